#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/claims/measured_file.hpp"
#include "experiments/commands/baseline.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/work/judge.hpp"
#include "experiments/work/measured_systems.hpp"
#include "solver/support/close_names.hpp"
#include "solver/support/commit.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/processor.hpp"

namespace slfb {
namespace {

constexpr const char* examples = R"(Examples:
  slfb check                          every claim: paper, ours, verdict, gate
  slfb check fig05 table2             the claims whose id begins so
  slfb check --json                   the same as JSON on standard output
  slfb check --junit gates.xml        a test case per claim, for CI
  slfb check --template > mine.toml   a file for results of your own, from an experiment or another code: values,
                                      or raw series and dumps of spheres with the definitions that reduce them
  slfb check --measured mine.toml     what the claims say to them; the bands of the paper are the gates
  slfb check --measured mine.toml --baseline accepted.toml --accept   accept them: gates of the next call
  slfb check --measured mine.toml --baseline accepted.toml            have they changed since?

A verdict says whether the paper is reproduced; a gate says whether our own accepted value still stands. The exit
status is 0 when every gate of the chosen claims holds, 1 when one is broken, when results of --measured decide no claim,
or when a file cannot be read or written, 2 for a wrong command line. Name claims before --json, which takes what follows it as its file. Nothing is simulated.

JSON: {"made_by": {"version", "commit", "date", "machine"}, "claims": [CLAIM, ...]}; version and commit are empty for
results of --measured. `slfb history` keeps what versions said. A CLAIM has
  id, figure, quantity, unit   texts; "-" is the unit of ratios
  paper                        number, or a text ("at most 0.5", "increasing")
  ours, deviation              number, or null when not measured; deviation from the paper's value or the bound that
                               is broken, relative
  interval, paper_band         [lower, upper], or null; null inside stands for an open end
  verdict                      "reproduced", "not reproduced", "not decidable"
  gate                         "holds", "broken", "none"
  origin                       "paper", or "arithmetic": worked out here from its numbers and laws, not stated by it
  lack                         what an undecided claim needs: "paper" (its number or definition is lost), "run",
                               "steady bed", "samples"; "nothing" for a decided one
  reason                       text
The rules are in reference-data/README.md.)";

struct Options {
  std::string work;
  std::vector<std::string> ids;
  std::string json = "-";
  std::filesystem::path junit, measured, baseline;
  bool accept = false;  ///< take `measured` for the baseline
  bool start = false;   ///< print a file of measured results to start from
  std::string profile;
  std::filesystem::path out = build_folder();
};

/// The claims whose id is or begins with one of `ids`; all when there are none.
std::vector<Claim> choose(const std::vector<Claim>& claims, const std::vector<std::string>& ids) {
  if (ids.empty()) return claims;
  for (const std::string& id : ids) {
    if (std::none_of(claims.begin(), claims.end(), [&](const Claim& claim) { return claim.id.starts_with(id); })) {
      std::vector<std::string> known;
      for (const Claim& claim : claims) known.insert(known.end(), {claim.id, claim.figure});
      throw CLI::ValidationError("ID", fmt::format("no claim begins with \"{}\"; close: {}", id,
                                                   fmt::join(close_names(id, std::move(known)), ", ")));
    }
  }
  std::vector<Claim> chosen;
  std::copy_if(claims.begin(), claims.end(), std::back_inserter(chosen), [&](const Claim& claim) {
    return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) { return claim.id.starts_with(id); });
  });
  return chosen;
}

std::string ours_text(const Evaluation& evaluation) {
  if (!evaluation.ours) return "";
  std::string text = fmt::format("{:.4g}", *evaluation.ours);
  if (evaluation.interval) {
    const double half_width = 0.5 * (evaluation.interval->second - evaluation.interval->first);
    if (half_width > 0.0) text += fmt::format(" ± {:.2g}", half_width);
  }
  return text;
}

void print_table(const std::vector<Evaluation>& evaluations) {
  std::size_t id_width = 0, paper_width = 5;
  for (const Evaluation& evaluation : evaluations) {
    id_width = std::max(id_width, evaluation.claim.id.size());
    if (evaluation.claim.kind != StatementKind::words) {
      paper_width = std::max(paper_width, evaluation.claim.paper_text().size());
    }
  }
  fmt::print("{:<{}}  {:>{}}  {:>20}  {:<6} {:>9}  {:<14}  {:<6}  {}\n", "claim", id_width, "paper", paper_width,
             "ours", "unit", "deviation", "verdict", "gate", "reason");
  for (const Evaluation& evaluation : evaluations) {
    const Claim& claim = evaluation.claim;
    const std::string paper = claim.kind == StatementKind::words ? "words" : claim.paper_text();
    const std::string deviation =
        evaluation.deviation ? fmt::format("{:+.1f} %", 100.0 * *evaluation.deviation) : std::string();
    fmt::print("{:<{}}  {:>{}}  {:>20}  {:<6} {:>9}  {:<14}  {:<6}  {}\n", claim.id, id_width, paper, paper_width,
               ours_text(evaluation), claim.unit, deviation, to_string(evaluation.verdict), to_string(evaluation.gate),
               evaluation.reason);
  }
  const ClaimCounts counts = count(evaluations);
  fmt::print("\n{}\ngates: {} hold, {} broken\n", counts_text(evaluations), counts.gates_holding, counts.gates_broken);
}

/// What the laws and the runs of this suite say to the claims.
std::vector<Evaluation> evaluate_own(const Work& work, const std::vector<Claim>& claims, const Options& options) {
  const Profile profile = load_profile(work, options.profile.empty() ? work.default_profile : options.profile);
  return judge(work, profile, claims, options.out).evaluations;
}

/// What the claims say to results of others.
std::vector<Evaluation> evaluate_results(const Work& work, const std::vector<Claim>& chosen,
                                         const std::vector<Claim>& all, const Options& options) {
  const MeasuredSystems systems = measured_systems(work);
  const Measurements measured = load_measured(options.measured, all, systems);
  for (const auto& [key, value] : measured)
    if (!value.has_interval())
      spdlog::warn("{}: {} = {:.4g} {} has no interval: a single sample decides nothing", options.measured.string(),
                   to_string(key), value.value, value.unit);
  auto evaluations = evaluate_measured(chosen, measured);
  if (!options.baseline.empty())
    gate_against_baseline(evaluations, measured, load_measured(options.baseline, all, systems));
  return evaluations;
}

/// Takes the results for the baseline, once they have been read without an error: as values, since the records that a
/// file names will be other ones next time.
void accept(const Work& work, const Options& options) {
  const Measurements measured = load_measured(options.measured, load_claims(work), measured_systems(work));
  write_named_file(options.baseline, measured_text(measured));
  fmt::print("{} results of {} accepted in {}\n", measured.size(), options.measured.string(),
             options.baseline.string());
}

/// What was found, and by what.
nlohmann::ordered_json checked_json(const std::vector<Evaluation>& evaluations, bool of_others) {
  nlohmann::ordered_json json;
  json["made_by"] = {{"version", of_others ? "" : SLFB_VERSION},
                     {"commit", of_others ? "" : suite_commit()},
                     {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
                     {"machine", processor_name()}};
  json.update(claims_json(evaluations));
  return json;
}

/// Returns the exit status: 1 when a gate is broken, or when results of others were held against nothing.
int check(const Work& work, const Options& options, bool json) {
  for (const std::filesystem::path& file : {std::filesystem::path(options.json), options.junit})
    if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path()))
      throw std::runtime_error(
          fmt::format("cannot write {}: there is no folder {}", file.string(), file.parent_path().string()));
  const std::vector<Claim> all = load_claims(work), claims = choose(all, options.ids);
  const auto evaluations =
      options.measured.empty() ? evaluate_own(work, claims, options) : evaluate_results(work, claims, all, options);
  const bool json_to_stdout = json && options.json == "-";
  if (json_to_stdout) {
    fmt::print("{}\n", checked_json(evaluations, !options.measured.empty()).dump(2));
  } else {
    print_table(evaluations);
  }
  if (json && !json_to_stdout)
    write_named_file(options.json, checked_json(evaluations, !options.measured.empty()).dump(2) + "\n");
  if (!options.junit.empty()) write_named_file(options.junit, claims_junit(evaluations));
  const ClaimCounts counts = count(evaluations);
  if (!options.measured.empty() && counts.gates_holding + counts.gates_broken == 0) {
    // Nothing was held against anything: that is no success.
    fmt::print(
        stderr,
        "slfb: error: {} decides none of the {} chosen claims: a value needs an interval, and a claim all of its "
        "measures{}\n",
        options.measured.string(), claims.size(),
        options.baseline.empty() ? "" : fmt::format("; {} needs the same measures", options.baseline.string()));
    return 1;
  }
  return counts.gates_broken == 0 ? 0 : 1;
}

}  // namespace

void add_check_command(CLI::App& app, const Works& works) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("check", "Compare with the claims of a work; fail when a gate is broken");
  command->add_option("ID", options->ids, "claims, or what their ids begin with, such as fig05 (default: all)");
  add_work_option(*command, works, options->work);
  CLI::Option* json =
      command->add_option("--json", options->json, "write JSON to FILE, or to standard output without one")
          ->expected(0, 1)
          ->option_text("[FILE]");
  command->add_option("--junit", options->junit, "write JUnit XML of the claims to FILE")->option_text("FILE");
  CLI::Option* profile =
      command->add_option("--profile", options->profile, "whose simulations to use (`slfb list` shows them)");
  CLI::Option* out = command->add_option("--out", options->out, "folder with runs/")->option_text("DIR");
  CLI::Option* measured = command
                              ->add_option("--measured", options->measured,
                                           "hold the results in FILE against the claims, not those of this suite")
                              ->check(CLI::ExistingFile)
                              ->option_text("FILE")
                              ->excludes(profile)
                              ->excludes(out);
  CLI::Option* baseline = command
                              ->add_option("--baseline", options->baseline,
                                           "the gates are the results in FILE, accepted before, not the paper's bands")
                              ->option_text("FILE")
                              ->needs(measured);
  command->add_flag("--accept", options->accept, "write the results of --measured to FILE of --baseline")
      ->needs(baseline);
  command->add_flag("--template", options->start, "print a file for --measured to start from")->excludes(measured);
  command->footer(examples);
  command->callback([options, json, &works] {
    const Work& work = find_work(works, options->work);
    if (options->start)
      return fmt::print("{}", measured_template(choose(load_claims(work), options->ids), measured_systems(work)));
    if (options->accept) return accept(work, *options);
    if (options->json.empty()) options->json = "-";
    const int status = check(work, *options, json->count() > 0);
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
