#include "solver/fluid/three_dimensional_liquid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "solver/fluid/one_dimensional_liquid.hpp"
#include "solver/support/stopwatch.hpp"

namespace slfb::fluid {

ThreeDimensionalLiquid::ThreeDimensionalLiquid(const Scene& scene, bool closed, int threads)
    : StaggeredLiquid(scene, scene.fluid.wall, closed, threads),
      superficial_velocity_(scene.first_superficial_velocity()),
      pressure_tolerance_(scene.fluid.pressure_tolerance),
      simple_tolerance_(scene.fluid.simple_tolerance),
      pressure_velocity_(scene.fluid.pressure_velocity),
      pressure_equation_(grid_, closed, threads),
      imbalance_(grid_.size(), 0.0),
      correction_(grid_.size(), 0.0) {
  for (std::size_t a = 0; a < 3; ++a) mobility_[a].assign(nodes(a), 0.0);
}

void ThreeDimensionalLiquid::set_superficial_velocity(double velocity) {
  StaggeredLiquid::set_superficial_velocity(velocity);
  superficial_velocity_ = velocity;
}

void ThreeDimensionalLiquid::solve(const Exchange& exchange) {
  constexpr int most_iterations = 100;
  const bool simple = pressure_velocity_ == PressureVelocity::simple;
  for (int iteration = 1;; ++iteration) {
    double leaving = 0.0;
    {
      // Equation (27) at the present pressure
      const Stopwatch stopwatch(cost_.momentum_seconds);
      momentum_.solve(exchange);
      leaving = outflow();
    }
    // Equation (26)
    const double imbalance = correct_pressure(exchange);
    if (!simple || (iteration > 1 && imbalance < simple_tolerance_)) {
      record_vertical_forces(leaving);
      return;
    }
    if (iteration == most_iterations)
      throw FluidError(fmt::format("SIMPLE: {} iterations leave a scaled residual of {:.3g} (tolerance {:.3g})",
                                   most_iterations, imbalance, simple_tolerance_));
  }
}

/// Pressure correction: u = u* − m ∇δp with m = liquid volume over (inertia + drag) per node, so that continuity
/// ∂V_L/∂t + Σ α u A = 0 (Eq. 26) holds in every cell. Returns the largest imbalance before the correction over the
/// inlet flow.
double ThreeDimensionalLiquid::correct_pressure(const Exchange& exchange) {
  const Stopwatch stopwatch(cost_.pressure_seconds);
  momentum_.update_flows();
  assemble_pressure_equation(exchange);
  const double inlet_flow = std::max(std::abs(superficial_velocity_), 1e-3) * grid_.section_area();
  const double largest = find_imbalance(inlet_flow);
  if (!std::isfinite(largest)) throw FluidError("liquid continuity: an imbalance is not finite");
  continuity_error_ = 0.0;
  if (largest == 0.0) return 0.0;

  // Σ_faces α A m δp/Δx = imbalance
  constexpr int most_iterations = 500;
  const auto [iterations, error] =
      pressure_equation_.solve(imbalance_, correction_, pressure_tolerance_, most_iterations);
  cost_.pressure_iterations += iterations;
  if (!(error <= pressure_tolerance_))
    throw FluidError(
        fmt::format("pressure equation: {} iterations leave a relative residual of {:.3g} (tolerance {:.3g})",
                    iterations, error, pressure_tolerance_));
  // p = p* + δp and u = u* − m ∇δp
  for (std::size_t i = 0; i < grid_.size(); ++i) pressure_[i] += correction_[i];
  update_pressure_gradient(mobility_);
  continuity_error_ = pressure_equation_.largest_residual() / inlet_flow;
  return largest;
}

/// m on the nodes and the coefficients α A m/Δx of the faces between cells.
void ThreeDimensionalLiquid::assemble_pressure_equation(const Exchange& exchange) {
  const int layers = grid_.layers();
  momentum_.for_sections([&](std::size_t a, int s) {
    const MomentumEquations::Component& c = momentum_.component[a];
    const double area = c.face_area(s);
    const std::size_t start = index_of(s, 0, c.levels);
    const double *stressed = &c.stressed[start], *inertia = &c.inertia[start], *drag = &exchange.coefficient[a][start],
                 *fraction = &c.fraction[start];
    double *mobility = &mobility_[a][start], *coefficient = &pressure_equation_.coefficient[a][start];
    const double per_spacing = 1.0 / c.spacing(1);
    const int first = c.first, last = c.last;
#pragma omp simd
    for (int k = first; k <= last; ++k) {
      mobility[k] = stressed[k] / (inertia[k] + drag[k]);
      coefficient[k] = fraction[k] * area * mobility[k] * per_spacing;
    }
    if (a == vertical && last == layers)  // the outlet is half a cell away
      coefficient[layers] = fraction[layers] * area * mobility[layers] / c.spacing(layers);
  });
}

/// What continuity lacks in each cell, −∂V_L/∂t − Σ α u A (Eq. 26); returns the largest over the inlet flow.
double ThreeDimensionalLiquid::find_imbalance(double inlet_flow) {
  const int layers = grid_.layers();
  const std::vector<double>& volume_change = momentum_.volume_change();
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (int cell = 0; cell < grid_.cells(); ++cell) {
    const double *change = &volume_change[index_of(cell, 0, layers)],
                 *up = &momentum_.component[vertical].flow[index_of(cell, 0, layers + 1)];
    double* imbalance = &imbalance_[index_of(cell, 0, layers)];
    for (int k = 0; k < layers; ++k) imbalance[k] = up[k] - up[k + 1] - change[k];
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}})
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(cell, axis, side);
        if (face < 0) continue;
        const double *flow = &momentum_.component[axis].flow[index_of(face, 0, layers)], sign = side == 0 ? 1.0 : -1.0;
        for (int k = 0; k < layers; ++k) imbalance[k] += sign * flow[k];
      }
  }
  double largest = 0.0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < imbalance_.size(); ++i) largest = std::max(largest, std::abs(imbalance_[i]));
  return largest / inlet_flow;
}

std::unique_ptr<Liquid> make_three_dimensional_liquid(const Scene& scene, int threads) {
  if (ColumnGrid(scene).cells() == 1) return make_one_dimensional_liquid(scene, threads);
  return std::make_unique<ThreeDimensionalLiquid>(scene, false, threads);
}

}  // namespace slfb::fluid
