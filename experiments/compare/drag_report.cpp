#include "experiments/compare/drag_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "correlations/drag/drag_laws.hpp"
#include "experiments/compare/drag_figures.hpp"
#include "reports/html.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

using nlohmann::ordered_json;

std::string range_text(const Range& range) { return readable_range(range.lower, range.upper); }

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

/// The number printed for that superficial velocity; a dash without one.
std::string printed(const PrintedSeries& series, double superficial_velocity) {
  const auto found = std::ranges::find_if(series.points, [&](const PrintedPoint& point) {
    return std::abs(point.superficial_velocity - superficial_velocity) < 1e-9;
  });
  return found == series.points.end() ? "–" : readable_number(found->value);
}

Section bed_section(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                    const ComparisonBed& bed, const std::string& pictures) {
  std::vector<std::string> headings{
      escape_html(fmt::format("{}, {}, {}", bed.bed.words(), bed.foreign.words(), bed.liquid_name)), "Paper"};
  for (const auto& compared : laws) headings.push_back(escape_html(compared.name()));
  const auto answer = [](double value, bool in_range) {
    return readable_number(value) +
           (std::isnan(value) || in_range ? "" : "<span class=\"id\">outside its range</span>");
  };
  std::vector<std::vector<std::string>> rows{
      {"Minimum fluidisation velocity [m/s]",
       bed.minimum_fluidisation ? readable_number(*bed.minimum_fluidisation) : "–"}};
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double velocity = findings[i].minimum_fluidisation;
    rows.back().push_back(answer(velocity, bed_in_range(laws[i].law, bed, bed.packed_voidage, velocity)));
  }
  for (const double velocity : bed.tabulated_velocities) {
    std::vector<std::string> voidages{fmt::format("Voidage at {:.2f} m/s [-]", velocity),
                                      printed(bed.expansion, velocity)};
    std::vector<std::string> classification{
        prose_html(fmt::format("V_2 at {:.2f} m/s by force balance [m/s]", velocity)),
        printed(bed.classification, velocity)};
    for (const auto& compared : laws) {
      const HomogeneousBed found = homogeneous_bed(compared.law, bed, velocity);
      voidages.push_back(answer(found.voidage, found.bed_in_range));
      classification.push_back(answer(found.classification_velocity, found.in_range));
    }
    rows.push_back(std::move(voidages));
    rows.push_back(std::move(classification));
  }
  return {"bed", "The homogeneous bed",
          fmt::format("<p>What the law alone makes of the paper's bed, without a simulation: the velocity that carries "
                      "the packed bed, the voidage at which drag balances weight, and the fall of the {} sphere when "
                      "nothing but drag and the pressure gradient carry it. A dash: the law has no steady bed "
                      "there.</p>\n",
                      escape_html(bed.foreign.material)) +
              table_html(headings, rows) + pictures};
}

}  // namespace

std::vector<Section> drag_sections(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                                   const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                   const std::filesystem::path& folder) {
  std::vector<Picture> pictures = draw_drag_pictures(laws, candidates, bed, folder / "figures");
  const auto of_bed = pictures.end() - 2;
  const std::string surfaces = pictures_html({pictures.begin(), of_bed});
  const std::string bed_pictures = pictures_html({of_bed, pictures.end()});
  std::vector<std::vector<PropertyCheck>> properties;
  for (const DragFindings& finding : findings) properties.push_back(finding.properties);
  return {laws_section(laws),
          {"surfaces", "Beside the literature", surfaces},
          ratio_section(laws),
          property_section(names_of(laws), properties,
                           "Looked for on a grid in the range that the law states for itself. A law that lacks one of "
                           "them can still be useful; know which one it lacks."),
          bed_section(laws, findings, bed, bed_pictures)};
}

std::string evaluation_cost_html(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings) {
  std::vector<double> seconds;
  for (const DragFindings& finding : findings) seconds.push_back(finding.seconds_per_evaluation);
  return time_html("One evaluation in blocks of 256 spheres on one core, the fastest of twenty rounds:", names_of(laws),
                   seconds);
}

ordered_json drag_json(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                       const ComparisonBed& bed) {
  const auto number = [](double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); };
  ordered_json answer = ordered_json::array();
  for (std::size_t i = 0; i < laws.size(); ++i) {
    ordered_json law{{"name", laws[i].name()},
                     {"argument", laws[i].argument},
                     {"seconds_per_evaluation", findings[i].seconds_per_evaluation},
                     {"minimum_fluidisation_velocity", number(findings[i].minimum_fluidisation)}};
    for (const auto& check : findings[i].properties)
      law["properties"].push_back({{"property", check.property}, {"holds", check.holds}, {"found", check.found}});
    for (const double velocity : bed.tabulated_velocities) {
      const HomogeneousBed found = homogeneous_bed(laws[i].law, bed, velocity);
      law["bed"].push_back({{"superficial_velocity", velocity},
                            {"voidage", number(found.voidage)},
                            {"classification_velocity", number(found.classification_velocity)},
                            {"in_range", found.in_range}});
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
