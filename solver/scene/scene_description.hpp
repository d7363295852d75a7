#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_laws.hpp"
#include "solver/scene/units.hpp"

/// Every key of a scene file, once: where it goes, what it measures and what it may be. The reader, the writer and
/// the range check walk this description, so that none of them can know a key that the others do not.
namespace slfb::description {

/// Interval of the values allowed, in SI.
struct Allowed {
  double lower = -std::numeric_limits<double>::infinity();
  bool lower_included = false;
  double upper = std::numeric_limits<double>::infinity();
  bool upper_included = false;
  std::string_view words;
  [[nodiscard]] constexpr bool contains(double value) const {
    return (lower_included ? value >= lower : value > lower) && (upper_included ? value <= upper : value < upper);
  }
};

inline constexpr double no_limit = std::numeric_limits<double>::infinity();
inline constexpr Allowed positive{0.0, false, no_limit, false, "greater than zero"};
inline constexpr Allowed not_negative{0.0, true, no_limit, false, "zero or greater"};
inline constexpr Allowed above_zero_to_one{0.0, false, 1.0, true, "greater than 0 and at most 1"};
inline constexpr Allowed zero_to_half{0.0, true, 0.5, true, "from 0 to 0.5"};
inline constexpr Allowed leaning{0.0, true, 90.0, false, "from 0 (upright) to below 90 degree"};
inline constexpr Allowed between_zero_and_one{0.0, false, 1.0, false, "between 0 and 1"};
/// Whole numbers: what TOML's signed integers and the arrays behind them hold.
inline constexpr Allowed one_to_a_million{1.0, true, 1e6, true, "a whole number from 1 to 1000000"};
inline constexpr Allowed zero_to_a_billion{0.0, true, 1e9, true, "a whole number from 0 to 1000000000"};

inline Presence required_if(bool condition, std::string_view reason) {
  return condition ? required : Presence{Presence::Rule::meaningless, std::string(reason)};
}
inline Presence optional_if(bool condition, std::string_view reason) {
  return condition ? optional : Presence{Presence::Rule::meaningless, std::string(reason)};
}

/// Optional, and not written while it has its default: a key that came after runs were named by their hashes.
/// \param value of the scene at hand
template <class Value>
Presence left_out_if_default(const Value& value, const Value& default_value) {
  return {Presence::Rule::optional, {}, value == default_value};
}

/// The same for a key that has a meaning under a condition only.
template <class Value>
Presence left_out_if_default(const Value& value, const Value& default_value, bool condition, std::string_view reason) {
  return condition ? left_out_if_default(value, default_value) : optional_if(false, reason);
}

/// Optional, and not part of the hash while it has the only value that there was when runs were named by their hashes.
inline Presence left_out_of_name_if(bool only_value_then) {
  return {Presence::Rule::optional, {}, false, only_value_then};
}

template <class Enum>
struct Choice {
  std::string_view word;
  Enum value;
};
template <class Enum>
Choice(std::string_view, Enum) -> Choice<Enum>;  // clang 14 does not deduce it for aggregates

inline constexpr std::array shapes{Choice{"cylinder", Shape::cylinder}, Choice{"box", Shape::box}};
inline constexpr std::array tiers{Choice{"quiescent", FluidTier::quiescent},
                                  Choice{"one-dimensional", FluidTier::one_dimensional},
                                  Choice{"three-dimensional", FluidTier::three_dimensional}};
inline constexpr std::array walls{Choice{"no-slip", LateralBoundary::no_slip}, Choice{"slip", LateralBoundary::slip},
                                  Choice{"periodic", LateralBoundary::periodic}};
inline constexpr std::array rolling_models{Choice{"constant-torque", RollingModel::constant_torque},
                                           Choice{"elastic-plastic", RollingModel::elastic_plastic}};
inline constexpr std::array rolling_radii{Choice{"own", RollingRadius::own}, Choice{"reduced", RollingRadius::reduced}};
inline constexpr std::array tangential_models{Choice{"spring-dashpot", TangentialModel::spring_dashpot},
                                              Choice{"dashpot", TangentialModel::dashpot},
                                              Choice{"spring", TangentialModel::spring}};
inline constexpr std::array integrators{
    Choice{"symplectic-euler", Integrator::symplectic_euler}, Choice{"velocity-verlet", Integrator::velocity_verlet},
    Choice{"position-verlet", Integrator::position_verlet}, Choice{"gear", Integrator::gear}};
inline constexpr std::array convections{
    Choice{"upwind", ConvectionScheme::upwind}, Choice{"central", ConvectionScheme::central},
    Choice{"quick", ConvectionScheme::quick}, Choice{"muscl", ConvectionScheme::muscl}};
inline constexpr std::array time_schemes{Choice{"euler", TimeScheme::euler},
                                         Choice{"second-order", TimeScheme::second_order}};
inline constexpr std::array pressure_velocities{Choice{"projection", PressureVelocity::projection},
                                                Choice{"simple", PressureVelocity::simple}};
inline constexpr std::array void_fractions{Choice{"centroid", VoidFractionScheme::centroid},
                                           Choice{"particle-meshing", VoidFractionScheme::particle_meshing},
                                           Choice{"exact-overlap", VoidFractionScheme::exact_overlap}};
inline constexpr std::array inlet_velocities{Choice{"interstitial", InletVelocity::interstitial},
                                             Choice{"superficial", InletVelocity::superficial}};
inline constexpr std::array exchanges{Choice{"explicit", MomentumExchange::explicit_in_time},
                                      Choice{"semi-implicit", MomentumExchange::semi_implicit},
                                      Choice{"implicit", MomentumExchange::implicit}};
inline constexpr std::array interpolations{Choice{"shares", Interpolation::shares},
                                           Choice{"gradient", Interpolation::gradient},
                                           Choice{"trilinear", Interpolation::trilinear}};
inline constexpr std::array own_volumes{Choice{"counted", OwnVolume::counted},
                                        Choice{"spread-where-alone", OwnVolume::spread_where_alone}};
inline constexpr std::array outlet_rules{Choice{"lid", OutletRule::lid}, Choice{"remove", OutletRule::remove}};
inline constexpr std::array arrangements{Choice{"lattice", Arrangement::lattice}, Choice{"random", Arrangement::random},
                                         Choice{"random-close", Arrangement::random_close}};
inline constexpr std::array stage_kinds{Choice{"settle", StageKind::settle}, Choice{"fluidise", StageKind::fluidise},
                                        Choice{"drop", StageKind::drop}};

template <class Enum, std::size_t N>
std::string_view word_of(Enum value, const std::array<Choice<Enum>, N>& choices) {
  return std::ranges::find(choices, value, &Choice<Enum>::value)->word;
}

/// Walks the scene. A visitor has text, law, boolean, integer, number, optional_number, pair, choice and
/// particle_count, each called
/// with the key, the value and the rules; section(name, body) and sections(name, items, body) open the tables.
template <class Visitor>
void describe(Visitor& visitor, Scene& scene, const SceneLaws& laws) {
  namespace u = units;
  visitor.text("title", scene.title, optional);
  visitor.integer("seed", scene.seed, Allowed{0.0, true, 0x1p63, false, "a whole number below 2^63"}, optional);
  visitor.section("geometry", [&] {
    auto& geometry = scene.geometry;
    visitor.choice("shape", geometry.shape, shapes, required);
    visitor.number("diameter", geometry.diameter, u::length, positive,
                   required_if(geometry.shape == Shape::cylinder, "it belongs to shape = \"cylinder\""));
    visitor.pair("width", geometry.width, u::length, positive,
                 required_if(geometry.shape == Shape::box, "it belongs to shape = \"box\""));
    visitor.number("height", geometry.height, u::length, positive, required);
    visitor.number("inclination", geometry.inclination, u::angle, leaning,
                   left_out_if_default(geometry.inclination, Geometry{}.inclination));
  });
  visitor.section("liquid", [&] {
    auto& liquid = scene.liquid;
    visitor.number("density", liquid.density, u::density, positive, required);
    visitor.number("viscosity", liquid.viscosity, u::viscosity, positive, required);
    visitor.number("superficial_velocity", liquid.superficial_velocity, u::velocity, not_negative, required);
  });
  visitor.section("fluid", [&] {
    auto& fluid = scene.fluid;
    visitor.choice("tier", fluid.tier, tiers, required);
    const Presence& flowing = fluid.tier == FluidTier::quiescent ? optional : required;
    visitor.choice("wall", fluid.wall, walls, optional);
    visitor.integer("cells_across", fluid.cells_across, one_to_a_million, optional);
    visitor.number("cell_height", fluid.cell_height, u::length, positive, flowing);
    visitor.choice("convection", fluid.convection, convections, optional);
    visitor.choice("time_scheme", fluid.time_scheme, time_schemes, optional);
    visitor.choice("pressure_velocity", fluid.pressure_velocity, pressure_velocities, optional);
    visitor.choice("inlet_velocity", fluid.inlet_velocity, inlet_velocities,
                   left_out_if_default(fluid.inlet_velocity, FluidNumerics{}.inlet_velocity));
    visitor.number("time_step", fluid.time_step, u::time, positive, flowing);
    visitor.number("pressure_tolerance", fluid.pressure_tolerance, u::ratio, between_zero_and_one, optional);
    visitor.number("simple_tolerance", fluid.simple_tolerance, u::ratio, between_zero_and_one, optional);
  });
  visitor.section("start", [&] {
    visitor.choice("arrangement", scene.start.arrangement, arrangements,
                   left_out_if_default(scene.start.arrangement, Start{}.arrangement));
  });
  visitor.section("contact", [&] {
    auto& contact = scene.contact;
    visitor.law("law", contact.law, optional);
    const auto of_law = [&](std::string_view key) { return laws.contact_key(contact.law, key); };
    // A law that can do without a modulus may be given 0, which is what it finds without the key.
    const auto modulus = [&](const std::string& key, double& value, const u::Dimension& dimension) {
      const Presence presence = of_law(key);
      visitor.number(key, value, dimension, presence.rule == Presence::Rule::required ? positive : not_negative,
                     presence);
    };
    modulus("stiffness", contact.stiffness, u::stiffness);
    modulus("youngs_modulus", contact.youngs_modulus, u::pressure);
    visitor.number("poisson_ratio", contact.poisson_ratio, u::ratio, zero_to_half, of_law("poisson_ratio"));
    visitor.boolean("rigid_walls", contact.rigid_walls, of_law("rigid_walls"));
    visitor.number("restitution", contact.restitution, u::ratio, above_zero_to_one, of_law("restitution"));
    visitor.boolean("cut_tension", contact.cut_tension, of_law("cut_tension"));
    visitor.number("sliding_friction", contact.sliding_friction, u::ratio, not_negative, optional);
    visitor.number("rolling_friction", contact.rolling_friction, u::ratio, not_negative, optional);
    visitor.choice("rolling_model", contact.rolling_model, rolling_models, optional);
    const bool plastic = contact.rolling_model == RollingModel::elastic_plastic;
    visitor.choice("rolling_radius", contact.rolling_radius, rolling_radii,
                   optional_if(!plastic, "it belongs to rolling_model = \"constant-torque\""));
    visitor.number("rolling_damping_ratio", contact.rolling_damping_ratio, u::ratio, not_negative,
                   optional_if(plastic, "it belongs to rolling_model = \"elastic-plastic\""));
    Presence model = of_law("tangential_model");
    model.left_out = contact.tangential_model == Contact{}.tangential_model;
    visitor.choice("tangential_model", contact.tangential_model, tangential_models, model);
    const auto unless = [&](TangentialModel other, std::string_view key, std::string_view reason) {
      return contact.tangential_model == other ? optional_if(false, reason) : of_law(key);
    };
    visitor.number("tangential_stiffness_ratio", contact.tangential_stiffness_ratio, u::ratio, positive,
                   unless(TangentialModel::dashpot, "tangential_stiffness_ratio",
                          "there is no spring with tangential_model = \"dashpot\""));
    visitor.number("tangential_damping_ratio", contact.tangential_damping_ratio, u::ratio, not_negative,
                   unless(TangentialModel::spring, "tangential_damping_ratio",
                          "there is no dashpot with tangential_model = \"spring\""));
    visitor.choice("integrator", contact.integrator, integrators, optional);
    visitor.number("time_step", contact.time_step, u::time, positive, required);
    visitor.boolean("allow_large_time_step", contact.allow_large_time_step, optional);
  });
  visitor.section("wall", [&] {
    const Contact& contact = scene.contact;
    WallContact& wall = scene.contact.wall;
    const auto of_law = [&](std::string_view key) {
      const Presence presence = laws.contact_key(contact.law, key);
      return presence.rule == Presence::Rule::required ? optional : presence;
    };
    const auto of_deforming_wall = [&](std::string_view key) {
      return contact.rigid_walls ? optional_if(false, "contact.rigid_walls = true") : of_law(key);
    };
    visitor.optional_number("stiffness", wall.stiffness, u::stiffness, positive, of_law("stiffness"));
    visitor.optional_number("youngs_modulus", wall.youngs_modulus, u::pressure, positive,
                            of_deforming_wall("youngs_modulus"));
    visitor.optional_number("poisson_ratio", wall.poisson_ratio, u::ratio, zero_to_half,
                            of_deforming_wall("poisson_ratio"));
    visitor.optional_number("restitution", wall.restitution, u::ratio, above_zero_to_one, of_law("restitution"));
    visitor.optional_number("sliding_friction", wall.sliding_friction, u::ratio, not_negative, optional);
    visitor.optional_number("rolling_friction", wall.rolling_friction, u::ratio, not_negative, optional);
  });
  visitor.section("coupling", [&] {
    auto& coupling = scene.coupling;
    visitor.law("drag_law", coupling.drag_law, optional);
    visitor.boolean("drag_times_voidage", coupling.drag_times_voidage,
                    left_out_if_default(coupling.drag_times_voidage, false));
    visitor.choice("void_fraction", coupling.void_fraction, void_fractions, optional);
    visitor.integer("meshing_pieces", coupling.meshing_pieces, one_to_a_million, optional);
    visitor.number("void_fraction_interval", coupling.void_fraction_interval, u::time, not_negative, optional);
    visitor.choice("exchange", coupling.exchange, exchanges, optional);
    visitor.choice("interpolation", coupling.interpolation, interpolations, optional);
    visitor.number("added_mass", coupling.added_mass, u::ratio, not_negative, optional);
    visitor.boolean("saffman_lift", coupling.saffman_lift, optional);
    visitor.boolean("magnus_lift", coupling.magnus_lift, optional);
    visitor.boolean("basset_history", coupling.basset_history, optional);
    visitor.number("lubrication_range", coupling.lubrication_range, u::length, not_negative, optional);
    visitor.number("lubrication_roughness", coupling.lubrication_roughness, u::length, positive, optional);
    visitor.boolean("disturbance_correction", coupling.disturbance_correction, optional);
    visitor.choice("own_volume", coupling.own_volume, own_volumes,
                   left_out_of_name_if(coupling.own_volume == OwnVolume::counted));
    visitor.text("wall_retardation", coupling.wall_retardation,
                 left_out_if_default(coupling.wall_retardation, Coupling{}.wall_retardation,
                                     scene.fluid.tier == FluidTier::quiescent, "it belongs to tier = \"quiescent\""));
    visitor.number("smoothing_length", coupling.smoothing_length, u::length, not_negative, optional);
  });
  visitor.section("outlet", [&] { visitor.choice("particles", scene.outlet.rule, outlet_rules, optional); });
  visitor.section("recording", [&] {
    auto& recording = scene.recording;
    visitor.number("bed_interval", recording.bed_interval, u::time, positive, optional);
    visitor.number("drop_interval", recording.drop_interval, u::time, positive, optional);
    visitor.number("snapshot_interval", recording.snapshot_interval, u::time, not_negative, optional);
    visitor.number("checkpoint_interval", recording.checkpoint_interval, u::time, positive, optional);
    visitor.pair("fluctuation_window", recording.fluctuation_window, u::length, not_negative,
                 left_out_if_default(recording.fluctuation_window, Recording{}.fluctuation_window));
  });
  visitor.sections("species", scene.species, [&](Species& species) {
    visitor.text("name", species.name, required);
    visitor.number("diameter", species.diameter, u::length, positive, required);
    visitor.number("density", species.density, u::density, positive, required);
    visitor.particle_count(species);
  });
  visitor.sections("stage", scene.stages, [&](Stage& stage) {
    visitor.choice("kind", stage.kind, stage_kinds, required);
    const bool drop = stage.kind == StageKind::drop;
    constexpr std::string_view drop_only = "it belongs to kind = \"drop\"";
    visitor.number("duration", stage.duration, u::time, positive, required);
    visitor.boolean("dry", stage.dry,
                    left_out_if_default(stage.dry, Stage{}.dry, stage.kind == StageKind::settle,
                                        "it belongs to kind = \"settle\""));
    visitor.number("superficial_velocity", stage.superficial_velocity, u::velocity, not_negative,
                   left_out_if_default(stage.superficial_velocity, 0.0, stage.kind == StageKind::fluidise,
                                       "it belongs to kind = \"fluidise\""));
    visitor.text("species", stage.species, required_if(drop, drop_only));
    visitor.integer("repetitions", stage.repetitions, one_to_a_million, optional_if(drop, drop_only));
    visitor.number("release_height", stage.release_height, u::length, positive, required_if(drop, drop_only));
    visitor.number("relaxation", stage.relaxation, u::time, not_negative, optional_if(drop, drop_only));
  });
}

}  // namespace slfb::description
