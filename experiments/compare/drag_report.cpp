#include "experiments/compare/drag_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "correlations/drag/drag_laws.hpp"
#include "experiments/compare/drag_figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "reports/html.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

using nlohmann::ordered_json;

/// Velocities at which the homogeneous bed is tabulated: the slow end, the middle and the fast end of what is compared
/// [m/s].
constexpr std::array shown_velocities{0.06, 0.08, 0.10};

std::string range_text(const Range& range) {
  if (std::isinf(range.upper)) return range.lower == 0.0 ? "any" : "≥ " + readable_number(range.lower);
  return readable_number(range.lower) + " … " + readable_number(range.upper);
}

std::vector<std::string> names_of(const std::vector<ComparedDragLaw>& laws) {
  std::vector<std::string> names;
  for (const auto& compared : laws) names.push_back(compared.name());
  return names;
}

Section laws_section(const std::vector<ComparedDragLaw>& laws) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [argument, law] : laws)
    rows.push_back({fmt::format("<code>{}</code><span class=\"id\">{}</span>", escape_html(std::string(law.info.name)),
                                escape_html(std::string(law.info.title))),
                    "<code>" + escape_html(std::string(law.info.equation)) + "</code>", range_text(law.info.reynolds),
                    range_text(law.info.voidage),
                    is_user_law(argument) ? "<code>" + escape_html(argument) + "</code>" : "suite"});
  return {"laws", "The laws", table_html({"Law", "Formula", "Re", "Voidage", "From"}, rows)};
}

Section ratio_section(const std::vector<ComparedDragLaw>& laws) {
  std::vector<std::string> headings{"Law of the literature"};
  for (const auto& compared : laws) headings.push_back(escape_html(compared.name()));
  std::vector<std::vector<std::string>> rows;
  for_each_law<drag::DragLaws>([&](const auto& other) {
    std::vector<std::string> row{"<code>" + std::string(other.info.name) + "</code>"};
    for (const auto& compared : laws) {
      const DragRatio ratio = drag_ratio(compared.law, drag::kernels_of<std::decay_t<decltype(other)>>());
      row.push_back(ratio.points == 0 ? "–"
                                      : fmt::format("<div><span class=\"number\">{:.3f}</span><span class=\"id "
                                                    "number\">{:.3f} … {:.3f}</span></div>",
                                                    ratio.median, ratio.smallest, ratio.largest));
    }
    rows.push_back(std::move(row));
  });
  return {"ratios", "Ratio to the literature",
          "<p>Median, smallest and largest ratio of the law over each law of the literature where the ranges of both "
          "meet, over voidage and log Re in even steps.</p>\n" +
              table_html(headings, rows)};
}

Section bed_section(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                    const std::string& pictures) {
  std::vector<std::string> headings{"5 mm glass, 6 mm steel, water", "Paper"};
  for (const auto& compared : laws) headings.push_back(escape_html(compared.name()));
  const auto with_paper = [](const char* id) {
    const auto& values = peng_2014().values();
    const auto found = values.find(id);
    return found == values.end() ? std::string("–") : readable_number(found->second.value);
  };
  const auto answer = [](double value, bool in_range) {
    return readable_number(value) +
           (std::isnan(value) || in_range ? "" : "<span class=\"id\">outside its range</span>");
  };
  std::vector<std::vector<std::string>> rows{{"Minimum fluidisation velocity [m/s]", with_paper("umf_crossing")}};
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double velocity = findings[i].minimum_fluidisation;
    rows.back().push_back(answer(velocity, bed_in_range(laws[i].law, paper::packed_voidage(), velocity)));
  }
  for (const double velocity : shown_velocities) {
    std::vector<std::string> voidages{fmt::format("Voidage at {:.2f} m/s [-]", velocity),
                                      with_paper(fmt::format("figure13/voidage/{:.2f}", velocity).c_str())};
    std::vector<std::string> falls{prose_html(fmt::format("V_2 at {:.2f} m/s by force balance [m/s]", velocity)),
                                   with_paper(fmt::format("table2/classification_velocity/{:.2f}", velocity).c_str())};
    for (const auto& compared : laws) {
      const HomogeneousBed bed = homogeneous_bed(compared.law, velocity);
      voidages.push_back(answer(bed.voidage, bed.bed_in_range));
      falls.push_back(answer(bed.classification_velocity, bed.in_range));
    }
    rows.push_back(std::move(voidages));
    rows.push_back(std::move(falls));
  }
  return {"bed", "The homogeneous bed",
          "<p>What the law alone makes of the paper's bed, without a simulation: the velocity that carries the packed "
          "bed, the voidage at which drag balances weight, and the fall of the steel sphere when nothing but drag and "
          "the pressure gradient carry it. A dash: the law has no steady bed there.</p>\n" +
              table_html(headings, rows) + pictures};
}

}  // namespace

std::vector<DragFindings> find_out(const std::vector<ComparedDragLaw>& laws) {
  std::vector<DragFindings> findings;
  for (const auto& compared : laws)
    findings.push_back({check_properties(compared.law), bed_velocity(compared.law, paper::packed_voidage()),
                        seconds_per_evaluation(compared.law)});
  return findings;
}

std::vector<Section> drag_sections(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                                   const std::vector<Candidate>& candidates, const std::filesystem::path& folder) {
  std::vector<Picture> pictures = draw_drag_pictures(laws, candidates, folder / "figures");
  const auto of_bed = pictures.end() - 2;
  const std::string surfaces = pictures_html({pictures.begin(), of_bed}), bed = pictures_html({of_bed, pictures.end()});
  std::vector<std::vector<PropertyCheck>> properties;
  for (const DragFindings& finding : findings) properties.push_back(finding.properties);
  return {laws_section(laws),
          {"surfaces", "Beside the literature", surfaces},
          ratio_section(laws),
          property_section(names_of(laws), properties,
                           "Looked for on a grid in the range that the law states for itself. A law that lacks one is "
                           "not useless, but it is used with open eyes."),
          bed_section(laws, findings, bed)};
}

std::string evaluation_cost_html(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings) {
  std::vector<double> seconds;
  for (const DragFindings& finding : findings) seconds.push_back(finding.seconds_per_evaluation);
  return time_html("One evaluation in blocks of 256 spheres on one core, the fastest of twenty rounds:", names_of(laws),
                   seconds);
}

ordered_json drag_json(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings) {
  const auto number = [](double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); };
  ordered_json answer = ordered_json::array();
  for (std::size_t i = 0; i < laws.size(); ++i) {
    ordered_json law{{"name", laws[i].name()},
                     {"argument", laws[i].argument},
                     {"seconds_per_evaluation", findings[i].seconds_per_evaluation},
                     {"minimum_fluidisation_velocity", number(findings[i].minimum_fluidisation)}};
    for (const auto& check : findings[i].properties)
      law["properties"].push_back({{"property", check.property}, {"holds", check.holds}, {"found", check.found}});
    for (const double velocity : shown_velocities) {
      const HomogeneousBed bed = homogeneous_bed(laws[i].law, velocity);
      law["bed"].push_back({{"superficial_velocity", velocity},
                            {"voidage", number(bed.voidage)},
                            {"classification_velocity", number(bed.classification_velocity)},
                            {"in_range", bed.in_range}});
    }
    for_each_law<drag::DragLaws>([&](const auto& other) {
      const DragRatio ratio = drag_ratio(laws[i].law, drag::kernels_of<std::decay_t<decltype(other)>>());
      law["ratio_to"][std::string(other.info.name)] = {
          {"smallest", number(ratio.smallest)}, {"median", number(ratio.median)}, {"largest", number(ratio.largest)}};
    });
    answer.push_back(std::move(law));
  }
  return answer;
}

}  // namespace slfb::compare
