#pragma once

#include "solver/fluid/liquid.hpp"

namespace slfb::fluid {

/// Liquid of a uniform, given velocity that no sphere disturbs: one-way coupling, the tier "quiescent".
///
/// Each sphere feels the velocity w upwards, the void fraction 1 and no stress beside the static pressure: it moves
/// through still or uniformly rising liquid with the drag of a single sphere.
class PrescribedLiquid final : public Liquid {
 public:
  /// \param velocity w [m/s]
  PrescribedLiquid(const Scene& scene, double velocity);

  [[nodiscard]] bool two_way() const override { return false; }
  /// A single cell that holds the whole column.
  [[nodiscard]] const ColumnGrid& grid() const override { return grid_; }
  void set_superficial_velocity(double velocity) override { velocity_ = velocity; }
  /// Nothing changes; throws nothing.
  void advance(double, const std::vector<double>&, const std::vector<double>&, const Exchange&) override {}

  void scatter(const std::array<std::vector<double>, 5>&, Exchange&) const override {}
  void gather(std::array<std::vector<double>, 3>& velocity, std::array<std::vector<double>, 3>& stress) const override;
  void gather_pressure_gradient(std::size_t a, std::vector<double>& cells) const override;
  [[nodiscard]] double taken_by(const Exchange&, std::size_t) const override { return 0.0; }
  [[nodiscard]] VerticalForces vertical_forces() const override { return {}; }
  [[nodiscard]] double vertical_momentum() const override { return 0.0; }
  [[nodiscard]] const std::vector<double>& pressure() const override { return pressure_; }
  [[nodiscard]] double inlet_pressure() const override { return 0.0; }
  [[nodiscard]] double continuity_error() const override { return 0.0; }
  [[nodiscard]] LiquidCost cost() const override { return {}; }
  [[nodiscard]] NamedFields state() const override { return {}; }
  void restore(const NamedFields&) override {}

 private:
  ColumnGrid grid_;
  double velocity_;
  std::vector<double> pressure_;
};

/// The tier's maker: w is the superficial velocity of the scene's first stage after settling.
std::unique_ptr<Liquid> make_prescribed_liquid(const Scene& scene, int threads);

}  // namespace slfb::fluid
