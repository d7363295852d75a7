#include "experiments/peng_2014/comparison.hpp"

#include <fmt/format.h>

#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"

namespace slfb::paper {

compare::ComparisonBed comparison_bed() {
  compare::ComparisonBed bed;
  bed.system = "6in5W";
  bed.bed = {glass(0.005), "glass"};
  bed.foreign = {steel(0.006), "steel"};
  bed.liquid = water();
  bed.liquid_name = "water";
  bed.packed_voidage = packed_voidage();

  bed.classification.title = "paper, Table 2";
  for (const Table2Row& row : peng_2014().table2())
    bed.classification.points.push_back({row.superficial_velocity, row.classification_velocity});
  bed.expansion.title = "paper, Fig. 13";
  for (const VoidagePoint& point : peng_2014().figure13())
    bed.expansion.points.push_back({point.superficial_velocity, point.voidage});
  bed.minimum_fluidisation = peng_2014().value("umf_crossing");
  bed.tabulated_velocities = {0.06, 0.08, 0.10};
  bed.slowest = 0.045;
  bed.fastest = 0.245;

  bed.drag_law = "gidaspow-1994";
  bed.contact_law = "linear";

  for (const RunSpec& run : load_profile("quick").runs)
    if (run.system == bed.system && run.variant.empty()) bed.three_dimensional.push_back(run);
  for (RunSpec run : bed.three_dimensional) {
    run.scene.replace_filename("6in5W_one-dimensional.toml");
    run.overrides = {fmt::format("liquid.superficial_velocity={} m/s", run.superficial_velocity)};
    bed.one_dimensional.push_back(std::move(run));
  }
  bed.usual_velocities = {0.06, 0.08, 0.10};
  bed.about_three_dimensional =
      "Simulated in the bed of the paper with the settings of the profile quick, three-dimensional liquid.";
  bed.about_one_dimensional =
      "Simulated in a slice of the paper's bed (20 mm square, periodic sides, 733 spheres) in a one-dimensional "
      "liquid: collisions and fluctuations are there, walls and circulation of the liquid are not.";
  bed.claims = load_claims();
  bed.measuring = peng_2014_work().measuring;
  return bed;
}

}  // namespace slfb::paper
