#include "experiments/quantities/analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "correlations/materials.hpp"
#include "experiments/quantities/quantity.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

/// x_k = φ x_{k−1} + noise around `mean`; stationary from the start; autocorrelation time (1 + φ)/(1 − φ).
std::vector<double> autoregressive(std::size_t size, double phi, double mean, std::mt19937_64& generator) {
  std::normal_distribution<double> noise;
  std::vector<double> values(size);
  double state = noise(generator) / std::sqrt(1.0 - phi * phi);
  for (double& value : values) {
    value = mean + state;
    state = phi * state + noise(generator);
  }
  return values;
}

/// Part of `trials` made-up series whose interval holds the true mean.
double coverage(std::size_t size, double phi, int trials) {
  std::mt19937_64 generator(20140427);
  int covered = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const SeriesEstimate estimate = estimate_mean(autoregressive(size, phi, 3.0, generator));
    covered += std::abs(estimate.mean - 3.0) <= estimate.half_width;
  }
  return static_cast<double>(covered) / trials;
}

TEST(AutocorrelationTime, WhiteNoiseHasOne) {
  std::mt19937_64 generator(1);
  EXPECT_NEAR(integrated_autocorrelation_time(autoregressive(20000, 0.0, 0.0, generator)), 1.0, 0.05);
}

TEST(AutocorrelationTime, MatchesTheAutoregressiveProcess) {
  std::mt19937_64 generator(2);
  for (const double phi : {0.5, 0.8, 0.9}) {
    const double exact = (1.0 + phi) / (1.0 - phi);
    EXPECT_NEAR(integrated_autocorrelation_time(autoregressive(200000, phi, 0.0, generator)), exact, 0.1 * exact);
  }
}

TEST(SeriesMean, IntervalOfWhiteNoiseCoversTheTruthNineteenTimesInTwenty) {
  EXPECT_NEAR(coverage(400, 0.0, 2000), 0.95, 0.015);
}

TEST(SeriesMean, IntervalOfACorrelatedSeriesCoversTheTruthNineteenTimesInTwenty) {
  EXPECT_NEAR(coverage(4000, 0.9, 1000), 0.95, 0.025);
}

TEST(SeriesMean, AnIntervalThatIgnoresCorrelationWouldNotCover) {
  // The same series with its samples taken as independent: the test above would notice.
  std::mt19937_64 generator(3);
  int covered = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto values = autoregressive(4000, 0.9, 3.0, generator);
    const ReplicateEstimate estimate = estimate_replicates(values);
    covered += std::abs(estimate.mean - 3.0) <= estimate.half_width;
  }
  EXPECT_LT(covered, 200);
}

TEST(SeriesMean, ConstantSeriesIsExact) {
  const std::vector<double> values(50, 7.0);
  const SeriesEstimate estimate = estimate_steady_mean(values);
  EXPECT_DOUBLE_EQ(estimate.mean, 7.0);
  EXPECT_DOUBLE_EQ(estimate.half_width, 0.0);
}

TEST(SeriesMean, OneSampleHasNoInterval) {
  EXPECT_TRUE(std::isnan(estimate_mean(std::vector{1.0}).half_width));
  EXPECT_THROW(estimate_mean({}), std::invalid_argument);
}

TEST(Transient, StationarySeriesKeepsNearlyAll) {
  std::mt19937_64 generator(4);
  EXPECT_LT(transient_length(autoregressive(2000, 0.5, 0.0, generator)), 400u);
}

TEST(Transient, StartUpIsCutOffAndTheMeanIsTheSteadyOne) {
  std::mt19937_64 generator(5);
  auto values = autoregressive(2000, 0.5, 10.0, generator);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 100.0 * std::exp(-static_cast<double>(i) / 40.0);
  const SeriesEstimate estimate = estimate_steady_mean(values);
  EXPECT_GT(estimate.discarded, 100u);
  EXPECT_LE(estimate.discarded, 1000u);
  EXPECT_NEAR(estimate.mean, 10.0, 3.0 * estimate.half_width);
  EXPECT_GT(estimate_mean(values).mean, 11.0) << "without the cut the start-up shows";
}

TEST(Replicates, IntervalIsStudentsForThreeSamples) {
  // Mean 2, standard deviation 1, t(0.975, 2) = 4.302653.
  const ReplicateEstimate estimate = estimate_replicates(std::vector{1.0, 2.0, 3.0});
  EXPECT_DOUBLE_EQ(estimate.mean, 2.0);
  EXPECT_DOUBLE_EQ(estimate.standard_deviation, 1.0);
  EXPECT_NEAR(estimate.half_width, 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_TRUE(std::isnan(estimate_replicates(std::vector{1.0}).half_width));
  EXPECT_THROW(estimate_replicates({}), std::invalid_argument);
}

TEST(Line, RecoversAStraightLine) {
  std::vector<double> x, y;
  for (int i = 0; i < 20; ++i) {
    x.push_back(0.1 * i);
    y.push_back(3.0 - 0.25 * 0.1 * i);
  }
  const LineFit fit = fit_line(x, y);
  EXPECT_NEAR(fit.slope, -0.25, 1e-12);
  EXPECT_NEAR(fit.intercept, 3.0, 1e-12);
  EXPECT_NEAR(fit.r_squared, 1.0, 1e-12);
  EXPECT_THROW(fit_line(std::vector{1.0}, std::vector{1.0}), std::invalid_argument);
  EXPECT_THROW(fit_line(std::vector{1.0, 2.0}, std::vector{1.0}), std::invalid_argument);
}

TEST(Line, RSquaredOfAKnownScatter) {
  // By hand: S_xx = 5, S_xy = 4, S_yy = 6, so the slope is 0.8 and R² = 16/30.
  const LineFit fit = fit_line(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{-1.0, 2.0, 1.0, 2.0});
  EXPECT_NEAR(fit.slope, 0.8, 1e-12);
  EXPECT_NEAR(fit.r_squared, 16.0 / 30.0, 1e-12);
}

constexpr double bed_top = 0.3;
constexpr double fall_speed = 1.0;  // above the bed [m/s]
constexpr double settling = 0.25;   // V_2 in the bed [m/s]
constexpr double height = 0.9975;   // of release [m]; no sample falls on the top of the bed
constexpr double weight_factor = 2.0;

double weight_of_sphere() { return std::numbers::pi / 6.0 * std::pow(0.006, 3) * 7800.0 * gravitational_acceleration; }

/// A sphere that falls at two constant speeds and touches a neighbour in every other sample of the bed.
DropSeries made_up_drop() {
  DropSeries drop;
  drop.release_time = 4.0;
  drop.species = "steel";
  const double weight = weight_of_sphere();
  const double entry = (height - bed_top) / fall_speed;
  double contacts = 0.0;
  for (int step = 0;; ++step) {
    const double time = 1e-3 * step;
    const bool inside = time > entry;
    const double z = inside ? bed_top - settling * (time - entry) : height - fall_speed * time;
    if (z < 0.003) {
      drop.bottom_time = time;
      break;
    }
    const bool touching = inside && step % 2 == 0;
    if (touching) contacts += 1.0;
    drop.time.push_back(time);
    drop.x.push_back(inside ? 0.1 * (bed_top - z) : 0.0);
    drop.y.push_back(0.0);
    drop.z.push_back(z);
    drop.velocity_x.push_back(0.0);
    drop.velocity_y.push_back(0.0);
    drop.velocity_z.push_back(inside ? -settling : -fall_speed);
    drop.angular_speed.push_back(0.0);
    drop.voidage.push_back(inside ? 0.5 + 0.1 * (step % 2) : 1.0);
    drop.liquid_velocity_z.push_back(inside ? 0.2 : 0.1);
    drop.reynolds.push_back(inside ? 1000.0 : 6600.0);
    drop.contact_force.push_back(touching ? weight_factor * weight : 0.0);
    drop.contact_force_mean_x.push_back(0.0);
    drop.contact_force_mean_y.push_back(0.0);
    drop.contact_force_mean_z.push_back(inside ? 0.5 * weight : 0.0);
    drop.drag_force_z.push_back(0.25 * weight);
    drop.pressure_force_z.push_back(0.2 * weight);
    drop.contacts.push_back(touching ? 3.0 : 0.0);
    drop.cumulative_contacts.push_back(contacts);
  }
  return drop;
}

DropStatistics statistics_of(const DropSeries& drop) {
  return analyse_drop(drop, {.bed_top = bed_top,
                             .bed_diameter = 0.005,
                             .sphere_diameter = 0.006,
                             .sphere_density = 7800.0,
                             .classification = fit_classification(drop, 0.1, 0.2, 20.0)});
}

TEST(Drop, ClassificationVelocityIsTheSlopeInTheWindow) {
  const DropSeries drop = made_up_drop();
  const auto fit = fit_classification(drop, 0.1, 0.2, 20.0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->velocity, settling, 1e-9);
  EXPECT_NEAR(fit->r_squared, 1.0, 1e-9);
  const double entry = (height - bed_top) / fall_speed;
  EXPECT_NEAR(fit->intercept, bed_top + settling * (20.0 + entry), 1e-6) << "on the clock of Table 2";
  EXPECT_NEAR(static_cast<double>(fit->points), 0.1 / settling * 1000.0, 2.0);
}

// Upside down the fall is a rise with the same line, and negative speed: the same window counts.
TEST(Drop, ASphereThatRisesHasANegativeClassificationVelocity) {
  DropSeries drop = made_up_drop();
  const auto falls = fit_classification(drop, 0.1, 0.2, 0.0);
  for (double& z : drop.z) z = 0.3 - z;
  drop.bottom_time = -1.0;
  const auto rises = fit_classification(drop, 0.1, 0.2, 0.0);
  ASSERT_TRUE(falls && rises);
  EXPECT_NEAR(rises->velocity, -falls->velocity, 1e-9);
  EXPECT_NEAR(rises->intercept, 0.3 - falls->intercept, 1e-9);
  for (double& z : drop.z) z = std::min(z, 0.19);
  EXPECT_FALSE(fit_classification(drop, 0.1, 0.2, 0.0)) << "it has not left the window";
}

// Its passage of the bed ends where it leaves the bed, not with the record.
TEST(Drop, ASphereThatRisesOutOfTheBedLeavesIt) {
  DropSeries drop;
  for (int k = 0; k < 100; ++k) {
    drop.time.push_back(0.01 * k);
    drop.z.push_back(0.05 + 0.002 * k);
  }
  const auto passage = bed_passage(drop, 0.1501);
  ASSERT_TRUE(passage);
  EXPECT_EQ(passage->begin, 0U);
  EXPECT_EQ(passage->end, 51U);
}

// In a liquid at rest a sphere that is lighter by as much as another is heavier rises as fast as that falls.
TEST(Drop, ALightSphereRisesThroughTheWindowAsFastAsAHeavyOneFalls) {
  const auto velocity = [](double density, double release_height) {
    Scene scene;
    scene.geometry.diameter = 0.05;
    scene.geometry.height = 0.3;
    scene.liquid = {1000.0, 1e-3, 0.0};
    scene.fluid.tier = FluidTier::quiescent;
    scene.fluid.cell_height = 0.01;
    scene.fluid.time_step = scene.contact.time_step = 1e-4;
    scene.contact.stiffness = 1e3;
    scene.coupling.drag_law = "wen-yu-1966";
    scene.outlet.rule = OutletRule::remove;
    scene.species = {{"one", 0.004, density, 0}};
    Stage drop;
    drop.kind = StageKind::drop;
    drop.species = "one";
    drop.release_height = release_height;
    drop.duration = 5.0;
    scene.stages = {drop};
    validate_scene(scene);
    const Folder folder;
    const RunResult result = run_scene(scene, {.directory = folder.path()}).result;
    EXPECT_EQ(result.particles_removed, density < 1000.0 ? 1 : 0);
    const auto fit = classification_of(result.drops.at(0), scene, general_rules(), 0.0);
    EXPECT_TRUE(fit);
    return fit ? fit->velocity : 0.0;
  };
  const double falls = velocity(1500.0, 0.27), rises = velocity(500.0, 0.03);
  EXPECT_GT(falls, 0.2);
  EXPECT_NEAR(rises, -falls, 0.01 * falls) << "but for its smaller inertia, which reaches that speed sooner";
}

TEST(Drop, ASphereThatDoesNotPassTheWindowHasNoClassificationVelocity) {
  DropSeries drop = made_up_drop();
  for (double& z : drop.z) z = std::max(z, 0.15);
  EXPECT_FALSE(fit_classification(drop, 0.1, 0.2, 20.0));
}

TEST(Drop, AveragesOverThePassageOfTheBed) {
  const DropStatistics statistics = statistics_of(made_up_drop());
  EXPECT_NEAR(*statistics.force_ratio, 0.5 * weight_factor, 0.005);
  EXPECT_NEAR(*statistics.force_ratio_of_mean, 0.5, 1e-3);
  EXPECT_NEAR(*statistics.peak_force_ratio, weight_factor, 1e-12);
  EXPECT_NEAR(*statistics.contact_fraction, 0.5, 0.005);
  EXPECT_NEAR(*statistics.collision_frequency, 500.0, 1.0);
  EXPECT_NEAR(*statistics.drag_ratio, 0.25, 1e-12);
  EXPECT_NEAR(*statistics.pressure_gradient_ratio, 0.2, 1e-12);
  EXPECT_NEAR(*statistics.collision_to_drag_ratio, 4.0, 0.02);
  EXPECT_NEAR(*statistics.mean_contacts, 1.5, 0.01);
  EXPECT_NEAR(*statistics.maximum_contacts, 3.0, 1e-12);
  EXPECT_NEAR(*statistics.local_voidage_mean, 0.55, 1e-3);
  EXPECT_NEAR(*statistics.local_voidage_minimum, 0.5, 1e-12);
  EXPECT_NEAR(*statistics.local_voidage_maximum, 0.6, 1e-12);
  EXPECT_NEAR(*statistics.lateral_travel, 0.1, 1e-9);
  EXPECT_NEAR(*statistics.time_to_bottom, (height - bed_top) / fall_speed + (bed_top - 0.003) / settling, 2e-3);
  EXPECT_FALSE(statistics.rests) << "it went through";
}

TEST(Drop, TerminalVelocityIsTheSlipAboveTheBed) {
  const DropStatistics statistics = statistics_of(made_up_drop());
  EXPECT_NEAR(*statistics.terminal_velocity, fall_speed + 0.1, 1e-9);
  EXPECT_NEAR(*statistics.terminal_reynolds, 6600.0, 1e-6);
}

/// A drop that comes to rest with its lowest point that far below the surface of the bed [m].
DropSeries resting_at(double depth) {
  DropSeries drop = made_up_drop();
  for (double& z : drop.z) z = std::max(z, bed_top + 0.0025 - depth + 0.003);
  drop.bottom_time = -1.0;
  return drop;
}

// A sphere that meets a hill of the surface sinks from there, however far the mean surface is.
TEST(Drop, ASphereSinksFromItsFirstContact) {
  DropSeries drop = resting_at(0.0005);
  const double hill = drop.z.back() + 0.004;
  for (std::size_t k = 0; k < drop.z.size(); ++k) drop.cumulative_contacts[k] = drop.z[k] < hill ? 1.0 : 0.0;
  const DropStatistics statistics = statistics_of(drop);
  EXPECT_TRUE(statistics.rests);
  ASSERT_TRUE(statistics.sinking);
  EXPECT_NEAR(*statistics.sinking, 0.004, 0.5e-3 * fall_speed + 1e-9) << "half of what it falls between two samples";
  EXPECT_FALSE(statistics.time_to_bottom);
  EXPECT_FALSE(statistics.force_ratio) << "it never came down to the centres of the bed";
}

TEST(Drop, SamplesFarApartDoNotTellHowFarASphereSinks) {
  DropSeries drop = resting_at(0.0005);
  for (double& time : drop.time) time *= 20.0;
  EXPECT_TRUE(statistics_of(drop).rests);
  EXPECT_FALSE(statistics_of(drop).sinking);
}

// In a hollow of the surface its centre lies below the highest ones, and still it has not gone through the bed.
TEST(Drop, ASphereInAHollowOfTheSurfaceHasNoPassage) {
  EXPECT_TRUE(statistics_of(resting_at(0.007)).rests);
  EXPECT_FALSE(statistics_of(resting_at(0.007)).collision_frequency);
  EXPECT_TRUE(statistics_of(resting_at(0.05)).collision_frequency) << "it stays in the bed";
}

TEST(Voidage, OfThePaperBed) {
  // 0.5255 kg at 2230 kg/m³ in 0.2 m of a 50 mm column is 0.3999.
  const double area = std::numbers::pi / 4.0 * 0.05 * 0.05;
  EXPECT_NEAR(voidage_from_height(0.5255 / 2230.0, area, 0.2), 0.39992, 1e-5);
}

TEST(Plane, VoidageDeviationAndVorticityOfKnownFields) {
  PlaneField plane;
  plane.x = {-0.01, 0.0, 0.01};
  plane.z = {0.05, 0.15, 0.25, 0.35, 0.45};
  for (std::size_t row = 0; row < plane.z.size(); ++row) {
    for (std::size_t column = 0; column < plane.x.size(); ++column) {
      plane.voidage.push_back(row == 4 ? 1.0 : (column == 1 ? 0.6 : 0.5));
      // Solid-body rotation u = Ω z, w = −Ω x has ω_y = ∂u/∂z − ∂w/∂x = 2Ω; Ω = 5 in the lower half, −5 above.
      const double rotation = plane.z[row] < 0.2 ? 5.0 : -5.0;
      plane.velocity_x.push_back(rotation * (plane.z[row] - 0.2));
      plane.velocity_z.push_back(-rotation * plane.x[column]);
    }
  }
  const auto vorticity = plane_vorticity(plane);
  ASSERT_EQ(vorticity.size(), plane.voidage.size());
  EXPECT_NEAR(vorticity[4], 7.5, 1e-9) << "row 0.15, on the axis: see below";
  EXPECT_NEAR(vorticity[10], -10.0, 1e-9) << "row 0.35, rotation at −5 on all sides: 2 Ω";
  EXPECT_TRUE(std::isnan(vorticity[3])) << "no neighbour beyond the edge";
  const auto statistics = analyse_plane(plane, 0.4);
  ASSERT_TRUE(statistics);
  // Four rows of 0.5, 0.6, 0.5: variance 2/9 · 0.01.
  EXPECT_NEAR(statistics->voidage_deviation, std::sqrt(0.02 / 9.0), 1e-12);
  // Row 0.15: ∂u/∂z = (−5·0.05 − 5·(−0.15))/0.2 = 2.5, −∂w/∂x = 5: 7.5. Row 0.25: ∂u/∂z = (−0.75 + 0.25)/0.2 = −2.5,
  // −∂w/∂x = −5: −7.5.
  EXPECT_NEAR(statistics->vorticity_range, 15.0, 1e-9);
  EXPECT_FALSE(analyse_plane(plane, 0.01));
}

}  // namespace
}  // namespace slfb
