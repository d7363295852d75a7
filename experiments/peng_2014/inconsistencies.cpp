#include "experiments/peng_2014/inconsistencies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/drag/ergun_1952.hpp"
#include "correlations/drag/gidaspow_1994.hpp"
#include "correlations/drag/wen_yu_1966.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

/// Ergun's drag with the factor α_L of Eq. 20 in front.
struct ErgunTimesVoidage {
  double operator()(drag::SuspensionFlow flow) const { return flow.voidage * drag::Ergun1952{}(flow); }
};

/// Builds the table; each function is one or a few rows that share their numbers.
class InconsistencyTable {
 public:
  std::vector<reports::InconsistencyRow> take() {
    add_bed_rows();
    add_equation_rows();
    add_numerics_rows();
    add_pressure_rows();
    add_expansion_rows();
    add_settling_rows();
    add_collision_rows();
    add_force_rows();
    return std::move(rows_);
  }

 private:
  [[nodiscard]] double paper(const char* id) const { return paper_.value(id); }
  [[nodiscard]] double law(const char* quantity, const char* subject) const {
    return laws_.at({quantity, subject}).value;
  }
  [[nodiscard]] double law(const char* quantity, const char* subject, double at) const {
    return laws_.at(measure_key(quantity, subject, at)).value;
  }
  [[nodiscard]] const Table2Row& row_at(double velocity) const {
    for (const Table2Row& row : paper_.table2()) {
      if (std::abs(row.superficial_velocity - velocity) < 1e-9) return row;
    }
    throw std::out_of_range(fmt::format("Table 2 has no row at {} m/s", velocity));
  }

  /// A row whose printed number is the reference value `reference`.
  void add(const char* id, const char* subject, const char* reference, double recomputed, std::string explanation) {
    const ReferenceValue& printed = paper_.at(reference);
    rows_.push_back({id, subject, printed.source, printed.value, recomputed, printed.unit, std::move(explanation)});
  }

  void add_bed_rows() {
    const double mass = paper("fluidised_mass_text");
    const double printed_density = paper("fluidised_particle_density");
    const double height = paper("packed_height");
    const double volume_3mm = paper::glass(0.003).volume();
    add("particle_density", "density of the fluidised glass", "fluidised_particle_density",
        law("glass_density", "from-particle-count"),
        fmt::format("With {:.0f} kg/m³ the {} kg make {:.0f} spheres of 3 mm, weigh {:.0f} Pa and fill {} m at voidage "
                    "{:.3f}; with {:.0f} kg/m³ these are {:.1f}, {:.1f} Pa and {:.4f}, the printed {:.0f}, {:.0f} Pa "
                    "and a packed bed of that height.",
                    printed_density, mass, mass / (printed_density * volume_3mm),
                    paper::bed_weight_pressure(printed_density), height,
                    paper::voidage_in_column(mass, printed_density, height), paper::glass_density,
                    law("particle_count", "3mm"), law("bed_weight_pressure", "glass-2230"), paper::packed_voidage(),
                    paper("particle_count_3mm"), paper("bed_weight_pressure")));

    const double table_mass = paper("fluidised_mass_table");
    add("particle_mass", "mass of the fluidised particles", "fluidised_mass_table",
        law("fluidised_mass", "in-packed-height"),
        fmt::format("The text has {} kg; {} kg of glass would make a bed of {:.3f} m, not of {} m.", mass, table_mass,
                    table_mass / (paper::glass_density * (1.0 - paper::packed_voidage()) * paper::column_area()),
                    height));

    const double stated_solids = paper("packed_solid_fraction");
    add("packed_solids", "solid fraction of the packed bed", "packed_solid_fraction", 1.0 - paper::packed_voidage(),
        fmt::format("{} kg in {} m is a solid fraction of {:.3f}; at {} the bed would stand {:.4f} m high.", mass,
                    height, 1.0 - paper::packed_voidage(), stated_solids,
                    mass / (paper::glass_density * stated_solids * paper::column_area())));

    const double water = paper("water_viscosity") / paper("water_density");
    const double iodide = paper("sodium_iodide_viscosity") / paper("sodium_iodide_density");
    rows_.push_back(
        {"liquid_viscosity", "kinematic viscosity of the NaI solution", "Table 1, p. 53; §5.4.2, p. 37", iodide, water,
         "m²/s",
         fmt::format("Water has {:.4g} m²/s and NaI {:.4g} m²/s, so that comparing the two liquids tests the buoyancy "
                     "({:.0f} and {:.0f} kg/m³ of density difference), not the viscosity.",
                     water, iodide, paper::glass_density - paper("water_density"),
                     paper::glass_density - paper("sodium_iodide_density"))});
  }

  void add_equation_rows() {
    const double voidage = paper::packed_voidage();
    const auto velocity = [&](const auto& drag_law) {
      return fluidisation::minimum_fluidisation_velocity(drag_law, paper::glass(0.005), paper::water(), voidage);
    };
    const double with_factor = velocity(ErgunTimesVoidage{});
    rows_.push_back(
        {"drag_factor", "minimum fluidisation velocity with the drag of Eq. 20", "Eqs. 20 and 35, pp. 13 and 19",
         paper("umf_equation_36"), with_factor, "m/s",
         fmt::format("Eq. 20 multiplies the drag by the voidage and Eq. 35 does not; with the factor a bed of voidage "
                     "{:.3f} would fluidise at {:.4f} m/s, without it at {:.4f} m/s.",
                     voidage, with_factor, velocity(drag::Ergun1952{}))});
    add("centroid_error", "largest error of the centroid method", "centroid_error",
        law("centroid_volume_error", "corner"),
        fmt::format(
            "A sphere at a cell face is misplaced by {:.0f} % of its volume, but one at an edge by {:.0f} % and "
            "one at a corner by {:.1f} %.",
            100.0 * law("centroid_volume_error", "face"), 100.0 * law("centroid_volume_error", "edge"),
            100.0 * law("centroid_volume_error", "corner")));
  }

  void add_numerics_rows() {
    const double contact_3mm = law("contact_time", "glass-3mm-glass-3mm");
    const Sphere sphere = paper::glass(0.003);
    const double effective_mass = 0.5 * sphere.volume() * sphere.density;
    const double limit = 2.0 * std::sqrt(effective_mass / paper("normal_stiffness"));
    constexpr double steps_usual = 20.0;
    add("solid_time_step", "time step of the particles", "solid_time_step", contact_3mm / steps_usual,
        fmt::format(
            "A collision of 5 mm spheres lasts {:.3g} s ({:.1f} steps) and one of 3 mm spheres {:.3g} s ({:.1f} "
            "steps) where {:.0f} are usual; the explicit limit of a single 3 mm pair is {:.2g} s, and lower in "
            "a packing.",
            law("contact_time", "glass-5mm-glass-5mm"), law("steps_per_contact", "glass-5mm-glass-5mm"), contact_3mm,
            law("steps_per_contact", "glass-3mm-glass-3mm"), steps_usual, limit));
    add("maximum_overlap", "largest overlap over particle radius", "maximum_overlap", law("overlap", "peak-highest"),
        fmt::format("Peaks of {:.0f} to {:.0f} times the weight of the steel sphere press it {:.2f} to {:.2f} % of its "
                    "radius into its neighbour; the printed {:.4f} % can only be an average.",
                    paper("peak_force_lowest"), paper("peak_force_highest"), 100.0 * law("overlap", "peak-lowest"),
                    100.0 * law("overlap", "peak-highest"), 100.0 * paper("maximum_overlap")));
    const double cell = law("mean_cell_size", "stated-mesh");
    rows_.push_back({"cell_size", "mean cell of the mesh against the foreign sphere", paper_.at("cell_count").source,
                     0.006, cell, "m",
                     fmt::format("{:.0f} cells in the column are {:.2f} mm wide on average, so that the 6 mm sphere "
                                 "fills {:.0f} % of one and sees itself in its local voidage.",
                                 paper("cell_count"), 1000.0 * cell, 100.0 * law("cell_fraction", "steel-6mm"))});
    add("restitution", "restitution in the liquid", "restitution_coefficient",
        paper("restitution_coefficient") * law("wet_restitution", "glass-5mm-water-lowest"),
        fmt::format(
            "By Legendre et al. (2005) a 5 mm glass sphere that hits at √q_p² of Fig. 18 keeps {:.2f} to {:.2f} "
            "of its dry restitution in water.",
            law("wet_restitution", "glass-5mm-water-lowest"), law("wet_restitution", "glass-5mm-water-highest")));
  }

  void add_pressure_rows() {
    add("umf_packing", "minimum fluidisation velocity by Eq. 36", "umf_equation_36",
        law("minimum_fluidisation_velocity", "equation-36-at-stated-packing"),
        fmt::format("The printed value needs voidage {:.3f}; at the packed {} it is {:.4f} m/s.",
                    paper::packed_voidage(), paper("packed_voidage"),
                    law("minimum_fluidisation_velocity", "equation-36-at-stated-packing")));
    const double weight = law("bed_weight_pressure", "glass-2230");
    const double steel = paper::steel(0.006).volume() * (paper::steel(0.006).density - paper::water().density) *
                         gravitational_acceleration / paper::column_area();
    add("pressure_plateau", "pressure drop of the fluidised bed", "pressure_plateau", weight,
        fmt::format("That is {:.1f} % more than the bed weighs, which a steady bed cannot carry; the steel sphere adds "
                    "{:.1f} %.",
                    100.0 * (paper("pressure_plateau") / weight - 1.0), 100.0 * steel / weight));
    add("packed_line", "pressure drop of the packed bed at 0.03 m/s", "figure5/packed_line/0.03",
        law("packed_pressure", "ergun-1952", 0.03),
        fmt::format(
            "The line is negative below {:.4f} m/s, so it is no packed-bed law; Ergun's equation gives {:.0f} and "
            "{:.0f} Pa at 0.03 and 0.04 m/s where the line has {:.0f} and {:.0f} Pa.",
            -paper("packed_line_intercept") / paper("packed_line_slope"), law("packed_pressure", "ergun-1952", 0.03),
            law("packed_pressure", "ergun-1952", 0.04), paper("figure5/packed_line/0.03"),
            paper("figure5/packed_line/0.04")));
  }

  void add_expansion_rows() {
    std::vector<std::string> printed, gidaspow, equation_36;
    double largest = 0.0;
    for (const VoidagePoint& point : paper_.figure13()) {
      printed.push_back(fmt::format("{:.2f}", point.voidage));
      gidaspow.push_back(
          fmt::format("{:.3f}", law("homogeneous_voidage", "gidaspow-1994", point.superficial_velocity)));
      equation_36.push_back(
          fmt::format("{:.3f}", law("homogeneous_voidage", "doroodchi-2012", point.superficial_velocity)));
      largest = std::max(largest, std::abs(law("voidage_difference", "doroodchi-2012", point.superficial_velocity)));
    }
    add("drag_law", "voidage of the bed at 0.11 m/s under the drag law the paper names", "figure13/voidage/0.11",
        law("homogeneous_voidage", "gidaspow-1994", 0.11),
        fmt::format("From 0.06 to 0.11 m/s the captions print {}; a homogeneous bed under Gidaspow's law stands at {}, "
                    "under that of Eq. 36 at {} (within {:.3f}).",
                    fmt::join(printed, ", "), fmt::join(gidaspow, ", "), fmt::join(equation_36, ", "), largest));

    const auto at_switch = [](const auto& drag_law) {
      return fluidisation::superficial_velocity(drag_law, paper::glass(0.005), paper::water(), 0.8);
    };
    const double below = at_switch(drag::Ergun1952{});
    const double above = at_switch(drag::WenYu1966{});
    const auto possible = std::count_if(paper_.table2().begin(), paper_.table2().end(), [&](const Table2Row& row) {
      return row.superficial_velocity < below || row.superficial_velocity > above;
    });
    rows_.push_back(
        {"drag_switch", "velocities of Table 2 with a homogeneous bed under Gidaspow's law",
         "Eq. 23, p. 14; Table 2, p. 54", static_cast<double>(paper_.table2().size()), static_cast<double>(possible),
         "-",
         fmt::format("The law jumps at voidage 0.8, so that no homogeneous bed of 5 mm glass in water exists "
                     "between {:.3f} and {:.3f} m/s.",
                     below, above)});
    add("washed_out", "superficial velocity of the NaI bed in Fig. 17", "figure17_velocity",
        law("terminal_velocity", "glass-5mm-sodium-iodide"),
        fmt::format("A 5 mm glass sphere falls at {:.3f} m/s in that liquid, so that the bed would wash out at {} m/s.",
                    law("terminal_velocity", "glass-5mm-sodium-iodide"), paper("figure17_velocity")));
    add("figure15_caption", "voidage of the dilute case of Fig. 15", "figure15_caption_voidage",
        paper("figure15_text_voidage"),
        "The caption repeats the voidage of the case before; text and plot have the other.");
    add("solid_fraction_range", "largest solid fraction of Fig. 19", "solid_fraction_text",
        paper("solid_fraction_axis"),
        fmt::format("The axis ends at {}; beyond {} Eq. 7 has no value.", paper("solid_fraction_axis"),
                    paper("packed_solid_fraction")));
  }

  /// When the fitted line of Table 2 reaches z = 0, after the release [s].
  [[nodiscard]] double line_at_bottom(double velocity) const {
    const Table2Row& row = row_at(velocity);
    return row.intercept / row.classification_velocity - paper("drop_time_water");
  }

  void add_settling_rows() {
    add("settling_time", "time from release to the bottom at 0.06 m/s", "settling_time_0.06", line_at_bottom(0.06),
        fmt::format(
            "The line of Table 2 reaches the bottom {:.2f} s after the release at 0.06 m/s (text: {}) and {:.2f} "
            "s at 0.07 m/s (text: {}).",
            line_at_bottom(0.06), paper("settling_time_0.06"), line_at_bottom(0.07), paper("settling_time_0.07")));
    const double between = 0.5 * (line_at_bottom(0.16) + line_at_bottom(0.18));
    add("copied_intercept", "intercept of the line at 0.17 m/s", "table2/intercept/0.17",
        row_at(0.17).classification_velocity * (paper("drop_time_water") + between),
        fmt::format(
            "It repeats that at 0.16 m/s and puts the sphere at the bottom {:.2f} s after the release, where the "
            "neighbours need {:.2f} and {:.2f} s.",
            line_at_bottom(0.17), line_at_bottom(0.16), line_at_bottom(0.18)));

    std::vector<std::string> dips;
    double deepest = 0.0;
    const auto& table = paper_.table2();
    for (std::size_t i = 1; i < table.size(); ++i) {
      const double change = table[i].classification_velocity / table[i - 1].classification_velocity - 1.0;
      if (change >= 0.0) continue;
      dips.push_back(fmt::format("{:.2f}", table[i].superficial_velocity));
      deepest = std::min(deepest, change);
    }
    rows_.push_back(
        {"velocity_dips", "steps of Table 2 in which the classification velocity falls", "Table 2, p. 54; §5.2, p. 27",
         0.0, static_cast<double>(dips.size()), "-",
         fmt::format("It falls at {} m/s, by up to {:.0f} %; each velocity is one drop, so that this is scatter until "
                     "drops are repeated.",
                     fmt::join(dips, ", "), -100.0 * deepest)});
  }

  void add_collision_rows() {
    const double kinetic = law("dimensionless_collision_frequency", "simonin-1991", 0.42);
    const double speed = std::sqrt(paper("fluctuating_energy_lowest"));
    const double printed = paper("collision_frequency_dilute");
    add("kinetic_theory", "collision frequency at solid fraction 0.42", "collision_frequency_dilute",
        kinetic * speed / 0.005,
        fmt::format(
            "Even at the smallest fluctuating energy of Fig. 18 the printed {:.0f} 1/s is f* = {:.1f} (5 mm) or "
            "{:.1f} (6 mm), where the kinetic theory has {:.1f}; the swept volume of a sphere that drifts at V_2 "
            "(Eq. 5) gives {:.0f} 1/s.",
            printed, printed * 0.005 / speed, printed * 0.006 / speed, kinetic,
            law("collision_frequency", "gjaltema-1997", 0.42)));
    add("stokes_number", "Stokes number of the particles, lower bound", "stokes_limit",
        law("stokes_number", "glass-3mm-sodium-iodide-lowest"),
        fmt::format("With the fluctuating energies of Fig. 18 the glass spheres span {:.0f} to {:.0f}; only the steel "
                    "sphere, {:.0f} and more, is always above.",
                    law("stokes_number", "glass-3mm-sodium-iodide-lowest"),
                    law("stokes_number", "glass-5mm-water-highest"),
                    law("stokes_number", "steel-6mm-sodium-iodide-lowest")));
  }

  void add_force_rows() {
    add("mean_drag", "drag over weight of the foreign sphere in the dilute bed", "drag_ratio_dilute",
        law("drag_ratio", "gidaspow-1994", 0.24),
        fmt::format("At the mean voidage and the velocities of Table 2, from 0.06 to 0.24 m/s, Gidaspow's law gives "
                    "{:.2f} to {:.2f} of the weight, Wen and Yu's {:.2f} to {:.2f}; the paper has {} to {}.",
                    law("drag_ratio", "gidaspow-1994", 0.06), law("drag_ratio", "gidaspow-1994", 0.24),
                    law("drag_ratio", "wen-yu-1966", 0.06), law("drag_ratio", "wen-yu-1966", 0.24),
                    paper("drag_ratio_dense"), paper("drag_ratio_dilute")));
    add("pressure_force", "pressure-gradient force over weight in the dense bed", "pressure_ratio_dense",
        law("pressure_gradient_ratio", "suspension", 0.46),
        fmt::format(
            "In a fluidised bed the pressure carries the suspension: {:.3f} at voidage 0.46 and {:.3f} at 0.80; "
            "the paper has {} and {}, less than the hydrostatic {:.3f}.",
            law("pressure_gradient_ratio", "suspension", 0.46), law("pressure_gradient_ratio", "suspension", 0.80),
            paper("pressure_ratio_dense"), paper("pressure_ratio_dilute"), law("buoyancy_ratio", "steel-water")));
    add("hydrostatic_force", "pressure-gradient force over weight below voidage 0.54", "pressure_ratio_dense",
        law("buoyancy_ratio", "steel-water"),
        fmt::format("The text says that it is the hydrostatic {}, the plot of the same quantity begins at {}.",
                    paper("buoyancy_ratio"), paper("pressure_ratio_dense")));
    const auto collision_force = [&](double voidage) {
      return paper("equation_40_constant") + paper("equation_40_linear") * voidage +
             paper("equation_40_quadratic") * voidage * voidage;
    };
    const double dense =
        collision_force(paper("voidage_range_begin")) + paper("drag_ratio_dense") + paper("pressure_ratio_dense");
    const double dilute =
        collision_force(paper("voidage_range_end")) + paper("drag_ratio_dilute") + paper("pressure_ratio_dilute");
    rows_.push_back({"force_balance", "sum of the mean upward forces on the settling sphere over its weight",
                     "Eq. 40, p. 41; Fig. 22", 1.0, dense, "-",
                     fmt::format("Collision force (Eq. 40), drag and pressure-gradient force of the plots add up to "
                                 "{:.2f} at voidage {} and {:.2f} at {}, where a steady fall needs 1.",
                                 dense, paper("voidage_range_begin"), dilute, paper("voidage_range_end"))});
  }

  const Peng2014& paper_ = peng_2014();
  const Measurements laws_ = measure_laws();
  std::vector<reports::InconsistencyRow> rows_;
};

}  // namespace

std::vector<reports::InconsistencyRow> inconsistencies() { return InconsistencyTable().take(); }

}  // namespace slfb
