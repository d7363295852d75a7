#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/accuracy.hpp"
#include "experiments/commands/budget.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/run_entries.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/numerics/plan/plan.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/coupling/drag_relaxation.hpp"
#include "solver/dem/packing.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/scene_remarks.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

using nlohmann::json;

constexpr const char* examples = R"(Examples:
  slfb run experiments/scenes/fluidised_box.toml --dry-run   check the scene, show what it costs
  slfb run scene.toml --threads 2                            simulate
  slfb run scene.toml --plan auto                            simulate no more than V_2 and voidage need
  slfb run scene.toml --accuracy "5 %" --for classification_velocity,voidage   as many beds as this accuracy takes
  slfb run scene.toml --set "liquid.superficial_velocity=0.08 m/s" --set stage[2].repetitions=5
  slfb run --profile full SYSTEM/0.10                        one run of a profile (`slfb list --runs full` shows them)

The result lies in DIR/runs/HASH/result.h5, HASH being computed from every value of the scene: the same scene is not
simulated twice, and a run that was interrupted goes on when the same command is given again.

)";

struct Options {
  std::string asked_scene;  ///< a file, or with a profile the key of one of its runs
  std::string profile, work;
  std::filesystem::path scene;
  std::filesystem::path out = build_folder();
  int threads = 1;
  Overrides overrides;
  bool planned = false, keep_forces = false, best = false;
  double accuracy = 0.0;                                    ///< asked relative error [-]; 0: one run as it is
  double budget = std::numeric_limits<double>::infinity();  ///< of CPU time for the accuracy [s]
  std::vector<std::string> asked;
  bool dry_run = false;
  bool json = false;
};

/// Top of the bed as the run would start it; nothing for a bed so large that placing it takes long [m].
/// Throws SceneError if the spheres do not fit.
std::optional<double> top_at_start(const Scene& scene, std::int64_t spheres) {
  constexpr std::int64_t most = 10'000'000;
  if (spheres == 0 || spheres > most) return std::nullopt;
  double top = 0.0;
  for (const dem::PlacedSphere& sphere : dem::start_positions(scene))
    top = std::max(top, sphere.centre[2] + 0.5 * scene.species[static_cast<std::size_t>(sphere.species)].diameter);
  return top;
}

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

int print_plan(const Options& options, const Scene& scene) {
  const RunEstimate estimate = estimate_run(scene);
  const std::optional<double> top = top_at_start(scene, estimate.spheres);
  const std::string hash = scene_hash(scene);
  const auto result = result_file(options.out, hash);
  const bool exists = std::filesystem::exists(result);
  const double wall_seconds = estimate.core_seconds / options.threads;
  if (options.json) {
    const json plan{{"scene", options.scene.string()},
                    {"hash", hash},
                    {"spheres", estimate.spheres},
                    {"liquid_cells", estimate.liquid_cells},
                    {"steps_per_contact", number_or_null(estimate.steps_per_contact)},
                    {"dem_time_step", scene.contact.time_step},
                    {"dem_time_step_bound", number_or_null(estimate.time_step_bound)},
                    {"liquid_time_step", scene.fluid.time_step},
                    {"simulated_seconds", estimate.simulated_seconds},
                    {"simulated_seconds_at_most", estimate.longest_seconds},
                    {"particle_steps", estimate.particle_steps},
                    {"dry_steps", estimate.dry_steps},
                    {"packed_steps", estimate.packed_steps},
                    {"exchange_steps", estimate.exchange_steps},
                    {"cell_steps", estimate.cell_steps},
                    {"estimated_wall_seconds", wall_seconds},
                    {"estimated_memory_bytes", estimate.memory},
                    {"notes", remarks_on(scene)},
                    {"result", result.string()},
                    {"result_exists", exists}};
    fmt::print("{}\n", plan.dump(2));
    return 0;
  }
  const auto line = [](const char* name, const std::string& text) { fmt::print("  {:<18} {}\n", name, text); };
  fmt::print("{}: the scene is valid\n", options.scene.string());
  if (!scene.title.empty()) line("title", scene.title);
  line("hash", hash);
  line("spheres", fmt::format("{}", estimate.spheres) +
                      (top ? fmt::format(", at the start up to {:.3g} m", *top) : std::string()));
  line("liquid cells", fmt::format("{}", estimate.liquid_cells));
  if (std::isnan(estimate.time_step_bound)) {
    line("bound of the step", "unknown: contact.law is a file, and --dry-run runs no code of it");
  } else {
    line("steps per contact", fmt::format("{:.1f} of {:.3g} s", estimate.steps_per_contact, scene.contact.time_step));
    line("bound of the step", fmt::format("{:.3g} s (1/ω_0 of the stiffest pair)", estimate.time_step_bound));
  }
  const double relaxation = is_user_law(scene.coupling.drag_law)
                                ? std::numeric_limits<double>::infinity()
                                : coupling::packed_relaxation_time(scene, find_drag_law(scene.coupling.drag_law));
  line("liquid step", fmt::format("{:.3g} s", scene.fluid.time_step) +
                          (scene.fluid.time_step > relaxation
                               ? fmt::format(", longer than the {:.2g} s in which drag stops a sphere of the packed "
                                             "bed: the motion may become unstable",
                                             relaxation)
                               : ""));
  line("simulated time", estimate.longest_seconds > estimate.simulated_seconds
                             ? fmt::format("{:.2f} s with {} s for each fall, at most {:.2f} s",
                                           estimate.simulated_seconds, typical_fall, estimate.longest_seconds)
                             : fmt::format("{:.2f} s", estimate.simulated_seconds));
  line("wall-clock time",
       fmt::format("about {} on {} thread{} of a quiet machine: {:.3g} M steps of a sphere, {:.3g} M of a cell",
                   format_duration(wall_seconds), options.threads, options.threads == 1 ? "" : "s",
                   1e-6 * static_cast<double>(estimate.particle_steps),
                   1e-6 * static_cast<double>(estimate.cell_steps)));
  line("memory", fmt::format("about {:.2g} GB", 1e-9 * estimate.memory));
  for (const std::string& remark : remarks_on(scene)) line("note", remark);
  line("result", result.string() + (exists ? " (exists: nothing would be simulated)" : ""));
  return 0;
}

/// The conventions of the work in whose folder a scene lies, or the general ones.
const MeasuringRules& rules_of(const std::filesystem::path& scene) {
  const auto folder = std::filesystem::weakly_canonical(scene).parent_path();
  for (const Work* work : works())
    if (folder == work->folders.experiments / "scenes") return work->measuring;
  return general_rules();
}

/// What measure_runs finds in one run, by quantity. Empty without bed particles, which its definitions need.
std::map<std::string, Measurement> measure(const Options& options, const Scene& scene, const RunResult& result) {
  if (std::none_of(scene.species.begin(), scene.species.end(), [](const Species& s) { return s.count > 0; })) return {};
  const RunSpec spec{options.scene.stem().string(), scene.liquid.superficial_velocity, "", options.scene, {}};
  const MeasuringRules& rules = rules_of(options.scene);
  std::map<std::string, Measurement> by_quantity;
  for (const auto& [key, measurement] : measure_runs({{spec, scene, result}}, rules))
    // The others are of a system over its velocities.
    if (key == measure_key(key.quantity, spec.system, spec.superficial_velocity))
      by_quantity[key.quantity] = measurement;
  return by_quantity;
}

double particle_steps_per_second(const RunResult& result) {
  return result.wall_seconds > 0.0 ? static_cast<double>(result.particle_steps) / result.wall_seconds : 0.0;
}

void add_result(json& answer, const Options& options, const Scene& scene, const RunResult& result,
                const std::map<std::string, Measurement>& measurements) {
  answer["wall_seconds"] = result.wall_seconds;
  answer["cpu_seconds"] = result.cpu_seconds;
  answer["simulated_seconds"] = result.simulated_seconds;
  answer["particle_steps"] = result.particle_steps;
  answer["particle_steps_per_second"] = particle_steps_per_second(result);
  answer["particles_removed"] = result.particles_removed;
  json& quantities = answer["measurements"] = json::object();
  for (const auto& [quantity, measurement] : measurements) {
    quantities[quantity] = {{"value", number_or_null(measurement.value)},
                            {"half_width", number_or_null(measurement.half_width)},
                            {"unit", measurement.unit},
                            {"samples", measurement.samples}};
  }
  json& drops = answer["drops"] = json::array();
  for (const DropSeries& drop : result.drops) {
    const auto fit = classification_of(drop, scene, rules_of(options.scene));
    drops.push_back({{"species", drop.species},
                     {"release_time", drop.release_time},
                     {"bottom_time", drop.bottom_time < 0.0 ? json(nullptr) : json(drop.bottom_time)},
                     {"classification_velocity", fit ? json(fit->velocity) : json(nullptr)},
                     {"r_squared", fit ? json(fit->r_squared) : json(nullptr)}});
  }
}

void print_result(const Options& options, const Scene& scene, const RunResult& result,
                  const std::map<std::string, Measurement>& measurements) {
  const auto line = [](const std::string& name, const std::string& text) { fmt::print("  {:<22} {}\n", name, text); };
  const auto measured = [&](const char* name, const char* quantity) {
    const auto found = measurements.find(quantity);
    if (found == measurements.end()) return;
    const Measurement& m = found->second;
    const std::string unit = m.unit == "-" ? "" : " " + m.unit;
    line(name, std::isfinite(m.half_width) ? fmt::format("{:.4g} ± {:.2g}{}", m.value, m.half_width, unit)
                                           : fmt::format("{:.4g}{}", m.value, unit));
  };
  measured("bed voidage", "voidage_centre_of_mass");
  measured("pressure drop", "pressure_drop");
  measured("V_2, mean of drops", "classification_velocity");
  for (std::size_t i = 0; i < result.drops.size(); ++i) {
    const DropSeries& drop = result.drops[i];
    const auto fit = classification_of(drop, scene, rules_of(options.scene));
    line(fmt::format("drop {} ({})", i + 1, drop.species),
         fmt::format(
             "{}, {}",
             fit ? fmt::format("V_2 = {:.4g} m/s{}", fit->velocity, fit->velocity < 0.0 ? " (rises)" : "")
                 : "no V_2 (too few points)",
             drop.bottom_time < 0.0 ? "bottom not reached" : fmt::format("bottom after {:.3g} s", drop.bottom_time)));
  }
  if (result.particles_removed > 0) line("left through outlet", fmt::format("{} spheres", result.particles_removed));
  line("simulated", fmt::format("{:.2f} s in {}, {:.3g} particle steps/s, {} thread{}", result.simulated_seconds,
                                format_duration(result.wall_seconds), particle_steps_per_second(result), result.threads,
                                result.threads == 1 ? "" : "s"));
}

const char* status_of(const CampaignOutcome& outcome) {
  if (outcome.interrupted > 0) return "interrupted";
  if (outcome.failed > 0) return "failed";
  return outcome.skipped > 0 ? "existed" : "finished";
}

/// Sets the scene file and the overrides from what was asked for.
void find_scene(Options& options) {
  options.scene = options.asked_scene;
  if (options.profile.empty()) {
    if (const std::string problem = CLI::ExistingFile(options.asked_scene); !problem.empty())
      throw CLI::ValidationError("SCENE", problem);
    return;
  }
  const RunSpec spec = find_run(load_profile(find_work(works(), options.work), options.profile), options.asked_scene);
  options.scene = spec.scene;
  options.overrides = spec.overrides;
}

/// Returns the exit status.
int run(const Options& options) {
  std::optional<NoForeignCode> guard;
  if (options.dry_run) guard.emplace();
  Scene scene = load_scene(options.scene, options.overrides);
  if (options.accuracy > 0.0) {
    const AccuracyOptions asked{.file = options.scene,
                                .scene = scene,
                                .asked = options.asked,
                                .error = options.accuracy,
                                .keep_forces = options.keep_forces,
                                .best = options.best,
                                .budget = options.budget,
                                .out = options.out,
                                .threads = options.threads,
                                .json = options.json};
    return options.dry_run ? plan_for_accuracy(asked) : run_for_accuracy(asked, rules_of(options.scene));
  }
  if (options.planned) {
    const plan::Plan made =
        plan::make_plan(scene, options.asked.empty() ? plan::usual_questions(scene) : options.asked, plan::load_rules(),
                        options.keep_forces ? plan::Forces::of_the_scene : plan::Forces::planned);
    if (made.by_formula) {
      for (const auto& [quantity, answer] : plan::answer_by_formula(scene, made))
        fmt::print("{} = {:.6g} by {}; nothing to simulate\n{}", quantity, answer.value, made.decisions.front().choice,
                   answer.remark.empty() ? "" : fmt::format("    {}\n", answer.remark));
      return 0;
    }
    scene = plan::changed(scene, made.overrides);
  }
  if (const std::string problem = memory_problem(estimate_run(scene)); !problem.empty())
    throw std::runtime_error(fmt::format("{}: {}", options.scene.string(), problem));
  if (options.dry_run) return print_plan(options, scene);

  for (const std::string& remark : remarks_on(scene)) spdlog::warn("{}", remark);
  const std::string hash = scene_hash(scene);
  const std::string label = options.profile.empty() ? options.scene.stem().string() : options.asked_scene;
  const CampaignOutcome outcome =
      run_scenes({{label, scene}}, {.out = options.out, .jobs = 1, .threads_per_run = options.threads});
  json answer{{"scene", options.scene.string()}, {"hash", hash}, {"status", status_of(outcome)}};
  if (outcome.unfinished() == 0) {
    const auto file = result_file(options.out, hash);
    const RunResult result = load_own_result(options.out, hash);
    const auto measurements = measure(options, scene, result);
    answer["result"] = file.string();
    add_result(answer, options, scene, result, measurements);
    if (!options.json) {
      fmt::print("{}{}\n", file.string(),
                 outcome.skipped > 0 ? " (had been computed; remove its folder to repeat)" : "");
      print_result(options, scene, result, measurements);
    }
  } else {
    answer["result"] = nullptr;
  }
  if (options.json) fmt::print("{}\n", answer.dump(2));
  return outcome.exit_status();
}

}  // namespace

void add_run_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("run", "Simulate one scene");
  command->add_option("SCENE", options->asked_scene, "scene file (TOML), or with --profile the key of a run")
      ->required()
      ->option_text("SCENE|KEY");
  CLI::Option* profile =
      command->add_option("--profile", options->profile, "one run of this profile, with its settings")
          ->option_text("PROFILE");
  add_work_option(*command, works(), options->work);
  command->add_option("--out", options->out, "folder of runs/")->type_name("DIR")->capture_default_str();
  command->add_option("--threads", options->threads, fmt::format("Threads, up to the {} cores here", cores))
      ->check(CLI::Range(1, cores))
      ->capture_default_str();
  command->add_option("--set", options->overrides, "replace a value of the scene: KEY=VALUE, may be repeated")
      ->allow_extra_args(false)
      ->excludes(profile);
  CLI::Option* plan = command->add_option_function<std::string>(
      "--plan", [options](const std::string&) { options->planned = true; },
      "auto: models, stiffness and steps as `slfb plan` chooses them");
  plan->check(CLI::IsMember({"auto"}));
  CLI::Option* accuracy = command->add_option_function<std::string>(
      "--accuracy", [options](const std::string& text) { options->accuracy = accuracy_of(text); },
      "Largest relative error that each asked quantity may have, \"5 %\": plans, and runs as many beds as it takes");
  accuracy->type_name("ERROR")->excludes(plan);
  command->add_flag("--best", options->best, "with --accuracy: the best that can be had where it is out of reach")
      ->needs(accuracy);
  command
      ->add_option_function<std::string>(
          "--budget", [options](const std::string& text) { options->budget = budget_seconds(text); },
          "With --accuracy: CPU time that may be spent, \"30 min\"")
      ->needs(accuracy)
      ->type_name("TIME");
  CLI::Option* asked =
      command->add_option("--for", options->asked, "quantities that are asked for (see `slfb plan --help`)");
  asked->delimiter(',')->type_name("Q,...");
  CLI::Option* keep_forces = command->add_flag("--keep-forces", options->keep_forces,
                                               "the plan leaves added mass, lift, … as the scene has them");
  command->add_flag("--dry-run", options->dry_run, "check the scene and show what would run, without running it");
  command->add_flag("--json", options->json, "write the plan or the summary as JSON");
  command->footer(std::string(examples) + accuracy_help);
  command->callback([options, plan, accuracy, asked, keep_forces] {
    for (const CLI::Option* option : {asked, keep_forces})
      if (option->count() > 0 && plan->count() == 0 && accuracy->count() == 0)
        throw CLI::RequiresError(option->get_name(), "--plan or --accuracy");
    find_scene(*options);
    int status = 0;
    try {
      status = run(*options);
    } catch (const std::invalid_argument& error) {  // a quantity that nobody knows, or the scene cannot answer
      throw CLI::ValidationError(error.what());
    }
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
