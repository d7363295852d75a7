#pragma once

#include <filesystem>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/figures/figure.hpp"
#include "experiments/peng_2014/inconsistencies.hpp"
#include "experiments/runs/campaign.hpp"

namespace slfb {

/// What the report shows, beside the catalogue of laws.
struct ReportContents {
  const Profile& profile;  ///< asked for
  const Profile& shown;    ///< the same with what it lacks of the full one (with_full_runs)
  const std::vector<FinishedRun>& runs;
  const std::vector<FigureOutput>& figures;  ///< what drawing slfb::figures() left
  const std::vector<Evaluation>& evaluations;
  const std::vector<Inconsistency>& inconsistencies;
  const std::filesystem::path& out;  ///< folder of runs/
};

/// Writes `folder`/index.html and the pages that it leads to, and copies every file of the figures from
/// `figures_folder` to `folder`/figures and the results of the runs to `folder`/runs, so that the report is one folder
/// that can be moved, opened offline and read on a phone. Throws std::runtime_error naming the file that cannot be read
/// or written.
void write_report(const ReportContents& contents, const std::filesystem::path& figures_folder,
                  const std::filesystem::path& folder);

}  // namespace slfb
