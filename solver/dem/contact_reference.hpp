#pragma once

#include <optional>
#include <vector>

namespace slfb::dem {

/// Contact law of the reference trajectories, as an ordinary differential equation and nothing of the engine in it.
///
/// With the overlap δ, the approach speed v_n = dδ/dt, the slip velocity v_t at the contact point (spin included), the
/// tangential spring ξ, and β = −ln e/√(π² + ln² e):
///
/// - linear: F_n = k_n δ + c_n v_n, c_n = 2 β √(k_n m_eff); k_t and c_t are constants (Cundall & Strack 1979);
/// - Hertz-Mindlin: F_n = 4/3 E* √R* δ^{3/2} + c_n v_n, c_n = 2 √(5/6) β √(S_n m_eff), S_n = 2 E* √(R* δ), which
///   returns e at any speed (Tsuji et al. 1992; Antypov & Elliott 2011); k_t = S_t = 8 G* √(R* δ) on the whole spring
///   and c_t = 2 √(5/6) β √(S_t m_eff).
///
/// A contact lasts while δ > 0; its normal force may be tensile just before the end unless `cut_tension`. It sticks,
/// dξ/dt = v_t and F_t = −k_t ξ − c_t v_t, until |F_t| reaches μ F_n; then it slides, |F_t| = μ F_n with ξ slaved to
/// k_t ξ + c_t v_t = −F_t, until the spring-dashpot released from that ξ would carry less than the limit. While F_n < 0
/// there is no tangential force.
///
/// Where the Mindlin dashpot alone exceeds the limit at first touch, c_t v_t > μ c_n v_n, the slaved spring is singular
/// (ξ → −∞ as δ → 0) and friction at first acts along the slip: the law as stated has this limit for small steps, but
/// reaches it, at worst, only below some 1e-6 of the contact's duration. Compare with `mindlin_damping` = 0 there.
struct ReferenceLaw {
  enum class Kind { linear, hertz_mindlin };
  Kind kind = Kind::linear;
  double stiffness = 0.0;             ///< linear: k_n [N/m]
  double tangential_stiffness = 0.0;  ///< linear: k_t [N/m]
  double tangential_damping = 0.0;    ///< linear: c_t [N s/m]
  double modulus = 0.0;               ///< Hertz: E*, 1/E* = Σ (1 − ν²)/E [Pa]
  double shear_modulus = 0.0;         ///< Mindlin: G*, 1/G* = Σ (2 − ν)/G [Pa]
  double mindlin_damping = 1.0;       ///< Mindlin: share of c_t that acts, 0 to leave it out [-]
  double restitution = 1.0;           ///< e of a normal impact with the tensile part, 0 < e ≤ 1 [-]
  double friction = 0.0;              ///< μ [-]
  bool cut_tension = false;           ///< F_n = max(F_n, 0)
};

enum class ReferenceEventKind {
  contact_start,
  contact_end,     ///< δ = 0
  tension_start,   ///< F_n = 0 while δ > 0; only where the law has a kink there: friction or cut_tension
  tension_end,     ///< F_n = 0 and rising
  sliding_start,   ///< |F_t| = μ F_n
  sticking_start,  ///< at the end of sliding, or at contact_start
};

/// States at the requested times, and those at all events up to the last of them.
template <class State>
struct ReferenceTrajectory {
  struct Event {
    ReferenceEventKind kind;
    int contact;  ///< number of the contact, 0 where there is but one
    State state;  ///< its time is that of the event
  };
  std::vector<State> samples;
  std::vector<Event> events;
};

struct ReferenceSphere {
  double radius, mass;        ///< [m], [kg]
  double position, velocity;  ///< at t = 0, along the line [m], [m/s]
};

/// Spheres on a line in ascending order, between no, one or two walls, with normal contacts only.
///
/// Contact k lies between sphere k − 1 and sphere k, the lower wall being sphere −1 and the upper one sphere N. Spheres
/// that touch at rest count as in contact.
struct ReferenceLine {
  ReferenceLaw law;  ///< for all contacts, walls included
  std::vector<ReferenceSphere> spheres;
  double gravity = 0.0;                          ///< downwards [m/s²]
  std::optional<double> lower_wall, upper_wall;  ///< position [m]
};

struct ReferenceLineState {
  double time;                             ///< [s]
  std::vector<double> position, velocity;  ///< of each sphere [m], [m/s]
  std::vector<double> gap;                 ///< of each contact, −δ if negative; 0 where there is no wall [m]
};

/// One sphere that strikes a plane at t = 0, in the plane of x (along the wall) and z (away from it), without gravity.
struct ReferenceImpact {
  ReferenceLaw law;
  double radius = 0.0, mass = 0.0;   ///< [m], [kg]; I = 2/5 m r²
  double normal_speed = 0.0;         ///< towards the plane, > 0 [m/s]
  double tangential_velocity = 0.0;  ///< of the centre along x [m/s]
  double spin = 0.0;                 ///< about y; rolling is v_x = ω r [rad/s]
};

struct ReferenceImpactState {
  double time;                            ///< [s]
  double x, z;                            ///< of the centre; z = r at the impact [m]
  double velocity_x, velocity_z;          ///< [m/s]
  double spin;                            ///< [rad/s]
  double overlap;                         ///< δ, ≤ 0 when apart [m]
  double spring;                          ///< ξ, slaved when sliding, 0 without tangential force [m]
  double normal_force, tangential_force;  ///< on the sphere, along z and x [N]
};

/// Trajectories from t = 0 by CVODE (Adams, local error 1e-13 of the scale of each variable), stopped and started again
/// at every event, so that no step straddles a kink of the law.
///
/// \param times output times, ascending from 0 on [s]
/// \throws std::runtime_error if CVODE fails, std::invalid_argument for a problem that is not well posed
ReferenceTrajectory<ReferenceLineState> reference_line(const ReferenceLine& line, const std::vector<double>& times);
ReferenceTrajectory<ReferenceImpactState> reference_impact(const ReferenceImpact& impact,
                                                           const std::vector<double>& times);

/// A sphere released at rest above a plane at height 0: reference_line with one sphere.
///
/// \param height of the centre [m]
ReferenceTrajectory<ReferenceLineState> reference_bounce(const ReferenceLaw& law, double radius, double mass,
                                                         double gravity, double height,
                                                         const std::vector<double>& times);

}  // namespace slfb::dem
