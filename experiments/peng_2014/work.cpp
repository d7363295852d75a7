#include "experiments/peng_2014/work.hpp"

#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/causes/causes.hpp"
#include "experiments/peng_2014/comparison.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/inconsistencies.hpp"
#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/own_quantities.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/planned_figures/figure_plans.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/report_texts.hpp"
#include "experiments/work/profiles.hpp"

namespace slfb {
namespace {

MeasuringRules measuring_rules() {
  const Peng2014& printed = peng_2014();
  MeasuringRules rules;
  for (Quantity& quantity : paper::own_quantities()) rules.quantities.push_back(std::move(quantity));
  rules.classification_window = {0.1, 0.2};  // §4.1, §5.2: of the paper and of its experiment
  for (const BedSystem& system : bed_systems)
    rules.release_clocks[std::string(system.name)] =
        printed.value(system.liquid == BedLiquid::water ? "drop_time_water" : "drop_time_sodium_iodide");
  rules.release_height = printed.value("column_height");
  // On either side of U_mf = 0.042 m/s in Fig. 5.
  rules.packed_up_to = 0.0401;
  rules.fluidised_from = 0.0599;
  rules.printed_voidages = {0.45, 0.46, 0.51, 0.52, 0.55, 0.57, 0.58, 0.60, 0.62, 0.65, 0.67, 0.71, 0.79, 0.80};
  // Half the last printed digit, and as much for an unstated definition of the bed's voidage.
  rules.voidage_tolerance = 0.01;
  rules.at_voidages = {"collision_frequency", "collision_to_drag_ratio", "drag_ratio",           "lateral_travel",
                       "liquid_fluctuation",  "maximum_contacts",        "mean_contacts",        "peak_force_ratio",
                       "contact_fraction",    "pressure_gradient_ratio", "collision_force_ratio"};
  rules.printed_voidage = paper::voidage_by_equation_36;
  return rules;
}

Work put_together() {
  Work work;
  work.id = "peng_2014";
  work.citation =
      "Z. Peng, S. V. Ghatage, E. Doroodchi, J. B. Joshi, G. M. Evans, B. Moghtaderi, Forces acting on a single "
      "introduced particle in a solid-liquid fluidised bed, Chemical Engineering Science (2014), doi "
      "10.1016/j.ces.2014.04.040";
  work.folders = folders_of(work.id);
  for (const BedSystem& system : bed_systems)
    work.systems.push_back({std::string(system.name), std::string(system.title)});
  work.measuring = measuring_rules();
  work.reference = &peng_2014();
  work.figures = figures();
  work.shown_beside = "full";
  work.unchanged = {{"packed", default_reading}};
  work.read_by_figures = {"drag-law",    "causes",    "lattice",    "paper-steps", "packed",
                          "defluidised", "screening", "candidates", "literal"};
  work.stated_liquid_step = peng_2014().value("fluid_time_step");
  work.without_runs = measure_without_runs;
  work.name_causes = name_causes;
  work.inconsistencies = inconsistencies;
  work.texts = paper::report_texts;
  work.comparison_bed = paper::comparison_bed;
  work.figure_plans = figure_plans;
  return work;
}

}  // namespace

const Work& peng_2014_work() {
  static const Work work = put_together();
  return work;
}

std::vector<Claim> load_claims() { return load_claims(peng_2014_work()); }

Profile load_profile(const std::string& name) { return load_profile(peng_2014_work(), name); }

std::vector<FinishedRun> runs_with_own_springs(const std::filesystem::path& out) {
  return runs_with_scene_stiffness(peng_2014_work(), out);
}

}  // namespace slfb
