#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/particles.hpp"
#include "solver/fluid/liquid.hpp"
#include "solver/scene/scene.hpp"
#include "solver/support/stopwatch.hpp"

namespace slfb::studies {

/// Spheres and liquid that are advanced together without stages, recording or checkpoints: what studies and benchmarks
/// measure in between is theirs.
class CoupledBed {
 public:
  /// \param scene its geometry, liquid, numerics and species are used; stages and counts are not
  /// \param spheres the start, with positions, velocities and angular velocities; their densities are those of their
  /// species
  /// \throws what engine, liquid and coupling throw for a scene that they cannot solve
  CoupledBed(const Scene& scene, const dem::Particles& spheres, int threads = 1);

  /// Advances by round(`seconds`/liquid step) steps of the liquid, each with the whole number of solid steps that is
  /// nearest to it, and calls `each()` after each. Throws std::runtime_error when a method breaks down.
  template <class Each>
  void advance(double seconds, Each&& each) {
    const auto substeps = std::llround(scene_.fluid.time_step / scene_.contact.time_step);
    for (std::int64_t k = std::llround(seconds / scene_.fluid.time_step); k > 0; --k) {
      exchange.advance(engine, scene_.fluid.time_step);
      {
        const Stopwatch stopwatch(particle_seconds);
        engine.advance(substeps);
      }
      each();
    }
  }
  void advance(double seconds) {
    advance(seconds, [] {});
  }

 private:
  Scene scene_;

 public:
  dem::Engine engine;

 private:
  std::unique_ptr<fluid::Liquid> owned_liquid_;

 public:
  fluid::Liquid& liquid;
  coupling::PhaseCoupling exchange;
  double particle_seconds = 0.0;  ///< wall time of the spheres' motion so far [s]
};

/// 3600 glass spheres of 5 mm in water at 0.10 m/s in a column of 50 mm, cells of 6.25 mm, springs of 1e3 N/m; liquid
/// step 1e-3 s, solid step 1e-4 s, which suits any liquid step between 1e-4 and 1e-3 s.
Scene glass_bed();

/// Spheres of the scene's bed after `seconds` of fluidisation from a loose packing, with the scene's own steps.
dem::Particles fluidised(const Scene& scene, double seconds, int threads = 1);

}  // namespace slfb::studies
