#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/figures/figure.hpp"
#include "experiments/runs/campaign.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

void list_figures(const std::vector<Claim>& claims) {
  std::map<std::string, std::size_t> of_figure;
  for (const Claim& claim : claims) ++of_figure[claim.figure];
  fmt::print("Figures drawn (slfb figures ID) and their claims (slfb check ID)\n");
  for (const Figure& figure : figures()) {
    fmt::print("  {:<8} {:3} claims  {}\n", figure.id, of_figure[figure.id], figure.title);
    of_figure.erase(figure.id);
  }
  std::string others;
  for (const auto& [figure, number] : of_figure) {
    others += fmt::format("{}{} ({})", others.empty() ? "" : ", ", figure, number);
  }
  fmt::print("  claims without a figure of their own: {}\n  {} claims in all\n", others, claims.size());
}

void list_profile(const std::string& name) {
  const Profile profile = load_profile(name);
  // One line per system and variant, with its velocities.
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> velocities;
  for (const RunSpec& run : profile.runs) {
    velocities[{run.system, run.variant}].push_back(velocity_text(run.superficial_velocity));
  }
  fmt::print("\nProfile {}: {} simulations\n", profile.name, profile.runs.size());
  for (const auto& [key, values] : velocities) {
    const auto& [system, variant] = key;
    fmt::print("  {} at {} m/s\n", variant.empty() ? system : system + ", " + variant, fmt::join(values, " "));
  }
}

void list_scenes() {
  fmt::print("\nScenes (slfb run experiments/scenes/NAME)\n");
  const auto folder = source_folder() / "experiments" / "peng_2014" / "scenes";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    fmt::print("  {:<32} {}\n", name, load_scene(folder / name).title);
  }
}

}  // namespace

void add_list_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("list", "List the figures, claims, simulations and scenes");
  command->callback([] {
    list_figures(load_claims());
    for (const std::string& name : profile_names()) list_profile(name);
    list_scenes();
  });
}

}  // namespace slfb
