#include "solver/fluid/staggered_liquid.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "solver/support/stopwatch.hpp"

namespace slfb::fluid {

StaggeredLiquid::StaggeredLiquid(const Scene& scene, LateralBoundary wall, bool closed, int threads)
    : grid_(scene),
      density_(scene.liquid.density),
      closed_(closed),
      threads_(threads),
      momentum_(grid_, scene, wall, closed, threads),
      pressure_(grid_.size(), 0.0) {}

void StaggeredLiquid::advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
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
    momentum_.start_step(time_step, before, now, exchange);
  }
  solve(exchange);
  momentum_.end_step();
}

void StaggeredLiquid::scatter(std::size_t a, const std::vector<double>& cells, std::vector<double>& nodes) const {
  const auto& c = momentum_.component[a];
  nodes.resize(c.size());
  c.scatter({0, c.sections}, cells, nodes);
}

void StaggeredLiquid::scatter(const std::array<std::vector<double>, 5>& cells, Exchange& exchange) const {
  for (std::size_t a = 0; a < 3; ++a)
    for (auto* field : {&exchange.coefficient[a], &exchange.source[a], &exchange.volume[a]}) field->resize(nodes(a));
  momentum_.for_ranges([&](std::size_t a, SectionRange own, int) {
    const auto& c = momentum_.component[a];
    c.scatter(own, cells[0], exchange.coefficient[a]);
    c.scatter(own, cells[a + 1], exchange.source[a]);
    c.scatter(own, cells[4], exchange.volume[a]);
  });
}

void StaggeredLiquid::gather(std::size_t a, const std::vector<double>& nodes, std::vector<double>& cells) const {
  cells.resize(grid_.size());
  for (int cell = 0; cell < grid_.cells(); ++cell)
    momentum_.component[a].gather(
        cell, [&](std::size_t n) { return nodes[n]; }, &cells[index_of(cell, 0, grid_.layers())]);
}

void StaggeredLiquid::gather(std::array<std::vector<double>, 3>& velocity,
                             std::array<std::vector<double>, 3>& stress) const {
  for (auto* fields : {&velocity, &stress})
    for (auto& field : *fields) field.resize(grid_.size());
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (int cell = 0; cell < grid_.cells(); ++cell)
    for (std::size_t a = 0; a < 3; ++a) {
      const MomentumEquations::Component& c = momentum_.component[a];
      const double *u = c.velocity.data(), *viscous = c.viscous.data(), *gradient = c.pressure_gradient.data();
      const std::size_t start = index_of(cell, 0, grid_.layers());
      c.gather(
          cell, [=](std::size_t n) { return u[n]; }, &velocity[a][start]);
      c.gather(
          cell, [=](std::size_t n) { return viscous[n] - gradient[n]; }, &stress[a][start]);
    }
}

double StaggeredLiquid::taken_by(const Exchange& exchange, std::size_t a) const {
  const auto& c = momentum_.component[a];
  double sum = 0.0;
  for (std::size_t n = 0; n < c.size(); ++n)
    sum += exchange.coefficient[a][n] * c.velocity[n] - exchange.source[a][n] -
           exchange.volume[a][n] * (c.viscous[n] - c.pressure_gradient[n]);
  return sum;
}

template <bool correct_velocity>
void StaggeredLiquid::set_pressure_gradient(const std::array<std::vector<double>, 3>& mobility_of) {
  const int layers = grid_.layers();
  momentum_.for_sections([&, layers](std::size_t a, int s) {
    MomentumEquations::Component& c = momentum_.component[a];
    const std::size_t start = index_of(s, 0, c.levels);
    double* gradient = &c.pressure_gradient[start];
    double* velocity = &c.velocity[start];
    const double* mobility = correct_velocity ? &mobility_of[a][start] : nullptr;
    const auto set = [=](int k, double value) {
      if constexpr (correct_velocity) velocity[k] -= mobility[k] * (value - gradient[k]);
      gradient[k] = value;
    };
    const double *lower = &pressure_[index_of(c.owner[as_index(s)][0], 0, layers)],
                 *upper = &pressure_[index_of(c.owner[as_index(s)][1], 0, layers)];
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

void StaggeredLiquid::update_pressure_gradient() { set_pressure_gradient<false>({}); }

void StaggeredLiquid::update_pressure_gradient(const std::array<std::vector<double>, 3>& mobility) {
  set_pressure_gradient<true>(mobility);
}

double StaggeredLiquid::outflow() const {
  const MomentumEquations::Component& c = momentum_.component[vertical];
  double sum = 0.0;
  for (int s = 0; s < c.sections; ++s) {
    const std::size_t top = index_of(s, grid_.layers(), c.levels);
    sum += density_ * c.flow[top] * c.velocity[top];
  }
  return sum;
}

void StaggeredLiquid::record_vertical_forces(double leaving) {
  const MomentumEquations::Component& c = momentum_.component[vertical];
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
  if (momentum_.of_second_order()) vertical_forces_.momentum_rate = momentum_.vertical_momentum_rate();
  for (int s = 0; s < c.sections; ++s)
    vertical_forces_.inflow +=
        density_ * momentum_.convected_inlet()[as_index(s)] * grid_.area(s) * momentum_.entering_velocity(s);
}

double StaggeredLiquid::vertical_momentum() const {
  const MomentumEquations::Component& c = momentum_.component[vertical];
  const std::vector<double>& liquid = momentum_.settled_flow() ? c.liquid_before : c.liquid_now;
  double sum = 0.0;
  for (int s = 0; s < c.sections; ++s)
    for (int k = c.first; k <= c.last; ++k) {
      const std::size_t n = index_of(s, k, c.levels);
      sum += density_ * liquid[n] * c.velocity[n];
    }
  return sum;
}

double StaggeredLiquid::inlet_pressure() const {
  const int layers = grid_.layers();
  double sum = 0.0;
  for (int c = 0; c < grid_.cells(); ++c) {
    const double lowest = pressure_[index_of(c, 0, layers)];
    const double next = layers > 1 ? pressure_[index_of(c, 1, layers)] : 0.0;
    sum += grid_.area(c) * (1.5 * lowest - 0.5 * next);
  }
  return sum / grid_.section_area();
}

NamedFields StaggeredLiquid::state() const {
  NamedFields state;
  momentum_.add_state(state);
  state["pressure"] = pressure_;
  return state;
}

void StaggeredLiquid::restore(const NamedFields& state) {
  momentum_.restore(state);
  pressure_ = field_of(state, "pressure", pressure_.size());
  update_pressure_gradient();
}

}  // namespace slfb::fluid
