#include "reports/html.hpp"

#include <fmt/format.h>
#include <md4c-html.h>
#include <md4c.h>

#include <cmath>
#include <regex>
#include <stdexcept>

#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {

std::string escape_html(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    switch (character) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

std::string with_subscripts(const std::string& html) {
  // A symbol of one or two letters before the underscore, at most three after it: names of files and keys stay as
  // they are.
  static const std::regex symbol(
      "(^|[^A-Za-z0-9_./-])([A-Za-z]{1,2}|α|ρ|ε|μ|ω)_([A-Za-z0-9]{1,3})(?![A-Za-z0-9_./-]*[A-Za-z0-9_])");
  return std::regex_replace(html, symbol, "$1$2<sub>$3</sub>");
}

std::string prose_html(const std::string& text) { return with_subscripts(escape_html(text)); }

std::string readable_number(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0.0 ? "∞" : "−∞";
  const double size = std::fabs(value);
  std::string text;
  if (size == 0.0 || (size >= 1e-3 && size < 1e4)) {
    text = fmt::format("{:.4g}", value);
  } else if (size >= 1e4 && size < 1e6) {
    text = fmt::format("{:.0f}", value);
  } else {
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    text = fmt::format("{:.3g}·10<sup>{}</sup>", value / std::pow(10.0, exponent), exponent);
  }
  if (value < 0.0) text.replace(0, 1, "−");
  return text;
}

std::string readable_range(double lower, double upper) {
  if (std::isinf(upper)) return lower == 0.0 ? "any" : "≥ " + readable_number(lower);
  return readable_number(lower) + " … " + readable_number(upper);
}

std::string readable_duration(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.3g} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.3g} min", seconds / 60.0);
  return fmt::format("{:.3g} h", seconds / 3600.0);
}

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

std::string table_html(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"card scroll\"><table class=\"stack\"><thead><tr>";
  for (const auto& heading : headings) html += "<th>" + heading + "</th>";
  html += "</tr></thead><tbody>\n";
  // A label is plain text: subscripts are set back to the line.
  static const std::regex tag("<[^>]*>");
  std::vector<std::string> labels;
  for (const auto& heading : headings) labels.push_back(std::regex_replace(heading, tag, ""));
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += fmt::format("<td{} data-label=\"{}\">{}</td>", i == 0 ? " class=\"lead\"" : "", labels[i], row[i]);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_page(const std::string& title, const std::string& body, const std::string& html_class) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"{}>\n<head>\n<meta charset=\"utf-8\" />\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\" />\n<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "{}</body>\n</html>\n",
      html_class.empty() ? "" : fmt::format(" class=\"{}\"", html_class), title,
      read_file(source_folder() / "reports" / "report.css"), body);
}

}  // namespace slfb
