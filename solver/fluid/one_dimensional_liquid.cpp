#include "solver/fluid/one_dimensional_liquid.hpp"

#include <algorithm>

#include "solver/support/stopwatch.hpp"

namespace slfb::fluid {

// Nothing varies across the section, so that the wall is felt by no node.
OneDimensionalLiquid::OneDimensionalLiquid(const Scene& scene, int threads)
    : StaggeredLiquid(scene, LateralBoundary::slip, false, threads) {}

void OneDimensionalLiquid::solve(const Exchange& exchange) {
  const Stopwatch stopwatch(cost_.momentum_seconds);
  MomentumEquations::Component& c = momentum_.component[vertical];
  const std::vector<double>& volume_change = momentum_.volume_change();
  const int layers = grid_.layers();
  const double area = grid_.area(0);
  // Equation (26): the flow through the upper face of each cell
  c.flow[0] = c.end[0][0] * area;
  for (int k = 1; k <= layers; ++k) {
    const std::size_t n = as_index(k);
    c.flow[n] = c.flow[n - 1] - volume_change[n - 1];
    c.velocity[n] = c.flow[n] / (c.fraction[n] * area);
  }
  // Equation (27) without −α ∇p
  std::fill(c.pressure_gradient.begin(), c.pressure_gradient.end(), 0.0);
  momentum_.assemble_column(exchange);
  // and with it, solved for ∇p from the outlet down
  double above = 0.0;
  for (int k = layers; k > 0; --k) {
    const std::size_t n = as_index(k);
    double force = c.right_hand_side[n] - c.diagonal[n] * c.velocity[n] + c.coefficient[5][n] * above;
    if (k > 1) force += c.coefficient[4][n] * c.velocity[n - 1];
    above = c.velocity[n];
    c.pressure_gradient[n] = force / c.stressed[n];
    pressure_[n - 1] = (k < layers ? pressure_[n] : 0.0) - c.pressure_gradient[n] * c.spacing(k);
  }
  momentum_.finish_column();
  record_vertical_forces(outflow());
}

std::unique_ptr<Liquid> make_one_dimensional_liquid(const Scene& scene, int threads) {
  return std::make_unique<OneDimensionalLiquid>(scene, threads);
}

}  // namespace slfb::fluid
