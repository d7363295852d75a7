#pragma once

#include <map>
#include <optional>

#include "experiments/quantities/measurement.hpp"

/// Numbers that follow from several runs of a system.
namespace slfb {

/// A number that is linear in independent measurements.
struct LinearNumber {
  double value = 0.0;
  double variance = 0.0;  ///< of half-widths
  void add(double weight, const Measurement& term);
};

/// The pressure drop of a bed over the superficial velocity: a straight line while it is packed, a constant when it is
/// fluidised. Units and origins are left open; a member is empty where there are too few runs for it.
struct PressureCurve {
  std::optional<Measurement> plateau;    ///< mean over the fluidised runs that have an interval [Pa]
  std::optional<Measurement> slope;      ///< of the line through at least two packed runs [Pa s/m]
  std::optional<Measurement> intercept;  ///< [Pa]
  std::optional<Measurement> crossing;   ///< superficial velocity where the two lines meet [m/s]
  /// Rise of the line through at least three fluidised runs, from the first to the last, over the plateau [-].
  std::optional<Measurement> plateau_rise;
};

/// \param pressures pressure drop [Pa] by superficial velocity [m/s]
/// \param packed_up_to, fluidised_from a run between the two belongs to neither line [m/s]
PressureCurve pressure_curve(const std::map<double, Measurement>& pressures, double packed_up_to,
                             double fluidised_from);

/// `values` at the voidage `stated`, on a straight line between the two runs on either side of it; both by the
/// superficial velocity of their runs. Outside of all runs the nearest one stands for it where it misses it by no more
/// than `tolerance`, else there is no answer.
std::optional<Measurement> value_at_voidage(const std::map<double, Measurement>& voidages,
                                            const std::map<double, Measurement>& values, double stated,
                                            double tolerance);

}  // namespace slfb
