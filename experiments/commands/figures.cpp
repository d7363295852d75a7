#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/judge.hpp"
#include "experiments/work/report_pages.hpp"
#include "reports/report.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

constexpr const char* examples = R"(Examples:
  slfb figures                     simulate what is missing, draw every figure, write the report
  slfb figures fig10 fig25         simulate only what these two need
  slfb figures --no-run            draw with what exists; takes seconds
  slfb figures --profile full      the settings of the full campaign; takes hours, may be interrupted
  slfb figures --profile NAME --only-runs --publish   simulate a profile and keep its results; draw nothing
  slfb figures --jobs 1 --threads 2   one simulation at a time on two cores

Results are kept in DIR/runs and named by their scene: a second call simulates nothing twice, and after an
interruption the same command goes on where it was. `slfb list` shows the figures and the runs of each profile.)";

struct Options {
  std::string work;
  std::vector<std::string> ids;
  std::string profile;
  int jobs = 0;     // 0: as many as there are cores or runs
  int threads = 0;  // 0: share the cores among the jobs
  std::filesystem::path out = build_folder();
  bool no_run = false;
  bool only_runs = false;
  bool publish = false;
};

std::string known_ids(const Work& work) {
  std::string text;
  for (const auto& figure : work.figures) text += (text.empty() ? "" : ", ") + figure.id;
  return text;
}

/// The named figures, or all of them. Throws CLI::ValidationError listing the known ones on an unknown name.
std::vector<const Figure*> choose(const Work& work, const std::vector<std::string>& ids) {
  for (const auto& id : ids)
    if (std::ranges::find(work.figures, id, &Figure::id) == work.figures.end())
      throw CLI::ValidationError("ID", fmt::format("there is no figure \"{}\"; known: {}", id, known_ids(work)));
  std::vector<const Figure*> chosen;
  for (const auto& figure : work.figures)
    if (ids.empty() || std::ranges::find(ids, figure.id) != ids.end()) chosen.push_back(&figure);
  return chosen;
}

/// The runs that the figures need, or with `all` those of the profile, whether a figure draws them or not.
std::vector<RunSpec> needed_runs(const std::vector<const Figure*>& chosen, const Profile& profile, bool all) {
  std::set<std::string> keys;
  if (all)
    for (const RunSpec& spec : profile.runs) keys.insert(run_key(spec));
  for (const Figure* figure : chosen)
    for (auto& key : figure->needs(profile)) keys.insert(std::move(key));
  if (profile.goes_on_from_published)
    for (const FinishedRun& run : published_runs(profile)) keys.erase(run_key(run.spec));
  std::vector<RunSpec> needed;
  for (const auto& spec : profile.runs)
    if (keys.contains(run_key(spec))) needed.push_back(spec);
  return needed;
}

CampaignOptions campaign_options(const Options& options, std::size_t runs) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = options.jobs > 0 ? options.jobs : std::clamp(static_cast<int>(runs), 1, cores);
  const int threads = options.threads > 0 ? options.threads : std::max(1, cores / jobs);
  return {.out = options.out, .jobs = jobs, .threads_per_run = threads, .progress = true};
}

/// Puts a finished result of a profile where it can be committed; figures use it where nothing is simulated.
void publish(const Work& work, const Profile& profile, const RunSpec& spec, const std::filesystem::path& out) {
  const std::string hash = scene_hash(load_run_scene(spec));
  if (std::filesystem::exists(result_file(out, hash)))
    publish_result(spec, load_own_result(out, hash), profile.whole.contains(run_key(spec)), work.measuring);
}

/// Returns the exit status, which tells of simulations that failed or were interrupted.
int make_figures(const Work& work, const Options& options) {
  const auto chosen = choose(work, options.ids);
  const Profile profile = load_profile(work, options.profile.empty() ? work.default_profile : options.profile);
  CampaignOutcome outcome;
  if (!options.no_run) {
    const auto needed = needed_runs(chosen, profile, options.only_runs && options.ids.empty());
    CampaignOptions campaign = campaign_options(options, needed.size());
    if (options.publish) campaign.finished = [&](std::size_t k) { publish(work, profile, needed[k], options.out); };
    if (!needed.empty()) outcome = run_campaign(needed, campaign);
    if (outcome.interrupted > 0) return outcome.exit_status();  // interrupted: skip drawing
  }
  if (options.publish)  // also what an earlier call has simulated
    for (const RunSpec& spec : profile.runs) publish(work, profile, spec, options.out);
  if (options.only_runs) {
    fmt::print("{} simulated, {} had been before, {} failed\n", outcome.finished, outcome.skipped, outcome.failed);
    return outcome.exit_status();
  }

  const Judgement judgement = judge(work, profile, load_claims(work), options.out);

  // Every figure is drawn, also when only some were named: it takes seconds, and the report stays complete.
  const auto figures_folder = options.out / "figures";
  std::filesystem::create_directories(figures_folder);
  std::vector<FigureOutput> outputs;
  for (const auto& figure : work.figures)
    outputs.push_back(
        figure.draw({judgement.shown, judgement.runs, judgement.measurements, figures_folder, options.out}));

  const auto report_folder = options.out / "report";
  auto reported = judgement.runs;
  reported.insert(reported.end(), judgement.left_out.begin(), judgement.left_out.end());
  for (const std::string& own : work.read_by_figures)
    if (profile.name != own)
      for (auto& run : finished_runs(load_profile(work, own), options.out)) reported.push_back(std::move(run));
  reports::write_report(report_contents({work, judgement, reported, outputs, options.out}), figures_folder,
                        report_folder);

  for (const Figure* figure : chosen)
    fmt::print("{}  {:<62}{}\n", figure->id, figure->title, (figures_folder / (figure->id + ".svg")).string());
  fmt::print("\n{}\nreport: {}\n", counts_text(judgement.evaluations), (report_folder / "index.html").string());
  if (outcome.unfinished() > 0)
    fmt::print(stderr, "{} simulation{} did not finish; the figures show what exists. The same command goes on.\n",
               outcome.unfinished(), outcome.unfinished() == 1 ? "" : "s");
  return outcome.exit_status();
}

}  // namespace

void add_figures_command(CLI::App& app, const Works& works) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("figures", "Simulate what is missing, draw the figures, write the report");
  command->add_option("ID", options->ids,
                      "figures to simulate for: " + known_ids(find_work(works, "")) + " (default: all)");
  add_work_option(*command, works, options->work);
  command->add_option(
      "--profile", options->profile,
      "settings of the simulations (`slfb list` shows them; default: " + find_work(works, "").default_profile + ")");
  command->add_option("--jobs", options->jobs, "simulations side by side (default: one per core)")->check(above_zero());
  command->add_option("--threads", options->threads, "threads of each simulation (default: cores over jobs)")
      ->check(above_zero());
  command->add_option("--out", options->out, "folder of runs/, figures/ and report/")->capture_default_str();
  auto* no_run = command->add_flag("--no-run", options->no_run, "simulate nothing, draw with what exists");
  command
      ->add_flag("--only-runs", options->only_runs,
                 "simulate all runs of the profile, or those of the ID; draw nothing")
      ->excludes(no_run);
  command->add_flag("--publish", options->publish,
                    "copy the finished results of the profile to reports/published/WORK/runs, to be committed");
  command->footer(examples);
  command->callback([options, &works] {
    if (const int status = make_figures(find_work(works, options->work), *options); status != 0)
      throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
