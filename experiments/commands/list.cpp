#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

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

void list_scenes(const Work& work) {
  fmt::print("\nScenes (slfb run FILE)\n");
  for (const auto& folder : {work.folders.experiments / "scenes", source_folder() / "experiments" / "scenes"}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& file : toml_files(folder)) {
      const auto shown = std::filesystem::relative(file, source_folder());
      fmt::print("  {:<55} {}\n", shown.string(), load_scene(file).title);
    }
  }
}

void list_quantities(const Work& work) {
  for (const Quantity& quantity : work.measuring.quantities)
    fmt::print("{} [{}]: {}\n    {}{}\n", quantity.id, quantity.unit, quantity.title, quantity.definition,
               quantity.depends_on_contact_stiffness ? " Depends on the contact stiffness." : "");
}

}  // namespace

void add_list_command(CLI::App& app, const Works& works) {
  struct Options {
    std::string work, what;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("list", "List the figures, claims, simulations and scenes, or the quantities");
  command->add_option("WHAT", options->what, "quantities: what is measured, with unit and definition")
      ->check(CLI::IsMember({"quantities"}));
  add_work_option(*command, works, options->work);
  command->callback([options, &works] {
    const Work& work = find_work(works, options->work);
    if (options->what == "quantities") return list_quantities(work);
    list_figures(work);
    for (const std::string& name : profile_names(work)) list_profile(work, name);
    list_scenes(work);
  });
}

}  // namespace slfb
