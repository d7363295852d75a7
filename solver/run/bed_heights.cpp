#include "solver/run/bed_heights.hpp"

#include <algorithm>
#include <cstddef>

namespace slfb::simulation {

BedHeights bed_heights(std::vector<double> heights, std::span<const double> volumes) {
  double moment = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    moment += volumes[i] * heights[i];
    volume += volumes[i];
  }
  const auto top = heights.begin() + static_cast<std::ptrdiff_t>(0.99 * (static_cast<double>(heights.size()) - 1.0));
  std::nth_element(heights.begin(), top, heights.end());
  return {moment / volume, *top};
}

SettledBed settled_bed(std::span<const double> heights, std::span<const double> volumes,
                       const std::vector<bool>& floats, double column_height, double cross_section) {
  struct Part {
    double moment = 0.0, volume = 0.0;
    [[nodiscard]] double height() const { return volume > 0.0 ? 2.0 * moment / volume : 0.0; }
  } sunk, floating;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const bool rises = !floats.empty() && floats[i];
    Part& part = rises ? floating : sunk;
    part.moment += volumes[i] * (rises ? column_height - heights[i] : heights[i]);
    part.volume += volumes[i];
  }
  const double height = sunk.height() + floating.height();
  return {height, 1.0 - (sunk.volume + floating.volume) / (cross_section * height)};
}

}  // namespace slfb::simulation
