#pragma once

#include <filesystem>

#include "reports/report_contents.hpp"

namespace slfb::reports {

/// Writes the whole report: `folder`/index.html, the pages that it leads to, and print.html with all of them.
///
/// Copies every file of the figures from `figures_folder` to `folder`/figures and the results of the runs to
/// `folder`/runs, so that the report is one folder that can be moved, opened offline and read on a phone. Throws
/// std::runtime_error naming the file that cannot be read, copied or written.
void write_report(const ReportContents& contents, const std::filesystem::path& figures_folder,
                  const std::filesystem::path& folder);

}  // namespace slfb::reports
