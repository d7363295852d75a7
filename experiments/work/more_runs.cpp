#include "experiments/work/more_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "solver/support/files.hpp"

namespace slfb {
namespace {

bool same_run(const MoreRun& a, const MoreRun& b) {
  return a.profile == b.profile && a.system == b.system && a.superficial_velocity == b.superficial_velocity &&
         a.variant == b.variant && a.seed == b.seed;
}

MoreRuns load(const std::filesystem::path& file) {
  MoreRuns more;
  if (!std::filesystem::exists(file)) return more;
  try {
    const auto json = nlohmann::json::parse(read_file(file));
    for (const auto& run : json.at("runs"))
      more.runs.push_back({run.at("profile"), run.at("system"), run.at("superficial_velocity"), run.at("variant"),
                           run.at("seed"), run.at("overrides")});
    for (const auto& [claim, look] : json.at("looks").items()) more.looks[claim] = look.get<int>();
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not a list of runs: {}", file.string(), error.what()));
  }
  return more;
}

}  // namespace

std::filesystem::path more_runs_file(const std::filesystem::path& out, const Work& work) {
  return out / "runs" / fmt::format("more_{}.json", work.id);
}

std::filesystem::path published_more_runs_file(const Work& work) {
  return work.folders.published.parent_path() / "more_runs.json";
}

MoreRuns load_more_runs(const Work& work, const std::filesystem::path& out) {
  MoreRuns more = work.folders.published.empty() ? MoreRuns{} : load(published_more_runs_file(work));
  const MoreRuns own = load(more_runs_file(out, work));
  for (const MoreRun& run : own.runs)
    if (std::ranges::none_of(more.runs, [&](const MoreRun& other) { return same_run(run, other); }))
      more.runs.push_back(run);
  for (const auto& [claim, look] : own.looks) {
    int& known = more.looks[claim];
    known = std::max(known, look);
  }
  return more;
}

void save_more_runs(const MoreRuns& more, const std::filesystem::path& file) {
  nlohmann::ordered_json json;
  json["runs"] = nlohmann::ordered_json::array();
  for (const MoreRun& run : more.runs)
    json["runs"].push_back({{"profile", run.profile},
                            {"system", run.system},
                            {"superficial_velocity", run.superficial_velocity},
                            {"variant", run.variant},
                            {"seed", run.seed},
                            {"overrides", run.overrides}});
  json["looks"] = nlohmann::ordered_json::object();
  for (const auto& [claim, look] : more.looks) json["looks"][claim] = look;
  std::filesystem::create_directories(file.parent_path());
  write_file(file, json.dump(1) + "\n");
}

RunSpec once_more(RunSpec base, const MoreRun& more) {
  base.overrides.insert(base.overrides.end(), more.overrides.begin(), more.overrides.end());
  base.overrides.push_back(fmt::format("seed={}", more.seed));
  base.seed = more.seed;
  return base;
}

Profile with_more_runs(Profile profile, const MoreRuns& more) {
  const std::vector<RunSpec> own = profile.runs;
  const auto repeats = [](const RunSpec& spec, const MoreRun& run) {
    return spec.profile == run.profile && spec.system == run.system && spec.variant == run.variant &&
           velocity_text(spec.superficial_velocity) == velocity_text(run.superficial_velocity);
  };
  for (const MoreRun& run : more.runs) {
    // A profile may have got this bed since: it stays one bed.
    if (run.overrides.empty() &&
        std::ranges::any_of(own, [&](const RunSpec& spec) { return repeats(spec, run) && spec.seed == run.seed; }))
      continue;
    const auto base = std::ranges::find_if(own, [&](const RunSpec& spec) { return !spec.seed && repeats(spec, run); });
    if (base != own.end()) profile.runs.push_back(once_more(*base, run));
  }
  return profile;
}

}  // namespace slfb
