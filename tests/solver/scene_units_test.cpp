#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "solver/scene/units.hpp"

namespace slfb::units {
namespace {

struct Reading {
  std::string text;
  Dimension dimension;
  double value;
};

std::ostream& operator<<(std::ostream& out, const Reading& reading) { return out << reading.text; }

class Quantity : public testing::TestWithParam<Reading> {};

// Equal to the last bit: a unit is wording, and wording must not change the name of a run.
TEST_P(Quantity, IsTheSameNumberAsInSi) {
  EXPECT_EQ(parse_quantity(GetParam().text, GetParam().dimension), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(Units, Quantity,
                         testing::Values(Reading{"50 mm", length, 0.05}, Reading{"7.14 mm", length, 0.00714},
                                         Reading{"50mm", length, 0.05}, Reading{"6.25 mm", length, 0.00625},
                                         Reading{" 1 in ", length, 0.0254}, Reading{"1.0 mPa s", viscosity, 1e-3},
                                         Reading{"1.8 mPa·s", viscosity, 1.8e-3},
                                         Reading{"0.01 poise", viscosity, 1e-3}, Reading{"998.2 kg/m3", density, 998.2},
                                         Reading{"998.2 kg/m³", density, 998.2}, Reading{"7.8 g/cm3", density, 7800.0},
                                         Reading{"1e4 N/m", stiffness, 1e4}, Reading{"10 kN/m", stiffness, 1e4},
                                         Reading{"5e-5 s", time, 5e-5}, Reading{"0.1 ms", time, 1e-4},
                                         Reading{"2 min", time, 120.0}, Reading{"6 cm/s", velocity, 0.06},
                                         Reading{"+6 cm/s", velocity, 0.06}, Reading{"525.5 g", mass, 0.5255},
                                         Reading{"5 deg", angle, 5.0}, Reading{"0.9", ratio, 0.9},
                                         Reading{"90 %", ratio, 0.9}));

class NotAQuantity : public testing::TestWithParam<Reading> {};

TEST_P(NotAQuantity, IsRejectedWithWhatIsNeeded) {
  try {
    parse_quantity(GetParam().text, GetParam().dimension);
    FAIL() << GetParam().text << " was read";
  } catch (const UnitError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(GetParam().dimension.name), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().dimension.example), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(Units, NotAQuantity,
                         testing::Values(Reading{"50", length, 0}, Reading{"", length, 0}, Reading{"mm", length, 0},
                                         Reading{"50 kg", length, 0}, Reading{"50 m2", length, 0},
                                         Reading{"1,5 mm", length, 0}, Reading{"1 000 mm", length, 0},
                                         Reading{"inf m", length, 0}, Reading{"nan m", length, 0},
                                         Reading{"1e999 m", length, 0}, Reading{"50 parsnips", length, 0},
                                         Reading{"20 Hz", time, 0},  // a reciprocal is another dimension
                                         Reading{"1 s since 2000-01-01", time, 0}, Reading{"1 mm2/s", viscosity, 0},
                                         Reading{"0.9 m", ratio, 0}, Reading{"1 degC", length, 0}));

TEST(Units, ADecimalCommaIsNamed) {
  for (const char* text : {"1,5 mm", "998,2"}) try {
      parse_quantity(text, length);
      FAIL() << text << " was read";
    } catch (const UnitError& error) {
      EXPECT_NE(std::string(error.what()).find("holds a comma"), std::string::npos) << error.what();
    }
}

TEST(Units, AreReadFromSeveralThreads) {
  std::vector<std::thread> threads;
  threads.reserve(4);
  std::vector<double> sums(4, 0.0);
  for (double& sum : sums) {
    threads.emplace_back([&sum] {
      for (int i = 0; i < 200; ++i) sum += parse_quantity("50 mm", length);
    });
  }
  for (auto& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_NEAR(sum, 10.0, 1e-12);
}

}  // namespace
}  // namespace slfb::units
