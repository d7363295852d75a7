// Laws against measurements: the statistic, laws as beds, and predictions of what the statistics had not seen.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "correlations/drag/ergun_1952.hpp"
#include "correlations/drag/wen_yu_1966.hpp"
#include "experiments/league/prediction.hpp"
#include "experiments/league/scene_bed.hpp"
#include "experiments/league/standings.hpp"
#include "experiments/numerics/plan/plan.hpp"
#include "experiments/richardson_zaki_1954/work.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::league {
namespace {

const Bed glass_in_water{{0.005, 2230.0}, {998.2, 1e-3}, 0.05};

/// ln(law / measured) of a law with this bias and spread, held against measurements with a spread of their own.
std::vector<Comparison> synthetic(double bias, double spread, double measured_spread, int groups, int points) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> gauss;
  std::vector<Comparison> comparisons;
  for (int group = 0; group < groups; ++group) {
    const double law = std::log(bias) + spread * gauss(random);
    for (int point = 0; point < points; ++point)
      comparisons.push_back({std::to_string(group), law + measured_spread * gauss(random)});
  }
  return comparisons;
}

TEST(LeagueStatistic, FindsBiasAndSpreadThatWerePutIn) {
  const Statistic found = statistic_of(synthetic(1.2, 0.15, 0.05, 400, 5), 0.05);
  EXPECT_EQ(found.groups, 400u);
  EXPECT_EQ(found.points, 2000u);
  EXPECT_NEAR(found.mean, std::log(1.2), found.mean_half_width);
  EXPECT_GT(found.spread, 0.13);
  EXPECT_LT(found.spread, 0.17);
  EXPECT_LT(found.spread_lower, 0.15);
  EXPECT_GT(found.spread_upper, 0.15);
}

TEST(LeagueStatistic, AnExactLawHasNoSpreadOfItsOwn) {
  const Statistic found = statistic_of(synthetic(1.0, 0.0, 0.1, 2000, 1), 0.1);
  EXPECT_LT(found.spread, 0.03) << "what is left is the chance of the sample";
  EXPECT_NEAR(found.total_spread, 0.1, 0.005);
}

TEST(LeagueStatistic, PointsOfOneGroupAreNotIndependent) {
  const double few = statistic_of(synthetic(1.0, 0.2, 0.0, 8, 1), 0.0).mean_half_width;
  const double many = statistic_of(synthetic(1.0, 0.2, 0.0, 8, 100), 0.0).mean_half_width;
  EXPECT_GT(many, 0.5 * few) << "a hundred points on eight lines are eight lines";
}

TEST(LeagueStatistic, StudentsTAsTabulated) {
  EXPECT_NEAR(student_factor(0.95, 9), 2.262, 0.001);
  EXPECT_NEAR(student_factor(0.95, 1), 12.706, 0.001);
}

TEST(LeagueContender, VoidageAndVelocityAreInverse) {
  for (const Contender& law : contenders())
    for (const double voidage : {0.55, 0.75, 0.95}) {
      const double velocity = law.velocity(glass_in_water, voidage);
      if (!std::isfinite(velocity)) continue;
      const auto state = law.voidage(glass_in_water, velocity, 0.4);
      // A law that jumps, or falls with the voidage, holds one velocity at more than one voidage.
      if (state.regime == fluidisation::BedRegime::expanded && std::abs(state.voidage - voidage) > 1e-6) {
        EXPECT_NEAR(law.velocity(glass_in_water, state.voidage) / velocity, 1.0, 1e-6) << law.name();
      }
    }
}

TEST(LeagueContender, TheWallSlowsAFluidisedBedByTheAuthorsFactorAndNoSuspension) {
  const auto all = contenders();
  const Contender& free = find_contender(all, "wen-yu-1966");
  const Contender& walled = find_contender(all, "wen-yu-1966 + wall");
  EXPECT_NEAR(walled.velocity(glass_in_water, 0.7) / free.velocity(glass_in_water, 0.7), std::pow(10.0, -0.1), 1e-12);
  Bed settling = glass_in_water;
  settling.motion = BedMotion::settling;
  EXPECT_DOUBLE_EQ(walled.velocity(settling, 0.7), free.velocity(settling, 0.7));
  Bed without_walls = glass_in_water;
  without_walls.tube_diameter = 0.0;
  EXPECT_DOUBLE_EQ(walled.velocity(without_walls, 0.7), free.velocity(without_walls, 0.7));
}

TEST(LeagueContender, AFormulaEndsAtTheTerminalVelocityWithThePrintedExponent) {
  const auto all = contenders();
  const Contender& formula = find_contender(all, "richardson-zaki-1954");
  EXPECT_NEAR(formula.velocity(glass_in_water, 1.0), terminal_velocity(glass_in_water), 1e-12);
  // Re_t is 2000 here, where Eq. 34 has n = 2.39.
  EXPECT_NEAR(std::log(formula.velocity(glass_in_water, 0.5) / formula.velocity(glass_in_water, 1.0)) / std::log(0.5),
              2.39, 1e-12);
}

TEST(LeagueContender, TheFormulaOfTheSuiteIsOneOfItsChoices) {
  const auto laws = contenders(), formulas = formula_contenders();
  const std::string one_sphere = "brown-lawler-2003, richardson-zaki-1954, ";
  const Contender& with_wall = find_contender(formulas, one_sphere + "richardson-zaki-1954-wall");
  const Contender& without = find_contender(formulas, one_sphere + "no wall");
  EXPECT_DOUBLE_EQ(with_wall.velocity(glass_in_water, 0.7),
                   find_contender(laws, "richardson-zaki-1954 + wall").velocity(glass_in_water, 0.7));
  EXPECT_DOUBLE_EQ(without.velocity(glass_in_water, 0.7),
                   find_contender(laws, "richardson-zaki-1954").velocity(glass_in_water, 0.7));
  Bed suspension = glass_in_water;
  suspension.motion = BedMotion::settling;
  EXPECT_DOUBLE_EQ(with_wall.velocity(suspension, 0.7), without.velocity(suspension, 0.7));
}

TEST(LeagueContender, KnowsPackedAndWashedOutBeds) {
  const auto all = contenders();
  const Contender& law = find_contender(all, "wen-yu-1966");
  EXPECT_EQ(law.voidage(glass_in_water, 0.01, 0.4).regime, fluidisation::BedRegime::packed);
  EXPECT_EQ(law.voidage(glass_in_water, 0.01, 0.4).voidage, 0.4);
  EXPECT_EQ(law.voidage(glass_in_water, 1.0, 0.4).regime, fluidisation::BedRegime::washed_out);
  EXPECT_THROW(find_contender(all, "wen-yu"), std::invalid_argument);
}

TEST(LeagueData, LinesAreReadInSiUnits) {
  const auto lines = expansion_lines(reference_data_folder() / "richardson_zaki_1954");
  EXPECT_EQ(std::ranges::count(lines, BedMotion::fluidised, &ExpansionLine::motion), 11);
  EXPECT_EQ(std::ranges::count(lines, BedMotion::settling, &ExpansionLine::motion), 37);
  EXPECT_EQ(packed_bed_points(reference_data_folder() / "ergun_1952").size(), 244u);
  const ExpansionLine& steel = lines.front();
  EXPECT_NEAR(steel.intercept, 0.955, 0.0005) << "log10 of it in cm/s is printed as 1.98";
  EXPECT_DOUBLE_EQ(steel.sphere.diameter, 0.00635);
  EXPECT_DOUBLE_EQ(steel.liquid.viscosity, 0.001);
  // The printed Reynolds numbers of suspensions are those of the terminal velocities that their lines end at.
  for (const ExpansionLine& line : lines)
    if (line.name == "run-10") {
      EXPECT_NEAR(reynolds_number(line.liquid, line.sphere.diameter, line.intercept), 2.021, 0.05);
    }
}

TEST(LeagueData, ABrokenTableIsNamedWithItsLine) {
  const Folder folder;
  const auto file = folder.path() / "packed_beds.csv";
  std::ofstream(file) << "series,reynolds over solids [-],friction factor [-]\none,10,150\ntwo,ten,150\n";
  try {
    packed_bed_points(folder.path());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), file.string() + ":3: \"ten\" is not a number");
  }
  std::ofstream(file) << "series,reynolds [-],friction factor [-]\n";
  EXPECT_THROW(packed_bed_points(folder.path()), std::runtime_error) << "a heading that says something else";
}

TEST(LeagueData, SpreadOfLinesIsThatOfColumnsWithTheSameSpheres) {
  std::vector<ExpansionLine> lines;
  const auto add = [&](BedMotion motion, double intercept) {
    lines.push_back({"made up", "line", "glass", "water", motion, glass_in_water.sphere, glass_in_water.liquid, 0.05,
                     intercept, 2.4, ""});
  };
  for (const double shift : {-0.05, 0.05}) add(BedMotion::fluidised, 0.3 * std::exp(shift));
  for (const double shift : {-0.02, 0.02}) add(BedMotion::settling, 0.3 * std::exp(shift));
  EXPECT_NEAR(line_spread(lines, BedMotion::fluidised), 0.05 * std::sqrt(2.0), 1e-9) << "standard deviation of two";
  EXPECT_NEAR(line_spread(lines, BedMotion::settling), 0.02 * std::sqrt(2.0), 1e-9);
  lines.resize(1);
  EXPECT_LT(line_spread(lines, BedMotion::fluidised), 0.01) << "one line has only the rounding of its print";
}

TEST(LeagueData, TwoFastBedsOfNearlyOneWallRatioContradictEachOther) {
  // d/D 0.102 and 0.110, both in Newton's regime, n 2.38 and 2.33: a law that changes little between them cannot have
  // both. Halfway, with n = 2.36, it is off by half of what they differ by.
  const auto& lines = measured().lines;
  const auto named = [&](const std::string& name) { return *std::ranges::find(lines, name, &ExpansionLine::name); };
  const ExpansionLine steel = named("steel6-water-62"), glass = named("glass4-water-38");
  const double voidage = 0.9;
  const auto relative = [&](const ExpansionLine& line) {
    return line.velocity(voidage) / terminal_velocity(bed_of(line));
  };
  const double halfway = 0.5 * std::log(relative(steel) / relative(glass));
  EXPECT_NEAR(voidage * halfway / 2.36, 0.031, 0.002) << "of the voidage";
}

TEST(LeagueData, ErgunsEquationFitsItsOwnPoints) {
  const Statistic found = statistic_of(compare_packed(drag::kernels_of<drag::Ergun1952>(), measured().packed), 0.0);
  EXPECT_NEAR(found.bias, 1.0, 0.02);
  EXPECT_LT(found.root_mean_square, 0.08);
}

TEST(LeaguePrediction, TakesTheBiasOfALawOff) {
  // Lines of beds that follow Wen & Yu exactly, each read through its own two ends, and a law 30 % above it.
  const auto all = contenders();
  const Contender& truth = find_contender(all, "wen-yu-1966");
  std::vector<ExpansionLine> lines;
  for (const double diameter : {0.002, 0.003, 0.004, 0.006}) {
    const Bed bed{{diameter, 2500.0}, {1000.0, 1e-3}, 0.1};
    const double low = truth.velocity(bed, 0.5), high = truth.velocity(bed, 0.9);
    const double exponent = std::log(high / low) / std::log(0.9 / 0.5);
    lines.push_back({"made up", std::to_string(diameter), "glass", "water", BedMotion::fluidised, bed.sphere,
                     bed.liquid, 0.1, low / std::pow(0.5, exponent), exponent, ""});
  }
  const Contender above("above", ContenderKind::drag_law, false,
                        [&](const Bed& bed, double voidage) { return 1.3 * truth.velocity(bed, voidage); });
  const Bed bed{{0.005, 2500.0}, {1000.0, 1e-3}, 0.1};
  const double velocity = truth.velocity(bed, 0.7);
  const Predicted found = predict_voidage(above, bed, velocity, 0.4, lines);
  EXPECT_NEAR(found.value, 0.7, 0.01);
  EXPECT_LT(above.voidage(bed, velocity, 0.4).voidage, 0.65) << "without the correction it is far off";
  EXPECT_LT(found.sigma(), 0.01);
  EXPECT_LE(found.two_sigma.first, found.one_sigma.first);
  EXPECT_GE(found.two_sigma.second, found.one_sigma.second);
}

TEST(LeaguePrediction, IsAsOftenRightAsItSays) {
  const auto all = contenders();
  for (const auto& blind : {leave_one_group_out(all, measured().lines), predict_settling(all, measured().lines)}) {
    double one = 0.0, two = 0.0;
    for (const Blind& point : blind) {
      one += point.in_one_sigma ? 1.0 : 0.0;
      two += point.in_two_sigma ? 1.0 : 0.0;
      EXPECT_LT(std::abs(point.predicted - point.measured), 0.05) << point.line << " at " << point.measured;
    }
    const auto count = static_cast<double>(blind.size());
    EXPECT_GE(one / count, 0.6);
    EXPECT_GE(two / count, 0.9);
  }
}

TEST(LeaguePrediction, CalibrationCountsErrorsAndShares) {
  const Calibration found = calibration_of({{"a", "law", 0.5, 0.53, 0.02, false, true},
                                            {"a", "law", 0.6, 0.56, 0.02, false, true},
                                            {"b", "law", 0.7, 0.70, 0.02, true, true},
                                            {"b", "law", 0.8, 0.80, 0.02, true, false}});
  EXPECT_EQ(found.points, 4u);
  EXPECT_DOUBLE_EQ(found.in_one_sigma, 0.5);
  EXPECT_DOUBLE_EQ(found.in_two_sigma, 0.75);
  EXPECT_NEAR(found.root_mean_square, 0.025, 1e-12) << "3, 4, 0 and 0 hundredths";
  EXPECT_NEAR(found.worst, 0.04, 1e-12);
  EXPECT_THROW(calibration_of({}), std::invalid_argument);
}

TEST(LeaguePrediction, ALawChosenFromFewBedsIsNoBetterThanTheSuites) {
  // 200 formulas against ten kinds of beds: what is nearest by chance is not nearest to the bed left out.
  const auto& lines = measured().lines;
  const auto choices = formula_choices(lines, 1);
  ASSERT_EQ(choices.size(), 2u);
  EXPECT_TRUE(choices.back().parts.empty());
  EXPECT_GT(choices.back().left_out.root_mean_square,
            calibration_of(leave_one_group_out(contenders(), lines)).root_mean_square);
}

TEST(LeaguePrediction, MinimumFluidisationIsErgunsAtThePackedVoidage) {
  const Predicted found =
      predict_minimum_fluidisation(drag::kernels_of<drag::Ergun1952>(), glass_in_water, measured().packed, 0.40);
  EXPECT_NEAR(found.value, 0.0422, 0.0005);
  EXPECT_LT(found.one_sigma.first, found.value);
  EXPECT_GT(found.one_sigma.second, found.value);
}

TEST(LeaguePrediction, NearBedsAreThoseOfLikeArchimedesNumberAndWall) {
  const auto near = near_lines(glass_in_water, measured().lines);
  ASSERT_FALSE(near.empty());
  EXPECT_EQ(near.front().name, "glass4-water-38") << "Ar 1.4e6 and d/D 0.11 beside 1.5e6 and 0.10";
}

}  // namespace

namespace {

TEST(SecondWorkOfTheSuite, HasItsClaimsAndScenes) {
  const Work& work = richardson_zaki_1954_work();
  const std::vector<Claim> claims = load_claims(work);
  EXPECT_GE(claims.size(), 50u);
  for (const Claim& claim : claims) {
    ASSERT_TRUE(claim.paper_band.has_value()) << claim.id;
    EXPECT_TRUE(claim.paper_band->contains(claim.paper)) << claim.id;
    EXPECT_FALSE(claim.source.empty()) << claim.id;
  }
  for (const std::string& name : profile_names(work)) {
    const Profile profile = load_profile(work, name);
    EXPECT_FALSE(profile.runs.empty()) << name;
    for (const RunSpec& run : profile.runs) {
      const Scene scene = load_run_scene(run);
      EXPECT_DOUBLE_EQ(scene.liquid.superficial_velocity, run.superficial_velocity) << run_key(run);
      EXPECT_NO_THROW(bed_of(scene)) << run_key(run);
    }
  }
  EXPECT_THROW(load_profile(work, "none"), std::runtime_error);
}

TEST(SecondWorkOfTheSuite, PublishedRunsAreThoseOfItsScenes) {
  const Work& work = richardson_zaki_1954_work();
  const Folder nothing_of_this_machine;
  for (const std::string& name : profile_names(work)) {
    const Profile profile = load_profile(work, name);
    EXPECT_TRUE(profile.goes_on_from_published) << name;
    for (const FinishedRun& run : finished_runs(profile, nothing_of_this_machine.path()))
      EXPECT_FALSE(run.stale) << name << ": " << run_key(run.spec) << " was made from another scene";
  }
}

TEST(SecondWorkOfTheSuite, APlanOfAnyRunIsAValidScene) {
  // The plan has other steps of the liquid than the scene, and a run counts its times in them.
  const plan::Rules rules = plan::load_rules();
  for (const RunSpec& run : load_profile(richardson_zaki_1954_work(), "quick").runs) {
    const Scene scene = load_run_scene(run);
    const plan::Plan made = plan::make_plan(scene, {"voidage"}, rules);
    const Scene planned = plan::changed(scene, made.overrides);
    const double samples = planned.recording.bed_interval / planned.fluid.time_step;
    EXPECT_NEAR(samples, std::round(samples), 1e-6) << run_key(run);
    EXPECT_NEAR(planned.recording.bed_interval, scene.recording.bed_interval, planned.fluid.time_step) << run_key(run);
  }
}

TEST(SecondWorkOfTheSuite, ClaimsOfLawsAreAnsweredWithoutARun) {
  const Work& work = richardson_zaki_1954_work();
  const Measurements measured = work.without_runs();
  std::size_t answered = 0;
  for (const Claim& claim : load_claims(work))
    if (!claim.needs_run()) {
      EXPECT_TRUE(measured.contains(claim.measures.front())) << claim.id;
      ++answered;
    }
  EXPECT_GE(answered, 100u);
}

}  // namespace
}  // namespace slfb::league
