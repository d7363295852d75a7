#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/fluid/momentum_equations.hpp"

namespace slfb::fluid {
namespace {

/// Of the sweeps: what is still to come, over the largest velocity, that ends them [-], and how many there may be.
constexpr double momentum_tolerance = 1e-10;
constexpr int most_sweeps = 5000;

}  // namespace

/// The momentum equations are strongly diagonal (a step is short against drag and convection): Jacobi sweeps suffice.
/// Each changes the velocity by about the same small part of what the last one did, so that what is still to come is
/// known.
///
/// Called by all threads together. `current` and `next` hold the velocity in turn; after the last sweep it is the
/// former that `c.velocity` becomes.
void MomentumEquations::run_sweeps(std::size_t a, SectionRange own, int thread, Scratch& scratch) {
  Component& c = component[a];
  const int levels = c.levels, first = c.first, last = c.last;
  double last_change = 0.0;
  for (int s = own.first; s < own.last; ++s) {  // what is given stays as it is
    const std::size_t start = index_of(s, 0, levels), end = start + as_index(levels);
    std::copy(&c.velocity[start], &c.velocity[start] + c.first, &c.next[start]);
    for (std::size_t n = start + as_index(c.last) + 1; n < end; ++n) c.next[n] = c.velocity[n];
  }
  double *current = c.velocity.data(), *updated = c.next.data();
  int sweep = 0;
  while (sweep < most_sweeps) {
    scratch.change.assign(as_index(levels), 0.0);
    scratch.peak.assign(as_index(levels), 0.0);
    for (int s = own.first; s < own.last; ++s) {
      const std::size_t start = index_of(s, 0, levels);
      const auto next_to = [&](std::size_t direction) {
        const int t = c.neighbour[as_index(s)][direction];
        return current + index_of(t >= 0 ? t : s, 0, levels);  // a missing neighbour has the weight 0
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
    // Each thread writes its own entry; those of the next sweep go to the other list, so that none is overwritten while
    // another thread reads it.
    auto& of_threads = c.sweep_change[as_index(sweep % 2)];
    of_threads[as_index(thread)] = {*std::max_element(scratch.change.begin(), scratch.change.end()),
                                    *std::max_element(scratch.peak.begin(), scratch.peak.end())};
    ++sweep;
#pragma omp barrier
    double change = 0.0, largest = 0.0;
    for (const auto& [change_there, largest_there] : of_threads) {
      change = std::max(change, change_there);
      largest = std::max(largest, largest_there);
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

void MomentumEquations::check_sweeps() const {
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& c = component[a];
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

}  // namespace slfb::fluid
