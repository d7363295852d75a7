#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "correlations/catalogue.hpp"

namespace slfb {

/// A number that a law has to give, from outside this code.
struct CheckValue {
  std::string law;
  std::vector<std::pair<std::string, double>> arguments;  ///< by name; the others keep their defaults
  std::string quantity;
  std::string value;   ///< as it was written: its digits are its precision
  std::string origin;  ///< where the number comes from
  std::string remark;

  [[nodiscard]] double number() const { return std::stod(value); }
  /// A little more than half a unit of the last digit that is written.
  [[nodiscard]] double tolerance() const;
};

/// The check values of every CSV file of `folder`, file by file. A line is
/// "law,arguments,quantity,value,origin,remark", its arguments "voidage=0.4 re=100"; lines that start with '#' are
/// remarks. \throws std::runtime_error naming the file and line that cannot be read, or the unknown argument
std::vector<CheckValue> read_check_values(const std::filesystem::path& folder);

/// The arguments of a check value, the others at their defaults.
LawArguments arguments_of(const CheckValue& check);

}  // namespace slfb
