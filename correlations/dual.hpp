#pragma once

#include <cmath>
#include <compare>

namespace slfb {

/// A number that carries its derivative along (forward-mode differentiation): f(Dual{x, 1}).slope is f'(x) to
/// round-off, for every formula that is written for any kind of number.
struct Dual {
  double value;
  double slope;  ///< derivative of `value` with respect to the one variable that was given slope 1

  // Constants enter formulas without a cast.
  constexpr Dual(double constant, double derivative = 0.0)  // NOLINT(google-explicit-constructor)
      : value(constant), slope(derivative) {}

  friend constexpr Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  friend constexpr Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  friend constexpr Dual operator-(Dual a) { return {-a.value, -a.slope}; }
  friend constexpr Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
  friend constexpr Dual operator/(Dual a, Dual b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
  }
  friend constexpr auto operator<=>(Dual a, Dual b) { return a.value <=> b.value; }

  friend Dual sqrt(Dual a) {
    const double root = std::sqrt(a.value);
    return {root, 0.5 * a.slope / root};
  }
  friend Dual exp(Dual a) {
    const double power = std::exp(a.value);
    return {power, power * a.slope};
  }
  friend Dual log10(Dual a) { return {std::log10(a.value), a.slope / (a.value * std::log(10.0))}; }
  friend Dual pow(Dual base, double exponent) {
    return {std::pow(base.value, exponent), exponent * std::pow(base.value, exponent - 1.0) * base.slope};
  }
  friend Dual pow(double base, Dual exponent) {
    const double power = std::pow(base, exponent.value);
    return {power, power * std::log(base) * exponent.slope};
  }
};

}  // namespace slfb
