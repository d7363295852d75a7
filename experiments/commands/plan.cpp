#include "experiments/numerics/plan/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/accuracy.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/law_evidence.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/league/league_report.hpp"
#include "experiments/numerics/plan/settled_bed.hpp"
#include "experiments/numerics/studies/trial.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/laws/scene_remarks.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using plan::Decision;
using plan::Plan;

constexpr const char* examples = R"(Examples:
  slfb plan experiments/scenes/fluidised_box.toml                  what the usual questions need: voidage, pressure drop
  slfb plan experiments/numerics/studies/scenes/slice.toml --for collision_frequency   one dimension is enough
  slfb plan scene.toml --for minimum_fluidisation_velocity         a root, of the packing that a part of the bed settles to
  slfb plan experiments/scenes/single_sphere.toml                  terminal velocity by an ODE, with the answer
  slfb plan scene.toml --for voidage --keep-forces                 of a work that leaves added mass out: steps and grid only
  slfb plan scene.toml --for voidage --verify                      run the richer choices and compare
  slfb plan --figures                                              the cheapest model for each figure of a work
  slfb plan scene.toml --for voidage --accuracy "2 %"              what this accuracy would take
  slfb run scene.toml --plan auto                                  simulate as planned
  slfb run scene.toml --for voidage --accuracy "2 %"               simulate until it is reached

Quantities: terminal_velocity, minimum_fluidisation_velocity, voidage, pressure_drop, classification_velocity (V_2),
force_ratio (|F_c|/mg), fluctuating_energy (q_p²), collision_frequency, peak_force, contacts.
The rules are experiments/numerics/plan/rules.toml, each with its source and with the study or map behind it. `--verify` repeats
the planned run with each richer choice in turn and says whether the asked quantities stay inside their bands: a rule
whose choice leaves its band is named, and the exit status is 1.)";

struct Options {
  std::string work;
  fs::path scene;
  std::vector<std::string> asked;
  Overrides overrides;
  fs::path out = build_folder();
  int jobs = 2;
  bool verify = false, json = false, figures = false, keep_forces = false, best = false;
  double accuracy = 0.0;  ///< asked relative error [-]; 0: the bands of the rules
};

std::string effect_text(const std::map<std::string, double>& effect) {
  std::vector<std::string> parts;
  for (const auto& [quantity, error] : effect) parts.push_back(fmt::format("{} {:.2g} %", quantity, 100.0 * error));
  return parts.empty() ? "none known" : fmt::format("{}", fmt::join(parts, ", "));
}

/// One ablation: the planned run beside the one with a richer choice.
struct Verification {
  std::string subject, choice, richer, quantity;
  double planned, other, deviation, uncertainty, band;
  [[nodiscard]] bool inside() const { return std::abs(deviation) <= band + uncertainty; }
};

using Answers = std::map<std::string, std::pair<double, double>>;  ///< value and half width by quantity

Answers answers_of(const Scene& scene, const fs::path& out, const std::vector<std::string>& asked) {
  const RunResult result = load_own_result(out, scene_hash(scene));
  const RunSpec spec{"scene", scene.liquid.superficial_velocity, "", "", {}};
  const Measurements found = measure_runs({{spec, scene, result}});
  Answers answers;
  for (const std::string& quantity : asked) {
    const auto name = plan::measured_names().find(quantity);
    if (name == plan::measured_names().end()) continue;
    const auto entry = found.find(measure_key(name->second, spec.system, spec.superficial_velocity));
    if (entry != found.end())
      answers[quantity] = {entry->second.value,
                           std::isfinite(entry->second.half_width) ? entry->second.half_width : 0.0};
  }
  return answers;
}

/// Terminal velocity of the particle engine in still liquid: the richer choice beside the ODE.
std::vector<Verification> verify_formula(const Scene& scene, const Plan& made) {
  std::vector<Verification> checks;
  const auto answers = plan::answer_by_formula(scene, made);
  if (const auto found = answers.find("terminal_velocity"); found != answers.end()) {
    const Species& sphere = scene.species.front();
    const studies::Trial trial{
        "fall",
        {fmt::format("species[0].diameter={}", sphere.diameter), fmt::format("species[0].density={}", sphere.density),
         fmt::format("liquid.density={}", scene.liquid.density),
         fmt::format("liquid.viscosity={}", scene.liquid.viscosity), "coupling.drag_law=" + scene.coupling.drag_law,
         "contact.stiffness=1", "contact.time_step=1e-3", "fluid.time_step=1e-3", "contact.allow_large_time_step=true"},
        0};
    const double other = studies::solve(trial).values.at("terminal_velocity").value;
    checks.push_back({"tier", made.decisions.front().choice, "particle engine in still liquid", "terminal_velocity",
                      found->second.value, other, found->second.value / other - 1.0, 0.0,
                      made.band.at("terminal_velocity")});
  }
  return checks;
}

std::optional<std::vector<Verification>> verify(const Scene& scene, const Plan& made, const Options& options) {
  if (made.by_formula) return verify_formula(scene, made);
  const Scene planned = plan::changed(scene, made.overrides);
  std::vector<NamedScene> scenes{{"planned", planned}};
  std::vector<const Decision*> ablated;
  for (const Decision& decision : made.decisions) {
    if (decision.richer_overrides.empty()) continue;
    scenes.push_back({decision.subject + ": " + decision.richer, plan::changed(planned, decision.richer_overrides)});
    ablated.push_back(&decision);
  }
  // And each step halved.
  static const Decision halved{.subject = "solid step", .choice = "as planned", .richer = "halved"};
  scenes.push_back({"solid step: halved",
                    plan::changed(planned, {fmt::format("contact.time_step={}", 0.5 * planned.contact.time_step)})});
  ablated.push_back(&halved);
  static const Decision liquid_halved{.subject = "liquid step", .choice = "as planned", .richer = "halved"};
  if (planned.fluid.tier != FluidTier::quiescent) {
    const double liquid = 0.5 * planned.fluid.time_step;
    scenes.push_back(
        {"liquid step: halved",
         plan::changed(planned, {fmt::format("fluid.time_step={}", liquid),
                                 fmt::format("contact.time_step={}",
                                             liquid / std::ceil(liquid / planned.contact.time_step - 1e-9))})});
    ablated.push_back(&liquid_halved);
  }
  if (run_scenes(scenes, {.out = options.out, .jobs = options.jobs}).unfinished() > 0) return std::nullopt;
  const Answers ours = answers_of(planned, options.out, made.asked);
  std::vector<Verification> checks;
  for (std::size_t i = 0; i < ablated.size(); ++i) {
    const Answers other = answers_of(scenes[i + 1].scene, options.out, made.asked);
    for (const auto& [quantity, value] : ours)
      if (const auto found = other.find(quantity); found != other.end())
        checks.push_back({ablated[i]->subject, ablated[i]->choice, ablated[i]->richer, quantity, value.first,
                          found->second.first, value.first / found->second.first - 1.0,
                          std::hypot(value.second, found->second.second) / std::abs(found->second.first),
                          made.band.at(quantity)});
  }
  return checks;
}

/// The packing of a bed next to minimum fluidisation, which a voidage of 0.4 for all would not tell apart.
struct BedNearMinimum {
  plan::SettledBed settled;
  double minimum;  ///< velocity that lifts it [m/s]
};
std::optional<BedNearMinimum> bed_near_minimum(const Scene& scene, const Plan& made) {
  constexpr double near = 2.0;  // packings of up to 0.5 are lifted by twice the velocity of one of 0.4
  const auto ratio = std::ranges::find(made.numbers, "velocity_over_minimum", &plan::Number::name);
  if (made.by_formula || ratio == made.numbers.end() || !(ratio->value > 0.0) || ratio->value > near ||
      std::ranges::none_of(scene.species, [](const Species& species) { return species.count > 0; }))
    return std::nullopt;
  const plan::SettledBed settled = plan::settle(scene);
  return BedNearMinimum{settled, plan::minimum_fluidisation_velocity(scene, settled.voidage)};
}

ordered_json json_of(const Scene& scene, const Plan& made) {
  ordered_json json{{"asked", made.asked},
                    {"numbers", ordered_json::object()},
                    {"decisions", ordered_json::array()},
                    {"overrides", made.overrides},
                    {"core_seconds", made.core_seconds},
                    {"core_seconds_as_given", made.given_core_seconds},
                    {"effect", made.effect},
                    {"band", made.band},
                    {"not_covered", made.not_covered()}};
  for (const auto& number : made.numbers) json["numbers"][number.name] = number.value;
  for (const Decision& d : made.decisions)
    json["decisions"].push_back(
        {{"subject", d.subject},
         {"choice", d.choice},
         {"why", d.why},
         {"source", d.source},
         {"evidence", d.evidence},
         {"part", plan::to_string(d.part)},
         {"effect", d.effect},
         {"effect_in_studies", d.studied},
         {"richer", d.richer},
         {"richer_core_seconds", d.richer.empty() ? ordered_json(nullptr) : ordered_json(d.richer_core_seconds)}});
  if (made.by_formula) {
    json["answers"] = ordered_json::object();
    for (const auto& [quantity, answer] : plan::answer_by_formula(scene, made)) {
      json["answers"][quantity] = answer.value;
      if (!answer.remark.empty())
        json["answers_rest_on"][quantity] = {{"remark", answer.remark}, {"error", answer.error}};
    }
  }
  if (const auto bed = bed_near_minimum(scene, made))
    json["settled_bed"] = {{"voidage", bed->settled.voidage},
                           {"half_width", bed->settled.half_width},
                           {"minimum_fluidisation_velocity", bed->minimum}};
  if (const LawEvidence laws(scene); const auto& found = laws.found) {
    json["laws"] = {
        {"formula", league::evidence_json({found->formula})[0]},
        {"drag_law", league::evidence_json({found->drag_law})[0]},
        {"of_the_scene", found->of_the_scene ? league::evidence_json({*found->of_the_scene})[0] : ordered_json()}};
  }
  return json;
}

/// Which law measured beds like that of the scene speak for.
void print_recommendation(const Scene& scene) {
  const LawEvidence laws(scene);
  const auto& found = laws.found;
  if (!found) return;
  fmt::print("\nlaw for the bed         in the {} measured beds that are near ({}):\n", found->formula.beds.size(),
             fmt::join(found->formula.beds, ", "));
  fmt::print("    without a run       {}\n    to simulate         {}\n", evidence_text(found->formula),
             evidence_text(found->drag_law));
  fmt::print("    the scene's         {}\n", found->of_the_scene
                                                 ? evidence_text(*found->of_the_scene)
                                                 : scene.coupling.drag_law + ": no answer for all of them");
  fmt::print("    evidence            slfb league SCENE; prediction: slfb predict SCENE\n");
}

/// A packing has to settle before a velocity that lifts it can be told.
std::string formula_cost(const Plan& made) {
  return std::ranges::find(made.asked, "minimum_fluidisation_velocity") == made.asked.end() ? "milliseconds"
                                                                                            : "seconds";
}

void print_plan(const Options& options, const Scene& scene, const Plan& made) {
  fmt::print("{}: asked for {}\n\n", options.scene.string(), fmt::join(made.asked, ", "));
  for (const auto& number : made.numbers)
    fmt::print("  {:<28}{:>10.4g}  {}\n", number.name, number.value, number.meaning);
  fmt::print("\n");
  for (const Decision& d : made.decisions) {
    fmt::print("{:<20} {}\n", d.subject, d.choice);
    fmt::print("    why       {}\n    source    {}; evidence: {}\n    effect    {}\n", d.why, d.source, d.evidence,
               effect_text(d.effect));
    if (!d.richer.empty())
      fmt::print("    richer    {}: {} of CPU instead of {}\n", d.richer, format_duration(d.richer_core_seconds),
                 made.by_formula ? formula_cost(made) : format_duration(made.core_seconds));
  }
  if (options.keep_forces) fmt::print("{:<20} as the scene has them\n", "forces beyond drag");
  if (const auto bed = bed_near_minimum(scene, made)) {
    const double ratio = scene.liquid.superficial_velocity / bed->minimum;
    fmt::print(
        "\n{:<20} settles to a voidage of {:.4f} ± {:.2g}: U_mf {:.4g} m/s by the drag law, and U_L is {:.3g} of "
        "it{}\n",
        "packing", bed->settled.voidage, bed->settled.half_width, bed->minimum, ratio,
        ratio < 1.2 ? "; WARNING: such a bed may stand still, or only a part of it move" : "");
  }
  if (const auto sentences = made.not_covered(); !sentences.empty()) {
    fmt::print(
        "\nWARNING: no study behind these choices had a scene like this one; their errors are taken larger, and "
        "--verify measures them\n");
    for (const std::string& sentence : sentences) fmt::print("    {}\n", sentence);
  }
  fmt::print("\nestimated error (band)  ");
  std::vector<std::string> parts;
  for (const std::string& quantity : made.asked)
    parts.push_back(fmt::format("{} {:.2g} % ({:.2g} %{})", quantity,
                                made.effect.contains(quantity) ? 100.0 * made.effect.at(quantity) : 0.0,
                                100.0 * made.band.at(quantity),
                                made.effect.contains(quantity) && made.effect.at(quantity) > made.band.at(quantity)
                                    ? ": NOT MET, take a richer choice"
                                    : ""));
  fmt::print("{}\nestimated cost          {} of CPU; the scene as it stands: {}\n", fmt::join(parts, ", "),
             made.by_formula ? formula_cost(made) : format_duration(made.core_seconds),
             format_duration(made.given_core_seconds));
  if (made.by_formula) {
    for (const auto& [quantity, answer] : plan::answer_by_formula(scene, made))
      fmt::print("answer                  {} = {:.6g}{}\n{}", quantity, answer.value,
                 answer.error > 0.0 ? fmt::format(" ± {:.2g} %", 100.0 * answer.error) : "",
                 answer.remark.empty() ? "" : fmt::format("{:<24}{}\n", "", answer.remark));
  } else {
    fmt::print("to run it               slfb run {} --plan auto --for {}{}\n", options.scene.string(),
               fmt::join(made.asked, ","), options.keep_forces ? " --keep-forces" : "");
  }
}

int run(const Options& options) {
  if (options.figures) {
    const Work& work = find_work(works(), options.work);
    if (!work.figure_plans) throw std::invalid_argument(work.id + " has no plans of its figures");
    fmt::print("{}", plan::figure_plans_text(work.figure_plans()));
    return 0;
  }
  if (options.scene.empty()) throw std::invalid_argument("a scene is needed, or --figures");
  const Scene scene = load_scene(options.scene, options.overrides);
  if (options.accuracy > 0.0)
    return plan_for_accuracy({.file = options.scene,
                              .scene = scene,
                              .asked = options.asked,
                              .error = options.accuracy,
                              .keep_forces = options.keep_forces,
                              .best = options.best,
                              .out = options.out,
                              .json = options.json});
  const auto rules = plan::load_rules();
  const Plan made = plan::make_plan(scene, options.asked.empty() ? plan::usual_questions(scene) : options.asked, rules,
                                    options.keep_forces ? plan::Forces::of_the_scene : plan::Forces::planned);
  for (const std::string& remark : remarks_on(scene)) spdlog::warn("{}", remark);
  std::optional<std::vector<Verification>> checks;
  if (options.verify) {
    checks = verify(scene, made, options);
    if (!checks) return 130;
  }
  const bool holds = !checks || std::ranges::all_of(*checks, &Verification::inside);
  if (options.json) {
    ordered_json json = json_of(scene, made);
    if (checks) {
      json["verification"] = ordered_json::array();
      for (const Verification& v : *checks)
        json["verification"].push_back({{"subject", v.subject},
                                        {"richer", v.richer},
                                        {"quantity", v.quantity},
                                        {"planned", v.planned},
                                        {"with_richer", v.other},
                                        {"deviation", v.deviation},
                                        {"uncertainty", v.uncertainty},
                                        {"band", v.band},
                                        {"inside", v.inside()}});
    }
    fmt::print("{}\n", json.dump(2));
    return holds ? 0 : 1;
  }
  print_plan(options, scene, made);
  print_recommendation(scene);
  if (checks) {
    fmt::print("\n{:<20}{:<36}{:<26}{:>12}{:>12}{:>18}{:>8}\n", "verified", "richer choice", "quantity", "planned",
               "richer", "deviation", "band");
    for (const Verification& v : *checks)
      fmt::print("{:<20}{:<36}{:<26}{:>12.4g}{:>12.4g}{:>18}{:>8}  {}\n", v.subject, v.richer, v.quantity, v.planned,
                 v.other, fmt::format("{:+.2g} ± {:.2g} %", 100.0 * v.deviation, 100.0 * v.uncertainty),
                 fmt::format("{:.2g} %", 100.0 * v.band), v.inside() ? "inside" : "WRONG: the rule does not hold here");
  }
  return holds ? 0 : 1;
}

}  // namespace

void add_plan_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plan", "Which models and steps a scene needs for what is asked of it");
  command->add_option("SCENE", options->scene, "scene file (TOML)")->check(CLI::ExistingFile);
  add_work_option(*command, works(), options->work);
  command->add_option("--for", options->asked, "quantities that are asked for")->delimiter(',')->type_name("Q,...");
  command->add_option("--set", options->overrides, "replace a value of the scene: KEY=VALUE, may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--keep-forces", options->keep_forces,
                    "leave added mass, lift, history, lubrication and correction as the scene has them");
  CLI::Option* accuracy = command->add_option_function<std::string>(
      "--accuracy", [options](const std::string& text) { options->accuracy = accuracy_of(text); },
      "Largest error that each asked quantity may have, \"5 %\": what it takes (see `slfb run --help`)");
  accuracy->type_name("ERROR");
  command->add_flag("--best", options->best, "with --accuracy: the best that can be had where it is out of reach")
      ->needs(accuracy);
  command->add_flag("--verify", options->verify, "run each richer choice and compare with the bands");
  command->add_flag("--figures", options->figures, "instead of a scene: the cheapest model for each figure of a work");
  command->add_flag("--json", options->json, "write the plan as JSON");
  command->add_option("--out", options->out, "folder of runs/, for --verify")->type_name("DIR")->capture_default_str();
  command->add_option("--jobs", options->jobs, "simulations side by side, for --verify")
      ->check(above_zero())
      ->capture_default_str();
  command->footer(examples);
  command->callback([options] {
    int status = 0;
    try {
      status = run(*options);
    } catch (const std::invalid_argument& error) {  // an unknown quantity
      throw CLI::ValidationError(error.what());
    }
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
