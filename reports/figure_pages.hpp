#pragma once

#include <filesystem>
#include <string>

#include "reports/report_contents.hpp"

/// The figures in the report: a tile on the first page, a page each, a section on the page for paper. `folder` is where
/// the pictures and tables of the figures lie. All throw std::runtime_error naming a file that cannot be read or
/// written.
namespace slfb::reports {

/// All figures side by side, each a link to its page, for the first page of the report (HTML).
std::string figure_gallery(const ReportContents& contents, const std::filesystem::path& folder);

/// Writes one page per figure, `folder`/ID.html: the picture, how it is measured, what the work states beside our
/// numbers, the simulations behind it and their cost, and how to redraw it.
void write_figure_pages(const ReportContents& contents, const std::filesystem::path& folder);

/// The same one after the other, as sections of a page in the folder above (HTML).
std::string figures_to_print(const ReportContents& contents, const std::filesystem::path& folder);

}  // namespace slfb::reports
