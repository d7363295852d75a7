#include "experiments/compare/contact_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/compare/bed_figures.hpp"
#include "experiments/compare/contact_figures.hpp"
#include "reports/html.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

using nlohmann::ordered_json;

std::vector<std::string> names_of(const std::vector<ComparedContactLaw>& laws) {
  std::vector<std::string> names;
  for (const auto& law : laws) names.push_back(law.name);
  return names;
}

Section laws_section(const std::vector<ComparedContactLaw>& laws) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& compared : laws) {
    const dem::ContactLawInfo& info = compared.law.info;
    rows.push_back({fmt::format("<code>{}</code><span class=\"id\">{}</span>", escape_html(compared.name),
                                escape_html(std::string(info.title))),
                    "<code>" + escape_html(std::string(info.equation)) + "</code>",
                    "<code>" + escape_html(fmt::format("{}", fmt::join(compared.overrides, ", "))) + "</code>",
                    std::isinf(info.overlap.upper) ? "any" : fmt::format("at most {:g} R*", info.overlap.upper),
                    is_user_law(compared.argument) ? "<code>" + escape_html(compared.argument) + "</code>" : "suite"});
  }
  return {"laws", "The laws", table_html({"Law", "Normal force", "In the scene", "Overlap", "From"}, rows)};
}

Section collision_section(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                          const ComparisonBed& bed, const std::vector<Picture>& pictures) {
  std::vector<std::string> headings{escape_html(fmt::format("Two {} spheres at 0.1 m/s", bed.bed.words()))};
  for (const auto& law : laws) headings.push_back(escape_html(law.name));
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& what, auto value) {
    std::vector<std::string> row{prose_html(what)};
    for (std::size_t i = 0; i < laws.size(); ++i) row.push_back(value(laws[i], findings[i]));
    rows.push_back(std::move(row));
  };
  using Law = ComparedContactLaw;
  using Found = ContactFindings;
  add("Restitution [-]", [](const Law&, const Found& found) { return readable_number(found.usual.restitution); });
  add("… with the step of the scene, lowest to highest [-]", [](const Law&, const Found& found) {
    return readable_number(found.usual_at_step.lowest) + " … " + readable_number(found.usual_at_step.highest);
  });
  add("Contact time [s]", [](const Law&, const Found& found) { return readable_number(found.usual.duration); });
  add("Peak force [N]", [](const Law&, const Found& found) { return readable_number(found.usual.peak_force); });
  add("Largest overlap over effective radius [%]",
      [](const Law&, const Found& found) { return readable_number(100.0 * found.usual.overlap); });
  add("Step of the scene [s]", [](const Law& law, const Found&) { return readable_number(law.contact.time_step); });
  add("Steps per contact [-]", [](const Law& law, const Found& found) {
    return fmt::format("{:.1f}", found.usual.duration / law.contact.time_step);
  });
  add("Largest stable step of the pair, 2/ω [s]",
      [](const Law&, const Found& found) { return readable_number(found.stability_limit); });
  return {"collisions", "Two bodies",
          "<p>Each law in the particle engine, alone and without gravity, so that nothing but the law and its steps "
          "shows. Rolling resistance is left out.</p>\n" +
              table_html(headings, rows) + pictures_html(pictures)};
}

}  // namespace

std::vector<Section> contact_sections(const std::vector<ComparedContactLaw>& laws,
                                      const std::vector<ContactFindings>& findings,
                                      const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                      const std::filesystem::path& folder) {
  const auto pictures = draw_contact_pictures(laws, findings, bed, folder / "figures");
  const auto of_bed = draw_bed_pictures(candidates, bed, folder / "figures");
  std::vector<std::vector<PropertyCheck>> properties;
  for (const ContactFindings& found : findings) properties.push_back(found.properties);
  std::vector<Section> sections{
      laws_section(laws), collision_section(laws, findings, bed, pictures),
      property_section(
          names_of(laws), properties,
          fmt::format("Looked for in collisions of {0} on {0}, {1} on {0} and {0} on a wall, from 0.01 to 1 "
                      "m/s, at angles up to 85 degrees. A law that lacks one of them can still be useful; know "
                      "which one it lacks.",
                      bed.bed.material, bed.foreign.material))};
  if (!of_bed.empty())
    sections.push_back(
        {"bed", "In the bed",
         "<p>What the runs measured, beside the paper and the correlations.</p>\n" + pictures_html(of_bed)});
  return sections;
}

std::string contact_cost_html(const std::vector<ComparedContactLaw>& laws,
                              const std::vector<ContactFindings>& findings) {
  std::vector<double> seconds;
  for (const ContactFindings& found : findings) seconds.push_back(found.seconds_per_contact);
  return time_html(
      "One contact with its friction and rolling resistance, in batches of 96 on one core, the fastest of "
      "fifty rounds:",
      names_of(laws), seconds);
}

ordered_json contact_json(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings) {
  ordered_json answer = ordered_json::array();
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const ContactFindings& found = findings[i];
    ordered_json law{{"name", laws[i].name},
                     {"overrides", laws[i].overrides},
                     {"seconds_per_contact", found.seconds_per_contact},
                     {"restitution", found.usual.restitution},
                     {"restitution_at_step", {found.usual_at_step.lowest, found.usual_at_step.highest}},
                     {"contact_time", found.usual.duration},
                     {"peak_force", found.usual.peak_force},
                     {"largest_overlap", found.usual.overlap},
                     {"steps_per_contact", found.usual.duration / laws[i].contact.time_step},
                     {"stability_limit", found.stability_limit}};
    for (const auto& check : found.properties)
      law["properties"].push_back({{"property", check.property}, {"holds", check.holds}, {"found", check.found}});
    answer.push_back(std::move(law));
  }
  return answer;
}

}  // namespace slfb::compare
