#pragma once

#include "solver/fluid/momentum_equations.hpp"

namespace slfb::fluid {

/// Volume-averaged continuity and momentum of the liquid (Peng 2014, Eqs. 21, 26, 27) on a staggered ColumnGrid: what
/// the tiers that solve for the liquid have in common. They differ in how the pressure makes continuity hold.
///
/// The sides are walls as the scene says; the inlet at z = 0 gives the velocity, the outlet at z = height the pressure.
class StaggeredLiquid : public Liquid {
 public:
  [[nodiscard]] bool two_way() const final { return true; }
  [[nodiscard]] const ColumnGrid& grid() const final { return grid_; }

  void set_superficial_velocity(double velocity) override { momentum_.set_inlet_velocity(velocity); }

  /// In second order the time step stays the same; where `before` is not the last step's `now` (a sphere was put in),
  /// the scheme starts anew with Euler.
  void advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
               const Exchange& exchange) final;

  /// Distributes an extensive cell quantity to the nodes of a component.
  void scatter(std::size_t component, const std::vector<double>& cells, std::vector<double>& nodes) const;
  void scatter(const std::array<std::vector<double>, 5>& cells, Exchange& exchange) const final;
  /// Mean of a node quantity over the nodes of each cell: the adjoint of scatter.
  void gather(std::size_t component, const std::vector<double>& nodes, std::vector<double>& cells) const;
  void gather(std::array<std::vector<double>, 3>& velocity, std::array<std::vector<double>, 3>& stress) const final;
  void gather_pressure_gradient(std::size_t a, std::vector<double>& cells) const final {
    gather(a, pressure_gradient(a), cells);
  }
  [[nodiscard]] std::size_t nodes(std::size_t component) const { return momentum_.component[component].size(); }
  /// Where the velocity of a node is that of the liquid [m].
  [[nodiscard]] std::array<double, 3> position(std::size_t component, std::size_t node) const {
    return momentum_.component[component].position(node);
  }

  /// Velocity given at z = 0 (side 0) and, for the lateral components of a closed liquid, at z = height (side 1), per
  /// section node [m/s]. For the vertical component it is the superficial velocity α w. A scene's liquid enters with
  /// set_superficial_velocity().
  [[nodiscard]] std::vector<double>& end_velocity(std::size_t component, std::size_t side) {
    return momentum_.component[component].end[side];
  }

  /// Interstitial liquid velocity on the nodes of a component [m/s].
  [[nodiscard]] const std::vector<double>& velocity(std::size_t component) const {
    return momentum_.component[component].velocity;
  }
  [[nodiscard]] const std::vector<double>& pressure() const final { return pressure_; }
  /// ∂p/∂x_a of the dynamic pressure on the nodes [Pa/m].
  [[nodiscard]] const std::vector<double>& pressure_gradient(std::size_t component) const {
    return momentum_.component[component].pressure_gradient;
  }
  /// ∇·τ on the nodes, force per volume [N/m³].
  [[nodiscard]] const std::vector<double>& viscous_force(std::size_t component) const {
    return momentum_.component[component].viscous;
  }
  [[nodiscard]] double taken_by(const Exchange& exchange, std::size_t a) const final;
  /// Extrapolated from the two lowest layers.
  [[nodiscard]] double inlet_pressure() const final;
  [[nodiscard]] double continuity_error() const final { return continuity_error_; }
  [[nodiscard]] VerticalForces vertical_forces() const final { return vertical_forces_; }
  /// The projection in first order conserves it with the liquid volumes of the step before, which its convecting flow
  /// belongs to.
  [[nodiscard]] double vertical_momentum() const final;
  [[nodiscard]] LiquidCost cost() const final { return cost_; }

  /// velocity_x and so on [m/s] and viscous_x [N/m³] on the nodes, last_volume [m³] and pressure [Pa] per cell; of the
  /// step before (earlier_velocity_x, earlier_volume) only in second order, else empty.
  [[nodiscard]] NamedFields state() const final;
  void restore(const NamedFields& state) final;

 protected:
  StaggeredLiquid(const Scene& scene, LateralBoundary wall, bool closed, int threads);

  /// Velocity and pressure at the end of the step that momentum_ has started; records the vertical forces.
  virtual void solve(const Exchange& exchange) = 0;

  /// Momentum that leaves through the outlet with the convecting flow [N].
  [[nodiscard]] double outflow() const;
  void record_vertical_forces(double outflow);
  /// ∇p on the nodes from the pressure.
  void update_pressure_gradient();
  /// The same; each velocity follows the change by its mobility [m³/(N s)]: u −= m δ(∂p/∂x_a).
  void update_pressure_gradient(const std::array<std::vector<double>, 3>& mobility);

  ColumnGrid grid_;
  double density_;
  bool closed_;
  int threads_;
  MomentumEquations momentum_;
  std::vector<double> pressure_;  ///< per cell [Pa]
  double continuity_error_ = 0.0;
  LiquidCost cost_;

 private:
  template <bool correct_velocity>
  void set_pressure_gradient(const std::array<std::vector<double>, 3>& mobility);

  VerticalForces vertical_forces_;
};

}  // namespace slfb::fluid
