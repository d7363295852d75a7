#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/league/standings.hpp"

/// What the measurements say of a bed that nobody measured: which law to take, and how far to trust it.
namespace slfb::league {

/// A number with where a measurement of it would fall: in `one_sigma` twice of three times, in `two_sigma` 95 times of
/// a hundred.
struct Predicted {
  double value = 0.0;
  std::pair<double, double> one_sigma{}, two_sigma{};
  [[nodiscard]] double sigma() const { return 0.5 * (one_sigma.second - one_sigma.first); }
};

/// A law in the measured beds that are near the asked one.
struct Evidence {
  const Contender* law;
  Statistic statistic;            ///< of the velocity in the near beds
  double largest = 0.0;           ///< largest |law / measured − 1| there [-]
  std::vector<std::string> beds;  ///< names of the near lines
};

/// Lines of fluidised beds that are near: those of the groups whose Archimedes number and d/D are nearest, the distance
/// being |Δ log10 Ar| and |Δ(d/D)| over 0.1 together, as many groups as are given and all that are within 1.
std::vector<ExpansionLine> near_lines(const Bed& bed, const std::vector<ExpansionLine>& lines, std::size_t groups = 5);

/// Voidage of a bed by the measured line of another, as if the two were alike: the line's velocity over the terminal
/// velocity of its own spheres is that of the bed over that of its spheres, both by Brown & Lawler (2003).
double voidage_by_line(const ExpansionLine& line, const Bed& bed, double superficial_velocity);

/// Every law in the near beds, the smallest root mean square first.
std::vector<Evidence> evidence_for(const Bed& bed, const std::vector<Contender>& laws,
                                   const std::vector<ExpansionLine>& lines);

/// Voidage of a bed by a law: the law's bias over all measured fluidised beds taken off the velocity, and around it the
/// spread of the law over these beds (measurement included, Student's t over the groups).
/// \param tier_error relative error of the voidage by the way the law is solved, added in squares [-]
Predicted predict_voidage(const Contender& law, const Bed& bed, double superficial_velocity, double packed_voidage,
                          const std::vector<ExpansionLine>& lines, double tier_error = 0.0);

/// The law with the smallest root mean square over all measured fluidised beds.
const Contender& recommended(const std::vector<Contender>& laws, const std::vector<ExpansionLine>& lines);

/// One prediction of a measured point that the statistics had not seen.
struct Blind {
  std::string line;
  std::string law;                    ///< chosen without it
  double measured, predicted, sigma;  ///< voidage [-]
  bool in_one_sigma, in_two_sigma;
  [[nodiscard]] double error() const { return predicted - measured; }  ///< of the voidage [-]
};

/// How far predictions were off, and how often inside what they said.
struct Calibration {
  std::size_t points = 0;
  double in_one_sigma = 0.0, in_two_sigma = 0.0;  ///< shares [-]
  double root_mean_square = 0.0, worst = 0.0;     ///< of the voidage's error [-]
};
/// \throws std::invalid_argument without predictions
Calibration calibration_of(const std::vector<Blind>& blind);

/// Each group of fluidised lines predicted from the others: the law is chosen and its spread found without it.
std::vector<Blind> leave_one_group_out(const std::vector<Contender>& laws, const std::vector<ExpansionLine>& lines);

/// A formula whose parts were chosen for all measured fluidised beds, held against these beds.
struct FormulaChoice {
  std::string parts;     ///< name in formula_contenders(); "" where they are chosen anew for each group left out
  Calibration left_out;  ///< each group predicted with bias and spread from the others
};

/// Does another law for one sphere, for n or for the wall predict better? The formulas with the smallest root mean
/// square over all lines, in that order, and at the end the parts chosen anew for each group left out.
std::vector<FormulaChoice> formula_choices(const std::vector<ExpansionLine>& lines, std::size_t shown);

/// Suspensions that settle, predicted from the fluidised beds alone.
std::vector<Blind> predict_settling(const std::vector<Contender>& laws, const std::vector<ExpansionLine>& lines);

/// U_mf [m/s]: the velocity at which a drag law of packed beds carries the spheres at the packed voidage. Its sigma is
/// made of that of the packed voidage and of the law's spread over the measured packed beds.
Predicted predict_minimum_fluidisation(const drag::DragLawKernels& law, const Bed& bed,
                                       const std::vector<PackedBedPoint>& points, double packed_voidage);

}  // namespace slfb::league
