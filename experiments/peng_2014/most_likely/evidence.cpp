#include "experiments/peng_2014/most_likely/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/quantities/measure_key.hpp"

namespace slfb::most_likely {
namespace {

using readings::Evidence, readings::Part;

constexpr const char* system_name = "6in5W";
constexpr const char* packed_bed = "packed bed";

/// Numbers that chose something of the default scene (scenes/6in5W.toml says how).
constexpr double chose_spring = 0.06;
constexpr std::array chose_own_volume{0.06, 0.10, 0.16};

std::string drops_at(double velocity) { return fmt::format("drops at {} m/s", velocity_text(velocity)); }

Evidence of_table(const std::string& id, const std::string& title, const std::string& quantity,
                  const std::string& block, double velocity, Part part) {
  const ReferenceValue& printed = peng_2014().at(fmt::format("{}/{}", id, velocity_text(velocity)));
  return {{fmt::format("{} at {} m/s", title, velocity_text(velocity)), quantity, block, printed.value,
           printed.uncertainty, part},
          system_name,
          velocity,
          ""};
}

/// A force or a frequency that the text gives for one state of the bed.
Evidence of_text(const std::string& id, const std::string& title, const std::string& quantity, const std::string& block,
                 double velocity) {
  const ReferenceValue& printed = peng_2014().at(id);
  return {{fmt::format("{} at {} m/s", title, velocity_text(velocity)), quantity, block, printed.value,
           printed.uncertainty, Part::test},
          system_name,
          velocity,
          ""};
}

/// Printed twice: as a solid fraction, and as a height that leaves half of its last digit open.
Evidence voidage_of_the_packed_bed() {
  const Peng2014& printed = peng_2014();
  const double mass = printed.value("fluidised_mass_text");
  const ReferenceValue &height = printed.at("packed_height"), &solids = printed.at("packed_solid_fraction");
  const double lowest = paper::voidage_in_column(mass, paper::glass_density, height.value - height.uncertainty),
               highest = 1.0 - solids.value + solids.uncertainty;
  return {{"voidage of the packed bed", "packed_voidage", packed_bed, 0.5 * (lowest + highest),
           0.5 * (highest - lowest), Part::calibration},
          system_name,
          std::nullopt,
          ""};
}

Evidence time_to_the_window(const Table2Row& row) {
  const double velocity = row.superficial_velocity;
  Evidence time = of_table("table2/time_to_window", "time to the window", "time_to_window", drops_at(velocity),
                           velocity, Part::test);
  if (std::ranges::count(peng_2014().table2(), row.intercept, &Table2Row::intercept) > 1)
    time.disputed = "two rows of Table 2 have one intercept, so that one of them is a copy";
  if (std::ranges::count(chose_own_volume, velocity) > 0) time.chose = "what a lone sphere reads";
  return time;
}

}  // namespace

std::vector<Evidence> evidence() {
  const Peng2014& printed = peng_2014();
  std::vector<Evidence> list{voidage_of_the_packed_bed()};
  for (const double velocity : {0.03, 0.04})
    list.push_back(
        of_table("figure5/packed_line", "pressure drop", "pressure_drop", packed_bed, velocity, Part::calibration));
  for (const Table2Row& row : printed.table2()) {
    const double velocity = row.superficial_velocity;
    list.push_back(of_table("table2/classification_velocity", "V_2", "classification_velocity", drops_at(velocity),
                            velocity, Part::test));
    if (velocity == chose_spring) list.back().chose = "the tangential spring";
    list.push_back(time_to_the_window(row));
    // Eq. 40 over the voidage of Eq. 36 at this velocity, as the paper draws it; most points lie within this of it.
    const auto bed = paper::steel_in_glass(velocity);
    const double force = collision::Peng2014{}(bed, 0.0);
    list.push_back({{fmt::format("|F_c|/mg at {} m/s", velocity_text(velocity)), "collision_force_ratio",
                     drops_at(velocity), force, printed.value("equation_40_most") * force, Part::test},
                    system_name,
                    velocity,
                    ""});
  }
  // The text gives these for voidages of 0.46 and 0.58, which the captions of Fig. 13 have at 0.06 and 0.11 m/s.
  list.push_back(of_text("drag_ratio_dense", "drag/mg", "drag_ratio", drops_at(0.06), 0.06));
  list.push_back(of_text("pressure_ratio_dense", "pressure force/mg", "pressure_gradient_ratio", drops_at(0.06), 0.06));
  list.push_back(of_text("collision_frequency_dense", "f_coll", "collision_frequency", "collisions at 0.06 m/s", 0.06));
  list.push_back(
      of_text("collision_frequency_dilute", "f_coll", "collision_frequency", "collisions at 0.11 m/s", 0.11));
  for (const VoidagePoint& point : printed.figure13()) {
    Evidence voidage = of_table("figure13/voidage", "voidage", "voidage_centre_of_mass",
                                fmt::format("bed at {} m/s", velocity_text(point.superficial_velocity)),
                                point.superficial_velocity, Part::test);
    voidage.disputed =
        "the printed voidages are those of Eq. 36 to half a hundredth, so that they may be computed and not simulated";
    list.push_back(std::move(voidage));
  }
  return list;
}

}  // namespace slfb::most_likely
