// The lid-driven square cavity against the tables of Ghia, Ghia and Shin (1982).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "solver/fluid/three_dimensional_liquid.hpp"
#include "solver/support/folders.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

/// Position and velocity of one column of a table of reference-data/ghia_1982.
std::vector<std::array<double, 2>> profile_of(const std::string& table, int reynolds) {
  std::ifstream file(source_folder() / "reference-data/ghia_1982" / table);
  std::vector<std::array<double, 2>> profile;
  std::size_t column = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    if (column > 0) {
      profile.push_back({std::stod(fields[0]), std::stod(fields[column])});
      continue;
    }
    while (!fields.at(column).starts_with("velocity_re_" + std::to_string(reynolds) + " ")) ++column;
  }
  return profile;
}

/// Cubic through the four nearest of equally spaced values in the cell middles, with the values at both walls.
double interpolated(const std::vector<double>& middles, double start, double end, double at) {
  std::vector<double> x{0.0}, f{start};
  for (std::size_t i = 0; i < middles.size(); ++i) {
    x.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(middles.size()));
    f.push_back(middles[i]);
  }
  x.push_back(1.0);
  f.push_back(end);
  std::size_t first = 0;
  while (first + 4 < x.size() && x[first + 2] < at) ++first;
  double sum = 0.0;
  for (std::size_t i = first; i < first + 4; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < first + 4; ++j)
      if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
    sum += weight * f[i];
  }
  return sum;
}

/// A square of side 1 with a lid of speed 1, filled with liquid at one void fraction.
class Cavity {
 public:
  Cavity(int reynolds, int cells, double void_fraction, double pressure_tolerance)
      : cells_(cells), liquid_(scene_of(reynolds, cells, pressure_tolerance), true), exchange_(no_exchange(liquid_)) {
    for (double& speed : liquid_.end_velocity(0, 1)) speed = 1.0;
    volume_ = liquid_volumes(liquid_.grid(), [&](const Point&) { return void_fraction; });
  }

  void advance() { liquid_.advance(2.0 / cells_, volume_, volume_, exchange_); }

  /// Until nothing changes any more.
  void run_to_rest() {
    std::vector<double> before;
    double change = 1.0;
    for (int k = 0; k < 5000 && change > 1e-5; ++k) {
      before = liquid_.velocity(0);
      advance();
      change = 0.0;
      for (std::size_t n = 0; n < before.size(); ++n)
        change = std::max(change, std::abs(liquid_.velocity(0)[n] - before[n]));
    }
    ASSERT_LE(change, 1e-5);
  }

  [[nodiscard]] const fluid::ThreeDimensionalLiquid& liquid() const { return liquid_; }
  /// u on the vertical line through the centre, by height.
  [[nodiscard]] std::vector<double> vertical_line() const { return line(0, 0.0, 0); }
  /// w on the horizontal line through the centre, by distance.
  [[nodiscard]] std::vector<double> horizontal_line() const { return line(2, 0.5, 2); }

 private:
  static Scene scene_of(int reynolds, int cells, double pressure_tolerance) {
    Scene scene;
    scene.geometry.shape = Shape::box;
    scene.geometry.width = {1.0, 1.0 / cells};
    scene.geometry.height = 1.0;
    scene.liquid = {1.0, 1.0 / reynolds, 0.0};
    scene.fluid.cells_across = cells;
    scene.fluid.cell_height = 1.0 / cells;
    scene.fluid.pressure_tolerance = pressure_tolerance;
    return scene;
  }
  /// Nodes of a component whose coordinate `fixed` has a value; their numbers run along the other coordinate.
  [[nodiscard]] std::vector<double> line(std::size_t a, double at, std::size_t fixed) const {
    std::vector<double> values;
    for (std::size_t n = 0; n < liquid_.nodes(a); ++n)
      if (std::abs(liquid_.position(a, n)[fixed] - at) < 1e-9) values.push_back(liquid_.velocity(a)[n]);
    return values;
  }

  int cells_;
  fluid::ThreeDimensionalLiquid liquid_;
  fluid::Exchange exchange_;
  std::vector<double> volume_;
};

// QUICK. The bands are the errors of grids this coarse; they halve with 64 cells at Re 1000. At Re 100 it is the table
// of v that is off: by 0.009 near its minimum, from which no refinement brings a solution back to it.
TEST(LidDrivenCavity, AgreesWithTheTablesOfGhia) {
  struct Case {
    int reynolds, cells;
    double band;
  };
  for (const Case& c : {Case{100, 32, 0.010}, Case{400, 40, 0.012}, Case{1000, 48, 0.02}}) {
    Cavity cavity(c.reynolds, c.cells, 1.0, 1e-3);  // what one step leaves of the pressure, the next takes up
    cavity.run_to_rest();
    const auto u = cavity.vertical_line(), v = cavity.horizontal_line();
    ASSERT_EQ(u.size(), static_cast<std::size_t>(c.cells));
    ASSERT_EQ(v.size(), static_cast<std::size_t>(c.cells));
    const auto horizontal = profile_of("table1.csv", c.reynolds), vertical = profile_of("table2.csv", c.reynolds);
    ASSERT_EQ(horizontal.size(), 17u);
    ASSERT_EQ(vertical.size(), 17u);
    for (const auto& [height, expected] : horizontal)
      EXPECT_NEAR(interpolated(u, 0.0, 1.0, height), expected, c.band) << c.reynolds << ", height " << height;
    for (const auto& [distance, expected] : vertical) {
      if (c.reynolds == 400 && distance == 0.9063) continue;  // a misprint: reference-data/ghia_1982/source.toml
      EXPECT_NEAR(interpolated(v, 0.0, 0.0, distance), expected, c.band) << c.reynolds << ", distance " << distance;
    }
  }
}

// With a constant void fraction every term of Eq. 27 has the factor α: the flow is that of the plain liquid.
TEST(LidDrivenCavity, FlowsAlikeAtAnyConstantVoidFraction) {
  Cavity plain(400, 16, 1.0, 1e-12), averaged(400, 16, 0.45, 1e-12);
  for (int k = 0; k < 30; ++k) {
    plain.advance();
    averaged.advance();
  }
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}})
    for (std::size_t n = 0; n < plain.liquid().nodes(a); ++n)
      ASSERT_NEAR(plain.liquid().velocity(a)[n], averaged.liquid().velocity(a)[n], 1e-8);
}

}  // namespace
}  // namespace slfb
