#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slfb::reports {

/// A value of a sequence, with the ends of its interval where it has one.
struct SparkPoint {
  std::optional<double> value;
  std::optional<std::pair<double, double>> interval;
};

/// A small picture of a sequence of values, one step apart: a line through them, a bar for each interval, and a band
/// behind them. What is not finite is not drawn. \param description read out instead of the picture
/// \return HTML: inline SVG; empty where no point has a value
std::string sparkline(const std::vector<SparkPoint>& points, const std::optional<std::pair<double, double>>& band,
                      const std::string& description);

}  // namespace slfb::reports
