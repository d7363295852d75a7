#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "correlations/materials.hpp"

/// The one description of a run: plain data in SI units, filled and checked by solver/laws/scene_file.hpp.
namespace slfb {

enum class Shape { cylinder, box };
enum class LateralBoundary { no_slip, slip, periodic };  ///< periodic: boxes only
enum class FluidTier { quiescent, one_dimensional, three_dimensional };
enum class ConvectionScheme { upwind, central, quick, muscl };
enum class TimeScheme { euler, second_order };
enum class VoidFractionScheme { centroid, particle_meshing, exact_overlap };
enum class MomentumExchange { explicit_in_time, semi_implicit, implicit };
enum class Interpolation { shares, gradient, trilinear };
enum class OwnVolume { counted, spread_where_alone };
enum class InletVelocity { interstitial, superficial };
enum class PressureVelocity { projection, simple };
enum class OutletRule { lid, remove };
enum class StageKind { settle, fluidise, drop };
enum class Arrangement { lattice, random, random_close };

struct Geometry {
  Shape shape = Shape::cylinder;
  double diameter = 0.0;              ///< cylinder: inner diameter [m]
  std::array<double, 2> width{0, 0};  ///< box: extent in x and y [m]
  double height = 0.0;                ///< along the axis [m]; z = 0 is the distributor, z the column's axis
  double inclination = 0.0;           ///< of the axis from the vertical [degree]; the column leans over to -x

  /// Acceleration of gravity in the axes of the column [m/s²]: along -z where it is upright.
  [[nodiscard]] std::array<double, 3> gravity() const {
    const double angle = inclination * std::numbers::pi / 180.0;
    return {gravitational_acceleration * std::sin(angle), 0.0, -gravitational_acceleration * std::cos(angle)};
  }
  /// Area of a cut across the axis [m²].
  [[nodiscard]] double cross_section() const {
    return shape == Shape::cylinder ? 0.25 * std::numbers::pi * diameter * diameter : width[0] * width[1];
  }
};

struct Liquid {
  double density = 0.0;               ///< [kg/m³]
  double viscosity = 0.0;             ///< [Pa s]
  double superficial_velocity = 0.0;  ///< U_L at the inlet, upwards [m/s]
};

struct FluidNumerics {
  FluidTier tier = FluidTier::three_dimensional;
  LateralBoundary wall = LateralBoundary::no_slip;
  int cells_across = 8;      ///< cells over the diameter (or over width[0])
  double cell_height = 0.0;  ///< [m]; the column height is divided evenly into cells of about this height
  ConvectionScheme convection = ConvectionScheme::quick;
  TimeScheme time_scheme = TimeScheme::euler;  ///< second order: backward differences (BDF2)
  PressureVelocity pressure_velocity = PressureVelocity::projection;
  InletVelocity inlet_velocity = InletVelocity::interstitial;  ///< with which the liquid's momentum enters
  double time_step = 0.0;                                      ///< [s]
  double pressure_tolerance = 1e-6;                            ///< relative residual of the pressure equation [-]
  double simple_tolerance = 1e-5;                              ///< scaled residual that ends the SIMPLE iterations [-]
};

struct Species {
  std::string name;
  double diameter = 0.0;   ///< [m]
  double density = 0.0;    ///< [kg/m³]
  std::int64_t count = 0;  ///< bed particles at the start; 0 for a species that is only dropped

  /// Of one sphere [m³] and [kg].
  [[nodiscard]] double volume() const { return std::numbers::pi / 6.0 * std::pow(diameter, 3); }
  [[nodiscard]] double mass() const { return density * volume(); }
};

/// Where the spheres of the bed are at the start.
struct Start {
  /// lattice: jittered, filled from the bottom; random: over the whole column; random_close: in its lower part
  Arrangement arrangement = Arrangement::lattice;
};

enum class RollingModel { constant_torque, elastic_plastic };
enum class RollingRadius { own, reduced };
enum class TangentialModel { spring_dashpot, dashpot, spring };
enum class Integrator { symplectic_euler, velocity_verlet, position_verlet, gear };

/// What the walls have of their own; without a value: as between spheres.
struct WallContact {
  std::optional<double> stiffness;         ///< linear: k_n of a sphere at a wall [N/m]
  std::optional<double> youngs_modulus;    ///< hertz: E of the wall's material [Pa]
  std::optional<double> poisson_ratio;     ///< hertz: ν of the wall's material [-]
  std::optional<double> restitution;       ///< e [-]
  std::optional<double> sliding_friction;  ///< μ [-]
  std::optional<double> rolling_friction;  ///< μ_rol [-]
};

/// Soft-sphere contact of pairs and, where `wall` has no other value, of walls (Peng 2014, Table 1).
struct Contact {
  std::string law = "linear";     ///< of solver/dem/contact_laws.cpp, or a C++ file (solver/laws/user_law.hpp)
  double stiffness = 0.0;         ///< linear: k_n [N/m]
  double youngs_modulus = 0.0;    ///< hertz: E [Pa]
  double poisson_ratio = 0.25;    ///< hertz: ν [-]
  bool rigid_walls = false;       ///< hertz: walls do not deform
  double restitution = 0.9;       ///< e [-]
  bool cut_tension = false;       ///< no pull just before spheres part; raises the restitution above e
  double sliding_friction = 0.3;  ///< μ [-]
  double rolling_friction = 0.0;  ///< μ_rol of Eq. 18 [-]
  RollingModel rolling_model = RollingModel::constant_torque;
  RollingRadius rolling_radius = RollingRadius::own;  ///< constant torque: whose radius is its lever arm
  double rolling_damping_ratio = 0.3;                 ///< elastic-plastic: η_r (Ai et al. 2011) [-]
  double tangential_stiffness_ratio = 2.0 / 7.0;      ///< linear: k_t / k_n [-]; the paper does not say
  double tangential_damping_ratio = 0.5;  ///< linear: tangential over normal damping [-]; the paper does not say
  TangentialModel tangential_model = TangentialModel::spring_dashpot;  ///< linear
  Integrator integrator = Integrator::symplectic_euler;
  double time_step = 0.0;              ///< [s]
  bool allow_large_time_step = false;  ///< accept a step above 1/ω_0 of the stiffest pair
  WallContact wall;

  /// That of a sphere and a wall. Young's modulus and Poisson's ratio stay those of the spheres: a contact has both
  /// bodies', and the law finds those of the other in `wall`.
  [[nodiscard]] Contact at_wall() const {
    Contact contact = *this;
    contact.stiffness = wall.stiffness.value_or(stiffness);
    contact.restitution = wall.restitution.value_or(restitution);
    contact.sliding_friction = wall.sliding_friction.value_or(sliding_friction);
    contact.rolling_friction = wall.rolling_friction.value_or(rolling_friction);
    return contact;
  }
};

struct Coupling {
  std::string drag_law = "gidaspow-1994";
  bool drag_times_voidage = false;  ///< the drag of the law is multiplied by α once more (Peng 2014, Eq. 20 as printed)
  VoidFractionScheme void_fraction = VoidFractionScheme::exact_overlap;
  int meshing_pieces = 1214;            ///< particle meshing: pieces per sphere
  double void_fraction_interval = 0.0;  ///< between computations of the void fraction [s]; 0: in every liquid step
  MomentumExchange exchange = MomentumExchange::semi_implicit;
  Interpolation interpolation = Interpolation::shares;  ///< of voidage and liquid velocity at the spheres
  double added_mass = 0.0;                              ///< C_m, 0.5 for a sphere alone; 0: none [-]
  bool saffman_lift = false;                            ///< lift by shear (Saffman 1965, Mei 1992)
  bool magnus_lift = false;             ///< lift by spin (Oesterlé & Bui Dinh 1998) and the liquid's torque
  bool basset_history = false;          ///< history force (Basset 1888)
  double lubrication_range = 0.0;       ///< gap below which squeezed liquid resists approach [m]; 0: none
  double lubrication_roughness = 5e-6;  ///< gap below which it does not grow any more [m]
  bool disturbance_correction = false;  ///< a sphere's own disturbance of voidage and velocity taken out
  /// Whether a sphere without neighbours reads its own volume and forces (coupling::LoneSpheres).
  OwnVolume own_volume = OwnVolume::spread_where_alone;
  /// Of a sphere alone in a quiescent tube: a law of the kind wall_correction (correlations/fluidisation), or "none".
  std::string wall_retardation = "none";
  double smoothing_length = 0.0;  ///< bandwidth b of the Gaussian exp(−|x|²/b²) that spreads the shares [m]; 0: none
};

struct Outlet {
  OutletRule rule = OutletRule::lid;  ///< lid: particles stay below z = height; remove: counted and taken out
};

struct Stage {
  StageKind kind = StageKind::settle;
  double duration = 0.0;  ///< [s]; for a drop: the longest wait for one sphere to arrive
  bool dry = false;       ///< settle only: without the liquid, which enters at rest at the end of the stage
  /// Fluidise only: U_L of a stage that another fluidise stage follows [m/s]; 0: that of the liquid.
  double superficial_velocity = 0.0;
  // drop only
  std::string species;          ///< the species released
  int repetitions = 1;          ///< spheres released one after the other
  double release_height = 0.0;  ///< centre of the sphere at release [m]
  double relaxation = 0.0;      ///< time between taking out one sphere and releasing the next [s]
};

struct Recording {
  double bed_interval = 0.01;         ///< between samples of the bed [s]
  double drop_interval = 0.001;       ///< between samples of the dropped sphere [s] (1000 Hz in the paper)
  double snapshot_interval = 0.0;     ///< between VTKHDF snapshots [s]; 0: none
  double checkpoint_interval = 60.0;  ///< wall-clock time between checkpoints [s]
  /// Lowest and highest centre of the cells of the plane y = 0 whose liquid velocity fluctuations are recorded [m].
  std::array<double, 2> fluctuation_window{0.1, 0.2};
};

struct Scene {
  std::string title;  ///< not part of the hash
  Geometry geometry;
  Liquid liquid;
  FluidNumerics fluid;
  std::vector<Species> species;
  Start start;
  Contact contact;
  Coupling coupling;
  Outlet outlet;
  std::vector<Stage> stages;
  Recording recording;
  std::uint64_t seed = 1;

  /// U_L in a stage that is not settling, upwards [m/s].
  [[nodiscard]] double superficial_velocity(const Stage& stage) const {
    return stage.superficial_velocity > 0.0 ? stage.superficial_velocity : liquid.superficial_velocity;
  }
  /// U_L at the start of the first such stage [m/s].
  [[nodiscard]] double first_superficial_velocity() const {
    for (const Stage& stage : stages)
      if (stage.kind != StageKind::settle) return superficial_velocity(stage);
    return liquid.superficial_velocity;
  }
};

/// Raised by hand when a change of the solver changes results by more than round-off; part of each run's name.
inline constexpr int numerics_version = 4;

}  // namespace slfb
