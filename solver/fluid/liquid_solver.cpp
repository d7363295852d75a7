#include "solver/fluid/liquid_solver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace slfb::fluid {
namespace {

constexpr std::size_t vertical = 2;

std::size_t index(int section, int level, int levels) {
  return static_cast<std::size_t>(section) * static_cast<std::size_t>(levels) + static_cast<std::size_t>(level);
}

std::size_t as_index(int value) { return static_cast<std::size_t>(value); }

}  // namespace

LiquidSolver::LiquidSolver(const Scene& scene)
    : grid_(scene),
      density_(scene.liquid.density),
      viscosity_(scene.liquid.viscosity),
      superficial_velocity_(scene.liquid.superficial_velocity),
      pressure_tolerance_(scene.fluid.pressure_tolerance),
      simple_tolerance_(scene.fluid.simple_tolerance),
      wall_(scene.fluid.tier == FluidTier::three_dimensional ? scene.fluid.wall : LateralBoundary::slip),
      convection_(scene.fluid.convection),
      pressure_velocity_(scene.fluid.pressure_velocity),
      pressure_(grid_.size(), 0.0) {
  for (std::size_t a = 0; a < 3; ++a) build_component(a);
  assemble_pattern();
}

void LiquidSolver::build_component(std::size_t a) {
  Component& c = component_[a];
  const int layers = grid_.layers();
  const double height = grid_.cell_height();
  const auto wall_ratio = [&](int cell) {
    return wall_ == LateralBoundary::no_slip && grid_.wall_length(cell) > 0.0
               ? grid_.wall_length(cell) / grid_.wall_distance(cell)
               : 0.0;
  };
  const auto across = [&](int cell, std::size_t axis, std::size_t side) {
    const int face = grid_.face_of(cell, axis, side);
    if (face < 0) return -1;
    const auto& f = grid_.faces(axis)[as_index(face)];
    return side == 0 ? f.first : f.second;
  };
  if (a == vertical) {
    c.sections = grid_.cells();
    c.levels = layers + 1;
    c.level_height.assign(as_index(c.levels), height);
    c.level_height.front() = 0.0;  // the inlet face: velocity given
    c.level_height[1] = layers == 1 ? height : 1.5 * height;
    if (layers > 1) c.level_height.back() = 0.5 * height;
  } else {
    c.sections = static_cast<int>(grid_.faces(a).size());
    c.levels = layers;
    c.level_height.assign(as_index(c.levels), height);
  }
  for (int s = 0; s < c.sections; ++s) {
    std::array<int, 4> neighbour{-1, -1, -1, -1};
    if (a == vertical) {
      for (std::size_t axis : {std::size_t{0}, std::size_t{1}})
        for (std::size_t side : {std::size_t{0}, std::size_t{1}}) neighbour[2 * axis + side] = across(s, axis, side);
      c.owner.push_back({s, s});
      c.share.push_back({0.5, 0.5});
      c.wall.push_back(wall_ratio(s));
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
      const double first_share = grid_.face_of(face.first, a, 0) >= 0 ? 0.5 : 1.0;
      const double second_share = grid_.face_of(face.second, a, 1) >= 0 ? 0.5 : 1.0;
      c.share.push_back({first_share, second_share});
      c.wall.push_back(first_share * wall_ratio(face.first) + second_share * wall_ratio(face.second));
    }
    c.neighbour.push_back(neighbour);
  }
  // Lateral conductance per height of the links towards +x and +y: wetted length over distance.
  for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    c.lateral_conductance[axis].assign(as_index(c.sections), 0.0);
    for (int s = 0; s < c.sections; ++s) {
      if (c.neighbour[as_index(s)][2 * axis + 1] < 0) continue;
      double length = grid_.spacing(1 - axis);
      if (a == vertical) length = grid_.faces(axis)[as_index(grid_.face_of(s, axis, 1))].length;
      c.lateral_conductance[axis][as_index(s)] = length / grid_.spacing(axis);
    }
  }
  const std::size_t n = as_index(c.sections) * as_index(c.levels);
  for (auto* field : {&c.volume, &c.liquid_before, &c.liquid_now, &c.velocity, &c.previous, &c.pressure_gradient,
                      &c.viscous, &c.diagonal, &c.right_hand_side, &c.next, &c.mobility})
    field->assign(n, 0.0);
  for (auto& flux : c.flux) flux.assign(n, 0.0);
  std::vector<double> volumes(grid_.size());
  for (int cell = 0; cell < grid_.cells(); ++cell)
    for (int k = 0; k < layers; ++k) volumes[index(cell, k, layers)] = grid_.volume(cell);
  scatter(a, volumes, c.volume);
  if (a == vertical) std::fill(c.velocity.begin(), c.velocity.end(), superficial_velocity_);
}

void LiquidSolver::scatter(std::size_t a, const std::vector<double>& cells, std::vector<double>& nodes) const {
  const Component& c = component_[a];
  const int layers = grid_.layers();
  nodes.assign(as_index(c.sections) * as_index(c.levels), 0.0);
  for (int s = 0; s < c.sections; ++s) {
    if (a == vertical) {
      for (int k = 0; k < layers; ++k) {
        const double value = cells[index(s, k, layers)];
        // The lowest cell's share of the inlet face goes to the first free node above it.
        nodes[index(s, k == 0 ? 1 : k, c.levels)] += 0.5 * value;
        nodes[index(s, k + 1, c.levels)] += 0.5 * value;
      }
    } else {
      const auto& owner = c.owner[as_index(s)];
      const auto& share = c.share[as_index(s)];
      for (int k = 0; k < layers; ++k)
        nodes[index(s, k, layers)] =
            share[0] * cells[index(owner[0], k, layers)] + share[1] * cells[index(owner[1], k, layers)];
    }
  }
}

void LiquidSolver::gather(std::size_t a, const std::vector<double>& nodes, std::vector<double>& cells) const {
  const Component& c = component_[a];
  const int layers = grid_.layers();
  cells.assign(grid_.size(), 0.0);
  for (int s = 0; s < c.sections; ++s) {
    if (a == vertical) {
      for (int k = 0; k < layers; ++k)
        cells[index(s, k, layers)] =
            0.5 * (nodes[index(s, k == 0 ? 1 : k, c.levels)] + nodes[index(s, k + 1, c.levels)]);
    } else {
      const auto& owner = c.owner[as_index(s)];
      const auto& share = c.share[as_index(s)];
      for (int k = 0; k < layers; ++k) {
        cells[index(owner[0], k, layers)] += share[0] * nodes[index(s, k, layers)];
        cells[index(owner[1], k, layers)] += share[1] * nodes[index(s, k, layers)];
      }
    }
  }
}

double LiquidSolver::face_area(std::size_t a, int section) const {
  return a == vertical ? grid_.area(section) : grid_.faces(a)[as_index(section)].length * grid_.cell_height();
}

/// Distance between the pressure points on both sides of a node [m].
double LiquidSolver::spacing(std::size_t a, int level) const {
  if (a != vertical) return grid_.spacing(a);
  return level == grid_.layers() ? 0.5 * grid_.cell_height() : grid_.cell_height();
}

/// Volume flow of liquid α u A through every cell face, on the nodes [m³/s].
void LiquidSolver::face_flows(std::array<std::vector<double>, 3>& flow) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& c = component_[a];
    flow[a].resize(c.velocity.size());
    for (int s = 0; s < c.sections; ++s) {
      const double area = face_area(a, s);
      for (int k = 0; k < c.levels; ++k) {
        const std::size_t n = index(s, k, c.levels);
        flow[a][n] = a == vertical && k == 0 ? superficial_velocity_ * area
                                             : c.liquid_now[n] / c.volume[n] * area * c.velocity[n];
      }
    }
  }
}

/// Flow through the links between the control volumes of a component: each cell's face flow counts with the share that
/// the cell has in the node, so that the node's continuity is the sum of its cells' continuities.
void LiquidSolver::link_fluxes(std::size_t a, const std::array<std::vector<double>, 3>& flow) {
  Component& c = component_[a];
  const int layers = grid_.layers();
  if (a == vertical) {
    for (int s = 0; s < c.sections; ++s) {
      for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const int face = grid_.face_of(s, axis, 1);
        for (int k = 1; k < c.levels; ++k) {
          double value = 0.0;
          if (face >= 0) {
            const double below = flow[axis][index(face, k - 1, layers)];
            value = (k == 1 ? 1.0 : 0.5) * below;
            if (k < layers) value += 0.5 * flow[axis][index(face, k, layers)];
          }
          c.flux[axis][index(s, k, c.levels)] = value;
        }
      }
      // From below: the inlet for the first free node, else the mean of the two faces of the cell in between.
      for (int k = 1; k < c.levels; ++k)
        c.flux[2][index(s, k, c.levels)] =
            k == 1 ? flow[2][index(s, 0, c.levels)]
                   : 0.5 * (flow[2][index(s, k - 1, c.levels)] + flow[2][index(s, k, c.levels)]);
    }
    return;
  }
  const std::size_t cross = 1 - a;
  for (int s = 0; s < c.sections; ++s) {
    const auto& owner = c.owner[as_index(s)];
    const auto& share = c.share[as_index(s)];
    const int next = c.neighbour[as_index(s)][2 * a + 1];
    const int face_first = grid_.face_of(owner[0], cross, 1), face_second = grid_.face_of(owner[1], cross, 1);
    const bool linked = c.neighbour[as_index(s)][2 * cross + 1] >= 0;
    for (int k = 0; k < layers; ++k) {
      const std::size_t n = index(s, k, layers);
      c.flux[a][n] = next < 0 ? 0.0 : 0.5 * (flow[a][n] + flow[a][index(next, k, layers)]);
      c.flux[cross][n] = !linked ? 0.0
                                 : share[0] * flow[cross][index(face_first, k, layers)] +
                                       share[1] * flow[cross][index(face_second, k, layers)];
      c.flux[2][n] =
          share[0] * flow[2][index(owner[0], k, layers + 1)] + share[1] * flow[2][index(owner[1], k, layers + 1)];
    }
  }
}

/// Momentum predictor: implicit in time, upwind convection, diffusion and drag; QUICK as a deferred correction.
///
/// Convection is written as Σ q (u_face − u_P), the conservative form minus u_P times continuity: it cannot create
/// momentum where q is still that of the last iteration.
void LiquidSolver::predict(std::size_t a, double time_step, const Exchange& exchange) {
  Component& c = component_[a];
  const int levels = c.levels, first_level = a == vertical ? 1 : 0;
  const double height = grid_.cell_height();
  const std::vector<double>& u = c.velocity;
  const auto inlet_value = [&](int s) {
    if (a != vertical) return 0.0;  // the liquid enters without lateral velocity
    const double voidage = c.liquid_now[index(s, 1, levels)] / c.volume[index(s, 1, levels)];
    return superficial_velocity_ / voidage;
  };
  const auto value_at = [&](int section, int level) { return u[index(section, level, levels)]; };

  // Deferred QUICK minus upwind, flow direction known per link; u_far is the node beyond the upwind one.
  const auto correction = [](double flow, double lower, double upper, double below_lower, double above_upper,
                             bool has_below, bool has_above) {
    if (flow >= 0.0) return has_below ? flow * (0.375 * upper - 0.25 * lower - 0.125 * below_lower) : 0.0;
    return has_above ? flow * (0.375 * lower - 0.25 * upper - 0.125 * above_upper) : 0.0;
  };

  for (int s = 0; s < c.sections; ++s)
    for (int k = first_level; k < levels; ++k) {
      const std::size_t n = index(s, k, levels);
      const double inertia = density_ * c.liquid_before[n] / time_step;
      c.diagonal[n] = inertia + exchange.coefficient[a][n];
      c.right_hand_side[n] = inertia * c.previous[n] + exchange.source[a][n] - c.liquid_now[n] * c.pressure_gradient[n];
    }
  const bool quick = convection_ == ConvectionScheme::quick;
  const auto add_convection_link = [&](std::size_t lower, std::size_t upper, double volume_flow, double deferred) {
    // Upwind: only the node that receives the flow is drawn towards the other one.
    const double flow = density_ * volume_flow;
    c.diagonal[upper] += std::max(flow, 0.0);
    c.diagonal[lower] += std::max(-flow, 0.0);
    c.right_hand_side[lower] -= density_ * deferred;
    c.right_hand_side[upper] += density_ * deferred;
  };
  for (int s = 0; s < c.sections; ++s) {
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const int t = c.neighbour[as_index(s)][2 * axis + 1];
      if (t < 0) continue;
      const int before = c.neighbour[as_index(s)][2 * axis], after = c.neighbour[as_index(t)][2 * axis + 1];
      for (int k = first_level; k < levels; ++k) {
        const std::size_t lower = index(s, k, levels), upper = index(t, k, levels);
        const double q = c.flux[axis][lower];
        double deferred = 0.0;
        if (quick)
          deferred = correction(q, u[lower], u[upper], before >= 0 ? value_at(before, k) : 0.0,
                                after >= 0 ? value_at(after, k) : 0.0, before >= 0, after >= 0);
        add_convection_link(lower, upper, q, deferred);
        const double conductance = viscosity_ * c.lateral_conductance[axis][as_index(s)] * c.level_height[as_index(k)];
        c.diagonal[lower] += conductance * c.liquid_now[lower] / c.volume[lower];
        c.diagonal[upper] += conductance * c.liquid_now[upper] / c.volume[upper];
      }
    }
    const double area = a == vertical ? grid_.area(s) : c.volume[index(s, 0, levels)] / height;
    for (int k = first_level; k < levels; ++k) {
      const std::size_t n = index(s, k, levels);
      const double share_liquid = c.liquid_now[n] / c.volume[n];
      c.diagonal[n] += share_liquid * viscosity_ * c.wall[as_index(s)] * c.level_height[as_index(k)];
      if (k == first_level) {
        const double q = density_ * c.flux[2][n];
        const double conductance = share_liquid * viscosity_ * area / (a == vertical ? height : 0.5 * height);
        c.diagonal[n] += std::max(q, 0.0) + conductance;
        c.right_hand_side[n] += (std::max(q, 0.0) + conductance) * inlet_value(s);
        continue;
      }
      const std::size_t lower = n - 1;
      const double q = c.flux[2][n];
      double deferred = 0.0;
      if (quick)
        deferred = correction(q, u[lower], u[n], k - 2 >= first_level ? u[n - 2] : 0.0, k + 1 < levels ? u[n + 1] : 0.0,
                              k - 2 >= first_level, k + 1 < levels);
      add_convection_link(lower, n, q, deferred);
      const double conductance = viscosity_ * area / height;
      c.diagonal[lower] += conductance * c.liquid_now[lower] / c.volume[lower];
      c.diagonal[n] += conductance * share_liquid;
    }
  }

  // The implicit part is strongly diagonal (a step is short against drag and convection): Jacobi sweeps suffice.
  constexpr int most_sweeps = 500;
  double change = 0.0;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    c.next = c.right_hand_side;
    for (int s = 0; s < c.sections; ++s) {
      for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const int t = c.neighbour[as_index(s)][2 * axis + 1];
        if (t < 0) continue;
        const double* flux = &c.flux[axis][index(s, 0, levels)];
        double* next_s = &c.next[index(s, 0, levels)];
        double* next_t = &c.next[index(t, 0, levels)];
        const double* u_s = &u[index(s, 0, levels)];
        const double* u_t = &u[index(t, 0, levels)];
        const std::size_t at_s = index(s, 0, levels), at_t = index(t, 0, levels);
        const double lateral = viscosity_ * c.lateral_conductance[axis][as_index(s)];
        for (int k = first_level; k < levels; ++k) {
          const std::size_t l = as_index(k);
          const double conductance = lateral * c.level_height[l];
          next_s[l] +=
              (density_ * std::max(-flux[l], 0.0) + conductance * c.liquid_now[at_s + l] / c.volume[at_s + l]) * u_t[l];
          next_t[l] +=
              (density_ * std::max(flux[l], 0.0) + conductance * c.liquid_now[at_t + l] / c.volume[at_t + l]) * u_s[l];
        }
      }
      const double area = a == vertical ? grid_.area(s) : c.volume[index(s, 0, levels)] / height;
      for (int k = first_level + 1; k < levels; ++k) {
        const std::size_t n = index(s, k, levels), lower = n - 1;
        const double q = density_ * c.flux[2][n], conductance = viscosity_ * area / height;
        c.next[lower] += (std::max(-q, 0.0) + conductance * c.liquid_now[lower] / c.volume[lower]) * u[n];
        c.next[n] += (std::max(q, 0.0) + conductance * c.liquid_now[n] / c.volume[n]) * u[lower];
      }
    }
    change = 0.0;
    double largest = 0.0;
    for (int s = 0; s < c.sections; ++s)
      for (int k = first_level; k < levels; ++k) {
        const std::size_t n = index(s, k, levels);
        const double value = c.next[n] / c.diagonal[n];
        change = std::max(change, std::abs(value - c.velocity[n]));
        largest = std::max(largest, std::abs(value));
        c.velocity[n] = value;
      }
    if (!std::isfinite(largest))
      throw FluidError(fmt::format("liquid momentum ({}): a velocity is not finite", "xyz"[a]));
    if (change <= 1e-10 * (largest + 1e-6)) {
      if (a == vertical)
        for (int s = 0; s < c.sections; ++s) c.velocity[index(s, 0, levels)] = inlet_value(s);
      return;
    }
  }
  throw FluidError(
      fmt::format("liquid momentum ({}): {} sweeps leave a change of {:.3g} m/s; a smaller fluid.time_step may help",
                  "xyz"[a], most_sweeps, change));
}

/// ∇·(μ ∇u) on the nodes with the present velocity [N/m³].
void LiquidSolver::update_viscous(std::size_t a) {
  Component& c = component_[a];
  const int levels = c.levels, first_level = a == vertical ? 1 : 0;
  const double height = grid_.cell_height();
  std::fill(c.viscous.begin(), c.viscous.end(), 0.0);
  for (int s = 0; s < c.sections; ++s) {
    for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const int t = c.neighbour[as_index(s)][2 * axis + 1];
      if (t < 0) continue;
      for (int k = first_level; k < levels; ++k) {
        const std::size_t lower = index(s, k, levels), upper = index(t, k, levels);
        const double force = viscosity_ * c.lateral_conductance[axis][as_index(s)] * c.level_height[as_index(k)] *
                             (c.velocity[upper] - c.velocity[lower]);
        c.viscous[lower] += force;
        c.viscous[upper] -= force;
      }
    }
    const double area = a == vertical ? grid_.area(s) : c.volume[index(s, 0, levels)] / height;
    for (int k = first_level; k < levels; ++k) {
      const std::size_t n = index(s, k, levels);
      c.viscous[n] -= viscosity_ * c.wall[as_index(s)] * c.level_height[as_index(k)] * c.velocity[n];
      if (k == first_level) {
        const double inlet = a == vertical ? c.velocity[n - 1] : 0.0;
        c.viscous[n] += viscosity_ * area / (a == vertical ? height : 0.5 * height) * (inlet - c.velocity[n]);
      } else {
        const double force = viscosity_ * area / height * (c.velocity[n] - c.velocity[n - 1]);
        c.viscous[n - 1] += force;
        c.viscous[n] -= force;
      }
    }
  }
  for (std::size_t n = 0; n < c.viscous.size(); ++n)
    if (c.volume[n] > 0.0) c.viscous[n] /= c.volume[n];
}

void LiquidSolver::update_pressure_gradient() {
  const int layers = grid_.layers();
  for (std::size_t a = 0; a < 3; ++a) {
    Component& c = component_[a];
    for (int s = 0; s < c.sections; ++s)
      for (int k = a == vertical ? 1 : 0; k < c.levels; ++k) {
        const auto& owner = c.owner[as_index(s)];
        const double lower = a == vertical ? pressure_[index(s, k - 1, layers)] : pressure_[index(owner[0], k, layers)];
        double upper = 0.0;  // the outlet's dynamic pressure
        if (a != vertical)
          upper = pressure_[index(owner[1], k, layers)];
        else if (k < layers)
          upper = pressure_[index(s, k, layers)];
        c.pressure_gradient[index(s, k, c.levels)] = (upper - lower) / spacing(a, k);
      }
  }
}

void LiquidSolver::assemble_pattern() {
  const int layers = grid_.layers();
  std::vector<Eigen::Triplet<double>> entries;
  const auto cell = [&](int c, int k) { return static_cast<int>(index(c, k, layers)); };
  for (std::size_t i = 0; i < grid_.size(); ++i) entries.emplace_back(static_cast<int>(i), static_cast<int>(i), 1.0);
  const auto add = [&](int i, int j) {
    entries.emplace_back(i, j, 0.0);
    entries.emplace_back(j, i, 0.0);
  };
  for (std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (const auto& face : grid_.faces(a))
      for (int k = 0; k < layers; ++k) add(cell(face.first, k), cell(face.second, k));
  for (int c = 0; c < grid_.cells(); ++c)
    for (int k = 0; k + 1 < layers; ++k) add(cell(c, k), cell(c, k + 1));
  const int n = static_cast<int>(grid_.size());
  matrix_.resize(n, n);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();
  diagonal_entry_.resize(grid_.size());
  for (int i = 0; i < n; ++i) diagonal_entry_[as_index(i)] = &matrix_.coeffRef(i, i);
  for (std::size_t a = 0; a < 3; ++a)
    for (int s = 0; s < component_[a].sections; ++s)
      for (int k = 0; k < component_[a].levels; ++k) {
        std::array<double*, 2> pointers{nullptr, nullptr};
        if (a != vertical) {
          const auto& face = grid_.faces(a)[as_index(s)];
          const int i = cell(face.first, k), j = cell(face.second, k);
          pointers = {&matrix_.coeffRef(i, j), &matrix_.coeffRef(j, i)};
        } else if (k > 0 && k < layers) {
          const int i = cell(s, k - 1), j = cell(s, k);
          pointers = {&matrix_.coeffRef(i, j), &matrix_.coeffRef(j, i)};
        }
        lower_entry_.push_back(pointers);
      }
  solver_.setTolerance(pressure_tolerance_);
  solver_.setMaxIterations(2000);
  solver_.preconditioner().set_layers(layers);
}

/// Pressure correction: u = u* − m ∇δp with m = liquid volume over (inertia + drag) per node, so that continuity
/// ∂V_L/∂t + Σ α u A = 0 holds in every cell. Returns the largest imbalance before the correction over the inlet flow.
double LiquidSolver::correct_pressure(double time_step, const std::vector<double>& before,
                                      const std::vector<double>& now, const Exchange& exchange) {
  const int layers = grid_.layers();
  std::array<std::vector<double>, 3> flow;
  face_flows(flow);
  Eigen::VectorXd imbalance(static_cast<Eigen::Index>(grid_.size()));
  for (std::size_t i = 0; i < grid_.size(); ++i)
    imbalance[static_cast<Eigen::Index>(i)] = -(now[i] - before[i]) / time_step;

  std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
  std::size_t entry = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    Component& c = component_[a];
    for (int s = 0; s < c.sections; ++s)
      for (int k = 0; k < c.levels; ++k, ++entry) {
        const std::size_t n = index(s, k, c.levels);
        const std::ptrdiff_t lower = a == vertical
                                         ? (k > 0 ? static_cast<std::ptrdiff_t>(index(s, k - 1, layers)) : -1)
                                         : static_cast<std::ptrdiff_t>(index(c.owner[as_index(s)][0], k, layers));
        const std::ptrdiff_t upper = a == vertical
                                         ? (k < layers ? static_cast<std::ptrdiff_t>(index(s, k, layers)) : -1)
                                         : static_cast<std::ptrdiff_t>(index(c.owner[as_index(s)][1], k, layers));
        if (lower >= 0) imbalance[lower] -= flow[a][n];
        if (upper >= 0) imbalance[upper] += flow[a][n];
        if (a == vertical && k == 0) continue;  // the inlet's velocity is given
        c.mobility[n] = c.liquid_now[n] / (density_ * c.liquid_before[n] / time_step + exchange.coefficient[a][n]);
        const double coefficient = c.liquid_now[n] / c.volume[n] * face_area(a, s) * c.mobility[n] / spacing(a, k);
        if (lower >= 0) *diagonal_entry_[static_cast<std::size_t>(lower)] += coefficient;
        if (upper >= 0) *diagonal_entry_[static_cast<std::size_t>(upper)] += coefficient;
        if (lower_entry_[entry][0] != nullptr) {
          *lower_entry_[entry][0] -= coefficient;
          *lower_entry_[entry][1] -= coefficient;
        }
      }
  }
  const double inlet_flow = std::max(std::abs(superficial_velocity_), 1e-3) * grid_.section_area();
  const double largest = imbalance.cwiseAbs().maxCoeff() / inlet_flow;
  if (!std::isfinite(largest)) throw FluidError("liquid continuity: an imbalance is not finite");
  if (largest == 0.0) return 0.0;

  solver_.compute(matrix_);
  const Eigen::VectorXd correction = solver_.solve(imbalance);
  if (solver_.info() != Eigen::Success)
    throw FluidError(
        fmt::format("pressure equation: {} iterations leave a relative residual of {:.3g} (tolerance {:.3g})",
                    solver_.iterations(), solver_.error(), pressure_tolerance_));
  for (std::size_t i = 0; i < grid_.size(); ++i) pressure_[i] += correction[static_cast<Eigen::Index>(i)];
  std::array<std::vector<double>, 3> old_gradient;
  for (std::size_t a = 0; a < 3; ++a) old_gradient[a] = component_[a].pressure_gradient;
  update_pressure_gradient();
  for (std::size_t a = 0; a < 3; ++a) {
    Component& c = component_[a];
    for (std::size_t n = 0; n < c.velocity.size(); ++n)
      c.velocity[n] -= c.mobility[n] * (c.pressure_gradient[n] - old_gradient[a][n]);
  }
  continuity_error_ = (imbalance - matrix_ * correction).cwiseAbs().maxCoeff() / inlet_flow;
  return largest;
}

void LiquidSolver::advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
                           const Exchange& exchange) {
  const auto [least, most] = std::minmax_element(now.begin(), now.end());
  static_cast<void>(most);
  if (!(*least > 0.0)) {
    const auto cell = static_cast<std::size_t>(least - now.begin());
    throw FluidError(
        fmt::format("void fraction: layer {} of section cell {} holds no liquid; larger cells (fluid.cells_across, "
                    "fluid.cell_height) are needed",
                    cell % as_index(grid_.layers()), cell / as_index(grid_.layers())));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    Component& c = component_[a];
    scatter(a, before, c.liquid_before);
    scatter(a, now, c.liquid_now);
    c.previous = c.velocity;
  }
  // The projection takes one pass; SIMPLE repeats it until pressure, velocity and convecting flow agree.
  constexpr int most_iterations = 100;
  const bool simple = pressure_velocity_ == PressureVelocity::simple;
  std::array<std::vector<double>, 3> flow;
  for (int iteration = 1;; ++iteration) {
    face_flows(flow);
    for (std::size_t a = 0; a < 3; ++a) {
      link_fluxes(a, flow);
      predict(a, time_step, exchange);
      update_viscous(a);
    }
    const double imbalance = correct_pressure(time_step, before, now, exchange);
    if (!simple) return;
    if (iteration > 1 && imbalance < simple_tolerance_) return;
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

std::array<std::vector<double>, 7> LiquidSolver::state() const {
  return {component_[0].velocity,
          component_[1].velocity,
          component_[2].velocity,
          component_[0].viscous,
          component_[1].viscous,
          component_[2].viscous,
          pressure_};
}

void LiquidSolver::restore(const std::array<std::vector<double>, 7>& state) {
  for (std::size_t a = 0; a < 3; ++a) {
    component_[a].velocity = state[a];
    component_[a].viscous = state[3 + a];
  }
  pressure_ = state[6];
  update_pressure_gradient();
}

}  // namespace slfb::fluid
