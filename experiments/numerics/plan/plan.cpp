#include "experiments/numerics/plan/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>

#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/fluidisation/fluidisation_laws.hpp"
#include "correlations/law_list.hpp"
#include "correlations/materials.hpp"
#include "experiments/numerics/plan/settled_bed.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "solver/dem/particles.hpp"
#include "solver/laws/scene_drag_law.hpp"
#include "solver/run/one_particle.hpp"

namespace slfb::plan {
namespace {

/// By which the rules tell how far a bed is from minimum fluidisation: the studies have the same convention. What a bed
/// settles to is another question (settle).
constexpr double conventional_packing = 0.4;

Sphere sphere_of(const Species& species) { return {species.diameter, species.density}; }
LiquidProperties liquid_of(const Scene& scene) { return {scene.liquid.density, scene.liquid.viscosity}; }

const Species& leading_species(const Scene& scene) {
  for (const Species& species : scene.species)
    if (species.count > 0) return species;
  return scene.species.front();
}

double bed_spheres(const Scene& scene) {
  double n = 0.0;
  for (const Species& species : scene.species) n += static_cast<double>(species.count);
  return n;
}

double terminal_velocity(const Scene& scene, const Species& sphere) {
  return fluidisation::superficial_velocity(scene_drag_law(scene), sphere_of(sphere), liquid_of(scene), 1.0);
}

/// The liquid brings the momentum ρ U² (1/ε − 1) per area into the bed, which the pressure drop lacks of the buoyant
/// weight over the area. ε is that of the lowest cells, which may be much less than that of the bed (0.52 where the bed
/// had 0.59, 5 mm glass at 0.08 m/s): the packing gives the most that it can be. Where that leaves the band, it is let
/// in with U_L, without it; not where the scene keeps what it says of forces.
void add_momentum_at_inlet(const Scene& scene, Forces forces, Plan& plan) {
  if (scene.fluid.inlet_velocity == InletVelocity::superficial) return;
  const double velocity = scene.liquid.superficial_velocity, area = scene.geometry.cross_section();
  double weight = 0.0;
  for (const Species& species : scene.species)
    weight += static_cast<double>(species.count) * species.volume() * (species.density - scene.liquid.density) *
              gravitational_acceleration;
  if (!(weight > 0.0)) return;
  const double share = scene.liquid.density * velocity * velocity * (1.0 / conventional_packing - 1.0) * area / weight;
  Decision decision{
      .subject = "momentum at the inlet",
      .choice = "enters with the velocity between the spheres",
      .why =
          "the pressure drop is less than the buoyant weight over the area by what the liquid brings: at most this, "
          "where the lowest cells are packed",
      .source = "momentum balance of the column; solver/scene/README.md",
      .evidence = "exact by construction",
      .studied = {{"pressure_drop", share}},
      .effect = {{"pressure_drop", share}},
      .richer = "superficial velocity",
      .richer_overrides = {"fluid.inlet_velocity=superficial"},
      .richer_core_seconds = plan.core_seconds};
  if (forces == Forces::planned && share > plan.band.at("pressure_drop")) {
    decision.choice = "superficial velocity";
    decision.why =
        fmt::format("with that between the spheres the liquid would bring up to {:.2g} % of the weight", 100.0 * share);
    decision.overrides = decision.richer_overrides;
    decision.studied = decision.effect = {{"pressure_drop", 0.0}};
    decision.richer.clear();
    decision.richer_overrides.clear();
    plan.overrides.emplace_back("fluid.inlet_velocity=superficial");
  }
  plan.effect["pressure_drop"] = std::hypot(plan.effect["pressure_drop"], decision.effect.at("pressure_drop"));
  plan.decisions.push_back(std::move(decision));
}

/// Share of its velocity that a sphere keeps in a tube, by a law of the catalogue.
double kept_in_tube(const std::string& law, double diameter_ratio) {
  return with_law<fluidisation::WallCorrectionLaws>("wall law", law,
                                                    [&](auto correction) { return correction(diameter_ratio); });
}

/// A terminal velocity as the scene has its walls: by its law, or without them, and then with what they would take.
FormulaAnswer beside_walls(const Scene& scene, const Species& sphere, double unbounded) {
  if (scene.geometry.shape != Shape::cylinder) return {unbounded};
  const double ratio = sphere.diameter / scene.geometry.diameter;
  if (scene.coupling.wall_retardation != "none")
    return {unbounded * kept_in_tube(scene.coupling.wall_retardation, ratio), 0.0,
            "less what the tube takes by " + scene.coupling.wall_retardation};
  constexpr double newtons_regime = 1000.0;  // above which Munroe's law holds; the other is for creeping flow
  const bool fast = reynolds_number(liquid_of(scene), sphere.diameter, unbounded) > newtons_regime;
  const std::string law = fast ? "munroe-1888" : "haberman-sayre-1958";
  if (ratio >= 0.5) return {unbounded, 0.0, "without walls, which hold such a sphere back"};
  return {unbounded, 0.0,
          fmt::format("without walls, as coupling.wall_retardation says; this tube takes {}{:.2g} % off by {}",
                      fast ? "" : "up to ", 100.0 * (1.0 - kept_in_tube(law, ratio)), law)};
}

/// 1, 2 or 5 times a power of ten, never above the value: steps that people can read.
double rounded_down(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * decade <= value * (1.0 + 1e-9)) return digit * decade;
  return decade;
}

/// Times that a run counts in liquid steps, where a scene with steps of this length may not have them: the nearest
/// whole number of steps. Intervals that the scene leaves at their defaults adapt by themselves.
Overrides in_whole_steps(const Scene& scene, double liquid_step) {
  constexpr double rounding = 1e-3, none = 1e-9;  // that the checks of a scene allow
  Overrides times;
  const auto adapt = [&](const std::string& key, double time, double allowed) {
    const double whole = std::max(1.0, std::round(time / liquid_step)) * liquid_step;
    if (time > 0.0 && std::abs(whole - time) > allowed * time) times.push_back(fmt::format("{}={} s", key, whole));
  };
  const Recording& recording = scene.recording;
  if (recording.bed_interval != Recording{}.bed_interval)
    adapt("recording.bed_interval", recording.bed_interval, rounding);
  if (recording.drop_interval != Recording{}.drop_interval)
    adapt("recording.drop_interval", recording.drop_interval, rounding);
  adapt("recording.snapshot_interval", recording.snapshot_interval, rounding);
  adapt("coupling.void_fraction_interval", scene.coupling.void_fraction_interval, none);
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    adapt(fmt::format("stage[{}].duration", i), scene.stages[i].duration, rounding);
    adapt(fmt::format("stage[{}].relaxation", i), scene.stages[i].relaxation, rounding);
  }
  return times;
}

bool holds(const Rule& rule, const std::vector<Number>& numbers, const std::vector<std::string>& asked) {
  for (const auto& condition : rule.when) {
    const auto number = std::ranges::find(numbers, condition.number, &Number::name);
    if (number == numbers.end())
      throw std::runtime_error(fmt::format("rules.toml: no number is called \"{}\"", condition.number));
    if (condition.above ? !(number->value > condition.value) : !(number->value < condition.value)) return false;
  }
  const auto in = [](const std::vector<std::string>& list, const std::string& item) {
    return std::ranges::find(list, item) != list.end();
  };
  if (!rule.asked.empty() && std::ranges::none_of(asked, [&](const auto& q) { return in(rule.asked, q); }))
    return false;
  return rule.only.empty() || std::ranges::all_of(asked, [&](const auto& q) { return in(rule.only, q); });
}

/// What rules say of any scene as overrides of this one: "stage[drop].repetitions=5" for every drop by its number,
/// "cells_in_bed_diameters=1" as so many cubes across that are about as wide as a sphere of the bed, and
/// "cells_in_diameters=1.25" the same, but wide enough for the largest sphere. Others as they are.
Overrides for_scene(const Scene& scene, const std::vector<std::string>& overrides) {
  Overrides list;
  const double diameter = leading_species(scene).diameter;
  double largest = 0.0;
  for (const Species& species : scene.species) largest = std::max(largest, species.diameter);
  const auto cubes = [&](double width_wished) {
    const double width =
        scene.geometry.shape == Shape::cylinder ? scene.geometry.diameter : scene.geometry.width.front();
    // A cube of less than 1/√3 of the largest diameter could lie wholly inside that sphere.
    const double narrowest = std::max(width_wished, largest / std::numbers::sqrt3);
    const auto across = std::max(1L, std::lround(std::floor(width / narrowest * (1.0 + 1e-9))));
    list.push_back(fmt::format("fluid.cells_across={}", across));
    list.push_back(fmt::format("fluid.cell_height={}", width / static_cast<double>(across)));
  };
  for (const std::string& one : overrides) {
    const std::string key = one.substr(0, one.find('=')), value = one.substr(key.size() + 1);
    const bool drop = key.starts_with("stage[drop]"), fluidise = key.starts_with("stage[fluidise]");
    if (key == "lubrication_in_diameters") {
      list.push_back(fmt::format("coupling.lubrication_range={}", std::stod(value) * diameter));
    } else if (key == "cells_in_bed_diameters") {
      cubes(std::stod(value) * diameter);
    } else if (key == "cells_in_diameters") {
      cubes(std::max(std::stod(value) * diameter, largest));
    } else if (drop || fluidise) {
      for (std::size_t i = 0; i < scene.stages.size(); ++i)
        if (scene.stages[i].kind == (drop ? StageKind::drop : StageKind::fluidise))
          list.push_back(fmt::format("stage[{}]{}", i, one.substr(one.find(']') + 1)));
    } else {
      list.push_back(one);
    }
  }
  return list;
}

/// Of each subject the first rule whose conditions are true and that is not refused. A tier without simulation leaves
/// nothing else to choose.
std::vector<const Rule*> first_that_hold(const Rules& rules, const std::vector<Number>& numbers,
                                         const std::vector<std::string>& asked, const std::set<const Rule*>& refused) {
  std::vector<const Rule*> chosen;
  std::set<std::string> decided;
  for (const Rule& rule : rules.list) {
    if (decided.contains(rule.subject) || refused.contains(&rule) || !holds(rule, numbers, asked)) continue;
    decided.insert(rule.subject);
    chosen.push_back(&rule);
    if (rule.without_simulation()) return {&rule};
  }
  return chosen;
}

double effect_on(const Rule& rule, const std::string& quantity) {
  const auto found = rule.effect.find(quantity);
  return found == rule.effect.end() ? 0.0 : found->second;
}

/// Whether two rules choose the same, perhaps of different effect under their own conditions.
bool same_choice(const Rule& a, const Rule& b) {
  return a.set == b.set && a.steps_per_contact == b.steps_per_contact &&
         a.liquid_steps_per_relaxation == b.liquid_steps_per_relaxation &&
         a.longest_liquid_step == b.longest_liquid_step;
}

/// The choice to give up when a quantity leaves its band: of those that another choice of a later rule of the same
/// subject betters, the one with the largest effect. Null when all are inside, or where even the best of all later
/// rules would not do.
const Rule* too_coarse(const Rules& rules, const std::vector<const Rule*>& chosen, const std::vector<Number>& numbers,
                       const std::vector<std::string>& asked) {
  for (const std::string& quantity : asked) {
    double squares = 0.0, least_squares = 0.0;
    const Rule* worst = nullptr;
    for (const Rule* rule : chosen) {
      const double own = effect_on(*rule, quantity);
      double least = own;
      for (const Rule& later : rules.list)
        if (&later > rule && later.subject == rule->subject && !same_choice(later, *rule) &&
            holds(later, numbers, asked))
          least = std::min(least, effect_on(later, quantity));
      squares += own * own;
      least_squares += least * least;
      if (least < own && (worst == nullptr || own > effect_on(*worst, quantity))) worst = rule;
    }
    const double band = rules.bands.at(quantity);
    if (std::sqrt(squares) > band && std::sqrt(least_squares) <= band) return worst;
  }
  return nullptr;
}

double core_seconds(const Scene& scene) { return estimate_run(scene).core_seconds; }

/// Estimates of answers without simulation: a root, a short integration [s].
constexpr double formula_core_seconds = 1e-3;

}  // namespace

std::vector<Number> numbers_of(const Scene& scene) {
  const Species& sphere = leading_species(scene);
  if (sphere.density <= scene.liquid.density)
    throw std::runtime_error(
        fmt::format("species \"{}\" of {:g} kg/m3 does not sink in a liquid of {:g} kg/m3: there is no fall and no "
                    "fluidised bed to "
                    "plan for",
                    sphere.name, sphere.density, scene.liquid.density));
  const auto liquid = liquid_of(scene);
  const double terminal = terminal_velocity(scene, sphere),
               minimum = minimum_fluidisation_velocity(scene, conventional_packing);
  const double reynolds = reynolds_number(liquid, sphere.diameter, terminal);
  const double column = scene.geometry.shape == Shape::cylinder
                            ? scene.geometry.diameter
                            : std::min(scene.geometry.width[0], scene.geometry.width[1]);
  double largest = 0.0;
  for (const Species& species : scene.species) largest = std::max(largest, species.diameter);
  const double mass = sphere.density * dem::Particles::volume_of(0.5 * sphere.diameter);
  const double cell = scene.fluid.tier == FluidTier::quiescent ? 2.0 * largest : scene.fluid.cell_height;
  // Time in which the drag alone would take up the terminal velocity.
  const double relaxation = terminal / (gravitational_acceleration * (1.0 - scene.liquid.density / sphere.density));
  const bool walls = scene.geometry.shape == Shape::cylinder || scene.fluid.wall != LateralBoundary::periodic;
  double drops = 0.0;
  for (const Stage& stage : scene.stages)
    if (stage.kind == StageKind::drop) drops += stage.repetitions;
  const double stiffness = scene.contact.law == "linear" ? scene.contact.stiffness : 0.0;
  return {{"archimedes_number", archimedes_number(sphere_of(sphere), liquid), "Ar of the bed's spheres"},
          {"terminal_reynolds_number", reynolds, "Re at the terminal velocity"},
          {"stokes_number", sphere.density * sphere.diameter * terminal / (9.0 * liquid.viscosity),
           "St of an impact at the terminal velocity"},
          {"density_ratio", sphere.density / scene.liquid.density, "sphere over liquid"},
          {"bed_spheres", bed_spheres(scene), "spheres of the bed"},
          {"column_over_diameter", column / sphere.diameter, "width of the column in diameters"},
          {"has_walls", walls ? 1.0 : 0.0, "1 with side walls, 0 for periodic sides"},
          {"cell_over_diameter", cell / sphere.diameter, "cell in diameters of the bed's spheres"},
          {"largest_over_bed", largest / sphere.diameter, "largest sphere in diameters of the bed's"},
          {"cell_over_largest", cell / largest, "cell in diameters of the largest sphere"},
          {"velocity_over_minimum", scene.liquid.superficial_velocity / minimum,
           "U_L over U_mf of a packing of voidage 0.4"},
          {"velocity_over_terminal", scene.liquid.superficial_velocity / terminal, "U_L over u_t: 1 is wash-out"},
          {"drops", drops, "spheres dropped, one after the other"},
          {"relaxation_time", relaxation, "of the drag at the terminal velocity [s]"},
          {"liquid_steps_per_relaxation", relaxation / scene.fluid.time_step, "in the scene as it stands"},
          {"steps_per_contact", std::numbers::pi * contact_time_step_bound(scene) / scene.contact.time_step,
           "in the scene as it stands"},
          {"stiffness", stiffness, "of the normal spring [N/m]"},
          {"overlap_at_soft", scene.liquid.superficial_velocity * std::sqrt(0.5 * mass / 1e3) / sphere.diameter,
           "of an impact at U_L with 1e3 N/m, in diameters"}};
}

std::vector<std::string> Plan::not_covered() const {
  std::vector<std::string> names, sentences;
  for (const Decision& decision : decisions)
    for (const Beyond& one : decision.beyond)
      if (std::ranges::find(names, one.number) == names.end()) names.push_back(one.number);
  for (const std::string& number : names) {
    std::vector<std::string> subjects;
    Range covered{std::numeric_limits<double>::infinity(), 0.0};
    double value = 0.0;
    for (const Decision& decision : decisions)
      for (const Beyond& one : decision.beyond) {
        if (one.number != number) continue;
        subjects.push_back(decision.subject);
        value = one.value;
        covered = {std::min(covered.lowest, one.covered.lowest), std::max(covered.highest, one.covered.highest)};
      }
    const std::string studies = covered.highest > 1.001 * covered.lowest
                                    ? fmt::format("{:.3g} to {:.3g}", covered.lowest, covered.highest)
                                    : fmt::format("{:.3g}", covered.lowest);
    sentences.push_back(fmt::format("{} {:.3g} (studies: {}): {}", number, value, studies, fmt::join(subjects, ", ")));
  }
  return sentences;
}

const std::map<std::string, std::string>& measured_names() {
  static const std::map<std::string, std::string> names{{"terminal_velocity", "terminal_velocity"},
                                                        {"voidage", "voidage_centre_of_mass"},
                                                        {"pressure_drop", "pressure_drop"},
                                                        {"classification_velocity", "classification_velocity"},
                                                        {"force_ratio", "collision_force_ratio"},
                                                        {"fluctuating_energy", "fluctuating_energy"},
                                                        {"collision_frequency", "collision_frequency"},
                                                        {"peak_force", "peak_force_ratio"},
                                                        {"contacts", "contacts_per_particle"}};
  return names;
}

std::vector<std::string> usual_questions(const Scene& scene) {
  if (!(bed_spheres(scene) > 0.0)) return {"terminal_velocity"};
  for (const Stage& stage : scene.stages)
    if (stage.kind == StageKind::drop) return {"classification_velocity", "voidage"};
  return {"voidage", "pressure_drop"};
}

Scene changed(const Scene& scene, const Overrides& overrides) {
  return overrides.empty() ? scene : parse_scene(canonical_toml(scene), "plan", overrides);
}

Plan make_plan(const Scene& scene, const std::vector<std::string>& asked, const Rules& all_rules, Forces forces) {
  Rules rules = all_rules;
  if (forces == Forces::of_the_scene)
    std::erase_if(rules.list, [&](const Rule& rule) {
      return std::ranges::find(rules.forces, rule.subject) != rules.forces.end();
    });
  std::vector<std::string> known;
  for (const auto& [quantity, band] : rules.bands) known.push_back(quantity);
  for (const std::string& quantity : asked)
    if (!rules.bands.contains(quantity))
      throw std::invalid_argument(
          fmt::format("there is no quantity \"{}\"; known: {}", quantity, fmt::join(known, ", ")));
  if (scene.geometry.inclination > 0.0)
    throw std::invalid_argument(fmt::format(
        "geometry.inclination = {:g} degree: the studies behind a plan are of upright columns, so that it cannot tell "
        "what an inclined one needs; run it as it is, and with a smaller step or cell to compare",
        scene.geometry.inclination));
  Plan plan;
  plan.asked = asked;
  plan.numbers = numbers_of(scene);
  plan.given_core_seconds = core_seconds(scene);
  std::map<std::string, double> by_name;
  for (const Number& number : plan.numbers) by_name[number.name] = number.value;
  std::set<const Rule*> refused;
  auto chosen = first_that_hold(rules, plan.numbers, asked, refused);
  for (const Rule* rule = too_coarse(rules, chosen, plan.numbers, asked); rule != nullptr;
       rule = too_coarse(rules, chosen, plan.numbers, asked)) {
    refused.insert(rule);
    chosen = first_that_hold(rules, plan.numbers, asked, refused);
  }
  struct Pending {
    const Rule* rule;
    std::size_t decision;
  };
  std::vector<Pending> pending;
  for (const Rule* rule : chosen) {
    plan.by_formula = plan.by_formula || rule->without_simulation();
    Decision decision{.subject = rule->subject,
                      .choice = rule->choice,
                      .why = rule->why,
                      .source = rule->source,
                      .evidence = rule->evidence,
                      .overrides = for_scene(scene, rule->set),
                      .part = rule->part,
                      .beyond = beyond(*rule, rules, by_name),
                      .richer = rule->richer};
    double steps = 0.0;
    for (const Beyond& one : decision.beyond) steps = std::max(steps, one.steps);
    for (const std::string& quantity : asked)
      if (const auto found = rule->effect.find(quantity); found != rule->effect.end()) {
        decision.studied[quantity] = found->second;
        decision.effect[quantity] = effect_beyond(*rule, quantity, steps);
        plan.effect[quantity] = std::hypot(plan.effect[quantity], decision.effect[quantity]);
      }
    plan.decisions.push_back(decision);
    pending.push_back({rule, plan.decisions.size() - 1});
  }
  for (const std::string& quantity : asked) plan.band[quantity] = rules.bands.at(quantity);
  if (plan.by_formula) {
    plan.core_seconds = formula_core_seconds;
    Decision& tier = plan.decisions.front();
    tier.richer_overrides = for_scene(scene, pending.front().rule->richer_set);
    tier.richer_core_seconds = plan.given_core_seconds;
    return plan;
  }
  // Values first that steps depend on.
  Overrides values;
  for (const Decision& decision : plan.decisions)
    values.insert(values.end(), decision.overrides.begin(), decision.overrides.end());
  values.emplace_back("contact.allow_large_time_step=true");
  Scene planned = changed(scene, values);
  // The step of the spheres divides that of the liquid.
  double liquid_step = planned.fluid.time_step, solid_step = planned.contact.time_step;
  for (const auto& [rule, decision] : pending) {
    if (rule->liquid_steps_per_relaxation > 0.0) {
      const auto relaxation = std::ranges::find(plan.numbers, "relaxation_time", &Number::name)->value;
      liquid_step = std::min(rule->longest_liquid_step, rounded_down(relaxation / rule->liquid_steps_per_relaxation));
      plan.decisions[decision].choice += fmt::format(": {:g} s", liquid_step);
    }
  }
  for (const auto& [rule, decision] : pending)
    if (rule->steps_per_contact > 0.0) {
      const double wanted = std::numbers::pi * contact_time_step_bound(planned) / rule->steps_per_contact;
      solid_step = liquid_step / std::ceil(liquid_step / wanted);
      plan.decisions[decision].choice += fmt::format(": {:.3g} s", solid_step);
      plan.decisions[decision].overrides = {fmt::format("contact.time_step={}", solid_step)};
    }
  for (const auto& [rule, decision] : pending)
    if (rule->liquid_steps_per_relaxation > 0.0)
      plan.decisions[decision].overrides = {fmt::format("fluid.time_step={}", liquid_step)};
  values.push_back(fmt::format("contact.time_step={}", solid_step));
  const double step = planned.fluid.tier == FluidTier::quiescent ? solid_step : liquid_step;
  values.push_back(fmt::format("fluid.time_step={}", step));
  const Overrides times = in_whole_steps(planned, step);
  values.insert(values.end(), times.begin(), times.end());
  plan.overrides = values;
  planned = changed(scene, values);
  plan.core_seconds = core_seconds(planned);
  for (const auto& [rule, number] : pending) {
    Decision& decision = plan.decisions[number];
    if (decision.richer.empty()) continue;
    decision.richer_overrides = for_scene(scene, rule->richer_set);
    if (rule->richer_set.empty()) {
      // "the scene's own": whatever the rule replaced.
      if (rule->subject == "contact stiffness")
        decision.richer_overrides = {
            fmt::format("contact.stiffness={}", scene.contact.stiffness),
            fmt::format("contact.time_step={}",
                        liquid_step / std::ceil(liquid_step / solid_step * std::sqrt(scene.contact.stiffness / 1e3)))};
      if (rule->subject == "rolling resistance")
        decision.richer_overrides = {fmt::format("contact.rolling_friction={}", scene.contact.rolling_friction)};
    }
    decision.richer_core_seconds = core_seconds(changed(planned, decision.richer_overrides));
  }
  if (std::ranges::find(asked, "pressure_drop") != asked.end()) add_momentum_at_inlet(scene, forces, plan);
  return plan;
}

std::map<std::string, FormulaAnswer> answer_by_formula(const Scene& scene, const Plan& plan) {
  std::map<std::string, FormulaAnswer> answers;
  for (const std::string& quantity : plan.asked) {
    if (quantity == "terminal_velocity") {
      const Species& sphere = leading_species(scene);
      OneParticleFall fall;
      fall.diameter = sphere.diameter;
      fall.density = sphere.density;
      fall.liquid_density = fall.surrounding_density = scene.liquid.density;
      fall.viscosity = scene.liquid.viscosity;
      fall.drag_law = scene.coupling.drag_law;
      // Thirty relaxation times, after which nothing changes any more.
      const double relaxation = std::ranges::find(plan.numbers, "relaxation_time", &Number::name)->value;
      const double unbounded = -integrate_fall(fall, {0.0, 30.0 * relaxation}).back().velocity;
      answers[quantity] = beside_walls(scene, sphere, unbounded);
    } else if (quantity == "minimum_fluidisation_velocity") {
      const SettledBed bed = settle(scene);
      const auto at = [&](double voidage) { return minimum_fluidisation_velocity(scene, voidage); };
      const double value = at(bed.voidage);
      const double spread = 0.5 * (at(bed.voidage + bed.half_width) - at(bed.voidage - bed.half_width));
      answers[quantity] = {value, std::abs(spread / value),
                           fmt::format("at the voidage {:.4f} ± {:.2g} to which {} beds of {:g} of its spheres settled",
                                       bed.voidage, bed.half_width, bed.beds, bed.spheres)};
    } else if (quantity == "pressure_drop") {
      double weight = 0.0;
      for (const Species& species : scene.species)
        weight += static_cast<double>(species.count) * dem::Particles::volume_of(0.5 * species.diameter) *
                  (species.density - scene.liquid.density) * gravitational_acceleration;
      answers[quantity] = {weight / scene.geometry.cross_section()};
    }
  }
  return answers;
}

}  // namespace slfb::plan
