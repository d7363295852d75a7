#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/budget.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/compute_studies.hpp"
#include "experiments/commands/report_inputs.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/runs/progress_display.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/decide.hpp"
#include "experiments/work/judge.hpp"
#include "experiments/work/more_runs.hpp"
#include "experiments/work/report_pages.hpp"
#include "reports/report.hpp"
#include "solver/support/close_names.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

constexpr const char* examples = R"(Examples:
  slfb figures                     the report from what exists, then simulate what is missing, then the report again
  slfb figures fig10 fig25         simulate what these two need and draw these two; the report stays as it is
  slfb figures --no-run            draw with what exists; takes seconds
  slfb figures --studies quick     after the simulations also the charts of methods (slfb frontier, slfb stability)
  slfb figures --profile full      the settings of the full campaign; takes hours, may be interrupted
  slfb figures --profile NAME --only-runs --publish   simulate a profile and keep its results; draw nothing
  slfb figures --jobs 1 --threads 2   one simulation at a time on two cores
  slfb figures --decide --budget 30min     more drops and beds where a claim is not decided, the cheapest first
  slfb figures --decide table2 --budget 0  what each undecided claim of table2 lacks, and what it would cost

Results are kept in DIR/runs and named by their scene: a second call simulates nothing twice, and after an
interruption the same command goes on where it was. A picture is drawn again only where its numbers have changed.
`slfb list` shows the figures and the runs of each profile.)";

struct Options {
  std::string work;
  std::vector<std::string> ids;
  std::string profile;
  std::string studies;  // "": none
  int jobs = 0;         // 0: as many as there are cores or runs
  int threads = 0;      // 0: share the cores among the jobs
  std::filesystem::path out = build_folder();
  bool no_run = false;
  bool only_runs = false;
  bool publish = false;
  bool open = false;
  std::vector<std::string> decide;  ///< beginnings of the ids of claims
  std::string budget = "30 min";
};

/// The named figures, or all of them. Throws CLI::ValidationError listing the known ones on an unknown name.
std::vector<const Figure*> choose(const Work& work, const std::vector<std::string>& ids) {
  std::vector<std::string> known;
  for (const auto& figure : work.figures) known.push_back(figure.id);
  for (const auto& id : ids)
    if (std::ranges::find(known, id) == known.end())
      throw CLI::ValidationError("ID", fmt::format("there is no figure \"{}\"{}; known: {}", id,
                                                   did_you_mean(id, known), fmt::join(known, ", ")));
  std::vector<const Figure*> chosen;
  for (const auto& figure : work.figures)
    if (ids.empty() || std::ranges::find(ids, figure.id) != ids.end()) chosen.push_back(&figure);
  return chosen;
}

/// The runs of a profile that the figures draw, or with `all` every run of it, and that have no result yet.
std::vector<RunSpec> missing_runs(const std::vector<const Figure*>& chosen, const Profile& profile, bool all,
                                  const std::filesystem::path& out) {
  std::set<std::string> keys;
  if (all)
    for (const RunSpec& spec : profile.runs) keys.insert(run_key(spec));
  for (const Figure* figure : chosen)
    for (auto& key : figure->needs(profile)) keys.insert(std::move(key));
  if (profile.goes_on_from_published)
    for (const FinishedRun& run : published_runs(profile)) keys.erase(run_key(run.spec));
  std::vector<RunSpec> missing;
  for (const auto& spec : profile.runs)
    if (keys.contains(run_key(spec)) && !std::filesystem::exists(result_file(out, scene_hash(load_run_scene(spec)))))
      missing.push_back(spec);
  return missing;
}

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

CampaignOptions campaign_options(const Options& options, std::size_t runs, const std::string& heading) {
  const int jobs = options.jobs > 0 ? options.jobs : std::clamp(static_cast<int>(runs), 1, cores());
  const int threads = options.threads > 0 ? options.threads : std::max(1, cores() / jobs);
  return {.out = options.out, .jobs = jobs, .threads_per_run = threads, .progress = true, .heading = heading};
}

/// Puts a finished result of a profile where it can be committed; figures use it where nothing is simulated.
void publish(const Work& work, const Profile& profile, const RunSpec& spec, const std::filesystem::path& out) {
  const std::string hash = scene_hash(load_run_scene(spec));
  if (std::filesystem::exists(result_file(out, hash)))
    publish_result(spec, load_own_result(out, hash), profile.whole.contains(run_key(spec)), work.measuring);
}

/// Claims whose ids begin with one of `ids`; all when there are none.
std::vector<Claim> claims_to_decide(const Work& work, const std::vector<std::string>& ids) {
  std::vector<Claim> claims = load_claims(work);
  for (const std::string& id : ids)
    if (std::ranges::none_of(claims, [&](const Claim& claim) { return claim.id.starts_with(id); }))
      throw CLI::ValidationError("--decide", fmt::format("no claim begins with \"{}\"", id));
  if (!ids.empty())
    std::erase_if(claims, [&](const Claim& claim) {
      return std::ranges::none_of(ids, [&](const std::string& id) { return claim.id.starts_with(id); });
    });
  return claims;
}

/// Returns the exit status.
int decide_claims(const Work& work, const Options& options) {
  const Profile profile = load_profile(work, options.profile.empty() ? work.default_profile : options.profile);
  const double budget = budget_seconds(options.budget);
  int failed = 0;
  const auto simulate = [&](const std::vector<RunSpec>& specs) -> std::optional<double> {
    const CampaignOutcome ended = run_campaign(specs, campaign_options(options, specs.size(), "more runs"));
    failed += ended.failed;
    if (ended.unfinished() > 0) return std::nullopt;
    double spent = 0.0;
    for (const RunSpec& spec : specs)
      spent += load_own_result(options.out, scene_hash(load_run_scene(spec))).cpu_seconds;
    return spent;
  };
  DecideWorld world = world_of(work, profile, claims_to_decide(work, options.decide), options.out, simulate);
  world.begin = [](const Evaluation& evaluation, const NextStep& step) {
    fmt::print(stderr, "{}: {} run{}, about {} of one core\n", evaluation.claim.id, step.specs.size(),
               step.specs.size() == 1 ? "" : "s", format_duration(step.core_seconds));
  };
  const DecideOutcome outcome = decide(world, load_more_runs(work, options.out), budget);
  if (options.publish) {
    for (const RunSpec& spec : with_more_runs(with_shown_runs(work, profile), outcome.more).runs)
      publish(work, profile, spec, options.out);
    save_more_runs(outcome.more, published_more_runs_file(work));
  }
  fmt::print("{}", decide_text(outcome));
  return failed > 0 ? 1 : outcome.interrupted ? 130 : 0;
}

/// Numbers the steps of one call: "step 2 of 3, simulations".
class Steps {
 public:
  explicit Steps(int all) : all_(all) {}

  /// Begins the next step and says what it does.
  void begin(const std::string& name, const std::string& what) {
    heading_ = fmt::format("step {} of {}, {}", ++now_, all_, name);
    if (all_ > 1) fmt::print(stderr, "Step {} of {}: {}\n", now_, all_, what);
  }
  [[nodiscard]] const std::string& heading() const { return heading_; }

 private:
  int all_, now_ = 0;
  std::string heading_;
};

/// Draws the chosen figures with what exists.
std::vector<FigureOutput> draw(const std::vector<const Figure*>& chosen, const Judgement& judgement,
                               const std::filesystem::path& out, const std::string& heading) {
  const auto folder = out / "figures";
  make_output_folder(folder);
  remove_unfinished(folder);
  std::vector<ProgressDisplay::Job> jobs;
  for (const Figure* figure : chosen) jobs.push_back({figure->id});
  ProgressDisplay display(std::move(jobs), 1, true, heading);
  const DisplayRefresher refresher(display);
  std::vector<FigureOutput> outputs;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    display.start(i);
    try {
      outputs.push_back(chosen[i]->draw({judgement.shown, judgement.runs, judgement.measurements, folder, out}));
      display.end(i, "");
    } catch (const std::exception& error) {  // a damaged file of one figure; the others go on
      spdlog::error("{} is not drawn: {}", chosen[i]->id, error.what());
      display.end(i, "not drawn");
    }
  }
  return outputs;
}

struct Drawn {
  Judgement judgement;
  bool complete = true;  ///< false if a figure could not be drawn
};

/// Judges the claims, draws the figures and, where all of them are asked for, writes the report.
Drawn judge_and_draw(const Work& work, const Profile& profile, const std::vector<const Figure*>& chosen,
                     const Options& options, const std::string& heading) {
  Judgement judgement = judge(work, profile, load_claims(work), options.out);
  const auto outputs = draw(chosen, judgement, options.out, heading);
  const bool complete = outputs.size() == chosen.size();
  if (!options.ids.empty()) return {std::move(judgement), complete};
  auto reported = judgement.runs;
  reported.insert(reported.end(), judgement.left_out.begin(), judgement.left_out.end());
  for (const std::string& own : work.read_by_figures)
    if (profile.name != own)
      for (auto& run : finished_runs(load_profile(work, own), options.out)) reported.push_back(std::move(run));
  reports::write_report(report_contents({work, judgement, reported, outputs, options.out}), options.out / "figures",
                        options.out / "report");
  return {std::move(judgement), complete};
}

/// Shows a page where there is a desktop; its own messages are not of interest.
void open_page(const std::filesystem::path& page) {
  if (getenv("CI") != nullptr || (getenv("DISPLAY") == nullptr && getenv("WAYLAND_DISPLAY") == nullptr)) return;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string program = "xdg-open", argument = page.string();
  const std::array<char*, 3> words{program.data(), argument.data(), nullptr};
  pid_t process = 0;
  posix_spawnp(&process, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
}

/// Claims whose verdict is another than before, one line each.
std::string changed_verdicts(const std::vector<Evaluation>& before, const std::vector<Evaluation>& now) {
  std::map<std::string, Verdict> old;
  for (const Evaluation& evaluation : before) old[evaluation.claim.id] = evaluation.verdict;
  std::string text;
  for (const Evaluation& evaluation : now)
    if (const auto found = old.find(evaluation.claim.id); found != old.end() && found->second != evaluation.verdict)
      text += fmt::format("  {}: {}, before: {}\n", evaluation.claim.id, to_string(evaluation.verdict),
                          to_string(found->second));
  return text.empty() ? "No verdict has changed.\n" : "Verdicts that have changed:\n" + text;
}

/// Simulates and draws nothing. Returns the exit status.
int only_simulate(const Work& work, const Profile& profile, const std::vector<RunSpec>& missing,
                  const Options& options) {
  CampaignOptions campaign = campaign_options(options, missing.size(), "");
  if (options.publish) campaign.finished = [&](std::size_t k) { publish(work, profile, missing[k], options.out); };
  const CampaignOutcome outcome = missing.empty() ? CampaignOutcome{} : run_campaign(missing, campaign);
  if (options.publish)  // also what an earlier call has simulated
    for (const RunSpec& spec : profile.runs) publish(work, profile, spec, options.out);
  if (missing.empty())
    fmt::print("nothing to simulate: every result exists\n");
  else
    fmt::print("{} simulated, {} failed\n", outcome.finished, outcome.failed);
  return outcome.exit_status();
}

/// Simulates, draws and reports what is asked. Returns the exit status, which tells of simulations that failed or were
/// interrupted.
int make_figures(const Work& work, const Options& options) {
  const auto chosen = choose(work, options.ids);
  const bool all = options.ids.empty();
  const Profile profile = load_profile(work, options.profile.empty() ? work.default_profile : options.profile);
  const auto missing =
      options.no_run ? std::vector<RunSpec>{} : missing_runs(chosen, profile, options.only_runs && all, options.out);
  if (options.only_runs) return only_simulate(work, profile, missing, options);
  const bool with_studies = all && !options.no_run && !options.studies.empty();
  if (options.publish)  // what an earlier call has simulated
    for (const RunSpec& spec : profile.runs) publish(work, profile, spec, options.out);

  const auto page = options.out / "report" / "index.html";
  Steps steps((all || missing.empty() ? 1 : 0) + (missing.empty() ? 0 : 1) + (with_studies ? 1 : 0));
  Drawn drawn;
  const auto note = options.out / "report" / "drawn_from.txt";
  const auto is_drawn = [&] {
    return all && missing.empty() && std::filesystem::exists(note) && std::filesystem::exists(page) &&
           read_file(note).starts_with(report_inputs(work.id, profile.name, options.out));
  };
  const bool nothing_new = is_drawn();
  if ((all || missing.empty()) && !nothing_new) {
    steps.begin("drawing", "the report from the results that exist");
    drawn = judge_and_draw(work, profile, chosen, options, steps.heading());
    if (all && (!missing.empty() || with_studies)) fmt::print(stderr, "report: {}\n", page.string());
    if (all && options.open) open_page(page);
  }
  const std::vector<Evaluation> before = drawn.judgement.evaluations;

  CampaignOutcome outcome;
  if (!missing.empty()) {
    steps.begin("simulations", fmt::format("{} simulations of profile {}", missing.size(), profile.name));
    CampaignOptions campaign = campaign_options(options, missing.size(), steps.heading());
    if (options.publish) campaign.finished = [&](std::size_t k) { publish(work, profile, missing[k], options.out); };
    outcome = run_campaign(missing, campaign);
    if (outcome.interrupted > 0) return outcome.exit_status();  // interrupted: skip drawing
    drawn = judge_and_draw(work, profile, chosen, options, steps.heading() + ", drawing");
  }
  if (with_studies) {
    steps.begin("charts of methods", fmt::format("charts of methods, set {}", options.studies));
    const int jobs = options.jobs > 0 ? options.jobs : cores();
    if (!compute_studies(studies::set_named(options.studies), options.out, jobs, steps.heading())) {
      fmt::print(stderr, "Interrupted: the same command goes on where this one stopped.\n");
      return 130;
    }
    if (!nothing_new || !is_drawn())
      drawn = judge_and_draw(work, profile, chosen, options, steps.heading() + ", drawing");
  }
  if (nothing_new && is_drawn()) {
    const std::string kept = read_file(note);
    fmt::print("{}Nothing is new: the report is as it was.\nreport: {}\n", kept.substr(kept.find('\n') + 1),
               page.string());
    return 0;
  }

  if (!all)
    for (const Figure* figure : chosen)
      fmt::print("{}  {:<62}{}\n", figure->id, figure->title,
                 (options.out / "figures" / (figure->id + ".svg")).string());
  if (all) {
    fmt::print("{}\n", counts_text(drawn.judgement.evaluations));
    if (drawn.complete)
      write_file(note, report_inputs(work.id, profile.name, options.out) + "\n" +
                           counts_text(drawn.judgement.evaluations) + "\n");
    if (!missing.empty() || with_studies) fmt::print("{}", changed_verdicts(before, drawn.judgement.evaluations));
    fmt::print("report: {}\n", page.string());
  }
  if (outcome.unfinished() > 0)
    fmt::print(stderr, "{} simulation{} did not finish; the figures show what exists. The same command goes on.\n",
               outcome.unfinished(), outcome.unfinished() == 1 ? "" : "s");
  return outcome.exit_status() == 0 && !drawn.complete ? 1 : outcome.exit_status();
}

}  // namespace

void add_figures_command(CLI::App& app, const Works& works) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("figures", "Simulate what is missing, draw the figures, write the report");
  command->add_option(
      "ID", options->ids,
      "figures to draw, and to simulate for, such as fig05 (`slfb list` shows them; default: all of them "
      "and the report)");
  add_work_option(*command, works, options->work);
  command->add_option(
      "--profile", options->profile,
      "settings of the simulations (`slfb list` shows them; default: " + find_work(works, "").default_profile + ")");
  command->add_option("--jobs", options->jobs, "simulations side by side (default: one per core)")->check(above_zero());
  command->add_option("--threads", options->threads, "threads of each simulation (default: cores over jobs)")
      ->check(above_zero());
  command->add_option("--out", options->out, "folder of runs/, figures/ and report/")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--studies", options->studies, "charts of methods too: how much of them to compute")
      ->check(CLI::IsMember({"quick", "full"}));
  auto* no_run = command->add_flag("--no-run", options->no_run, "simulate nothing, draw with what exists");
  command
      ->add_flag("--only-runs", options->only_runs,
                 "simulate all runs of the profile, or those of the ID; draw nothing")
      ->excludes(no_run);
  command->add_flag("--open", options->open, "show the report as soon as it is there, where there is a desktop");
  auto* decide = command
                     ->add_option("--decide", options->decide,
                                  "simulate more drops, beds or time where claims are not decided, the cheapest first "
                                  "(CLAIM: what their ids begin with; default: all); draws nothing")
                     ->expected(0, -1)
                     ->option_text("[CLAIM ...]")
                     ->excludes(no_run);
  command->add_option("--budget", options->budget, "CPU time that --decide may spend (default: 30 min; 0: only tell)")
      ->option_text("TIME")
      ->needs(decide);
  command->add_flag("--publish", options->publish,
                    "copy the finished results of the profile to reports/published/WORK/runs, to be committed");
  command->footer(examples);
  command->callback([options, decide, &works] {
    std::erase(options->decide, "");  // what the option has without a CLAIM
    const Work& work = find_work(works, options->work);
    if (const int status = decide->count() > 0 ? decide_claims(work, *options) : make_figures(work, *options);
        status != 0)
      throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
