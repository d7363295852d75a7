#include "solver/run/bed_recorder.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "correlations/fluidisation/bed_expansion.hpp"
#include "solver/dem/granular_temperature.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/bed_heights.hpp"
#include "solver/run/run_title.hpp"

namespace slfb::simulation {

void BedRecorder::measure_packed_bed(const Model& model, bool in_liquid) {
  const dem::Particles& particles = model.particles();
  if (particles.size() == 0) return;
  std::vector<double> volumes;
  std::vector<bool> floats;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    volumes.push_back(particles.volume(i));
    floats.push_back(in_liquid && particles.mass[i] < scene_.liquid.density * volumes.back());
  }
  const SettledBed settled =
      settled_bed(particles.position.z, volumes, floats, scene_.geometry.height, scene_.geometry.cross_section());
  result_.packed_height = settled.height;
  result_.packed_voidage = settled.voidage;
  double energy = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3 v = particles.velocity.vector(i);
    energy += particles.mass[i] * dot(v, v);
    mass += particles.mass[i];
  }
  constexpr double resting_speed = 1e-3;  // [m/s]
  const double speed = std::sqrt(energy / mass);
  if (speed > resting_speed)
    spdlog::warn(
        "{}: at the end of settling the spheres still move, at {:.2g} m/s on the average (root mean square; a bed at "
        "rest has less than {:g}): what is called the packed bed has not come to rest; a longer stage of kind = "
        "\"settle\" may help",
        run_title(scene_), speed, resting_speed);
}

void BedRecorder::look_for_standing_bed() const {
  const auto bed = std::ranges::max_element(
      scene_.species, {}, [](const Species& species) { return static_cast<double>(species.count) * species.volume(); });
  const LiquidProperties liquid{scene_.liquid.density, scene_.liquid.viscosity};
  if (bed == scene_.species.end() || bed->count == 0 || bed->density <= liquid.density || result_.bed.time.empty())
    return;
  const std::vector<double>& energies = result_.bed.fluctuating_energy;
  const auto half = energies.begin() + static_cast<std::ptrdiff_t>(energies.size() / 2);
  const double speed = std::sqrt(2.0 / 3.0 * *std::max_element(half, energies.end()));
  const double velocity = scene_.liquid.superficial_velocity;
  // A fluidised bed has some tenths of the superficial velocity, and a packed one 0.35 to 0.45 of voidage.
  constexpr double still = 1e-3, surely_above = 1.1;
  const double voidage = result_.packed_voidage > 0.3 && result_.packed_voidage < 0.5 ? result_.packed_voidage : 0.4;
  if (speed > still * velocity) return;
  const double minimum = fluidisation::minimum_fluidisation_velocity(find_drag_law(scene_.coupling.drag_law),
                                                                     {bed->diameter, bed->density}, liquid, voidage);
  if (velocity < surely_above * minimum) return;
  spdlog::warn(
      "{}: the bed stands still (velocities of {:.2g} m/s) although liquid.superficial_velocity = {:g} m/s is {:.2f} "
      "times its minimum fluidisation velocity of {:.3g} m/s ({} at a voidage of {:.2f}): friction at near walls or a "
      "bridge may hold it, or it rests as a plug; a wider column or tier = \"three-dimensional\" would tell",
      run_title(scene_), speed, velocity, velocity / minimum, minimum, scene_.coupling.drag_law, voidage);
}

bool BedRecorder::sample(const Model& model, double time, double superficial_velocity) {
  const dem::Particles& particles = model.particles();
  const dem::Engine& engine = model.engine();
  const std::optional<std::size_t> dropped = model.dropped();
  std::vector<double> heights, volumes;
  double contacts = 0.0, events = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (i == dropped) continue;
    heights.push_back(particles.position.z[i]);
    volumes.push_back(particles.volume(i));
    contacts += engine.contacts(i);
    events += static_cast<double>(engine.contact_events(i));
  }
  if (heights.empty()) return false;
  const auto n = static_cast<double>(heights.size());
  const BedHeights measured = bed_heights(std::move(heights), volumes);
  BedSeries& bed = result_.bed;
  bed.time.push_back(time);
  bed.pressure_drop.push_back(model.liquid().inlet_pressure());
  bed.centre_of_mass_height.push_back(measured.centre_of_mass);
  bed.bed_top.push_back(measured.top);
  const double box = 8.0 * *std::max_element(particles.radius.begin(), particles.radius.end());
  bed.fluctuating_energy.push_back(dem::fluctuating_energy(particles, dropped));
  bed.local_fluctuating_energy.push_back(dem::local_fluctuating_energy(particles, {box, box, box}, dropped));
  bed.contacts_per_particle.push_back(contacts / n);
  bed.cumulative_contacts.push_back(events / n);
  sample_contact_forces(model, time);
  bed.maximum_overlap.push_back(engine.maximum_overlap());
  bed.foreign_present.push_back(dropped ? 1.0 : 0.0);
  bed.superficial_velocity.push_back(superficial_velocity);
  return true;
}

/// Mean normal force of the contacts, by what touches, and whether the time step can follow the contact network.
void BedRecorder::sample_contact_forces(const Model& model, double time) {
  enum Kind : std::size_t { bed, dropped, wall };
  std::array<double, 3> sum{}, count{};
  for (const auto& pair : model.engine().touching_pairs()) {
    const bool of_dropped = pair.first == model.dropped() || (!pair.at_wall && pair.second == model.dropped());
    const Kind kind = pair.at_wall ? wall : of_dropped ? dropped : bed;
    sum[kind] += pair.normal_force;
    count[kind] += 1.0;
  }
  const auto mean = [&](Kind kind) { return count[kind] > 0.0 ? sum[kind] / count[kind] : 0.0; };
  result_.bed.contact_force_bed.push_back(mean(bed));
  result_.bed.contact_force_foreign.push_back(mean(dropped));
  result_.bed.contact_force_wall.push_back(mean(wall));
  const double time_step = model.engine().time_step();
  const double network_step = time_step * std::sqrt(model.engine().network_frequency_squared());
  result_.bed.network_step.push_back(network_step);
  if (network_step > 2.0 && !warned_of_network_) {
    warned_of_network_ = true;
    spdlog::warn(
        "{}: at {:.3f} s the contacts of one sphere make up to {:.2f} of contact.time_step = {:g} s; steps are surely "
        "stable only below 2 (step times frequency, 2 sum k/m per sphere), so that here {:.3g} s would be needed",
        run_title(scene_), time, network_step, time_step, 2.0 / network_step * time_step);
  }
}

}  // namespace slfb::simulation
