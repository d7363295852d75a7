#include "experiments/numerics/accuracy/expectation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/numerics/accuracy/sequence.hpp"
#include "experiments/quantities/quantity.hpp"
#include "experiments/runs/run_estimate.hpp"

namespace slfb::accuracy {
namespace {

/// Shares of the goal that models, grid and steps may have: coarse to fine, and beyond the goal to find the best that
/// can be had.
constexpr std::array shares_within{0.8, 0.6, 0.4, 0.2, 0.1};
constexpr std::array shares_beyond{1.0, 1.5, 2.5, 4.0, 8.0, 20.0, 100.0};

/// Time in which a bed takes up a new voidage, in times that the liquid needs to pass the packed bed at U_L: 8 s in the
/// bed of the studies, 0.2 m at 0.08 m/s. A run whose bed still changes is repeated over twice the time.
constexpr double passages = 4.0;

bool has_bed(const Scene& scene) {
  return std::ranges::any_of(scene.species, [](const Species& species) { return species.count > 0; });
}
bool has_stage(const Scene& scene, StageKind kind) {
  return std::ranges::any_of(scene.stages, [&](const Stage& stage) { return stage.kind == kind; });
}

/// Quantities that have an answer in this scene.
std::vector<std::string> answerable(const Scene& scene, const plan::Rules& rules) {
  std::vector<std::string> list;
  const bool bed = has_bed(scene), fluidised = bed && has_stage(scene, StageKind::fluidise);
  const bool drops = fluidised && has_stage(scene, StageKind::drop);
  for (const auto& [quantity, band] : rules.bands) {
    const bool by_law = quantity == "minimum_fluidisation_velocity";
    const bool lone = quantity == "terminal_velocity" && !bed;
    const bool measured = plan::measured_names().contains(quantity) && (of_drops(quantity) ? drops : fluidised);
    if ((by_law && bed) || lone || measured) list.push_back(quantity);
  }
  return list;
}

void check_questions(const Scene& scene, const Goal& goal, const plan::Rules& rules) {
  const auto known = answerable(scene, rules);
  for (const std::string& quantity : goal.asked) {
    if (!rules.bands.contains(quantity) || std::ranges::find(known, quantity) != known.end()) continue;
    const char* lack = !has_bed(scene)                          ? "there are no spheres of a bed"
                       : !has_stage(scene, StageKind::fluidise) ? "it has no [[stage]] of kind \"fluidise\""
                       : of_drops(quantity)                     ? "it has no [[stage]] of kind \"drop\""
                                                                : "no run answers that";
    throw std::invalid_argument(fmt::format("the scene cannot answer \"{}\": {}; it can answer {}", quantity, lack,
                                            known.empty() ? "nothing" : fmt::format("{}", fmt::join(known, ", "))));
  }
}

/// Without the rules of length and number, which follow from the goal.
plan::Rules systematic_rules(const plan::Rules& rules, const Goal& goal, double band) {
  plan::Rules list = rules;
  std::erase_if(list.list, [](const plan::Rule& rule) { return rule.part == plan::Part::statistics; });
  for (const std::string& quantity : goal.asked) list.bands.at(quantity) = band;
  return list;
}

/// Whether a richer scene can say what the decision changes here.
bool can_be_checked(const plan::Decision& decision) {
  return !decision.beyond.empty() &&
         (!decision.richer_overrides.empty() || decision.subject == "solid step" || decision.subject == "liquid step");
}

/// Errors of models, grid and steps. Where a check will measure what studies do not reach, they count as in the
/// studies.
std::map<std::string, Parts> systematic_parts(const plan::Plan& made, bool before_check) {
  std::map<std::string, Parts> parts;
  for (const std::string& quantity : made.asked) {
    Parts& of = parts[quantity];
    for (const plan::Decision& decision : made.decisions) {
      const auto& effects = before_check && can_be_checked(decision) ? decision.studied : decision.effect;
      const auto found = effects.find(quantity);
      if (found == effects.end()) continue;
      double& part = decision.part == plan::Part::model ? of.model : of.discretisation;
      part = std::hypot(part, found->second);
    }
  }
  return parts;
}

double largest_systematic(const std::map<std::string, Parts>& parts) {
  double largest = 0.0;
  for (const auto& [quantity, of] : parts) largest = std::max(largest, of.systematic());
  return largest;
}

/// The choices with the largest error on the worst quantity, in words.
std::string obstacle_of(const plan::Plan& made, const std::map<std::string, Parts>& parts, double error) {
  const auto worst = std::ranges::max_element(parts, {}, [](const auto& entry) { return entry.second.systematic(); });
  std::vector<const plan::Decision*> decisions;
  for (const plan::Decision& decision : made.decisions)
    if (decision.effect.contains(worst->first)) decisions.push_back(&decision);
  std::ranges::sort(decisions, std::greater{},
                    [&](const plan::Decision* decision) { return decision->effect.at(worst->first); });
  std::string text = fmt::format("{} cannot be had to {:.3g} %: models, grid and steps alone make {:.2g} %",
                                 worst->first, 100.0 * error, 100.0 * worst->second.systematic());
  for (std::size_t k = 0; k < std::min<std::size_t>(2, decisions.size()); ++k)
    text += fmt::format("{} {} ({}) {:.2g} %", k == 0 ? "; most of it:" : ",", decisions[k]->subject,
                        decisions[k]->choice, 100.0 * decisions[k]->effect.at(worst->first));
  return text;
}

/// Time of fluidisation [s]: whole half seconds, or one digit below that, so that it is a whole number of steps.
double time_to_settle_down(const Scene& scene) {
  double volume = 0.0;
  for (const Species& species : scene.species) volume += static_cast<double>(species.count) * species.volume();
  const double packed_height = volume / 0.6 / scene.geometry.cross_section();
  const double time = passages * packed_height / scene.liquid.superficial_velocity;
  if (time > 1.0) return 0.5 * std::ceil(2.0 * time);
  const double digit = std::pow(10.0, std::floor(std::log10(time)));
  return digit * std::ceil(time / digit);
}

/// Sets the times of fluidisation (at least what the scene has, if that is shorter than needed) and the drops.
Scene with_length(Scene scene, double seconds, int drops) {
  Stage* last = nullptr;
  for (Stage& stage : scene.stages) {
    if (stage.kind == StageKind::fluidise) last = &stage;
    if (stage.kind == StageKind::drop) stage.repetitions = drops;
  }
  if (last != nullptr) last->duration = seconds;
  return plan::changed(scene, {"contact.allow_large_time_step=true"});
}

/// Overrides of the scene that is compared with the planned one.
Overrides check_overrides(const Expectation& expected, const Scene& planned) {
  Overrides list;
  double solid = planned.contact.time_step, liquid = planned.fluid.time_step;
  for (const plan::Decision& decision : expected.plan.decisions) {
    if (!can_be_checked(decision)) continue;
    if (decision.subject == "solid step") solid *= 0.5;
    if (decision.subject == "liquid step") liquid *= 0.5;
    list.insert(list.end(), decision.richer_overrides.begin(), decision.richer_overrides.end());
  }
  if (planned.fluid.tier == FluidTier::quiescent) liquid = solid;
  // The step of the spheres divides that of the liquid.
  list.push_back(fmt::format("contact.time_step={}", liquid / std::ceil(liquid / solid - 1e-9)));
  list.push_back(fmt::format("fluid.time_step={}", liquid));
  return list;
}

double scatter_of(const std::string& quantity, const Scatter& scatter, const plan::Rules& rules) {
  const auto& own = of_drops(quantity) ? scatter.drop : scatter.bed;
  const auto& usual = of_drops(quantity) ? rules.drop_scatter : rules.bed_scatter;
  if (const auto found = own.find(quantity); found != own.end()) return found->second;
  const auto found = usual.find(quantity);
  return found == usual.end() ? 0.1 : found->second;
}

/// Beds, drops, cost and statistics of a plan whose other errors are known.
void add_samples(const Scene& scene, const Scatter& scatter, const plan::Rules& rules, Expectation& expected) {
  int beds = fewest_beds, drops = 0;
  for (const auto& [quantity, parts] : expected.parts) {
    const double half_width = expected.goal.error - parts.systematic();
    const int samples = samples_for(scatter_of(quantity, scatter, rules), half_width);
    if (of_drops(quantity))
      drops = std::max(drops, samples);
    else
      beds = std::max(beds, samples);
  }
  constexpr int most_drops = 10;  // into one bed: its own share of the scatter is then no larger than that of the drops
  const int drops_each = std::clamp((drops + beds - 1) / beds, 1, most_drops);
  beds = std::max(beds, (drops + drops_each - 1) / drops_each);
  expected.beds = beds;
  const Scene planned = plan::changed(scene, expected.plan.overrides);
  expected.scene = with_length(planned, time_to_settle_down(scene), drops_each);
  for (auto& [quantity, parts] : expected.parts)
    parts.statistics =
        half_width_of(scatter_of(quantity, scatter, rules), of_drops(quantity) ? beds * drops_each : beds, 1);
  expected.core_seconds = beds * estimate_run(expected.scene).core_seconds;
  for (const plan::Decision& decision : expected.plan.decisions)
    if (can_be_checked(decision)) expected.checked.push_back(decision.subject);
  if (expected.checked.empty()) return;
  expected.check = plan::changed(expected.scene, check_overrides(expected, expected.scene));
  expected.check_core_seconds = fewest_beds * estimate_run(*expected.check).core_seconds;
  expected.core_seconds += expected.check_core_seconds;
}

/// Answers by formula, whose errors are those of what it is given: no samples, but an interval all the same.
void answer(Expectation& expected) {
  expected.answers = plan::answer_by_formula(expected.scene, expected.plan);
  for (const auto& [quantity, found] : expected.answers) {
    Parts& parts = expected.parts.at(quantity);
    parts.statistics = found.error;
    if (parts.total() > expected.goal.error && expected.obstacle.empty())
      expected.obstacle = fmt::format("{} cannot be had to {:.3g} %: {} it is known to {:.2g} % only", quantity,
                                      100.0 * expected.goal.error, found.remark, 100.0 * parts.total());
    expected.best = std::max(expected.best, parts.total());
  }
}

}  // namespace

double Parts::systematic() const { return std::hypot(model, discretisation); }

bool of_drops(const std::string& quantity) {
  const auto name = plan::measured_names().find(quantity);
  if (name == plan::measured_names().end()) return false;
  const Quantity* measured = find_quantity(general_rules(), name->second);
  return measured != nullptr && (std::holds_alternative<OfDrop>(measured->computed) ||
                                 std::holds_alternative<OfDropNumbers>(measured->computed));
}

Scene bed_of(const Scene& scene, int number) {
  Scene bed = scene;
  bed.seed += static_cast<std::uint64_t>(number);
  return bed;
}

Scene refined(const Scene& scene) {
  const double liquid = 0.5 * scene.fluid.time_step;
  const double solid = scene.fluid.tier == FluidTier::quiescent ? liquid : 0.5 * scene.contact.time_step;
  const Scene halved =
      plan::changed(scene, {fmt::format("contact.time_step={}", solid), fmt::format("fluid.time_step={}", liquid)});
  if (scene.fluid.tier != FluidTier::three_dimensional) return halved;
  try {
    const int across = std::max(scene.fluid.cells_across + 1, scene.fluid.cells_across * 5 / 4);
    return plan::changed(
        halved, {fmt::format("fluid.cells_across={}", across),
                 fmt::format("fluid.cell_height={}", scene.fluid.cell_height * scene.fluid.cells_across / across)});
  } catch (const SceneError&) {  // a cell could lie inside a sphere
    return halved;
  }
}

Expectation expect(const Scene& scene, const Goal& goal, const plan::Rules& rules, const Scatter& scatter) {
  if (!(goal.error > 0.0 && goal.error < 1.0))
    throw std::invalid_argument("an accuracy lies between 0 and 1 (100 %), as \"5 %\" or 0.05");
  (void)plan::make_plan(scene, goal.asked, rules, goal.forces);  // refuses quantities that nobody knows
  check_questions(scene, goal, rules);
  std::optional<Expectation> cheapest, nearest;
  const auto look_at = [&](double share) {
    Expectation expected;
    expected.goal = goal;
    expected.plan = plan::make_plan(scene, goal.asked, systematic_rules(rules, goal, share * goal.error), goal.forces);
    if (!expected.by_formula() && std::ranges::find(goal.asked, "minimum_fluidisation_velocity") != goal.asked.end())
      throw std::invalid_argument(
          "minimum_fluidisation_velocity is the root of a law, and no run of one velocity has it: ask for it alone");
    expected.parts = systematic_parts(expected.plan, true);
    expected.best = largest_systematic(expected.parts);
    if (expected.by_formula()) {
      expected.scene = scene;
      expected.core_seconds = expected.plan.core_seconds;
    }
    if (!nearest || expected.best < nearest->best) nearest = expected;
    if (expected.best >= goal.error) return;
    if (!expected.by_formula()) add_samples(scene, scatter, rules, expected);
    if (!cheapest || expected.core_seconds < cheapest->core_seconds) cheapest = std::move(expected);
  };
  for (const double share : shares_within) look_at(share);
  if (cheapest) {
    cheapest->best = nearest->best;
    if (cheapest->by_formula()) answer(*cheapest);
    return *cheapest;
  }
  for (const double share : shares_beyond) look_at(share);
  nearest->obstacle = obstacle_of(nearest->plan, nearest->parts, goal.error);
  return *nearest;
}

}  // namespace slfb::accuracy
