#include <algorithm>

#include "solver/fluid/momentum_equations.hpp"

// What flows through the control volumes of the nodes: liquid volume, and the viscous part of the stress.
namespace slfb::fluid {

/// Volume flow of liquid α u A through every cell face at the start of the step, for which continuity holds.
void MomentumEquations::start_flows() {
  for_sections([this](std::size_t a, int s) {
    Component& c = component[a];
    const double area = c.face_area(s);
    const std::size_t start = index_of(s, 0, c.levels);
    const double *volume = &c.volume[start], *liquid = &c.liquid_before[start], *velocity = &c.velocity[start];
    double* flow = &c.flow[start];
    const int levels = c.levels;
#pragma omp simd
    for (int k = 0; k < levels; ++k) flow[k] = volume[k] > 0.0 ? liquid[k] / volume[k] * area * velocity[k] : 0.0;
    if (a == vertical) flow[0] = convected_inlet()[as_index(s)] * area;
  });
}

/// Volume flow of liquid α u A through every cell face, on the nodes.
void MomentumEquations::update_flows() {
  for_sections([this](std::size_t a, int s) {
    Component& c = component[a];
    const double area = c.face_area(s);
    const std::size_t start = index_of(s, 0, c.levels);
    const double *fraction = &c.fraction[start], *velocity = &c.velocity[start];
    double* flow = &c.flow[start];
    const int levels = c.levels;
#pragma omp simd
    for (int k = 0; k < levels; ++k) flow[k] = fraction[k] * area * velocity[k];
    if (a == vertical) flow[0] = c.end[0][as_index(s)] * area;
  });
}

/// Flow through the links between the control volumes of a component: each cell's face flow counts with the share that
/// the cell has in the node, so that the node's continuity is the sum of its cells' continuities.
void MomentumEquations::link_fluxes(std::size_t a, SectionRange own) {
  Component& c = component[a];
  const int layers = grid_.layers();
  if (a == vertical) {
    for (int s = own.first; s < own.last; ++s) {
      for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(s, axis, 1);
        if (face < 0) continue;
        const double* flow = &component[axis].flow[index_of(face, 0, layers)];
        double* flux = &c.flux[axis][index_of(s, 0, c.levels)];
        for (int k = c.first; k < layers; ++k) flux[k] = 0.5 * (flow[k - 1] + flow[k]);
        // The ends of the first node's volume, and of the last one's.
        if (c.last == layers) flux[layers] = 0.5 * flow[layers - 1];
        flux[c.first] += 0.5 * flow[0];
        if (closed_) flux[c.last] += 0.5 * flow[layers - 1];
      }
      // From below: the inlet for the first free node, else the mean of the two faces of the cell in between.
      const double* flow = &c.flow[index_of(s, 0, c.levels)];
      double* flux = &c.flux[2][index_of(s, 0, c.levels)];
      flux[1] = flow[0];
      for (int k = 2; k < c.levels; ++k) flux[k] = 0.5 * (flow[k - 1] + flow[k]);
    }
    return;
  }
  const std::size_t cross = 1 - a;
  for (int s = own.first; s < own.last; ++s) {
    const auto& owner = c.owner[as_index(s)];
    const auto& share = c.share[as_index(s)];
    const std::size_t start = index_of(s, 0, layers);
    const int next = c.neighbour[as_index(s)][2 * a + 1];
    if (next >= 0) {
      const double *here = &c.flow[start], *there = &c.flow[index_of(next, 0, layers)];
      for (std::size_t k = 0; k < as_index(layers); ++k) c.flux[a][start + k] = 0.5 * (here[k] + there[k]);
    }
    if (c.neighbour[as_index(s)][2 * cross + 1] >= 0) {
      const double* first = &component[cross].flow[index_of(grid_.face_of(owner[0], cross, 1), 0, layers)];
      const double* second = &component[cross].flow[index_of(grid_.face_of(owner[1], cross, 1), 0, layers)];
      for (std::size_t k = 0; k < as_index(layers); ++k)
        c.flux[cross][start + k] = share[0] * first[k] + share[1] * second[k];
    }
    const double* first = &component[vertical].flow[index_of(owner[0], 0, layers + 1)];
    const double* second = &component[vertical].flow[index_of(owner[1], 0, layers + 1)];
    for (std::size_t k = 0; k < as_index(layers); ++k)
      c.flux[2][start + k] = share[0] * first[k] + share[1] * second[k];
  }
}

/// Makes the vertical momentum's old content that of the liquid volumes which the convecting flow has filled from:
/// V^(n−1) = V^n + Δt Σ flow out. With it Σ q (u_face − u_P) is conservative although q is that of the step before.
void MomentumEquations::add_net_outflow(SectionRange own) {
  Component& c = component[vertical];
  const int layers = grid_.layers();
  for (int s = 0; s < c.sections; ++s) {
    const std::size_t start = index_of(s, 0, c.levels);
    double* inertia = &c.old_inertia[start];
    if (own.has(s)) {
      const double *up = &c.flux[2][start], *flow = &c.flow[start];
      for (int k = 1; k < layers; ++k) inertia[k] += density_ * (up[k + 1] - up[k]);
      inertia[layers] += density_ * (flow[layers] - up[layers]);
    }
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const int t = c.neighbour[as_index(s)][2 * axis + 1];
      if (t < 0) continue;
      double* beyond = &c.old_inertia[index_of(t, 0, c.levels)];
      const double* flux = &c.flux[axis][start];
      if (own.has(s))
        for (int k = 1; k <= layers; ++k) inertia[k] += density_ * flux[k];
      if (own.has(t))
        for (int k = 1; k <= layers; ++k) beyond[k] -= density_ * flux[k];
    }
  }
}

/// The part ⅓ μ ∇(∇·u) of ∇·τ from the velocity before the solution: with the implicit ∇² beside it, it is stable at
/// any time step.
void MomentumEquations::start_viscous() {
  const int layers = grid_.layers();
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (int cell = 0; cell < grid_.cells(); ++cell) {
    const double *velocity = &component[vertical].velocity[index_of(cell, 0, layers + 1)],
                 per_height = 1.0 / grid_.cell_height();
    double* dilatation = &dilatation_[index_of(cell, 0, layers)];
#pragma omp simd
    for (int k = 0; k < layers; ++k) dilatation[k] = (velocity[k + 1] - velocity[k]) * per_height;
    for (std::size_t a : {std::size_t{0}, std::size_t{1}})
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(cell, a, side);
        if (face < 0) continue;
        const double *through = &component[a].velocity[index_of(face, 0, layers)],
                     weight = (side == 0 ? -1.0 : 1.0) * grid_.faces(a)[as_index(face)].length / grid_.area(cell);
#pragma omp simd
        for (int k = 0; k < layers; ++k) dilatation[k] += weight * through[k];
      }
  }
  for_sections([this, layers](std::size_t a, int s) {
    Component& c = component[a];
    const double factor = viscosity_ / 3.0 / (a == vertical ? grid_.cell_height() : grid_.spacing(a));
    const auto& owner = c.owner[as_index(s)];
    const double *lower = &dilatation_[index_of(owner[0], 0, layers)],
                 *upper = &dilatation_[index_of(owner[1], 0, layers)];
    double* viscous = &c.viscous[index_of(s, 0, c.levels)];
    if (a == vertical) {
#pragma omp simd
      for (int k = 1; k < layers; ++k) viscous[k] = factor * (upper[k] - lower[k - 1]);
      if (!closed_) viscous[layers] = 0.0;  // ∇·u goes on unchanged past the outlet
    } else {
#pragma omp simd
      for (int k = 0; k < layers; ++k) viscous[k] = factor * (upper[k] - lower[k]);
    }
  });
}

/// Adds μ ∇²u of the present velocity to the part that start_viscous has left: ∇·τ on the nodes.
void MomentumEquations::finish_viscous(std::size_t a, SectionRange own) {
  Component& c = component[a];
  const int levels = c.levels;
  for (int s = own.first; s < own.last; ++s) {
    const std::size_t start = index_of(s, 0, levels);
    const double* u = &c.velocity[start];
    double* viscous = &c.viscous[start];
    std::array<const double*, 4> next_to{u, u, u, u};
    std::array<double, 4> weight{};
    const double own_weight = viscosity_ * c.own[as_index(s)];
    for (std::size_t direction = 0; direction < 4; ++direction) {
      const int t = c.neighbour[as_index(s)][direction];
      if (t < 0) continue;
      next_to[direction] = &c.velocity[index_of(t, 0, levels)];
      weight[direction] = viscosity_ * c.lateral[direction][as_index(s)];
    }
    const double *below = c.below.data(), *above = c.above.data();
    const double viscosity = viscosity_;
    const int first = c.first, last = c.last;
    const double *left = next_to[0], *right = next_to[1], *front = next_to[2], *back = next_to[3];
#pragma omp simd
    for (int k = first; k <= last; ++k)
      viscous[k] +=
          weight[0] * left[k] + weight[1] * right[k] + weight[2] * front[k] + weight[3] * back[k] - own_weight * u[k];
    const double bottom = a == vertical ? u[0] : c.end[0][as_index(s)];
    const double top = c.last + 1 < levels ? u[levels - 1] : c.end[1][as_index(s)];
#pragma omp simd
    for (int k = first; k < last; ++k) viscous[k] += viscosity * above[k] * (u[k + 1] - u[k]);
#pragma omp simd
    for (int k = first + 1; k <= last; ++k) viscous[k] += viscosity * below[k] * (u[k - 1] - u[k]);
    viscous[c.first] += viscosity_ * below[c.first] * (bottom - u[c.first]);
    viscous[c.last] += viscosity_ * above[c.last] * (top - u[c.last]);
  }
}

}  // namespace slfb::fluid
