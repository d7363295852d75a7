#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

namespace slfb {

/// Accepts numbers above zero. CLI::PositiveNumber does too, but prints the largest double, 309 digits, in its message.
inline CLI::Validator above_zero() {
  const auto problem = [](const std::string& text) -> std::string {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && value > 0.0 ? "" : text + " is not allowed, a number above zero is";
  };
  return CLI::Validator([problem](std::string& text) { return problem(text); }, "POSITIVE");
}

}  // namespace slfb
