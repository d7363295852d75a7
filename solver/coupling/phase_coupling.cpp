#include "solver/coupling/phase_coupling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "correlations/fluidisation/fluidisation_laws.hpp"
#include "correlations/law_list.hpp"
#include "solver/support/stopwatch.hpp"

namespace slfb::coupling {
namespace {

/// How far a sphere's shares, or its own volume put back, may miss 1 by rounding [-].
constexpr double rounding_of_shares = 1e-9;

bool is_file(const std::string& law) { return law.ends_with(".cpp"); }

using WallLaw = double (*)(double diameter_ratio);

WallLaw wall_law_of(const Scene& scene) {
  if (scene.coupling.wall_retardation == "none") return nullptr;
  return with_law<fluidisation::WallCorrectionLaws>(
      "wall law", scene.coupling.wall_retardation,
      [](auto law) -> WallLaw { return [](double diameter_ratio) { return decltype(law){}(diameter_ratio); }; });
}

}  // namespace

PhaseCoupling::PhaseCoupling(const Scene& scene, fluid::Liquid& liquid, const drag::DragLawKernels& drag_law)
    : scene_(scene),
      liquid_(liquid),
      gravity_(scene.geometry.gravity()),
      law_(drag_law.drag),
      law_name_(is_file(scene.coupling.drag_law) ? fmt::format("{} ({})", drag_law.info.name, scene.coupling.drag_law)
                                                 : std::string(drag_law.info.name)),
      wall_law_(wall_law_of(scene)),
      volumes_(scene, liquid),
      point_values_(liquid.grid(), scene.coupling.interpolation, scene.fluid.wall == LateralBoundary::no_slip),
      beyond_drag_(scene, scene.fluid.time_step),
      at_centres_(liquid.two_way() && scene.coupling.interpolation != Interpolation::shares),
      corrects_disturbance_(liquid.two_way() && beyond_drag_.corrects_disturbance()),
      implicit_(liquid.two_way() && scene.coupling.exchange == MomentumExchange::implicit) {}

void PhaseCoupling::resize(std::size_t n) {
  for (auto* field : {&volume_, &voidage_, &reynolds_, &coefficient_, &damped_coefficient_, &next_coefficient_,
                      &beyond_coefficient_, &stressed_volume_})
    field->resize(n);
  for (auto* fields : {&velocity_correction_, &liquid_velocity_, &drag_, &free_velocity_, &momentum_, &beyond_force_,
                       &beyond_reaction_})
    for (auto& field : *fields) field.resize(n, 0.0);
}

void PhaseCoupling::sphere_removed(std::size_t i) {
  volumes_.start_anew();
  beyond_drag_.remove(i);
}

NamedFields PhaseCoupling::state() const {
  NamedFields state = volumes_.state();
  add_part(state, "forces_beyond_drag", beyond_drag_.state());
  return state;
}

void PhaseCoupling::restore(const NamedFields& state, const dem::Particles& particles) {
  volumes_.restore(state, particles.radius);
  beyond_drag_.restore(part_of(state, "forces_beyond_drag"), particles.size());
  cells_valid_ = velocity_is_gathered_ = false;
}

/// Shares and void fraction at the end of the step (Eq. 29).
void PhaseCoupling::update_void_fraction(const dem::Engine& engine, double time_step) {
  const Stopwatch stopwatch(void_fraction_seconds_);
  if (volumes_.start_step(engine, time_step, volume_)) velocity_is_gathered_ = false;
  const std::vector<double>& voidage = volumes_.voidage();
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (std::size_t c = 0; c < cells_.size(); ++c) cells_[c].value[CellValues::voidage] = voidage[c];
}

void PhaseCoupling::update_section_means() {
  if (!volumes_.lone().any()) return;
  section_means_ =
      volumes_.lone().section_means<8>([&](std::size_t cell, std::size_t field) { return cells_[cell].value[field]; });
}

/// Velocity and stress of the liquid, cell by cell.
void PhaseCoupling::read_liquid(int threads) {
  liquid_.gather(cell_velocity_, cell_stress_);
  for (auto* fields : {&cell_velocity_, &cell_stress_})
    for (auto& field : *fields) volumes_.smoothing().gather(field, threads);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::size_t c = 0; c < cells_.size(); ++c)
    for (std::size_t a = 0; a < 3; ++a) {
      cells_[c].value[CellValues::velocity_x + a] = cell_velocity_[a][c];
      cells_[c].value[CellValues::stress_x + a] = cell_stress_[a][c];
    }
  update_section_means();
  cells_valid_ = true;
}

/// Σ_c φ_ic of what the cells hold (Eq. 29).
inline std::array<double, 8> PhaseCoupling::mean_by_shares(std::size_t i) const {
  const VolumeShares& shares = volumes_.shares();
  const std::uint32_t* cell = shares.cells(i);
  const double* share = shares.shares(i);
  const int count = shares.count(i);
  std::array<double, 8> mean{};
  for (int m = 0; m < count; ++m)
    for (std::size_t f = 0; f < 8; ++f) mean[f] += share[m] * cells_[cell[m]].value[f];
  return mean;
}

/// Voidage, slip and Reynolds number, the drag's coefficient K, and K' and v' of Eq. 35. The contacts of the last step
/// are among the other forces: in a bed at rest the drag is then exactly K u.
void PhaseCoupling::read_at_spheres(const dem::Engine& engine, double time_step) {
  const dem::Particles& particles = engine.particles;
  const double density = scene_.liquid.density, viscosity = scene_.liquid.viscosity;
  const bool explicit_exchange = drag_is_explicit();
  const bool corrected = slip_is_corrected(), beyond_drag = beyond_drag_.any();
  // Within an interval of the void fraction the end of the last step has read the same velocities by the same shares.
  const bool gathered = velocity_is_gathered_ && !corrected;
  const auto n = static_cast<std::int64_t>(particles.size());
  constexpr std::int64_t block = 256;
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (std::int64_t first = 0; first < n; first += block) {
    const auto begin = static_cast<std::size_t>(first), end = static_cast<std::size_t>(std::min(first + block, n));
    std::array<std::array<double, 8>, block> values;
    for (std::size_t i = begin; i < end; ++i) {
      std::array<double, 8>& value = values[i - begin];
      if (gathered) {
        value = {};
        value[CellValues::voidage] = volumes_.shares().gather(i, volumes_.voidage());
        for (std::size_t a = 0; a < 3; ++a) value[CellValues::velocity_x + a] = liquid_velocity_[a][i];
      } else {
        value = mean_by_shares(i);
      }
      std::array<double, 3> u{value[CellValues::velocity_x], value[CellValues::velocity_y],
                              value[CellValues::velocity_z]};
      const double alone = volumes_.lone().weight(i);
      if (alone > 0.0) {
        // Voidage and velocity where the sphere is, less what of its spread volume lies there.
        const double voidage = value[CellValues::voidage] + volumes_.lone().own_spread_fraction(i);
        value = volumes_.lone().mean(i, value, section_means_);
        value[CellValues::voidage] = voidage;
      }
      // Equations (30), (31), or trilinear
      if (at_centres_) {
        const auto at_centre = point_values_.at(particles.position.at(i), cells_);
        value[CellValues::voidage] = at_centre[0] + volumes_.lone().own_spread_fraction(i);
        std::copy_n(at_centre.begin() + 1, 3, u.begin());
      }
      if (corrects_disturbance_) {
        const Vec3 own = beyond_drag_.self_induced(i);
        const std::array<double, 3> induced{own.x, own.y, own.z};
        for (std::size_t a = 0; a < 3; ++a) u[a] -= induced[a];
        value[CellValues::voidage] =
            undisturbed_voidage(value[CellValues::voidage], (1.0 - alone) * volume_[i] * own_concentration(i));
      }
      if (corrected)
        for (std::size_t a = 0; a < 3; ++a) velocity_correction_[a][i] = u[a] - value[CellValues::velocity_x + a];
      const double x = u[0] - particles.velocity.x[i], y = u[1] - particles.velocity.y[i],
                   z = u[2] - particles.velocity.z[i];
      // Sums of shares round; a law may take a root of what is left for the spheres. What a gradient (Eq. 30 of Peng
      // 2014) extrapolates beyond 1 stays: the law's range tells of it.
      voidage_[i] = value[CellValues::voidage];
      if (voidage_[i] > 1.0 && voidage_[i] < 1.0 + rounding_of_shares) voidage_[i] = 1.0;
      // Equation (25)
      reynolds_[i] = density * 2.0 * particles.radius[i] * voidage_[i] * std::sqrt(x * x + y * y + z * z) / viscosity;
    }
    // One indirect call per block of spheres; the law itself is inlined in the loop over them.
    evaluate_law(particles, begin, end, coefficient_);
    for (std::size_t i = begin; i < end; ++i) {
      const std::array<double, 8>& value = values[i - begin];
      const double volume = volume_[i], per_inertia = time_step / particles.inertial_mass(i);
      // Equations (22), (23): K = V β/(1 − α)
      coefficient_[i] =
          volume * drag::exchange_per_solid_volume(coefficient_[i], voidage_[i], 2.0 * particles.radius[i], viscosity);
      if (beyond_drag) coefficient_[i] += beyond_coefficient_[i];
      const auto solid = engine.mean_solid_force(i);
      const std::array<double, 3> v = particles.velocity.at(i);
      const double buoyant_mass = particles.mass[i] - density * volume;
      // Equation (35): K' = K/(1 + K Δt/m), and v' without the liquid's stress
      damped_coefficient_[i] = coefficient_[i] / (1.0 + coefficient_[i] * per_inertia);
      for (std::size_t a = 0; a < 3; ++a) {
        double other = solid[a] + gravity_[a] * buoyant_mass;
        if (beyond_drag) other += beyond_force_[a][i];
        free_velocity_[a][i] = v[a] + per_inertia * other;
        if (explicit_exchange)  // the force itself, as momentum that the liquid gains
          drag_[a][i] = coefficient_[i] *
                        (value[CellValues::velocity_x + a] + (corrected ? velocity_correction_[a][i] : 0.0) - v[a]);
      }
    }
  }
}

/// F of the drag law for some spheres. A tube slows a sphere alone to k times its velocity: its drag at Re is k^-1
/// times that without walls at Re/k. What a law throws or gives goes to law_error_, as threads cannot throw.
void PhaseCoupling::evaluate_law(const dem::Particles& particles, std::size_t begin, std::size_t end,
                                 std::vector<double>& result) {
  const auto k = [&](std::size_t i) { return wall_law_(2.0 * particles.radius[i] / scene_.geometry.diameter); };
  try {
    if (wall_law_ != nullptr)
      for (std::size_t i = begin; i < end; ++i) reynolds_[i] /= k(i);
    law_(&voidage_[begin], &reynolds_[begin], &result[begin], end - begin);
    if (wall_law_ != nullptr)
      for (std::size_t i = begin; i < end; ++i) {
        reynolds_[i] *= k(i);
        result[i] /= k(i);
      }
    if (scene_.coupling.drag_times_voidage)  // Equation (20) as printed
      for (std::size_t i = begin; i < end; ++i) result[i] *= voidage_[i];
    bool usable = true;
    for (std::size_t i = begin; i < end; ++i)
      usable = usable && result[i] >= 0.0 && result[i] < std::numeric_limits<double>::infinity();
    if (usable) return;
    for (std::size_t i = begin; i < end; ++i)
      if (!(result[i] >= 0.0 && result[i] < std::numeric_limits<double>::infinity()) && std::isfinite(voidage_[i]) &&
          std::isfinite(reynolds_[i]))
        throw LawError(fmt::format(
            "the drag law {} gives {:g} times Stokes drag at a voidage of {:.6g} and Re = {:.6g}; a drag is positive",
            law_name_, result[i], voidage_[i], reynolds_[i]));
  } catch (const LawError&) {
    keep_law_error(std::current_exception());
  } catch (const std::exception& error) {
    keep_law_error(
        std::make_exception_ptr(LawError(fmt::format("the drag law {} fails: {}", law_name_, error.what()))));
  } catch (...) {
    keep_law_error(std::make_exception_ptr(
        LawError(fmt::format("the drag law {} throws something that is no std::exception", law_name_))));
  }
}

void PhaseCoupling::keep_law_error(std::exception_ptr error) {
#pragma omp critical(drag_law_error)
  if (!law_error_) law_error_ = std::move(error);
}

void PhaseCoupling::raise_law_error() {
  if (law_error_) std::rethrow_exception(std::exchange(law_error_, nullptr));
}

/// The stress that is in v' acts through the drag on the liquid: the liquid is solved with it. Taken from before the
/// step it would be returned amplified by up to (1 − α)/α, and grow without bound where the drag is stiff.
void PhaseCoupling::give_to_liquid(const dem::Engine& engine, double time_step) {
  if (!liquid_.two_way()) return;
  const bool explicit_exchange = drag_is_explicit();
  const bool corrected = slip_is_corrected();
  const auto n = static_cast<std::int64_t>(coefficient_.size());
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (std::int64_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (explicit_exchange) damped_coefficient_[i] = 0.0;
    stressed_volume_[i] = volume_[i] * damped_coefficient_[i] * time_step / engine.particles.inertial_mass(i);
    for (std::size_t a = 0; a < 3; ++a) {
      const double correction = corrected ? velocity_correction_[a][i] : 0.0;
      momentum_[a][i] = explicit_exchange ? -drag_[a][i] : damped_coefficient_[i] * (free_velocity_[a][i] - correction);
    }
    if (beyond_drag_.any())
      for (std::size_t a = 0; a < 3; ++a) momentum_[a][i] += beyond_reaction_[a][i];
  }
  // Equations (28), (29)
  const VolumeShares& shares = volumes_.shares();
  shares.scatter<5>({&damped_coefficient_, &momentum_[0], &momentum_[1], &momentum_[2], &stressed_volume_},
                    {&scattered_[0], &scattered_[1], &scattered_[2], &scattered_[3], &scattered_[4]}, engine.threads());
  const std::array<const std::vector<double>*, 5> given{&damped_coefficient_, &momentum_[0], &momentum_[1],
                                                        &momentum_[2], &stressed_volume_};
  for (std::size_t f = 0; f < given.size(); ++f) {
    volumes_.lone().spread(*given[f], shares, scattered_[f]);
    volumes_.smoothing().scatter(scattered_[f], engine.threads());
  }
  // The stress on the spheres acts where their shares are, the rest of it on the liquid: together on whole cells.
  volumes_.add_rest_of_interval(scattered_[4]);
  liquid_.scatter(scattered_, exchange_);
}

/// The drag at the liquid's new velocity, and all that the liquid does to the spheres, as a constant force.
void PhaseCoupling::give_to_spheres(dem::Engine& engine, double time_step) {
  const dem::Particles& particles = engine.particles;
  const std::array<std::vector<double>*, 3> external{&engine.external_force.x, &engine.external_force.y,
                                                     &engine.external_force.z};
  const bool explicit_exchange = drag_is_explicit();
  const bool corrected = slip_is_corrected();
  const auto n = static_cast<std::int64_t>(particles.size());
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (std::int64_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const std::array<double, 8> value = volumes_.lone().mean(i, mean_by_shares(i), section_means_);
    const double volume = volume_[i];
    for (std::size_t a = 0; a < 3; ++a) {
      double u = value[CellValues::velocity_x + a];
      if (corrected) u += velocity_correction_[a][i];
      liquid_velocity_[a][i] = u;
      // Equation (20): V (−∇p + ∇·τ), of the dynamic pressure
      const double stress_force = volume * value[CellValues::stress_x + a];
      if (!explicit_exchange) {  // Equation (35): F = K' (u − v'), now with the stress in v'
        const double without_drag = free_velocity_[a][i] + time_step / particles.inertial_mass(i) * stress_force;
        drag_[a][i] = damped_coefficient_[i] * (u - without_drag);
      }
      (*external[a])[i] = drag_[a][i] + stress_force;
      if (beyond_drag_.any()) (*external[a])[i] += beyond_force_[a][i];
    }
    // Weight, and buoyancy by the static pressure
    const double buoyant_mass = particles.mass[i] - scene_.liquid.density * volume;
    for (std::size_t a = 0; a < 3; ++a) (*external[a])[i] += gravity_[a] * buoyant_mass;
  }
  velocity_is_gathered_ = true;
}

/// β at the slip that the last pass has found; returns the largest relative change of K.
double PhaseCoupling::update_coefficient(const dem::Engine& engine, double time_step) {
  const dem::Particles& particles = engine.particles;
  const double density = scene_.liquid.density, viscosity = scene_.liquid.viscosity;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double squared = 0.0;
    // The new velocity of the sphere is that of Eq. 35: K (u − v_new) is the drag.
    for (std::size_t a = 0; a < 3; ++a) squared += drag_[a][i] * drag_[a][i];
    reynolds_[i] = density * 2.0 * particles.radius[i] * voidage_[i] * std::sqrt(squared) / coefficient_[i] / viscosity;
  }
  evaluate_law(particles, 0, particles.size(), next_coefficient_);
  raise_law_error();
  double change = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double coefficient =
        beyond_coefficient_[i] + volume_[i] * drag::exchange_per_solid_volume(next_coefficient_[i], voidage_[i],
                                                                              2.0 * particles.radius[i], viscosity);
    change = std::max(change, std::abs(coefficient - coefficient_[i]) / coefficient_[i]);
    coefficient_[i] = coefficient;
    damped_coefficient_[i] = coefficient / (1.0 + coefficient * time_step / particles.inertial_mass(i));
  }
  return change;
}

void PhaseCoupling::advance(dem::Engine& engine, double time_step) {
  const std::size_t n = engine.particles.size();
  resize(n);
#pragma omp parallel for num_threads(engine.threads()) schedule(static)
  for (std::size_t i = 0; i < n; ++i) volume_[i] = engine.particles.volume(i);
  cells_.resize(liquid_.grid().size());
  update_void_fraction(engine, time_step);
  cells_valid_ ? update_section_means() : read_liquid(engine.threads());
  if (beyond_drag_.any()) apply_forces_beyond_drag(engine);
  read_at_spheres(engine, time_step);
  raise_law_error();
  NamedFields start;
  if (implicit_) start = liquid_.state();
  for (passes_ = 1;; ++passes_) {
    give_to_liquid(engine, time_step);
    // Equations (26), (27)
    liquid_.advance(time_step, volumes_.before(), volumes_.now(), exchange_);
    read_liquid(engine.threads());
    give_to_spheres(engine, time_step);
    if (!implicit_) break;
    constexpr double tolerance = 1e-6;
    constexpr int most_passes = 50;
    const double change = update_coefficient(engine, time_step);
    if (change < tolerance) break;
    if (passes_ == most_passes)
      throw fluid::FluidError(
          fmt::format("implicit exchange: after {} passes the drag of a sphere still changes by {:.3g} of itself",
                      passes_, change));
    liquid_.restore(start);
  }
  volumes_.end_step();
  if (corrects_disturbance_) disturb_liquid(engine.particles);
}

/// What the spheres' drag does to the velocity that they themselves will read.
void PhaseCoupling::disturb_liquid(const dem::Particles& particles) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto v = particles.velocity.at(i);
    const double slip =
        std::hypot(liquid_velocity_[0][i] - v[0], liquid_velocity_[1][i] - v[1], liquid_velocity_[2][i] - v[2]);
    const double local = volumes_.lone().weight(i) - 1.0;  // of the drag, on the liquid
    beyond_drag_.disturb(i, {local * drag_[0][i], local * drag_[1][i], local * drag_[2][i]}, own_concentration(i),
                         voidage_[i], slip);
  }
}

/// Σ φ²/V_c of a sphere's shares [1/m³].
double PhaseCoupling::own_concentration(std::size_t i) const {
  const auto layers = static_cast<std::size_t>(liquid_.grid().layers());
  const VolumeShares& shares = volumes_.shares();
  const std::uint32_t* cell = shares.cells(i);
  const double* share = shares.shares(i);
  double sum = 0.0;
  for (int m = 0; m < shares.count(i); ++m)
    sum += share[m] * share[m] / liquid_.grid().volume(static_cast<int>(cell[m] / layers));
  return sum;
}

/// Forces that the scene has switched on beyond drag and pressure, from the liquid around each sphere before the step.
void PhaseCoupling::apply_forces_beyond_drag(dem::Engine& engine) {
  dem::Particles& particles = engine.particles;
  const std::size_t n = particles.size();
  const VolumeShares& shares = volumes_.shares();
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, 3> u{};
    const std::uint32_t* cell = shares.cells(i);
    const double* share = shares.shares(i);
    for (int m = 0; m < shares.count(i); ++m)
      for (std::size_t a = 0; a < 3; ++a) u[a] += share[m] * cells_[cell[m]].value[CellValues::velocity_x + a];
    if (at_centres_) {
      const auto at_centre = point_values_.at(particles.position.at(i), cells_);
      std::copy_n(at_centre.begin() + 1, 3, u.begin());
    }
    for (std::size_t a = 0; a < 3; ++a) liquid_velocity_[a][i] = u[a];
  }
  beyond_drag_.start_step(particles, liquid_velocity_);
  for (std::size_t i = 0; i < n; ++i) {
    ForcesBeyondDrag::Surroundings around{
        Vec3{liquid_velocity_[0][i], liquid_velocity_[1][i], liquid_velocity_[2][i]} - beyond_drag_.self_induced(i),
        {}};
    if (beyond_drag_.need_gradients()) {
      const auto gradient = point_values_.gradient(particles.position.at(i), cells_);
      for (std::size_t a = 0; a < 3; ++a)
        around.gradient[a] = {gradient[a + 1][0], gradient[a + 1][1], gradient[a + 1][2]};
    }
    const ForcesBeyondDrag::Effect effect = beyond_drag_.effect(particles, i, around);
    beyond_force_[0][i] = effect.force.x, beyond_force_[1][i] = effect.force.y, beyond_force_[2][i] = effect.force.z;
    beyond_reaction_[0][i] = effect.reaction.x, beyond_reaction_[1][i] = effect.reaction.y;
    beyond_reaction_[2][i] = effect.reaction.z;
    beyond_coefficient_[i] = effect.coefficient;
    const Vec3 change = beyond_drag_.change_of_angular_velocity(particles, i, around);
    particles.angular_velocity.x[i] += change.x;
    particles.angular_velocity.y[i] += change.y;
    particles.angular_velocity.z[i] += change.z;
  }
}

double PhaseCoupling::pressure_force(std::size_t i, std::size_t a) {
  std::vector<double> cells;
  liquid_.gather_pressure_gradient(a, cells);
  volumes_.smoothing().gather(cells);
  const LoneSpheres& lone = volumes_.lone();
  std::vector<std::array<double, 1>> means;
  if (lone.any()) means = lone.section_means<1>([&](std::size_t cell, std::size_t) { return cells[cell]; });
  const double gradient = lone.mean<1>(i, {volumes_.shares().gather(i, cells)}, means)[0];
  return -volume_[i] * (gradient + scene_.liquid.density * gravity_[a]);
}

std::vector<double> PhaseCoupling::void_fraction() const {
  std::vector<double> voidage(liquid_volume().size());
  const auto layers = static_cast<std::size_t>(liquid_.grid().layers());
  for (std::size_t c = 0; c < voidage.size(); ++c)
    voidage[c] = liquid_volume()[c] / liquid_.grid().volume(static_cast<int>(c / layers));
  return voidage;
}

}  // namespace slfb::coupling
