#include "solver/coupling/liquid_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/coupling/void_fraction/single_cell.hpp"

namespace slfb::coupling {
namespace {

double largest_radius(const Scene& scene) {
  double radius = 0.0;
  for (const Species& species : scene.species) radius = std::max(radius, 0.5 * species.diameter);
  return radius;
}

VolumeShares make_shares(const Scene& scene, const fluid::Liquid& liquid) {
  if (!liquid.two_way())
    return {std::make_unique<SingleCell>(), liquid.grid(), std::numeric_limits<double>::infinity()};
  return {make_share_scheme(scene.coupling), liquid.grid(), largest_radius(scene)};
}

}  // namespace

LiquidVolumes::LiquidVolumes(const Scene& scene, const fluid::Liquid& liquid)
    : scene_(scene),
      grid_(liquid.grid()),
      two_way_(liquid.two_way()),
      shares_(make_shares(scene, liquid)),
      lone_(grid_, two_way_ && scene.coupling.own_volume == OwnVolume::spread_where_alone),
      smoothing_(grid_, two_way_ ? scene.coupling.smoothing_length : 0.0) {}

void LiquidVolumes::start_anew() {
  anew_ = true;
  steps_done_ = steps_;
}

int LiquidVolumes::steps_per_interval() const {
  return static_cast<int>(std::max(1L, std::lround(scene_.coupling.void_fraction_interval / scene_.fluid.time_step)));
}

/// Shares of the spheres, what they fill of each cell, and who is alone.
void LiquidVolumes::find_shares(const dem::VectorField& centres, const std::vector<double>& radii,
                                const std::vector<double>& sphere_volume, int threads) {
  shares_.update(centres, radii, threads);
  shares_.scatter<1>({&sphere_volume}, {&solid_}, threads);
  lone_.update(centres.z, radii, shares_, sphere_volume, solid_);
}

/// The liquid at the end of an interval, from where the spheres will then be; after a sphere has been put in or taken
/// out an interval of a single step, which displaces nothing.
void LiquidVolumes::start_interval(const dem::Engine& engine, double time_step,
                                   const std::vector<double>& sphere_volume) {
  const dem::Particles& particles = engine.particles;
  steps_done_ = 0;
  steps_ = anew_ ? 1 : steps_per_interval();
  if (steps_per_interval() == 1) {
    find_shares(particles.position, particles.radius, sphere_volume, engine.threads());
  } else {
    const double ahead = (steps_ - 1) * time_step;
    centres_ = particles.position;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      centres_.x[i] += ahead * particles.velocity.x[i];
      centres_.y[i] += ahead * particles.velocity.y[i];
      centres_.z[i] += ahead * particles.velocity.z[i];
    }
    find_shares(centres_, particles.radius, sphere_volume, engine.threads());
  }
  // Equation (29): V_L = V_cell − Σ φ_i V_i
  lone_.spread(sphere_volume, shares_, solid_);
  smoothing_.scatter(solid_, engine.threads());
  at_end_.resize(grid_.size());
  const auto layers = static_cast<std::size_t>(grid_.layers());
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (int s = 0; s < grid_.cells(); ++s) {
    const std::size_t start = static_cast<std::size_t>(s) * layers;
    const double volume = grid_.volume(s), *solid = &solid_[start];
    double* liquid = &at_end_[start];
#pragma omp simd
    for (std::size_t k = 0; k < layers; ++k) liquid[k] = volume - solid[k];
  }
  if (steps_ > 1) at_start_ = before_;
}

bool LiquidVolumes::start_step(const dem::Engine& engine, double time_step, const std::vector<double>& sphere_volume) {
  if (!two_way_) {
    shares_.update(engine.particles, engine.threads());
    voidage_.assign(grid_.size(), 1.0);
    return true;
  }
  const bool new_shares = steps_done_ >= steps_ || at_end_.empty();
  if (new_shares) start_interval(engine, time_step, sphere_volume);
  ++steps_done_;
  const double done = static_cast<double>(steps_done_) / steps_;
  now_.resize(grid_.size());
  voidage_.resize(grid_.size());
  const auto layers = static_cast<std::size_t>(grid_.layers());
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (int s = 0; s < grid_.cells(); ++s) {
    const std::size_t start = static_cast<std::size_t>(s) * layers;
    const double volume = grid_.volume(s), *end = &at_end_[start];
    double *liquid = &now_[start], *voidage = &voidage_[start];
    std::copy_n(end, layers, liquid);
    if (steps_done_ < steps_)
      for (std::size_t k = 0; k < layers; ++k) {
        const double before = at_start_[start + k];
        liquid[k] = before + done * (end[k] - before);
      }
#pragma omp simd
    for (std::size_t k = 0; k < layers; ++k) voidage[k] = liquid[k] / volume;
  }
  smoothing_.gather(voidage_, engine.threads());
  if (std::exchange(anew_, false)) before_ = now_;
  return new_shares;
}

void LiquidVolumes::add_rest_of_interval(std::vector<double>& cells) const {
  if (steps_done_ >= steps_) return;
  for (std::size_t c = 0; c < cells.size(); ++c) cells[c] += at_end_[c] - now_[c];
}

NamedFields LiquidVolumes::state() const {
  NamedFields state{{"liquid_volume", anew_ ? std::vector<double>{} : before_}};
  if (centres_.x.empty() || steps_done_ >= steps_) return state;
  state["interval/steps"] = {static_cast<double>(steps_), static_cast<double>(steps_done_)};
  state["interval/liquid_at_start"] = at_start_;
  state["interval/liquid_at_end"] = at_end_;
  state["interval/centre_x"] = centres_.x;
  state["interval/centre_y"] = centres_.y;
  state["interval/centre_z"] = centres_.z;
  return state;
}

void LiquidVolumes::restore(const NamedFields& state, const std::vector<double>& radius) {
  const std::size_t cells = grid_.size(), spheres = radius.size();
  before_ = field_or_none(state, "liquid_volume", cells);
  anew_ = before_.empty();
  if (!state.contains("interval/steps")) return;
  constexpr std::size_t most = std::numeric_limits<int>::max();
  steps_ = static_cast<int>(index_of(state, "interval/steps", 0, most));
  steps_done_ = static_cast<int>(index_of(state, "interval/steps", 1, static_cast<std::size_t>(steps_)));
  at_start_ = field_of(state, "interval/liquid_at_start", cells);
  at_end_ = field_of(state, "interval/liquid_at_end", cells);
  centres_ = {field_of(state, "interval/centre_x", spheres), field_of(state, "interval/centre_y", spheres),
              field_of(state, "interval/centre_z", spheres)};
  std::vector<double> sphere_volume;
  sphere_volume.reserve(radius.size());
  for (const double r : radius) sphere_volume.push_back(dem::Particles::volume_of(r));
  find_shares(centres_, radius, sphere_volume, 1);
}

}  // namespace slfb::coupling
