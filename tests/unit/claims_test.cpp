#include "experiments/claims/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

bool needs_run(const MeasureKey& measure) { return slfb::needs_run(peng_2014_work(), measure); }

/// The key of this text.
MeasureKey key(std::string_view text) { return parse_measure_key(text); }

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A claim about "mass/6in5W/0.06": equals 10 within 1, accepted between 9 and 11.
Claim made_up_claim() {
  Claim claim;
  claim.id = "fig99.mass";
  claim.figure = "fig99";
  claim.quantity = "made-up mass";
  claim.unit = "kg";
  claim.source = "nowhere";
  claim.kind = StatementKind::value;
  claim.paper = claim.paper_upper = 10.0;
  claim.paper_band = Band{9.0, 11.0};
  claim.systems = {"6in5W"};
  claim.measures = {key("mass/6in5W/0.06")};
  claim.regression_band = Band{9.5, 10.5};
  return claim;
}

Evaluation evaluate_one(const Claim& claim, const Measurements& measurements) {
  return evaluate({claim}, measurements).front();
}

Measurements with(double value, double half_width) {
  return {
      {key("mass/6in5W/0.06"), {.value = value, .half_width = half_width, .samples = 5, .unit = "kg", .origin = ""}}};
}

TEST(Claims, ThereAreAtLeastSixtyWithUniqueIdsUnitsAndSources) {
  const auto claims = load_claims();
  EXPECT_GE(claims.size(), 60u);
  std::set<std::string> ids;
  for (const Claim& claim : claims) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    EXPECT_TRUE(claim.id.starts_with(claim.figure + ".")) << claim.id;
    EXPECT_FALSE(claim.unit.empty()) << claim.id;
    EXPECT_FALSE(claim.source.empty()) << claim.id;
    EXPECT_FALSE(claim.quantity.empty()) << claim.id;
    EXPECT_TRUE(!claim.measures.empty() || !claim.undecidable.empty()) << claim.id;
    if (claim.paper_band) {
      EXPECT_FALSE(claim.band_reason.empty()) << claim.id;
      EXPECT_TRUE(claim.paper_band->contains(claim.paper)) << claim.id;
    }
    if (claim.regression_band) {
      EXPECT_FALSE(claim.regression_reason.empty()) << claim.id;
      EXPECT_TRUE(std::isfinite(claim.regression_band->upper - claim.regression_band->lower)) << claim.id;
    }
  }
}

TEST(Claims, MeasureKeysAreWellFormed) {
  const std::regex of_run("[a-z0-9_]+/(all|[3-6]in[3-6][WN](/([0-9]\\.[0-9]{2}(/[a-z0-9-]+)?|\\*))?)");
  const std::regex of_law("[a-z0-9_]+/[a-z0-9.-]+(/[a-z0-9.-]+)?");
  for (const Claim& claim : load_claims()) {
    for (const MeasureKey& measure : claim.measures) {
      const std::string text = to_string(measure);
      EXPECT_TRUE(std::regex_match(text, needs_run(measure) ? of_run : of_law)) << claim.id << ": " << text;
    }
  }
}

TEST(Claims, EveryRowOfTable2IsAClaim) {
  const auto claims = load_claims();
  for (const Table2Row& row : peng_2014().table2()) {
    const MeasureKey key = measure_key("classification_velocity", "6in5W", row.superficial_velocity);
    const auto found = std::find_if(claims.begin(), claims.end(), [&](const Claim& claim) {
      return claim.figure == "table2" && claim.measures == std::vector{key};
    });
    ASSERT_NE(found, claims.end()) << to_string(key);
    EXPECT_DOUBLE_EQ(found->paper, row.classification_velocity);
  }
}

TEST(Claims, WithoutRunsNothingThatNeedsOneIsDecided) {
  for (const Evaluation& evaluation : evaluate(load_claims(), measure_without_runs())) {
    const auto& keys = evaluation.claim.measures;
    if (std::ranges::none_of(keys, needs_run)) continue;
    EXPECT_EQ(evaluation.verdict, Verdict::not_decidable) << evaluation.claim.id;
    EXPECT_EQ(evaluation.gate, Gate::none) << evaluation.claim.id;
    EXPECT_TRUE(evaluation.reason.find("not yet simulated: ") != std::string::npos ||
                evaluation.reason.find("no runs about this voidage: ") != std::string::npos ||
                !evaluation.claim.undecidable.empty())
        << evaluation.reason;
  }
}

TEST(Verdict, IntervalInsideTheBandIsReproduced) {
  const Evaluation evaluation = evaluate_one(made_up_claim(), with(10.2, 0.5));
  EXPECT_EQ(evaluation.verdict, Verdict::reproduced);
  EXPECT_DOUBLE_EQ(*evaluation.ours, 10.2);
  EXPECT_DOUBLE_EQ(evaluation.interval->first, 9.7);
  EXPECT_NEAR(*evaluation.deviation, 0.02, 1e-12);
}

TEST(Verdict, IntervalOutsideTheBandIsNotReproduced) {
  EXPECT_EQ(evaluate_one(made_up_claim(), with(12.0, 0.5)).verdict, Verdict::not_reproduced);
  EXPECT_EQ(evaluate_one(made_up_claim(), with(8.0, 0.5)).verdict, Verdict::not_reproduced);
  EXPECT_NEAR(*evaluate_one(made_up_claim(), with(8.0, 0.5)).deviation, -0.2, 1e-12);
}

TEST(Verdict, IntervalThatStraddlesAnEdgeIsNotDecidable) {
  for (const double value : {10.8, 11.2, 9.1}) {
    const Evaluation evaluation = evaluate_one(made_up_claim(), with(value, 0.5));
    EXPECT_EQ(evaluation.verdict, Verdict::not_decidable) << value;
    EXPECT_NE(evaluation.reason.find("straddles"), std::string::npos);
  }
  EXPECT_EQ(evaluate_one(made_up_claim(), with(10.0, 50.0)).verdict, Verdict::not_decidable)
      << "a wide interval does not make a claim hold";
}

TEST(Verdict, OneSampleDecidesNothing) {
  const Evaluation evaluation = evaluate_one(made_up_claim(), with(10.0, nan));
  EXPECT_EQ(evaluation.verdict, Verdict::not_decidable);
  EXPECT_FALSE(evaluation.interval);
  EXPECT_DOUBLE_EQ(*evaluation.ours, 10.0);
  EXPECT_NE(evaluation.reason.find("inside"), std::string::npos);
}

TEST(Verdict, BoundsAreOneSided) {
  Claim claim = made_up_claim();
  claim.kind = StatementKind::at_most;
  claim.paper_band = Band{-infinity, 10.0};
  EXPECT_EQ(evaluate_one(claim, with(-100.0, 1.0)).verdict, Verdict::reproduced);
  EXPECT_DOUBLE_EQ(*evaluate_one(claim, with(-100.0, 1.0)).deviation, 0.0);
  EXPECT_EQ(evaluate_one(claim, with(12.0, 1.0)).verdict, Verdict::not_reproduced);
  EXPECT_NEAR(*evaluate_one(claim, with(12.0, 1.0)).deviation, 0.2, 1e-12);
  EXPECT_EQ(claim.paper_text(), "at most 10");
}

TEST(Verdict, ARangeMeasuresItsDeviationFromTheNearerEnd) {
  Claim claim = made_up_claim();
  claim.kind = StatementKind::between;
  claim.paper_upper = 50.0;
  claim.paper_band = Band{10.0, 50.0};
  EXPECT_DOUBLE_EQ(*evaluate_one(claim, with(30.0, 1.0)).deviation, 0.0);
  EXPECT_NEAR(*evaluate_one(claim, with(60.0, 1.0)).deviation, 0.2, 1e-12);
  EXPECT_NEAR(*evaluate_one(claim, with(5.0, 1.0)).deviation, -0.5, 1e-12);
  EXPECT_EQ(claim.paper_text(), "between 10 and 50");
}

Claim trend_claim(StatementKind kind) {
  Claim claim = made_up_claim();
  claim.kind = kind;
  claim.paper_band.reset();
  claim.regression_band.reset();
  claim.measures = {key("mass/6in5W/0.06"), key("mass/6in5W/0.07"), key("mass/6in5W/0.08")};
  return claim;
}

Measurements three(double a, double b, double c, double half_width) {
  const auto measurement = [&](double value) { return Measurement{value, half_width, 5, "kg", ""}; };
  return {{key("mass/6in5W/0.06"), measurement(a)},
          {key("mass/6in5W/0.07"), measurement(b)},
          {key("mass/6in5W/0.08"), measurement(c)}};
}

TEST(Trend, Rules) {
  const Claim rising = trend_claim(StatementKind::increasing);
  const Claim falling = trend_claim(StatementKind::decreasing);
  EXPECT_EQ(evaluate_one(rising, three(1, 2, 3, 0.1)).verdict, Verdict::reproduced);
  EXPECT_DOUBLE_EQ(*evaluate_one(rising, three(1, 2, 3, 0.1)).ours, 2.0);
  EXPECT_EQ(evaluate_one(falling, three(1, 2, 3, 0.1)).verdict, Verdict::not_reproduced);
  EXPECT_EQ(evaluate_one(falling, three(3, 2, 1, 0.1)).verdict, Verdict::reproduced);
  EXPECT_EQ(evaluate_one(rising, three(1, 3, 2, 0.1)).verdict, Verdict::not_reproduced) << "a step goes down";
  EXPECT_EQ(evaluate_one(rising, three(1, 2.05, 2, 0.1)).verdict, Verdict::reproduced) << "within its interval";
  EXPECT_EQ(evaluate_one(rising, three(1, 1.05, 1.1, 0.1)).verdict, Verdict::not_decidable) << "too small to tell";
  EXPECT_EQ(evaluate_one(rising, three(1, 1, 1, 0.0)).verdict, Verdict::not_reproduced) << "exactly no change";
  EXPECT_EQ(evaluate_one(rising, three(1, 2, 3, nan)).verdict, Verdict::not_decidable);
  EXPECT_EQ(evaluate_one(rising, with(1.0, 0.1)).verdict, Verdict::not_decidable) << "two runs are missing";
}

TEST(Gate, PlantedDeviationTurnsItRed) {
  EXPECT_EQ(evaluate_one(made_up_claim(), with(10.0, 0.1)).gate, Gate::holds);
  const Evaluation broken = evaluate_one(made_up_claim(), with(10.6, 0.1));
  EXPECT_EQ(broken.gate, Gate::broken);
  EXPECT_EQ(broken.verdict, Verdict::reproduced) << "the paper's band is another one";
  EXPECT_NE(broken.reason.find("outside the accepted"), std::string::npos);
}

TEST(Gate, EveryLawGateGoesRedWhenItsMeasurementIsOff) {
  const auto claims = load_claims();
  const Measurements laws = measure_without_runs();
  for (const Claim& claim : claims) {
    if (!claim.regression_band) continue;
    Measurements planted = laws;
    // One part in a hundred, or more where the band is wider.
    const double width = claim.regression_band->upper - claim.regression_band->lower;
    for (const MeasureKey& key : claim.measures) planted.at(key).value += 0.01 * std::abs(laws.at(key).value) + width;
    if (claim.reduction == Reduction::single && claim.measures.size() == 1) {
      EXPECT_EQ(evaluate_one(claim, planted).gate, Gate::broken) << claim.id;
    }
    planted = laws;
    planted.erase(claim.measures.front());
    EXPECT_EQ(evaluate_one(claim, planted).gate, Gate::broken) << claim.id << " without its measurement";
  }
}

TEST(Gate, ARunThatDoesNotExistBreaksNothing) { EXPECT_EQ(evaluate_one(made_up_claim(), {}).gate, Gate::none); }

TEST(Reduction, OfSeveralMeasures) {
  Claim claim = made_up_claim();
  claim.measures = {key("mass/6in5W/*")};
  Measurements values = three(8.0, 10.0, 12.0, 0.3);
  values[key("mass/6in5W/0.09/variant")] = {100.0, 0.0, 1, "kg", ""};
  claim.reduction = Reduction::largest;
  EXPECT_DOUBLE_EQ(*evaluate_one(claim, values).ours, 12.0) << "variants do not count";
  claim.reduction = Reduction::smallest;
  EXPECT_DOUBLE_EQ(*evaluate_one(claim, values).ours, 8.0);
  claim.reduction = Reduction::relative_spread;
  EXPECT_DOUBLE_EQ(*evaluate_one(claim, values).ours, 0.4);
  claim.reduction = Reduction::ratio;
  claim.measures = {key("mass/6in5W/0.08"), key("mass/6in5W/0.06")};
  const Evaluation ratio = evaluate_one(claim, values);
  EXPECT_DOUBLE_EQ(*ratio.ours, 1.5);
  EXPECT_NEAR(ratio.interval->second - 1.5, 1.5 * std::hypot(0.3 / 12.0, 0.3 / 8.0), 1e-12);
  values.at(key("mass/6in5W/0.06")).value = -20.0;
  claim.measures = {key("mass/6in5W/*")};
  claim.reduction = Reduction::largest_magnitude;
  EXPECT_DOUBLE_EQ(*evaluate_one(claim, values).ours, 20.0);
}

/// Several drops: their mean, its half-width, what one of them scatters.
Measurement drops(double mean, double scatter, std::size_t samples) {
  Measurement measured{mean, 0.0, samples, "kg", ""};
  measured.half_width = scatter / std::sqrt(static_cast<double>(samples)) *
                        (samples == 5    ? 2.776445
                         : samples == 30 ? 2.045230
                                         : nan);
  measured.scatter = scatter;
  return measured;
}

/// The made-up claim as one printed drop: 10, its curve followed within 20 %.
Claim one_drop_claim() {
  Claim claim = made_up_claim();
  claim.printed_from = PrintedFrom::one_drop;
  claim.paper_band = Band{8.0, 12.0};
  claim.regression_band.reset();
  return claim;
}

Verdict verdict_of_drops(double mean, double scatter, std::size_t samples) {
  return evaluate_one(one_drop_claim(), {{key("mass/6in5W/0.06"), drops(mean, scatter, samples)}}).verdict;
}

// One printed drop is held against one drop of ours: 2.776 · 1 · √(1 + 1/5) = 3.04 about the mean.
TEST(OneDrop, IsHeldAgainstThePredictionOfOneDrop) {
  EXPECT_EQ(verdict_of_drops(10.2, 1.0, 5), Verdict::reproduced);
  EXPECT_EQ(verdict_of_drops(13.1, 1.0, 5), Verdict::not_reproduced);
  EXPECT_EQ(verdict_of_drops(12.9, 1.0, 5), Verdict::not_decidable) << "inside that interval, but hardly";
  const Evaluation evaluation = evaluate_one(one_drop_claim(), {{key("mass/6in5W/0.06"), drops(13.1, 1.0, 5)}});
  EXPECT_NEAR(evaluation.interval->first, 13.1 - 2.776445 * std::sqrt(1.2), 1e-5);
  // The interval of the mean, 1.24, would have decided more: the paper's drop scatters as ours do.
  EXPECT_EQ(verdict_of_drops(11.5, 1.0, 5), Verdict::not_decidable);
  EXPECT_EQ(verdict_of_drops(11.5, 1.0, 30), Verdict::reproduced);
}

TEST(OneDrop, WideScatterDoesNotMakeAClaimHold) {
  const Evaluation evaluation = evaluate_one(one_drop_claim(), {{key("mass/6in5W/0.06"), drops(13.0, 8.0, 30)}});
  EXPECT_EQ(evaluation.verdict, Verdict::not_decidable);
  EXPECT_EQ(evaluation.lack, Lack::paper) << "no number of our drops tells what one printed drop is";
}

TEST(OneDrop, ThatDidNotArriveIsHeldAgainstTheBand) {
  Measurement late{15.0, nan, 5, "kg", ""};
  late.interval = {15.0, infinity};
  EXPECT_EQ(evaluate_one(one_drop_claim(), {{key("mass/6in5W/0.06"), late}}).verdict, Verdict::not_reproduced);
}

// Six points of which each lies within 20 % in nine of ten repeats keep the bound all together in 0.9^6 = 0.53 of them;
// sixty in two of a thousand.
TEST(OneDrop, TheLargestOfManyHasItsOwnDistribution) {
  Claim claim = one_drop_claim();
  claim.kind = StatementKind::at_most;
  claim.reduction = Reduction::largest_magnitude;
  claim.paper = 0.2;
  claim.paper_band = Band{-infinity, 0.2};
  claim.measures = {key("mass/6in5W/*")};
  const auto points = [&](int count) {
    Measurements values;
    Measurement point{0.0, 1e-9, 100000, "kg", ""};
    point.scatter = 0.2 / 1.644854;  // 90 % within
    for (int k = 0; k < count; ++k) values[measure_key("mass", "6in5W", 0.06 + 0.001 * k)] = point;
    return values;
  };
  EXPECT_EQ(evaluate_one(claim, points(6)).verdict, Verdict::reproduced);
  EXPECT_NE(evaluate_one(claim, points(6)).reason.find("0.53"), std::string::npos);
  EXPECT_EQ(evaluate_one(claim, points(60)).verdict, Verdict::not_reproduced);
  EXPECT_GT(evaluate_one(claim, points(60)).interval->first, evaluate_one(claim, points(6)).interval->first);
}

// The largest of several noisy means: no single one of twenty that stands out by its own interval breaks a bound.
TEST(Reduction, TheLargestOfManyMeansStandsOutByChance) {
  Claim claim = made_up_claim();
  claim.kind = StatementKind::at_most;
  claim.paper_band = Band{-infinity, 10.0};
  claim.reduction = Reduction::largest;
  claim.measures = {key("mass/6in5W/*")};
  Measurements values;
  for (int k = 0; k < 20; ++k) values[measure_key("mass", "6in5W", 0.06 + 0.001 * k)] = {9.0, 1.0, 50, "kg", ""};
  values[measure_key("mass", "6in5W", 0.09)] = {11.1, 1.0, 50, "kg", ""};
  EXPECT_EQ(evaluate_one(claim, values).verdict, Verdict::not_decidable);
  values[measure_key("mass", "6in5W", 0.09)] = {12.0, 1.0, 50, "kg", ""};
  EXPECT_EQ(evaluate_one(claim, values).verdict, Verdict::not_reproduced);
}

TEST(Readings, OfWhoseVoidageIsMeantAreBothJudged) {
  Claim claim = made_up_claim();
  claim.other_measures = {key("mass/6in5W/0.07")};
  claim.reading = "our voidage";
  claim.other_reading = "Eq. 36's";
  const auto both = [&](double one, double other) {
    return evaluate_one(claim, {{key("mass/6in5W/0.06"), {one, 0.1, 5, "kg", ""}},
                                {key("mass/6in5W/0.07"), {other, 0.1, 5, "kg", ""}}});
  };
  EXPECT_EQ(both(10.0, 10.1).verdict, Verdict::reproduced);
  EXPECT_EQ(both(20.0, 20.0).verdict, Verdict::not_reproduced);
  const Evaluation split = both(10.0, 20.0);
  EXPECT_EQ(split.verdict, Verdict::not_decidable);
  EXPECT_EQ(split.lack, Lack::paper);
  EXPECT_NE(split.reason.find("at our voidage: 10, reproduced"), std::string::npos) << split.reason;
  EXPECT_NE(split.reason.find("at Eq. 36's: 20, not reproduced"), std::string::npos) << split.reason;
  // Where there is no run about one of them, the other decides.
  EXPECT_EQ(evaluate_one(claim, {{key("mass/6in5W/0.07"), {20.0, 0.1, 5, "kg", ""}}}).verdict, Verdict::not_reproduced);
}

TEST(Verdict, AnUndecidedClaimSaysWhatItLacks) {
  EXPECT_EQ(evaluate_one(made_up_claim(), {}).lack, Lack::run);
  EXPECT_EQ(evaluate_one(made_up_claim(), with(10.9, 0.5)).lack, Lack::more_samples);
  EXPECT_EQ(evaluate_one(made_up_claim(), with(10.0, 0.5)).lack, Lack::nothing);
  Measurements expanding = with(10.9, nan);
  expanding.begin()->second.steady = false;
  EXPECT_EQ(evaluate_one(made_up_claim(), expanding).lack, Lack::steadiness);
  Claim lost = made_up_claim();
  lost.undecidable = "the number is lost";
  EXPECT_EQ(evaluate_one(lost, with(10.0, 0.1)).lack, Lack::paper);
}

// What a law would give is no statement of the paper.
TEST(Claims, ArithmeticIsCountedApart) {
  Claim ours = made_up_claim(), theirs = made_up_claim();
  ours.origin = Origin::arithmetic;
  const auto evaluations = evaluate({ours, theirs, theirs}, with(10.0, 0.1));
  EXPECT_EQ(count(evaluations, Origin::paper).reproduced, 2U);
  EXPECT_EQ(count(evaluations, Origin::arithmetic).reproduced, 1U);
  EXPECT_EQ(count(evaluations).reproduced, 3U);
  for (const Claim& claim : load_claims())
    if (claim.origin == Origin::arithmetic) {
      EXPECT_TRUE(std::ranges::none_of(claim.measures, needs_run)) << claim.id;
    }
}

// No measurement of a bound that can only be kept: each of these fails on one side and on the other.
TEST(Claims, AxesThatHoldTheDataCanBeMissed) {
  for (const char* id : {"fig08.terminal_reynolds", "fig14.vorticity_scale", "fig14.speed"}) {
    const auto claims = load_claims();
    const auto found = std::ranges::find(claims, id, &Claim::id);
    ASSERT_NE(found, claims.end());
    ASSERT_TRUE(found->paper_band) << id;
    EXPECT_GT(found->paper_band->lower, 0.5 * found->paper) << id;
    EXPECT_LT(found->paper_band->upper, 2.0 * found->paper) << id;
  }
}

TEST(Json, HasExactlyTheDocumentedShape) {
  const auto evaluations = evaluate(load_claims(), measure_without_runs());
  const auto json = nlohmann::json::parse(claims_json(evaluations).dump());
  ASSERT_EQ(json.size(), 1u);
  ASSERT_EQ(json.at("claims").size(), evaluations.size());
  const std::set<std::string> expected{"id",        "figure",     "quantity", "unit", "paper",  "ours",   "interval",
                                       "deviation", "paper_band", "verdict",  "gate", "reason", "origin", "lack"};
  for (const auto& claim : json.at("claims")) {
    std::set<std::string> keys;
    for (const auto& [key, value] : claim.items()) keys.insert(key);
    EXPECT_EQ(keys, expected);
    for (const char* key : {"id", "figure", "quantity", "unit", "verdict", "gate", "reason"}) {
      EXPECT_TRUE(claim.at(key).is_string()) << key;
    }
    EXPECT_TRUE(claim.at("paper").is_number() || claim.at("paper").is_string());
    for (const char* key : {"ours", "deviation"}) EXPECT_TRUE(claim.at(key).is_number() || claim.at(key).is_null());
    for (const char* key : {"interval", "paper_band"}) {
      EXPECT_TRUE(claim.at(key).is_null() || claim.at(key).size() == 2u) << key;
    }
    EXPECT_TRUE((std::set<std::string>{"reproduced", "not reproduced", "not decidable"}).contains(claim.at("verdict")));
    EXPECT_TRUE((std::set<std::string>{"holds", "broken", "none"}).contains(claim.at("gate")));
    EXPECT_TRUE((std::set<std::string>{"paper", "arithmetic"}).contains(claim.at("origin")));
    EXPECT_EQ(claim.at("lack") == "nothing", claim.at("verdict") != "not decidable") << claim.at("id");
  }
}

TEST(Json, AnOpenSideOfABandIsNull) {
  Claim claim = made_up_claim();
  claim.paper_band = Band{-infinity, 10.0};
  const auto json = claims_json(evaluate({claim}, {}));
  EXPECT_TRUE(json.at("claims").at(0).at("paper_band").at(0).is_null());
  EXPECT_DOUBLE_EQ(json.at("claims").at(0).at("paper_band").at(1), 10.0);
  EXPECT_TRUE(json.at("claims").at(0).at("ours").is_null());
}

TEST(Junit, BrokenGatesAreFailuresAndMissingRunsAreSkipped) {
  Claim holds = made_up_claim(), broken = made_up_claim(), missing = made_up_claim(), without = made_up_claim();
  broken.id = "fig99.broken";
  broken.regression_band = Band{20.0, 21.0};
  missing.id = "fig99.missing";
  missing.measures = {key("mass/6in5W/0.24")};
  without.id = "fig99.without";
  without.regression_band.reset();
  const std::string text = claims_junit(evaluate({holds, broken, missing, without}, with(10.0, 0.1)));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str()));
  const auto suite = document.child("testsuite");
  EXPECT_EQ(suite.attribute("tests").as_int(), 4);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 2);
  const auto failed = suite.find_child_by_attribute("testcase", "name", "fig99.broken");
  const std::string message = failed.child("failure").attribute("message").value();
  EXPECT_NE(message.find("ours 10 "), std::string::npos) << message;
  EXPECT_NE(message.find("allowed [20, 21]"), std::string::npos) << message;
  EXPECT_GE(failed.attribute("time").as_double(-1.0), 0.0);
  EXPECT_TRUE(suite.find_child_by_attribute("testcase", "name", "fig99.missing").child("skipped"));
  EXPECT_TRUE(suite.find_child_by_attribute("testcase", "name", "fig99.without").child("skipped"));
}

/// What load_claims says to a file with this text.
std::string error_of(const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / "slfb_claims.toml";
  std::ofstream(file) << text;
  std::string message = "no error";
  try {
    load_claims(file, peng_2014(), {"6in5W"});
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  std::filesystem::remove(file);
  return message;
}

TEST(ClaimFile, MistakesAreNamedWithLineAndClaim) {
  const std::string head = "[[claim]]\nid = \"fig05.a\"\nfigure = \"fig05\"\nquantity = \"q\"\n";
  const std::string band = "paper_band = { relative = 0.1, why = \"w\" }\n";
  const std::string measure = "measure = \"pressure_drop/6in5W/0.06\"\n";
  const std::string value = "equals = \"pressure_plateau\"\n";
  EXPECT_EQ(error_of(head + value + band + measure), "no error");
  EXPECT_NE(error_of(head + value + band + measure + "colour = 1\n").find("slfb_claims.toml:8: colour: "),
            std::string::npos);
  EXPECT_NE(error_of(head + value + measure).find("paper_band: is missing"), std::string::npos);
  EXPECT_NE(error_of(head + value + band).find("measure: claim fig05.a: is missing"), std::string::npos);
  EXPECT_NE(error_of(head + band + measure).find("exactly one of"), std::string::npos);
  EXPECT_NE(error_of(head + "equals = \"nothing\"\n" + band + measure).find("\"nothing\""), std::string::npos);
  EXPECT_NE(error_of(head + value + band + "measure = [\"a/6in5W/0.06\", \"b/6in5W/0.06\"]\n").find("need \"reduce\""),
            std::string::npos);
  EXPECT_NE(error_of(head + value + "paper_band = { why = \"w\" }\n" + measure).find("\"relative\" or \"absolute\""),
            std::string::npos);
  EXPECT_NE(error_of(head + value + band + measure + "origin = \"hearsay\"\n").find("neither \"paper\" nor"),
            std::string::npos);
  EXPECT_NE(error_of(head + value + band + measure + "other_measure = \"pressure_drop/6in5W/0.07\"\n")
                .find("needs \"measure_is\""),
            std::string::npos);
  const std::string whole = head + value + band + measure;
  EXPECT_NE(error_of(whole + whole).find("occurs twice"), std::string::npos);
}

/// The claim on V_2 at 0.06 m/s, judged with `ours` against `published` drops.
Evaluation gate_of_drops(const std::vector<double>& ours, const std::vector<double>& published) {
  const auto measured = [](const std::vector<double>& drops) {
    const ReplicateEstimate e = estimate_replicates(drops);
    return Measurements{{key("classification_velocity/6in5W/0.06"), {e.mean, e.half_width, e.samples, "m/s", "a run"}}};
  };
  std::vector<Claim> claims = load_claims();
  std::erase_if(claims, [](const Claim& claim) { return claim.id != "table2.classification_velocity_0.06"; });
  auto evaluations = evaluate(claims, measured(ours));
  judge_run_gates(evaluations, measured(ours), measured(published));
  return evaluations.at(0);
}

TEST(RunGates, HoldForTheSameRunsAndBreakForOthers) {
  EXPECT_EQ(gate_of_drops({0.10, 0.11, 0.12}, {0.10, 0.11, 0.12}).gate, Gate::holds);
  EXPECT_EQ(gate_of_drops({0.10, 0.11, 0.12}, {0.115, 0.10, 0.105, 0.12}).gate, Gate::holds);
  const Evaluation broken = gate_of_drops({0.200, 0.201, 0.199, 0.2005, 0.1995}, {0.100, 0.101, 0.099, 0.1005, 0.0995});
  EXPECT_EQ(broken.gate, Gate::broken);
  EXPECT_NE(broken.reason.find("classification_velocity/6in5W/0.06 is 0.2 here and 0.1"), std::string::npos)
      << broken.reason;
  EXPECT_EQ(gate_of_drops({0.10}, {0.20, 0.21}).gate, Gate::none);
  // CI reads the file: a broken gate that makes the command fail is a failure there too.
  const std::string junit = claims_junit({broken});
  EXPECT_NE(junit.find("failures=\"1\""), std::string::npos) << junit;
}

// Equal beds, three drops against five: a false alarm once in a thousand times, 20 of 20000 (the band is the 99.9 %
// interval of a Poisson number of that mean).
TEST(RunGates, RaiseAFalseAlarmOnceInAThousandTimes) {
  std::mt19937 random(7);
  std::normal_distribution<double> drop(0.1, 0.01);
  int alarms = 0;
  Measurements ours, published;
  std::vector<Claim> claims = load_claims();
  std::erase_if(claims, [](const Claim& claim) { return claim.id != "table2.classification_velocity_0.06"; });
  const auto draw = [&](std::size_t samples) {
    std::vector<double> drops(samples);
    for (double& value : drops) value = drop(random);
    const ReplicateEstimate e = estimate_replicates(drops);
    return Measurements{{key("classification_velocity/6in5W/0.06"), {e.mean, e.half_width, e.samples, "m/s", "a run"}}};
  };
  for (int k = 0; k < 20000; ++k) {
    std::vector<Evaluation> evaluations(1);
    evaluations[0].claim = claims.at(0);
    judge_run_gates(evaluations, draw(3), draw(5));
    alarms += evaluations[0].gate == Gate::broken;
  }
  EXPECT_GE(alarms, 7);
  EXPECT_LE(alarms, 37);
}

// A trend over systems whose runs have springs of two kinds is a trend of the springs as well.
TEST(Claims, DoNotCompareSpringsOfTwoKinds) {
  Claim rising = made_up_claim();
  rising.kind = StatementKind::increasing;
  rising.measures = {key("collision_frequency/a"), key("collision_frequency/b")};
  Measurements values{{key("collision_frequency/a"), {1.0, 0.1, 3, "1/s", "", Springs::own}},
                      {key("collision_frequency/b"), {2.0, 0.1, 3, "1/s", "", Springs::own}}};
  EXPECT_EQ(evaluate_one(rising, values).verdict, Verdict::reproduced);
  values.at(key("collision_frequency/b")).springs = Springs::softened;
  EXPECT_EQ(evaluate_one(rising, values).verdict, Verdict::not_decidable);
}

}  // namespace
}  // namespace slfb
