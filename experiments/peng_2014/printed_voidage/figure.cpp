#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::printed_voidage {
namespace {

const FigureFolder folder{"peng_2014/printed_voidage"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.variant.empty() && std::any_of(bed_systems.begin(), bed_systems.end(),
                                               [&](const BedSystem& system) { return system.name == spec.system; });
  });
}

/// Of the homogeneous bed by Eq. 36 [-]; NaN where there is none.
double equation_36(const BedSystem& system, double superficial_velocity) {
  const auto liquid = system.name.ends_with('N') ? paper::sodium_iodide() : paper::water();
  const auto bed = fluidisation::bed_voidage(drag::Doroodchi2012{}, paper::glass(system.bed_diameter), liquid,
                                             superficial_velocity, paper::packed_voidage());
  return bed.regime == fluidisation::BedRegime::expanded ? bed.voidage : std::nan("");
}

double equation_40(double voidage) { return collision::Peng2014{}(paper::steel_in_glass(0.0, voidage), 0.0); }

/// Deviations of points from Eq. 40.
class Deviations {
 public:
  void add(double voidage, double force) {
    const double deviation = force / equation_40(voidage) - 1.0;
    squares_ += deviation * deviation;
    ++points_;
    within_10_ += std::fabs(deviation) <= 0.1 ? 1 : 0;
    within_20_ += std::fabs(deviation) <= 0.2 ? 1 : 0;
  }
  [[nodiscard]] int points() const { return points_; }
  [[nodiscard]] std::string text() const {
    return fmt::format("{:.0f} % r.m.s., {} of {} points within 10 %, {} within 20 %",
                       100.0 * std::sqrt(squares_ / points_), within_10_, points_, within_20_);
  }

 private:
  double squares_ = 0.0;
  int points_ = 0, within_10_ = 0, within_20_ = 0;
};

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"printed-voidage", {}, "", run_notes(context, keys)};

  DataTable curve{"printed_voidage_equations", {"voidage [-]", "Eq. 40 [-]"}, {}};
  for (int step = 42; step <= 92; ++step) curve.rows.push_back({0.01 * step, equation_40(0.01 * step)});
  DataTable homogeneous{"printed_voidage_equation_36", {"superficial velocity [m/s]", "voidage [-]"}, {}};
  const BedSystem& main = *std::ranges::find(bed_systems, "6in5W", &BedSystem::name);  // Fig. 13 and Table 2
  for (int step = 44; step <= 240; ++step) homogeneous.rows.push_back({1e-3 * step, equation_36(main, 1e-3 * step)});
  DataTable printed{"printed_voidage_paper", {"superficial velocity [m/s]", "voidage [-]"}, {}};
  double largest = 0.0;
  for (const auto& point : peng_2014().figure13()) {
    printed.rows.push_back({point.superficial_velocity, point.voidage});
    largest = std::max(largest, std::fabs(point.voidage - equation_36(main, point.superficial_velocity)));
  }
  for (const auto* table : {&curve, &homogeneous, &printed}) output.data.push_back(write_csv(*table, context.out));

  Deviations own, by_equation_36;
  std::vector<Series> simulated;
  std::vector<std::string> main_bed;  // its table
  for (const BedSystem& system : bed_systems) {
    DataTable table{fmt::format("printed_voidage_{}", system.name),
                    {"superficial velocity [m/s]", "voidage of the bed [-]", "half width of its 95 % interval [-]",
                     "|F_c|/mg [-]", "half width of its 95 % interval [-]", "voidage by Eq. 36 [-]"},
                    {}};
    for (auto row : against_bed(context, "collision_force_ratio", "", system.name, "", BedAbscissa::voidage).rows) {
      const double homogeneous_voidage = equation_36(system, row[0]);
      if (!std::isfinite(homogeneous_voidage)) continue;  // a packed bed: nothing falls through it
      row.push_back(homogeneous_voidage);
      own.add(row[1], row[3]);
      by_equation_36.add(homogeneous_voidage, row[3]);
      table.rows.push_back(std::move(row));
    }
    if (system.name == main.name && !table.rows.empty()) main_bed.push_back(table.name);
    simulated.push_back({std::move(table), std::string(system.title), system.line_style});
  }
  output.caption = folder.caption(
      {{"largest", fmt::format("{:.3f}", largest)},
       {"deviations",
        own.points() == 0
            ? ""
            : fmt::format("From Eq. 40 the force deviates, at the bed's own voidage, by {}; at that of Eq. 36 by {}.",
                          own.text(), by_equation_36.text())}});

  PlotValues values;
  add_series("simulated", simulated, values, context, output);
  values.files("main_bed", main_bed);
  values.number("main_bed_style", main.line_style);
  draw_plot_of_runs("printed-voidage", folder.plot(), values, {1180, 420}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"printed-voidage", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::printed_voidage
