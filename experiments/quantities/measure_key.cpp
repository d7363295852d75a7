#include "experiments/quantities/measure_key.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace slfb {
namespace {

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && rest == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto slash = text.find('/');
    parts.push_back(text.substr(0, slash));
    if (slash == std::string_view::npos) return parts;
    text.remove_prefix(slash + 1);
  }
}

}  // namespace

std::string velocity_text(double value) {
  std::string text = fmt::format("{:.2f}", value);
  if (std::abs(std::stod(text) - value) > 1e-9) text = fmt::format("{:g}", value);
  return text;
}

MeasureKey measure_key(std::string_view quantity, std::string_view subject, double at, std::string_view detail) {
  return {std::string(quantity), std::string(subject), std::stod(velocity_text(at)), std::string(detail)};
}

std::string to_string(const MeasureKey& key) {
  std::string text = key.quantity + "/" + key.subject;
  if (key.for_all_at) text += "/*";
  if (key.at) text += "/" + velocity_text(*key.at);
  if (!key.detail.empty()) text += "/" + key.detail;
  return text;
}

MeasureKey parse_measure_key(std::string_view text) {
  const auto problem = [&](std::string_view what) {
    return std::invalid_argument(
        fmt::format("\"{}\" is no measure: {}; needed is quantity/subject, with /number and /detail behind it where "
                    "there are any",
                    text, what));
  };
  const auto parts = parts_of(text);
  if (parts.size() < 2) throw problem("it has no subject");
  if (parts.size() > 4) throw problem("it has more than four parts");
  for (const std::string_view part : parts)
    if (part.empty()) throw problem("a part is empty");
  MeasureKey key{std::string(parts[0]), std::string(parts[1])};
  std::size_t next = 2;
  if (next < parts.size() && parts[next] == "*") {
    key.for_all_at = true;
    ++next;
  } else if (next < parts.size()) {
    key.at = number_in(parts[next]);
    if (key.at) ++next;
  }
  if (next < parts.size()) key.detail = parts[next++];
  if (next < parts.size()) throw problem(fmt::format("\"{}\" is not a number", parts[next - 1]));
  return key;
}

bool stands_for(const MeasureKey& pattern, const MeasureKey& key) {
  if (!pattern.for_all_at) return pattern == key;
  return key.at && key.quantity == pattern.quantity && key.subject == pattern.subject && key.detail == pattern.detail;
}

}  // namespace slfb
