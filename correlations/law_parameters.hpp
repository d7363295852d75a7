#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "correlations/law.hpp"

/// Constants of a law that users vary, and how they name them: "ergun-1952:viscous=180,inertial=1.8".
namespace slfb {

/// A constant of a law, as the law declares it: a member whose default is the value of the source.
template <class Law>
struct LawParameter {
  std::string_view name;
  double Law::*value;
  Range range;
  std::string_view meaning;
};

/// The same for a reader.
struct ParameterInfo {
  std::string_view name;
  double of_source;  ///< its value in the law without parameters
  Range range;
  std::string_view meaning;
};

/// A law with `static constexpr auto parameters()`, an array of LawParameter.
template <class Law>
concept HasParameters = requires {
  Law::parameters();
};

template <class Law>
std::vector<ParameterInfo> parameters_of() {
  std::vector<ParameterInfo> all;
  if constexpr (HasParameters<Law>)
    for (const auto& one : Law::parameters())  // LawParameter of this law, or of one that it derives from
      all.push_back({one.name, Law{}.*one.value, one.range, one.meaning});
  return all;
}

/// A law by name with the values that its parameters take.
struct LawCall {
  std::string name;
  std::vector<std::pair<std::string, double>> values = {};
};

/// Where the name of a law ends and its parameters begin; the length of the text where it has none.
inline std::size_t end_of_law_name(std::string_view text) {
  // A file may have a colon in its path; parameters have an equals sign and no slash behind theirs.
  const auto equals = text.find('=');
  const auto colon = equals == std::string_view::npos ? equals : text.substr(0, equals).rfind(':');
  return colon == std::string_view::npos ? text.size() : colon;
}

/// Reads "NAME" or "NAME:KEY=VALUE,KEY=VALUE"; a colon between parameters is the same as a comma. \throws
/// std::invalid_argument for a part that is no KEY=NUMBER, and for a key that stands there twice
inline LawCall parse_law_call(std::string_view text) {
  const std::size_t end = end_of_law_name(text);
  LawCall call{std::string(text.substr(0, end))};
  if (end == text.size()) return call;
  for (std::string_view rest = text.substr(end + 1);;) {
    const std::string_view part = rest.substr(0, rest.find_first_of(",:"));
    const auto equals = part.find('=');
    const std::string key(part.substr(0, equals));
    const std::string_view number = equals == std::string_view::npos ? "" : part.substr(equals + 1);
    double value = 0.0;
    const auto [last, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (key.empty() || number.empty() || error != std::errc{} || last != number.data() + number.size())
      throw std::invalid_argument("\"" + std::string(part) + "\" of \"" + std::string(text) +
                                  "\" is no KEY=NUMBER; needed is NAME:KEY=NUMBER,KEY=NUMBER");
    for (const auto& [known, other] : call.values)
      if (known == key) throw std::invalid_argument("\"" + std::string(text) + "\" has " + key + " twice");
    call.values.emplace_back(key, value);
    if (part.size() == rest.size()) return call;
    rest.remove_prefix(part.size() + 1);
  }
}

/// The name of a law with its parameters, as tables and the headings of their columns have it: without a comma.
inline std::string law_call_text(std::string_view name, const LawCall& call) {
  std::string text(name);
  for (const auto& [key, value] : call.values) {
    std::array<char, 32> digits{};
    text += ":" + key + "=" +
            std::string(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  }
  return text;
}

/// "viscous (0 to 1000, 150 of the source): constant of the viscous part".
inline std::string parameter_text(const ParameterInfo& parameter) {
  const auto number = [](double value) {
    std::array<char, 32> digits{};
    return std::string(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  };
  return std::string(parameter.name) + " (" + number(parameter.range.lower) + " to " + number(parameter.range.upper) +
         ", " + number(parameter.of_source) + " of the source): " + std::string(parameter.meaning);
}

/// The law with these values. \throws std::invalid_argument that names the parameters of the law for a key that is none
/// of them, and the range for a value outside of it
template <class Law>
Law with_values(const LawCall& call) {
  Law law{};
  const std::vector<ParameterInfo> known = parameters_of<Law>();
  for (const auto& [key, value] : call.values) {
    const auto complain = [&, &name = key](const std::string& what) {
      std::string message = call.name;
      message.append(": ").append(name).append(" ").append(what);
      message.append(known.empty() ? "; this law has no parameters" : "; allowed are ");
      for (std::size_t k = 0; k < known.size(); ++k)
        message.append(k == 0 ? "" : "; ").append(parameter_text(known[k]));
      throw std::invalid_argument(message);
    };
    bool found = false;
    if constexpr (HasParameters<Law>)
      for (const auto& one : Law::parameters())  // LawParameter of this law, or of one that it derives from
        if (one.name == key) {
          found = true;
          if (!std::isfinite(value) || !one.range.contains(value)) complain("is outside of its range");
          law.*one.value = value;
        }
    if (!found) complain("is none of its parameters");
  }
  return law;
}

/// Splits "A,B:KEY=1,KEY=2,C" into its laws: what has an equals sign and no colon before it belongs to the law before.
inline std::vector<std::string> split_laws(std::string_view text) {
  std::vector<std::string> laws;
  for (;;) {
    const std::string_view part = text.substr(0, text.find(','));
    const auto equals = part.find('=');
    const bool goes_on = equals != std::string_view::npos && part.substr(0, equals).find(':') == std::string_view::npos;
    if (goes_on && !laws.empty())
      laws.back() += "," + std::string(part);
    else
      laws.emplace_back(part);
    if (part.size() == text.size()) return laws;
    text.remove_prefix(part.size() + 1);
  }
}

}  // namespace slfb
