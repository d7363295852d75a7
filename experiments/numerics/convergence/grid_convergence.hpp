#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Discretisation error from three grids, or three time steps: observed order and grid convergence index after Roache
/// (1994), J. Fluids Eng. 116, 405, and Celik et al. (2008), J. Fluids Eng. 130, 078001, for values that scatter.
namespace slfb::convergence {

/// One quantity on one grid, or with one step.
struct Level {
  double size;        ///< width of a cell [m], or step [s]
  double value;       ///< mean
  double half_width;  ///< of its 95 % interval; 0: exact; NaN: a single sample
};

/// How the values change from the coarsest of three levels to the finest.
enum class Behaviour {
  converges,   ///< to one side, by less and less: the sequence has an order
  oscillates,  ///< first to one side, then to the other
  diverges,    ///< to one side, by as much or more for each refinement
  undecided    ///< the intervals do not tell, or the two finest agree too well for an order
};

/// What three levels say. Order, limit and index are NaN, and have no interval, unless the levels converge.
struct GridConvergence {
  std::array<Level, 3> levels{};  ///< that are used, the finest first
  Behaviour behaviour = Behaviour::undecided;
  std::array<double, 4> shares{};                           ///< parts of what the intervals allow, by Behaviour [-]
  double order = std::numeric_limits<double>::quiet_NaN();  ///< p of φ = φ_0 + C h^p [-]
  double extrapolated = std::numeric_limits<double>::quiet_NaN();  ///< φ_0
  double index = std::numeric_limits<double>::quiet_NaN();  ///< grid convergence index of the finest level: 1.25 |φ_1 −
                                                            ///< φ_0|/|φ_1| [-]
  std::optional<std::pair<double, double>> order_interval = {},
                                           index_interval = {};  ///< 95 %; empty where all is exact
  double half_range = 0.0;  ///< of all levels given, over the finest value: the error where there is no order [-]
  bool differs = false;     ///< two of all levels given differ by more than their intervals

  /// The index of a level that is not the finest: 1.25 |φ − φ_0|/|φ| [-]; NaN unless the levels converge.
  [[nodiscard]] double index_of(double value) const;
};

/// Of the levels those that are used: the finest, and each next one that is coarser by 1.3 at least (Celik et al.).
/// With fewer than three such: the finest, the coarsest and the one between that is nearest to their geometric mean.
/// \throws std::invalid_argument for fewer than three different sizes, or a size that is not positive
std::array<Level, 3> choose_levels(std::vector<Level> levels);

/// With φ_1, φ_2, φ_3 on levels of size h_1 < h_2 < h_3 and r_21 = h_2/h_1, r_32 = h_3/h_2, the order p solves
/// (φ_3 − φ_2)/(φ_2 − φ_1) = (r_32^p − 1)/(1 − r_21^−p), which is Celik et al.'s equation without the absolute value
/// that gives an order to sequences that have none; φ_0 = φ_1 − (φ_2 − φ_1)/(r_21^p − 1).
///
/// The values are taken as normally distributed with their intervals. The behaviour is one that 95 % of the
/// combinations of their quantiles share; intervals are those of the combinations that converge.
/// \throws std::invalid_argument as choose_levels, or for a finest value of zero
GridConvergence analyse(const std::vector<Level>& levels);

/// In words: "order 1.9 (1.6 to 2.3), index 2.1 % (1.5 to 3.0 %)", or that there is none and why.
std::string describe(const GridConvergence& found);

}  // namespace slfb::convergence
