#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/run_entries.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/io/run_result.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

using json = nlohmann::ordered_json;

void list_figures(const Work& work) {
  const std::vector<Claim> claims = load_claims(work);
  std::map<std::string, std::size_t> of_figure;
  for (const Claim& claim : claims) ++of_figure[claim.figure];
  fmt::print("Figures drawn (slfb figures ID) and their claims (slfb check ID)\n");
  for (const Figure& figure : work.figures) {
    fmt::print("  {:<8} {:3} claims  {}\n", figure.id, of_figure[figure.id], figure.title);
    of_figure.erase(figure.id);
  }
  std::string others;
  for (const auto& [figure, number] : of_figure) {
    others += fmt::format("{}{} ({})", others.empty() ? "" : ", ", figure, number);
  }
  fmt::print("  claims without a figure of their own: {}\n  {} claims in all\n", others, claims.size());
}

void list_profile(const Work& work, const std::string& name) {
  const Profile profile = load_profile(work, name);
  // One line per system and variant, with its velocities.
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> velocities;
  double core_seconds = 0.0;
  for (const RunSpec& run : profile.runs) {
    std::string text = velocity_text(run.superficial_velocity);
    if (run.seed) text += fmt::format(" (seed {})", *run.seed);
    velocities[{run.system, run.variant}].push_back(std::move(text));
    core_seconds += estimate_run(load_run_scene(run)).core_seconds;
  }
  fmt::print("\nProfile {}: {} simulations, about {} of one core\n", profile.name, profile.runs.size(),
             format_duration(core_seconds));
  for (const auto& [key, values] : velocities) {
    const auto& [system, variant] = key;
    fmt::print("  {} at {} m/s\n", variant.empty() ? system : system + ", " + variant, fmt::join(values, " "));
  }
}

std::vector<std::filesystem::path> scene_files(const Work& work) {
  std::vector<std::filesystem::path> files;
  for (const auto& folder : {work.folders.experiments / "scenes", source_folder() / "experiments" / "scenes"}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& file : toml_files(folder)) files.push_back(file);
  }
  return files;
}

void list_scenes(const Work& work) {
  fmt::print("\nScenes (slfb run FILE)\n");
  for (const auto& file : scene_files(work))
    fmt::print("  {:<55} {}\n", std::filesystem::relative(file, source_folder()).string(), load_scene(file).title);
}

void list_quantities(const Work& work) {
  for (const Quantity& quantity : work.measuring.quantities)
    fmt::print("{} [{}]: {}\n    {}{}\n", quantity.id, quantity.unit, quantity.title, quantity.definition,
               quantity.depends_on_contact_stiffness ? " Depends on the contact stiffness." : "");
}

void list_data() {
  for (const ResultDataSet& set : result_data_sets())
    fmt::print("{:<40} {:<8} {}\n", set.path, set.unit, set.description);
}

void list_runs(const Profile& profile, const std::filesystem::path& out) {
  double core_seconds = 0.0;
  for (const RunEntry& entry : run_entries(profile, out)) {
    fmt::print("{}  {:<40} {:>12}  {}\n", entry.hash, entry.key, format_duration(entry.core_seconds),
               entry.done     ? "done"
               : entry.needed ? "to do"
                              : "committed");
    if (entry.needed) core_seconds += entry.core_seconds;
  }
  fmt::print("to do: about {} of one core\n", format_duration(core_seconds));
}

json runs_json(const Profile& profile, const std::filesystem::path& out) {
  json runs = json::array();
  for (const RunEntry& entry : run_entries(profile, out)) runs.push_back(run_entry_json(entry, out));
  return {{"profile", profile.name}, {"runs", std::move(runs)}};
}

json everything_json(const Work& work, const std::filesystem::path& out) {
  json figures = json::array(), claims = json::array(), profiles = json::array(), scenes = json::array(),
       quantities = json::array(), data = json::array();
  for (const Figure& figure : work.figures) figures.push_back({{"id", figure.id}, {"title", figure.title}});
  for (const Claim& claim : load_claims(work))
    claims.push_back(
        {{"id", claim.id}, {"figure", claim.figure}, {"quantity", claim.quantity}, {"paper", claim.paper_text()}});
  for (const std::string& name : profile_names(work)) profiles.push_back(runs_json(load_profile(work, name), out));
  for (const auto& file : scene_files(work))
    scenes.push_back({{"file", file.string()}, {"title", load_scene(file).title}});
  for (const Quantity& quantity : work.measuring.quantities)
    quantities.push_back(
        {{"id", quantity.id}, {"unit", quantity.unit}, {"title", quantity.title}, {"definition", quantity.definition}});
  for (const ResultDataSet& set : result_data_sets())
    data.push_back({{"path", set.path}, {"unit", set.unit}, {"description", set.description}});
  return {{"work", work.id},  {"figures", figures},       {"claims", claims}, {"profiles", profiles},
          {"scenes", scenes}, {"quantities", quantities}, {"data", data}};
}

}  // namespace

void add_list_command(CLI::App& app, const Works& works) {
  struct Options {
    std::string work, what, runs;
    std::filesystem::path out = build_folder();
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("list", "List the figures, claims, simulations and scenes, or the quantities");
  CLI::Option* what = command
                          ->add_option("WHAT", options->what,
                                       "quantities: what is measured, with unit and definition; data: what a result "
                                       "file holds")
                          ->check(CLI::IsMember({"quantities", "data"}));
  command->add_option("--runs", options->runs, "the runs of a profile: hash, key, cost on one core, whether it is done")
      ->option_text("PROFILE")
      ->excludes(what);
  command->add_flag("--json", options->json, "everything, or the runs of --runs, as JSON")->excludes(what);
  command->add_option("--out", options->out, "folder of runs/")->option_text("DIR");
  add_work_option(*command, works, options->work);
  command->footer(R"(Examples:
  slfb list                          figures, runs and costs of each profile, scenes
  slfb list quantities               what is measured, with unit and definition
  slfb list data                     what a result file holds
  slfb list --runs full              the runs of profile full: hash, key, cost on one core, whether they are done
  slfb list --json                   everything, for programs)");
  command->callback([options, &works] {
    const Work& work = find_work(works, options->work);
    if (options->what == "quantities") return list_quantities(work);
    if (options->what == "data") return list_data();
    if (!options->runs.empty()) {
      const Profile profile = load_profile(work, options->runs);
      if (options->json) return fmt::print("{}\n", runs_json(profile, options->out).dump(2));
      return list_runs(profile, options->out);
    }
    if (options->json) return fmt::print("{}\n", everything_json(work, options->out).dump(2));
    list_figures(work);
    for (const std::string& name : profile_names(work)) list_profile(work, name);
    list_scenes(work);
  });
}

}  // namespace slfb
