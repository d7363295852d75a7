#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "correlations/materials.hpp"
#include "experiments/runs/campaign.hpp"

/// Made-up runs with the shape of real ones, so that figures and the report can be tested without a simulation. None
/// of these numbers is a result.
namespace slfb::synthetic {

inline double bed_voidage(double superficial_velocity) { return std::pow(superficial_velocity / 0.428, 1.0 / 2.503); }

inline Scene scene(double superficial_velocity) {
  Scene scene;
  scene.title = "synthetic";
  scene.geometry = {Shape::cylinder, 0.05, {0, 0}, 1.0};
  scene.liquid = {998.2, 1e-3, superficial_velocity};
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"bed", 0.005, 2230.0, 3600}, {"foreign", 0.006, 7800.0, 0}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 5e-5;
  Stage settle;
  settle.kind = StageKind::settle;
  settle.duration = 1.0;
  Stage fluidise;
  fluidise.kind = StageKind::fluidise;
  fluidise.duration = 4.0;
  Stage drop;
  drop.kind = StageKind::drop;
  drop.duration = 6.0;
  drop.species = "foreign";
  drop.repetitions = 3;
  drop.release_height = 0.997;
  drop.relaxation = 0.5;
  scene.stages = {settle, fluidise, drop};
  return scene;
}

/// A fall: free until the bed's surface, then a steady descent with noise.
inline DropSeries drop(double superficial_velocity, double release_time, double bed_height, double speed,
                       std::mt19937& generator) {
  std::normal_distribution<double> noise(0.0, 1.0);
  DropSeries series;
  series.release_time = release_time;
  series.species = "foreign";
  const double voidage_in_bed = bed_voidage(superficial_velocity);
  const double weight = 7800.0 * 4.0 / 3.0 * 3.14159265 * std::pow(0.003, 3) * gravitational_acceleration;
  double z = 0.997;
  double v = 0.0;
  double contacts = 0.0;
  for (int step = 0; step <= 6000 && z > 0.003; ++step) {
    const double time = 1e-3 * step;
    const bool inside = z < bed_height;
    const double target = inside ? speed * (1.0 + 0.3 * noise(generator)) : 1.1 - superficial_velocity;
    v += (target - v) * (inside ? 0.05 : 0.008);
    z = std::max(0.003, z - 1e-3 * v);
    const double liquid = inside ? superficial_velocity / voidage_in_bed : superficial_velocity;
    const double voidage = inside ? std::clamp(voidage_in_bed + 0.05 * noise(generator), 0.4, 0.9) : 1.0;
    const double force = inside && noise(generator) > 0.3 ? 3.0 * weight * std::fabs(noise(generator)) : 0.0;
    if (force > 0.0) contacts += 1.0;
    series.time.push_back(time);
    series.x.push_back(0.002 * std::sin(time));
    series.y.push_back(0.001 * std::cos(time));
    series.z.push_back(z);
    series.velocity_x.push_back(0.01 * noise(generator));
    series.velocity_y.push_back(0.01 * noise(generator));
    series.velocity_z.push_back(-v);
    series.angular_speed.push_back(inside ? 15.0 + 5.0 * noise(generator) : 0.0);
    series.voidage.push_back(voidage);
    series.liquid_velocity_z.push_back(liquid * (1.0 + 0.1 * noise(generator)));
    series.reynolds.push_back(998.2 * 0.006 * voidage * (v + liquid) / 1e-3);
    series.contact_force.push_back(force);
    series.contact_force_mean_x.push_back(0.0);
    series.contact_force_mean_y.push_back(0.0);
    series.contact_force_mean_z.push_back(0.7 * force);
    series.drag_force_z.push_back(inside ? 0.2 * weight : weight);
    series.pressure_force_z.push_back(0.15 * weight);
    series.contacts.push_back(force > 0.0 ? 1.0 : 0.0);
    series.cumulative_contacts.push_back(contacts);
  }
  if (z <= 0.0031) series.bottom_time = series.time.back();
  return series;
}

/// A few spheres on a lattice about the axis and the dropped one among them.
inline Snapshot snapshot(const std::string& moment, double foreign_height) {
  Snapshot snapshot{moment, 4.0, 27, {}, {}, {}, {}};
  for (int i = 0; i < 27; ++i) {
    snapshot.x.push_back(0.006 * (i % 3 - 1));
    snapshot.y.push_back(0.006 * (i / 3 % 3 - 1));
    snapshot.z.push_back(foreign_height + 0.006 * (i / 9 + 1));
    snapshot.radius.push_back(0.0025);
  }
  snapshot.x.push_back(0.0);
  snapshot.y.push_back(0.0);
  snapshot.z.push_back(foreign_height);
  snapshot.radius.push_back(0.003);
  return snapshot;
}

inline FinishedRun run(const std::string& system, double superficial_velocity, const std::string& variant,
                       unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  FinishedRun run;
  run.spec = {system, superficial_velocity, variant, "6in5W.toml", {}};
  run.scene = scene(superficial_velocity);
  RunResult& result = run.result;
  result.name = "synthetic" + std::to_string(seed);
  result.scene_text = "title = \"synthetic\"\n";
  result.suite_version = "0.1.0";
  result.machine = "no machine: made-up numbers <&>";
  result.date = "2024-01-01T00:00:00Z";
  result.threads = 1;
  result.wall_seconds = 123.0;
  result.cpu_seconds = 120.0;
  result.packed_voidage = 0.41;
  result.packed_height = 0.203;
  const double voidage = bed_voidage(superficial_velocity) + (variant.empty() ? 0.0 : 0.03);
  const double height = 0.12 / (1.0 - voidage);
  for (int step = 0; step <= 1200; ++step) {
    const double time = 0.01 * step;
    const double swelling = 1.0 - std::exp(-time);
    result.bed.time.push_back(time);
    result.bed.pressure_drop.push_back(1450.0 + 30.0 * noise(generator));
    result.bed.centre_of_mass_height.push_back(0.5 * (0.203 + (height - 0.203) * swelling));
    result.bed.bed_top.push_back(0.203 + (height - 0.203) * swelling);
    result.bed.fluctuating_energy.push_back(2e-3 * (1.0 + 0.1 * noise(generator)));
    result.bed.contacts_per_particle.push_back(1.5 + 0.1 * noise(generator));
    result.bed.local_fluctuating_energy.push_back(1e-3);
    result.bed.cumulative_contacts.push_back(1.0);
    result.bed.contact_force_bed.push_back(1e-3);
    result.bed.contact_force_foreign.push_back(0.0);
    result.bed.contact_force_wall.push_back(1e-3);
    result.bed.network_step.push_back(0.5);
    for (auto* force : {&result.bed.pressure_force, &result.bed.buoyant_weight, &result.bed.bottom_force,
                        &result.bed.wall_force, &result.bed.shear_force, &result.bed.flow_force,
                        &result.bed.sphere_inertia, &result.bed.liquid_inertia, &result.bed.balance_residual})
      force->push_back(0.0);
    result.bed.maximum_overlap.push_back(0.01);
    result.bed.foreign_present.push_back(time > 4.0 ? 1.0 : 0.0);
  }
  for (int index = 0; index < 3; ++index) {
    const double speed = (1.7 * superficial_velocity + 0.03) * (1.0 + 0.08 * noise(generator));
    result.drops.push_back(drop(superficial_velocity, 4.0 + 2.5 * index, height, speed, generator));
  }
  result.simulated_seconds = 12.0;
  PlaneField& plane = result.plane;
  plane.time = 4.0;
  for (int ix = 0; ix < 8; ++ix) plane.x.push_back(-0.025 + 0.00625 * (ix + 0.5));
  for (int iz = 0; iz < 160; ++iz) plane.z.push_back(0.00625 * (iz + 0.5));
  for (const double z : plane.z)
    for (const double x : plane.x) {
      const double local = z < height ? voidage + 0.06 * std::sin(60 * z + 90 * x) + 0.02 * noise(generator) : 1.0;
      plane.voidage.push_back(std::clamp(local, 0.36, 1.0));
      plane.velocity_x.push_back(0.02 * std::sin(50 * z + 40 * x));
      plane.velocity_z.push_back(superficial_velocity / local);
    }
  LiquidFluctuation& fluctuation = result.fluctuation;
  for (int step = 0; step < 200; ++step) {
    fluctuation.time.push_back(2.0 + 0.01 * step);
    for (auto* series :
         {&fluctuation.series_x, &fluctuation.series_y, &fluctuation.series_z, &fluctuation.series_vector})
      series->push_back(0.03 + 0.003 * noise(generator));
  }
  for (const auto& [moment, share] : {std::pair{"release", 3.0}, {"enters", 1.0}, {"halfway", 0.5}, {"ends", 0.015}})
    result.snapshots.push_back(snapshot(moment, share * height));
  return run;
}

inline Profile profile() {
  Profile profile;
  profile.name = "synthetic";
  profile.differences = {"Every number of a simulation on this page is made up: this is a test of the drawing.",
                         "Contact stiffness 1e3 N/m instead of 1e4 N/m."};
  for (const double velocity : {0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.10, 0.11, 0.12, 0.16, 0.18, 0.20, 0.24}) {
    profile.runs.push_back({"6in5W", velocity, "", "6in5W.toml", {}});
    if (velocity == 0.06 || velocity == 0.10)
      profile.runs.push_back({"6in5W", velocity, "di-felice-1994", "6in5W.toml", {}});
  }
  // Velocities whose made-up voidages are near those of the paper's Fig. 15.
  for (const char* system : {"6in3W", "6in4W", "5in5W", "4in5W", "3in5W", "6in3N", "6in5N"})
    for (const double velocity : {0.06, 0.15, 0.24}) profile.runs.push_back({system, velocity, "", "6in5W.toml", {}});
  return profile;
}

/// The profile asks for runs at this velocity, and none exists.
inline constexpr double absent_velocity = 0.05;

inline std::vector<FinishedRun> runs(const Profile& profile) {
  std::vector<FinishedRun> finished;
  unsigned seed = 1;
  for (const auto& spec : profile.runs)
    if (spec.superficial_velocity != absent_velocity)
      finished.push_back(run(spec.system, spec.superficial_velocity, spec.variant, seed++));
  return finished;
}

}  // namespace slfb::synthetic
