// The decaying vortices of Taylor and Green (1937), Proc. R. Soc. Lond. A 158, 499, in the three planes of the grid.
#include <gtest/gtest.h>

#include <numbers>

#include "solver/fluid/three_dimensional_liquid.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

constexpr double wave = 2.0 * std::numbers::pi, density = 1.0, viscosity = 0.02;

/// u = −sin kx cos kz, w = cos kx sin kz, each times exp(−2 ν k² t), in the plane of the axes `first` and `second`.
struct Vortices {
  std::size_t first, second;
  [[nodiscard]] double velocity(std::size_t a, const Point& at, double t) const {
    const double x = wave * at[first], z = wave * at[second];
    const double decay = std::exp(-2.0 * viscosity / density * wave * wave * t);
    if (a == first) return -std::sin(x) * std::cos(z) * decay;
    return a == second ? std::cos(x) * std::sin(z) * decay : 0.0;
  }
  [[nodiscard]] double pressure(const Point& at) const {
    return 0.25 * density * (std::cos(2.0 * wave * at[first]) + std::cos(2.0 * wave * at[second]));
  }
};

/// Error after the vortices have lost half their speed, over their mean speed; the sides are periodic and the end
/// planes move with the liquid.
double error_with(const Vortices& vortices, ConvectionScheme convection, int cells) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  const double cell = 1.0 / cells;
  scene.geometry.width = {vortices.first == 0 ? 1.0 : cell, vortices.first == 1 || vortices.second == 1 ? 1.0 : cell};
  scene.geometry.height = vortices.second == 2 ? 1.0 : 0.25;
  scene.liquid = {density, viscosity, 0.0};
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cells_across = vortices.first == 0 ? cells : 1;
  scene.fluid.cell_height = cell;
  scene.fluid.convection = convection;
  scene.fluid.time_scheme = TimeScheme::second_order;
  scene.fluid.pressure_tolerance = 1e-8;
  fluid::ThreeDimensionalLiquid liquid(scene, true);
  std::array<Field, 3> start;
  for (std::size_t a = 0; a < 3; ++a) start[a] = [&, a](const Point& x) { return vortices.velocity(a, x, 0.0); };
  start_from(liquid, start, [&](const Point& x) { return vortices.pressure(x); });
  const auto volume = cell_volumes(liquid.grid());
  const auto exchange = no_exchange(liquid);
  const double duration = std::log(2.0) / (2.0 * viscosity / density * wave * wave);
  const int steps = 2 * cells;
  const auto layers = static_cast<std::size_t>(liquid.grid().layers());
  for (int k = 1; k <= steps; ++k) {
    for (std::size_t a : {std::size_t{0}, std::size_t{1}})
      for (std::size_t s = 0; s < liquid.end_velocity(a, 0).size(); ++s)
        for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
          Point at = liquid.position(a, s * layers);
          at[2] = side == 0 ? 0.0 : scene.geometry.height;
          liquid.end_velocity(a, side)[s] = vortices.velocity(a, at, duration * k / steps);
        }
    liquid.advance(duration / steps, volume, volume, exchange);
  }
  double sum = 0.0;
  for (std::size_t a : {vortices.first, vortices.second}) {
    const Field exact = [&](const Point& x) { return vortices.velocity(a, x, duration); };
    sum += std::pow(error_of(liquid, a, liquid.velocity(a), exact).l2, 2);
  }
  return std::sqrt(sum) / std::sqrt(0.5 * 0.25);  // mean of u² + w² at the start ½, a quarter of it at the end
}

TEST(TaylorGreen, VorticesDecayAsTheyShouldInEveryPlane) {
  for (const Vortices vortices : {Vortices{0, 2}, Vortices{1, 2}, Vortices{0, 1}}) {
    const double coarse = error_with(vortices, ConvectionScheme::central, 16);
    const double fine = error_with(vortices, ConvectionScheme::central, 32);
    EXPECT_LT(fine, 0.005) << vortices.first << vortices.second;
    EXPECT_GE(order(coarse, fine, 16, 32), 1.9) << vortices.first << vortices.second;
    // QUICK's own errors cancel those of diffusion on such grids: smaller, but not yet in order.
    EXPECT_LT(error_with(vortices, ConvectionScheme::quick, 32), fine) << vortices.first << vortices.second;
  }
}

}  // namespace
}  // namespace slfb
