#include "correlations/catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "correlations/classification/classification_laws.hpp"
#include "correlations/collision/collision_laws.hpp"
#include "correlations/collision/stokes_number.hpp"
#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/single_sphere/single_sphere_laws.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/fluidisation/fluidisation_laws.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/law_list.hpp"

namespace slfb {

namespace {

constexpr std::array arguments{
    Argument{"voidage", "e", "1", "liquid volume fraction", &LawArguments::voidage, false, 1.0},
    Argument{"re", "Re", "1", "Reynolds number as the law defines it", &LawArguments::reynolds, true},
    Argument{"diameter", "d", "m", "diameter of the (bed) particle, d1 beside a foreign one", &LawArguments::diameter},
    Argument{"particle_density", "rho_P", "kg/m3", "density of the (bed) particle", &LawArguments::particle_density},
    Argument{"foreign_diameter", "d2", "m", "diameter of the foreign particle", &LawArguments::foreign_diameter},
    Argument{"foreign_density", "rho_2", "kg/m3", "density of the foreign particle", &LawArguments::foreign_density},
    Argument{"density", "rho", "kg/m3", "density of the liquid", &LawArguments::liquid_density},
    Argument{"viscosity", "mu", "Pa s", "viscosity of the liquid", &LawArguments::viscosity},
    Argument{"superficial_velocity", "U_L", "m/s", "superficial liquid velocity", &LawArguments::superficial_velocity},
    Argument{"settling_velocity", "V2", "m/s", "settling velocity of the foreign particle",
             &LawArguments::settling_velocity, true},
    Argument{"column_diameter", "D", "m", "inner diameter of the column", &LawArguments::column_diameter},
    Argument{"kinetic_energy", "q2", "m2/s2", "3/2 <u_p^2> of one velocity component", &LawArguments::kinetic_energy},
    Argument{"foreign_kinetic_energy", "q2 of sphere 2", "m2/s2", "the same of the foreign particle",
             &LawArguments::foreign_kinetic_energy},
    Argument{"transition", "f", "1", "transition function of Ruzicka (2006), assumed between 0 and 1",
             &LawArguments::transition, true, 1.0},
    Argument{"impact_speed", "U", "m/s", "speed of the particle at impact", &LawArguments::impact_speed},
    Argument{"roughness", "k", "m", "height of the surface roughness", &LawArguments::roughness},
};

// One function object per kind turns the arguments into what its laws take, and their answer into named quantities.

constexpr auto evaluate_drag = [](const auto& law, const LawArguments& a) {
  const drag::SuspensionFlow flow{a.voidage, a.reynolds};
  const double drag = law(flow);
  const double slip = a.reynolds * a.viscosity / (a.liquid_density * a.voidage * a.diameter);
  const double coefficient = a.voidage * drag::stokes_drag_coefficient(a.diameter, a.viscosity);
  return LawAnswer{{{"dimensionless_drag", drag, "1"},
                    {"beta", drag::exchange_coefficient(drag, a.voidage, a.diameter, a.viscosity), "kg/(m3 s)"},
                    {"slip_velocity", slip, "m/s"},
                    {"drag_force", coefficient * drag * slip, "N"},
                    {"drag_force_per_slip", coefficient * drag::slip_derivative(law, flow), "N s/m"}},
                   a.reynolds};
};

constexpr auto evaluate_single_sphere = [](const auto& law, const LawArguments& a) {
  return LawAnswer{{{"drag_coefficient", drag::single_sphere::drag_coefficient(law, a.reynolds), "1"},
                    {"dimensionless_drag", law(a.reynolds), "1"},
                    {"terminal_velocity", fluidisation::terminal_velocity(law, a.particle(), a.liquid()), "m/s"}},
                   a.reynolds};
};

// Laws that need the terminal velocity of the bed particle but do not say which drag coefficient it comes from.
double terminal_reynolds(const LawArguments& a) {
  const double velocity =
      fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, a.particle(), a.liquid());
  return reynolds_number(a.liquid(), a.diameter, velocity);
}

constexpr auto evaluate_wall_correction = [](const auto& law, const LawArguments& a) {
  const double reynolds = terminal_reynolds(a);
  const double size_ratio = a.diameter / a.column_diameter;
  return LawAnswer{{{"velocity_ratio", law(size_ratio), "1"}, {"reynolds", reynolds, "1"}}, reynolds, size_ratio};
};

constexpr auto evaluate_minimum_fluidisation = [](const auto& law, const LawArguments& a) {
  const double velocity = law(fluidisation::PackedBed{a.particle(), a.liquid(), a.voidage});
  const double reynolds = reynolds_number(a.liquid(), a.diameter, velocity);
  return LawAnswer{{{"minimum_fluidisation_velocity", velocity, "m/s"}, {"reynolds", reynolds, "1"}}, reynolds};
};

constexpr auto evaluate_expansion_exponent = [](const auto& law, const LawArguments& a) {
  const fluidisation::ExpansionConditions conditions{terminal_reynolds(a), archimedes_number(a.particle(), a.liquid()),
                                                     a.diameter / a.column_diameter};
  return LawAnswer{{{"expansion_exponent", law(conditions), "1"}, {"reynolds", conditions.terminal_reynolds, "1"}},
                   conditions.terminal_reynolds,
                   conditions.diameter_ratio};
};

template <class Law>
concept HasTransition = requires(Law law) {
  law.transition;
};

// The law itself, with the assumed transition function where it has one.
template <class Law>
Law with_transition(Law law, double transition) {
  if constexpr (HasTransition<Law>) law.transition = transition;
  return law;
}

constexpr auto evaluate_classification = [](const auto& plain_law, const LawArguments& a) {
  const auto law = with_transition(plain_law, a.transition);
  const ForeignSphereInBed state = a.foreign_sphere_in_bed();
  const double velocity = law(state);
  const double slip = velocity + state.interstitial_velocity();
  const double reynolds = reynolds_number(state.liquid, state.foreign.diameter, slip);
  LawAnswer answer{
      {{"settling_velocity", velocity, "m/s"}, {"slip_velocity", slip, "m/s"}, {"reynolds", reynolds, "1"}}, reynolds};
  if constexpr (requires { law.band(state); }) {
    const auto band = law.band(state);
    answer.quantities.push_back({"settling_velocity_lower", band.lower, "m/s"});
    answer.quantities.push_back({"settling_velocity_upper", band.upper, "m/s"});
  }
  return answer;
};

constexpr auto evaluate_collision_force = [](const auto& plain_law, const LawArguments& a) {
  const auto law = with_transition(plain_law, a.transition);
  const ForeignSphereInBed state = a.foreign_sphere_in_bed();
  const double over_weight = law(state, a.settling_velocity);
  LawAnswer answer{{{"force_over_weight", over_weight, "1"}, {"force", over_weight * state.foreign.weight(), "N"}}};
  answer.size_ratio = a.foreign_diameter / a.diameter;
  answer.stokes = collision::stokes_number(state.foreign, state.liquid, a.kinetic_energy);
  if constexpr (requires { law.band(state); }) {
    const auto band = law.band(state);
    answer.quantities.push_back({"force_over_weight_lower", band.lower, "1"});
    answer.quantities.push_back({"force_over_weight_upper", band.upper, "1"});
  }
  return answer;
};

constexpr auto evaluate_radial_distribution = [](const auto& law, const LawArguments& a) {
  return LawAnswer{{{"contact_value", law(1.0 - a.voidage), "1"}}};
};

constexpr auto evaluate_collision_frequency = [](const auto& law, const LawArguments& a) {
  const double solids = 1.0 - a.voidage;
  const collision::CollisionState state{.solids = solids,
                                        .bed_diameter = a.diameter,
                                        .foreign_diameter = a.foreign_diameter,
                                        .kinetic_energy = a.kinetic_energy,
                                        .relative_velocity = a.settling_velocity,
                                        .contact_value = collision::LunSavage1986{}(solids),
                                        .foreign_kinetic_energy = a.foreign_kinetic_energy};
  const double frequency = law(state);
  return LawAnswer{{{"collision_frequency", frequency, "1/s"},
                    {"dimensionless_frequency", collision::dimensionless_frequency(frequency, state), "1"},
                    {"stokes_number", collision::stokes_number(a.particle(), a.liquid(), a.kinetic_energy), "1"}}};
};

constexpr auto evaluate_restitution = [](const auto& law, const LawArguments& a) {
  return LawAnswer{{{"restitution_over_dry",
                     law(collision::WetImpact{a.particle(), a.liquid(), a.impact_speed, a.roughness}), "1"}}};
};

template <class Laws, class Evaluate>
void add(std::vector<CatalogueEntry>& entries, Evaluate) {
  for_each_law<Laws>([&]<class Law>(const Law&) {
    entries.push_back({Law::info, [](const LawArguments& a) { return Evaluate{}(Law{}, a); }, HasTransition<Law>,
                       parameters_of<Law>(),
                       [](const LawCall& call) -> std::function<LawAnswer(const LawArguments&)> {
                         return [law = with_values<Law>(call)](const LawArguments& a) { return Evaluate{}(law, a); };
                       }});
  });
}

std::vector<CatalogueEntry> make_catalogue() {
  std::vector<CatalogueEntry> entries;
  add<drag::DragLaws>(entries, evaluate_drag);
  add<drag::single_sphere::SingleSphereLaws>(entries, evaluate_single_sphere);
  add<fluidisation::WallCorrectionLaws>(entries, evaluate_wall_correction);
  add<fluidisation::MinimumFluidisationLaws>(entries, evaluate_minimum_fluidisation);
  add<fluidisation::ExpansionExponentLaws>(entries, evaluate_expansion_exponent);
  add<classification::ClassificationLaws>(entries, evaluate_classification);
  add<collision::CollisionForceLaws>(entries, evaluate_collision_force);
  add<collision::RadialDistributionLaws>(entries, evaluate_radial_distribution);
  add<collision::CollisionFrequencyLaws>(entries, evaluate_collision_frequency);
  add<collision::RestitutionLaws>(entries, evaluate_restitution);
  return entries;
}

std::vector<std::string_view> argument_names(LawKind kind) {
  switch (kind) {
    case LawKind::drag:
      return {"voidage", "re", "diameter", "density", "viscosity"};
    case LawKind::single_sphere_drag:
      return {"re", "diameter", "particle_density", "density", "viscosity"};
    case LawKind::wall_correction:
    case LawKind::expansion_exponent:
      return {"diameter", "particle_density", "density", "viscosity", "column_diameter"};
    case LawKind::minimum_fluidisation:
      return {"voidage", "diameter", "particle_density", "density", "viscosity"};
    case LawKind::classification:
      return {"voidage",          "superficial_velocity", "diameter", "particle_density",
              "foreign_diameter", "foreign_density",      "density",  "viscosity",
              "transition"};
    case LawKind::collision_force:
      return {"voidage",         "settling_velocity", "diameter",  "particle_density", "foreign_diameter",
              "foreign_density", "density",           "viscosity", "kinetic_energy",   "transition"};
    case LawKind::radial_distribution:
      return {"voidage"};
    case LawKind::collision_frequency:
      return {"voidage",  "settling_velocity", "kinetic_energy",   "foreign_kinetic_energy",
              "diameter", "particle_density",  "foreign_diameter", "density",
              "viscosity"};
    case LawKind::restitution:
      return {"impact_speed", "diameter", "particle_density", "roughness", "density", "viscosity"};
  }
  throw std::logic_error("a kind of law without arguments");
}

}  // namespace

std::span<const Argument> all_arguments() { return arguments; }

std::vector<const Argument*> arguments_of(const CatalogueEntry& law) {
  std::vector<const Argument*> found;
  for (const std::string_view name : argument_names(law.info.kind)) {
    if (name != "transition" || law.takes_transition)
      found.push_back(std::ranges::find(arguments, name, &Argument::name));
  }
  return found;
}

const LawValue& LawAnswer::at(std::string_view name) const {
  const auto found = std::ranges::find(quantities, name, &LawValue::name);
  if (found != quantities.end()) return *found;
  std::string known;
  for (const LawValue& quantity : quantities) known += (known.empty() ? "" : ", ") + std::string(quantity.name);
  throw std::invalid_argument("the law gives no \"" + std::string(name) + "\"; it gives: " + known);
}

std::vector<const CatalogueEntry*> variants_of(std::string_view name) {
  std::vector<const CatalogueEntry*> found;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.info.variant_of == name) found.push_back(&entry);
  }
  return found;
}

const Sweep& sweep_of(LawKind kind) {
  static constexpr Sweep drag{{"Re [-]", true},
                              0.1,
                              1e4,
                              [](LawArguments a, double x) {
                                a.reynolds = x;
                                return a;
                              },
                              {"f_d/(3 pi mu d e w) [-]", true},
                              "dimensionless_drag"};
  static constexpr Sweep single_sphere_drag{{"Re [-]", true},
                                            0.1,
                                            1e5,
                                            [](LawArguments a, double x) {
                                              a.reynolds = x;
                                              return a;
                                            },
                                            {"C_D [-]", true},
                                            "drag_coefficient"};
  static constexpr Sweep wall_correction{{"d/D [-]"},
                                         0.0,
                                         0.3,
                                         [](LawArguments a, double x) {
                                           a.column_diameter = a.diameter / x;
                                           return a;
                                         },
                                         {"u/u_t [-]"},
                                         "velocity_ratio"};
  static constexpr Sweep minimum_fluidisation{{"voidage of the packed bed [-]"},
                                              0.36,
                                              0.5,
                                              [](LawArguments a, double x) {
                                                a.voidage = x;
                                                return a;
                                              },
                                              {"U_mf [m/s]"},
                                              "minimum_fluidisation_velocity"};
  static constexpr Sweep expansion_exponent{{"diameter [m]", true},
                                            5e-5,
                                            1e-2,
                                            [](LawArguments a, double x) {
                                              a.diameter = x;
                                              return a;
                                            },
                                            {"n [-]", false, {2.0, 6.0}},  // one variant has a pole
                                            "expansion_exponent"};
  static constexpr Sweep classification{
      {"U_L [m/s]"},
      0.045,
      0.25,
      [](LawArguments a, double x) {
        a.superficial_velocity = x;
        a.voidage = fluidisation::bed_voidage(drag::Doroodchi2012{}, a.particle(), a.liquid(), x, 0.4).voidage;
        return a;
      },
      {"V2 [m/s]"},
      "settling_velocity"};
  static constexpr Sweep collision_force{{"voidage [-]"},
                                         0.425,
                                         1.0,
                                         [](LawArguments a, double x) {
                                           a.voidage = x;
                                           return a;
                                         },
                                         {"F_c/(m g) [-]"},
                                         "force_over_weight"};
  static constexpr Sweep radial_distribution{{"solids fraction [-]"},
                                             0.0,
                                             0.57,
                                             [](LawArguments a, double x) {
                                               a.voidage = 1.0 - x;
                                               return a;
                                             },
                                             {"g0 [-]", true},
                                             "contact_value"};
  static constexpr Sweep collision_frequency{{"solids fraction [-]"},
                                             0.01,
                                             0.57,
                                             [](LawArguments a, double x) {
                                               a.voidage = 1.0 - x;
                                               return a;
                                             },
                                             {"f [1/s]", true},
                                             "collision_frequency"};
  static constexpr Sweep restitution{{"impact speed [m/s]", true},
                                     0.01,
                                     10.0,
                                     [](LawArguments a, double x) {
                                       a.impact_speed = x;
                                       return a;
                                     },
                                     {"e_wet/e_dry [-]"},
                                     "restitution_over_dry"};
  switch (kind) {
    case LawKind::drag:
      return drag;
    case LawKind::single_sphere_drag:
      return single_sphere_drag;
    case LawKind::wall_correction:
      return wall_correction;
    case LawKind::minimum_fluidisation:
      return minimum_fluidisation;
    case LawKind::expansion_exponent:
      return expansion_exponent;
    case LawKind::classification:
      return classification;
    case LawKind::collision_force:
      return collision_force;
    case LawKind::radial_distribution:
      return radial_distribution;
    case LawKind::collision_frequency:
      return collision_frequency;
    case LawKind::restitution:
      return restitution;
  }
  throw std::logic_error("a kind of law that cannot be drawn");
}

const std::vector<CatalogueEntry>& catalogue() {
  static const std::vector<CatalogueEntry> entries = make_catalogue();
  return entries;
}

const CatalogueEntry& find_law(std::string_view text) {
  const LawCall call = parse_law_call(text);
  std::string known;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.info.name == call.name) {
      if (call.values.empty()) return entry;
      static std::map<std::string, CatalogueEntry, std::less<>> varied;
      static std::mutex mutex;
      const std::lock_guard lock(mutex);
      const std::string name = law_call_text(call.name, call);
      if (const auto found = varied.find(name); found != varied.end()) return found->second;
      CatalogueEntry one = entry;
      one.evaluate = entry.with(call);
      const auto added = varied.emplace(name, std::move(one)).first;
      added->second.info.name = added->first;
      if (entry.info.variant_of.empty()) added->second.info.variant_of = entry.info.name;
      return added->second;
    }
    known += (known.empty() ? "" : ", ") + std::string(entry.info.name);
  }
  throw std::invalid_argument("unknown law \"" + call.name + "\"; known: " + known);
}

bool in_range(const LawInfo& info, const LawArguments& a, const LawAnswer& evaluation) {
  const std::vector<std::string_view> taken = argument_names(info.kind);
  const bool takes_voidage = std::ranges::find(taken, "voidage") != taken.end();
  return (!takes_voidage || info.voidage.contains(a.voidage)) &&
         (std::isnan(evaluation.reynolds) || info.reynolds.contains(evaluation.reynolds)) &&
         (std::isnan(evaluation.size_ratio) || info.size_ratio.contains(evaluation.size_ratio)) &&
         (std::isnan(evaluation.stokes) || info.stokes.contains(evaluation.stokes));
}

std::string_view to_string(LawKind kind) {
  switch (kind) {
    case LawKind::drag:
      return "drag";
    case LawKind::single_sphere_drag:
      return "single-sphere-drag";
    case LawKind::wall_correction:
      return "wall-correction";
    case LawKind::minimum_fluidisation:
      return "minimum-fluidisation";
    case LawKind::expansion_exponent:
      return "expansion-exponent";
    case LawKind::classification:
      return "classification";
    case LawKind::collision_force:
      return "collision-force";
    case LawKind::radial_distribution:
      return "radial-distribution";
    case LawKind::collision_frequency:
      return "collision-frequency";
    case LawKind::restitution:
      return "restitution";
  }
  throw std::logic_error("a kind of law without a name");
}

std::string_view to_string(Confidence confidence) {
  switch (confidence) {
    case Confidence::read:
      return "read";
    case Confidence::recalled:
      return "recalled";
    case Confidence::derived:
      return "derived";
    case Confidence::reconstructed:
      return "reconstructed";
  }
  throw std::logic_error("a confidence without a name");
}

}  // namespace slfb
