// The two commands that show the catalogue of laws.

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "correlations/catalogue.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/laws.hpp"

namespace slfb {
namespace {

using nlohmann::json;

// Runs a command line as the binary would and returns what it writes.
std::string run(const std::vector<std::string>& words) {
  CLI::App app{"slfb"};
  add_laws_command(app);
  add_law_command(app);
  testing::internal::CaptureStdout();
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the words last first
  } catch (...) {
    testing::internal::GetCapturedStdout();
    throw;
  }
  return testing::internal::GetCapturedStdout();
}

std::string error_of(const std::vector<std::string>& words) {
  try {
    run(words);
  } catch (const CLI::ValidationError& error) {
    return error.what();
  }
  return "";
}

TEST(LawsCommand, WritesTheFixedJsonShape) {
  const json answer = json::parse(run({"laws", "--json"}));
  ASSERT_EQ(answer.at("laws").size(), catalogue().size());
  for (const json& law : answer.at("laws")) {
    for (const char* key : {"name", "kind", "source", "title", "equation", "convention", "confidence", "note"}) {
      EXPECT_TRUE(law.at(key).is_string()) << law;
    }
    EXPECT_EQ(law.at("range").at("reynolds").size(), 2u);
    EXPECT_EQ(law.at("range").at("voidage").size(), 2u);
  }
}

TEST(LawsCommand, WritesAnOpenRangeAsNull) {
  const json answer = json::parse(run({"laws", "--json", "--kind", "classification"}));
  EXPECT_TRUE(answer.at("laws").at(0).at("range").at("reynolds").at(1).is_null());
}

TEST(LawsCommand, ShowsOneKind) {
  const std::string table = run({"laws", "--kind", "drag"});
  EXPECT_NE(table.find("di-felice-1994"), std::string::npos);
  EXPECT_EQ(table.find("peng-2014"), std::string::npos);
  EXPECT_NE(error_of({"laws", "--kind", "dragg"}).find("single-sphere-drag"), std::string::npos);
}

TEST(LawCommand, WritesTheFixedJsonShape) {
  const json answer = json::parse(run({"law", "gidaspow-1994", "--voidage", "0.5", "--re", "499.1", "--json"}));
  EXPECT_EQ(answer.at("law"), "gidaspow-1994");
  EXPECT_EQ(answer.at("voidage"), 0.5);
  EXPECT_EQ(answer.at("re"), 499.1);
  EXPECT_EQ(answer.at("in_range"), true);
  // Water, 5 mm, w = 0.2 m/s: 3000 + 34937 = 37937 kg/(m³ s), which over 18·1e-3·0.5·0.5/2.5e-5 = 180 is 210.76.
  EXPECT_NEAR(answer.at("beta").get<double>(), 37937.0, 0.5);
  EXPECT_NEAR(answer.at("dimensionless_drag").get<double>(), 210.76, 0.01);
  EXPECT_NEAR(answer.at("slip_velocity").get<double>(), 0.2, 1e-9);
  EXPECT_EQ(answer.at("units").at("beta"), "kg/(m3 s)");
  EXPECT_EQ(answer.at("units").at("slip_velocity"), "m/s");
}

TEST(LawCommand, AnswersOutsideTheRangeAndSaysSo) {
  const json answer = json::parse(run({"law", "tenneti-2011", "--voidage", "0.45", "--re", "2000", "--json"}));
  EXPECT_EQ(answer.at("in_range"), false);
  EXPECT_GT(answer.at("dimensionless_drag").get<double>(), 0.0);
  EXPECT_NE(run({"law", "tenneti-2011", "--voidage", "0.45", "--re", "2000"}).find("OUTSIDE"), std::string::npos);
}

TEST(LawCommand, TakesAndRefusesTheLimitsOfItsArguments) {
  EXPECT_NO_THROW(run({"law", "ergun-1952", "--voidage", "1", "--re", "0", "--json"}));
  const std::string too_large = error_of({"law", "ergun-1952", "--voidage", "1.2", "--re", "1"});
  EXPECT_NE(too_large.find("1.2"), std::string::npos);
  EXPECT_NE(too_large.find("0 < voidage <= 1"), std::string::npos);
  EXPECT_NE(error_of({"law", "ergun-1952", "--voidage", "0", "--re", "1"}), "");
  EXPECT_NE(error_of({"law", "ergun-1952", "--voidage", "nan", "--re", "1"}), "");
  EXPECT_NE(error_of({"law", "ergun-1952", "--voidage", "0.5", "--re", "inf"}), "");
  EXPECT_NE(error_of({"law", "ergun-1952", "--voidage", "0.5", "--re", "-3"}).find("-3"), std::string::npos);
}

TEST(LawCommand, NamesWhatIsMissingOrUnknown) {
  EXPECT_NE(error_of({"law", "ergun-1952", "--voidage", "0.5"}).find("needs --re"), std::string::npos);
  EXPECT_NE(error_of({"law", "peng-2014", "--re", "5"}).find("does not take --re"), std::string::npos);
  const std::string unknown = error_of({"law", "gidaspov", "--voidage", "0.5", "--re", "1"});
  EXPECT_NE(unknown.find("gidaspov"), std::string::npos);
  EXPECT_NE(unknown.find("gidaspow-1994"), std::string::npos);
  // Arguments for which the law has no solution are an error that says why.
  EXPECT_NE(error_of({"law", "di-felice-1991", "--superficial-velocity", "3"}).find("pseudo-fluid"), std::string::npos);
}

TEST(LawCommand, GivesTheDerivativeOfTheDragWithRespectToTheSlip) {
  // Ergun, e = 0.5, Re = 100, 5 mm in water: 3 pi 1e-3·5e-3·0.5·94.444 = 2.2253e-3 N s/m.
  const json answer = json::parse(run({"law", "ergun-1952", "--voidage", "0.5", "--re", "100", "--json"}));
  EXPECT_NEAR(answer.at("drag_force_per_slip").get<double>(), 2.2253e-3, 6e-8);
  EXPECT_EQ(answer.at("units").at("drag_force_per_slip"), "N s/m");
}

// By hand: (180 · 0.5 + 1.8 · 100)/(18 · 0.25) = 60.
TEST(LawCommand, TakesOtherConstants) {
  const auto answer =
      json::parse(run({"law", "ergun-1952:viscous=180,inertial=1.8", "--voidage", "0.5", "--re", "100", "--json"}));
  EXPECT_NEAR(answer.at("dimensionless_drag").get<double>(), 60.0, 1e-12);
  EXPECT_NE(run({"law", "ergun-1952", "--voidage", "0.5", "--re", "1"}).find("viscous (0 to 1000, 150 of the source)"),
            std::string::npos);
  EXPECT_NE(error_of({"law", "ergun-1952:viscos=180", "--voidage", "0.5", "--re", "1"}).find("viscous"),
            std::string::npos);
}

TEST(LawCommand, TheAssumedTransitionIsAnArgument) {
  const auto force = [](const char* transition) {
    return json::parse(run({"law", "grbavcic-2009-force", "--transition", transition, "--json"}));
  };
  EXPECT_EQ(force("1").at("force_over_weight"), 0.0);
  EXPECT_EQ(force("0").at("force_over_weight"), force("0.3").at("force_over_weight_upper"));
  EXPECT_NE(error_of({"law", "grbavcic-2009-force", "--transition", "1.5"}).find("0 <= transition <= 1"),
            std::string::npos);
  EXPECT_NE(error_of({"law", "van-der-wielen-1996", "--transition", "0.3"}).find("does not take"), std::string::npos);
}

// Ergun's range ends on both sides inside the picture; what lies between is no part of the line outside it.
TEST(LawCommand, TheLineOutsideTheRangeIsBrokenByTheRange) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "slfb-law-gap";
  std::filesystem::create_directories(folder);
  run({"law", "ergun-1952", "--voidage", "0.45", "--plot", (folder / "ergun.svg").string()});
  std::ifstream stream(folder / "ergun.svg");
  const std::string picture{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t dashes = picture.rfind("stroke-dasharray"), path = picture.find("d='", dashes);
  ASSERT_NE(dashes, std::string::npos);
  const std::string line = picture.substr(path, picture.find("'/>", path) - path);
  EXPECT_EQ(std::ranges::count(line, 'M'), 3) << line;  // begins in the key, and on either side of the range
  std::filesystem::remove_all(folder);
}

TEST(LawCommand, DrawsALawAndAFamily) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "slfb-law-plots";
  std::filesystem::create_directories(folder);
  run({"law", "tenneti-2011", "--voidage", "0.6", "--plot", (folder / "one.svg").string()});
  run({"laws", "--kind", "radial-distribution", "--plot", (folder / "all.pdf").string()});
  for (const char* name : {"one.svg", "one.csv", "one.gp", "all.pdf", "all.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  EXPECT_NE(error_of({"law", "tenneti-2011", "--plot", (folder / "one.jpg").string()}).find(".svg"), std::string::npos);
  EXPECT_NE(error_of({"law", "tenneti-2011", "--plot", (folder / "none" / "a.svg").string()}).find("no folder"),
            std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(LawCommand, WritesCsv) {
  const std::string csv = run({"law", "doroodchi-2012-minimum-fluidisation", "--voidage", "0.4", "--csv"});
  EXPECT_EQ(csv.find("quantity,value,unit\nvoidage,0.4,1\n"), 0u);
  EXPECT_NE(csv.find("\nminimum_fluidisation_velocity,0.0423"), std::string::npos);
  EXPECT_NE(csv.find("\nin_range,1,1\n"), std::string::npos);
}

TEST(LawCommand, AnswersForEveryLaw) {
  for (const CatalogueEntry& entry : catalogue()) {
    std::vector<std::string> words{"law", std::string(entry.info.name), "--json"};
    for (const Argument* argument : arguments_of(entry)) {
      if (argument->name == "voidage") words.insert(words.end(), {"--voidage", "0.5"});
      if (argument->name == "re") words.insert(words.end(), {"--re", "100"});
    }
    EXPECT_EQ(json::parse(run(words)).at("law"), entry.info.name);
  }
}

}  // namespace
}  // namespace slfb
