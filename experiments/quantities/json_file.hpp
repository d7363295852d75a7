#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "solver/support/files.hpp"

/// Reading JSON that may have been damaged or written by others.
namespace slfb {

/// Parses a file and hands it to `read`. Whatever goes wrong becomes a std::runtime_error that names the file and
/// `what` it should be ("a summary of a run").
template <class Read>
auto read_json(const std::filesystem::path& file, std::string_view what, Read read) {
  const std::string text = read_file(file);
  try {
    return read(nlohmann::ordered_json::parse(text));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: damaged, or not {}: {}", file.string(), what, error.what()));
  }
}

/// JSON knows no NaN: null stands for it.
inline nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}
inline double number_or_nan(const nlohmann::ordered_json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

/// A whole number from 0 to `most`; JSON's own conversion would wrap others around.
inline std::uint32_t whole_number(const nlohmann::ordered_json& value,
                                  std::uint32_t most = std::numeric_limits<std::int32_t>::max()) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
    throw std::runtime_error(fmt::format("{} is no whole number from 0 to {}", value.dump(), most));
  return value.get<std::uint32_t>();
}

}  // namespace slfb
