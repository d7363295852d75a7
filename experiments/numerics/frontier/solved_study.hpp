#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "experiments/numerics/frontier/study.hpp"

namespace slfb::frontier {

/// Relative error of a point against the reference of its study [-].
struct PointError {
  double value;
  double half_width;  ///< of the 95 % interval, that of the reference included; 0 where there is none
};

/// "12 ± 3 %", "0.4 %" without an interval, "–" for none.
std::string percent(const std::optional<PointError>& error);

/// A study with what is known of it, for tables that are read off several studies.
struct SolvedStudy {
  Study study;
  ReducedStudy reduced;

  /// Title of a quantity of the study's problem.
  [[nodiscard]] std::string title(const std::string& quantity) const;
  /// The point of a series nearest to `axis`, on a logarithmic scale; null when nothing of the series was computed.
  [[nodiscard]] const ReducedPoint* nearest(const std::string& series, double axis) const;
  /// The point of a series at `axis`; null when it was not computed.
  [[nodiscard]] const ReducedPoint* at(const std::string& series, double axis) const;
  /// None where the point failed or has no answer.
  [[nodiscard]] std::optional<PointError> error_of(const ReducedPoint& point, const std::string& quantity) const;
};

/// The full set of study `id` with its results (load_reduced).
/// \param results folder of this machine's results, with frontier/
/// \throws what load_study throws
SolvedStudy load_solved(const std::string& id, const std::filesystem::path& results);

}  // namespace slfb::frontier
