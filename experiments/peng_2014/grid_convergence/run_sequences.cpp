#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "experiments/peng_2014/causes/causes.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::grid_convergence {
namespace {

const std::map<std::string, std::string>& titles() {
  static const std::map<std::string, std::string> list{
      {velocity, "V_2"}, {voidage, "voidage"}, {pressure_drop, "Δp"}, {force_ratio, "|F_c|/mg"}};
  return list;
}

/// Runs of "PROFILE/VARIANT" at one of these velocities.
std::vector<FinishedRun> runs_named(const std::string& name, const std::set<double>& velocities,
                                    const std::filesystem::path& results) {
  const std::size_t slash = name.find('/');
  Profile profile = load_profile(name.substr(0, slash));
  const std::string variant = name.substr(slash + 1);
  std::erase_if(profile.runs, [&](const RunSpec& spec) {
    return spec.variant != variant || !velocities.contains(spec.superficial_velocity);
  });
  return single_changes::runs_of(profile, variant, results);
}

/// What is known of one sequence, "V_2, default scene, 0.10 m/s, cells 5 to 10 mm: order …"; empty for fewer than two
/// levels.
std::string sentence(const convergence::Sequence& sequence, const convergence::QuantitySequence& of) {
  if (of.levels.size() < 2) return {};
  const auto [least, largest] = std::ranges::minmax(of.levels, {}, &convergence::Level::size);
  const std::string what = fmt::format(
      "{}, {}, {} {} to {}", titles().at(of.quantity), sequence.title, convergence::name_of(sequence.refined),
      convergence::size_text(sequence.refined, least.size), convergence::size_text(sequence.refined, largest.size));
  if (of.levels.size() > 2) return fmt::format("{}: {}", what, convergence::describe(convergence::analyse(of.levels)));
  return fmt::format("{}: {:+.2g} % from the finer to the coarser; an order needs a third", what,
                     100.0 * (largest.value / least.value - 1.0));
}

}  // namespace

std::vector<convergence::Sequence> run_sequences(const std::filesystem::path& results) {
  const auto file = source_folder() / "experiments/peng_2014/grid_convergence/sequences.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  std::vector<convergence::Sequence> sequences;
  for (TomlTable& one : table.tables("sequence")) {
    const std::string title = one.text("title");
    const convergence::Refined refined = convergence::refined_by_name(one.text("refined"));
    const auto listed = one.numbers("superficial_velocities");
    const std::set<double> velocities(listed.begin(), listed.end());
    const std::size_t first = sequences.size();
    for (const double u : listed) {
      sequences.push_back({fmt::format("{}, {:.2f} m/s", title, u), refined, {}});
      for (const auto& [quantity, of] : titles()) sequences.back().quantities.push_back({quantity, {}});
    }
    for (TomlTable& level : one.tables("level")) {
      const double size = level.number("size");
      std::vector<FinishedRun> runs;
      for (const std::string& name : level.texts("runs"))
        for (FinishedRun& run : runs_named(name, velocities, results)) runs.push_back(std::move(run));
      level.reject_others();
      const Measurements found = measure_runs(runs, peng_2014_work().measuring);
      for (std::size_t k = 0; k < listed.size(); ++k)
        for (convergence::QuantitySequence& of : sequences[first + k].quantities)
          if (const auto entry = found.find(measure_key(of.quantity, single_changes::system_name, listed[k]));
              entry != found.end())
            of.levels.push_back({size, entry->second.value, entry->second.half_width});
    }
    one.reject_others();
  }
  table.reject_others();
  return sequences;
}

void add_note(const std::vector<std::string>& quantities, const FigureContext& context, FigureOutput& output) {
  // Many figures of one report ask, and the runs take a second to read.
  static std::mutex mutex;
  static std::map<std::filesystem::path, std::vector<convergence::Sequence>> known;
  const std::lock_guard lock(mutex);
  const auto [entry, is_new] = known.try_emplace(context.results);
  if (is_new) entry->second = run_sequences(context.results);
  std::string note;
  for (const convergence::Sequence& sequence : entry->second)
    for (const convergence::QuantitySequence& of : sequence.quantities)
      if (std::ranges::find(quantities, of.quantity) != quantities.end())
        if (const std::string text = sentence(sequence, of); !text.empty()) note += (note.empty() ? "" : ". ") + text;
  if (!note.empty()) output.notes.push_back("Discretisation error (figure grid-convergence): " + note + ".");
}

}  // namespace slfb::grid_convergence
