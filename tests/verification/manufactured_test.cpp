// Manufactured solutions of the averaged equations with a void fraction that varies in space and time (Roache 2002,
// J. Fluids Eng. 124, 4): the exact fields fulfil Eq. 26 by construction, and Eq. 27 with the source that they leave.
#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double density = 1.3, viscosity = 0.05, inflow = 1.0;  // Re about 20 to 30 on the width 1
constexpr double frequency = 3.0;

/// sin⁴(πz), its slope and its integral: at the inlet and the outlet the void fraction is uniform and the velocity
/// has no gradient along z, as the solver's end conditions want it.
double bump(double z) { return std::pow(std::sin(pi * z), 4); }
double bump_slope(double z) { return 4.0 * pi * std::pow(std::sin(pi * z), 3) * std::cos(pi * z); }
double bump_integral(double z) {
  return 0.375 * z - std::sin(2.0 * pi * z) / (4.0 * pi) + std::sin(4.0 * pi * z) / (32.0 * pi);
}

/// α, the superficial velocity α u with ∂α/∂t + ∇·(α u) = 0, and p with p = 0 at the outlet z = 1.
struct Solution {
  virtual ~Solution() = default;
  [[nodiscard]] virtual double void_fraction(const Point& x, double t) const = 0;
  [[nodiscard]] virtual Point superficial(const Point& x, double t) const = 0;
  [[nodiscard]] double pressure(const Point& x, double t) const {
    return 2.0 * std::cos(0.5 * pi * x[2]) * (1.0 + 0.5 * std::sin(2.0 * pi * x[0]) * std::cos(frequency * t));
  }
  [[nodiscard]] double velocity(std::size_t a, const Point& x, double t) const {
    return superficial(x, t)[a] / void_fraction(x, t);
  }
};

/// Plane flow over the width 1: plug flow between periodic sides, or no slip at both walls.
struct PlaneSolution : Solution {
  explicit PlaneSolution(bool walls) : walls_(walls) {}
  [[nodiscard]] double void_fraction(const Point& x, double t) const override {
    return 0.6 + 0.15 * shape(x[0]) * bump(x[2]) * std::cos(frequency * t);
  }
  // Stream function ψ with α u = −∂ψ/∂z and α w = ∂ψ/∂x, and a part of α w that pays for ∂α/∂t.
  [[nodiscard]] Point superficial(const Point& x, double t) const override {
    const double turn = 0.15 * std::sin(frequency * t + 1.0);
    const double profile = walls_ ? 1.0 + std::cos(2.0 * pi * x[0]) : 1.0;
    const double displaced = 0.15 * shape(x[0]) * bump_integral(x[2]) * frequency * std::sin(frequency * t);
    return {-turn * shape(x[0]) * bump_slope(x[2]), 0.0,
            inflow * profile + turn * shape_slope(x[0]) * bump(x[2]) + displaced};
  }

 private:
  static double shape(double x) { return std::pow(std::cos(pi * x), 2) * (1.0 + 0.5 * std::sin(2.0 * pi * x)); }
  static double shape_slope(double x) {
    return -pi * std::sin(2.0 * pi * x) * (1.0 + 0.5 * std::sin(2.0 * pi * x)) +
           pi * std::pow(std::cos(pi * x), 2) * std::cos(2.0 * pi * x);
  }
  bool walls_;
};

/// Flow in a round column of diameter 1 without slip: a parabola, a swirl off the axis and a meridional roll.
struct PipeSolution : Solution {
  [[nodiscard]] double void_fraction(const Point& x, double t) const override {
    return 0.6 + 0.15 * lobe(x) * bump(x[2]) * std::cos(frequency * t);
  }
  [[nodiscard]] Point superficial(const Point& x, double t) const override {
    const double s = inside(x), turn = std::sin(frequency * t + 1.0), swirl = 0.4 * turn, roll = 0.1 * turn;
    const double r2 = x[0] * x[0] + x[1] * x[1], h = bump(x[2]), slope = bump_slope(x[2]);
    const double displaced = 0.15 * lobe(x) * bump_integral(x[2]) * frequency * std::sin(frequency * t);
    return {-16.0 * swirl * s * x[1] * (1.0 + x[0]) * h - roll * x[0] * s * s * slope,
            swirl * (16.0 * s * x[0] * (1.0 + x[0]) - s * s) * h - roll * x[1] * s * s * slope,
            2.0 * inflow * s + roll * h * (2.0 * s * s - 16.0 * s * r2) + displaced};
  }

 private:
  static double inside(const Point& x) { return 1.0 - 4.0 * (x[0] * x[0] + x[1] * x[1]); }
  static double lobe(const Point& x) { return std::pow(inside(x), 2) * (1.0 + x[1]); }
};

Point moved(Point x, std::size_t axis, double by) {
  x[axis] += by;
  return x;
}

/// Derivatives by central differences; what they leave (1e-6 of the value) is far below the solver's error.
constexpr double step = 1e-4;
template <class Function>
double derivative(const Function& f, const Point& x, std::size_t axis) {
  return (f(moved(x, axis, step)) - f(moved(x, axis, -step))) / (2.0 * step);
}
template <class Function>
double second_derivative(const Function& f, const Point& x, std::size_t axis) {
  return (f(moved(x, axis, step)) - 2.0 * f(x) + f(moved(x, axis, -step))) / (step * step);
}

/// ∇·τ of Eq. 21 in component a, as ∂_b of μ (∂_b u_a + ∂_a u_b − ⅔ δ_ab ∇·u) [N/m³].
double viscous_force(const Solution& exact, std::size_t a, const Point& x, double t) {
  double sum = 0.0;
  for (std::size_t b = 0; b < 3; ++b) {
    sum += second_derivative([&](const Point& y) { return exact.velocity(a, y, t); }, x, b);
    // ∂_a ∂_b u_b occurs once in the transposed part and with −⅔ in the isotropic one.
    const auto u_b = [&](const Point& y) { return exact.velocity(b, y, t); };
    sum += (1.0 - 2.0 / 3.0) * (a == b ? second_derivative(u_b, x, a)
                                       : derivative([&](const Point& y) { return derivative(u_b, y, b); }, x, a));
  }
  return viscosity * sum;
}

/// What Eq. 27 lacks for the exact fields: α ρ (∂u/∂t + u·∇u) + α ∇p − α ∇·τ [N/m³].
double momentum_source(const Solution& exact, std::size_t a, const Point& x, double t) {
  double acceleration = (exact.velocity(a, x, t + step) - exact.velocity(a, x, t - step)) / (2.0 * step);
  for (std::size_t b = 0; b < 3; ++b)
    acceleration += exact.velocity(b, x, t) * derivative([&](const Point& y) { return exact.velocity(a, y, t); }, x, b);
  const double gradient = derivative([&](const Point& y) { return exact.pressure(y, t); }, x, a);
  return exact.void_fraction(x, t) * (density * acceleration + gradient - viscous_force(exact, a, x, t));
}

/// Runs the solver on the exact solution's scene.
class Manufactured {
 public:
  Manufactured(const Scene& scene, const Solution& exact) : exact_(exact), owner_(solved_liquid(scene)) {
    for (std::size_t s = 0; s < liquid_.end_velocity(2, 0).size(); ++s) {
      const auto levels = static_cast<std::size_t>(liquid_.grid().layers() + 1);
      liquid_.end_velocity(2, 0)[s] = exact_.superficial(liquid_.position(2, s * levels), 0.0)[2];
    }
    start_from(liquid_, velocities(0.0), [&](const Point& x) { return exact_.pressure(x, 0.0); });
  }

  void run(double duration, int steps) {
    auto exchange = no_exchange(liquid_);
    std::array<std::vector<double>, 3> volume;
    for (std::size_t a = 0; a < 3; ++a) volume[a] = node_volumes(liquid_, a);
    const auto liquid_at = [&](double t) {
      return liquid_volumes(liquid_.grid(), [&](const Point& x) { return exact_.void_fraction(x, t); });
    };
    auto before = liquid_at(0.0);
    for (int k = 1; k <= steps; ++k) {
      time_ = duration * k / steps;
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t n = 0; n < volume[a].size(); ++n)
          if (volume[a][n] > 0.0)
            exchange.source[a][n] = volume[a][n] * momentum_source(exact_, a, liquid_.position(a, n), time_);
      auto now = liquid_at(time_);
      liquid_.advance(duration / steps, before, now, exchange);
      before = std::move(now);
    }
  }

  [[nodiscard]] const std::vector<double>& velocity(std::size_t a) const { return liquid_.velocity(a); }
  /// Error of all velocity components together, within a radius.
  [[nodiscard]] Norms velocity_error(double radius = 1.0) const {
    Norms sum;
    const auto exact = velocities(time_);
    for (std::size_t a = 0; a < 3; ++a) {
      if (liquid_.nodes(a) == 0) continue;
      const Norms part = error_of(liquid_, a, liquid_.velocity(a), exact[a], radius);
      sum.l1 += part.l1;
      sum.l2 += part.l2 * part.l2;
    }
    return {sum.l1, std::sqrt(sum.l2)};
  }
  [[nodiscard]] double pressure_error() const {
    const auto volume = cell_volumes(liquid_.grid());
    double sum = 0.0, total = 0.0;
    for (std::size_t c = 0; c < volume.size(); ++c) {
      const double error = liquid_.pressure()[c] - exact_.pressure(cell_position(liquid_.grid(), c), time_);
      sum += volume[c] * error * error;
      total += volume[c];
    }
    return std::sqrt(sum / total);
  }
  /// Error of the force that the spheres feel by ∇·τ.
  [[nodiscard]] double viscous_error(std::size_t a) const {
    return error_of(liquid_, a, liquid_.viscous_force(a),
                    [&](const Point& x) { return viscous_force(exact_, a, x, time_); })
        .l2;
  }

 private:
  [[nodiscard]] std::array<Field, 3> velocities(double t) const {
    std::array<Field, 3> result;
    for (std::size_t a = 0; a < 3; ++a) result[a] = [this, a, t](const Point& x) { return exact_.velocity(a, x, t); };
    return result;
  }

  const Solution& exact_;
  std::unique_ptr<fluid::StaggeredLiquid> owner_;
  fluid::StaggeredLiquid& liquid_ = *owner_;
  double time_ = 0.0;
};

constexpr double duration = 0.25;

Scene scene_of(int cells, LateralBoundary wall, ConvectionScheme convection) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {1.0, 1.0 / cells};
  scene.geometry.height = 1.0;
  scene.liquid = {density, viscosity, inflow};
  scene.fluid.wall = wall;
  scene.fluid.cells_across = cells;
  scene.fluid.cell_height = 1.0 / cells;
  scene.fluid.convection = convection;
  scene.fluid.time_scheme = TimeScheme::second_order;
  scene.fluid.pressure_tolerance = 1e-8;
  return scene;
}

Scene pipe_scene(int cells) {
  Scene scene = scene_of(cells, LateralBoundary::no_slip, ConvectionScheme::quick);
  scene.geometry.shape = Shape::cylinder;
  scene.geometry.diameter = 1.0;
  return scene;
}

class ManufacturedPlane : public testing::TestWithParam<LateralBoundary> {
 protected:
  /// Orders between 20 and 40 cells, time step in proportion.
  void measure(ConvectionScheme convection, PressureVelocity pressure_velocity = PressureVelocity::projection) {
    const PlaneSolution exact(GetParam() == LateralBoundary::no_slip);
    std::array<Norms, 2> velocity;
    std::array<double, 2> pressure{}, viscous{};
    for (std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const int cells = i == 0 ? 20 : 40;
      Scene scene = scene_of(cells, GetParam(), convection);
      scene.fluid.pressure_velocity = pressure_velocity;
      Manufactured run(scene, exact);
      run.run(duration, cells / 2);
      velocity[i] = run.velocity_error();
      pressure[i] = run.pressure_error();
      viscous[i] = std::hypot(run.viscous_error(0), run.viscous_error(2));
    }
    l1_ = order(velocity[0].l1, velocity[1].l1, 20, 40);
    l2_ = order(velocity[0].l2, velocity[1].l2, 20, 40);
    pressure_ = order(pressure[0], pressure[1], 20, 40);
    viscous_ = order(viscous[0], viscous[1], 20, 40);
    RecordProperty("order_l1", std::to_string(l1_));
    RecordProperty("order_l2", std::to_string(l2_));
    RecordProperty("order_pressure", std::to_string(pressure_));
    RecordProperty("order_viscous", std::to_string(viscous_));
  }
  double l1_ = 0.0, l2_ = 0.0, pressure_ = 0.0, viscous_ = 0.0;
};

TEST_P(ManufacturedPlane, UpwindIsOfFirstOrder) {
  measure(ConvectionScheme::upwind);
  EXPECT_NEAR(l2_, 1.0, 0.2);
  EXPECT_NEAR(pressure_, 1.0, 0.2);
}

TEST_P(ManufacturedPlane, CentralIsOfSecondOrder) {
  measure(ConvectionScheme::central);
  EXPECT_GE(l2_, 1.9);
  EXPECT_GE(pressure_, 1.9);
  // The one row of nodes beside a wall has ∇² to first order.
  EXPECT_GE(viscous_, GetParam() == LateralBoundary::no_slip ? 1.5 : 1.9);
}

TEST_P(ManufacturedPlane, QuickIsOfSecondOrder) {
  measure(ConvectionScheme::quick);
  EXPECT_GE(l2_, 1.9);
  EXPECT_GE(pressure_, 1.9);
  // The one row of nodes beside a wall has ∇² to first order.
  EXPECT_GE(viscous_, GetParam() == LateralBoundary::no_slip ? 1.5 : 1.9);
}

// The limiter flattens extrema: second order in the mean of |error|.
TEST_P(ManufacturedPlane, MusclIsOfSecondOrderInTheMean) {
  measure(ConvectionScheme::muscl);
  EXPECT_GE(l1_, 1.8);
}

TEST_P(ManufacturedPlane, SimpleHasTheOrderOfTheProjection) {
  measure(ConvectionScheme::quick, PressureVelocity::simple);
  EXPECT_GE(l2_, 1.9);
  EXPECT_GE(pressure_, 1.9);
}

INSTANTIATE_TEST_SUITE_P(Walls, ManufacturedPlane, testing::Values(LateralBoundary::periodic, LateralBoundary::no_slip),
                         [](const auto& tested) {
                           return tested.param == LateralBoundary::no_slip ? "NoSlip" : "Periodic";
                         });

// On one grid, the change from one time step to its half falls with the order of the time scheme.
TEST(ManufacturedTime, HasTheOrderOfItsScheme) {
  const PlaneSolution exact(true);
  for (const auto& [scheme, lowest, highest] :
       {std::tuple{TimeScheme::euler, 0.85, 1.2}, std::tuple{TimeScheme::second_order, 1.85, 2.5}}) {
    Scene scene = scene_of(12, LateralBoundary::no_slip, ConvectionScheme::central);
    scene.fluid.time_scheme = scheme;
    scene.fluid.pressure_tolerance = 1e-10;
    std::vector<double> coarser;
    std::vector<double> differences;
    for (const int steps : {32, 64, 128}) {
      Manufactured run(scene, exact);
      run.run(1.0, steps);
      double sum = 0.0;
      for (std::size_t n = 0; n < coarser.size(); ++n) sum += std::pow(run.velocity(2)[n] - coarser[n], 2);
      if (!coarser.empty()) differences.push_back(std::sqrt(sum));
      coarser = run.velocity(2);
    }
    const double measured = order(differences[0], differences[1], 1, 2);
    EXPECT_GE(measured, lowest);
    EXPECT_LE(measured, highest);
  }
}

// At the round wall a band of cells is of first order, away from it the flow is of second order. Both grids cut the
// circle alike.
TEST(ManufacturedPipe, CutCellsKeepTheOrder) {
  const PipeSolution exact;
  std::array<double, 2> whole{}, core{};
  for (std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const int cells = i == 0 ? 12 : 24;
    Manufactured run(pipe_scene(cells), exact);
    run.run(duration, cells / 2);
    whole[i] = run.velocity_error().l2;
    core[i] = run.velocity_error(0.3).l2;
  }
  EXPECT_GE(order(whole[0], whole[1], 12, 24), 1.5);
  EXPECT_GE(order(core[0], core[1], 12, 24), 1.9);
}

}  // namespace
}  // namespace slfb
