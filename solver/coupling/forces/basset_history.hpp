#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "correlations/materials.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// C = (3/2) d² √(π ρ μ) [kg/√s], by which BassetHistory's integral becomes a force.
/// \param diameter d [m]
double basset_coefficient(double diameter, LiquidProperties liquid);

/// History force on spheres, Basset (1888): F = C [∫_0^t w'(τ)/√(t − τ) dτ + w(0)/√t], w = u − v the slip,
/// C = (3/2) d² √(π ρ μ).
///
/// The slip counts as piecewise linear between the steps, for which every integral below is exact. The last
/// `window` steps keep their own 1/√; older ones are remembered by ten exponentials (the method of van Hinsberg,
/// ten Thije Boonkkamp & Clercx 2011, J. Comput. Phys. 230, 1465, with weights fitted here), which stand for 1/√ within
/// 0.2 % over ages of 1 to 10⁴ windows and forget beyond. The jump from rest to w(0), for a sphere put into moving
/// liquid, is kept apart and exact for all time.
///
/// The newest slip enters linearly, so that a step may be implicit in it: F = C (weight() w + memory(i)). A step is:
/// solve with that, then advance(i, w) for every sphere, then end_step(). Only equal steps.
///
/// Keys: basset1888, vanhinsberg2011. Range: Re < 1. At larger Re the wake sweeps vorticity away and the true kernel
/// falls as t⁻² (Mei & Adrian 1992): the force then remembers too long and is too large.
class BassetHistory {
 public:
  /// \param time_step of advance() [s]; \param window how many steps are kept singly [-]
  explicit BassetHistory(double time_step, std::size_t window = 16);

  /// Appends a sphere with slip w(0) [m/s] at this moment.
  void add(Vec3 slip);
  /// Takes sphere i out; those after it move up by one.
  void remove(std::size_t i);
  [[nodiscard]] std::size_t size() const { return state_.size() / stride_; }

  /// What multiplies the newest slip, 2/√Δt [1/√s].
  [[nodiscard]] double weight() const { return weight_; }
  /// The rest of the bracket at the end of the step that is now under way [m/s^1.5].
  [[nodiscard]] Vec3 memory(std::size_t i) const;
  /// Takes in the slip of sphere i at the end of the step [m/s].
  void advance(std::size_t i, Vec3 slip);
  /// After advance() of all spheres.
  void end_step() { newest_ = newest_ == 0 ? window_ - 1 : newest_ - 1; }

  /// All that the next step depends on, for checkpoints: of every sphere its changes of the slip [m/s], modes and age
  /// in steps one after the other; and where the newest change stands.
  struct State {
    std::vector<double> spheres;
    std::size_t newest = 0;
  };
  [[nodiscard]] State state() const { return {state_, newest_}; }
  /// \throws std::invalid_argument if the state is that of another window
  void restore(State state);

  /// The exponentials' stand-in for 1/√age [1/√s], for age ≥ window Δt.
  [[nodiscard]] double tail_kernel(double age) const;

 private:
  static constexpr std::size_t modes = 10;
  /// Of one sphere and axis: a ring of `window_` changes of the slip, then modes, last slip, initial slip.
  [[nodiscard]] std::size_t axis_stride() const { return window_ + modes + 2; }
  void fit_tail();

  double time_step_, weight_;
  std::size_t window_, stride_, newest_ = 0;  ///< stride_: three axes and the age in steps
  std::vector<double> kernel_;  ///< of the ring, twice over so that it can be read from any entry [1/√s]
  std::array<double, modes> rate_, tail_weight_;  ///< s_j [1/s], a_j [1/√s]: 1/√age ≈ Σ a_j e^(−s_j age)
  std::array<double, modes> decay_, entry_;       ///< over a step; of a change that leaves the ring
  std::vector<double> state_;
};

}  // namespace slfb::coupling
