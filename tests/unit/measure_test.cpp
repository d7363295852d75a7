#include "experiments/runs/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "correlations/materials.hpp"
#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/work.hpp"

namespace slfb {
namespace {

Measurements measured_in(const std::vector<FinishedRun>& runs) {
  return slfb::measure_runs(runs, peng_2014_work().measuring);
}
bool needs_run(const MeasureKey& measure) { return slfb::needs_run(peng_2014_work(), measure); }

/// The key of this text.
MeasureKey key(std::string_view text) { return parse_measure_key(text); }

constexpr double column_diameter = 0.05;
constexpr int bed_count = 3600;

/// Height of a bed of that voidage [m].
double bed_height(double voidage) {
  const double volume = bed_count * std::numbers::pi / 6.0 * std::pow(0.005, 3);
  return volume / ((1.0 - voidage) * std::numbers::pi / 4.0 * column_diameter * column_diameter);
}

/// A run of exactly known answers: constant bed, drops that fall at constant speeds.
FinishedRun made_up_run(double velocity, const std::string& name, double voidage, double pressure,
                        const std::vector<double>& settling_speeds, double release_height = 0.5) {
  FinishedRun run;
  run.spec.system = "6in5W";
  run.spec.superficial_velocity = velocity;
  run.scene.geometry.diameter = column_diameter;
  run.scene.geometry.height = 1.0;
  run.scene.liquid = {998.2, 1e-3, velocity};
  run.scene.species = {{"glass", 0.005, 2230.0, bed_count}, {"steel", 0.006, 7800.0, 0}};
  run.result.name = name;
  run.result.wall_seconds = 100.0;
  run.result.simulated_seconds = 20.0;
  run.result.packed_voidage = 0.4;
  run.result.packed_height = 0.2;
  const double height = bed_height(voidage);
  BedSeries& bed = run.result.bed;
  for (int i = 0; i < 400; ++i) {
    const bool dropped = i >= 300;
    bed.time.push_back(0.01 * i);
    bed.pressure_drop.push_back(dropped ? 9999.0 : pressure);
    bed.centre_of_mass_height.push_back(0.5 * height);
    bed.bed_top.push_back(height - 0.0025);
    bed.fluctuating_energy.push_back(4e-4);
    bed.contacts_per_particle.push_back(1.0);
    bed.local_fluctuating_energy.push_back(1e-3);
    bed.cumulative_contacts.push_back(1.0);
    bed.contact_force_bed.push_back(1e-3);
    bed.contact_force_foreign.push_back(0.0);
    bed.contact_force_wall.push_back(1e-3);
    bed.network_step.push_back(0.5);
    for (auto* force : {&bed.pressure_force, &bed.buoyant_weight, &bed.bottom_force, &bed.wall_force, &bed.shear_force,
                        &bed.flow_force, &bed.sphere_inertia, &bed.liquid_inertia, &bed.balance_residual})
      force->push_back(0.0);
    bed.maximum_overlap.push_back(0.01);
    bed.foreign_present.push_back(dropped ? 1.0 : 0.0);
  }
  const double weight = std::numbers::pi / 6.0 * std::pow(0.006, 3) * 7800.0 * gravitational_acceleration;
  for (const double speed : settling_speeds) {
    DropSeries drop;
    drop.release_time = 3.0;
    drop.species = "steel";
    double contacts = 0.0;
    for (int step = 0;; ++step) {
      const double z = release_height - speed * 1e-3 * step;
      if (z < 0.003) {
        drop.bottom_time = 1e-3 * step;
        break;
      }
      contacts += 0.1;
      drop.time.push_back(1e-3 * step);
      drop.z.push_back(z);
      drop.cumulative_contacts.push_back(contacts);
      for (auto* zero : {&drop.x, &drop.y, &drop.velocity_x, &drop.velocity_y, &drop.angular_speed,
                         &drop.contact_force_mean_x, &drop.contact_force_mean_y}) {
        zero->push_back(0.0);
      }
      drop.velocity_z.push_back(-speed);
      drop.voidage.push_back(voidage);
      drop.liquid_velocity_z.push_back(velocity);
      drop.reynolds.push_back(1000.0);
      drop.contact_force.push_back(0.5 * weight);
      drop.contact_force_mean_z.push_back(0.25 * weight);
      drop.drag_force_z.push_back(0.25 * weight);
      drop.pressure_force_z.push_back(0.2 * weight);
      drop.contacts.push_back(1.0);
    }
    run.result.drops.push_back(drop);
  }
  return run;
}

TEST(RunKey, HasTwoDecimalsAndAnOptionalVariant) {
  RunSpec spec;
  spec.system = "6in3N";
  spec.superficial_velocity = 0.04;
  EXPECT_EQ(run_key(spec), "6in3N/0.04");
  spec.variant = "paper-literal";
  EXPECT_EQ(run_key(spec), "6in3N/0.04/paper-literal");
  // Velocities between the hundredths are runs of their own.
  spec.superficial_velocity = 0.045;
  EXPECT_EQ(run_key(spec), "6in3N/0.045/paper-literal");
}

TEST(MeasureKey, TellsRunsFromLaws) {
  EXPECT_TRUE(needs_run(key("pressure_drop/6in5W/0.06")));
  EXPECT_TRUE(needs_run(key("pressure_drop/6in5W/*")));
  EXPECT_TRUE(needs_run(key("pressure_plateau/6in5W")));
  EXPECT_TRUE(needs_run(key("equation_40_share_within_10_percent/all")));
  EXPECT_FALSE(needs_run(key("homogeneous_voidage/wen-yu-1966/0.06")));
  EXPECT_FALSE(needs_run(key("terminal_velocity/steel-6mm-water")));
}

TEST(MeasureRuns, WithoutRunsThereIsNothing) { EXPECT_TRUE(measured_in({}).empty()); }

// Of a bed that was taken down from a higher velocity only the time after the change is measured.
TEST(MeasureRuns, LeaveOutEarlierVelocitiesOfTheLiquid) {
  FinishedRun run = made_up_run(0.06, "a", 0.46, 1450.0, {0.09, 0.10, 0.11});
  BedSeries& bed = run.result.bed;
  for (std::size_t k = 0; k < bed.time.size(); ++k) {
    const bool early = bed.time[k] < 1.0;
    bed.superficial_velocity.push_back(early ? 0.2 : 0.06);
    if (early) bed.pressure_drop[k] = 1e4;
  }
  EXPECT_NEAR(measured_in({run}).at(measure_key("pressure_drop", "6in5W", 0.06)).value, 1450.0, 1e-9);
}

TEST(MeasureRuns, NumbersOfAKnownRun) {
  const auto measured = measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.09, 0.10, 0.11})});
  const auto at = [&](const std::string& quantity) { return measured.at(measure_key(quantity, "6in5W", 0.06)); };
  EXPECT_NEAR(at("voidage_centre_of_mass").value, 0.46, 1e-12);
  EXPECT_NEAR(at("voidage_bed_top").value, 0.46, 1e-12);
  EXPECT_NEAR(at("pressure_drop").value, 1450.0, 1e-9) << "only the bed before the drop counts";
  EXPECT_DOUBLE_EQ(at("pressure_drop").half_width, 0.0);
  EXPECT_EQ(at("pressure_drop").unit, "Pa");
  EXPECT_EQ(at("pressure_drop").origin, "a");
  EXPECT_NEAR(at("classification_velocity").value, 0.10, 1e-9);
  EXPECT_NEAR(at("classification_velocity").half_width, 4.302653 * 0.01 / std::sqrt(3.0), 1e-6);
  EXPECT_EQ(at("classification_velocity").samples, 3u);
  EXPECT_NEAR(at("collision_force_ratio").value, 0.5, 1e-12);
  EXPECT_NEAR(at("collision_force_ratio_of_mean").value, 0.25, 1e-12);
  EXPECT_NEAR(at("collision_to_drag_ratio").value, 2.0, 1e-12);
  EXPECT_NEAR(at("equation_40_deviation").value, 0.5 / (1.08 + 0.26 * 0.46 - 1.34 * 0.46 * 0.46) - 1.0, 1e-12);
  EXPECT_NEAR(at("collision_frequency").value, 100.0, 1e-6);
  EXPECT_NEAR(at("dimensionless_collision_frequency").value, 100.0 * 0.005 / 0.02, 1e-6);
  // f* over Eqs. 6 and 7 at α_S = 0.54.
  const double kinetic =
      24.0 * std::sqrt(2.0 / (3.0 * std::numbers::pi)) * 0.54 * std::pow(1.0 - 0.54 / 0.575, -2.5 * 0.575);
  EXPECT_NEAR(at("ktgf_ratio").value, 25.0 / kinetic, 1e-6);
  EXPECT_NEAR(at("stokes_number").value, 2230.0 * 0.02 * 0.005 / (9.0 * 1e-3), 1e-9);
  EXPECT_NEAR(at("bottom_fraction").value, 1.0, 1e-12);
  EXPECT_NEAR(at("falling_after_15_s").value, 0.0, 1e-12);
  EXPECT_NEAR(at("wall_seconds_per_simulated_second").value, 5.0, 1e-12);
}

// z = 0.997 − V (t − 20) on the paper's clock. Drops from another height reach the bottom at another time, and may
// stand under the same key: they say nothing of times.
TEST(MeasureRuns, TimesSinceTheReleaseAreThoseOfThePapersHeight) {
  const auto low = made_up_run(0.06, "low", 0.46, 1450.0, {0.09, 0.11});
  EXPECT_FALSE(measured_in({low}).contains(key("time_to_bottom/6in5W/0.06")));
  const auto measured = measured_in({low, made_up_run(0.06, "high", 0.46, 1450.0, {0.08, 0.10}, 0.997)});
  EXPECT_NEAR(measured.at(key("classification_intercept/6in5W/0.06")).value, 0.997 + 20.0 * 0.09, 1e-6);
  EXPECT_NEAR(measured.at(key("time_to_bottom/6in5W/0.06")).value, 0.5 * (0.994 / 0.08 + 0.994 / 0.10), 2e-3);
  EXPECT_NEAR(measured.at(key("classification_velocity/6in5W/0.06")).value, 0.095, 1e-9);
}

TEST(MeasureRuns, ADropThatIsCutShortSaysNothingAboutLaterTimes) {
  FinishedRun run = made_up_run(0.05, "a", 0.43, 1450.0, {0.05});
  DropSeries& drop = run.result.drops.front();
  drop.bottom_time = -1.0;  // followed for about 10 s
  const auto measured = measured_in({run});
  EXPECT_FALSE(measured.contains(key("falling_after_15_s/6in5W/0.05")));
  EXPECT_DOUBLE_EQ(measured.at(key("bottom_fraction/6in5W/0.05")).value, 0.0);
  EXPECT_FALSE(measured.contains(key("time_to_bottom/6in5W/0.05")));
}

// Two spheres that are not at the bottom after 15 s: one sinks at 5 mm/s, the other has come to rest on the bed.
TEST(MeasureRuns, ASphereThatRestsDoesNotFall) {
  FinishedRun run = made_up_run(0.05, "a", 0.43, 1450.0, {0.005});
  DropSeries& drop = run.result.drops.front();
  ASSERT_GT(drop.time.back(), 15.0);
  drop.bottom_time = -1.0;
  EXPECT_DOUBLE_EQ(measured_in({run}).at(key("falling_after_15_s/6in5W/0.05")).value, 1.0);
  for (double& z : drop.z) z = std::max(z, 0.215);
  const auto resting = measured_in({run});
  EXPECT_DOUBLE_EQ(resting.at(key("falling_after_15_s/6in5W/0.05")).value, 0.0);
  EXPECT_DOUBLE_EQ(resting.at(key("bottom_fraction/6in5W/0.05")).value, 0.0);
}

TEST(MeasureRuns, ASingleDropHasNoInterval) {
  const auto measured = measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.10})});
  EXPECT_TRUE(std::isnan(measured.at(key("classification_velocity/6in5W/0.06")).half_width));
}

TEST(MeasureRuns, RunsOfOneKeyAreReplicates) {
  const auto measured =
      measured_in({made_up_run(0.06, "a", 0.46, 1440.0, {0.10}), made_up_run(0.06, "b", 0.46, 1460.0, {0.12})});
  EXPECT_NEAR(measured.at(key("pressure_drop/6in5W/0.06")).value, 1450.0, 1e-9);
  EXPECT_GT(measured.at(key("pressure_drop/6in5W/0.06")).half_width, 0.0);
  EXPECT_EQ(measured.at(key("classification_velocity/6in5W/0.06")).samples, 2u);
}

// What a published run lost by thinning stands in its summary: its numbers are those of the whole series.
TEST(MeasureRuns, ASummaryStandsForItsSeries) {
  FinishedRun thinned = made_up_run(0.06, "a", 0.46, 1440.0, {0.10, 0.12});
  const auto whole = measured_in({thinned});
  thinned.summary = summarise(thinned.spec.system, thinned.scene, thinned.result, peng_2014_work().measuring);
  thinned.result.bed = {};
  thinned.result.drops.clear();
  const auto measured = measured_in({thinned});
  ASSERT_EQ(measured.size(), whole.size());
  for (const auto& [name, measurement] : whole) {
    EXPECT_EQ(measured.at(name).value, measurement.value) << to_string(name);
    EXPECT_EQ(measured.at(name).samples, measurement.samples) << to_string(name);
  }
}

// A settled bed is one sample, however often runs begin with it.
TEST(MeasureRuns, OnePackingTwiceIsOneSample) {
  FinishedRun a = made_up_run(0.06, "a", 0.46, 1450.0, {0.10}), b = made_up_run(0.06, "b", 0.46, 1450.0, {0.12});
  EXPECT_TRUE(std::isnan(measured_in({a, b}).at(key("packed_voidage/6in5W/0.06")).half_width));
  b.scene.seed = 2;
  b.result.packed_voidage = 0.41;
  const Measurement two = measured_in({a, b}).at(key("packed_voidage/6in5W/0.06"));
  EXPECT_EQ(two.samples, 2U);
  EXPECT_NEAR(two.value, 0.405, 1e-12);
  EXPECT_GT(two.half_width, 0.0);
  // Below fluidisation the pressure drop is of the packing too.
  EXPECT_TRUE(std::isnan(
      measured_in({made_up_run(0.03, "c", 0.40, 876.0, {})}).at(key("pressure_drop/6in5W/0.03")).half_width));
}

// Quick runs without rolling friction are no samples of a bed that has it.
TEST(MeasureRuns, RunsOfAnotherModelAreLeftOut) {
  FinishedRun a = made_up_run(0.06, "a", 0.46, 1450.0, {0.10, 0.11}), b = made_up_run(0.06, "b", 0.46, 1450.0, {0.3});
  a.spec.scene = b.spec.scene = peng_2014_work().folders.experiments / "scenes" / "6in5W.toml";
  a.scene.contact.rolling_friction = 0.0175;
  b.scene.contact.rolling_friction = 0.0;
  for (const auto& runs : {std::vector{a, b}, std::vector{b, a}}) {
    const Measurement measured = measured_in(runs).at(key("classification_velocity/6in5W/0.06"));
    EXPECT_EQ(measured.samples, 2U);
    EXPECT_NEAR(measured.value, 0.105, 1e-9);
  }
  // Another seed, another length, other springs are no other model.
  b.scene.contact.rolling_friction = 0.0175;
  b.scene.seed = 7;
  b.scene.contact.stiffness = 1e3;
  b.scene.geometry.height = 0.6;
  EXPECT_NEAR(measured_in({a, b}).at(key("classification_velocity/6in5W/0.06")).value, 0.5 * (0.105 + 0.3), 1e-9);
}

// A bed that still expands is not measured where a steady one is, and has no interval where none is.
TEST(MeasureRuns, ABedThatStillExpandsIsLeftOut) {
  const FinishedRun steady = made_up_run(0.06, "a", 0.46, 1450.0, {0.10, 0.11});
  FinishedRun expanding = made_up_run(0.06, "b", 0.46, 1400.0, {0.30, 0.31});
  for (std::size_t k = 0; k < expanding.result.bed.time.size(); ++k)
    expanding.result.bed.centre_of_mass_height[k] *= 1.0 + 1e-3 * static_cast<double>(k);
  const auto measured = measured_in({steady, expanding});
  EXPECT_NEAR(measured.at(key("pressure_drop/6in5W/0.06")).value, 1450.0, 1e-9);
  EXPECT_NEAR(measured.at(key("classification_velocity/6in5W/0.06")).value, 0.105, 1e-9);
  const auto alone = measured_in({expanding});
  EXPECT_TRUE(std::isnan(alone.at(key("voidage_centre_of_mass/6in5W/0.06")).half_width));
  EXPECT_FALSE(alone.at(key("voidage_centre_of_mass/6in5W/0.06")).steady);
  EXPECT_NE(alone.at(key("voidage_centre_of_mass/6in5W/0.06")).remark.find("not steady"), std::string::npos);
}

// Five drops of which none arrives within the time: they need longer than that.
TEST(MeasureRuns, DropsThatDoNotArriveAreEvidence) {
  FinishedRun run = made_up_run(0.06, "a", 0.46, 1450.0, std::vector<double>(5, 0.05), 0.997);
  for (DropSeries& drop : run.result.drops) {
    drop.bottom_time = -1.0;
    for (double& z : drop.z) z = std::max(z, 0.15);
  }
  const auto measured = measured_in({run});
  const Measurement& time = measured.at(key("time_to_bottom/6in5W/0.06"));
  EXPECT_NEAR(time.lower(), run.result.drops.front().time.back(), 1e-9);
  EXPECT_EQ(time.upper(), std::numeric_limits<double>::infinity());
  EXPECT_NE(time.remark.find("5 of 5"), std::string::npos);
  // 0.1 m in the time since they came into the bed.
  EXPECT_LT(measured.at(key("classification_velocity/6in5W/0.06")).upper(), 0.1);
  EXPECT_EQ(measured.at(key("classification_velocity/6in5W/0.06")).lower(), -std::numeric_limits<double>::infinity());
}

TEST(MeasureRuns, SharesAndCountsStayWithinTheirBounds) {
  FinishedRun run = made_up_run(0.06, "a", 0.46, 1450.0, {0.10, 0.11, 0.12});
  for (double& contacts : run.result.drops.front().contacts) contacts = 9.0;
  const auto measured = measured_in({run});
  const Measurement& arrived = measured.at(key("bottom_fraction/6in5W/0.06"));
  EXPECT_EQ(arrived.value, 1.0);
  EXPECT_NEAR(arrived.lower(), 0.2924, 1e-4) << "three of three (Clopper and Pearson 1934)";
  EXPECT_EQ(arrived.upper(), 1.0);
  const Measurement& contacts = measured.at(key("mean_contacts/6in5W/0.06"));
  EXPECT_LT(contacts.value - contacts.half_width, 0.0);
  EXPECT_EQ(contacts.lower(), 0.0);
}

// A line z = 0.997 − V t passes 0.15 m after (0.997 − 0.15)/V.
TEST(MeasureRuns, TimeFromTheReleaseToTheWindow) {
  const auto measured = measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.10, 0.10}, 0.997)});
  EXPECT_NEAR(measured.at(key("time_to_window/6in5W/0.06")).value, 8.47, 1e-6);
  EXPECT_NEAR(measured.at(key("line_residual/6in5W/0.06")).value, 0.0, 1e-4);
}

// Later drops fall into the crater of the first.
TEST(MeasureRuns, OneDropACrater) {
  FinishedRun run = made_up_run(0.03, "a", 0.40, 876.0, {0.5, 0.5});
  for (DropSeries& drop : run.result.drops) {
    drop.bottom_time = -1.0;
    const double rest = &drop == run.result.drops.data() ? 0.200 : 0.190;
    double contacts = 0.0;
    for (std::size_t k = 0; k < drop.z.size(); ++k) {
      if (drop.z[k] < 0.203) contacts = 1.0;
      drop.cumulative_contacts[k] = contacts;
      drop.z[k] = std::max(drop.z[k], rest);
    }
    const double last = drop.time.back();
    for (int k = 1; k <= 1500; ++k) {
      drop.time.push_back(last + 1e-3 * k);
      for (auto* column :
           {&drop.x, &drop.y, &drop.z, &drop.velocity_x, &drop.velocity_y, &drop.velocity_z, &drop.angular_speed,
            &drop.voidage, &drop.liquid_velocity_z, &drop.reynolds, &drop.contact_force, &drop.contact_force_mean_x,
            &drop.contact_force_mean_y, &drop.contact_force_mean_z, &drop.drag_force_z, &drop.pressure_force_z,
            &drop.contacts, &drop.cumulative_contacts})
        column->push_back(column->back());
    }
  }
  const Measurement sinking = measured_in({run}).at(key("sinking/6in5W/0.03"));
  EXPECT_EQ(sinking.samples, 1U);
  EXPECT_NEAR(sinking.value, 0.003, 0.3e-3);
}

// At the voidage of Eq. 36: the force 0.5 of the made-up runs over Eq. 40 there, whatever the bed's own voidage.
TEST(MeasureRuns, AlsoAtTheVoidageOfEquation36) {
  const auto one = measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.10})}),
             other = measured_in({made_up_run(0.06, "a", 0.52, 1450.0, {0.10})});
  const MeasureKey as_printed = key("equation_40_deviation_at_printed_voidage/6in5W/0.06");
  EXPECT_EQ(one.at(as_printed).value, other.at(as_printed).value);
  EXPECT_NEAR(one.at(as_printed).value, 0.5 / (1.08 + 0.26 * 0.457 - 1.34 * 0.457 * 0.457) - 1.0, 2e-3);
  // Eq. 36 has 0.457 at 0.06 m/s.
  EXPECT_TRUE(other.contains(key("drag_ratio_at_printed_voidage/6in5W/0.46")));
  EXPECT_FALSE(other.contains(key("drag_ratio_at_voidage/6in5W/0.46")));
}

TEST(MeasureRuns, TheSameRunFromTwoPlacesCountsOnce) {
  const FinishedRun here = made_up_run(0.06, "a", 0.46, 1450.0, {0.10});
  FinishedRun published = here;
  published.published = true;
  EXPECT_EQ(measured_in({here, published}).at(key("classification_velocity/6in5W/0.06")).samples, 1u);
}

TEST(MeasureRuns, AStaleRunCountsOnlyAlone) {
  FinishedRun stale = made_up_run(0.06, "old", 0.50, 1400.0, {0.20});
  stale.stale = true;
  const FinishedRun current = made_up_run(0.06, "new", 0.46, 1450.0, {0.10});
  EXPECT_NEAR(measured_in({stale, current}).at(key("pressure_drop/6in5W/0.06")).value, 1450.0, 1e-9);
  EXPECT_NEAR(measured_in({stale}).at(key("pressure_drop/6in5W/0.06")).value, 1400.0, 1e-9);
}

TEST(MeasureRuns, VariantsStandApart) {
  FinishedRun variant = made_up_run(0.06, "v", 0.50, 1400.0, {0.20});
  variant.spec.variant = "di-felice-1994";
  const auto measured = measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.10}), variant});
  EXPECT_NEAR(measured.at(key("voidage_centre_of_mass/6in5W/0.06")).value, 0.46, 1e-12);
  EXPECT_NEAR(measured.at(key("voidage_centre_of_mass/6in5W/0.06/di-felice-1994")).value, 0.50, 1e-12);
}

TEST(MeasureRuns, QuantitiesAtAVoidageLieOnALineBetweenTheRuns) {
  // Both runs have 100 collisions a second and a drag that does not depend on the voidage: so has the line.
  const auto flat = measured_in(
      {made_up_run(0.06, "a", 0.44, 1450.0, {0.10, 0.11}), made_up_run(0.07, "b", 0.48, 1450.0, {0.10, 0.12})});
  EXPECT_NEAR(flat.at(key("collision_frequency_at_voidage/6in5W/0.46")).value, 100.0, 1e-6);
  EXPECT_FALSE(flat.contains(key("collision_frequency_at_voidage/6in5W/0.58"))) << "no run is near";
  // A single run stands for a voidage that it misses by less than 0.01, and for no other.
  const auto single = measured_in({made_up_run(0.06, "a", 0.455, 1450.0, {0.10, 0.11})});
  EXPECT_TRUE(single.contains(key("drag_ratio_at_voidage/6in5W/0.46")));
  EXPECT_FALSE(single.contains(key("drag_ratio_at_voidage/6in5W/0.52")));
}

TEST(MeasureRuns, QuantitiesAtAVoidageInterpolate) {
  FinishedRun low = made_up_run(0.06, "a", 0.44, 1450.0, {0.10}), high = made_up_run(0.07, "b", 0.50, 1450.0, {0.10});
  for (double& contacts : low.result.drops.front().contacts) contacts = 1.0;
  for (double& contacts : high.result.drops.front().contacts) contacts = 4.0;
  // A third of the way from 0.44 to 0.50.
  EXPECT_NEAR(measured_in({low, high}).at(key("mean_contacts_at_voidage/6in5W/0.46")).value, 2.0, 1e-9);
}

TEST(MeasureRuns, ShareOfRunsWithinTenPercentOfEquation40) {
  // Force over weight 0.5 in every made-up run; Eq. 40 gives 0.500 at 0.763 and 0.916 at 0.46.
  const auto measured =
      measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.10}), made_up_run(0.20, "b", 0.763, 1450.0, {0.10}),
                   made_up_run(0.21, "c", 0.760, 1450.0, {0.10})});
  EXPECT_NEAR(measured.at(key("equation_40_share_within_10_percent/all")).value, 2.0 / 3.0, 1e-12);
  EXPECT_GT(measured.at(key("equation_40_share_within_10_percent/all")).half_width, 0.3) << "three runs say little";
}

TEST(MeasureRuns, MinimumFluidisationIsTheCrossingOfTheTwoLines) {
  const auto line = [](double velocity) { return 51750.0 * velocity - 676.42; };
  const auto measured =
      measured_in({made_up_run(0.03, "a", 0.40, line(0.03), {}), made_up_run(0.04, "b", 0.40, line(0.04), {}),
                   made_up_run(0.06, "c", 0.46, 1500.0, {}), made_up_run(0.10, "d", 0.56, 1540.0, {})});
  EXPECT_NEAR(measured.at(key("packed_line_slope/6in5W")).value, 51750.0, 1e-6);
  EXPECT_NEAR(measured.at(key("packed_line_intercept/6in5W")).value, -676.42, 1e-6);
  EXPECT_NEAR(measured.at(key("pressure_plateau/6in5W")).value, 1520.0, 1e-9);
  EXPECT_NEAR(measured.at(key("minimum_fluidisation_velocity/6in5W")).value, 0.042443, 1e-6);
}

TEST(MeasureRuns, EarlyRiseOfTable2) {
  const auto measured = measured_in({made_up_run(0.06, "a", 0.46, 1450.0, {0.097, 0.097}),
                                     made_up_run(0.09, "b", 0.54, 1450.0, {0.229, 0.229}),
                                     made_up_run(0.24, "c", 0.79, 1450.0, {0.422, 0.422})});
  // (0.132/0.03) / (0.193/0.15), to the accuracy of the sampled lines.
  EXPECT_NEAR(measured.at(key("classification_velocity_rise_ratio/6in5W")).value, 3.4197, 1e-3);
}

TEST(MeasureLaws, HandComputedNumbers) {
  const auto laws = measure_laws();
  EXPECT_NEAR(laws.at(key("minimum_fluidisation_velocity/equation-36")).value, 0.0423, 0.00005);
  EXPECT_NEAR(laws.at(key("buoyancy_ratio/steel-water")).value, 998.2 / 7800.0, 1e-12);
  EXPECT_NEAR(laws.at(key("particle_count/3mm")).value, 16668.8, 0.1);
  EXPECT_NEAR(laws.at(key("packed_pressure/ergun-1952/0.03")).value, 792.0, 1.0);
  EXPECT_NEAR(laws.at(key("collision_force/van-der-wielen-1996-force/0.06")).value, 0.4655, 1e-4);
  EXPECT_NEAR(laws.at(key("dimensionless_collision_frequency/simonin-1991/0.42")).value, 30.57, 0.01);
  EXPECT_NEAR(laws.at(key("steps_per_contact/glass-5mm-glass-5mm")).value, 5.37, 0.01);
  for (const auto& [name, measurement] : laws) {
    EXPECT_TRUE(std::isfinite(measurement.value)) << to_string(name);
    EXPECT_FALSE(measurement.unit.empty()) << to_string(name);
    EXPECT_FALSE(needs_run(name)) << to_string(name);
  }
}

// The report and `slfb list quantities` describe each number that a work has, in its unit.
TEST(Quantities, EveryNumberOfLawsAndProbesHasOne) {
  for (const auto& [measure, measurement] : measure_without_runs()) {
    const Quantity* quantity = find_quantity(peng_2014_work().measuring, measure.quantity);
    ASSERT_NE(quantity, nullptr) << to_string(measure);
    EXPECT_EQ(quantity->unit, measurement.unit) << to_string(measure);
  }
}

TEST(Quantities, AreDefinedOnce) {
  std::set<std::string> ids;
  for (const Quantity& quantity : peng_2014_work().measuring.quantities) {
    EXPECT_TRUE(ids.insert(quantity.id).second) << quantity.id;
    EXPECT_FALSE(quantity.unit.empty()) << quantity.id;
    EXPECT_FALSE(quantity.title.empty()) << quantity.id;
    EXPECT_TRUE(quantity.definition.ends_with('.')) << quantity.id;
  }
}

// Contacts are taken from runs with the scene's own springs, all those of a system or none: one velocity of another
// kind would make a step in a trend. What does not hang on the springs, variants and other systems stay as they are.
TEST(OwnSprings, CountTheContactsOfAWholeSystem) {
  const auto of = [](double value) { return Measurement{value, 1.0, 3, "1/s", "run"}; };
  const Measurements soft{{key("collision_frequency/6in5W/0.06"), of(10)},
                          {key("collision_frequency/6in5W/0.08"), of(20)},
                          {key("collision_frequency/6in5W/0.10"), of(30)},
                          {key("collision_frequency/6in5W/0.10/di-felice-1994"), of(31)},
                          {key("collision_frequency_at_voidage/6in5W/0.46"), of(11)},
                          {key("collision_frequency/6in3W/0.10"), of(70)},
                          {key("classification_velocity/6in5W/0.10"), of(0.2)}};
  Measurements stiff{{key("collision_frequency/6in5W/0.06"), of(15)},
                     {key("classification_velocity/6in5W/0.06"), of(0.1)}};
  Measurements taken = soft;
  take_contacts_from(stiff, peng_2014_work().measuring, taken);
  EXPECT_EQ(taken.at(key("collision_frequency/6in5W/0.06")).value, 10) << "one velocity is not enough";
  EXPECT_FALSE(taken.contains(key("classification_velocity/6in5W/0.06")));

  stiff[key("collision_frequency/6in5W/0.10")] = of(45);
  take_contacts_from(stiff, peng_2014_work().measuring, taken);
  EXPECT_EQ(taken.at(key("collision_frequency/6in5W/0.06")).value, 15);
  EXPECT_EQ(taken.at(key("collision_frequency/6in5W/0.10")).value, 45);
  EXPECT_FALSE(taken.contains(key("collision_frequency/6in5W/0.08"))) << "of the soft kind";
  EXPECT_FALSE(taken.contains(key("collision_frequency_at_voidage/6in5W/0.46"))) << "of the soft kind";
  EXPECT_EQ(taken.at(key("collision_frequency/6in5W/0.10/di-felice-1994")).value, 31);
  EXPECT_EQ(taken.at(key("collision_frequency/6in3W/0.10")).value, 70);
  EXPECT_EQ(taken.at(key("collision_frequency/6in3W/0.10")).springs, Springs::softened);
  EXPECT_EQ(taken.at(key("collision_frequency/6in5W/0.10")).springs, Springs::own);
  EXPECT_EQ(taken.at(key("classification_velocity/6in5W/0.10")).springs, Springs::any);
  EXPECT_EQ(taken.at(key("classification_velocity/6in5W/0.10")).value, 0.2);
}

}  // namespace
}  // namespace slfb
