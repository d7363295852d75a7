#include "reports/markdown.hpp"

#include <md4c-html.h>
#include <md4c.h>

#include <regex>
#include <stdexcept>

#include "reports/html.hpp"

namespace slfb {

std::string markdown_html(const std::string& text) {
  std::string html;
  const auto append = [](const char* part, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(part, size);
  };
  if (md_html(text.data(), static_cast<MD_SIZE>(text.size()), append, &html, MD_DIALECT_GITHUB, MD_HTML_FLAG_XHTML) !=
      0)
    throw std::runtime_error("markdown_html: the text cannot be read");
  static const std::regex title("^<h1>[^\n]*</h1>\n"), heading("(</?)h[1-6]>");
  html = std::regex_replace(html, title, "", std::regex_constants::format_first_only);
  return with_subscripts(std::regex_replace(html, heading, "$1h3>"));
}

}  // namespace slfb
