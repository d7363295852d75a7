#pragma once

#include <omp.h>

#include <array>
#include <vector>

#include "solver/fluid/liquid.hpp"
#include "solver/fluid/momentum_nodes.hpp"

namespace slfb::fluid {

/// Volume-averaged momentum of the liquid (Peng 2014, Eq. 27) on the nodes of a staggered ColumnGrid, component by
/// component, with what a step needs of the liquid volumes around it.
///
///   ∂(α ρ u)/∂t + ∇·(α ρ u u) = −α ∇p + α ∇·τ + drag,   ∇·τ = μ ∇²u + ⅓ μ ∇(∇·u)  (Eq. 21 with constant μ)
///
/// Of Eq. 27's total force f_S-L the pressure-gradient and viscous parts are taken into the liquid's own terms, −α ∇p +
/// α ∇·τ, and the spheres receive the other (1 − α) parts, so that the sum of both phases feels −∇p + ∇·τ exactly. What
/// is solved for is implicit in upwind convection, diffusion and drag; schemes of higher order are deferred
/// corrections. Viscous stresses reach to where the wall cuts the axes through a node.
///
/// Fields of a component are numbered as its MomentumNodes. The threads share the section nodes of each component in
/// the same way always, so that what one of them has written is in its own cache; results do not depend on their
/// number.
class MomentumEquations {
 public:
  /// \param wall of the sides; \param closed walls at z = 0 and z = height instead of inlet and outlet
  MomentumEquations(const ColumnGrid& grid, const Scene& scene, LateralBoundary wall, bool closed, int threads);

  struct Component : MomentumNodes {
    using MomentumNodes::MomentumNodes;
    std::array<std::vector<double>, 2> end;                         ///< velocity given at z = 0 and z = height [m/s]
    std::vector<double> fraction;                                   ///< α, of liquid [-]
    std::vector<double> liquid_earlier, liquid_before, liquid_now;  ///< liquid volumes [m³]
    std::vector<double> stressed;                                   ///< liquid_now and Exchange::volume [m³]
    std::vector<double> velocity, previous, earlier;                ///< now, one and two steps ago [m/s]
    std::vector<double> pressure_gradient;                          ///< ∂p/∂x_a of the dynamic pressure [Pa/m]
    std::vector<double> viscous;                                    ///< ∇·τ [N/m³]
    std::vector<double> inlet_before;         ///< velocity given at z = 0 before a change of it, else empty [m/s]
    std::vector<double> flow;                 ///< of liquid volume through the node's face [m³/s]
    std::array<std::vector<double>, 3> flux;  ///< the same through the links towards +x and +y and from below [m³/s]
    /// The momentum equations: weights of the neighbours towards −x, +x, −y, +y, −z, +z [kg/s].
    std::array<std::vector<double>, 6> coefficient;
    std::vector<double> inertia, old_inertia, diagonal, inverse_diagonal;  ///< [kg/s]
    std::vector<double> right_hand_side;                                   ///< [N]
    std::vector<double> next;                                              ///< velocity after the present sweep [m/s]
    /// Largest change and largest velocity of a sweep by thread [m/s], of two sweeps in turn.
    std::array<std::vector<std::array<double, 2>>, 2> sweep_change;
    double unsettled = 0.0, largest = 0.0;  ///< change that the sweeps leave to come, largest velocity [m/s]
  };
  std::array<Component, 3> component;

  /// ∂V_L/∂t per cell in the present step [m³/s].
  [[nodiscard]] const std::vector<double>& volume_change() const { return volume_change_; }
  /// Σ over the vertical nodes of ∂(ρ V_L w)/∂t, as the time scheme forms it [N]; after the solution.
  [[nodiscard]] double vertical_momentum_rate() const;
  /// In first order the projection convects with the flow of the step's start, whose continuity is settled: momentum is
  /// then conserved. Iterations and extrapolated velocities bring flows of their own.
  [[nodiscard]] bool settled_flow() const { return settled_flow_; }
  [[nodiscard]] bool of_second_order() const { return time_scheme_ == TimeScheme::second_order; }

  /// Velocity α w of the liquid that enters over the whole section from the next step on [m/s].
  void set_inlet_velocity(double velocity);
  /// The same for the flow that brings momentum in: where the flow is that of the step's start, from before a change.
  [[nodiscard]] const std::vector<double>& convected_inlet() const {
    const Component& c = component[vertical];
    return settled_flow_ && !c.inlet_before.empty() ? c.inlet_before : c.end[0];
  }
  /// Velocity whose momentum enters through section node s [m/s]: fluid.inlet_velocity.
  [[nodiscard]] double entering_velocity(int s) const {
    const Component& c = component[vertical];
    return inlet_velocity_ == InletVelocity::superficial ? c.end[0][as_index(s)] : c.velocity[index_of(s, 0, c.levels)];
  }
  /// The step is over: the liquid has entered with its present velocity.
  void end_step() { component[vertical].inlet_before.clear(); }

  /// Starts a step from liquid volumes `before` to `now` per cell [m³]. In second order the time step stays the same;
  /// where `before` is not the last step's `now` (a sphere was put in), the scheme starts anew with Euler.
  void start_step(double time_step, const std::vector<double>& before, const std::vector<double>& now,
                  const Exchange& exchange);
  /// Solves all components for the velocity at the present pressure. \throws FluidError if the sweeps do not settle or
  /// a velocity is not finite
  void solve(const Exchange& exchange);
  /// Volume flow of liquid α u A through every cell face, on the nodes.
  void update_flows();

  /// For a section of a single cell, whose velocity and flow are known: sets up the vertical equations, and afterwards
  /// the viscous force.
  void assemble_column(const Exchange& exchange);
  void finish_column();

  /// Velocities and viscous forces, last_volume; of the step before only in second order, else empty.
  void add_state(NamedFields& state) const;
  void restore(const NamedFields& state);

  /// Calls work(component, its section nodes that are the thread's, thread) on every thread.
  template <class Work>
  void for_ranges(Work work) const {
#pragma omp parallel num_threads(threads_)
    {
      const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
      for (std::size_t a = 0; a < 3; ++a) {
        const int sections = component[a].sections;
        work(a, SectionRange{sections * thread / threads, sections * (thread + 1) / threads}, thread);
      }
    }
  }
  /// The same, section node by section node: work(component, section node).
  template <class Work>
  void for_sections(Work work) const {
    for_ranges([&](std::size_t a, SectionRange own, int) {
      for (int s = own.first; s < own.last; ++s) work(a, s);
    });
  }

 private:
  /// Of one thread, per level: what convection carries beyond upwind; largest change and velocity of a sweep; and where
  /// goes what a link gives to a node of another thread.
  struct Scratch {
    std::vector<double> excess, change, peak, right_hand_side, diagonal, coefficient;
  };

  void put_stress_on(const Exchange& exchange);
  void start_flows();
  void link_fluxes(std::size_t a, SectionRange own);
  void add_net_outflow(SectionRange own);
  void start_viscous();
  void finish_viscous(std::size_t a, SectionRange own);
  template <ConvectionScheme scheme>
  void assemble(std::size_t a, SectionRange own, const Exchange& exchange, Scratch& scratch);
  void assemble(std::size_t a, SectionRange own, const Exchange& exchange, Scratch& scratch);
  void run_sweeps(std::size_t a, SectionRange own, int thread, Scratch& scratch);
  void check_sweeps() const;

  const ColumnGrid& grid_;
  double density_, viscosity_;
  ConvectionScheme convection_;
  TimeScheme time_scheme_;
  InletVelocity inlet_velocity_;
  bool closed_;
  int threads_;
  bool settled_flow_;
  double per_step_ = 0.0;                ///< factor of the new momentum in ∂/∂t [1/s]
  std::vector<double> volume_change_;    ///< ∂V_L/∂t per cell [m³/s]
  std::vector<double> dilatation_;       ///< ∇·u per cell [1/s]
  std::vector<double> earlier_volume_;   ///< second order: liquid at the start of the last step [m³]
  std::vector<double> last_volume_;      ///< liquid at the end of the last step [m³]
  bool nodes_hold_last_volume_ = false;  ///< Component::liquid_now is last_volume_, scattered
  std::vector<Scratch> scratch_;         ///< per thread
};

}  // namespace slfb::fluid
