// A bed in a one-dimensional liquid that has come apart is told from one that is whole.
#include "solver/run/plugs.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace slfb::simulation {
namespace {

TEST(Plugs, AUniformBedIsOne) {
  std::vector<double> voidage(40, 0.55);
  voidage.resize(80, 1.0);
  voidage[40] = 0.8;  // its surface
  const Plugs plugs = find_plugs(voidage);
  EXPECT_LE(plugs.count, 1);
  EXPECT_TRUE(describe(plugs, 0.1).empty());
}

TEST(Plugs, WavesThatLeaveNoLayerHalfEmptyAreNone) {
  std::vector<double> voidage;
  for (int k = 0; k < 60; ++k) voidage.push_back(k % 6 < 3 ? 0.5 : 0.7);
  EXPECT_LE(find_plugs(voidage).count, 1);
}

TEST(Plugs, AreCountedBetweenEmptyLayers) {
  std::vector<double> voidage;
  for (int plug = 0; plug < 7; ++plug) voidage.insert(voidage.end(), {0.58, 0.62, 0.99});
  voidage.resize(60, 1.0);
  Plugs plugs = find_plugs(voidage);
  EXPECT_EQ(plugs.count, 7);
  EXPECT_DOUBLE_EQ(plugs.least, 0.58);
  EXPECT_DOUBLE_EQ(plugs.largest, 0.99);
  plugs.speed = 1e-10;
  EXPECT_NE(describe(plugs, 0.1).find("stand still"), std::string::npos);
  plugs.speed = 0.05;
  EXPECT_EQ(describe(plugs, 0.1).find("stand still"), std::string::npos);
  EXPECT_NE(describe(plugs, 0.1).find("7 plugs"), std::string::npos);
}

TEST(Plugs, AColumnWithoutSpheresHasNone) {
  EXPECT_EQ(find_plugs(std::vector<double>(10, 1.0)).count, 0);
  EXPECT_EQ(find_plugs(std::vector<double>{}).count, 0);
}

}  // namespace
}  // namespace slfb::simulation
