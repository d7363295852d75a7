#pragma once

#include <optional>
#include <string>
#include <vector>

#include "correlations/materials.hpp"
#include "experiments/claims/claims.hpp"
#include "experiments/quantities/quantity.hpp"
#include "experiments/runs/campaign.hpp"

/// The bed in which laws are compared: what a work hands over to `slfb compare`.
namespace slfb::compare {

/// A sphere and what it is made of.
struct NamedSphere {
  Sphere sphere;
  std::string material;  ///< "glass"
  /// "5 mm glass".
  [[nodiscard]] std::string words() const;
};

/// One printed number at one superficial velocity.
struct PrintedPoint {
  double superficial_velocity;  ///< [m/s]
  double value;
};

/// Numbers that the work prints, and how the key of a plot names them.
struct PrintedSeries {
  std::string title;  ///< "paper, Table 2"
  std::vector<PrintedPoint> points;
};

/// A bed of equal spheres in a liquid, one foreign sphere in it, the runs that simulate them, and the claims that these
/// runs answer.
struct ComparisonBed {
  std::string system;  ///< second part of the keys of its measurements
  NamedSphere bed;
  NamedSphere foreign;
  LiquidProperties liquid;
  std::string liquid_name;
  double packed_voidage = 0.0;  ///< [-]

  /// Classification velocity of the foreign sphere [m/s]. Its superficial velocities are those at which laws are judged
  /// without a simulation.
  PrintedSeries classification;
  PrintedSeries expansion;                       ///< voidage [-]
  std::optional<double> minimum_fluidisation{};  ///< [m/s]
  std::vector<double> tabulated_velocities;      ///< superficial, of the report's table of the homogeneous bed [m/s]
  double slowest = 0.0, fastest = 0.0;           ///< superficial velocities between which curves are drawn [m/s]

  std::string drag_law, contact_law;  ///< of the work: what a single law is compared with

  std::vector<RunSpec> three_dimensional;  ///< runs of the bed
  std::vector<RunSpec> one_dimensional;    ///< runs of a slice of it in a one-dimensional liquid
  std::vector<double> usual_velocities;    ///< of the slice unless others are asked for [m/s]
  std::string about_three_dimensional;     ///< a sentence for the report
  std::string about_one_dimensional;

  std::vector<Claim> claims;  ///< all of the work
  MeasuringRules measuring;   ///< what the runs are measured by
};

}  // namespace slfb::compare
