#include "experiments/numerics/studies/trial.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <stdexcept>

#include "solver/support/folders.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr std::string_view parameter_prefix = "problem.";

}  // namespace

const Problem& find_problem(const std::string& name) {
  std::vector<std::string> known;
  for (const Problem& problem : problems()) {
    if (problem.name == name) return problem;
    known.push_back(problem.name);
  }
  throw std::invalid_argument(fmt::format("there is no problem \"{}\"; known: {}", name, fmt::join(known, ", ")));
}

const ProblemQuantity& find_quantity(const Problem& problem, const std::string& name) {
  std::vector<std::string> known;
  for (const ProblemQuantity& quantity : problem.quantities) {
    if (quantity.name == name) return quantity;
    known.push_back(quantity.name);
  }
  throw std::invalid_argument(
      fmt::format("the problem \"{}\" has no quantity \"{}\"; known: {}", problem.name, name, fmt::join(known, ", ")));
}

Scene Trial::scene() const {
  Overrides overrides;
  for (const std::string& setting : settings)
    if (!setting.starts_with(parameter_prefix)) overrides.push_back(setting);
  overrides.push_back(fmt::format("seed={}", replicate + 1));
  return load_scene(source_folder() / "experiments" / find_problem(problem).scene, overrides);
}

Parameters Trial::parameters() const {
  const Problem& of = find_problem(problem);
  Parameters values = of.parameters;
  for (const std::string& setting : settings) {
    if (!setting.starts_with(parameter_prefix)) continue;
    const auto equals = setting.find('=');
    const std::string name = setting.substr(parameter_prefix.size(), equals - parameter_prefix.size());
    if (!values.contains(name)) {
      std::vector<std::string> known;
      for (const auto& [key, value] : values) known.push_back(key);
      throw std::invalid_argument(fmt::format("{}: the problem \"{}\" has no such parameter; it has: {}", setting,
                                              problem,
                                              known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    }
    try {
      values[name] = std::stod(setting.substr(equals + 1));
    } catch (const std::exception&) {
      throw std::invalid_argument(fmt::format("{}: not a number", setting));
    }
  }
  return values;
}

std::string Trial::hash() const {
  std::string text = fmt::format("{}\n{}\n{}\n", problem, scene_hash(scene()), replicate);
  for (const auto& [name, value] : parameters()) text += fmt::format("{}={}\n", name, value);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

TrialResult solve(const Trial& trial) {
  const Problem& problem = find_problem(trial.problem);
  const Scene scene = trial.scene();
  const Parameters parameters = trial.parameters();
  const double start = thread_cpu_seconds();
  TrialResult result;
  try {
    result = problem.solve(scene, parameters, trial.replicate);
  } catch (const std::runtime_error& error) {
    result = {};
    // Where a run left its last state is of no use to who reads a study.
    const std::string reason = error.what();
    result.failure = reason.substr(0, reason.find("; state saved in "));
    result.cpu_seconds = thread_cpu_seconds() - start;
  }
  result.machine = processor_name();
  return result;
}

std::string fill_in(std::string text, double value) {
  const std::string number = fmt::format("{}", value);
  for (auto position = text.find("{}"); position != std::string::npos;
       position = text.find("{}", position + number.size()))
    text.replace(position, 2, number);
  return text;
}

}  // namespace slfb::studies
