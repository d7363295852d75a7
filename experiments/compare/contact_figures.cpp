#include "experiments/compare/contact_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "correlations/collision/restitution/barnocky_davis_1988.hpp"
#include "correlations/collision/restitution/legendre_2005.hpp"
#include "experiments/compare/bed_figures.hpp"
#include "experiments/reference/wet_bounces.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> formats{"svg", "png"};

/// The values of all plots but what one of them needs besides.
PlotValues names_of(const std::vector<ComparedContactLaw>& laws) {
  std::vector<std::string> names;
  for (const auto& law : laws) names.push_back(law.name);
  PlotValues values;
  values.texts("law", names);
  return values;
}

Picture draw_collision(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                       const ComparisonBed& bed, const fs::path& folder) {
  const std::string id = "one_collision";
  DataTable table{id, {}, {}};
  std::size_t longest = 0;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    for (const char* column : {"time [ms]", "overlap over effective radius [%]", "normal force [N]"})
      table.columns.push_back(fmt::format("{}: {}", laws[i].name, column));
    longest = std::max(longest, findings[i].usual.time.size());
  }
  constexpr std::size_t thinned = 8;  // a tenth of a pixel between the rows that are left
  for (std::size_t k = thinned / 2; k < longest; k += thinned) {
    std::vector<double> row;
    for (const ContactFindings& finding : findings) {
      const Rebound& rebound = finding.usual;
      const bool there = k < rebound.time.size();
      row.insert(row.end(), {there ? 1e3 * rebound.time[k] : nothing, there ? 100.0 * rebound.depth[k] : nothing,
                             there ? rebound.force[k] : nothing});
    }
    table.rows.push_back(std::move(row));
  }
  write_csv(table, folder);
  draw_plot(id, plot_file(id), names_of(laws), {900, 380}, folder, "", formats);
  return {id, "One collision",
          fmt::format(
              "Two {} spheres that meet at 0.1 m/s, with steps small enough to show the law itself. The area inside "
              "a loop on the right is the energy lost.",
              bed.bed.words())};
}

Picture draw_speeds(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                    const ComparisonBed& bed, const fs::path& folder) {
  const std::string id = "impact_speed";
  DataTable table{id, {"impact speed [m/s]"}, {}};
  for (const auto& law : laws)
    for (const char* column : {"restitution [-]", "contact time [ms]", "peak force [N]",
                               "restitution at the step of the scene [-]", "lowest [-]", "highest [-]"})
      table.columns.push_back(fmt::format("{}: {}", law.name, column));
  for (std::size_t k = 0; k < impact_speeds().size(); ++k) {
    std::vector<double> row{impact_speeds()[k]};
    for (const ContactFindings& finding : findings) {
      const Rebound& rebound = finding.head_on[k];
      const RestitutionAtStep& at_step = finding.at_step[k];
      row.insert(row.end(), {rebound.restitution, 1e3 * rebound.duration, rebound.peak_force, at_step.mean,
                             at_step.lowest, at_step.highest});
    }
    table.rows.push_back(std::move(row));
  }
  write_csv(table, folder);
  draw_plot(id, plot_file(id), names_of(laws), {960, 360}, folder, "", formats);
  return {id, "Restitution, contact time and peak force over the impact speed",
          fmt::format(
              "Two {} spheres, head on. Lines: the law itself, with small steps. Symbols on the left: with the step "
              "of the scene, mean over where in a step the spheres meet; the bars are the lowest and the highest.",
              bed.bed.words())};
}

Picture draw_oblique(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                     const ComparisonBed& bed, const fs::path& folder) {
  const std::string id = "oblique_impact";
  DataTable table{id,
                  {"angle to the normal [degrees]", "rigid sphere that slides: tangential restitution [-]",
                   "rigid sphere that slides: spin [-]"},
                  {}};
  for (const auto& law : laws)
    for (const char* column : {"tangential restitution [-]", "spin [-]"})
      table.columns.push_back(fmt::format("{}: {}", law.name, column));
  const Contact& contact = laws[0].contact;
  const double carried = contact.sliding_friction * (1.0 + contact.restitution);
  for (std::size_t k = 0; k < impact_angles().size(); ++k) {
    const Impact impact = oblique_impact(bed, impact_angles()[k]);
    const double tangent = impact.tangential_speed / impact.speed;
    // Up to the angle where the slip would turn round it cannot slide all along.
    const bool slides = tangent > 3.5 * carried;
    std::vector<double> row{impact_angles()[k], slides ? 1.0 - carried / tangent : nothing,
                            slides ? 2.5 * carried : nothing};
    for (const ContactFindings& finding : findings) {
      const Rebound& rebound = finding.oblique[k];
      row.push_back(rebound.tangential_speed / impact.tangential_speed);
      row.push_back(0.5 * impact.first.diameter * rebound.angular_speed / impact.speed);
    }
    table.rows.push_back(std::move(row));
  }
  write_csv(table, folder);
  draw_plot(id, plot_file(id), names_of(laws), {900, 380}, folder, "", formats);
  return {id, "Oblique impact",
          fmt::format("A {} sphere without spin meets a wall, 0.1 m/s along the normal, friction {}. Grey: what a "
                      "rigid sphere of restitution {} does where it slides from start to end; below that angle the "
                      "tangential spring decides.",
                      bed.bed.words(), contact.sliding_friction, contact.restitution)};
}

Picture draw_wet(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                 const ComparisonBed& bed, const fs::path& folder) {
  const std::string id = "wet_restitution";
  const Sphere& sphere = bed.bed.sphere;
  const LiquidProperties& liquid = bed.liquid;
  const auto [outer, inner] = lubrication_gaps(bed);
  DataTable table{
      id, {"impact speed [m/s]", "Stokes number [-]", "Legendre 2005 [-]", "Barnocky & Davis 1988 [-]"}, {}};
  for (const auto& law : laws) table.columns.push_back(law.name + ": restitution over the dry one [-]");
  for (std::size_t k = 0; k < wet_speeds().size(); ++k) {
    const double speed = wet_speeds()[k];
    const collision::WetImpact impact{sphere, liquid, speed, inner};
    std::vector<double> row{speed, sphere.density * speed * sphere.diameter / (9.0 * liquid.viscosity),
                            collision::Legendre2005{}(impact), collision::BarnockyDavis1988{}(impact)};
    for (const ContactFindings& finding : findings) row.push_back(finding.wet[k]);
    table.rows.push_back(std::move(row));
  }
  write_csv(table, folder);
  DataTable measured{id + "_measured", {"Stokes number [-]", "restitution [-]"}, {}};
  for (const WetBounce& bounce : gondret_2002()) measured.rows.push_back({bounce.stokes, bounce.restitution});
  write_csv(measured, folder);
  const StokesLimits limits = joseph_2001();
  PlotValues values = names_of(laws);
  values.number("no_rebound_below", limits.no_rebound_below);
  values.number("dry_above", limits.dry_above);
  draw_plot(id, plot_file(id), values, {600, 480}, folder, "", formats);
  return {id, "Bounce in the liquid",
          fmt::format(
              "{} that hits a wall in {} under the suite's lubrication force (from a gap of {:g} mm, no "
              "further than a roughness of {:g} μm; coupling.lubrication_range), over the same bounce without it. A "
              "scene without lubrication, as the paper's, has 1 at every Stokes number. Grey, Joseph et al. (2001): no "
              "rebound on the left, the dry restitution on the right. Circles: restitutions of Gondret et al. (2002) "
              "for other spheres and liquids, dry value unknown.",
              bed.bed.words(), bed.liquid_name, 1e3 * outer, 1e6 * inner)};
}

}  // namespace

std::vector<Picture> draw_contact_pictures(const std::vector<ComparedContactLaw>& laws,
                                           const std::vector<ContactFindings>& findings, const ComparisonBed& bed,
                                           const fs::path& folder) {
  fs::create_directories(folder);
  return {draw_collision(laws, findings, bed, folder), draw_speeds(laws, findings, bed, folder),
          draw_oblique(laws, findings, bed, folder), draw_wet(laws, findings, bed, folder)};
}

}  // namespace slfb::compare
