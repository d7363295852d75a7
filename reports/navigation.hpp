#pragma once

#include <string>
#include <string_view>

#include "reports/report_contents.hpp"

namespace slfb::reports {

/// Links to all pages but the figures', and a field for searching, as HTML. \param current title of the page that is
/// shown, which is marked \param prefix from that page to the folder of the report: "" or "../"
std::string navigation(const ReportContents& contents, std::string_view current, const std::string& prefix);

}  // namespace slfb::reports
