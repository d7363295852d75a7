#include <array>
#include <cmath>
#include <numbers>

#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/fluid/three_dimensional_liquid.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr double wave = 2.0 * std::numbers::pi, viscosity = 2e-3, drift = 1.0;

/// Taylor and Green's decaying vortices in the plane of x and y, carried along by a uniform drift in both directions.
double velocity(std::size_t a, double x, double y, double t) {
  const double decay = std::exp(-2.0 * viscosity * wave * wave * t);
  const double u = wave * (x - drift * t), v = wave * (y - drift * t);
  if (a == 0) return drift - std::sin(u) * std::cos(v) * decay;
  return a == 1 ? drift + std::cos(u) * std::sin(v) * decay : 0.0;
}

TrialResult solve(const Scene& given, const Parameters& parameters, int) {
  const int cells = static_cast<int>(parameters.at("cells"));
  Scene scene = given;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {1.0, 1.0};
  scene.geometry.height = 2.0 / cells;
  scene.liquid = {1.0, viscosity, 0.0};
  scene.fluid.tier = FluidTier::three_dimensional;
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cells_across = cells;
  scene.fluid.cell_height = 1.0 / cells;
  fluid::ThreeDimensionalLiquid liquid(scene, true);
  auto state = liquid.state();
  for (const std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (std::size_t n = 0; n < liquid.nodes(a); ++n) {
      const auto at = liquid.position(a, n);
      state.at(a == 0 ? "velocity_x" : "velocity_y")[n] = velocity(a, at[0], at[1], 0.0);
    }
  for (std::size_t c = 0; c < liquid.grid().size(); ++c) {
    const auto centre = liquid.grid().centre(static_cast<int>(c) / liquid.grid().layers());
    state.at("pressure")[c] = 0.25 * (std::cos(2.0 * wave * centre[0]) + std::cos(2.0 * wave * centre[1]));
  }
  liquid.restore(state);
  std::vector<double> volume(liquid.grid().size());
  for (std::size_t c = 0; c < volume.size(); ++c)
    volume[c] = liquid.grid().volume(static_cast<int>(c) / liquid.grid().layers());
  fluid::Exchange nothing;
  for (std::size_t a = 0; a < 3; ++a) {
    nothing.coefficient[a].assign(liquid.nodes(a), 0.0);
    nothing.source[a].assign(liquid.nodes(a), 0.0);
  }
  // Until the drift has carried the vortices through half the box; the fastest liquid is twice as fast as the drift.
  constexpr double duration = 0.5 / drift;
  const auto steps = static_cast<int>(std::ceil(duration * 2.0 * drift * cells / parameters.at("courant")));
  const double step = duration / steps;
  const auto layers = static_cast<std::size_t>(liquid.grid().layers());
  const double start = thread_cpu_seconds();
  for (int k = 1; k <= steps; ++k) {
    for (const std::size_t a : {std::size_t{0}, std::size_t{1}})
      for (std::size_t s = 0; s < liquid.end_velocity(a, 0).size(); ++s)
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
          const auto at = liquid.position(a, s * layers);
          liquid.end_velocity(a, side)[s] = velocity(a, at[0], at[1], step * k);
        }
    liquid.advance(step, volume, volume, nothing);
  }
  TrialResult result;
  result.cpu_seconds = (thread_cpu_seconds() - start) / duration;
  double squares = 0.0, scale = 0.0;
  for (const std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (std::size_t n = 0; n < liquid.nodes(a); ++n) {
      const auto at = liquid.position(a, n);
      const double exact = velocity(a, at[0], at[1], duration);
      squares += std::pow(liquid.velocity(a)[n] - exact, 2);
      scale += std::pow(exact - drift, 2);
    }
  const double error = std::sqrt(squares / scale);
  result.values["velocity"] = {1.0, error, 1.0};
  result.values["error"].value = error;
  result.counts["cell-steps"] = static_cast<double>(liquid.grid().size()) * steps / duration;
  result.counts["pressure iterations"] = static_cast<double>(liquid.cost().pressure_iterations) / duration;
  return result;
}

}  // namespace

Problem vortices_problem() {
  return {
      "vortices",
      "Decaying vortices (Taylor & Green 1937) that drift through a periodic grid: an exact solution of the liquid.",
      "simulated second",
      "numerics/studies/scenes/box.toml",
      {{"velocity", "velocity of the vortices", "of their own"}, {"error", "error of the vortices' velocity", "-"}},
      {{"cells", 16.0}, {"courant", 0.5}},
      solve};
}

}  // namespace slfb::studies
