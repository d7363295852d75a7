#include "solver/coupling/forces/disturbance_correction.hpp"

#include <gsl/gsl_sf_erf.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slfb::coupling {
namespace {

constexpr double steady_response = 0.115, inertial_response = 0.5;  ///< c and a

double compressibility(double solid) {
  const double liquid = 1.0 - solid;
  return std::pow(liquid, 4) / (std::pow(1.0 + 2.0 * solid, 2) + std::pow(solid, 3) * (solid - 4.0));
}

}  // namespace

double share_concentration(std::span<const double> shares, std::span<const double> cell_volumes) {
  double sum = 0.0;
  for (std::size_t c = 0; c < shares.size(); ++c) sum += shares[c] * shares[c] / cell_volumes[c];
  return sum;
}

double undisturbed_voidage(double voidage, double own_fraction) {
  const double others = std::max(0.0, 1.0 - voidage - own_fraction);
  return voidage + compressibility(others / (1.0 - own_fraction)) * own_fraction;
}

double oseen_weakening(double width_reynolds) {
  const double r = width_reynolds, root = std::sqrt(0.5 * std::numbers::pi);
  // Below, the closed form is a small difference of large numbers.
  if (r < 0.02) return 1.0 - 0.375 * root * r + 0.2 * r * r;
  const double e = 1.0 / (root * gsl_sf_hazard(r));  // e^(r²/2) erfc(r/√2)
  return 1.5 * root * ((1.0 - e) / r + (r * r * e + 2.0 * (1.0 - e) - 2.0 * r / root) / (r * r * r));
}

double SelfInducedVelocity::mobility(double concentration, double voidage, double slip) const {
  const double length = 1.0 / std::cbrt(concentration);
  const double width = std::sqrt(2.0 / std::numbers::pi) / (6.0 * std::numbers::pi * steady_response) * length;
  return steady_response * oseen_weakening(reynolds_number(liquid_, width, slip)) /
         (voidage * liquid_.viscosity * length);
}

Vec3 SelfInducedVelocity::advance(Vec3 previous, Vec3 force, double concentration, double voidage, double slip,
                                  double time_step) const {
  const double steady = mobility(concentration, voidage, slip);
  const double beginning = inertial_response * concentration / (voidage * liquid_.density);
  const double left = std::exp(-time_step * beginning / steady);
  return left * previous + ((1.0 - left) * steady) * force;
}

}  // namespace slfb::coupling
