#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/league/contenders.hpp"
#include "experiments/league/statistics.hpp"
#include "experiments/reference/expansion_lines.hpp"

/// Laws against all measurements that the suite holds.
namespace slfb::league {

/// Everything measured, from every folder of reference-data/.
struct Measured {
  std::vector<ExpansionLine> lines;  ///< of spheres that sink in their liquid
  std::vector<PackedBedPoint> packed;
};
const Measured& measured();

/// Voidages at which a measured line is read [-]. The range in which the points of a line lie is not printed.
inline constexpr double line_voidages[] = {0.5, 0.6, 0.7, 0.8, 0.9};

/// Voidage of packed beds whose own is not at hand [-]: dense to loose random packings of spheres have 0.36 to 0.44,
/// read as two sigmas on either side.
inline constexpr double densest_packed_voidage = 0.36, packed_voidage_mean = 0.40, packed_voidage_sigma = 0.02;

/// σ_E of a velocity on a measured line of beds that move so [-]: how far lines of the same spheres in the same liquid
/// and different tubes lie apart at one voidage, once the part that Richardson & Zaki (1954) ascribe to the tube is
/// taken off; at least the rounding of the print. What spheres and liquid are known to is in no such difference: it
/// stays in the spread of the laws.
double line_spread(const std::vector<ExpansionLine>& lines, BedMotion motion);

/// σ_E of a packed bed's friction factor [-]: from differences of neighbours in Re of one series (von Neumann 1941),
/// which no smooth law can follow.
double packed_spread(const std::vector<PackedBedPoint>& points);

/// A part of the measurements that is looked at alone.
struct Regime {
  std::string id;     ///< "fluidised-dilute"
  std::string title;  ///< in words, with its bounds
  std::string kind;   ///< what is compared: "bed", "packed bed", "one sphere"
  BedMotion motion;   ///< of its lines: the wall's part of a law says something of fluidised beds alone
  /// Which points of lines belong to it; unused for packed beds and single spheres.
  std::function<bool(const ExpansionLine&, double voidage)> has;
};
const std::vector<Regime>& regimes();

/// ln(law / measured) of the velocity at every point of the lines for which `has` holds, where the law has an answer.
std::vector<Comparison> compare_lines(const Contender& contender, const std::vector<ExpansionLine>& lines,
                                      const std::function<bool(const ExpansionLine&, double voidage)>& has);

/// ln(law / measured) of the friction factor of packed beds by a drag law.
std::vector<Comparison> compare_packed(const drag::DragLawKernels& law, const std::vector<PackedBedPoint>& points);

/// A law in a regime.
struct Standing {
  std::string law;
  Statistic statistic;
  std::size_t without_answer = 0;                              ///< points at which the law has none
  double worst_voidage_error = 0.0, mean_voidage_error = 0.0;  ///< at the measured velocity, largest |…| and mean [-]
  double root_mean_square_voidage_error = 0.0;                 ///< [-]
};

/// The laws in a regime, the smallest root mean square first; those without an answer at some point last.
struct Table {
  Regime regime;
  std::vector<Standing> standings;
};

/// \param user laws of the user beside those of the suite
std::vector<Table> league_tables(const std::vector<drag::DragLawKernels>& user = {});

}  // namespace slfb::league
