#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "experiments/numerics/plan/plan.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/campaign.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

/// The table of profiles.toml that holds the definitions; each getter throws with the place of what it misses.
class Definitions {
 public:
  explicit Definitions(const std::filesystem::path& file) : file_(file.string()), root_(parse(file_)) {}

  /// Table `name` of a group ("profiles", "systems", "variants").
  [[nodiscard]] const toml::table& entry(const std::string& group, const std::string& name) const {
    const toml::table* all = root_[group].as_table();
    if (all == nullptr) throw std::runtime_error(fmt::format("{}: [{}] is missing", file_, group));
    const toml::table* found = (*all)[name].as_table();
    if (found != nullptr) return *found;
    std::string known;
    for (const auto& [key, node] : *all) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", key.str());
    throw std::runtime_error(fmt::format("{}: no \"{}\" in [{}]; known: {}", file_, name, group, known));
  }

  /// Names in a group, in the order of the file.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const {
    std::vector<std::pair<toml::source_index, std::string>> places;
    if (const toml::table* all = root_[group].as_table())
      for (const auto& [key, node] : *all) places.emplace_back(node.source().begin.line, key.str());
    std::ranges::sort(places);
    std::vector<std::string> names;
    for (auto& [line, name] : places) names.push_back(std::move(name));
    return names;
  }

  [[nodiscard]] const toml::table& common() const {
    const toml::table* found = root_["common"].as_table();
    if (found == nullptr) throw std::runtime_error(fmt::format("{}: [common] is missing", file_));
    return *found;
  }

  [[nodiscard]] const toml::array& array(const toml::table& table, const std::string& key) const {
    const toml::array* found = table[key].as_array();
    if (found == nullptr) throw missing(table, key, "an array");
    return *found;
  }

  template <class Value>
  [[nodiscard]] Value value(const toml::table& table, const std::string& key) const {
    const auto found = table[key].value<Value>();
    if (!found) throw missing(table, key, "a value");
    return *found;
  }

  /// The items of an array of one type.
  template <class Value>
  [[nodiscard]] std::vector<Value> values(const toml::table& table, const std::string& key) const {
    std::vector<Value> items;
    for (const toml::node& node : array(table, key)) {
      const auto item = node.value<Value>();
      if (!item) throw missing(table, key, "an array of one type");
      items.push_back(*item);
    }
    return items;
  }

 private:
  static toml::table parse(const std::string& file) {
    try {
      return toml::parse_file(file);
    } catch (const toml::parse_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
    }
  }

  [[nodiscard]] std::runtime_error missing(const toml::table& table, const std::string& key,
                                           std::string_view wanted) const {
    return std::runtime_error(fmt::format("{}:{}: \"{}\" is missing or of the wrong type; needed is {}", file_,
                                          table.source().begin.line, key, wanted));
  }

  std::string file_;
  toml::table root_;
};

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

std::filesystem::path scene_file(const std::filesystem::path& scene) {
  return source_folder() / "experiments" / "peng_2014" / "scenes" / scene;
}

std::filesystem::path definitions_file() { return source_folder() / "experiments" / "peng_2014" / "profiles.toml"; }

/// What the plan for these questions changes in a scene.
Overrides planned(const std::string& scene, const Overrides& overrides, const std::vector<std::string>& asked) {
  static const plan::Rules rules = plan::load_rules();
  return plan::make_plan(load_scene(scene_file(scene), overrides), asked, rules, plan::Forces::of_the_scene).overrides;
}

/// What planned runs have otherwise than the paper, as the other profiles say it in their own words.
std::vector<std::string> planned_differences(const std::vector<RunSpec>& runs) {
  const auto ms = [](double seconds) { return fmt::format("{:.3g} ms", 1e3 * seconds); };
  const auto stiffness = [](const Scene& scene) {  // "1e3", not "1e+03"
    const int power = static_cast<int>(std::floor(std::log10(scene.contact.stiffness) + 1e-9));
    return fmt::format("{:.2g}e{}", scene.contact.stiffness / std::pow(10.0, power), power);
  };
  const auto fluidised = [](const Scene& scene) {
    return std::ranges::find(scene.stages, StageKind::fluidise, &Stage::kind)->duration;
  };
  const Scene run = load_run_scene(runs.front()), paper = load_scene(scene_file(runs.front().scene));
  std::vector<std::string> differences{
      fmt::format("Contacts {} N/m at {}, not {} N/m at {}.", stiffness(run), ms(run.contact.time_step),
                  stiffness(paper), ms(paper.contact.time_step)),
      fmt::format("Liquid step {}, not {}.", ms(run.fluid.time_step), ms(peng_2014().value("fluid_time_step"))),
      fmt::format("Fluidised for {:g} s, not {:g} s.", fluidised(run), fluidised(paper))};
  std::set<double> without_rolling;
  for (const RunSpec& one : runs)
    if (load_run_scene(one).contact.rolling_friction == 0.0) without_rolling.insert(one.superficial_velocity);
  if (!without_rolling.empty())
    differences.push_back(fmt::format("No rolling resistance at {} to {} m/s.", velocity_text(*without_rolling.begin()),
                                      velocity_text(*without_rolling.rbegin())));
  return differences;
}

}  // namespace

std::vector<std::string> profile_names() { return Definitions(definitions_file()).names("profiles"); }

Profile load_profile(const std::string& name) {
  const Definitions definitions(definitions_file());
  const toml::table& table = definitions.entry("profiles", name);
  Profile profile{name, definitions.values<std::string>(definitions.common(), "differences"), {}};
  append(profile.differences, definitions.values<std::string>(table, "differences"));
  const auto profile_overrides = definitions.values<std::string>(table, "overrides");
  const bool by_plan = table.contains("planned_for");
  const auto asked = by_plan ? definitions.values<std::string>(table, "planned_for") : std::vector<std::string>{};

  for (const toml::node& node : definitions.array(table, "runs")) {
    if (!node.is_table()) throw std::runtime_error(fmt::format("profile \"{}\": a run is not a table", name));
    const toml::table& run = *node.as_table();
    const auto system = definitions.value<std::string>(run, "system");
    const toml::table& definition = definitions.entry("systems", system);
    const auto scene = definitions.value<std::string>(definition, "scene");
    const auto of_system = definitions.values<std::string>(definition, "overrides");
    const auto variant = run["variant"].value_or<std::string>("");
    for (const double velocity : definitions.values<double>(run, "superficial_velocities")) {
      const std::string of_velocity = fmt::format("liquid.superficial_velocity={} m/s", velocity);
      RunSpec spec{system, velocity, variant, scene, {}, name};
      if (by_plan) {
        auto paper = of_system;
        paper.push_back(of_velocity);
        spec.overrides = planned(scene, paper, asked);
      }
      append(spec.overrides, profile_overrides);
      append(spec.overrides, of_system);
      if (run.contains("overrides")) append(spec.overrides, definitions.values<std::string>(run, "overrides"));
      spec.overrides.push_back(of_velocity);
      if (!variant.empty())
        append(spec.overrides, definitions.values<std::string>(definitions.entry("variants", variant), "overrides"));
      profile.runs.push_back(std::move(spec));
    }
  }
  if (by_plan) append(profile.differences, planned_differences(profile.runs));
  profile.goes_on_from_published = table["goes_on_from_published"].value_or(false);
  if (table.contains("whole"))
    for (std::string& key : definitions.values<std::string>(table, "whole")) profile.whole.insert(std::move(key));
  return profile;
}

Profile with_full_runs(Profile profile) {
  if (profile.name == "full") return profile;
  for (RunSpec& run : load_profile("full").runs) profile.runs.push_back(std::move(run));
  return profile;
}

}  // namespace slfb
