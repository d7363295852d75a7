#pragma once

#include <filesystem>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/figures/figure.hpp"
#include "experiments/runs/campaign.hpp"
#include "reports/report_contents.hpp"

/// From evaluations, runs and figures to the plain values that the report shows.
namespace slfb {

/// What `slfb figures` has at hand when all is drawn.
struct ReportInputs {
  const Profile& profile;                    ///< asked for
  const Profile& shown;                      ///< the same with what it lacks of the full one (with_full_runs)
  const std::vector<FinishedRun>& runs;      ///< of `shown` and of the profiles that figures read by themselves
  const std::vector<Figure>& figures;        ///< of the work
  const std::vector<FigureOutput>& outputs;  ///< what drawing them left, in the same order
  const std::vector<Evaluation>& evaluations;
  const std::filesystem::path& out;  ///< folder of runs/
};

reports::ClaimRow claim_row(const Evaluation& evaluation);

/// \param out folder of runs/, where the results of this machine lie
reports::RunRow run_row(const FinishedRun& run, const std::filesystem::path& out);

/// All of the report but the texts of the work and its inconsistencies. Reads the README.md of each figure's folder;
/// throws std::runtime_error naming it where it cannot be read, or where an output belongs to no figure.
reports::ReportContents report_contents(const ReportInputs& inputs);

}  // namespace slfb
