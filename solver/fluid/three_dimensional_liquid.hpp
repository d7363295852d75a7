#pragma once

#include "solver/fluid/pressure_equation.hpp"
#include "solver/fluid/staggered_liquid.hpp"

namespace slfb::fluid {

/// Liquid on a mesh of many cells across: momentum by MomentumEquations, continuity by a pressure correction.
///
/// fluid.pressure_velocity says how often both are done in a step: the projection takes one pass, SIMPLE repeats it
/// until pressure, velocity and convecting flow agree.
class ThreeDimensionalLiquid final : public StaggeredLiquid {
 public:
  /// A closed liquid has walls at z = 0 and z = height instead of the inlet and the outlet: no scene, but cavities and
  /// vortices with exact solutions.
  explicit ThreeDimensionalLiquid(const Scene& scene, bool closed = false, int threads = 1);

  void set_superficial_velocity(double velocity) override;

 private:
  void solve(const Exchange& exchange) override;
  double correct_pressure(const Exchange& exchange);
  void assemble_pressure_equation(const Exchange& exchange);
  [[nodiscard]] double find_imbalance(double inlet_flow);

  double superficial_velocity_, pressure_tolerance_, simple_tolerance_;
  PressureVelocity pressure_velocity_;
  PressureEquation pressure_equation_;
  std::array<std::vector<double>, 3> mobility_;  ///< change of velocity over that of −∇p, on the nodes [m³/(N s)]
  std::vector<double> imbalance_;                ///< of continuity, per cell [m³/s]
  std::vector<double> correction_;               ///< of the pressure, per cell [Pa]
};

/// The tier's maker: a section of a single cell is left to OneDimensionalLiquid, which needs no pressure equation.
std::unique_ptr<Liquid> make_three_dimensional_liquid(const Scene& scene, int threads);

}  // namespace slfb::fluid
