#include "experiments/compare/bed_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/fig25_collision_force/collision_force_laws.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"
#include "reports/gnuplot.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

constexpr const char* system_name = "6in5W";
const std::vector<std::string> formats{"svg", "png"};

Picture draw_classification(const std::vector<Candidate>& candidates, const fs::path& folder) {
  const std::string id = "simulated_classification";
  DataTable paper{id, {"superficial velocity [m/s]", "V_2 of Table 2 [m/s]"}, {}};
  for (const Table2Row& row : peng_2014().table2())
    paper.rows.push_back({row.superficial_velocity, row.classification_velocity});
  write_csv(paper, folder);
  draw_figure(
      id,
      "set key tmargin left Left reverse maxrows 4 font ',12'\nset xrange [0.05:0.13]\nset yrange [0:0.3<*]\nset "
      "xlabel 'superficial velocity U_L [m/s]'\nset ylabel 'classification velocity V_2 [m/s]'\nplot "
      "'simulated_classification.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, Table 2'" +
          simulated_points(id, candidates, "", "classification_velocity", "m/s", folder) + "\n",
      {560, 460}, folder, formats);
  return {id, "Classification velocity",
          "The 6 mm steel sphere through the bed of 5 mm glass: means of the drops with 95 % intervals, those of one "
          "velocity side by side, and the paper's values."};
}

Picture draw_collision_force(const std::vector<Candidate>& candidates, const fs::path& folder) {
  const std::string id = "collision_force";
  write_csv(collision_force_laws(id), folder);
  write_csv(van_der_wielen_of_table_2(id + "_van_der_wielen"), folder);
  draw_figure(id,
              "set key tmargin left Left reverse vertical maxrows 6 font ',12'\nset xrange [0.4:1]\nset yrange "
              "[0:*]\n" +
                  collision_force_plot(id) +
                  simulated_points(id, candidates, "voidage_centre_of_mass", "collision_force_ratio", "-", folder) +
                  "\n",
              {560, 520}, folder, formats);
  return {id, "Collision force on the steel sphere",
          "Mean magnitude of the contact force over the weight, with 95 % intervals, beside Eq. 40, van der Wielen's "
          "force with the velocities of Table 2, and Grbavčić's force between no transition (f = 0, the edge of each "
          "shade) and none left (f = 1, zero)."};
}

Picture draw_collision_frequency(const std::vector<Candidate>& candidates, const fs::path& folder) {
  const std::string id = "collision_frequency";
  DataTable theory{id, {"voidage [-]", "f* of Eq. 6 with g_0 of Eq. 7 [-]"}, {}};
  const collision::LunSavage1986 contact_value;
  for (double solids = 0.01; solids < contact_value.packed_solids; solids += 0.005) {
    const collision::CollisionState state{.solids = solids,
                                          .bed_diameter = 1.0,
                                          .foreign_diameter = 1.0,
                                          .kinetic_energy = 1.0,
                                          .contact_value = contact_value(solids)};
    theory.rows.push_back({1.0 - solids, collision::dimensionless_frequency(collision::Simonin1991{}(state), state)});
  }
  write_csv(theory, folder);
  draw_figure(
      id,
      "set key tmargin left Left reverse maxrows 4 font ',12'\nset xrange [0.4:1]\nset logscale y\nset yrange "
      "[*<0.3:1000<*]\nset xlabel 'voidage α_L [-]'\nset ylabel 'collision frequency f* [-]'\nplot "
      "'collision_frequency.csv' skip 1 using 1:2 with lines linestyle 1 title 'kinetic theory, Eq. 6 (paper)'" +
          simulated_points(id, candidates, "voidage_centre_of_mass", "dimensionless_collision_frequency", "-", folder) +
          "\n",
      {560, 460}, folder, formats);
  return {
      id, "Collision frequency of the steel sphere",
      "New contacts of the steel sphere with the bed per time, f* = f d_1/√(q_p²) with the bed's fluctuating energy, "
      "with 95 % intervals, beside the kinetic theory of like spheres that the paper compares with."};
}

}  // namespace

std::string simulated_points(const std::string& id, const std::vector<Candidate>& candidates, const std::string& x,
                             const std::string& y, const std::string& y_unit, const fs::path& folder) {
  std::string plot;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    DataTable table{fmt::format("{}_simulated_{}", id, i + 1),
                    {"superficial velocity [m/s]", x.empty() ? "place in the picture [m/s]" : x + " [-]",
                     "half width of its 95 % interval [-]", fmt::format("{} [{}]", y, y_unit),
                     fmt::format("half width of its 95 % interval [{}]", y_unit)},
                    {}};
    for (const MeasuredPoint& point : measured_points(candidates[i].measurements, y, system_name)) {
      if (candidates[i].runs == 0) continue;
      // Those of one velocity stand side by side.
      const double aside = 1.5e-3 * (static_cast<double>(i) - 0.5 * static_cast<double>(candidates.size() - 1));
      std::vector<double> row{point.superficial_velocity, point.superficial_velocity + aside, 0.0, point.value,
                              point.half_width};
      if (!x.empty()) {
        const auto found = candidates[i].measurements.find(measure_key(x, system_name, point.superficial_velocity));
        if (found == candidates[i].measurements.end()) continue;
        row[1] = found->second.value;
        row[2] = found->second.half_width;
      }
      table.rows.push_back(std::move(row));
    }
    if (table.rows.empty()) continue;
    write_csv(table, folder);
    const int style = line_style(i);
    plot += fmt::format(", {}{}'{}.csv' skip 1 using 2:4 with points linestyle {} title {}",
                        error_bars(table, {2, 4, 5}, "yerrorbars", style),
                        x.empty() ? "" : error_bars(table, {2, 4, 3}, "xerrorbars", style), table.name, style,
                        gnuplot_text(candidates[i].name));
  }
  return plot;
}

std::vector<Picture> draw_bed_pictures(const std::vector<Candidate>& candidates, const fs::path& folder) {
  if (std::ranges::all_of(candidates, [](const Candidate& candidate) { return candidate.runs == 0; })) return {};
  fs::create_directories(folder);
  return {draw_classification(candidates, folder), draw_collision_force(candidates, folder),
          draw_collision_frequency(candidates, folder)};
}

}  // namespace slfb::compare
