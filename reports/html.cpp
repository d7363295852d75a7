#include "reports/html.hpp"

#include <fmt/format.h>

#include <cmath>
#include <regex>

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

std::string readable_duration(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.3g} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.3g} min", seconds / 60.0);
  return fmt::format("{:.3g} h", seconds / 3600.0);
}

}  // namespace slfb
