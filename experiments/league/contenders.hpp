#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "correlations/drag/drag_law_kernels.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/materials.hpp"
#include "experiments/reference/expansion_lines.hpp"

/// The laws that are held against measurements.
namespace slfb::league {

/// Spheres, liquid and walls of a bed or a suspension.
struct Bed {
  Sphere sphere;
  LiquidProperties liquid;
  double tube_diameter = 0.0;  ///< D [m]; 0: no walls
  BedMotion motion = BedMotion::fluidised;

  [[nodiscard]] double diameter_ratio() const { return tube_diameter > 0.0 ? sphere.diameter / tube_diameter : 0.0; }
  [[nodiscard]] double archimedes() const { return archimedes_number(sphere, liquid); }
};
Bed bed_of(const ExpansionLine& line);

/// Terminal velocity of one sphere without walls by Brown & Lawler (2003), the law that its authors fitted to the most
/// measurements of single spheres [m/s], and its Reynolds number [-].
double terminal_velocity(const Bed& bed);
double terminal_reynolds(const Bed& bed);

enum class ContenderKind {
  drag_law,           ///< the homogeneous bed in which the law balances the buoyant weight
  expansion_formula,  ///< U = U_i ε^n with n by a law for the exponent and U_i the terminal velocity
};

/// One law, with or without the wall's part.
///
/// With walls the velocity of a fluidised bed is that of the law times U_i/u_t of Richardson & Zaki (1954), Eq. 41,
/// 10^(−d/D); their suspensions that settle need no such factor (Eq. 40).
class Contender {
 public:
  using Velocity = std::function<double(const Bed&, double voidage)>;
  /// \param velocity without walls [m/s]; NaN or a std::domain_error where the law has no answer
  Contender(std::string law, ContenderKind kind, bool with_wall, Velocity velocity)
      : law_(std::move(law)), kind_(kind), with_wall_(with_wall), velocity_(std::move(velocity)) {}

  [[nodiscard]] std::string name() const { return with_wall_ ? law_ + " + wall" : law_; }
  [[nodiscard]] const std::string& law() const { return law_; }
  [[nodiscard]] ContenderKind kind() const { return kind_; }
  [[nodiscard]] bool with_wall() const { return with_wall_; }

  /// Superficial velocity of a bed of that voidage [m/s]; NaN where the law has no answer.
  [[nodiscard]] double velocity(const Bed& bed, double voidage) const;
  /// Voidage of the bed at a superficial velocity, the packed voidage where it is not lifted, 1 where it is washed out.
  [[nodiscard]] fluidisation::BedState voidage(const Bed& bed, double superficial_velocity, double packed) const;

 private:
  std::string law_;
  ContenderKind kind_;
  bool with_wall_;
  Velocity velocity_;
};

/// A drag law with and without the wall's part.
std::vector<Contender> contenders_of(const drag::DragLawKernels& law);

/// Every drag law and every law for the exponent of the suite, each with and without the wall's part.
std::vector<Contender> contenders();

/// U = u_t f(d/D) ε^n with every law for one sphere (u_t), every law for n, and every law for the wall (f) or none:
/// what the formula of contenders(), u_t by Brown & Lawler (2003) and f of Richardson & Zaki (1954), could have been.
/// Names are "LAW OF ONE SPHERE, LAW FOR n, LAW OF THE WALL" or "…, no wall". A suspension that settles has no f.
std::vector<Contender> formula_contenders();

/// The contender of that name. \throws std::invalid_argument that names close ones
const Contender& find_contender(const std::vector<Contender>& contenders, const std::string& name);

}  // namespace slfb::league
