#include "reports/markdown.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "reports/html.hpp"

namespace slfb {
namespace {

std::string paragraph(const std::string& text) {
  static const std::regex code("`([^`]+)`"), bold("\\*\\*([^*]+)\\*\\*");
  const std::string html = std::regex_replace(prose_html(text), code, "<code>$1</code>");
  return fmt::format("<p>{}</p>\n", std::regex_replace(html, bold, "<b>$1</b>"));
}

}  // namespace

std::string markdown_html(const std::string& text) {
  std::istringstream lines(text);
  std::string html, open;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ")) continue;
    if (!line.empty()) {
      open += (open.empty() ? "" : " ") + line;
    } else if (!open.empty()) {
      html += paragraph(open);
      open.clear();
    }
  }
  return open.empty() ? html : html + paragraph(open);
}

}  // namespace slfb
