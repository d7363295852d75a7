#pragma once

#include <filesystem>
#include <vector>

#include "experiments/work/judge.hpp"
#include "experiments/work/work.hpp"
#include "reports/report_contents.hpp"

/// From evaluations, runs and figures to the plain values that the report shows.
namespace slfb {

/// What `slfb figures` has at hand when all is drawn.
struct ReportInputs {
  const Work& work;
  const Judgement& judgement;
  const std::vector<FinishedRun>& runs;      ///< of the judgement and of the profiles that figures read by themselves
  const std::vector<FigureOutput>& outputs;  ///< what drawing the figures of the work left
  const std::filesystem::path& out;          ///< folder of runs/
};

/// The verdict as the pages name it.
reports::Verdict shown(Verdict verdict);

/// One claim as a row of a page.
reports::ClaimRow claim_row(const Evaluation& evaluation);

/// \param out folder of runs/, where the results of this machine lie
reports::RunRow run_row(const FinishedRun& run, const std::filesystem::path& out);

/// The whole report. Reads the README.md of each figure's folder; throws std::runtime_error naming it where it cannot
/// be read, or where an output belongs to no figure.
reports::ReportContents report_contents(const ReportInputs& inputs);

}  // namespace slfb
