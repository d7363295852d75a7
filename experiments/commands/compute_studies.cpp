#include "experiments/commands/compute_studies.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "experiments/numerics/frontier/study.hpp"
#include "experiments/numerics/stability/map.hpp"
#include "experiments/runs/progress_display.hpp"

namespace slfb {
namespace {

/// A boundary is found by about so many trials: the ends of the range, then halving it.
constexpr double trials_of_boundary = 8.0;

}  // namespace

bool compute_studies(studies::Set set, const std::filesystem::path& out, int jobs, const std::string& heading) {
  const studies::TrialStore store(out / "trials");
  std::vector<frontier::Study> all_studies;
  std::vector<stability::Map> maps;
  std::vector<ProgressDisplay::Job> shown;
  for (const auto& file : frontier::study_files()) {
    all_studies.push_back(frontier::load_study(file, set));
    shown.push_back({all_studies.back().id, static_cast<double>(frontier::trials_of(all_studies.back()).size())});
  }
  for (const auto& file : stability::map_files()) {
    maps.push_back(stability::load_map(file, set));
    shown.push_back({maps.back().id, trials_of_boundary * static_cast<double>(stability::boundaries_of(maps.back()))});
  }
  std::filesystem::create_directories(out / "frontier");
  ProgressDisplay display(std::move(shown), 1, true, heading);  // one after the other, each on all cores
  const DisplayRefresher refresher(display);
  std::size_t job = 0;
  for (const frontier::Study& study : all_studies) {
    display.start(job);
    const bool whole = studies::solve_missing(
        frontier::trials_of(study), store,
        {.jobs = jobs, .solved = [&](std::size_t done, std::size_t all, const auto&, const auto&) {
           display.update(job, static_cast<double>(done) / static_cast<double>(all),
                          fmt::format("{} of {} trials", done, all));
         }});
    if (!whole) return false;
    frontier::keep_if_whole(study, set, store, out);
    display.end(job++, "");
  }
  for (const stability::Map& map : maps) {
    display.start(job);
    std::size_t done = 0;
    const auto all = stability::boundaries_of(map);
    const bool whole = stability::solve_map(map, set, out, jobs, [&](const stability::Boundary&) {
                         display.update(job, static_cast<double>(++done) / static_cast<double>(all),
                                        fmt::format("{} of {} boundaries", done, all));
                       }).whole;
    if (!whole) return false;
    display.end(job++, "");
  }
  return true;
}

}  // namespace slfb
