#include "experiments/compare/contact_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "correlations/collision/restitution/barnocky_davis_1988.hpp"
#include "correlations/collision/restitution/legendre_2005.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> formats{"svg", "png"};

/// "'ID.csv' … title 'LAW'" for each law, the first in column `first` against `x`, the next `step` columns further
/// (`x_step`: likewise for x). The first lines are the widest, so that those that lie on them leave an edge to be seen.
std::string lines_of(const std::string& id, std::size_t x, std::size_t x_step, std::size_t first, std::size_t step,
                     const std::vector<ComparedContactLaw>& laws, bool titles) {
  std::string commands;
  for (std::size_t i = 0; i < laws.size(); ++i)
    commands += fmt::format("{}'{}.csv' skip 1 using {}:{} with lines linestyle {} linewidth {} {}", i == 0 ? "" : ", ",
                            id, x + i * x_step, first + i * step, line_style(i),
                            2.0 + 1.5 * static_cast<double>(laws.size() - 1 - i),
                            titles ? "title " + gnuplot_text(laws[i].name) : std::string("notitle"));
  return commands;
}

constexpr const char* key_above = "set key at screen 0.5,0.99 center top vertical maxrows 1 Left reverse font ',12'\n";

Picture draw_collision(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                       const fs::path& folder) {
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
  draw_figure(
      id,
      std::string(
          "set multiplot layout 1,2\nset tmargin 4\nset lmargin 11\nset ylabel 'normal force F_n [N]'\nset xlabel "
          "'time [ms]'\n") +
          key_above + "plot 0 with lines linestyle 20 notitle, " + lines_of(id, 1, 3, 3, 3, laws, true) +
          "\nunset key\nset xlabel 'overlap over effective radius, δ/R* [%]'\nplot 0 with lines linestyle 20 "
          "notitle, " +
          lines_of(id, 2, 3, 3, 3, laws, false) + "\nunset multiplot\n",
      {900, 380}, folder, formats);
  return {
      id, "One collision",
      "Two 5 mm glass spheres that meet at 0.1 m/s, with steps small enough to show the law itself. The area inside "
      "a loop on the right is the energy lost."};
}

Picture draw_speeds(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                    const fs::path& folder) {
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
  std::string at_step;
  for (std::size_t i = 0; i < laws.size(); ++i)
    at_step += fmt::format(  // side by side, for the bars of all are alike
        ", '{0}.csv' skip 1 using ($1*{5:.3f}):{1}:{2}:{3} with yerrorbars linestyle {4} pointsize 0.6 linewidth 1 "
        "notitle",
        id, 6 * i + 5, 6 * i + 6, 6 * i + 7, line_style(i),
        std::pow(1.1, static_cast<double>(i) - 0.5 * static_cast<double>(laws.size() - 1)));
  draw_figure(
      id,
      std::string(
          "set multiplot layout 1,3\nset tmargin 4\nset lmargin 10\nset logscale x\nset xrange [0.008:1.25]\nset "
          "format x '10^{%T}'\nset xtics 10\nset xlabel 'impact speed [m/s]'\nset ylabel 'restitution e "
          "[-]'\nset yrange [*:*]\n") +
          key_above + "plot " + lines_of(id, 1, 0, 2, 6, laws, true) + at_step +
          "\nunset key\nset yrange [0:*]\nset ylabel 'contact time [ms]'\nplot " +
          lines_of(id, 1, 0, 3, 6, laws, false) +
          "\nset logscale y\nset yrange [*:*]\nset format y '10^{%T}'\nset ylabel 'peak force [N]'\nplot " +
          lines_of(id, 1, 0, 4, 6, laws, false) + "\nunset multiplot\n",
      {960, 360}, folder, formats);
  return {
      id, "Restitution, contact time and peak force over the impact speed",
      "Two 5 mm glass spheres, head on. Lines: the law itself, with small steps. Symbols on the left: with the step "
      "of the scene, mean over where in a step the spheres meet; the bars are the lowest and the highest."};
}

Picture draw_oblique(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                     const fs::path& folder) {
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
    const Impact impact = oblique_impact(impact_angles()[k]);
    const double tangent = impact.tangential_speed / impact.speed;
    // Up to the angle where the slip would turn round it cannot slide all along.
    const bool slides = tangent > 3.5 * carried;
    std::vector<double> row{impact_angles()[k], slides ? 1.0 - carried / tangent : nothing,
                            slides ? 2.5 * carried : nothing};
    for (const ContactFindings& finding : findings) {
      const Rebound& rebound = finding.oblique[k];
      row.push_back(rebound.tangential_speed / impact.tangential_speed);
      row.push_back(0.5 * impact.first.diameter * rebound.spin / impact.speed);
    }
    table.rows.push_back(std::move(row));
  }
  write_csv(table, folder);
  const auto exact = [&](int column) {
    return fmt::format("'{}.csv' skip 1 using 1:{} with lines linecolor rgb '#c3c8ce' linewidth 12 notitle, ", id,
                       column);
  };
  draw_figure(id,
              std::string("set multiplot layout 1,2\nset tmargin 4\nset xrange [0:90]\nset xtics 15\nset xlabel 'angle "
                          "to the normal [°]'\nset ylabel \"tangential restitution v_t'/v_t [-]\"\n") +
                  key_above + "plot " + exact(2) + lines_of(id, 1, 0, 4, 2, laws, true) +
                  "\nunset key\nset ylabel \"spin rω'/v_n [-]\"\nplot " + exact(3) +
                  lines_of(id, 1, 0, 5, 2, laws, false) + "\nunset multiplot\n",
              {900, 380}, folder, formats);
  return {
      id, "Oblique impact",
      fmt::format("A 5 mm glass sphere without spin meets a wall, 0.1 m/s along the normal, friction {}. Grey: what a "
                  "rigid sphere of restitution {} does where it slides from start to end; below that angle the "
                  "tangential spring decides.",
                  contact.sliding_friction, contact.restitution)};
}

Picture draw_wet(const std::vector<ComparedContactLaw>& laws, const std::vector<ContactFindings>& findings,
                 const fs::path& folder) {
  const std::string id = "wet_restitution";
  const Sphere glass = paper::glass(0.005);
  const LiquidProperties water = paper::water();
  const auto [outer, inner] = lubrication_gaps();
  DataTable table{
      id, {"impact speed [m/s]", "Stokes number [-]", "Legendre 2005 [-]", "Barnocky & Davis 1988 [-]"}, {}};
  for (const auto& law : laws) table.columns.push_back(law.name + ": restitution over the dry one [-]");
  for (std::size_t k = 0; k < wet_speeds().size(); ++k) {
    const double speed = wet_speeds()[k];
    const collision::WetImpact impact{glass, water, speed, inner};
    std::vector<double> row{speed, glass.density * speed * glass.diameter / (9.0 * water.viscosity),
                            collision::Legendre2005{}(impact), collision::BarnockyDavis1988{}(impact)};
    for (const ContactFindings& finding : findings) row.push_back(finding.wet[k]);
    table.rows.push_back(std::move(row));
  }
  write_csv(table, folder);
  DataTable measured{id + "_measured", {"Stokes number [-]", "restitution [-]"}, {}};
  for (const WetBounce& bounce : gondret_2002()) measured.rows.push_back({bounce.stokes, bounce.restitution});
  write_csv(measured, folder);
  const StokesLimits limits = joseph_2001();
  draw_figure(
      id,
      fmt::format(
          "set key tmargin left Left reverse maxrows 4 font ',12'\nset logscale x\nset xrange [3:1500]\nset yrange "
          "[0:1.05]\nset xlabel 'Stokes number ρ_P U d/9μ [-]'\nset ylabel 'restitution over the dry one "
          "[-]'\nset object 1 rectangle from 3,0 to {0},1.05 fillcolor rgb '#f0f1f3' fillstyle solid noborder "
          "behind\nset object 2 rectangle from {1},0 to 1500,1.05 fillcolor rgb '#f0f1f3' fillstyle solid "
          "noborder behind\nset label 1 'no rebound' at {2},0.5 center rotate by 90 font ',11' textcolor rgb "
          "'#5b6470'\nset label 2 'dry value' at {3},0.5 center rotate by 90 font ',11' textcolor rgb "
          "'#5b6470'\nplot '{4}.csv' skip 1 using 2:3 with lines linestyle 11 title 'Legendre 2005', '' skip 1 "
          "using 2:4 with lines linestyle 12 title 'Barnocky, Davis 1988', '{4}_measured.csv' skip 1 using "
          "1:2 with points linestyle 1 dashtype 1 title 'Gondret 2002, measured', {5}\n",
          limits.no_rebound_below, limits.dry_above, std::sqrt(3.0 * limits.no_rebound_below),
          std::sqrt(1500.0 * limits.dry_above), id, lines_of(id, 2, 0, 5, 1, laws, true)),
      {600, 480}, folder, formats);
  return {id, "Bounce in the liquid",
          fmt::format(
              "5 mm glass that hits a wall in water under the suite's lubrication force (from a gap of {:g} mm, no "
              "further than a roughness of {:g} μm; coupling.lubrication_range), over the same bounce without it. A "
              "scene without lubrication, as the paper's, has 1 at every Stokes number. Grey, Joseph et al. (2001): no "
              "rebound on the left, the dry restitution on the right. Circles: restitutions of Gondret et al. (2002) "
              "for other spheres and liquids, dry value unknown.",
              1e3 * outer, 1e6 * inner)};
}

}  // namespace

std::vector<Picture> draw_contact_pictures(const std::vector<ComparedContactLaw>& laws,
                                           const std::vector<ContactFindings>& findings, const fs::path& folder) {
  fs::create_directories(folder);
  return {draw_collision(laws, findings, folder), draw_speeds(laws, findings, folder),
          draw_oblique(laws, findings, folder), draw_wet(laws, findings, folder)};
}

}  // namespace slfb::compare
