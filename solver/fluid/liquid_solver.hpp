#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "solver/fluid/column_grid.hpp"
#include "solver/fluid/pressure_equation.hpp"
#include "solver/scene/scene.hpp"
#include "solver/support/named_fields.hpp"

namespace slfb::fluid {

/// A solve of the liquid has not converged or has left finite numbers; what() says which one and how far it came.
struct FluidError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the particles do to the liquid in one step, on the momentum nodes of each velocity component.
///
/// The force on the liquid in node f is source_f − coefficient_f · u_f + volume_f (−∇p + ∇·τ)_f, with all three at the
/// end of the step.
struct Exchange {
  std::array<std::vector<double>, 3> coefficient;  ///< Σ φ_if K_i [kg/s]
  std::array<std::vector<double>, 3> source;       ///< Σ φ_if K_i v_i [N]
  std::array<std::vector<double>, 3> volume;       ///< of spheres that pass their stress on; empty: none [m³]
};

/// Volume-averaged continuity and momentum of the liquid (Peng 2014, Eqs. 21, 26, 27) on a staggered ColumnGrid.
///
/// The pressure is the dynamic one, p + ρ g z, 0 at the outlet. Of Eq. 27's total force f_S-L the pressure-gradient and
/// viscous parts are taken into the liquid's own terms, −α ∇p + α ∇·τ, and the particles receive the other
/// (1 − α) parts, so that the sum of both phases feels −∇p + ∇·τ exactly. With constant μ, Eq. 21 gives
/// ∇·τ = μ ∇²u + ⅓ μ ∇(∇·u).
///
/// A velocity component lives on the faces across its direction. Its control volume is made of the halves of the two
/// cells beside the face (the whole cell where the other side is a wall or the inlet), with the same shares for liquid
/// volume, forces and fluxes: a force scattered to the nodes and a velocity gathered from them are adjoint, which
/// makes the exchange of momentum exact. Viscous stresses reach to where the wall cuts the axes through a node.
///
/// A section of a single cell needs no pressure equation: continuity alone gives the velocity, and the momentum
/// balance then the pressure gradient.
class LiquidSolver {
 public:
  /// A closed liquid has walls at z = 0 and z = height instead of the inlet and the outlet: no scene, but cavities and
  /// vortices with exact solutions.
  explicit LiquidSolver(const Scene& scene, bool closed = false, int threads = 1);

  [[nodiscard]] const ColumnGrid& grid() const { return grid_; }

  /// One step of the liquid from liquid volumes `before` to `now` (per cell [m³]). In second order the time step stays
  /// the same; where `before` is not the last step's `now` (a sphere was put in), the scheme starts anew with Euler.
  void advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
               const Exchange& exchange);

  /// Distributes an extensive cell quantity to the nodes of a component.
  void scatter(std::size_t component, const std::vector<double>& cells, std::vector<double>& nodes) const;
  /// Mean of a node quantity over the nodes of each cell: the adjoint of scatter.
  void gather(std::size_t component, const std::vector<double>& nodes, std::vector<double>& cells) const;
  /// The same for all components of the velocity [m/s] and of the stress −∇p + ∇·τ with the dynamic pressure [N/m³].
  void gather(std::array<std::vector<double>, 3>& velocity, std::array<std::vector<double>, 3>& stress) const;
  /// Puts together an exchange from what is given per cell: coefficient, source along x, y, z, volume.
  void scatter(const std::array<std::vector<double>, 5>& cells, Exchange& exchange) const;
  [[nodiscard]] std::size_t nodes(std::size_t component) const { return component_[component].velocity.size(); }
  /// Where the velocity of a node is that of the liquid [m].
  [[nodiscard]] std::array<double, 3> position(std::size_t component, std::size_t node) const;

  /// Velocity given at z = 0 (side 0) and, for the lateral components of a closed liquid, at z = height (side 1), per
  /// section node [m/s]. For the vertical component it is the superficial velocity α w. A scene's liquid enters with
  /// its superficial_velocity.
  [[nodiscard]] std::vector<double>& end_velocity(std::size_t component, std::size_t side) {
    return component_[component].end[side];
  }

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

  /// What acted on the liquid and the spheres in it along z over the last step, by the liquid's own equations [N]: the
  /// sum over all nodes of the pressure's and the viscous forces on whole volumes, so on both phases, and the momentum
  /// that came in and went out with the flow.
  struct VerticalForces {
    double pressure = 0.0, stress = 0.0, inflow = 0.0, outflow = 0.0;
  };
  [[nodiscard]] const VerticalForces& vertical_forces() const { return vertical_forces_; }
  /// Σ ρ V_L w [kg m/s]. The projection in first order conserves it with the liquid volumes of the step before, which
  /// its convecting flow belongs to.
  [[nodiscard]] double vertical_momentum() const;

  /// Wall time spent so far on the momentum equations and on the pressure equation [s], and its iterations.
  struct Cost {
    double momentum_seconds = 0.0, pressure_seconds = 0.0;
    std::int64_t pressure_iterations = 0;
  };
  [[nodiscard]] const Cost& cost() const { return cost_; }

  /// Fields that the next step starts from, for checkpoints: velocity_x and so on [m/s] and viscous_x [N/m³] on the
  /// nodes, last_volume [m³] and pressure [Pa] per cell; of the step before (earlier_velocity_x, earlier_volume) only
  /// in second order, else empty.
  [[nodiscard]] NamedFields state() const;
  /// \throws std::runtime_error if a field is missing
  void restore(const NamedFields& state);

 private:
  /// One velocity component: nodes numbered section node * levels + level.
  struct Component {
    int sections = 0;                           ///< nodes in the section
    int levels = 0;                             ///< nodes over the height
    int first = 0, last = 0;                    ///< levels that are solved for; the others are given
    std::vector<std::array<int, 4>> neighbour;  ///< section nodes towards −x, +x, −y, +y; −1 at a wall
    std::vector<std::array<int, 2>> owner;      ///< the two cells beside the node (x, y) or the cell twice (z)
    std::vector<std::array<double, 2>> share;   ///< of each owner's volume that belongs to the node
    /// Weights in ∇² of the four neighbours, less those of the node and its walls, and by level of the nodes below and
    /// above [1/m²]; and the part of a node's value that stands for a missing neighbour in convection.
    std::array<std::vector<double>, 4> lateral, mirror;
    std::vector<double> own, below, above;
    std::array<std::vector<double>, 2> end;                         ///< velocity given at z = 0 and z = height [m/s]
    std::vector<double> volume, fraction;                           ///< [m³]; of liquid [-]
    std::vector<double> liquid_earlier, liquid_before, liquid_now;  ///< liquid volumes [m³]
    std::vector<double> stressed;                                   ///< liquid_now and Exchange::volume [m³]
    std::vector<double> velocity, previous, earlier, pressure_gradient, viscous;
    std::vector<double> flow;                 ///< of liquid volume through the node's face [m³/s]
    std::array<std::vector<double>, 3> flux;  ///< the same through the links towards +x and +y and from below [m³/s]
    /// The momentum equations: weights of the neighbours towards −x, +x, −y, +y, −z, +z [kg/s].
    std::array<std::vector<double>, 6> coefficient;
    std::vector<double> inertia, old_inertia, diagonal, inverse_diagonal, right_hand_side, next, mobility;
    /// What each thread tells of a sweep, of two sweeps in turn: largest change, largest velocity [m/s].
    std::array<std::vector<std::array<double, 2>>, 2> told;
    double unsettled = 0.0, largest = 0.0;  ///< change that the sweeps leave to come, largest velocity [m/s]
  };

  /// Section nodes of a component.
  struct Range {
    int first, last;
    [[nodiscard]] bool has(int s) const { return s >= first && s < last; }
  };
  /// Of one thread, per level: what convection carries beyond upwind; largest change and velocity of a sweep; and where
  /// goes what a link gives to a node of another thread.
  struct Scratch {
    std::vector<double> excess, change, peak, right_hand_side, diagonal, coefficient;
  };

  /// Calls work(component, its section nodes that are the thread's, thread) on every thread; the threads share each
  /// component in the same way always, so that what one of them has written is in its own cache.
  template <class Work>
  void for_ranges(Work work) const;
  /// The same, section node by section node: work(component, section node).
  template <class Work>
  void for_sections(Work work) const;
  /// Means over the nodes of one cell of the section, layer by layer; value(node).
  template <class Value>
  void gather_values(std::size_t a, int cell, const Value& value, double* result) const;
  void scatter(std::size_t component, Range own, const std::vector<double>& cells, std::vector<double>& nodes) const;
  void build_component(std::size_t a);
  void build_stencil(std::size_t a);
  void start_step(double time_step, const std::vector<double>& before, const std::vector<double>& now);
  void put_stress_on(const Exchange& exchange);
  [[nodiscard]] double face_area(std::size_t a, int section) const;
  [[nodiscard]] double spacing(std::size_t a, int level) const;
  void start_flows();
  void update_flows();
  void add_net_outflow(Range own);
  void link_fluxes(std::size_t a, Range own);
  void start_viscous();
  template <ConvectionScheme scheme>
  void assemble(std::size_t a, Range own, const Exchange& exchange, Scratch& scratch);
  void assemble(std::size_t a, Range own, const Exchange& exchange, Scratch& scratch);
  void solve_momentum(std::size_t a, Range own, int thread, Scratch& scratch);
  void check_momentum() const;
  void record_vertical_forces(double outflow);
  [[nodiscard]] double outflow() const;
  void finish_viscous(std::size_t a, Range own);
  template <bool correct_velocity>
  void update_pressure_gradient();
  double correct_pressure(const Exchange& exchange);
  void balance_column(const Exchange& exchange);

  ColumnGrid grid_;
  double density_, viscosity_, superficial_velocity_, pressure_tolerance_, simple_tolerance_;
  LateralBoundary wall_;
  ConvectionScheme convection_;
  TimeScheme time_scheme_;
  PressureVelocity pressure_velocity_;
  bool closed_;
  int threads_;
  /// In first order the projection convects with the flow of the step's start, whose continuity is settled: momentum is
  /// then conserved. Iterations and extrapolated velocities bring flows of their own.
  bool settled_flow_;
  std::array<Component, 3> component_;
  std::vector<double> pressure_;
  std::vector<double> volume_change_;    ///< ∂V_L/∂t per cell [m³/s]
  std::vector<double> dilatation_;       ///< ∇·u per cell [1/s]
  std::vector<double> earlier_volume_;   ///< second order: liquid at the start of the last step [m³]
  std::vector<double> last_volume_;      ///< liquid at the end of the last step [m³]
  bool nodes_hold_last_volume_ = false;  ///< Component::liquid_now is last_volume_, scattered
  PressureEquation pressure_equation_;
  std::vector<double> imbalance_, correction_;
  std::vector<Scratch> scratch_;  ///< per thread
  double continuity_error_ = 0.0;
  VerticalForces vertical_forces_;
  Cost cost_;
};

}  // namespace slfb::fluid
