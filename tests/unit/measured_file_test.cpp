#include "experiments/claims/measured_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "experiments/peng_2014/work.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

class MeasuredFile : public testing::Test {
 protected:
  Measurements load(const std::string& text) {
    const auto file = folder_.path() / "mine.toml";
    std::ofstream(file) << text << std::flush;
    return load_measured(file, claims_);
  }
  std::string complaint(const std::string& text) {
    try {
      load(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  Evaluation said_of(const std::string& id, const Measurements& measured) {
    for (Evaluation& evaluation : evaluate_measured(claims_, measured))
      if (evaluation.claim.id == id) return evaluation;
    throw std::out_of_range(id);
  }

  std::vector<Claim> claims_ = load_claims();
  Folder folder_;
};

/// A velocity at 0.10 m/s in 6in5W.
std::string with_value(double value, const char* interval = "half_width = 0.004\n") {
  return fmt::format("[[measured]]\nmeasure = \"classification_velocity/6in5W/0.10\"\nvalue = {}\n{}unit = \"m/s\"\n",
                     value, interval);
}

// Table 2 has 0.214 m/s at 0.10 m/s: who measured that reproduces it, who measured twice that does not, and fails.
TEST_F(MeasuredFile, IsHeldAgainstThePaper) {
  const std::string id = "table2.classification_velocity_0.10";
  const Evaluation same = said_of(id, load(with_value(0.214)));
  EXPECT_EQ(same.verdict, Verdict::reproduced);
  EXPECT_EQ(same.gate, Gate::holds);
  const Evaluation twice = said_of(id, load(with_value(0.428)));
  EXPECT_EQ(twice.verdict, Verdict::not_reproduced);
  EXPECT_EQ(twice.gate, Gate::broken);
  EXPECT_NEAR(*twice.deviation, 1.0, 1e-12);
}

// Claims of which the file says nothing are left out; those of which it says a part are not decided.
TEST_F(MeasuredFile, SaysNothingOfWhatItDoesNotHave) {
  for (const Evaluation& evaluation : evaluate_measured(claims_, load(with_value(0.214)))) {
    const auto& measures = evaluation.claim.measures;
    EXPECT_TRUE(std::ranges::any_of(measures, [](const MeasureKey& measure) {
      return measure.quantity == "classification_velocity" && measure.subject == "6in5W";
    })) << evaluation.claim.id;
    if (measures.size() > 1) {
      EXPECT_EQ(evaluation.verdict, Verdict::not_decidable) << evaluation.claim.id;
      EXPECT_NE(evaluation.reason.find("not measured: "), std::string::npos) << evaluation.reason;
    }
  }
}

TEST_F(MeasuredFile, WithoutAnIntervalDecidesNothing) {
  EXPECT_EQ(said_of("table2.classification_velocity_0.10", load(with_value(0.214, ""))).verdict,
            Verdict::not_decidable);
}

TEST_F(MeasuredFile, ComplainsWithFileAndLine) {
  const std::string unknown =
      complaint("[[measured]]\nmeasure = \"clasification_velocity/6in5W/0.10\"\nvalue = 1\nunit = \"m/s\"\n");
  EXPECT_NE(unknown.find("mine.toml:2: measure"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("classification_velocity/6in5W/0.10"), std::string::npos) << unknown;
  const std::string unit =
      complaint("[[measured]]\nmeasure = \"classification_velocity/6in5W/0.10\"\nvalue = 21.4\nunit = \"cm\"\n");
  EXPECT_NE(unit.find("mine.toml:4: unit"), std::string::npos) << unit;
  EXPECT_NE(unit.find("\"m/s\""), std::string::npos) << unit;
  EXPECT_NE(complaint(with_value(0.214) + with_value(0.214)).find("twice"), std::string::npos);
  EXPECT_NE(complaint(with_value(0.214) + "half_with = 1\n").find("half_with"), std::string::npos);
  EXPECT_NE(complaint("").find("no [[measured]]"), std::string::npos);
}

TEST_F(MeasuredFile, TakesAnyUnitOfItsKind) {
  const Measurements measured = load(
      "[[measured]]\nmeasure = \"classification_velocity/6in5W/0.10\"\nvalue = 21.4\nhalf_width = 0.4\n"
      "unit = \"cm/s\"\n");
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_NEAR(measured.begin()->second.value, 0.214, 1e-15);
  EXPECT_NEAR(measured.begin()->second.half_width, 0.004, 1e-15);
  EXPECT_EQ(measured.begin()->second.unit, "m/s");
}

TEST_F(MeasuredFile, ReadsBackWhatItWrites) {
  Measurements measured = load(with_value(0.214));
  measured.begin()->second.interval = {0.2, std::numeric_limits<double>::infinity()};
  const Measurements again = load(measured_text(measured));
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again.begin()->first, measured.begin()->first);
  EXPECT_EQ(again.begin()->second.value, measured.begin()->second.value);
  EXPECT_EQ(again.begin()->second.half_width, measured.begin()->second.half_width);
  EXPECT_EQ(again.begin()->second.interval, measured.begin()->second.interval);
}

// What the template prints is a file of the right form, with nothing measured; its measures are those of the claims.
TEST_F(MeasuredFile, TemplateIsAValidFile) {
  std::string text = measured_template(claims_);
  EXPECT_NE(complaint(text).find("no [[measured]] with a value"), std::string::npos);
  const auto place = text.find("value = nan", text.find("\"classification_velocity/6in5W/0.10\""));
  ASSERT_NE(place, std::string::npos);
  EXPECT_EQ(load(text.substr(0, place) + "value = 0.2" + text.substr(place + 11)).size(), 1U);
}

}  // namespace
}  // namespace slfb
