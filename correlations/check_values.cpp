#include "correlations/check_values.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace slfb {

namespace {

namespace fs = std::filesystem;

const Argument& find_argument(const std::string& name) {
  const auto found = std::ranges::find(all_arguments(), name, &Argument::name);
  if (found != all_arguments().end()) return *found;
  std::string known;
  for (const Argument& argument : all_arguments()) known += (known.empty() ? "" : ", ") + std::string(argument.name);
  throw std::runtime_error("unknown argument \"" + name + "\"; known: " + known);
}

CheckValue parse(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> fields;
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  if (fields.size() == 5) fields.emplace_back();  // no remark
  if (fields.size() != 6) throw std::runtime_error("law,arguments,quantity,value,origin,remark expected");
  CheckValue check{fields[0], {}, fields[2], fields[3], fields[4], fields[5]};
  std::istringstream words(fields[1]);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals == std::string::npos) throw std::runtime_error("name=value expected, not \"" + word + "\"");
    check.arguments.emplace_back(find_argument(word.substr(0, equals)).name, std::stod(word.substr(equals + 1)));
  }
  static_cast<void>(check.number());
  return check;
}

}  // namespace

double CheckValue::tolerance() const {
  const auto exponent = value.find_first_of("eE");
  const std::string digits = value.substr(0, exponent);
  const auto point = digits.find('.');
  const double decimals = point == std::string::npos ? 0.0 : static_cast<double>(digits.size() - point - 1);
  const double power = exponent == std::string::npos ? 0.0 : std::stod(value.substr(exponent + 1));
  return 0.6 * std::pow(10.0, power - decimals);
}

std::vector<CheckValue> read_check_values(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<CheckValue> checks;
  for (const fs::path& file : files) {
    std::ifstream stream(file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      if (line.empty() || line.front() == '#') continue;
      try {
        checks.push_back(parse(line));
      } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": " + error.what());
      }
    }
  }
  return checks;
}

LawArguments arguments_of(const CheckValue& check) {
  LawArguments arguments;
  for (const auto& [name, value] : check.arguments) arguments.*find_argument(name).value = value;
  return arguments;
}

}  // namespace slfb
