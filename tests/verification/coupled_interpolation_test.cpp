// What a sphere reads of the liquid: by the gradient of its cell (Peng 2014, Eqs. 30, 31), between eight cells, and by
// its shares; along every direction and obliquely.
#include <gtest/gtest.h>

#include <numbers>

#include "solver/coupling/point_values.hpp"
#include "tests/verification/coupled_cases.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

using coupling::CellValues;
using coupling::PointValues;

constexpr std::array all_interpolations{Interpolation::shares, Interpolation::gradient, Interpolation::trilinear};

/// Slopes of voidage and velocity, no two alike.
constexpr std::array<std::array<double, 3>, 4> slope{
    {{3.0, -5.0, 7.0}, {-11.0, 13.0, 2.0}, {17.0, 19.0, -23.0}, {29.0, -31.0, 37.0}}};

double linear(std::size_t field, const Point& x) {
  return 0.5 + slope[field][0] * x[0] + slope[field][1] * x[1] + slope[field][2] * x[2];
}

std::vector<CellValues> cells_of(const fluid::ColumnGrid& grid,
                                 const std::function<double(std::size_t, const Point&)>& value) {
  std::vector<CellValues> cells(grid.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t f = 0; f < 4; ++f) cells[c].value[f] = value(f, cell_position(grid, c));
  return cells;
}

Scene grid_scene(Shape shape, LateralBoundary wall) {
  Scene scene = periodic_box(0.06, 0.09, 8, 0.0);
  scene.geometry.shape = shape;
  scene.geometry.diameter = 0.06;
  scene.fluid.wall = wall;
  scene.fluid.cell_height = 0.005;  // not the width: the cells are no cubes
  return scene;
}

/// Points in the interior: two cells from every wall, any place in a cell.
std::vector<Point> interior_points() {
  std::vector<Point> points;
  for (int k = 0; k < 200; ++k) {
    const auto part = [&](double irrational) { return std::fmod(k * irrational, 1.0) - 0.5; };
    points.push_back(
        {0.02 * part(std::numbers::sqrt2), 0.02 * part(std::numbers::sqrt3), 0.045 + 0.06 * part(std::numbers::phi)});
  }
  return points;
}

// A linear field is its own interpolation, and its gradient that of any cell.
TEST(PointValues, LinearFieldsAreExactInTheInterior) {
  for (const Shape shape : {Shape::box, Shape::cylinder})
    for (const LateralBoundary wall : {LateralBoundary::no_slip, LateralBoundary::slip}) {
      const fluid::ColumnGrid grid(grid_scene(shape, wall));
      const auto cells = cells_of(grid, linear);
      for (const Interpolation scheme : {Interpolation::gradient, Interpolation::trilinear}) {
        const PointValues values(grid, scheme, wall == LateralBoundary::no_slip);
        for (const Point& x : interior_points()) {
          const auto at = values.at(x, cells);
          const auto gradient = values.gradient(x, cells);
          for (std::size_t f = 0; f < 4; ++f) {
            EXPECT_NEAR(at[f], linear(f, x), 1e-13);
            for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(gradient[f][a], slope[f][a], 1e-11);
          }
        }
      }
    }
}

// Smooth fields are read to second order in the cell: halved cells, a quarter of the error.
TEST(PointValues, SmoothFieldsConvergeInSecondOrder) {
  const auto wave = [](std::size_t f, const Point& x) {
    return std::sin(100.0 * x[0] + static_cast<double>(f)) * std::cos(80.0 * x[1]) * std::sin(90.0 * x[2]);
  };
  for (const Interpolation scheme : {Interpolation::gradient, Interpolation::trilinear}) {
    const auto error = [&](int refinement) {
      Scene scene = grid_scene(Shape::box, LateralBoundary::slip);
      scene.fluid.cells_across = 8 * refinement;
      scene.fluid.cell_height /= refinement;
      const fluid::ColumnGrid grid(scene);
      const auto cells = cells_of(grid, wave);
      const PointValues values(grid, scheme, false);
      double sum = 0.0;
      for (const Point& x : interior_points())
        for (std::size_t f = 0; f < 4; ++f) sum += std::pow(values.at(x, cells)[f] - wave(f, x), 2);
      return std::sqrt(sum);
    };
    EXPECT_NEAR(std::log2(error(2) / error(4)), 2.0, 0.25);
  }
}

// Across a periodic side the field goes on: the two sides of the seam read alike.
TEST(PointValues, GoOnAcrossAPeriodicSide) {
  const Scene scene = grid_scene(Shape::box, LateralBoundary::periodic);
  const fluid::ColumnGrid grid(scene);
  const double k = 2.0 * std::numbers::pi / 0.06;
  const auto cells = cells_of(
      grid, [&](std::size_t f, const Point& x) { return std::sin(k * (x[0] + 2.0 * x[1]) + static_cast<double>(f)); });
  for (const Interpolation scheme : {Interpolation::gradient, Interpolation::trilinear}) {
    const PointValues values(grid, scheme, false);
    for (const Point& x : interior_points())
      for (std::size_t f = 0; f < 4; ++f) {
        const double here = values.at(x, cells)[f];
        EXPECT_NEAR(values.at({x[0] + 0.06, x[1], x[2]}, cells)[f], here, 1e-12);
        EXPECT_NEAR(values.at({x[0], x[1] - 0.06, x[2]}, cells)[f], here, 1e-12);
      }
  }
}

// At a wall without slip the velocity goes to zero by the gradient scheme: Eq. 31's face value is that of the wall.
TEST(PointValues, GradientKnowsTheWall) {
  const fluid::ColumnGrid grid(grid_scene(Shape::box, LateralBoundary::no_slip));
  const auto cells = cells_of(grid, [](std::size_t, const Point&) { return 1.0; });
  const PointValues values(grid, Interpolation::gradient, true);
  const double width = grid.spacing(0);
  const auto slope_at = values.gradient({-0.03 + 0.5 * width, 0.0, 0.045}, cells);
  EXPECT_NEAR(slope_at[0][0], 0.0, 1e-12);
  for (std::size_t f = 1; f < 4; ++f) EXPECT_NEAR(slope_at[f][0], 1.0 / width, 1e-9);
}

// By shares a sphere reads the mean of cells, not a point: in a linear field the error depends on where in the cell it
// is, less than half a cell's difference, and is nothing on average and at the centre.
TEST(Shares, ReadALinearFieldOnAverage) {
  Scene scene = periodic_box(0.048, 0.06, 8, 0.0);
  const fluid::ColumnGrid grid(scene);
  const double width = grid.spacing(0), radius = 0.0025;
  coupling::VolumeShares shares(coupling::make_share_scheme(scene.coupling), grid, radius);
  for (std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    std::vector<double> field(grid.size());
    for (std::size_t c = 0; c < field.size(); ++c) field[c] = cell_position(grid, c)[axis];
    double mean = 0.0;
    constexpr int places = 64;
    for (int k = 0; k < places; ++k) {
      dem::Particles sphere;
      std::array<double, 3> at{0.3 * width, 0.2 * width, 0.03 + 0.1 * width};
      at[axis] = (axis == 2 ? 0.03 : 0.0) + (k + 0.5) / places * width;
      sphere.add(at, radius, 1.0, 0);
      shares.update(sphere, 1);
      const double error = shares.gather(0, field) - at[axis];
      EXPECT_LT(std::abs(error), 0.5 * width);
      mean += error / places;
    }
    EXPECT_NEAR(mean, 0.0, 1e-12 * width) << axis;
  }
}

// Spheres so small that the void fraction is even, in liquid that moves everywhere alike, over a step too short to
// change that.
TEST(ReadingTheLiquid, AUniformStreamIsReadExactlyAlongEveryDirection) {
  for (const Interpolation interpolation : all_interpolations)
    for (const Point& stream : {Point{0.1, 0, 0}, Point{0, 0.1, 0}, Point{0, 0, 0.1}, Point{0.06, -0.05, 0.07}}) {
      Scene scene = periodic_box(0.03, 0.06, 5, stream[2]);
      scene.coupling.interpolation = interpolation;
      scene.species.front().diameter = 1e-4;
      scene.fluid.time_step = scene.contact.time_step = 1e-9;
      CoupledCase bed(scene);
      for (int k = 0; k < 20; ++k)
        bed.add({0.01 * std::sin(k), 0.012 * std::cos(2.1 * k), 0.003 + 0.0027 * k}, {0.0, 0.0, 0.0});
      start_from(*bed.liquid,
                 {[&](const Point&) { return stream[0]; }, [&](const Point&) { return stream[1]; },
                  [&](const Point&) { return stream[2]; }},
                 [](const Point&) { return 0.0; });
      for (std::size_t a : {std::size_t{0}, std::size_t{1}})
        for (double& u : bed.liquid->end_velocity(a, 0)) u = stream[a];
      bed.exchange->advance(bed.engine, scene.fluid.time_step);
      for (std::size_t i = 0; i < bed.engine.particles.size(); ++i)
        for (std::size_t a = 0; a < 3; ++a)
          EXPECT_NEAR(bed.exchange->liquid_velocity(i, a), stream[a], 1e-5 * 0.1)
              << static_cast<int>(interpolation) << ", " << i;
    }
}

// One sphere in the middle of a cell moves through liquid at rest: whichever way it goes, the force opposes it and is
// as large. Along x and y the box is the same, along z its ends are ten cells away.
TEST(ReadingTheLiquid, DragIsTheSameAlongEveryDirectionAndObliquely) {
  for (const Interpolation interpolation : all_interpolations)
    for (const MomentumExchange scheme : {MomentumExchange::explicit_in_time, MomentumExchange::semi_implicit}) {
      const auto drag = [&](const Point& velocity) {
        Scene scene = periodic_box(0.056, 0.168, 7, 0.0);
        scene.coupling.interpolation = interpolation;
        scene.coupling.exchange = scheme;
        scene.liquid.viscosity = 0.01;
        CoupledCase bed(scene);
        bed.add({0.0, 0.0, 0.084 + 0.004}, velocity);
        bed.engine.particles.mass[0] = scene.liquid.density * bed.engine.particles.volume(0);  // no weight
        bed.step();
        return Point{bed.exchange->drag_force(0, 0), bed.exchange->drag_force(0, 1), bed.exchange->drag_force(0, 2)};
      };
      const double size = -drag({0.1, 0, 0})[0];
      ASSERT_GT(size, 0.0);
      const double third = 0.1 / std::numbers::sqrt3;
      for (const Point& velocity : {Point{0.1, 0, 0}, Point{0, 0.1, 0}, Point{0, 0, 0.1}, Point{-0.1, 0, 0},
                                    Point{0, 0, -0.1}, Point{0.06, 0.08, 0}, Point{third, -third, third}}) {
        const auto force = drag(velocity);
        for (std::size_t a = 0; a < 3; ++a)
          EXPECT_NEAR(force[a], -velocity[a] / 0.1 * size, 1e-3 * size)
              << static_cast<int>(interpolation) << ": " << velocity[0] << ", " << velocity[1] << ", " << velocity[2];
      }
    }
}

}  // namespace
}  // namespace slfb
