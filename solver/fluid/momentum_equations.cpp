#include "solver/fluid/momentum_equations.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace slfb::fluid {
namespace {

/// Value at a face less the upwind one, from the nodes far upstream, upstream and downstream of it.
template <ConvectionScheme scheme>
double face_excess([[maybe_unused]] double far, double upstream, double downstream) {
  if constexpr (scheme == ConvectionScheme::central) return 0.5 * (downstream - upstream);
  if constexpr (scheme == ConvectionScheme::quick) return 0.375 * downstream - 0.25 * upstream - 0.125 * far;
  if constexpr (scheme == ConvectionScheme::muscl) {
    // Van Leer's limiter: the harmonic mean of both differences, 0 at an extremum.
    const double behind = upstream - far, ahead = downstream - upstream, product = behind * ahead;
    return product > 0.0 ? product / (behind + ahead) : 0.0;
  }
  return 0.0;
}

/// What a flow from the lower to the upper node carries beyond upwind; the outer nodes lie behind them.
template <ConvectionScheme scheme>
double carried_excess(double flow, double below_lower, double lower, double upper, double above_upper) {
  const bool upwards = flow >= 0.0;
  return flow *
         face_excess<scheme>(upwards ? below_lower : above_upper, upwards ? lower : upper, upwards ? upper : lower);
}

}  // namespace

MomentumEquations::MomentumEquations(const ColumnGrid& grid, const Scene& scene, LateralBoundary wall, bool closed,
                                     int threads)
    : component{Component(grid, 0, wall, closed), Component(grid, 1, wall, closed), Component(grid, 2, wall, closed)},
      grid_(grid),
      density_(scene.liquid.density),
      viscosity_(scene.liquid.viscosity),
      convection_(scene.fluid.convection),
      time_scheme_(scene.fluid.time_scheme),
      inlet_velocity_(scene.fluid.inlet_velocity),
      closed_(closed),
      threads_(threads),
      settled_flow_(!closed && scene.fluid.pressure_velocity == PressureVelocity::projection &&
                    time_scheme_ == TimeScheme::euler && grid.cells() > 1),
      volume_change_(grid.size(), 0.0),
      dilatation_(grid.size(), 0.0),
      scratch_(as_index(threads)) {
  for (Component& c : component) {
    const std::size_t n = c.size();
    for (auto* field : {&c.fraction, &c.liquid_before, &c.liquid_now, &c.stressed, &c.velocity, &c.previous,
                        &c.pressure_gradient, &c.viscous, &c.flow, &c.inertia, &c.old_inertia, &c.diagonal,
                        &c.inverse_diagonal, &c.right_hand_side, &c.next})
      field->assign(n, 0.0);
    if (time_scheme_ == TimeScheme::second_order)
      for (auto* field : {&c.liquid_earlier, &c.earlier}) field->assign(n, 0.0);
    for (auto& flux : c.flux) flux.assign(n, 0.0);
    for (auto& coefficient : c.coefficient) coefficient.assign(n, 0.0);
    for (auto& of_threads : c.sweep_change) of_threads.resize(as_index(threads));
    for (auto& end : c.end) end.assign(as_index(c.sections), 0.0);
  }
  Component& c = component[vertical];
  const double inlet = scene.first_superficial_velocity();
  std::fill(c.end[0].begin(), c.end[0].end(), inlet);
  for (int s = 0; s < c.sections; ++s)
    for (int k = c.first; k <= c.last; ++k) c.velocity[index_of(s, k, c.levels)] = inlet;
}

void MomentumEquations::set_inlet_velocity(double velocity) {
  Component& c = component[vertical];
  c.inlet_before = c.end[0];
  std::fill(c.end[0].begin(), c.end[0].end(), velocity);
}

/// Liquid volumes on the nodes, inertia and old momentum, ∂V_L/∂t, the inlet's velocity, and the velocity that the
/// solution starts from: extrapolated in second order, so that everything explicit in it is of second order too.
void MomentumEquations::start_step(double time_step, const std::vector<double>& before, const std::vector<double>& now,
                                   const Exchange& exchange) {
  const bool goes_on = last_volume_.size() == before.size() &&
                       std::memcmp(last_volume_.data(), before.data(), before.size() * sizeof(double)) == 0;
  const bool second_order = time_scheme_ == TimeScheme::second_order && goes_on;
  // ∂f/∂t at the end of the step = at_now f^(n+1) − at_before f^n + at_earlier f^(n−1).
  const double at_now = (second_order ? 1.5 : 1.0) / time_step, at_before = (second_order ? 2.0 : 1.0) / time_step,
               at_earlier = 0.5 / time_step;
  per_step_ = at_now;
  // Equation (26): ∂V_L/∂t of each cell
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (std::size_t i = 0; i < volume_change_.size(); ++i) {
    volume_change_[i] = at_now * now[i] - at_before * before[i];
    if (second_order) volume_change_[i] += at_earlier * earlier_volume_[i];
  }
  const bool nodes_hold_before = goes_on && nodes_hold_last_volume_;
  for (Component& c : component)
    if (nodes_hold_before) std::swap(c.liquid_before, c.liquid_now);
  for_ranges([&](std::size_t a, SectionRange own, int) {
    Component& c = component[a];
    if (!nodes_hold_before) c.scatter(own, before, c.liquid_before);
    c.scatter(own, now, c.liquid_now);
    if (second_order) c.scatter(own, earlier_volume_, c.liquid_earlier);
    const std::size_t first = index_of(own.first, 0, c.levels), end = index_of(own.last, 0, c.levels);
    {  // α, and of Equation (27) ∂(α ρ u)/∂t: inertia ρ V_L/Δt and the velocity before
      const double *volume = c.volume.data(), *liquid_now = c.liquid_now.data(), *liquid = c.liquid_before.data(),
                   *velocity = c.velocity.data();
      double *fraction = c.fraction.data(), *inertia = c.inertia.data(), *old_inertia = c.old_inertia.data(),
             *previous = c.previous.data();
      const double factor = density_ * at_before;
#pragma omp simd
      for (std::size_t i = first; i < end; ++i) {
        fraction[i] = volume[i] > 0.0 ? liquid_now[i] / volume[i] : 0.0;
        inertia[i] = old_inertia[i] = factor * liquid[i];
        previous[i] = velocity[i];
      }
    }
    if (time_scheme_ != TimeScheme::second_order) return;
    for (std::size_t i = first; i < end; ++i) {
      if (second_order) {
        // The sum of both steps' momentum over the inertia stands for the old velocity.
        const double earlier_inertia = density_ * at_earlier * c.liquid_earlier[i];
        const double momentum = c.inertia[i] * c.velocity[i] - earlier_inertia * c.earlier[i];
        c.inertia[i] -= earlier_inertia;
        c.old_inertia[i] = c.inertia[i];
        c.velocity[i] = 2.0 * c.velocity[i] - c.earlier[i];
        c.earlier[i] = c.previous[i];
        if (c.inertia[i] > 0.0) c.previous[i] = momentum / c.inertia[i];
      } else {
        c.earlier[i] = c.previous[i];
      }
    }
  });
  if (time_scheme_ == TimeScheme::second_order) earlier_volume_ = before;
  last_volume_ = now;
  nodes_hold_last_volume_ = true;
  Component& c = component[vertical];
  for (int s = 0; s < c.sections; ++s)
    c.velocity[index_of(s, 0, c.levels)] = c.end[0][as_index(s)] / c.fraction[index_of(s, 1, c.levels)];
  put_stress_on(exchange);
}

/// Stress moves the liquid's own volume, and through the drag what the spheres pass on of theirs.
void MomentumEquations::put_stress_on(const Exchange& exchange) {
  for_ranges([&](std::size_t a, SectionRange own, int) {
    Component& c = component[a];
    const std::size_t first = index_of(own.first, 0, c.levels), end = index_of(own.last, 0, c.levels);
    std::copy(c.liquid_now.data() + first, c.liquid_now.data() + end, c.stressed.data() + first);
    if (exchange.volume[a].empty()) return;
    const double* volume = exchange.volume[a].data();
    double* stressed = c.stressed.data();
#pragma omp simd
    for (std::size_t n = first; n < end; ++n) stressed[n] += volume[n];
  });
}

void MomentumEquations::assemble(std::size_t a, SectionRange own, const Exchange& exchange, Scratch& scratch) {
  switch (convection_) {
    case ConvectionScheme::upwind:
      return assemble<ConvectionScheme::upwind>(a, own, exchange, scratch);
    case ConvectionScheme::central:
      return assemble<ConvectionScheme::central>(a, own, exchange, scratch);
    case ConvectionScheme::quick:
      return assemble<ConvectionScheme::quick>(a, own, exchange, scratch);
    case ConvectionScheme::muscl:
      return assemble<ConvectionScheme::muscl>(a, own, exchange, scratch);
  }
}

/// Momentum equations of a component (Eq. 27): implicit in time, upwind convection, diffusion and drag; a scheme of
/// higher order as a deferred correction.
///
/// Convection is written as Σ q (u_face − u_P), the conservative form minus u_P times continuity: it cannot create
/// momentum where q is still that of the last iteration.
///
/// The loops over the height are marked `simd`: the compiler cannot know that the many fields do not overlap.
///
/// A link between section nodes of two threads is computed by both: each keeps what concerns its own.
template <ConvectionScheme scheme>
void MomentumEquations::assemble(std::size_t a, SectionRange own, const Exchange& exchange, Scratch& scratch) {
  Component& c = component[a];
  const int levels = c.levels;
  const double density = density_, viscosity = viscosity_;
  const double* velocity = c.velocity.data();
  const std::size_t own_nodes = index_of(own.first, 0, levels), end_of_own_nodes = index_of(own.last, 0, levels);
  {  // Equation (27): ∂(α ρ u)/∂t, the drag of Equations (28) and (35), −α ∇p + α ∇·τ as it is before the solution
    const double *inertia = c.old_inertia.data(), *coefficient = exchange.coefficient[a].data(),
                 *source = exchange.source[a].data(), *previous = c.previous.data(), *stressed = c.stressed.data(),
                 *viscous = c.viscous.data(), *gradient = c.pressure_gradient.data();
    double *diagonal = c.diagonal.data(), *rhs = c.right_hand_side.data();
#pragma omp simd
    for (std::size_t n = own_nodes; n < end_of_own_nodes; ++n) {
      diagonal[n] = inertia[n] + coefficient[n];
      rhs[n] = inertia[n] * previous[n] + source[n] + stressed[n] * (viscous[n] - gradient[n]);
    }
  }
  const int first = c.first, last = c.last;
  const double *below = c.below.data(), *above = c.above.data();
  for (auto* field : {&scratch.excess, &scratch.right_hand_side, &scratch.diagonal, &scratch.coefficient})
    field->resize(as_index(levels) + 1);
  for (int s = 0; s < c.sections; ++s) {
    const std::size_t start = index_of(s, 0, levels);
    const double* u = velocity + start;
    const double* liquid = &c.stressed[start];
    double* rhs = own.has(s) ? &c.right_hand_side[start] : scratch.right_hand_side.data();
    double* diagonal = own.has(s) ? &c.diagonal[start] : scratch.diagonal.data();
    // Equation (21): α μ ∇²u, the node's own part
    const double stress = viscosity_ * c.own[as_index(s)];
    if (own.has(s)) {
#pragma omp simd
      for (int k = first; k <= last; ++k) diagonal[k] += stress * liquid[k];
    }

    // Equations (27), (21): ∇·(α ρ u u) and α μ ∇²u through the links along x and y
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t minus = 2 * axis, plus = minus + 1;
      const int t = c.neighbour[as_index(s)][plus];
      if (t < 0 || !(own.has(s) || own.has(t))) continue;
      // Beyond the two nodes of the link: the next node, or the value that the wall puts in its place.
      const int before = c.neighbour[as_index(s)][minus], after = c.neighbour[as_index(t)][plus];
      const std::size_t start_t = index_of(t, 0, levels);
      const double* u_t = velocity + start_t;
      const double* u_before = before >= 0 ? velocity + index_of(before, 0, levels) : u;
      const double* u_after = after >= 0 ? velocity + index_of(after, 0, levels) : u_t;
      const double part_before = before >= 0 ? 1.0 : c.mirror[minus][as_index(s)];
      const double part_after = after >= 0 ? 1.0 : c.mirror[plus][as_index(t)];
      const double stress_s = viscosity_ * c.lateral[plus][as_index(s)];
      const double stress_t = viscosity_ * c.lateral[minus][as_index(t)];
      const double* liquid_t = &c.stressed[start_t];
      const double* flux = &c.flux[axis][start];
      double* to_plus = own.has(s) ? &c.coefficient[plus][start] : scratch.coefficient.data();
      double* to_minus = own.has(t) ? &c.coefficient[minus][start_t] : scratch.coefficient.data();
      double* rhs_t = own.has(t) ? &c.right_hand_side[start_t] : scratch.right_hand_side.data();
      double* diagonal_t = own.has(t) ? &c.diagonal[start_t] : scratch.diagonal.data();
#pragma omp simd
      for (int k = first; k <= last; ++k) {
        const double flow = density * flux[k], onwards = std::max(flow, 0.0), back = onwards - flow;
        to_plus[k] = back + stress_s * liquid[k];
        to_minus[k] = onwards + stress_t * liquid_t[k];
        diagonal[k] += back;
        diagonal_t[k] += onwards;
        if constexpr (scheme != ConvectionScheme::upwind) {
          const double excess =
              carried_excess<scheme>(flow, part_before * u_before[k], u[k], u_t[k], part_after * u_after[k]);
          rhs[k] -= excess;
          rhs_t[k] += excess;
        }
      }
    }

    if (!own.has(s)) continue;
    // The same along z
    const double* flux = &c.flux[2][start];
    double *to_below = &c.coefficient[4][start], *to_above = &c.coefficient[5][start];
#pragma omp simd
    for (int k = first + 1; k <= last; ++k) {
      const double flow = density * flux[k], onwards = std::max(flow, 0.0);
      to_below[k] = onwards + viscosity * below[k] * liquid[k];
      to_above[k - 1] = onwards - flow + viscosity * above[k - 1] * liquid[k - 1];
    }
    if constexpr (scheme != ConvectionScheme::upwind) {
      double* excess = scratch.excess.data();
      const auto link = [=](int k, double below_lower, double above_upper) {
        excess[k] = carried_excess<scheme>(density * flux[k], below_lower, u[k - 1], u[k], above_upper);
      };
      const double bottom = a == vertical ? u[0] : 2.0 * c.end[0][as_index(s)] - u[0];
      const double top = c.last + 1 < levels ? u[levels - 1]
                         : closed_           ? 2.0 * c.end[1][as_index(s)] - u[c.last]
                                             : u[c.last];
      const int lowest = first + 1;
      excess[first] = excess[last + 1] = 0.0;
      if (lowest <= last) link(lowest, bottom, lowest < last ? u[lowest + 1] : top);
#pragma omp simd
      for (int k = lowest + 1; k < last; ++k) link(k, u[k - 2], u[k + 1]);
      if (lowest < last) link(last, u[last - 2], top);
#pragma omp simd
      for (int k = first; k <= last; ++k) rhs[k] = rhs[k] + excess[k] - excess[k + 1];
    }
    // Ends of the column: values given, of the vertical component on the grid's own levels.
    const double from_below =
        density * std::max(flux[c.first], 0.0) + viscosity_ * c.below[as_index(c.first)] * liquid[c.first];
    const double from_above = viscosity_ * c.above[as_index(c.last)] * liquid[c.last];
    diagonal[c.first] += from_below;
    diagonal[c.last] += from_above;
    rhs[c.first] += from_below * (a == vertical ? u[0] : c.end[0][as_index(s)]);
    if (a == vertical && inlet_velocity_ == InletVelocity::superficial)
      rhs[c.first] += density * std::max(flux[c.first], 0.0) * (entering_velocity(s) - u[0]);
    if (a != vertical) rhs[c.last] += from_above * c.end[1][as_index(s)];
  }
  {  // The diagonal is the sum of all weights, of the links along z last
    const double *to_below = c.coefficient[4].data(), *to_above = c.coefficient[5].data();
    double *diagonal = c.diagonal.data(), *inverse = c.inverse_diagonal.data();
#pragma omp simd
    for (std::size_t n = own_nodes; n < end_of_own_nodes; ++n) {
      diagonal[n] += to_below[n] + to_above[n];
      inverse[n] = diagonal[n] > 0.0 ? 1.0 / diagonal[n] : 0.0;
    }
  }
}

/// Equation (27) at the present pressure: flows, ∇·τ, equations, sweeps.
void MomentumEquations::solve(const Exchange& exchange) {
  settled_flow_ ? start_flows() : update_flows();
  start_viscous();
  for_ranges([&](std::size_t a, SectionRange own, int thread) {
    Scratch& scratch = scratch_[as_index(thread)];
    link_fluxes(a, own);
#pragma omp barrier
    if (a == vertical && settled_flow_) add_net_outflow(own);
    assemble(a, own, exchange, scratch);
    run_sweeps(a, own, thread, scratch);
    finish_viscous(a, own);
  });
  check_sweeps();
}

void MomentumEquations::assemble_column(const Exchange& exchange) {
  constexpr SectionRange all{0, 1};
  link_fluxes(vertical, all);
  start_viscous();
  assemble(vertical, all, exchange, scratch_.front());
}

void MomentumEquations::finish_column() { finish_viscous(vertical, {0, 1}); }

double MomentumEquations::vertical_momentum_rate() const {
  const Component& c = component[vertical];
  double rate = 0.0;
  for (int s = 0; s < c.sections; ++s)
    for (int k = c.first; k <= c.last; ++k) {
      const std::size_t n = index_of(s, k, c.levels);
      rate += density_ * per_step_ * c.liquid_now[n] * c.velocity[n] - c.old_inertia[n] * c.previous[n];
    }
  return rate;
}

void MomentumEquations::add_state(NamedFields& state) const {
  for (const Component& c : component) {
    state[fmt::format("velocity_{}", "xyz"[c.axis])] = c.velocity;
    state[fmt::format("viscous_{}", "xyz"[c.axis])] = c.viscous;
    state[fmt::format("earlier_velocity_{}", "xyz"[c.axis])] = c.earlier;
  }
  state["earlier_volume"] = earlier_volume_;
  state["last_volume"] = last_volume_;
  // A change of the inlet that no step has seen yet.
  if (const auto& inlet = component[vertical].inlet_before; !inlet.empty()) state["inlet_before"] = inlet;
}

void MomentumEquations::restore(const NamedFields& state) {
  for (Component& c : component) {
    c.velocity = field_of(state, fmt::format("velocity_{}", "xyz"[c.axis]), c.velocity.size());
    c.viscous = field_of(state, fmt::format("viscous_{}", "xyz"[c.axis]), c.viscous.size());
    c.earlier = field_of(state, fmt::format("earlier_velocity_{}", "xyz"[c.axis]), c.earlier.size());
  }
  earlier_volume_ = field_or_none(state, "earlier_volume", volume_change_.size());
  last_volume_ = field_or_none(state, "last_volume", volume_change_.size());
  nodes_hold_last_volume_ = false;
  component[vertical].inlet_before =
      state.contains("inlet_before") ? field_of(state, "inlet_before") : std::vector<double>{};
}

}  // namespace slfb::fluid
