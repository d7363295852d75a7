#include "experiments/claims/history.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/quantities/json_file.hpp"
#include "experiments/work/history_page.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr const char* history_examples = R"(Examples:
  slfb check --json claims.json
  slfb bench dem --json > dem.json
  slfb history history.jsonl --add claims.json --bench dem.json    what this version says, behind the earlier ones
  slfb history history.jsonl                                       what has changed; DIR/history/index.html draws it
  slfb check --measured mine.toml --json claims.json
  slfb history mine.jsonl --add claims.json --label "mycode 2.1"   the same of another code

A line of the file is what one version said: version, commit, date, machine, value and verdict of each claim, times of
benchmarks. Each claim of the last one is held against the one before and the first: size of the change and its
significance, and how much of the paper's band is used up, so that a drift is seen before a gate breaks.)";

struct HistoryOptions {
  fs::path file, add, out = build_folder();
  std::vector<fs::path> bench;
  std::string label;
};

void add_entry(const HistoryOptions& options) {
  HistoryEntry entry =
      read_json(options.add, "what `slfb check --json` writes",
                [&](const nlohmann::ordered_json& json) { return history_entry(json, options.label); });
  for (const fs::path& file : options.bench)
    read_json(file, "what `slfb bench … --json` writes", [&](const nlohmann::ordered_json& json) {
      add_bench(entry, json);
      return true;
    });
  if (fs::exists(options.file)) load_history(options.file);  // nothing is written behind what cannot be read
  append_to_history(options.file, entry);
}

}  // namespace

void add_history_command(CLI::App& app) {
  auto options = std::make_shared<HistoryOptions>();
  CLI::App* command = app.add_subcommand("history", "What versions said to the claims, and what has changed");
  command->add_option("FILE", options->file, "file of the history, a line for each version")->required();
  CLI::Option* add = command->add_option("--add", options->add, "add what `slfb check --json` wrote to JSON")
                         ->check(CLI::ExistingFile)
                         ->option_text("JSON");
  command->add_option("--bench", options->bench, "with times that `slfb bench … --json` wrote")
      ->check(CLI::ExistingFile)
      ->option_text("JSON ...")
      ->needs(add);
  command->add_option("--label", options->label, "version that is added (default: that of slfb)")
      ->option_text("TEXT")
      ->needs(add);
  command->add_option("--out", options->out, "folder of history/index.html")->option_text("DIR");
  command->footer(history_examples);
  command->callback([options] {
    if (!options->add.empty()) add_entry(*options);
    const std::vector<HistoryEntry> entries = load_history(options->file);
    const fs::path folder = options->out / "history";
    fs::create_directories(folder);
    write_file(folder / "index.html", history_html(entries));
    fmt::print("{}page: {}\n", history_text(entries), (folder / "index.html").string());
  });
}

}  // namespace slfb
