#include "experiments/quantities/measure_key.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/quantities/measurement.hpp"

namespace slfb {
namespace {

TEST(MeasureKey, IsItsTextAndComesBackFromIt) {
  const MeasureKey keys[] = {measure_key("voidage", "a", 0.1),
                             measure_key("voidage", "a", 0.105, "wen-yu-1966"),
                             {"plateau", "a"},
                             {"force", "some-law", {}, "packed"},
                             {"voidage", "a", {}, "", true},
                             {"voidage", "a", {}, "wen-yu-1966", true}};
  const char* texts[] = {"voidage/a/0.10", "voidage/a/0.105/wen-yu-1966", "plateau/a", "force/some-law/packed",
                         "voidage/a/*",    "voidage/a/*/wen-yu-1966"};
  for (std::size_t k = 0; k < std::size(keys); ++k) {
    EXPECT_EQ(to_string(keys[k]), texts[k]);
    EXPECT_EQ(parse_measure_key(texts[k]), keys[k]) << texts[k];
  }
}

TEST(MeasureKey, RoundsItsNumberAsItsTextDoes) {
  EXPECT_EQ(measure_key("voidage", "a", 0.1 + 1e-12), parse_measure_key("voidage/a/0.10"));
  EXPECT_NE(measure_key("voidage", "a", 0.101), measure_key("voidage", "a", 0.10));
}

TEST(MeasureKey, RefusesWhatIsNone) {
  for (const char* text : {"", "voidage", "voidage/", "/a", "voidage/a/", "voidage/a/fast/0.10", "q/a/0.1/b/c"})
    EXPECT_THROW(parse_measure_key(text), std::invalid_argument) << text;
}

TEST(MeasureKey, APatternStandsForEveryNumberOfOneCurve) {
  const MeasureKey pattern = parse_measure_key("voidage/a/*");
  EXPECT_TRUE(stands_for(pattern, measure_key("voidage", "a", 0.06)));
  EXPECT_FALSE(stands_for(pattern, measure_key("voidage", "a", 0.06, "variant")));
  EXPECT_FALSE(stands_for(pattern, measure_key("voidage", "b", 0.06)));
  EXPECT_FALSE(stands_for(pattern, parse_measure_key("voidage/a"))) << "a number of all velocities together";
}

// In text 0.10 comes before 0.9 and after 0.02; as a number it does too, and 10 after both.
TEST(Measurements, OfOneCurveStandSideBySideByTheirNumbers) {
  Measurements measurements;
  for (const double at : {10.0, 0.9, 0.02, 0.10}) measurements[measure_key("voidage", "a", at)].value = at;
  measurements[measure_key("voidage", "a", 0.05, "variant")].value = -1.0;
  measurements[{"voidage", "a"}].value = -2.0;
  measurements[measure_key("voidage", "ab", 0.05)].value = -3.0;
  double previous = 0.0;
  const auto curve = over_numbers(measurements, "voidage", "a");
  ASSERT_EQ(curve.size(), 4U);
  for (const auto& [at, measurement] : curve) {
    EXPECT_EQ(measurement.value, at);
    EXPECT_GT(at, previous);
    previous = at;
  }
}

}  // namespace
}  // namespace slfb
