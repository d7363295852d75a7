// The designs over the choices that a source leaves open: balanced columns, readable names, errors that teach.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "experiments/readings/choices.hpp"
#include "experiments/readings/hadamard.hpp"
#include "solver/support/files.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::readings {
namespace {

constexpr const char* factors = R"(
[[factor]]
name = "start"
title = "start of the bed"
source = "not said"
[[factor.level]]
name = "lattice"
title = "from a lattice"
departs = "p. 1"
overrides = ["seed=1"]
[[factor.level]]
name = "random"
title = "at random"
overrides = ["seed=2"]

[[factor]]
name = "spring"
title = "spring"
source = "not said"
unit = "N/m"
[[factor.level]]
name = "hard"
title = "hard spring"
value = 10.0
overrides = ["contact.stiffness=10"]
[[factor.level]]
name = "soft-0.1"
title = "soft spring"
value = 0.1
overrides = ["contact.stiffness=0.1"]
[[factor.level]]
name = "softer"
title = "softer spring"
value = 0.01
overrides = ["contact.stiffness=0.01"]

[[factor]]
name = "wall"
title = "wall"
source = "not said"
[[factor.level]]
name = "rough"
title = "rough wall"
overrides = []
[[factor.level]]
name = "smooth"
title = "smooth wall"
overrides = ["wall.sliding_friction=0"]
)";

class ReadingDesigns : public testing::Test {
 protected:
  Choices load(const std::string& designs) {
    write_file(folder_.path() / "readings.toml", factors + designs);
    return load_choices(folder_.path() / "readings.toml");
  }

  std::set<std::string> names(const std::string& design) {
    const Choices choices = load("[designs.it]\n" + design);
    std::set<std::string> names;
    for (const Reading& reading : choices.design("it")) EXPECT_TRUE(names.insert(choices.name_of(reading)).second);
    return names;
  }

  std::string problem(const std::string& text) {
    try {
      load(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  Folder folder_;
};

TEST(Hadamard, RowsAndColumnsAreOrthogonal) {
  for (const std::size_t columns : {1U, 2U, 3U, 7U, 8U, 11U, 12U, 13U, 19U, 23U, 24U, 31U, 47U}) {
    const HadamardMatrix matrix = hadamard_matrix(columns);
    const std::size_t order = matrix.size();
    EXPECT_GE(order, columns);
    EXPECT_LE(order, columns + 4) << "orders that are multiples of 4 are all known up to here, but for 36 and 52";
    for (std::size_t i = 0; i < order; ++i) {
      EXPECT_EQ(matrix[i].size(), order);
      EXPECT_EQ(matrix[i].front(), 1);
      for (std::size_t j = 0; j < order; ++j) {
        int rows = 0, across = 0;
        for (std::size_t k = 0; k < order; ++k) {
          rows += matrix[i][k] * matrix[j][k];
          across += matrix[k][i] * matrix[k][j];
        }
        EXPECT_EQ(rows, i == j ? static_cast<int>(order) : 0);
        EXPECT_EQ(across, i == j ? static_cast<int>(order) : 0);
      }
    }
  }
  EXPECT_THROW(hadamard_matrix(0), std::invalid_argument);
  EXPECT_THROW(hadamard_matrix(257), std::invalid_argument);
}

TEST_F(ReadingDesigns, OneAtATimeChangesOneLevelOfTheBase) {
  EXPECT_EQ(names("kind = \"one-at-a-time\"\n"),
            (std::set<std::string>{"base", "random", "soft-0.1", "softer", "smooth"}));
  EXPECT_EQ(names("kind = \"one-at-a-time\"\nbase = [\"random\", \"softer\"]\nlevels = [\"smooth\", \"lattice\"]\n"),
            (std::set<std::string>{"random_softer", "random_softer_smooth", "softer"}));
}

TEST_F(ReadingDesigns, FullDesignHasEveryCombination) {
  EXPECT_EQ(names("kind = \"full\"\n").size(), 2U * 3U * 2U);
  EXPECT_EQ(names("kind = \"full\"\nlevels = [\"random\", \"smooth\"]\n"),
            (std::set<std::string>{"base", "random", "smooth", "random_smooth"}));
}

TEST_F(ReadingDesigns, TwoLevelDesignIsBalanced) {
  for (const bool folded : {false, true}) {
    const Choices choices = load(std::string("[designs.it]\nkind = \"two-level\"\nfolded = ") +
                                 (folded ? "true" : "false") + "\nlevels = [\"random\", \"softer\", \"smooth\"]\n");
    const auto& readings = choices.design("it");
    // Of four rows for three factors the mirror images are the other four of the eight combinations.
    EXPECT_EQ(readings.size(), folded ? 8U : 4U);
    for (std::size_t f = 0; f < 3; ++f)
      for (std::size_t g = 0; g < f; ++g)
        for (const bool first : {false, true})
          for (const bool second : {false, true})
            EXPECT_EQ(std::ranges::count_if(readings,
                                            [&](const Reading& reading) {
                                              return (reading[f] == 0) == first && (reading[g] == 0) == second;
                                            }),
                      folded ? 2 : 1);
  }
}

TEST_F(ReadingDesigns, NamesLeadBackToTheirReading) {
  const Choices choices = load("[designs.it]\nkind = \"full\"\n");
  for (const Reading& reading : choices.design("it"))
    EXPECT_EQ(choices.reading_named(choices.name_of(reading)), reading);
  for (const char* wrong : {"", "lattice", "smooth_random", "random_random", "steep", "random_"})
    EXPECT_THROW(static_cast<void>(choices.reading_named(wrong)), std::invalid_argument) << wrong;
}

TEST_F(ReadingDesigns, SayWhatTheySetAndWhereTheyDepart) {
  const Choices choices = load("");
  const Reading base = choices.reading_named("base"), other = choices.reading_named("random_soft-0.1");
  EXPECT_EQ(choices.overrides_of(base), (std::vector<std::string>{"seed=1", "contact.stiffness=10"}));
  EXPECT_EQ(choices.overrides_of(other), (std::vector<std::string>{"seed=2", "contact.stiffness=0.1"}));
  EXPECT_EQ(choices.departures_of(base).size(), 1U);
  EXPECT_EQ(choices.departures_of(base).front()->departs, "p. 1");
  EXPECT_TRUE(choices.departures_of(other).empty());
  EXPECT_EQ(choices.title_of(other), "at random, soft spring");
}

TEST_F(ReadingDesigns, WrongFilesAreExplained) {
  const auto has = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(problem(text).find(part), std::string::npos) << problem(text);
  };
  has("[designs.it]\nkind = \"guess\"\n", "kind: \"guess\" is no kind of design; allowed is one-at-a-time, full");
  has("[designs.it]\nkind = \"full\"\nlevels = [\"steep\"]\n", "levels: there is no level \"steep\"; known: lattice");
  has("[designs.it]\nkind = \"full\"\nbase = [\"hard\", \"softer\"]\n", "base: \"softer\" is a second level");
  has("[designs.it]\nkind = \"two-level\"\nlevels = [\"soft-0.1\", \"softer\"]\n", "\"spring\" has more");
  has("[designs.it]\nkind = \"one-at-a-time\"\nlevels = [\"hard\"]\n", "is a level of the base");
  has("[designs.it]\nkind = \"list\"\n", "readings: is empty");
  has("[designs.it]\nkind = \"list\"\nreading = []\n", "readings: is empty");
  has("[designs.it]\nkind = \"full\"\nfolded = true\n", "folded: is not a key that is read here");
  has("[[factor]]\nname = \"a\"\ntitle = \"a\"\nsource = \"\"\n", "level: a choice needs two levels or more");
  has("[[factor]]\nname = \"a\"\ntitle = \"a\"\nsource = \"\"\n[[factor.level]]\nname = \"rough\"\ntitle = \"\"\n",
      "is the name of another level too");
  has("[[factor]]\nname = \"a\"\ntitle = \"a\"\nsource = \"\"\n[[factor.level]]\nname = \"a_b\"\ntitle = \"\"\n",
      "\"a_b\" is no name of a level");
}

}  // namespace
}  // namespace slfb::readings
