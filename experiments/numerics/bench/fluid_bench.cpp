#include "experiments/numerics/bench/fluid_bench.hpp"

#include <cmath>
#include <vector>

#include "correlations/drag/drag_laws.hpp"
#include "solver/fluid/three_dimensional_liquid.hpp"
#include "solver/support/stopwatch.hpp"

namespace slfb::bench {

FluidTiming time_fluid(const Scene& scene, int threads, std::int64_t steps) {
  fluid::ThreeDimensionalLiquid liquid(scene, false, threads);
  const fluid::ColumnGrid& grid = liquid.grid();
  const auto layers = static_cast<std::size_t>(grid.layers());
  constexpr double diameter = 0.005, mean_voidage = 0.6;
  const double reynolds = scene.liquid.density * diameter * scene.liquid.superficial_velocity / scene.liquid.viscosity;
  const double beta = drag::exchange_coefficient(drag::Gidaspow1994{}({mean_voidage, reynolds}), mean_voidage, diameter,
                                                 scene.liquid.viscosity);
  std::vector<double> volume(grid.size()), before, now, coefficient(grid.size());
  for (std::size_t c = 0; c < grid.size(); ++c) {
    volume[c] = grid.volume(static_cast<int>(c / layers));
    coefficient[c] = c % layers < layers / 2 ? beta * volume[c] : 0.0;
  }
  fluid::Exchange exchange;
  for (std::size_t a = 0; a < 3; ++a) {
    liquid.scatter(a, coefficient, exchange.coefficient[a]);
    exchange.source[a].assign(liquid.nodes(a), 0.0);
  }
  // Each cell swings at its own phase, 1 Hz: the rate at which voidages change in a bed.
  const auto set_voidage = [&](std::int64_t step) {
    now.resize(grid.size());
    for (std::size_t c = 0; c < grid.size(); ++c) {
      const double phase =
          2.4 * static_cast<double>(c * c % 1009) + 6.28 * static_cast<double>(step) * scene.fluid.time_step;
      now[c] = volume[c] * (c % layers < layers / 2 ? mean_voidage + 0.15 * std::sin(phase) : 1.0);
    }
  };
  set_voidage(0);
  before = now;
  constexpr std::int64_t warm_up = 10;
  FluidTiming timing{.threads = threads, .cells = grid.size(), .steps = steps};
  fluid::LiquidCost cost;
  for (std::int64_t step = 1; step <= warm_up + steps; ++step) {
    if (step == warm_up + 1) cost = liquid.cost(), timing.seconds = 0.0;
    set_voidage(step);
    {
      const Stopwatch stopwatch(timing.seconds);
      liquid.advance(scene.fluid.time_step, before, now, exchange);
    }
    before.swap(now);
  }
  timing.momentum = liquid.cost().momentum_seconds - cost.momentum_seconds;
  timing.pressure = liquid.cost().pressure_seconds - cost.pressure_seconds;
  timing.iterations_per_step =
      static_cast<double>(liquid.cost().pressure_iterations - cost.pressure_iterations) / static_cast<double>(steps);
  timing.continuity_error = liquid.continuity_error();
  return timing;
}

}  // namespace slfb::bench
