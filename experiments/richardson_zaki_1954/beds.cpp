#include "experiments/richardson_zaki_1954/beds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "experiments/league/contenders.hpp"
#include "experiments/reference/reference_numbers.hpp"
#include "solver/support/folders.hpp"

namespace slfb::richardson_zaki {
namespace {

constexpr double packed_solids = 0.6;       // of the height of the packed bed, for the size of a model alone
constexpr double widest_column = 20.0;      // in diameters
constexpr double slice_width = 6.0;         // in diameters
constexpr double box_width = 10.0;          // in diameters
constexpr double slice_height = 20.0;       // of the packed bed, in diameters
constexpr double column_height = 10.0;      // of the packed bed, in diameters
constexpr double height_over_packed = 8.0;  // room for a bed of voidage 0.92
constexpr double impact_overlap = 0.03;     // of two spheres that meet at the terminal velocity, over d
constexpr double steps_per_contact = 20.0;
constexpr int contact_steps_per_liquid_step = 20;
constexpr double fluidised_times = 300.0;  // in d/u_t

/// Three significant digits, so that scenes stay readable.
double rounded(double value) { return std::stod(fmt::format("{:.3g}", value)); }

}  // namespace

const std::vector<ExpansionLine>& beds() {
  static const std::vector<ExpansionLine> list = [] {
    std::vector<ExpansionLine> fluidised;
    std::ranges::copy_if(expansion_lines(reference_data_folder() / "richardson_zaki_1954"),
                         std::back_inserter(fluidised),
                         [](const ExpansionLine& line) { return line.motion == BedMotion::fluidised; });
    return fluidised;
  }();
  return list;
}

const ExpansionLine& bed(const std::string& name) {
  const auto found = std::ranges::find(beds(), name, &ExpansionLine::name);
  if (found == beds().end()) throw std::out_of_range("Richardson & Zaki (1954) have no bed \"" + name + "\"");
  return *found;
}

double run_velocity(const ExpansionLine& line, double voidage) {
  return std::round(line.velocity(voidage) * 1e5) / 1e5;
}

std::filesystem::path scene_of(const ExpansionLine& line, Model model) {
  return source_folder() / "experiments" / "richardson_zaki_1954" / "scenes" /
         (model == Model::slice ? "slice.toml"
          : has_walls(line)     ? "column.toml"
                                : "box.toml");
}

bool has_walls(const ExpansionLine& line) { return line.tube_diameter <= widest_column * line.sphere.diameter; }

Overrides overrides_of(const ExpansionLine& line, Model model) {
  const double d = line.sphere.diameter;
  const double terminal = league::terminal_velocity(league::bed_of(line));
  const bool walls = model == Model::column && has_walls(line);
  const double width = walls ? line.tube_diameter : d * (model == Model::slice ? slice_width : box_width);
  const double section = walls ? 0.25 * std::numbers::pi * width * width : width * width;
  const double packed_height = d * (model == Model::slice ? slice_height : column_height);
  const double count = std::round(packed_solids * section * packed_height / line.sphere.volume());

  // Two spheres of reduced mass m/2 that meet at u_t overlap by u_t √(m/2k); they part after π √(m/2k).
  const double reduced_mass = 0.5 * line.sphere.volume() * line.sphere.density;
  const double overlap_time = impact_overlap * d / terminal;
  const double step = rounded(std::numbers::pi * overlap_time / steps_per_contact);
  const double liquid_step = contact_steps_per_liquid_step * step;

  Overrides overrides{
      fmt::format("species[0].diameter={} m", d),
      fmt::format("species[0].density={} kg/m3", line.sphere.density),
      fmt::format("species[0].count={:.0f}", count),
      fmt::format("liquid.density={} kg/m3", line.liquid.density),
      fmt::format("liquid.viscosity={} Pa s", line.liquid.viscosity),
      fmt::format("geometry.height={} m", rounded(height_over_packed * packed_height)),
      fmt::format("fluid.cell_height={} m", 1.25 * d),
      fmt::format("contact.stiffness={} N/m", rounded(reduced_mass / (overlap_time * overlap_time))),
      fmt::format("contact.time_step={} s", step),
      fmt::format("fluid.time_step={} s", liquid_step),
      fmt::format("recording.bed_interval={} s", 10.0 * liquid_step),
      fmt::format("stage[0].duration={} s", rounded(0.8 * std::sqrt(d / 5e-3))),
      fmt::format("stage[1].duration={} s", rounded(fluidised_times * d / terminal)),
  };
  overrides.push_back(walls ? fmt::format("geometry.diameter={} m", width)
                            : fmt::format("geometry.width=[\"{0} m\", \"{0} m\"]", width));
  if (model == Model::column)
    overrides.push_back(fmt::format("fluid.cells_across={:.0f}", std::round(width / (1.25 * d))));
  return overrides;
}

}  // namespace slfb::richardson_zaki
