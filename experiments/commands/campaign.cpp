#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/run_entries.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples = R"(Examples:
  slfb campaign full --to make > full.mk          then: make -f full.mk -j 8
  slfb campaign full --to snakemake > Snakefile   then: snakemake --cores 8 --keep-going
  slfb campaign full --to slurm > full.sh         then: sh full.sh, on the machine where sbatch is
  slfb campaign merge machine-1 machine-2         bring the results of several machines together, in DIR/runs

The jobs are the runs of the profile that have no result in DIR/runs, and, when all are done, the figures and the
claims. Many machines may write to one DIR: each run has a folder of its own and a lock in it. A run that is killed is
started again, three times at most, and goes on from its last checkpoint; the other runs are not touched. With Slurm, a
run that needs more time than asked for saves its state and is put into the queue again, five times at most. Whatever
else happens: write the jobs again, and they are the runs that are still to do.
A result is refused by merge if its numerics version is not that of this program, or if its scene is not the one that its
name stands for.)";

/// How often a run is started where it is killed each time. The status of a killed one is 137 (128 + SIGKILL).
constexpr int tries = 4;

struct Options {
  std::string profile, to, work;
  std::vector<fs::path> folders;
  fs::path out = fs::absolute(build_folder());
  int threads = 1;
};

/// What a scheduler starts.
struct Jobs {
  std::string program, profile;
  fs::path out;
  int threads;
  std::vector<RunEntry> runs;

  [[nodiscard]] std::string run(const std::string& key) const {
    return fmt::format("'{}' run --profile {} {} --threads {} --out '{}'", program, profile, key, threads,
                       out.string());
  }
  [[nodiscard]] std::vector<std::string> last() const {
    return {fmt::format("'{}' figures --profile {} --no-run --out '{}'", program, profile, out.string()),
            fmt::format("'{}' check --profile {} --out '{}'", program, profile, out.string())};
  }
  /// Minutes to ask for: three times the estimate, since another machine may be slower, and ten.
  [[nodiscard]] int minutes(const RunEntry& entry) const {
    return 10 + static_cast<int>(std::ceil(3.0 * entry.core_seconds / threads / 60.0));
  }
};

/// "1 2 3" for 3.
std::string numbers_to(int last) {
  std::string text = "1";
  for (int number = 2; number <= last; ++number) text += fmt::format(" {}", number);
  return text;
}

std::string as_make(const Jobs& jobs) {
  std::string results, keys, last;
  for (const RunEntry& entry : jobs.runs) {
    const std::string result = result_file(jobs.out, entry.hash).string();
    results += " \\\n  " + result;
    keys += fmt::format("{}: key = {}\n", result, entry.key);
  }
  for (const std::string& command : jobs.last()) last += "\t" + command + "\n";
  std::string text =
      fmt::format(R"(# The runs of profile {profile}, then its figures and claims: make -f FILE -j N
# A run that fails does not stop the others.
MAKEFLAGS += --keep-going
results ={results}

.PHONY: all
all: $(results)
{last})",
                  fmt::arg("profile", jobs.profile), fmt::arg("results", results), fmt::arg("last", last));
  if (jobs.runs.empty()) return text;
  return text + fmt::format(R"(
# A run that is killed (status 137) goes on from its last checkpoint.
$(results):
	@for try in {tries}; do {run}; status=$$?; \
	  [ $$status -eq 137 ] || exit $$status; done; exit 137

{keys})",
                            fmt::arg("tries", numbers_to(tries)), fmt::arg("run", jobs.run("$(key)")),
                            fmt::arg("keys", keys));
}

std::string as_snakemake(const Jobs& jobs) {
  std::string runs, last;
  for (const RunEntry& entry : jobs.runs)
    runs += fmt::format("    \"{}\": (\"{}\", {}),\n", entry.hash, entry.key, jobs.minutes(entry));
  for (const std::string& command : jobs.last()) last += fmt::format("{}{}", last.empty() ? "" : " && ", command);
  return fmt::format(
      R"(# The runs of profile {profile}, then its figures and claims: snakemake --cores N --keep-going
# If snakemake itself was killed: snakemake --unlock, then the same with --ignore-incomplete (a result is written whole
# or not at all).
# Hash of a run: its key, and the minutes that it may take.
RUNS = {{
{runs}}}
OUT = "{out}"

rule all:
    input: expand(OUT + "/runs/{{hash}}/result.h5", hash=RUNS)
    shell: "{last}"

rule run:
    output: OUT + "/runs/{{hash}}/result.h5"
    params: key=lambda wildcards: RUNS[wildcards.hash][0]
    retries: {retries}  # a run that is killed goes on from its last checkpoint
    threads: {threads}
    resources: runtime=lambda wildcards: RUNS[wildcards.hash][1]
    shell: "'{program}' run --profile {profile} {{params.key}} --threads {{threads}} --out '{out}'"
)",
      fmt::arg("profile", jobs.profile), fmt::arg("runs", runs), fmt::arg("out", jobs.out.string()),
      fmt::arg("last", last), fmt::arg("threads", jobs.threads), fmt::arg("program", jobs.program),
      fmt::arg("retries", tries - 1));
}

/// An array of jobs and one that waits for it. A job that runs out of time is told so two minutes before (SIGUSR1),
/// saves its state and asks for another turn. The shell passes signals on as SIGINT: Slurm sends SIGTERM to the shell
/// and to the run, and a run that is told the same twice ends without saving.
std::string as_slurm(const Jobs& jobs) {
  if (jobs.runs.empty()) return fmt::format("#!/bin/sh\nset -e\n{}\n{}\n", jobs.last()[0], jobs.last()[1]);
  std::string keys;
  int minutes = 0;
  for (const RunEntry& entry : jobs.runs) {
    keys += entry.key + "\n";
    minutes = std::max(minutes, jobs.minutes(entry));
  }
  return fmt::format(
      R"(#!/bin/sh
# The runs of profile {profile} as an array, then its figures and claims: sh FILE
set -e
mkdir -p '{out}'
job=$(sbatch --parsable <<'JOB'
#!/bin/sh
#SBATCH --job-name=slfb-{profile}
#SBATCH --array=1-{count}
#SBATCH --cpus-per-task={threads}
#SBATCH --time={minutes}
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output={out}/slurm-%A_%a.log
key=$(sed -n "${{SLURM_ARRAY_TASK_ID}}p" <<'RUNS'
{keys}RUNS
)
told= run=
trap 'told=stop; kill -INT $run' TERM
trap 'told=time; kill -INT $run' USR1
for try in {tries}; do
  {run} &
  run=$!
  wait $run
  status=$?
  # A signal ends the wait; the run is still saving its state then.
  [ -z "$told" ] || {{ wait $run; status=$?; }}
  # A run that is killed goes on from its last checkpoint.
  [ -z "$told" ] && [ $status -eq 137 ] || break
  echo "slfb was killed: $key, try $try of {last_try}"
done
if [ "$told" = time ] && [ $status -ne 0 ] && [ "${{SLURM_RESTART_COUNT:-0}}" -lt 5 ]; then
  echo "out of time, put into the queue again: $key"
  scontrol requeue "$SLURM_JOB_ID"
fi
exit $status
JOB
)
# It runs after failed runs too and says what is missing then.
sbatch --dependency=afterany:"$job" --job-name=slfb-{profile}-report --output='{out}/slurm-%j.log' <<'JOB'
#!/bin/sh
{first}
{second}
JOB
)",
      fmt::arg("profile", jobs.profile), fmt::arg("out", jobs.out.string()), fmt::arg("count", jobs.runs.size()),
      fmt::arg("threads", jobs.threads), fmt::arg("minutes", minutes), fmt::arg("keys", keys),
      fmt::arg("run", jobs.run("\"$key\"")), fmt::arg("tries", numbers_to(tries)), fmt::arg("last_try", tries),
      fmt::arg("first", jobs.last()[0]), fmt::arg("second", jobs.last()[1]));
}

void write_campaign(const Options& options) {
  const Profile profile = load_profile(find_work(works(), options.work), options.profile);
  Jobs jobs{fs::read_symlink("/proc/self/exe").string(),
            profile.name,
            fs::absolute(options.out).lexically_normal(),
            options.threads,
            {}};
  for (RunEntry& entry : run_entries(profile, options.out))
    if (entry.needed) jobs.runs.push_back(std::move(entry));
  // The longest first, so that the last to end are short.
  std::ranges::stable_sort(jobs.runs, std::ranges::greater{}, &RunEntry::core_seconds);
  fmt::print("{}", options.to == "make"        ? as_make(jobs)
                   : options.to == "snakemake" ? as_snakemake(jobs)
                                               : as_slurm(jobs));
}

/// Why a result does not belong under this name; empty if it does.
std::string objection(const RunResult& result, const std::string& hash) {
  if (result.numerics != numerics_version)
    return fmt::format("its numerics version is {}, that of this program {}", result.numerics, numerics_version);
  const std::string own = scene_hash(parse_scene(result.scene_text, hash));
  if (result.name != hash || own != hash) return fmt::format("it holds the scene {}, its folder says {}", own, hash);
  return "";
}

void merge(const Options& options) {
  std::size_t taken = 0, known = 0;
  std::vector<std::pair<fs::path, fs::path>> copies;
  // Everything is looked at before anything is copied.
  for (const fs::path& folder : options.folders) {
    const fs::path runs = fs::is_directory(folder / "runs") ? folder / "runs" : folder;
    if (!fs::is_directory(runs))
      throw CLI::ValidationError("FOLDER", fmt::format("there is no folder {}", runs.string()));
    std::vector<fs::path> results;
    for (const auto& entry : fs::directory_iterator(runs))
      if (fs::exists(entry.path() / "result.h5")) results.push_back(entry.path() / "result.h5");
    std::ranges::sort(results);
    if (results.empty()) throw std::runtime_error(fmt::format("{} holds no result", runs.string()));
    for (const fs::path& file : results) {
      const std::string hash = file.parent_path().filename().string();
      if (const std::string why = objection(load_result(file), hash); !why.empty())
        throw std::runtime_error(fmt::format("{}: {}; nothing was merged", file.string(), why));
      const fs::path to = result_file(options.out, hash);
      if (fs::exists(to))
        ++known;
      else
        copies.emplace_back(file, to);
    }
  }
  for (const auto& [from, to] : copies) {
    if (fs::exists(to)) {  // two of the folders hold it
      ++known;
      continue;
    }
    fs::create_directories(to.parent_path());
    const fs::path half = to.parent_path() / "result.h5.merged";
    fs::copy_file(from, half, fs::copy_options::overwrite_existing);
    fs::rename(half, to);
    ++taken;
  }
  fmt::print("{} results merged into {}, {} had been there\n", taken, (options.out / "runs").string(), known);
}

}  // namespace

void add_campaign_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("campaign", "Runs of a profile as jobs of make, snakemake or Slurm; merge results");
  command->add_option("PROFILE", options->profile, "whose runs; or the word merge")->required();
  command->add_option("FOLDER", options->folders, "with merge: folders with runs/ of other machines");
  command->add_option("--to", options->to, "what to write, on standard output")
      ->check(CLI::IsMember({"make", "snakemake", "slurm"}));
  command->add_option("--threads", options->threads, "threads of each run")->check(above_zero())->capture_default_str();
  command->add_option("--out", options->out, "folder of runs/, which all machines see")->option_text("DIR");
  add_work_option(*command, works(), options->work);
  command->footer(examples);
  command->callback([options] {
    if (options->profile == "merge") {
      if (options->folders.empty()) throw CLI::ValidationError("FOLDER", "merge needs folders with runs/");
      return merge(*options);
    }
    if (!options->folders.empty()) throw CLI::ValidationError("FOLDER", "only merge takes folders");
    if (options->to.empty()) throw CLI::ValidationError("--to", "say for what: make, snakemake or slurm");
    write_campaign(*options);
  });
}

}  // namespace slfb
