#include "solver/coupling/phase_coupling.hpp"

#include <algorithm>
#include <cmath>

#include "correlations/drag/drag_laws.hpp"
#include "solver/stopwatch.hpp"

namespace slfb::coupling {
namespace {

double largest_radius(const Scene& scene) {
  double radius = 0.0;
  for (const Species& species : scene.species) radius = std::max(radius, 0.5 * species.diameter);
  return radius;
}

}  // namespace

PhaseCoupling::PhaseCoupling(const Scene& scene, fluid::LiquidSolver* liquid) : scene_(scene), liquid_(liquid) {
  if (liquid != nullptr)
    shares_.emplace(scene.coupling.void_fraction, scene.coupling.meshing_pieces, liquid->grid(), largest_radius(scene));
  // One indirect call per step; the law itself is inlined in the loop over the spheres.
  law_ = drag::with_drag_law(scene.coupling.drag_law, [](auto law) -> LawKernel {
    return [law](std::span<const double> voidage, std::span<const double> reynolds, std::span<double> result) {
      for (std::size_t i = 0; i < voidage.size(); ++i) result[i] = law({voidage[i], reynolds[i]});
    };
  });
}

void PhaseCoupling::resize(std::size_t n) {
  for (auto* field : {&volume_, &voidage_, &reynolds_, &dimensionless_drag_, &coefficient_, &momentum_})
    field->resize(n);
  for (auto* fields : {&liquid_velocity_, &drag_, &pressure_force_, &other_force_, &predicted_velocity_, &stress_})
    for (auto& field : *fields) field.resize(n, 0.0);
}

/// Voidage, liquid velocity and Reynolds number (Eq. 25) at each sphere, then the drag coefficient K.
void PhaseCoupling::measure_slip(const dem::Particles& particles) {
  const std::size_t n = particles.size();
  const double density = scene_.liquid.density, viscosity = scene_.liquid.viscosity;
  if (liquid_ != nullptr)
    for (std::size_t a = 0; a < 3; ++a) {
      liquid_->gather(a, liquid_->velocity(a), cell_velocity_[a]);
      for (std::size_t i = 0; i < n; ++i) liquid_velocity_[a][i] = shares_->gather(i, cell_velocity_[a]);
    }
  for (std::size_t i = 0; i < n; ++i) {
    voidage_[i] = liquid_ != nullptr ? shares_->gather(i, cell_voidage_) : 1.0;
    const double slip = std::sqrt(std::pow(liquid_velocity_[0][i] - particles.velocity.x[i], 2) +
                                  std::pow(liquid_velocity_[1][i] - particles.velocity.y[i], 2) +
                                  std::pow(liquid_velocity_[2][i] - particles.velocity.z[i], 2));
    reynolds_[i] = density * 2.0 * particles.radius[i] * voidage_[i] * slip / viscosity;
  }
  law_(voidage_, reynolds_, dimensionless_drag_);
  for (std::size_t i = 0; i < n; ++i)
    coefficient_[i] = volume_[i] * drag::exchange_per_solid_volume(dimensionless_drag_[i], voidage_[i],
                                                                   2.0 * particles.radius[i], viscosity);
}

/// K' and v' of Eq. 35, the contacts of the last interval among the other forces: in a bed at rest the drag is then
/// exactly K u.
void PhaseCoupling::predict_velocity(const dem::Engine& engine, double time_step) {
  const auto& particles = engine.particles;
  const std::array<const std::vector<double>*, 3> velocity{&particles.velocity.x, &particles.velocity.y,
                                                           &particles.velocity.z};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto solid = engine.mean_solid_force(i);
    const double buoyant_weight = -gravity * (particles.mass[i] - scene_.liquid.density * volume_[i]);
    const double mass = particles.mass[i];
    const double damping = 1.0 + coefficient_[i] * time_step / mass;
    for (std::size_t a = 0; a < 3; ++a) {
      const double other = solid[a] + volume_[i] * stress_[a][i] + (a == 2 ? buoyant_weight : 0.0);
      predicted_velocity_[a][i] = (*velocity[a])[i] + time_step * other / mass;
    }
    coefficient_[i] /= damping;
  }
}

void PhaseCoupling::advance(dem::Engine& engine, double time_step) {
  dem::Particles& particles = engine.particles;
  const std::size_t n = particles.size();
  resize(n);
  for (std::size_t i = 0; i < n; ++i) volume_[i] = particles.volume(i);

  if (liquid_ != nullptr) {
    const Stopwatch stopwatch(void_fraction_seconds_);
    const fluid::ColumnGrid& grid = liquid_->grid();
    shares_->update(particles, engine.threads());
    shares_->scatter(volume_, solid_);
    liquid_now_.resize(grid.size());
    cell_voidage_.resize(grid.size());
    const auto layers = static_cast<std::size_t>(grid.layers());
    for (std::size_t c = 0; c < grid.size(); ++c) {
      const double cell_volume = grid.volume(static_cast<int>(c / layers));
      liquid_now_[c] = cell_volume - solid_[c];
      cell_voidage_[c] = liquid_now_[c] / cell_volume;
    }
    if (liquid_before_.empty()) liquid_before_ = liquid_now_;
  }
  const auto gather_stress = [&] {
    for (std::size_t a = 0; a < 3; ++a) {
      if (liquid_ == nullptr) {
        std::fill(stress_[a].begin(), stress_[a].end(), 0.0);
        continue;
      }
      liquid_->gather(a, liquid_->pressure_gradient(a), cell_stress_[a]);
      liquid_->gather(a, liquid_->viscous_force(a), cell_values_);
      for (std::size_t c = 0; c < cell_values_.size(); ++c) cell_values_[c] -= cell_stress_[a][c];
      for (std::size_t i = 0; i < n; ++i) stress_[a][i] = shares_->gather(i, cell_values_);
    }
  };
  gather_stress();
  measure_slip(particles);
  predict_velocity(engine, time_step);

  if (liquid_ != nullptr) {
    shares_->scatter(coefficient_, cell_values_);
    for (std::size_t a = 0; a < 3; ++a) liquid_->scatter(a, cell_values_, exchange_.coefficient[a]);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t i = 0; i < n; ++i) momentum_[i] = coefficient_[i] * predicted_velocity_[a][i];
      shares_->scatter(momentum_, cell_values_);
      liquid_->scatter(a, cell_values_, exchange_.source[a]);
    }
    liquid_->advance(time_step, liquid_before_, liquid_now_, exchange_);
    std::swap(liquid_before_, liquid_now_);
    gather_stress();
    for (std::size_t a = 0; a < 3; ++a) {
      liquid_->gather(a, liquid_->velocity(a), cell_velocity_[a]);
      for (std::size_t i = 0; i < n; ++i) liquid_velocity_[a][i] = shares_->gather(i, cell_velocity_[a]);
    }
  }

  const std::array<std::vector<double>*, 3> external{&engine.external_force.x, &engine.external_force.y,
                                                     &engine.external_force.z};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t i = 0; i < n; ++i) {
      drag_[a][i] = coefficient_[i] * (liquid_velocity_[a][i] - predicted_velocity_[a][i]);
      double force = drag_[a][i] + volume_[i] * stress_[a][i];
      double gradient = liquid_ != nullptr ? shares_->gather(i, cell_stress_[a]) : 0.0;
      if (a == 2) {
        gradient -= scene_.liquid.density * gravity;
        force -= gravity * (particles.mass[i] - scene_.liquid.density * volume_[i]);
      }
      pressure_force_[a][i] = -volume_[i] * gradient;
      (*external[a])[i] = force;
    }
}

double PhaseCoupling::drag_taken_from_liquid(std::size_t a) const {
  double sum = 0.0;
  const auto& velocity = liquid_->velocity(a);
  for (std::size_t n = 0; n < velocity.size(); ++n)
    sum += exchange_.coefficient[a][n] * velocity[n] - exchange_.source[a][n];
  return sum;
}

std::vector<double> PhaseCoupling::void_fraction() const {
  std::vector<double> voidage(liquid_before_.size());
  if (liquid_ == nullptr) return {};
  const auto layers = static_cast<std::size_t>(liquid_->grid().layers());
  for (std::size_t c = 0; c < voidage.size(); ++c)
    voidage[c] = liquid_before_[c] / liquid_->grid().volume(static_cast<int>(c / layers));
  return voidage;
}

std::array<std::vector<double>, 3> PhaseCoupling::cell_velocity() const { return cell_velocity_; }

}  // namespace slfb::coupling
