// The catalogue of laws.

#include "correlations/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "correlations/drag/drag_laws.hpp"

namespace slfb {
namespace {

TEST(Catalogue, EveryLawIsDescribedAndNamedOnce) {
  std::set<std::string_view> names;
  for (const CatalogueEntry& entry : catalogue()) {
    const LawInfo& info = entry.info;
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " is there twice";
    EXPECT_EQ(info.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos);
    EXPECT_FALSE(info.title.empty() || info.equation.empty() || info.convention.empty()) << info.name;
    EXPECT_LE(info.reynolds.lower, info.reynolds.upper) << info.name;
    EXPECT_LE(info.voidage.lower, info.voidage.upper) << info.name;
    EXPECT_EQ(&find_law(info.name), &entry);
  }
}

TEST(Catalogue, HoldsEveryDragLaw) {
  for_each_law<drag::DragLaws>([](const auto& law) { EXPECT_EQ(find_law(law.info.name).info.kind, LawKind::drag); });
}

TEST(Catalogue, EverySourceIsInTheBibliography) {
  std::ifstream file(SLFB_SOURCE_DIR "/reference-data/references.bib");
  ASSERT_TRUE(file);
  const std::string bibliography{std::istreambuf_iterator<char>(file), {}};
  for (const CatalogueEntry& entry : catalogue()) {
    std::string key = "{";
    key.append(entry.info.source).append(",");
    EXPECT_NE(bibliography.find(key), std::string::npos) << entry.info.name << " cites " << entry.info.source;
  }
}

TEST(Catalogue, EveryLawAnswersTheDefaultArgumentsWithFiniteNumbers) {
  for (const CatalogueEntry& entry : catalogue()) {
    const LawAnswer evaluation = entry.evaluate(LawArguments{});
    EXPECT_FALSE(evaluation.quantities.empty()) << entry.info.name;
    for (const LawValue& quantity : evaluation.quantities) {
      EXPECT_TRUE(std::isfinite(quantity.value)) << entry.info.name << ": " << quantity.name;
    }
  }
}

TEST(Catalogue, ReconstructionsSaySo) {
  EXPECT_EQ(find_law("joshi-1983-reconstruction").info.confidence, Confidence::reconstructed);
  EXPECT_NE(find_law("joshi-1983-reconstruction").info.title.find("reconstruction"), std::string_view::npos);
}

TEST(Catalogue, AVariantHasTheKindOfTheLawItVaries) {
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.info.variant_of.empty()) continue;
    const LawInfo& law = find_law(entry.info.variant_of).info;
    EXPECT_EQ(law.kind, entry.info.kind) << entry.info.name;
    EXPECT_TRUE(law.variant_of.empty()) << entry.info.name << " varies a variant";
  }
  EXPECT_EQ(variants_of("tenneti-2011").size(), 2u);
}

TEST(Catalogue, FlagsWhatLiesOutsideAnyOfTheRanges) {
  const auto flagged = [](std::string_view name, const LawArguments& arguments) {
    const CatalogueEntry& entry = find_law(name);
    return !in_range(entry.info, arguments, entry.evaluate(arguments));
  };
  EXPECT_FALSE(flagged("peng-2014", {}));
  EXPECT_TRUE(flagged("peng-2014", {.voidage = 0.40}));
  EXPECT_TRUE(flagged("peng-2014", {.foreign_diameter = 11e-3}));  // d2/d1 = 2.2
  EXPECT_TRUE(flagged("peng-2014", {.foreign_density = 2230.0}));  // glass: St_p = 47
  EXPECT_TRUE(flagged("richardson-zaki-1954", {}));                // d/D = 0.1
  EXPECT_FALSE(flagged("richardson-zaki-1954", {.column_diameter = 0.2}));
  EXPECT_TRUE(flagged("tenneti-2011", {.voidage = 0.7, .reynolds = 301.0}));
}

// By hand: Ergun with 180 and 1.8 at voidage 0.5 and Re 100 is (180 · 0.5 + 1.8 · 100)/(18 · 0.25) = 60.
TEST(LawParameters, TakeThePlaceOfTheConstantsOfTheSource) {
  const LawArguments state{.voidage = 0.5, .reynolds = 100.0};
  const auto drag = [&](std::string_view law) { return find_law(law).evaluate(state).at("dimensionless_drag").value; };
  EXPECT_NEAR(drag("ergun-1952:viscous=180,inertial=1.8"), 60.0, 1e-12);
  EXPECT_EQ(drag("ergun-1952:viscous=150"), drag("ergun-1952"));
  EXPECT_EQ(drag("gidaspow-1994:switch_voidage=0.4"), drag("wen-yu-1966"));
  EXPECT_EQ(drag("gidaspow-1994:switch_voidage=0.4,exponent=4"), drag("wen-yu-1966:exponent=4"));
  EXPECT_NEAR(drag("wen-yu-1966:exponent=4.65") / drag("wen-yu-1966"), 2.0, 1e-12);
  EXPECT_NEAR(drag("di-felice-1994:limit=4.7") / drag("di-felice-1994"), 2.0, 1e-12);
  EXPECT_EQ(find_law("ergun-1952:viscous=180,inertial=1.8").info.name, "ergun-1952:viscous=180:inertial=1.8");
  EXPECT_EQ(find_law("richardson-zaki-1954:n=2.4").evaluate(state).at("expansion_exponent").value, 2.4);
}

TEST(LawParameters, AreChecked) {
  const auto complaint = [](std::string_view law) -> std::string {
    try {
      find_law(law);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  const auto expect = [&](std::string_view law, std::string_view part) {
    EXPECT_NE(complaint(law).find(part), std::string::npos) << complaint(law);
  };
  expect("ergun-1952:viscosity=180", "viscosity is none of its parameters; allowed are viscous (0 to 1000, 150 of");
  expect("ergun-1952:viscous=-1", "viscous is outside of its range");
  expect("ergun-1952:viscous=nan", "viscous is outside of its range");
  expect("ergun-1952:viscous=a", "KEY=NUMBER");
  expect("ergun-1952:viscous=1,viscous=2", "viscous twice");
  expect("rong-2013:n=1", "has no parameters");
  expect("ergun:viscous=1", "unknown law \"ergun\"; known: ergun-1952");
}

TEST(LawParameters, AListOfLawsIsSplitBetweenLaws) {
  EXPECT_EQ(split_laws("a,b:x=1,y=2,c.cpp:z=3"), (std::vector<std::string>{"a", "b:x=1,y=2", "c.cpp:z=3"}));
  EXPECT_EQ(split_laws("a"), std::vector<std::string>{"a"});
  EXPECT_EQ(parse_law_call("b:x=1:y=2").values, parse_law_call("b:x=1,y=2").values);
}

// Every family is drawn over arguments that its laws can answer.
TEST(Catalogue, EveryLawAnswersAlongItsSweep) {
  for (const CatalogueEntry& entry : catalogue()) {
    const Sweep& sweep = sweep_of(entry.info.kind);
    for (const double part : {0.01, 0.5, 0.99}) {
      const LawArguments arguments = sweep.at({}, sweep.lower + part * (sweep.upper - sweep.lower));
      EXPECT_TRUE(std::isfinite(entry.evaluate(arguments).at(sweep.quantity).value)) << entry.info.name;
    }
  }
}

TEST(Catalogue, NamesTheQuantitiesItKnows) {
  try {
    static_cast<void>(find_law("ergun-1952").evaluate({}).at("betta"));
    FAIL() << "an unknown quantity was answered";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("dimensionless_drag"), std::string::npos);
  }
}

}  // namespace
}  // namespace slfb
