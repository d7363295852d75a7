#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "solver/fluid/column_grid.hpp"
#include "solver/scene/scene.hpp"
#include "solver/support/named_fields.hpp"

namespace slfb::fluid {

/// A solve of the liquid has not converged or has left finite numbers; what() says which one and how far it came.
struct FluidError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the spheres do to the liquid in one step, on the momentum nodes of each velocity component.
///
/// The force on the liquid in node f is source_f − coefficient_f · u_f + volume_f (−∇p + ∇·τ)_f, with all three at the
/// end of the step (Peng 2014, Eqs. 28, 29, 35).
struct Exchange {
  std::array<std::vector<double>, 3> coefficient;  ///< Σ φ_if K_i [kg/s]
  std::array<std::vector<double>, 3> source;       ///< Σ φ_if K_i v_i [N]
  std::array<std::vector<double>, 3> volume;       ///< of spheres that pass their stress on; empty: none [m³]
};

/// What acted on the liquid and the spheres in it along z over the last step, by the liquid's own equations [N].
struct VerticalForces {
  double pressure = 0.0;  ///< −Σ V ∂p/∂z over whole node volumes, so on both phases
  double stress = 0.0;    ///< Σ V (∇·τ)_z, the same
  double inflow = 0.0;    ///< momentum that came in through the inlet per time
  double outflow = 0.0;   ///< and went out through the outlet
  /// ∂(Σ ρ V_L w)/∂t where the time scheme forms it from more than the two ends of the step; else none, it is the
  /// change of vertical_momentum() over the step.
  std::optional<double> momentum_rate;
};

/// Wall time spent on the liquid since it was made [s], and the iterations of its pressure equation [-].
struct LiquidCost {
  double momentum_seconds = 0.0, pressure_seconds = 0.0;
  std::int64_t pressure_iterations = 0;
};

/// The liquid of a column as spheres and recorders see it; each tier (FluidTier) is a type of its own.
///
/// Values per cell are fields of grid().size() numbers, index section cell * layers + layer. The pressure is the
/// dynamic one, p + ρ g z, 0 at the outlet. A virtual function is called once per liquid step or per field, never per
/// cell.
class Liquid {
 public:
  Liquid() = default;
  Liquid(const Liquid&) = delete;
  Liquid& operator=(const Liquid&) = delete;
  virtual ~Liquid() = default;

  /// Whether the spheres act on the liquid (two-way coupling). If not (one-way), its velocity is given, a sphere feels
  /// the void fraction 1, its grid is a single cell, and there is nothing of it to record.
  [[nodiscard]] virtual bool two_way() const = 0;
  [[nodiscard]] virtual const ColumnGrid& grid() const = 0;

  /// Superficial velocity of the liquid that enters from the next step on [m/s]; at first it is that of the scene's
  /// first stage after settling. The
  /// state() has only a change that no step has seen yet.
  virtual void set_superficial_velocity(double velocity) = 0;

  /// One step of `time_step` [s], from liquid volumes `before` to `now` (per cell [m³]).
  /// \throws FluidError if a cell holds no liquid, if an equation does not converge, or if a value is not finite
  virtual void advance(double time_step, const std::vector<double>& before, const std::vector<double>& now,
                       const Exchange& exchange) = 0;

  /// Puts together an exchange from what is given per cell: coefficient [kg/s], source along x, y, z [N], volume [m³].
  virtual void scatter(const std::array<std::vector<double>, 5>& cells, Exchange& exchange) const = 0;
  /// Per cell: the interstitial velocity u [m/s] and the stress −∇p + ∇·τ [N/m³]; the adjoint of scatter().
  virtual void gather(std::array<std::vector<double>, 3>& velocity,
                      std::array<std::vector<double>, 3>& stress) const = 0;
  /// Per cell: ∂p/∂x_a [Pa/m].
  virtual void gather_pressure_gradient(std::size_t a, std::vector<double>& cells) const = 0;

  /// Momentum along axis a that `exchange`, that of the last step, has taken from the liquid per time [N].
  [[nodiscard]] virtual double taken_by(const Exchange& exchange, std::size_t a) const = 0;
  [[nodiscard]] virtual VerticalForces vertical_forces() const = 0;
  /// Σ ρ V_L w [kg m/s].
  [[nodiscard]] virtual double vertical_momentum() const = 0;

  /// Pressure per cell [Pa].
  [[nodiscard]] virtual const std::vector<double>& pressure() const = 0;
  /// Section mean of the pressure at the inlet [Pa].
  [[nodiscard]] virtual double inlet_pressure() const = 0;
  /// Largest violation of continuity (Peng 2014, Eq. 26) over all cells at the last step, over the inlet's flow [-].
  [[nodiscard]] virtual double continuity_error() const = 0;
  [[nodiscard]] virtual LiquidCost cost() const = 0;

  /// Fields that the next step starts from, for checkpoints.
  [[nodiscard]] virtual NamedFields state() const = 0;
  /// \throws std::runtime_error if a field is missing
  virtual void restore(const NamedFields& state) = 0;
};

/// The liquid of a scene, by its fluid.tier: see liquid_tiers.cpp. A result does not depend on the number of threads.
std::unique_ptr<Liquid> make_liquid(const Scene& scene, int threads = 1);

}  // namespace slfb::fluid
