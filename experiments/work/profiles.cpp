#include "experiments/work/profiles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/numerics/plan/plan.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/more_runs.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

/// The definitions of a profiles.toml.
class Definitions {
 public:
  explicit Definitions(const Work& work)
      : file_(work.folders.experiments / "profiles.toml"), root_(parse_toml_file(file_)) {}

  /// Table `name` of a group ("profiles", "systems", "variants").
  [[nodiscard]] TomlTable entry(const std::string& group, const std::string& name) const {
    const toml::table* found = root_[group][name].as_table();
    if (found != nullptr) return {*found, file_.string()};
    std::vector<std::string> known;
    if (const toml::table* all = root_[group].as_table())
      for (const auto& [key, node] : *all) known.push_back(fmt::format("\"{}\"", key.str()));
    throw std::runtime_error(
        fmt::format("{}: no \"{}\" in [{}]; known: {}", file_.string(), name, group, fmt::join(known, ", ")));
  }

  /// Names in a group, in the order of the file.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const {
    std::vector<std::pair<toml::source_index, std::string>> positions;
    if (const toml::table* all = root_[group].as_table())
      for (const auto& [key, node] : *all) positions.emplace_back(node.source().begin.line, key.str());
    std::ranges::sort(positions);
    std::vector<std::string> names;
    for (auto& [line, name] : positions) names.push_back(std::move(name));
    return names;
  }

  /// True of every profile: [common] differences.
  [[nodiscard]] std::vector<std::string> common_differences() const {
    const toml::table* common = root_["common"].as_table();
    return common == nullptr ? std::vector<std::string>{} : TomlTable(*common, file_.string()).texts("differences");
  }

 private:
  std::filesystem::path file_;
  toml::table root_;
};

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// A variant and what it changes in a scene.
using Variant = std::pair<std::string, Overrides>;

/// The variant of a [[profiles.NAME.runs]], or the readings of its design; "" where it names neither.
std::vector<Variant> variants_of_run(TomlTable& run, const Work& work, const Definitions& definitions) {
  const std::string variant = run.text("variant", ""), design = run.text("design", "");
  if (!design.empty()) {
    if (!variant.empty()) throw run.problem("variant", "stands beside a design; allowed is one of them");
    const readings::Choices choices = load_choices(work);
    std::vector<Variant> variants;
    try {
      for (const readings::Reading& reading : choices.design(design))
        variants.emplace_back(choices.name_of(reading), choices.overrides_of(reading));
    } catch (const std::invalid_argument& error) {
      throw run.problem("design", error.what());
    }
    return variants;
  }
  if (variant.empty()) return {{"", {}}};
  return {{variant, definitions.entry("variants", variant).texts("overrides")}};
}

/// The replicates of a [[profiles.NAME.runs]]; empty stands for the seed of the scene.
std::vector<std::optional<std::uint64_t>> seeds_of_run(TomlTable& run, const std::filesystem::path& scene,
                                                       const Overrides& of_system) {
  if (!run.has("seeds")) return {std::nullopt};
  const std::uint64_t own = load_scene(scene, of_system).seed;
  std::vector<std::optional<std::uint64_t>> seeds;
  for (const double number : run.numbers("seeds")) {
    if (!(number >= 0.0 && number <= 1e9 && number == std::floor(number)))
      throw run.problem("seeds", fmt::format("{} is no seed; allowed are whole numbers from 0 to 1e9", number));
    const auto seed = static_cast<std::uint64_t>(number);
    const auto entry = seed == own ? std::nullopt : std::optional(seed);
    if (std::ranges::find(seeds, entry) != seeds.end()) throw run.problem("seeds", fmt::format("has {} twice", seed));
    seeds.push_back(entry);
  }
  if (seeds.empty()) throw run.problem("seeds", "is empty; needed is one seed or more");
  return seeds;
}

/// What the plan for these questions changes in a scene.
Overrides planned(const std::filesystem::path& scene, const Overrides& overrides,
                  const std::vector<std::string>& asked) {
  static const plan::Rules rules = plan::load_rules();
  return plan::make_plan(load_scene(scene, overrides), asked, rules, plan::Forces::of_the_scene).overrides;
}

/// What planned runs have otherwise than the work, as the other profiles say it in their own words.
std::vector<std::string> planned_differences(const Work& work, const std::vector<RunSpec>& runs) {
  const auto ms = [](double seconds) { return fmt::format("{:.3g} ms", 1e3 * seconds); };
  const auto stiffness = [](const Scene& scene) {  // "1e3", not "1e+03"
    const int power = static_cast<int>(std::floor(std::log10(scene.contact.stiffness) + 1e-9));
    return fmt::format("{:.2g}e{}", scene.contact.stiffness / std::pow(10.0, power), power);
  };
  const auto fluidised = [](const Scene& scene) {
    return std::ranges::find(scene.stages, StageKind::fluidise, &Stage::kind)->duration;
  };
  const Scene run = load_run_scene(runs.front()), source = load_scene(runs.front().scene);
  std::vector<std::string> differences{
      fmt::format("Contacts {} N/m at {}, not {} N/m at {}.", stiffness(run), ms(run.contact.time_step),
                  stiffness(source), ms(source.contact.time_step)),
      fmt::format("Liquid step {}, not {}.", ms(run.fluid.time_step),
                  ms(work.stated_liquid_step.value_or(source.fluid.time_step))),
      fmt::format("Fluidised for {:g} s, not {:g} s.", fluidised(run), fluidised(source))};
  std::set<double> without_rolling;
  for (const RunSpec& one : runs)
    if (load_run_scene(one).contact.rolling_friction == 0.0) without_rolling.insert(one.superficial_velocity);
  if (!without_rolling.empty())
    differences.push_back(fmt::format("No rolling resistance at {} to {} m/s.", velocity_text(*without_rolling.begin()),
                                      velocity_text(*without_rolling.rbegin())));
  return differences;
}

}  // namespace

std::vector<std::string> profile_names(const Work& work) {
  std::vector<std::string> names;
  if (std::filesystem::exists(work.folders.experiments / "profiles.toml")) names = Definitions(work).names("profiles");
  if (work.profiles)
    for (const Profile& profile : work.profiles()) names.push_back(profile.name);
  return names;
}

Profile load_profile(const Work& work, const std::string& name) {
  if (work.profiles) {
    std::vector<std::string> known = profile_names(work);
    for (Profile& profile : work.profiles())
      if (profile.name == name) return std::move(profile);
    if (std::ranges::find(known, name) == known.end())
      throw std::runtime_error(
          fmt::format("{} has no profile \"{}\"; known: {}", work.id, name, fmt::join(known, ", ")));
  }
  const Definitions definitions(work);
  TomlTable table = definitions.entry("profiles", name);
  Profile profile{name, {}, {}};
  if (!table.flag("own_differences_only")) profile.differences = definitions.common_differences();
  append(profile.differences, table.texts("differences"));
  const auto profile_overrides = table.texts("overrides");
  const auto asked = table.texts("planned_for");
  const std::string of_profile = table.text("scene", "");

  std::set<std::string> keys;
  for (TomlTable& run : table.tables("runs")) {
    const auto system = run.text("system");
    TomlTable definition = definitions.entry("systems", system);
    const std::string of_definition = definition.text("scene");
    const auto of_system_scene = work.folders.experiments / "scenes" / of_definition;
    const auto scene =
        work.folders.experiments / "scenes" / run.text("scene", of_profile.empty() ? of_definition : of_profile);
    const auto of_system = definition.texts("overrides");
    const bool designed = run.has("design");
    const auto variants = variants_of_run(run, work, definitions);
    const auto seeds = seeds_of_run(run, scene, of_system);
    const auto of_run = run.texts("overrides");
    for (const double velocity : run.numbers("superficial_velocities")) {
      const std::string of_velocity = fmt::format("liquid.superficial_velocity={} m/s", velocity);
      Overrides overrides;
      if (!asked.empty()) {
        auto source = of_system;
        source.push_back(of_velocity);
        overrides = planned(scene, source, asked);
      }
      append(overrides, profile_overrides);
      append(overrides, of_system);
      append(overrides, of_run);
      overrides.push_back(of_velocity);
      for (const auto& [variant, of_variant] : variants)
        for (const auto seed : seeds) {
          RunSpec spec{system, velocity, variant, scene, overrides, name, {}, work.folders.published, seed};
          append(spec.overrides, of_variant);
          if (scene != of_system_scene) spec.system_scene = of_system_scene;
          if (seed) spec.overrides.push_back(fmt::format("seed={}", *seed));
          if (!keys.insert(run_key(spec)).second && designed) continue;  // another design of the profile has it too
          profile.runs.push_back(std::move(spec));
        }
    }
    run.reject_others();
  }
  if (!asked.empty() && !profile.runs.empty()) append(profile.differences, planned_differences(work, profile.runs));
  for (RunSpec& run : profile.runs) run.differences = profile.differences;
  profile.goes_on_from_published = table.flag("goes_on_from_published");
  for (std::string& key : table.texts("whole")) profile.whole.insert(std::move(key));
  table.reject_others();
  return profile;
}

readings::Choices load_choices(const Work& work) {
  return readings::load_choices(work.folders.experiments / "readings.toml");
}

Profile with_shown_runs(const Work& work, Profile profile) {
  if (work.shown_beside.empty() || profile.name == work.shown_beside) return profile;
  for (RunSpec& run : load_profile(work, work.shown_beside).runs) profile.runs.push_back(std::move(run));
  return profile;
}

std::vector<FinishedRun> runs_with_scene_stiffness(const Work& work, const std::filesystem::path& out) {
  std::vector<FinishedRun> runs;
  const Profile profile = with_more_runs(load_profile(work, work.shown_beside), load_more_runs(work, out));
  for (FinishedRun& run : finished_runs(profile, out))
    if (!run.stale && run.scene.contact.stiffness == load_scene(run.spec.scene).contact.stiffness)
      runs.push_back(std::move(run));
  take_out_other_models(runs, work.measuring);
  return runs;
}

}  // namespace slfb
