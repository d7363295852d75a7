#include "reports/sparkline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/html.hpp"

namespace slfb::reports {
namespace {

constexpr double width = 180.0, height = 36.0, margin = 4.0;  // [pixel]

}  // namespace

std::string sparkline(const std::vector<SparkPoint>& points, const std::optional<std::pair<double, double>>& band,
                      const std::string& description) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  const auto include = [&](double value) {
    if (!std::isfinite(value)) return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  };
  for (const SparkPoint& point : points) {
    if (!point.value) continue;
    include(*point.value);
    if (point.interval) {
      include(point.interval->first);
      include(point.interval->second);
    }
  }
  if (!(lowest <= highest)) return "";
  if (band) {
    include(band->first);
    include(band->second);
  }
  if (lowest == highest) {
    lowest -= 1.0;
    highest += 1.0;
  }
  const auto y = [&](double value) {
    return height - margin -
           (std::clamp(value, lowest, highest) - lowest) / (highest - lowest) * (height - 2.0 * margin);
  };
  const auto x = [&](std::size_t k) {
    return points.size() == 1
               ? 0.5 * width
               : margin + static_cast<double>(k) * (width - 2.0 * margin) / static_cast<double>(points.size() - 1);
  };
  std::string svg =
      fmt::format("<svg role=\"img\" aria-label=\"{}\" width=\"{:g}\" height=\"{:g}\" viewBox=\"0 0 {:g} {:g}\">",
                  escape_html(description), width, height, width, height);
  if (band)
    svg += fmt::format("<rect x=\"0\" width=\"{:g}\" y=\"{:.1f}\" height=\"{:.1f}\" fill=\"#8884\"/>", width,
                       y(band->second), y(band->first) - y(band->second));
  std::string line;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].value) continue;
    if (points[k].interval)
      svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"currentColor\" opacity=\"0.5\"/>", x(k),
                         y(points[k].interval->first), y(points[k].interval->second));
    svg +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"currentColor\"/>", x(k), y(*points[k].value));
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x(k), y(*points[k].value));
  }
  return svg + fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"currentColor\"/></svg>", line);
}

}  // namespace slfb::reports
