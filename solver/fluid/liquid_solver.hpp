#pragma once

#include <array>
#include <stdexcept>
#include <vector>

#include "solver/fluid/column_grid.hpp"
#include "solver/fluid/section_mean_preconditioner.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::fluid {

/// A solve of the liquid has not converged or has left finite numbers; what() says which one and how far it came.
struct FluidError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the particles do to the liquid in one step, on the momentum nodes of each velocity component.
///
/// The drag on the liquid in node f is source_f − coefficient_f · u_f, with u_f at the end of the step.
struct Exchange {
  std::array<std::vector<double>, 3> coefficient;  ///< Σ φ_if K_i [kg/s]
  std::array<std::vector<double>, 3> source;       ///< Σ φ_if K_i v_i [N]
};

/// Volume-averaged continuity and momentum of the liquid (Peng 2014, Eqs. 26, 27) on a staggered ColumnGrid.
///
/// The pressure is the dynamic one, p + ρ g z, 0 at the outlet. Of Eq. 27's total force f_S-L the pressure-gradient and
/// viscous parts are taken into the liquid's own terms, −α ∇p + α ∇·τ, and the particles receive the other
/// (1 − α) parts, so that the sum of both phases feels −∇p + ∇·τ exactly. The viscous stress is μ ∇u.
///
/// A velocity component lives on the faces across its direction. Its control volume is made of the halves of the two
/// cells beside the face (the whole cell where the other side is a wall or the inlet), with the same shares for liquid
/// volume, forces and fluxes: a force scattered to the nodes and a velocity gathered from them are adjoint, which
/// makes the exchange of momentum exact.
class LiquidSolver {
 public:
  explicit LiquidSolver(const Scene& scene);

  [[nodiscard]] const ColumnGrid& grid() const { return grid_; }

  /// One step of the liquid from liquid volumes `before` to `now` (per cell [m³]).
  void advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
               const Exchange& exchange);

  /// Distributes an extensive cell quantity to the nodes of a component.
  void scatter(std::size_t component, const std::vector<double>& cells, std::vector<double>& nodes) const;
  /// Mean of a node quantity over the nodes of each cell: the adjoint of scatter.
  void gather(std::size_t component, const std::vector<double>& nodes, std::vector<double>& cells) const;
  [[nodiscard]] std::size_t nodes(std::size_t component) const { return component_[component].velocity.size(); }

  /// Interstitial liquid velocity on the nodes of a component [m/s].
  [[nodiscard]] const std::vector<double>& velocity(std::size_t component) const {
    return component_[component].velocity;
  }
  /// Dynamic pressure per cell [Pa].
  [[nodiscard]] const std::vector<double>& pressure() const { return pressure_; }
  /// ∂p/∂x_a of the dynamic pressure on the nodes [Pa/m].
  [[nodiscard]] const std::vector<double>& pressure_gradient(std::size_t component) const {
    return component_[component].pressure_gradient;
  }
  /// ∇·τ on the nodes, force per volume [N/m³].
  [[nodiscard]] const std::vector<double>& viscous_force(std::size_t component) const {
    return component_[component].viscous;
  }
  /// Section-mean dynamic pressure at the inlet, extrapolated from the two lowest layers [Pa].
  [[nodiscard]] double inlet_pressure() const;
  /// Largest violation of continuity over all cells at the last step, over the inlet's volume flow [-].
  [[nodiscard]] double continuity_error() const { return continuity_error_; }

  /// Fields that the next step starts from, for checkpoints: velocities, viscous forces, pressure.
  static constexpr std::array<const char*, 7> state_names{"velocity_x", "velocity_y", "velocity_z", "viscous_x",
                                                          "viscous_y",  "viscous_z",  "pressure"};
  [[nodiscard]] std::array<std::vector<double>, 7> state() const;
  void restore(const std::array<std::vector<double>, 7>& state);

 private:
  /// One velocity component: nodes numbered section node * levels + level.
  struct Component {
    int sections = 0;  ///< nodes in the section
    int levels = 0;
    std::vector<std::array<int, 4>> neighbour;  ///< section nodes towards −x, +x, −y, +y; −1 at a wall
    std::vector<std::array<int, 2>> owner;      ///< the two cells beside the node (x, y) or the cell twice (z)
    std::vector<std::array<double, 2>> share;   ///< of each owner's volume that belongs to the node (x, y)
    std::vector<double> wall;                   ///< wall length over wall distance, per section node [-]
    std::array<std::vector<double>, 2> lateral_conductance;  ///< of the links towards +x and +y, per height [-]
    std::vector<double> level_height;                        ///< height of a node's volume by level [m]
    std::vector<double> volume, liquid_before, liquid_now;   ///< [m³]
    std::vector<double> velocity, previous, pressure_gradient, viscous;
    std::array<std::vector<double>, 3>
        flux;  ///< liquid volume flow through the links towards +x, +y and from below [m³/s]
    std::vector<double> diagonal, right_hand_side, next, mobility;
  };

  void build_component(std::size_t a);
  [[nodiscard]] double face_area(std::size_t a, int section) const;
  [[nodiscard]] double spacing(std::size_t a, int level) const;
  void face_flows(std::array<std::vector<double>, 3>& flow) const;
  void link_fluxes(std::size_t a, const std::array<std::vector<double>, 3>& flow);
  void predict(std::size_t a, double time_step, const Exchange& exchange);
  void update_viscous(std::size_t a);
  void update_pressure_gradient();
  double correct_pressure(double time_step, const std::vector<double>& before, const std::vector<double>& now,
                          const Exchange& exchange);
  void assemble_pattern();

  ColumnGrid grid_;
  double density_, viscosity_, superficial_velocity_, pressure_tolerance_, simple_tolerance_;
  LateralBoundary wall_;
  ConvectionScheme convection_;
  PressureVelocity pressure_velocity_;
  std::array<Component, 3> component_;
  std::vector<double> pressure_;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<std::array<double*, 2>> lower_entry_;  ///< per node: both off-diagonal entries of its two cells
  std::vector<double*> diagonal_entry_;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper, SectionMeanPreconditioner> solver_;
  double continuity_error_ = 0.0;
};

}  // namespace slfb::fluid
