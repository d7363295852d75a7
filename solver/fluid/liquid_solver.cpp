#include "solver/fluid/liquid_solver.hpp"

#include <fmt/core.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "solver/support/stopwatch.hpp"

namespace slfb::fluid {
namespace {

constexpr std::size_t vertical = 2;

/// Of the momentum equations' sweeps: what is still to come, over the largest velocity, that ends them [-], and how
/// many there may be.
constexpr double momentum_tolerance = 1e-10;
constexpr int most_sweeps = 5000;

std::size_t index(int section, int level, int levels) {
  return static_cast<std::size_t>(section) * static_cast<std::size_t>(levels) + static_cast<std::size_t>(level);
}

std::size_t as_index(int value) { return static_cast<std::size_t>(value); }

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

LiquidSolver::LiquidSolver(const Scene& scene, bool closed, int threads)
    : grid_(scene),
      density_(scene.liquid.density),
      viscosity_(scene.liquid.viscosity),
      superficial_velocity_(scene.liquid.superficial_velocity),
      pressure_tolerance_(scene.fluid.pressure_tolerance),
      simple_tolerance_(scene.fluid.simple_tolerance),
      wall_(scene.fluid.tier == FluidTier::three_dimensional ? scene.fluid.wall : LateralBoundary::slip),
      convection_(scene.fluid.convection),
      time_scheme_(scene.fluid.time_scheme),
      pressure_velocity_(scene.fluid.pressure_velocity),
      closed_(closed),
      threads_(threads),
      settled_flow_(!closed && pressure_velocity_ == PressureVelocity::projection &&
                    time_scheme_ == TimeScheme::euler && grid_.cells() > 1),
      pressure_(grid_.size(), 0.0),
      volume_change_(grid_.size(), 0.0),
      dilatation_(grid_.size(), 0.0),
      pressure_equation_(grid_, closed, threads),
      imbalance_(grid_.size(), 0.0),
      correction_(grid_.size(), 0.0),
      scratch_(as_index(threads)) {
  for (std::size_t a = 0; a < 3; ++a) build_component(a);
}

void LiquidSolver::build_component(std::size_t a) {
  Component& c = component_[a];
  const int layers = grid_.layers();
  const auto across = [&](int cell, std::size_t axis, std::size_t side) {
    const int face = grid_.face_of(cell, axis, side);
    if (face < 0) return -1;
    const auto& f = grid_.faces(axis)[as_index(face)];
    return side == 0 ? f.first : f.second;
  };
  c.sections = a == vertical ? grid_.cells() : static_cast<int>(grid_.faces(a).size());
  c.levels = a == vertical ? layers + 1 : layers;
  c.first = a == vertical ? 1 : 0;
  c.last = a == vertical && closed_ ? layers - 1 : c.levels - 1;
  for (int s = 0; s < c.sections; ++s) {
    std::array<int, 4> neighbour{-1, -1, -1, -1};
    if (a == vertical) {
      for (std::size_t axis : {std::size_t{0}, std::size_t{1}})
        for (std::size_t side : {std::size_t{0}, std::size_t{1}}) neighbour[2 * axis + side] = across(s, axis, side);
      c.owner.push_back({s, s});
      c.share.push_back({0.5, 0.5});
    } else {
      const auto& face = grid_.faces(a)[as_index(s)];
      const std::size_t cross = 1 - a;
      neighbour[2 * a] = grid_.face_of(face.first, a, 0);
      neighbour[2 * a + 1] = grid_.face_of(face.second, a, 1);
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const int first = across(face.first, cross, side), second = across(face.second, cross, side);
        if (first < 0 || second < 0) continue;
        const int candidate = grid_.face_of(first, a, 1);
        if (candidate >= 0 && grid_.faces(a)[as_index(candidate)].second == second)
          neighbour[2 * cross + side] = candidate;
      }
      c.owner.push_back({face.first, face.second});
      c.share.push_back(
          {grid_.face_of(face.first, a, 0) >= 0 ? 0.5 : 1.0, grid_.face_of(face.second, a, 1) >= 0 ? 0.5 : 1.0});
    }
    c.neighbour.push_back(neighbour);
  }
  const std::size_t n = as_index(c.sections) * as_index(c.levels);
  for (auto* field : {&c.volume, &c.fraction, &c.liquid_before, &c.liquid_now, &c.stressed, &c.velocity, &c.previous,
                      &c.pressure_gradient, &c.viscous, &c.flow, &c.inertia, &c.old_inertia, &c.diagonal,
                      &c.inverse_diagonal, &c.right_hand_side, &c.next, &c.mobility})
    field->assign(n, 0.0);
  if (time_scheme_ == TimeScheme::second_order)
    for (auto* field : {&c.liquid_earlier, &c.earlier}) field->assign(n, 0.0);
  for (auto& flux : c.flux) flux.assign(n, 0.0);
  for (auto& coefficient : c.coefficient) coefficient.assign(n, 0.0);
  for (auto& told : c.told) told.resize(as_index(threads_));
  for (auto& end : c.end) end.assign(as_index(c.sections), 0.0);
  std::vector<double> volumes(grid_.size());
  for (int cell = 0; cell < grid_.cells(); ++cell)
    for (int k = 0; k < layers; ++k) volumes[index(cell, k, layers)] = grid_.volume(cell);
  scatter(a, volumes, c.volume);
  if (a == vertical) {
    std::fill(c.end[0].begin(), c.end[0].end(), superficial_velocity_);
    for (int s = 0; s < c.sections; ++s)
      for (int k = c.first; k <= c.last; ++k) c.velocity[index(s, k, c.levels)] = superficial_velocity_;
  }
  build_stencil(a);
}

/// Weights of ∇². Where the wall is nearer than the next node it takes its place at its own distance (Shortley and
/// Weller 1938); past the outlet and slip walls the velocity goes on unchanged.
///
/// The differences are taken at the lattice points, while a node's velocity is the mean over its face, which the round
/// wall may cut off centre. In between stands the part of the velocity that is left at the lattice point: the ratio of
/// R² − r² there and at the centroid, as next to any wall without slip.
void LiquidSolver::build_stencil(std::size_t a) {
  Component& c = component_[a];
  for (auto* weights : {&c.lateral, &c.mirror})
    for (auto& weight : *weights) weight.assign(as_index(c.sections), 0.0);
  c.own.assign(as_index(c.sections), 0.0);
  const double radius = grid_.radius();
  const auto lattice_point = [&](int s) {
    auto point = grid_.centre(c.owner[as_index(s)][0]);
    if (a != vertical) point[a] += 0.5 * grid_.spacing(a);
    return point;
  };
  const auto part_at_lattice_point = [&](int s) {
    if (radius == 0.0 || wall_ != LateralBoundary::no_slip || grid_.cells() == 1) return 1.0;
    const auto point = lattice_point(s);
    const auto mean = position(a, index(s, 0, c.levels));
    return (radius * radius - point[0] * point[0] - point[1] * point[1]) /
           (radius * radius - mean[0] * mean[0] - mean[1] * mean[1]);
  };
  for (int s = 0; s < c.sections; ++s) {
    const auto point = lattice_point(s);
    const double part = part_at_lattice_point(s);
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const double width = grid_.spacing(axis);
      std::array<double, 2> distance{width, width};
      std::array<bool, 2> at_wall{false, false};
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (c.neighbour[as_index(s)][2 * axis + side] >= 0) continue;
        c.mirror[2 * axis + side][as_index(s)] = 1.0;
        const double to_wall = grid_.wall_distance(point, axis, side);
        // A slip wall holds back only what flows towards it; on the round wall neither axis is that direction.
        at_wall[side] =
            std::isfinite(to_wall) && (wall_ == LateralBoundary::no_slip ||
                                       (wall_ == LateralBoundary::slip && axis == a && grid_.radius() == 0.0));
        if (!at_wall[side]) continue;
        distance[side] = to_wall;  // not 0: every lattice point lies inside
        c.mirror[2 * axis + side][as_index(s)] = std::max(-1.0, 1.0 - width / distance[side]);
      }
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const double weight = 2.0 / (distance[side] * (distance[0] + distance[1]));
        const int neighbour = c.neighbour[as_index(s)][2 * axis + side];
        if (at_wall[side] || neighbour >= 0) c.own[as_index(s)] += weight * part;
        if (neighbour >= 0) c.lateral[2 * axis + side][as_index(s)] = weight * part_at_lattice_point(neighbour);
      }
    }
  }
  const double height = grid_.cell_height();
  c.below.assign(as_index(c.levels), 1.0 / (height * height));
  c.above = c.below;
  if (a == vertical) {
    if (!closed_) {  // the outlet mirrors the velocity
      c.below.back() *= 2.0;
      c.above.back() = 0.0;
    }
    return;
  }
  // The end planes are half a cell away.
  const double near = 2.0 / (0.5 * height * 1.5 * height), far = 2.0 / (height * 1.5 * height);
  c.below.front() = near;
  c.above.front() = far;
  if (closed_) {
    c.below.back() = far;
    c.above.back() = near;
  } else {
    c.above.back() = 0.0;
  }
}

std::array<double, 3> LiquidSolver::position(std::size_t a, std::size_t node) const {
  const Component& c = component_[a];
  const auto level = static_cast<double>(node % as_index(c.levels));
  const std::size_t section = node / as_index(c.levels);
  const double height = grid_.cell_height();
  const int cell = c.owner[section][0];
  if (a == vertical) return {grid_.centroid(cell)[0], grid_.centroid(cell)[1], level * height};
  std::array<double, 3> result{0.0, 0.0, (level + 0.5) * height};
  result[a] = grid_.centre(cell)[a] + 0.5 * grid_.spacing(a);
  result[1 - a] = grid_.faces(a)[section].middle;
  return result;
}

void LiquidSolver::scatter(std::size_t a, const std::vector<double>& cells, std::vector<double>& nodes) const {
  nodes.resize(as_index(component_[a].sections) * as_index(component_[a].levels));
  scatter(a, {0, component_[a].sections}, cells, nodes);
}

void LiquidSolver::scatter(const std::array<std::vector<double>, 5>& cells, Exchange& exchange) const {
  for (std::size_t a = 0; a < 3; ++a)
    for (auto* field : {&exchange.coefficient[a], &exchange.source[a], &exchange.volume[a]})
      field->resize(component_[a].velocity.size());
  for_ranges([&](std::size_t a, Range own, int) {
    scatter(a, own, cells[0], exchange.coefficient[a]);
    scatter(a, own, cells[a + 1], exchange.source[a]);
    scatter(a, own, cells[4], exchange.volume[a]);
  });
}

void LiquidSolver::scatter(std::size_t a, Range own, const std::vector<double>& cells,
                           std::vector<double>& nodes) const {
  const Component& c = component_[a];
  const auto layers = as_index(grid_.layers());
  for (int s = own.first; s < own.last; ++s) {
    const auto& owner = c.owner[as_index(s)];
    const auto& share = c.share[as_index(s)];
    const double *first = &cells[index(owner[0], 0, grid_.layers())],
                 *second = &cells[index(owner[1], 0, grid_.layers())];
    double* node = &nodes[index(s, 0, c.levels)];
    if (a == vertical) {
      for (std::size_t k = 1; k < layers; ++k) node[k] = 0.5 * first[k - 1] + 0.5 * first[k];
      // The lowest cell's share of the inlet face goes to the first free node above it; likewise below a closed top.
      node[0] = 0.0;
      node[layers] = 0.5 * first[layers - 1];
      node[1] += 0.5 * first[0];
      if (closed_) node[layers - 1] += std::exchange(node[layers], 0.0);
    } else {
      for (std::size_t k = 0; k < layers; ++k) node[k] = share[0] * first[k] + share[1] * second[k];
    }
  }
}

template <class Value>
void LiquidSolver::gather_values(std::size_t a, int cell, const Value& value, double* result) const {
  const Component& c = component_[a];
  const auto layers = as_index(grid_.layers());
  if (a == vertical) {
    const std::size_t node = index(cell, 0, c.levels);
    for (std::size_t k = 1; k < layers; ++k) result[k] = 0.5 * (value(node + k) + value(node + k + 1));
    result[0] = 0.5 * (value(node + 1) + value(node + std::min<std::size_t>(1, as_index(c.last))));
    if (closed_) result[layers - 1] = value(node + layers - 1);
    return;
  }
  std::fill_n(result, layers, 0.0);
  for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const int face = grid_.face_of(cell, a, side);
    if (face < 0) continue;
    const double share = c.share[as_index(face)][1 - side];
    const std::size_t node = index(face, 0, c.levels);
    for (std::size_t k = 0; k < layers; ++k) result[k] += share * value(node + k);
  }
}

void LiquidSolver::gather(std::size_t a, const std::vector<double>& nodes, std::vector<double>& cells) const {
  cells.resize(grid_.size());
  for (int cell = 0; cell < grid_.cells(); ++cell)
    gather_values(
        a, cell, [&](std::size_t n) { return nodes[n]; }, &cells[index(cell, 0, grid_.layers())]);
}

void LiquidSolver::gather(std::array<std::vector<double>, 3>& velocity,
                          std::array<std::vector<double>, 3>& stress) const {
  for (auto* fields : {&velocity, &stress})
    for (auto& field : *fields) field.resize(grid_.size());
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (int cell = 0; cell < grid_.cells(); ++cell)
    for (std::size_t a = 0; a < 3; ++a) {
      const Component& c = component_[a];
      const double *u = c.velocity.data(), *viscous = c.viscous.data(), *gradient = c.pressure_gradient.data();
      const std::size_t start = index(cell, 0, grid_.layers());
      gather_values(
          a, cell, [=](std::size_t n) { return u[n]; }, &velocity[a][start]);
      gather_values(
          a, cell, [=](std::size_t n) { return viscous[n] - gradient[n]; }, &stress[a][start]);
    }
}

double LiquidSolver::face_area(std::size_t a, int section) const {
  return a == vertical ? grid_.area(section) : grid_.faces(a)[as_index(section)].length * grid_.cell_height();
}

template <class Work>
void LiquidSolver::for_ranges(Work work) const {
#pragma omp parallel num_threads(threads_)
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    for (std::size_t a = 0; a < 3; ++a) {
      const int sections = component_[a].sections;
      work(a, Range{sections * thread / threads, sections * (thread + 1) / threads}, thread);
    }
  }
}

template <class Work>
void LiquidSolver::for_sections(Work work) const {
  for_ranges([&](std::size_t a, Range own, int) {
    for (int s = own.first; s < own.last; ++s) work(a, s);
  });
}

/// Distance between the pressure points on both sides of a node [m].
double LiquidSolver::spacing(std::size_t a, int level) const {
  if (a != vertical) return grid_.spacing(a);
  return level == grid_.layers() ? 0.5 * grid_.cell_height() : grid_.cell_height();
}

/// Liquid volumes on the nodes, inertia and old momentum, ∂V_L/∂t, the inlet's velocity, and the velocity that the
/// solution starts from: extrapolated in second order, so that everything explicit in it is of second order too.
void LiquidSolver::start_step(double time_step, const std::vector<double>& before, const std::vector<double>& now) {
  const bool goes_on = last_volume_.size() == before.size() &&
                       std::memcmp(last_volume_.data(), before.data(), before.size() * sizeof(double)) == 0;
  const bool second_order = time_scheme_ == TimeScheme::second_order && goes_on;
  // ∂f/∂t at the end of the step = at_now f^(n+1) − at_before f^n + at_earlier f^(n−1).
  const double at_now = (second_order ? 1.5 : 1.0) / time_step, at_before = (second_order ? 2.0 : 1.0) / time_step,
               at_earlier = 0.5 / time_step;
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (std::size_t i = 0; i < volume_change_.size(); ++i) {
    volume_change_[i] = at_now * now[i] - at_before * before[i];
    if (second_order) volume_change_[i] += at_earlier * earlier_volume_[i];
  }
  const bool nodes_hold_before = goes_on && nodes_hold_last_volume_;
  for (Component& c : component_)
    if (nodes_hold_before) std::swap(c.liquid_before, c.liquid_now);
  for_ranges([&](std::size_t a, Range own, int) {
    Component& c = component_[a];
    if (!nodes_hold_before) scatter(a, own, before, c.liquid_before);
    scatter(a, own, now, c.liquid_now);
    if (second_order) scatter(a, own, earlier_volume_, c.liquid_earlier);
    const std::size_t first = index(own.first, 0, c.levels), end = index(own.last, 0, c.levels);
    {
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
  Component& c = component_[vertical];
  for (int s = 0; s < c.sections; ++s)
    c.velocity[index(s, 0, c.levels)] = c.end[0][as_index(s)] / c.fraction[index(s, 1, c.levels)];
}

/// Volume flow of liquid α u A through every cell face at the start of the step, for which continuity holds.
void LiquidSolver::start_flows() {
  for_sections([this](std::size_t a, int s) {
    Component& c = component_[a];
    const double area = face_area(a, s);
    const std::size_t start = index(s, 0, c.levels);
    const double *volume = &c.volume[start], *liquid = &c.liquid_before[start], *velocity = &c.velocity[start];
    double* flow = &c.flow[start];
    const int levels = c.levels;
#pragma omp simd
    for (int k = 0; k < levels; ++k) flow[k] = volume[k] > 0.0 ? liquid[k] / volume[k] * area * velocity[k] : 0.0;
    if (a == vertical) flow[0] = c.end[0][as_index(s)] * area;
  });
}

/// Makes the vertical momentum's old content that of the liquid volumes which the convecting flow has filled from:
/// V^(n−1) = V^n + Δt Σ flow out. With it Σ q (u_face − u_P) is conservative although q is that of the step before.
void LiquidSolver::add_net_outflow(Range own) {
  Component& c = component_[vertical];
  const int layers = grid_.layers();
  for (int s = 0; s < c.sections; ++s) {
    const std::size_t start = index(s, 0, c.levels);
    double* inertia = &c.old_inertia[start];
    if (own.has(s)) {
      const double *up = &c.flux[2][start], *flow = &c.flow[start];
      for (int k = 1; k < layers; ++k) inertia[k] += density_ * (up[k + 1] - up[k]);
      inertia[layers] += density_ * (flow[layers] - up[layers]);
    }
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const int t = c.neighbour[as_index(s)][2 * axis + 1];
      if (t < 0) continue;
      double* beyond = &c.old_inertia[index(t, 0, c.levels)];
      const double* flux = &c.flux[axis][start];
      if (own.has(s))
        for (int k = 1; k <= layers; ++k) inertia[k] += density_ * flux[k];
      if (own.has(t))
        for (int k = 1; k <= layers; ++k) beyond[k] -= density_ * flux[k];
    }
  }
}

/// Stress moves the liquid's own volume, and through the drag what the spheres pass on of theirs.
void LiquidSolver::put_stress_on(const Exchange& exchange) {
  for_ranges([&](std::size_t a, Range own, int) {
    Component& c = component_[a];
    const std::size_t first = index(own.first, 0, c.levels), end = index(own.last, 0, c.levels);
    std::copy(&c.liquid_now[first], c.liquid_now.data() + end, &c.stressed[first]);
    if (exchange.volume[a].empty()) return;
    const double* volume = exchange.volume[a].data();
    double* stressed = c.stressed.data();
#pragma omp simd
    for (std::size_t n = first; n < end; ++n) stressed[n] += volume[n];
  });
}

/// Volume flow of liquid α u A through every cell face, on the nodes.
void LiquidSolver::update_flows() {
  for_sections([this](std::size_t a, int s) {
    Component& c = component_[a];
    const double area = face_area(a, s);
    const std::size_t start = index(s, 0, c.levels);
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
void LiquidSolver::link_fluxes(std::size_t a, Range own) {
  Component& c = component_[a];
  const int layers = grid_.layers();
  if (a == vertical) {
    for (int s = own.first; s < own.last; ++s) {
      for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(s, axis, 1);
        if (face < 0) continue;
        const double* flow = &component_[axis].flow[index(face, 0, layers)];
        double* flux = &c.flux[axis][index(s, 0, c.levels)];
        for (int k = c.first; k < layers; ++k) flux[k] = 0.5 * (flow[k - 1] + flow[k]);
        // The ends of the first node's volume, and of the last one's.
        if (c.last == layers) flux[layers] = 0.5 * flow[layers - 1];
        flux[c.first] += 0.5 * flow[0];
        if (closed_) flux[c.last] += 0.5 * flow[layers - 1];
      }
      // From below: the inlet for the first free node, else the mean of the two faces of the cell in between.
      const double* flow = &c.flow[index(s, 0, c.levels)];
      double* flux = &c.flux[2][index(s, 0, c.levels)];
      flux[1] = flow[0];
      for (int k = 2; k < c.levels; ++k) flux[k] = 0.5 * (flow[k - 1] + flow[k]);
    }
    return;
  }
  const std::size_t cross = 1 - a;
  for (int s = own.first; s < own.last; ++s) {
    const auto& owner = c.owner[as_index(s)];
    const auto& share = c.share[as_index(s)];
    const std::size_t start = index(s, 0, layers);
    const int next = c.neighbour[as_index(s)][2 * a + 1];
    if (next >= 0) {
      const double *here = &c.flow[start], *there = &c.flow[index(next, 0, layers)];
      for (std::size_t k = 0; k < as_index(layers); ++k) c.flux[a][start + k] = 0.5 * (here[k] + there[k]);
    }
    if (c.neighbour[as_index(s)][2 * cross + 1] >= 0) {
      const double* first = &component_[cross].flow[index(grid_.face_of(owner[0], cross, 1), 0, layers)];
      const double* second = &component_[cross].flow[index(grid_.face_of(owner[1], cross, 1), 0, layers)];
      for (std::size_t k = 0; k < as_index(layers); ++k)
        c.flux[cross][start + k] = share[0] * first[k] + share[1] * second[k];
    }
    const double* first = &component_[vertical].flow[index(owner[0], 0, layers + 1)];
    const double* second = &component_[vertical].flow[index(owner[1], 0, layers + 1)];
    for (std::size_t k = 0; k < as_index(layers); ++k)
      c.flux[2][start + k] = share[0] * first[k] + share[1] * second[k];
  }
}

/// The part ⅓ μ ∇(∇·u) of ∇·τ from the velocity before the solution: with the implicit ∇² beside it, it is stable at
/// any time step.
void LiquidSolver::start_viscous() {
  const int layers = grid_.layers();
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (int cell = 0; cell < grid_.cells(); ++cell) {
    const double *velocity = &component_[vertical].velocity[index(cell, 0, layers + 1)],
                 per_height = 1.0 / grid_.cell_height();
    double* dilatation = &dilatation_[index(cell, 0, layers)];
#pragma omp simd
    for (int k = 0; k < layers; ++k) dilatation[k] = (velocity[k + 1] - velocity[k]) * per_height;
    for (std::size_t a : {std::size_t{0}, std::size_t{1}})
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(cell, a, side);
        if (face < 0) continue;
        const double *through = &component_[a].velocity[index(face, 0, layers)],
                     weight = (side == 0 ? -1.0 : 1.0) * grid_.faces(a)[as_index(face)].length / grid_.area(cell);
#pragma omp simd
        for (int k = 0; k < layers; ++k) dilatation[k] += weight * through[k];
      }
  }
  for_sections([this, layers](std::size_t a, int s) {
    Component& c = component_[a];
    const double factor = viscosity_ / 3.0 / (a == vertical ? grid_.cell_height() : grid_.spacing(a));
    const auto& owner = c.owner[as_index(s)];
    const double *lower = &dilatation_[index(owner[0], 0, layers)], *upper = &dilatation_[index(owner[1], 0, layers)];
    double* viscous = &c.viscous[index(s, 0, c.levels)];
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

void LiquidSolver::assemble(std::size_t a, Range own, const Exchange& exchange, Scratch& scratch) {
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
void LiquidSolver::assemble(std::size_t a, Range own, const Exchange& exchange, Scratch& scratch) {
  Component& c = component_[a];
  const int levels = c.levels;
  const double density = density_, viscosity = viscosity_;
  const double* velocity = c.velocity.data();
  const std::size_t own_nodes = index(own.first, 0, levels), end_of_own_nodes = index(own.last, 0, levels);
  {
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
    const std::size_t start = index(s, 0, levels);
    const double* u = velocity + start;
    const double* liquid = &c.stressed[start];
    double* rhs = own.has(s) ? &c.right_hand_side[start] : scratch.right_hand_side.data();
    double* diagonal = own.has(s) ? &c.diagonal[start] : scratch.diagonal.data();
    const double stress = viscosity_ * c.own[as_index(s)];
    if (own.has(s)) {
#pragma omp simd
      for (int k = first; k <= last; ++k) diagonal[k] += stress * liquid[k];
    }

    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t minus = 2 * axis, plus = minus + 1;
      const int t = c.neighbour[as_index(s)][plus];
      if (t < 0 || !(own.has(s) || own.has(t))) continue;
      // Beyond the two nodes of the link: the next node, or the wall's stand-in for it.
      const int before = c.neighbour[as_index(s)][minus], after = c.neighbour[as_index(t)][plus];
      const std::size_t start_t = index(t, 0, levels);
      const double* u_t = velocity + start_t;
      const double* u_before = before >= 0 ? velocity + index(before, 0, levels) : u;
      const double* u_after = after >= 0 ? velocity + index(after, 0, levels) : u_t;
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
    if (a != vertical) rhs[c.last] += from_above * c.end[1][as_index(s)];
  }
  {
    const double *to_below = c.coefficient[4].data(), *to_above = c.coefficient[5].data();
    double *diagonal = c.diagonal.data(), *inverse = c.inverse_diagonal.data();
#pragma omp simd
    for (std::size_t n = own_nodes; n < end_of_own_nodes; ++n) {
      diagonal[n] += to_below[n] + to_above[n];
      inverse[n] = diagonal[n] > 0.0 ? 1.0 / diagonal[n] : 0.0;
    }
  }
}

/// The momentum equations are strongly diagonal (a step is short against drag and convection): Jacobi sweeps suffice.
/// Each changes the velocity by about the same small part of what the last one did, so that what is still to come is
/// known.
///
/// Called by all threads together. `current` and `next` hold the velocity in turn; after the last sweep it is the
/// former that `c.velocity` becomes.
void LiquidSolver::solve_momentum(std::size_t a, Range own, int thread, Scratch& scratch) {
  Component& c = component_[a];
  const int levels = c.levels, first = c.first, last = c.last;
  double last_change = 0.0;
  for (int s = own.first; s < own.last; ++s) {  // what is given stays as it is
    const std::size_t start = index(s, 0, levels), end = start + as_index(levels);
    std::copy(&c.velocity[start], &c.velocity[start] + c.first, &c.next[start]);
    for (std::size_t n = start + as_index(c.last) + 1; n < end; ++n) c.next[n] = c.velocity[n];
  }
  double *current = c.velocity.data(), *updated = c.next.data();
  int sweep = 0;
  while (sweep < most_sweeps) {
    scratch.change.assign(as_index(levels), 0.0);
    scratch.peak.assign(as_index(levels), 0.0);
    for (int s = own.first; s < own.last; ++s) {
      const std::size_t start = index(s, 0, levels);
      const auto next_to = [&](std::size_t direction) {
        const int t = c.neighbour[as_index(s)][direction];
        return current + index(t >= 0 ? t : s, 0, levels);  // a missing neighbour has the weight 0
      };
      const double *u = current + start, *left = next_to(0), *right = next_to(1), *front = next_to(2),
                   *back = next_to(3);
      const double *to_left = &c.coefficient[0][start], *to_right = &c.coefficient[1][start],
                   *to_front = &c.coefficient[2][start], *to_back = &c.coefficient[3][start],
                   *to_below = &c.coefficient[4][start], *to_above = &c.coefficient[5][start];
      const double *rhs = &c.right_hand_side[start], *inverse = &c.inverse_diagonal[start];
      double *next = updated + start, *moved = scratch.change.data(), *peak = scratch.peak.data();
      const auto lateral = [=](int k) {
        return rhs[k] + to_left[k] * left[k] + to_right[k] * right[k] + to_front[k] * front[k] + to_back[k] * back[k];
      };
      const auto update = [=](int k, double sum) {
        const double value = sum * inverse[k], change = std::abs(value - u[k]), size = std::abs(value);
        moved[k] = moved[k] > change ? moved[k] : change;
        peak[k] = peak[k] > size ? peak[k] : size;
        next[k] = value;
      };
      if (c.first == c.last) {
        update(c.first, lateral(c.first));
        continue;
      }
      update(c.first, lateral(c.first) + to_above[c.first] * u[c.first + 1]);
#pragma omp simd
      for (int k = first + 1; k < last; ++k) update(k, lateral(k) + to_below[k] * u[k - 1] + to_above[k] * u[k + 1]);
      update(c.last, lateral(c.last) + to_below[c.last] * u[c.last - 1]);
    }
    std::swap(current, updated);
    // Told to the others; those of the next sweep go to the other place, so that nobody overwrites what is being read.
    auto& told = c.told[as_index(sweep % 2)];
    told[as_index(thread)] = {*std::max_element(scratch.change.begin(), scratch.change.end()),
                              *std::max_element(scratch.peak.begin(), scratch.peak.end())};
    ++sweep;
#pragma omp barrier
    double change = 0.0, largest = 0.0;
    for (const auto& [its_change, its_largest] : told) {
      change = std::max(change, its_change);
      largest = std::max(largest, its_largest);
    }
    const double ratio = sweep > 1 && last_change > 0.0 ? change / last_change : 1.0;
    const double unsettled = ratio < 0.5 ? change * ratio / (1.0 - ratio) : change;
    const bool settled = unsettled <= momentum_tolerance * (largest + 1e-6);
    if (settled || sweep == most_sweeps) {
      if (thread == 0) c.unsettled = unsettled, c.largest = largest;
      break;
    }
    last_change = change;
  }
  if (sweep % 2 == 1 && thread == 0) std::swap(c.velocity, c.next);
#pragma omp barrier
}

void LiquidSolver::check_momentum() const {
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& c = component_[a];
    double nothing = 0.0;  // unless a velocity is not finite
#pragma omp simd reduction(+ : nothing)
    for (std::size_t n = 0; n < c.velocity.size(); ++n) nothing += 0.0 * c.velocity[n];
    if (!std::isfinite(nothing))
      throw FluidError(fmt::format("liquid momentum ({}): a velocity is not finite", "xyz"[a]));
    if (c.unsettled > momentum_tolerance * (c.largest + 1e-6))
      throw FluidError(fmt::format(
          "liquid momentum ({}): {} sweeps leave a change of {:.3g} m/s; a smaller fluid.time_step may help", "xyz"[a],
          most_sweeps, c.unsettled));
  }
}

/// Adds μ ∇²u of the present velocity to the part that start_viscous has left: ∇·τ on the nodes.
void LiquidSolver::finish_viscous(std::size_t a, Range own) {
  Component& c = component_[a];
  const int levels = c.levels;
  for (int s = own.first; s < own.last; ++s) {
    const std::size_t start = index(s, 0, levels);
    const double* u = &c.velocity[start];
    double* viscous = &c.viscous[start];
    std::array<const double*, 4> next_to{u, u, u, u};
    std::array<double, 4> weight{};
    const double own_weight = viscosity_ * c.own[as_index(s)];
    for (std::size_t direction = 0; direction < 4; ++direction) {
      const int t = c.neighbour[as_index(s)][direction];
      if (t < 0) continue;
      next_to[direction] = &c.velocity[index(t, 0, levels)];
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

/// ∇p on the nodes from the pressure; with `correct_velocity` each velocity follows the change by its mobility.
template <bool correct_velocity>
void LiquidSolver::update_pressure_gradient() {
  const int layers = grid_.layers();
  for_sections([this, layers](std::size_t a, int s) {
    Component& c = component_[a];
    const std::size_t start = index(s, 0, c.levels);
    double* gradient = &c.pressure_gradient[start];
    double* velocity = &c.velocity[start];
    const double* mobility = &c.mobility[start];
    const auto set = [=](int k, double value) {
      if constexpr (correct_velocity) velocity[k] -= mobility[k] * (value - gradient[k]);
      gradient[k] = value;
    };
    const double *lower = &pressure_[index(c.owner[as_index(s)][0], 0, layers)],
                 *upper = &pressure_[index(c.owner[as_index(s)][1], 0, layers)];
    if (a == vertical) {
      const double per_height = 1.0 / grid_.cell_height();
#pragma omp simd
      for (int k = 1; k < layers; ++k) set(k, (upper[k] - lower[k - 1]) * per_height);
      if (!closed_) set(layers, -lower[layers - 1] * 2.0 * per_height);  // the outlet's dynamic pressure is 0
    } else {
      const double per_width = 1.0 / grid_.spacing(a);
#pragma omp simd
      for (int k = 0; k < layers; ++k) set(k, (upper[k] - lower[k]) * per_width);
    }
  });
}

/// Pressure correction: u = u* − m ∇δp with m = liquid volume over (inertia + drag) per node, so that continuity
/// ∂V_L/∂t + Σ α u A = 0 (Eq. 26) holds in every cell. Returns the largest imbalance before the correction over the
/// inlet flow.
double LiquidSolver::correct_pressure(const Exchange& exchange) {
  const Stopwatch stopwatch(cost_.pressure_seconds);
  const int layers = grid_.layers();
  update_flows();
  for_sections([&](std::size_t a, int s) {
    Component& c = component_[a];
    const double area = face_area(a, s);
    const std::size_t start = index(s, 0, c.levels);
    const double *stressed = &c.stressed[start], *inertia = &c.inertia[start], *drag = &exchange.coefficient[a][start],
                 *fraction = &c.fraction[start];
    double *mobility = &c.mobility[start], *coefficient = &pressure_equation_.coefficient[a][start];
    const double per_spacing = 1.0 / spacing(a, 1);
    const int first = c.first, last = c.last;
#pragma omp simd
    for (int k = first; k <= last; ++k) {
      mobility[k] = stressed[k] / (inertia[k] + drag[k]);
      coefficient[k] = fraction[k] * area * mobility[k] * per_spacing;
    }
    if (a == vertical && last == layers)  // the outlet is half a cell away
      coefficient[layers] = fraction[layers] * area * mobility[layers] / spacing(a, layers);
  });
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (int cell = 0; cell < grid_.cells(); ++cell) {
    const double *change = &volume_change_[index(cell, 0, layers)],
                 *up = &component_[vertical].flow[index(cell, 0, layers + 1)];
    double* imbalance = &imbalance_[index(cell, 0, layers)];
    for (int k = 0; k < layers; ++k) imbalance[k] = up[k] - up[k + 1] - change[k];
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}})
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(cell, axis, side);
        if (face < 0) continue;
        const double *flow = &component_[axis].flow[index(face, 0, layers)], sign = side == 0 ? 1.0 : -1.0;
        for (int k = 0; k < layers; ++k) imbalance[k] += sign * flow[k];
      }
  }
  const double inlet_flow = std::max(std::abs(superficial_velocity_), 1e-3) * grid_.section_area();
  double largest = 0.0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < imbalance_.size(); ++i) largest = std::max(largest, std::abs(imbalance_[i]));
  largest /= inlet_flow;
  if (!std::isfinite(largest)) throw FluidError("liquid continuity: an imbalance is not finite");
  continuity_error_ = 0.0;
  if (largest == 0.0) return 0.0;

  constexpr int most_iterations = 500;
  const auto [iterations, error] =
      pressure_equation_.solve(imbalance_, correction_, pressure_tolerance_, most_iterations);
  cost_.pressure_iterations += iterations;
  if (!(error <= pressure_tolerance_))
    throw FluidError(
        fmt::format("pressure equation: {} iterations leave a relative residual of {:.3g} (tolerance {:.3g})",
                    iterations, error, pressure_tolerance_));
  for (std::size_t i = 0; i < grid_.size(); ++i) pressure_[i] += correction_[i];
  update_pressure_gradient<true>();
  continuity_error_ = pressure_equation_.largest_residual() / inlet_flow;
  return largest;
}

/// A section of one cell: α w A follows from continuity, layer by layer from the inlet; the momentum equation of each
/// node then holds the pressure gradient as its only unknown.
void LiquidSolver::balance_column(const Exchange& exchange) {
  Component& c = component_[vertical];
  const int layers = grid_.layers();
  const double area = grid_.area(0);
  c.flow[0] = c.end[0][0] * area;
  for (int k = 1; k <= layers; ++k) {
    const std::size_t n = as_index(k);
    c.flow[n] = c.flow[n - 1] - volume_change_[n - 1];
    c.velocity[n] = c.flow[n] / (c.fraction[n] * area);
  }
  constexpr Range all{0, 1};
  link_fluxes(vertical, all);
  start_viscous();
  std::fill(c.pressure_gradient.begin(), c.pressure_gradient.end(), 0.0);
  assemble(vertical, all, exchange, scratch_.front());
  double above = 0.0;
  for (int k = layers; k > 0; --k) {
    const std::size_t n = as_index(k);
    double force = c.right_hand_side[n] - c.diagonal[n] * c.velocity[n] + c.coefficient[5][n] * above;
    if (k > 1) force += c.coefficient[4][n] * c.velocity[n - 1];
    above = c.velocity[n];
    c.pressure_gradient[n] = force / c.stressed[n];
    pressure_[n - 1] = (k < layers ? pressure_[n] : 0.0) - c.pressure_gradient[n] * spacing(vertical, k);
  }
  finish_viscous(vertical, all);
  record_vertical_forces(outflow());
}

/// Momentum that leaves through the outlet with the convecting flow [N].
double LiquidSolver::outflow() const {
  const Component& c = component_[vertical];
  double sum = 0.0;
  for (int s = 0; s < c.sections; ++s) {
    const std::size_t top = index(s, grid_.layers(), c.levels);
    sum += density_ * c.flow[top] * c.velocity[top];
  }
  return sum;
}

void LiquidSolver::record_vertical_forces(double leaving) {
  const Component& c = component_[vertical];
  vertical_forces_ = {};
  vertical_forces_.outflow = leaving;
  double pressure = 0.0, stress = 0.0;
#pragma omp simd reduction(+ : pressure, stress)
  for (std::size_t n = 0; n < c.velocity.size(); ++n) {
    pressure -= c.volume[n] * c.pressure_gradient[n];
    stress += c.volume[n] * c.viscous[n];
  }
  vertical_forces_.pressure = pressure;
  vertical_forces_.stress = stress;
  for (int s = 0; s < c.sections; ++s)
    vertical_forces_.inflow += density_ * c.end[0][as_index(s)] * grid_.area(s) * c.velocity[index(s, 0, c.levels)];
}

double LiquidSolver::vertical_momentum() const {
  const Component& c = component_[vertical];
  const std::vector<double>& liquid = settled_flow_ ? c.liquid_before : c.liquid_now;
  double sum = 0.0;
  for (int s = 0; s < c.sections; ++s)
    for (int k = c.first; k <= c.last; ++k) {
      const std::size_t n = index(s, k, c.levels);
      sum += density_ * liquid[n] * c.velocity[n];
    }
  return sum;
}

void LiquidSolver::advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
                           const Exchange& exchange) {
  bool liquid_everywhere = true;
#pragma omp simd reduction(&& : liquid_everywhere)
  for (std::size_t i = 0; i < now.size(); ++i) liquid_everywhere = liquid_everywhere && now[i] > 0.0;
  if (!liquid_everywhere) {
    const auto cell = static_cast<std::size_t>(std::min_element(now.begin(), now.end()) - now.begin());
    throw FluidError(
        fmt::format("void fraction: layer {} of section cell {} holds no liquid; larger cells (fluid.cells_across, "
                    "fluid.cell_height) are needed",
                    cell % as_index(grid_.layers()), cell / as_index(grid_.layers())));
  }
  {
    const Stopwatch stopwatch(cost_.momentum_seconds);
    start_step(time_step, before, now);
    put_stress_on(exchange);
    if (grid_.cells() == 1 && !closed_) return balance_column(exchange);
  }
  // The projection takes one pass; SIMPLE repeats it until pressure, velocity and convecting flow agree.
  constexpr int most_iterations = 100;
  const bool simple = pressure_velocity_ == PressureVelocity::simple;
  for (int iteration = 1;; ++iteration) {
    double leaving = 0.0;
    {
      const Stopwatch stopwatch(cost_.momentum_seconds);
      settled_flow_ ? start_flows() : update_flows();
      start_viscous();
      for_ranges([&](std::size_t a, Range own, int thread) {
        Scratch& scratch = scratch_[as_index(thread)];
        link_fluxes(a, own);
#pragma omp barrier
        if (a == vertical && settled_flow_) add_net_outflow(own);
        assemble(a, own, exchange, scratch);
        solve_momentum(a, own, thread, scratch);
        finish_viscous(a, own);
      });
      check_momentum();
      leaving = outflow();
    }
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

double LiquidSolver::inlet_pressure() const {
  const int layers = grid_.layers();
  double sum = 0.0;
  for (int c = 0; c < grid_.cells(); ++c) {
    const double lowest = pressure_[index(c, 0, layers)];
    const double next = layers > 1 ? pressure_[index(c, 1, layers)] : 0.0;
    sum += grid_.area(c) * (1.5 * lowest - 0.5 * next);
  }
  return sum / grid_.section_area();
}

NamedFields LiquidSolver::state() const {
  NamedFields state;
  for (std::size_t a = 0; a < 3; ++a) {
    state[fmt::format("velocity_{}", "xyz"[a])] = component_[a].velocity;
    state[fmt::format("viscous_{}", "xyz"[a])] = component_[a].viscous;
    state[fmt::format("earlier_velocity_{}", "xyz"[a])] = component_[a].earlier;
  }
  state["earlier_volume"] = earlier_volume_;
  state["last_volume"] = last_volume_;
  state["pressure"] = pressure_;
  return state;
}

void LiquidSolver::restore(const NamedFields& state) {
  for (std::size_t a = 0; a < 3; ++a) {
    component_[a].velocity = field_of(state, fmt::format("velocity_{}", "xyz"[a]));
    component_[a].viscous = field_of(state, fmt::format("viscous_{}", "xyz"[a]));
    component_[a].earlier = field_of(state, fmt::format("earlier_velocity_{}", "xyz"[a]));
  }
  earlier_volume_ = field_of(state, "earlier_volume");
  last_volume_ = field_of(state, "last_volume");
  nodes_hold_last_volume_ = false;
  pressure_ = field_of(state, "pressure");
  update_pressure_gradient<false>();
}

}  // namespace slfb::fluid
