// The study behind figure 1: its spheres, its errors and a sphere that crosses a face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "experiments/numerics/studies/scheme_study.hpp"

namespace slfb::void_fraction_study {
namespace {

const Method& method(const std::string& name) {
  for (const Method& candidate : methods())
    if (candidate.name == name) return candidate;
  throw std::invalid_argument(name);
}

const Assembly& assembly() {
  static const Assembly spheres = hard_spheres(600, 0.5, 1);
  return spheres;
}

TEST(HardSpheres, FillHalfOfTheCubeWithoutOverlap) {
  const auto& [side, centres] = assembly();
  ASSERT_EQ(centres.size(), 600u);
  EXPECT_NEAR(600 * std::numbers::pi / 6 / std::pow(side, 3), 0.5, 1e-12);
  for (std::size_t i = 0; i < centres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double squared = 0.0;
      for (std::size_t a = 0; a < 3; ++a) squared += std::pow(std::remainder(centres[i][a] - centres[j][a], side), 2);
      EXPECT_GE(squared, 1.0);
    }
}

TEST(VoidFractionSchemes, ExactIsExactAndPiecesApproachIt) {
  const std::vector<Method> series{method("centroid"), method("8 pieces"), method("64 pieces"), method("1214 pieces"),
                                   method("exact overlap")};
  for (const int across : {4, 8}) {
    const auto outcomes = compare(assembly(), across, 2, 0.0, series);
    EXPECT_EQ(outcomes.back().largest, 0.0);
    for (std::size_t m = 1; m < series.size(); ++m) {
      EXPECT_LT(outcomes[m].root_mean_square, 0.5 * outcomes[m - 1].root_mean_square) << series[m].name;
      EXPECT_LT(outcomes[m].largest, outcomes[m - 1].largest) << series[m].name;
    }
  }
}

TEST(VoidFractionSchemes, LargerCellsErrLess) {
  const std::vector<Method> series{method("centroid"), method("64 pieces"), method("1214 pieces")};
  const auto coarse = compare(assembly(), 3, 2, 0.0, series), fine = compare(assembly(), 6, 2, 0.0, series);
  for (std::size_t m = 0; m < series.size(); ++m)
    EXPECT_LT(coarse[m].root_mean_square, 0.5 * fine[m].root_mean_square) << series[m].name;
}

// The part of a sphere beyond a plane through which its centre has passed by h: (1 + h)² (2 − h)/4, h in radii.
TEST(VoidFractionSchemes, ASphereCrossesAFace) {
  std::vector<double> distances;
  for (int k = -60; k <= 60; ++k) distances.push_back(0.01 * k + 0.003);
  const auto exact = crossing(method("exact overlap"), 1.3, distances),
             centroid = crossing(method("centroid"), 1.3, distances),
             meshed = crossing(method("1214 pieces"), 1.3, distances);
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const double h = std::clamp(2 * distances[k], -1.0, 1.0);
    EXPECT_NEAR(exact[k], (1 + h) * (1 + h) * (2 - h) / 4, 1e-13);
    EXPECT_EQ(centroid[k], distances[k] > 0.0 ? 1.0 : 0.0);
    EXPECT_NEAR(meshed[k], exact[k], 0.02);
  }
}

// A sphere centred on the face has half its volume on either side, so that its smoothed part lies halfway between those
// of spheres wholly before and wholly behind the face.
TEST(VoidFractionSchemes, SmoothingIsLinearInWhatItSmooths) {
  const double cell = 1.3, radius = 0.5;
  const auto parts = crossing(method("exact overlap + diffusion"), cell, {-radius, 0.0, radius});
  EXPECT_NEAR(parts[1], 0.5 * (parts[0] + parts[2]), 1e-14);
  EXPECT_LT(parts[2], 1.0);
  EXPECT_GT(parts[0], 0.0);
}

}  // namespace
}  // namespace slfb::void_fraction_study
