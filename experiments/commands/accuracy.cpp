#include "experiments/commands/accuracy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/commands/law_evidence.hpp"
#include "experiments/numerics/accuracy/sequence.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/laws/scene_remarks.hpp"

namespace slfb {

const char* const accuracy_help =
    R"(An accuracy, "5 %" or 0.05, is the largest relative error that each asked quantity may have against the same scene
(its spheres, liquid, contacts and drag law) solved with every model, grid and step of the suite. How far the drag law
itself is from measured beds stands beside it and is not counted. Three parts make the error: models that are left out,
and grid and steps (from the committed studies; as squares), and statistics (the 95 % interval of several beds; added as
it is). At least three beds with other seeds are run, then as many more as their scatter asks for, at most twice as many
as there were. Look k at them takes intervals that miss in 5 % * 6/(pi^2 k^2) of all cases, so that all looks together
miss in at most 5 %. A bed that still changes is run again over twice the time. Where no study had such a scene, a richer
one is run and the difference counts. Every bed is an ordinary run: after Ctrl-C the same command goes on.
An accuracy out of reach is refused before anything runs; --best takes the best that can be had.
Exit status: 0 when the accuracy is reached, 1 when not, 130 after Ctrl-C.)";

namespace {

using accuracy::Answers;
using accuracy::Expectation;
using accuracy::Goal;
using accuracy::Outcome;
using accuracy::Parts;
using nlohmann::ordered_json;

ordered_json number_or_null(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

std::string percent(double share) {
  return !std::isfinite(share) ? std::string("unknown")
         : share >= 0.1        ? fmt::format("{:.0f} %", 100.0 * share)
                               : fmt::format("{:.2g} %", 100.0 * share);
}

Expectation expectation(const AccuracyOptions& options, const plan::Rules& rules) {
  Goal goal{.asked = options.asked.empty() ? plan::usual_questions(options.scene) : options.asked,
            .error = options.error,
            .forces = options.keep_forces ? plan::Forces::of_the_scene : plan::Forces::planned};
  Expectation expected = accuracy::expect(options.scene, goal, rules);
  if (!options.best || expected.obstacle.empty()) return expected;
  // A fifth of the error is left to statistics.
  constexpr double room = 1.25;
  const std::string obstacle = expected.obstacle;
  goal.error = room * expected.best;
  if (goal.error >= 1.0) throw std::runtime_error(obstacle + "; the best that can be had is no answer either");
  if (!options.json) fmt::print("{}: the best that can be had is {}\n", obstacle, percent(goal.error));
  return accuracy::expect(options.scene, goal, rules);
}

/// The law that no part of the error counts.
std::string law_sentence(const Scene& scene) {
  const LawEvidence laws(scene);
  if (!laws.found) return scene.coupling.drag_law + ": no measured beds are near";
  return fmt::format("{} (in {} measured beds that are near)",
                     laws.found->of_the_scene ? evidence_text(*laws.found->of_the_scene)
                                              : scene.coupling.drag_law + ": no answer for all of them",
                     laws.found->formula.beds.size());
}

std::string choices_text(const Scene& scene) {
  const char* tier = scene.fluid.tier == FluidTier::quiescent         ? "liquid at rest"
                     : scene.fluid.tier == FluidTier::one_dimensional ? "1-D liquid"
                                                                      : "3-D liquid";
  std::string text = tier;
  if (scene.fluid.tier != FluidTier::quiescent)
    text += fmt::format(", cells of {:.3g} mm, {:.3g} ms", 1e3 * scene.fluid.cell_height, 1e3 * scene.fluid.time_step);
  text += fmt::format("; spheres {:.3g} ms", 1e3 * scene.contact.time_step);
  if (scene.contact.law == "linear") text += fmt::format(", {:.3g} N/m", scene.contact.stiffness);
  for (const Stage& stage : scene.stages) {
    if (stage.kind == StageKind::fluidise) text += fmt::format("; {:g} s fluidised", stage.duration);
    if (stage.kind == StageKind::drop)
      text += fmt::format("; {} drop{}", stage.repetitions, stage.repetitions == 1 ? "" : "s");
  }
  return text;
}

void print_parts(const std::map<std::string, Parts>& parts, double goal) {
  fmt::print("    {:<32}{:>10}{:>16}{:>12}{:>12}{:>9}\n", "error", "models", "grid and steps", "statistics", "together",
             "asked");
  for (const auto& [quantity, of] : parts)
    fmt::print("    {:<32}{:>10}{:>16}{:>12}{:>12}{:>9}{}\n", quantity, percent(of.model), percent(of.discretisation),
               percent(of.statistics), percent(of.total()), percent(goal), of.total() <= goal ? "" : "  NOT REACHED");
}

void print_expectation(const AccuracyOptions& options, const Expectation& expected) {
  fmt::print("{}: {} to {}\n", options.file.string(), fmt::join(expected.goal.asked, ", "),
             percent(expected.goal.error));
  if (!expected.obstacle.empty()) {
    fmt::print("  out of reach   {}\n  best           {}, of models, grid and steps; --best runs it\n",
               expected.obstacle, percent(expected.best));
    return;
  }
  if (expected.by_formula()) {
    fmt::print("  choices        {}: nothing to simulate\n", expected.plan.decisions.front().choice);
  } else {
    fmt::print("  choices        {}\n", choices_text(expected.scene));
    fmt::print("  beds           about {}, with other seeds; {} of CPU for each\n", expected.beds,
               format_duration(estimate_run(expected.scene).core_seconds));
    fmt::print("  cost           about {} of CPU in all\n", format_duration(expected.core_seconds));
  }
  for (const std::string& sentence : expected.plan.not_covered()) fmt::print("  not studied    {}\n", sentence);
  if (expected.check)
    fmt::print("  check          a richer scene ({}; {}), {} beds: {} of CPU of this\n",
               fmt::join(expected.checked, ", "), choices_text(*expected.check), accuracy::fewest_beds,
               format_duration(expected.check_core_seconds));
  fmt::print("  expected\n");
  print_parts(expected.parts, expected.goal.error);
  fmt::print("  not counted    the drag law: {}\n", law_sentence(options.scene));
}

ordered_json json_of(const Parts& parts) {
  return {{"model", number_or_null(parts.model)},
          {"discretisation", number_or_null(parts.discretisation)},
          {"statistics", number_or_null(parts.statistics)},
          {"together", number_or_null(parts.total())}};
}

ordered_json json_of(const AccuracyOptions& options, const Expectation& expected) {
  ordered_json json{{"scene", options.file.string()},
                    {"asked", expected.goal.asked},
                    {"accuracy", expected.goal.error},
                    {"within_reach", expected.obstacle.empty()},
                    {"obstacle", expected.obstacle},
                    {"best", expected.best},
                    {"by_formula", expected.by_formula()},
                    {"overrides", expected.plan.overrides},
                    {"beds", expected.beds},
                    {"core_seconds", expected.core_seconds},
                    {"not_covered", expected.plan.not_covered()},
                    {"checked", expected.checked},
                    {"check_core_seconds", expected.check_core_seconds},
                    {"drag_law", law_sentence(options.scene)}};
  json["error"] = ordered_json::object();
  for (const auto& [quantity, parts] : expected.parts) json["error"][quantity] = json_of(parts);
  return json;
}

/// Answers of several beds by the quantities of the plan.
Answers measure_beds(const AccuracyOptions& options, const MeasuringRules& rules, const std::vector<Scene>& scenes) {
  std::vector<FinishedRun> runs;
  const RunSpec spec{options.file.stem().string(), scenes.front().liquid.superficial_velocity, "", options.file, {}};
  for (const Scene& scene : scenes) runs.push_back({spec, scene, load_own_result(options.out, scene_hash(scene))});
  const Measurements found = measure_runs(runs, rules);
  Answers answers;
  const auto add = [&](const std::string& quantity, const std::string& measured) {
    const auto entry = found.find(measure_key(measured, spec.system, spec.superficial_velocity));
    if (entry == found.end()) return;
    const Measurement& m = entry->second;
    double half_width = m.half_width;
    if (m.interval) half_width = std::max(m.interval->second - m.value, m.value - m.interval->first);
    answers[quantity] = {m.value, half_width, m.samples, m.unit, m.remark};
  };
  for (const auto& [quantity, measured] : plan::measured_names()) add(quantity, measured);
  add("voidage_drift", "voidage_drift");
  return answers;
}

accuracy::World world_of(const AccuracyOptions& options, const MeasuringRules& rules, int& status) {
  accuracy::World world;
  world.simulate = [&](const std::vector<Scene>& scenes) -> std::optional<double> {
    std::vector<NamedScene> named;
    for (const Scene& scene : scenes)
      named.push_back({fmt::format("{} seed {}", options.file.stem().string(), scene.seed), scene});
    const int jobs = std::clamp(options.threads, 1, static_cast<int>(scenes.size()));
    const CampaignOutcome ended =
        run_scenes(named, {.out = options.out, .jobs = jobs, .threads_per_run = std::max(1, options.threads / jobs)});
    status = ended.exit_status();
    if (ended.unfinished() > 0) return std::nullopt;
    double spent = 0.0;
    for (const Scene& scene : scenes) spent += load_own_result(options.out, scene_hash(scene)).cpu_seconds;
    return spent;
  };
  world.measure = [&](const std::vector<Scene>& scenes) { return measure_beds(options, rules, scenes); };
  world.tell = [](const std::string& text) { fmt::print(stderr, "{}\n", text); };
  return world;
}

/// What half the error would cost, as far as this scene is known by now.
std::string half_the_error(const AccuracyOptions& options, const plan::Rules& rules, const Expectation& expected,
                           const Outcome& outcome) {
  accuracy::Scatter scatter;
  for (const auto& [quantity, value] : outcome.scatter)
    (accuracy::of_drops(quantity) ? scatter.drop : scatter.bed)[quantity] = value;
  Goal goal = expected.goal;
  goal.error *= 0.5;
  const Expectation half = accuracy::expect(options.scene, goal, rules, scatter);
  if (!half.obstacle.empty()) return half.obstacle;
  if (half.by_formula()) return "no more than this";
  return fmt::format("about {} of CPU: {} beds, {}", format_duration(half.core_seconds), half.beds,
                     choices_text(half.scene));
}

void print_outcome(const Expectation& expected, const Outcome& outcome, const std::string& half) {
  fmt::print("\nresult (95 % interval, {} look{}, {} beds)\n", outcome.looks, outcome.looks == 1 ? "" : "s",
             outcome.beds.size());
  for (const std::string& quantity : expected.goal.asked) {
    const auto answer = outcome.answers.find(quantity);
    if (answer == outcome.answers.end()) continue;
    const std::string unit = answer->second.unit == "-" ? "" : " " + answer->second.unit;
    fmt::print("    {:<32}{:.5g} ± {:.2g}{}{}\n", quantity, answer->second.value, answer->second.half_width, unit,
               answer->second.remark.empty() ? "" : "  (" + answer->second.remark + ")");
  }
  fmt::print("achieved\n");
  print_parts(outcome.parts, expected.goal.error);
  for (const auto& [quantity, deviation] : outcome.check)
    fmt::print("    {:<32}{:+.2g} ± {:.2g} % against the richer scene\n", "check: " + quantity, 100.0 * deviation.value,
               100.0 * deviation.uncertainty);
  if (!outcome.reason.empty()) fmt::print("not reached        {}\n", outcome.reason);
  fmt::print("as run             {}\n", choices_text(outcome.scene));
  fmt::print("cost               {} of CPU (expected {})\n", format_duration(outcome.core_seconds),
             format_duration(expected.core_seconds));
  fmt::print("half the error     {}\n", half);
}

ordered_json json_of(const AccuracyOptions& options, const Expectation& expected, const Outcome& outcome,
                     const std::string& half) {
  ordered_json json{{"expected", json_of(options, expected)},
                    {"reached", outcome.reached},
                    {"reason", outcome.reason},
                    {"looks", outcome.looks},
                    {"core_seconds", outcome.core_seconds},
                    {"half_the_error", half}};
  ordered_json& answers = json["answers"] = ordered_json::object();
  for (const std::string& quantity : expected.goal.asked) {
    const auto answer = outcome.answers.find(quantity);
    if (answer == outcome.answers.end()) continue;
    answers[quantity] = {{"value", number_or_null(answer->second.value)},
                         {"half_width", number_or_null(answer->second.half_width)},
                         {"unit", answer->second.unit},
                         {"remark", answer->second.remark}};
    if (const auto parts = outcome.parts.find(quantity); parts != outcome.parts.end())
      answers[quantity]["error"] = json_of(parts->second);
    if (const auto check = outcome.check.find(quantity); check != outcome.check.end())
      answers[quantity]["check"] = {{"deviation", check->second.value}, {"uncertainty", check->second.uncertainty}};
  }
  for (const auto& [name, scenes] : {std::pair{"beds", &outcome.beds}, {"check_beds", &outcome.richer}}) {
    ordered_json& list = json[name] = ordered_json::array();
    for (const Scene& scene : *scenes) list.push_back(result_file(options.out, scene_hash(scene)).string());
  }
  return json;
}

int answer_by_formula(const AccuracyOptions& options, const Expectation& expected) {
  if (options.json) {
    ordered_json json{{"expected", json_of(options, expected)}, {"reached", true}, {"core_seconds", 0.0}};
    for (const auto& [quantity, answer] : expected.answers)
      json["answers"][quantity] = {
          {"value", answer.value}, {"remark", answer.remark}, {"error", json_of(expected.parts.at(quantity))}};
    fmt::print("{}\n", json.dump(2));
    return 0;
  }
  for (const auto& [quantity, answer] : expected.answers)
    fmt::print("{} = {:.6g} ± {:.2g} by {}; nothing to simulate\n{}", quantity, answer.value,
               answer.value * expected.parts.at(quantity).total(), expected.plan.decisions.front().choice,
               answer.remark.empty() ? "" : fmt::format("    {}\n", answer.remark));
  return 0;
}

}  // namespace

double accuracy_of(const std::string& text) {
  std::string number = text;
  const bool percent_sign = number.ends_with('%');
  if (percent_sign) number.pop_back();
  while (number.ends_with(' ')) number.pop_back();
  double value = 0.0;
  if (!CLI::detail::lexical_cast(number, value) || !(value > 0.0) || !(value < (percent_sign ? 100.0 : 1.0)))
    throw CLI::ValidationError("--accuracy",
                               fmt::format("\"{}\" is no accuracy between 0 and 100 %, such as \"5 %\" or 0.05", text));
  return percent_sign ? 0.01 * value : value;
}

int plan_for_accuracy(const AccuracyOptions& options) {
  const auto rules = plan::load_rules();
  const Expectation expected = expectation(options, rules);
  if (options.json)
    fmt::print("{}\n", json_of(options, expected).dump(2));
  else
    print_expectation(options, expected);
  return expected.obstacle.empty() ? 0 : 1;
}

int run_for_accuracy(const AccuracyOptions& options, const MeasuringRules& rules) {
  const auto plan_rules = plan::load_rules();
  const Expectation expected = expectation(options, plan_rules);
  if (!options.json) print_expectation(options, expected);
  if (!expected.obstacle.empty()) {
    if (options.json) fmt::print("{}\n", json_of(options, expected).dump(2));
    return 1;
  }
  if (expected.by_formula()) return answer_by_formula(options, expected);
  for (const Scene* scene : {&expected.scene, expected.check ? &*expected.check : nullptr})
    if (scene != nullptr)
      if (const std::string problem = memory_problem(estimate_run(*scene)); !problem.empty())
        throw std::runtime_error(fmt::format("{}: {}", options.file.string(), problem));
  for (const std::string& remark : remarks_on(expected.scene)) spdlog::warn("{}", remark);
  std::fflush(stdout);
  int status = 0;
  const Outcome outcome = accuracy::run_until(expected, world_of(options, rules, status), options.budget);
  if (outcome.unfinished) return status;
  const std::string half = half_the_error(options, plan_rules, expected, outcome);
  if (options.json)
    fmt::print("{}\n", json_of(options, expected, outcome, half).dump(2));
  else
    print_outcome(expected, outcome, half);
  return outcome.reached ? 0 : 1;
}

}  // namespace slfb
