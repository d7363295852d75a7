#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <utility>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/inconsistencies.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/support/folders.hpp"

namespace slfb::table1_conditions {
namespace {

const std::vector<std::pair<std::string, std::string>> headings{
    {"", "condition"}, {"", "unit"}, {"paper,", "Table 1"}, {"here,", "6in5W"}, {"other numbers of", "the paper give"}};

const FigureFolder folder{"peng_2014/table1_conditions"};

/// One row: what Table 1 prints, what our working scene has, and the row of inconsistencies.cpp that doubts it.
struct Condition {
  const char *printed, *title;
  std::function<double(const Scene&)> ours;
  const char* inconsistency = "";
};

double bed_mass(const Scene& scene) {
  const Species& glass = scene.species.front();
  return static_cast<double>(glass.count) * Sphere{glass.diameter, glass.density}.volume() * glass.density;
}

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> list{
      {"water_density", "density of water", [](const Scene& s) { return s.liquid.density; }},
      {"water_viscosity", "viscosity of water", [](const Scene& s) { return s.liquid.viscosity; }},
      {"sodium_iodide_density", "density of the NaI solution",
       [](const Scene&) { return paper::sodium_iodide().density; }},
      {"sodium_iodide_viscosity", "viscosity of the NaI solution",
       [](const Scene&) { return paper::sodium_iodide().viscosity; }},
      {"foreign_particle_density", "density of the steel sphere", [](const Scene& s) { return s.species[1].density; }},
      {"fluidised_particle_density", "density of the glass", [](const Scene& s) { return s.species[0].density; },
       "particle_density"},
      {"fluidised_mass_table", "mass of the glass", bed_mass, "particle_mass"},
      {"normal_stiffness", "normal spring stiffness", [](const Scene& s) { return s.contact.stiffness; }},
      {"restitution_coefficient", "restitution", [](const Scene& s) { return s.contact.restitution; }, "restitution"},
      {"sliding_friction", "sliding friction", [](const Scene& s) { return s.contact.sliding_friction; }},
      {"rolling_friction", "rolling friction", [](const Scene& s) { return s.contact.rolling_friction; }},
      {"solid_time_step", "time step of the spheres", [](const Scene& s) { return s.contact.time_step; },
       "solid_time_step"},
      {"fluid_time_step", "time step of the liquid", [](const Scene& s) { return s.fluid.time_step; }}};
  return list;
}

/// Few digits, and no exponent where it would not help.
std::string compact(double value) {
  if (std::isnan(value)) return "–";
  return std::fabs(value) < 1e4 ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
}

FigureOutput draw(const FigureContext& context) {
  const Scene scene = load_scene(source_folder() / "experiments" / "peng_2014" / "scenes" / "6in5W.toml", {});
  const auto doubts = inconsistencies();
  DataTable table{
      "table1_conditions", {"row of the table [-]", "printed [SI]", "here [SI]", "needed elsewhere [SI]"}, {}};
  std::vector<std::vector<std::string>> rows;
  for (const Condition& condition : conditions()) {
    const ReferenceValue& printed = peng_2014().at(condition.printed);
    double needed = std::nan("");
    for (const reports::InconsistencyRow& doubt : doubts)
      if (doubt.id == condition.inconsistency) needed = doubt.recomputed;
    const double ours = condition.ours(scene);
    rows.push_back({condition.title, printed.unit == "-" ? "" : printed.unit, compact(printed.value), compact(ours),
                    compact(needed)});
    table.rows.push_back({static_cast<double>(rows.size()), printed.value, ours, needed});
  }
  return draw_table("table1", folder, {headings, std::move(rows)}, table, {"No simulation stands behind this picture."},
                    690, context.out);
}

}  // namespace

Figure figure() { return {"table1", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::table1_conditions
