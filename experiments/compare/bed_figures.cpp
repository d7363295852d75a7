#include "experiments/compare/bed_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/catalogue.hpp"
#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/support/folders.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> formats{"svg", "png"};

Picture draw_classification(const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                            const fs::path& folder) {
  const std::string id = "simulated_classification";
  DataTable printed{id, {"superficial velocity [m/s]", "V_2 as printed [m/s]"}, {}};
  for (const PrintedPoint& point : bed.classification.points)
    printed.rows.push_back({point.superficial_velocity, point.value});
  write_csv(printed, folder);
  PlotValues values;
  values.text("printed_title", bed.classification.title);
  add_simulated(id, candidates, bed, "", "classification_velocity", "m/s", values, folder);
  draw_plot(id, plot_file(id), values, {560, 460}, folder, "", formats);
  return {id, "Classification velocity",
          fmt::format("The {} sphere through the bed of {}: means of the drops with 95 % intervals, those of one "
                      "velocity side by side, and the paper's values.",
                      bed.foreign.words(), bed.bed.words())};
}

/// Force over weight that a law of the catalogue gives at that voidage [-] and settling velocity [m/s]; not a number
/// outside its voidages. Laws with a transition function are taken before the transition, f = 0.
double collision_force(const CatalogueEntry& law, const ComparisonBed& bed, double voidage, double settling_velocity) {
  if (!law.info.voidage.contains(voidage)) return std::nan("");
  LawArguments arguments;
  arguments.voidage = voidage;
  arguments.diameter = bed.bed.sphere.diameter;
  arguments.particle_density = bed.bed.sphere.density;
  arguments.foreign_diameter = bed.foreign.sphere.diameter;
  arguments.foreign_density = bed.foreign.sphere.density;
  arguments.liquid_density = bed.liquid.density;
  arguments.viscosity = bed.liquid.viscosity;
  arguments.settling_velocity = settling_velocity;
  arguments.transition = 0.0;
  return law.evaluate(arguments).at("force_over_weight").value;
}

/// All laws of the collision force: a curve over the voidage for those in which the settling velocity has no part, and
/// for the others points at the printed velocities, at the voidage of the homogeneous bed.
Picture draw_collision_force(const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                             const fs::path& folder) {
  const std::string id = "collision_force";
  constexpr int steps = 120;
  constexpr double loosest = 1.0;
  DataTable curves{id, {"voidage [-]"}, {}};
  for (int step = 0; step <= steps; ++step)
    curves.rows.push_back({bed.packed_voidage + (loosest - bed.packed_voidage) * step / steps});
  DataTable points{id + "_points", {"superficial velocity [m/s]", "voidage [-]", "printed V_2 [m/s]"}, {}};
  for (const PrintedPoint& point : bed.classification.points) {
    const auto found = fluidisation::bed_voidage(drag::Doroodchi2012{}, bed.bed.sphere, bed.liquid,
                                                 point.superficial_velocity, bed.packed_voidage);
    points.rows.push_back({point.superficial_velocity, found.voidage, point.value});
  }
  std::vector<std::string> curve_titles, point_titles;
  for (const CatalogueEntry& law : catalogue()) {
    if (law.info.kind != LawKind::collision_force) continue;
    const std::string name(law.info.name);
    const double middle = 0.5 * (bed.packed_voidage + loosest);
    const bool by_velocity = collision_force(law, bed, middle, 0.1) != collision_force(law, bed, middle, 0.2);
    DataTable& table = by_velocity ? points : curves;
    (by_velocity ? point_titles : curve_titles).push_back(name);
    table.columns.push_back(name + " [-]");
    for (auto& row : table.rows)
      row.push_back(by_velocity ? collision_force(law, bed, row[1], row[2]) : collision_force(law, bed, row[0], 0.0));
  }
  write_csv(curves, folder);
  write_csv(points, folder);
  PlotValues values;
  values.texts("curve_title", curve_titles);
  values.texts("point_title", point_titles);
  add_simulated(id, candidates, bed, "voidage_centre_of_mass", "collision_force_ratio", "-", values, folder);
  draw_plot(id, plot_file(id), values, {560, 520}, folder, "", formats);
  return {id, fmt::format("Collision force on the {} sphere", bed.foreign.material),
          "Mean magnitude of the contact force over the weight, with 95 % intervals, beside the laws of the "
          "literature, inside their ranges of the voidage. Laws that need the settling velocity: points, with the "
          "printed velocities. Grbavčić's force: before the transition (f = 0); it goes to zero at its end (f = 1)."};
}

Picture draw_collision_frequency(const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                 const fs::path& folder) {
  const std::string id = "collision_frequency";
  DataTable theory{id, {"voidage [-]", "f* of Simonin 1991 with g_0 of Lun and Savage 1986 [-]"}, {}};
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
  PlotValues values;
  add_simulated(id, candidates, bed, "voidage_centre_of_mass", "dimensionless_collision_frequency", "-", values,
                folder);
  draw_plot(id, plot_file(id), values, {560, 460}, folder, "", formats);
  return {id, fmt::format("Collision frequency of the {} sphere", bed.foreign.material),
          fmt::format("New contacts of the {} sphere with the bed per time, f* = f d_1/√(q_p²) with the bed's "
                      "fluctuating energy, with 95 % intervals, beside the kinetic theory of like spheres that the "
                      "paper compares with.",
                      bed.foreign.material)};
}

}  // namespace

fs::path plot_file(const std::string& name) {
  return source_folder() / "experiments" / "compare" / "plots" / (name + ".gp");
}

void add_simulated(const std::string& id, const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                   const std::string& x, const std::string& y, const std::string& y_unit, PlotValues& values,
                   const fs::path& folder) {
  std::vector<std::string> tables, titles;
  std::vector<double> styles;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].runs == 0) continue;
    DataTable table{fmt::format("{}_simulated_{}", id, i + 1),
                    {"superficial velocity [m/s]", x.empty() ? "abscissa in the picture [m/s]" : x + " [-]",
                     "half width of its 95 % interval [-]", fmt::format("{} [{}]", y, y_unit),
                     fmt::format("half width of its 95 % interval [{}]", y_unit)},
                    {}};
    for (const MeasuredPoint& point : measured_points(candidates[i].measurements, y, bed.system)) {
      const double aside = 1.5e-3 * (static_cast<double>(i) - 0.5 * static_cast<double>(candidates.size() - 1));
      std::vector<double> row{point.superficial_velocity, point.superficial_velocity + aside, 0.0, point.value,
                              point.half_width};
      if (!x.empty()) {
        const auto found = candidates[i].measurements.find(measure_key(x, bed.system, point.superficial_velocity));
        if (found == candidates[i].measurements.end()) continue;
        row[1] = found->second.value;
        row[2] = found->second.half_width;
      }
      table.rows.push_back(std::move(row));
    }
    if (table.rows.empty()) continue;
    write_csv(table, folder);
    tables.push_back(table.name);
    titles.push_back(candidates[i].name);
    styles.push_back(line_style(i));
  }
  values.files("simulated", tables);
  values.texts("simulated_title", titles);
  values.numbers("simulated_style", styles);
}

std::vector<Picture> draw_bed_pictures(const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                       const fs::path& folder) {
  if (std::ranges::all_of(candidates, [](const Candidate& candidate) { return candidate.runs == 0; })) return {};
  fs::create_directories(folder);
  return {draw_classification(candidates, bed, folder), draw_collision_force(candidates, bed, folder),
          draw_collision_frequency(candidates, bed, folder)};
}

}  // namespace slfb::compare
