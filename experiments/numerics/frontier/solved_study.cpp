#include "experiments/numerics/frontier/solved_study.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slfb::frontier {

std::string percent(const std::optional<PointError>& error) {
  if (!error) return "–";
  const auto digits = [](double share) {
    return share < 0.995 ? fmt::format("{:.2g}", 100.0 * share) : fmt::format("{:.0f}", 100.0 * share);
  };
  return error->half_width > 0.0 ? fmt::format("{} ± {} %", digits(error->value), digits(error->half_width))
                                 : fmt::format("{} %", digits(error->value));
}

std::string SolvedStudy::title(const std::string& quantity) const {
  return studies::find_quantity(studies::find_problem(study.problem), quantity).title;
}

const ReducedPoint* SolvedStudy::nearest(const std::string& series, double axis) const {
  const auto distance = [&](const ReducedPoint& point) {
    return point.axis > 0.0 && axis > 0.0 ? std::abs(std::log(point.axis / axis)) : std::abs(point.axis - axis);
  };
  const ReducedPoint* best = nullptr;
  for (const ReducedPoint& point : reduced.points)
    if (point.series == series && (best == nullptr || distance(point) < distance(*best))) best = &point;
  return best;
}

const ReducedPoint* SolvedStudy::at(const std::string& series, double axis) const {
  const ReducedPoint* point = nearest(series, axis);
  return point != nullptr && std::abs(point->axis - axis) <= 1e-9 * std::abs(axis) ? point : nullptr;
}

std::optional<PointError> SolvedStudy::error_of(const ReducedPoint& point, const std::string& quantity) const {
  const auto found = point.values.find(quantity);
  if (!point.failure.empty() || found == point.values.end() || !std::isfinite(found->second.error)) return std::nullopt;
  const auto truth = reduced.reference.find(quantity);
  const auto finite = [](double value) { return std::isfinite(value) ? value : 0.0; };
  return PointError{found->second.error,
                    std::hypot(finite(found->second.error_half_width),
                               truth == reduced.reference.end() ? 0.0 : finite(truth->second.error_half_width))};
}

SolvedStudy load_solved(const std::string& id, const std::filesystem::path& results) {
  Study study = load_study(study_file(id), studies::Set::full);
  ReducedStudy reduced = load_reduced(study, results);
  return {std::move(study), std::move(reduced)};
}

}  // namespace slfb::frontier
