#pragma once

#include <filesystem>
#include <string>

#include "reports/report.hpp"

namespace slfb {

/// All figures side by side, each a link to its page, for the first page of the report.
std::string figure_gallery(const ReportContents& contents, const std::filesystem::path& figures_folder);

/// The result of a run as the report offers it, in its folder runs: "quick_6in5W_0.06_default.h5".
std::string run_download(const FinishedRun& run);

/// Writes one page per figure, `folder`/ID.html, beside the pictures and tables of the figures: the picture, how it is
/// measured, what the paper states beside our numbers, the simulations behind it and their cost, and how to redraw it.
void write_figure_pages(const ReportContents& contents, const std::filesystem::path& folder);

/// The same one after the other, as sections of a page in the folder above.
std::string figures_to_print(const ReportContents& contents, const std::filesystem::path& folder);

}  // namespace slfb
