#include "reports/article.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "reports/html.hpp"

namespace slfb::reports {

std::string fill_template(const std::string& text, const std::string& origin, const Fill& fill) {
  std::string filled;
  std::size_t begin = 0;
  for (;;) {
    const auto open = text.find("{{", begin);
    filled += text.substr(begin, open - begin);
    if (open == std::string::npos) return filled;
    const auto problem = [&](const std::string& what) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(open), '\n');
      return std::runtime_error(fmt::format("{}:{}: {}", origin, line, what));
    };
    const auto close = text.find("}}", open);
    if (close == std::string::npos) throw problem("\"{{\" without \"}}\"");
    try {
      filled += fill(text.substr(open + 2, close - open - 2));
    } catch (const std::invalid_argument& error) {
      throw problem(error.what());
    }
    begin = close + 2;
  }
}

std::string article_html(const std::string& markdown) {
  constexpr std::string_view mark = "# ";
  if (!markdown.starts_with(mark)) throw std::runtime_error("article_html: the text does not begin with \"# TITLE\"");
  const std::string title = prose_html(markdown.substr(mark.size(), markdown.find('\n') - mark.size()));
  return html_page(title,
                   fmt::format("<header class=\"masthead slim\"><div><h1>{}</h1></div></header>\n<main>\n<div "
                               "class=\"prose\">\n{}</div>\n</main>\n",
                               title, markdown_html(markdown)),
                   "article");
}

}  // namespace slfb::reports
