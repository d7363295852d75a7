#pragma once

#include <optional>
#include <string>
#include <vector>

#include "correlations/materials.hpp"
#include "experiments/compare/comparison_bed.hpp"
#include "experiments/compare/property_check.hpp"
#include "experiments/quantities/measurement.hpp"
#include "experiments/runs/campaign.hpp"
#include "solver/dem/contact_law.hpp"

/// What a contact law makes of two bodies that meet, before any bed is simulated. The particle engine moves them.
namespace slfb::compare {

/// One of the contact laws that are compared: "linear", "hertz:youngs_modulus=1e7 Pa" or "mine.cpp:stiffness=2e3 N/m".
struct ComparedContactLaw {
  std::string name;                    ///< that of the law, with the parameters that were given
  std::string argument;                ///< as contact.law names it
  std::vector<std::string> overrides;  ///< what it changes in a scene
  Contact contact;                     ///< [contact] of the scene that it is compared in
  dem::ContactLawKernels law;
};

/// The laws of a list, with the contacts of the scene of `run`. Hertz without a modulus takes the one with which two
/// spheres of the bed touch as long as under the linear law of that scene at 0.1 m/s. \throws UserLawError,
/// std::invalid_argument, SceneError; std::runtime_error where two laws have one name
std::vector<ComparedContactLaw> compared_contact_laws(const std::vector<std::string>& arguments, const RunSpec& run,
                                                      const ComparisonBed& bed);

/// Two bodies that meet, alone and without gravity.
struct Impact {
  Sphere first;
  std::optional<Sphere> second;   ///< none: a wall
  double speed = 0.1;             ///< at which the centres approach [m/s]
  double tangential_speed = 0.0;  ///< of the first body past the second [m/s]
  double angular_speed = 0.0;     ///< of the first body, positive where it adds to the slip [rad/s]
};

/// What comes of it.
struct Rebound {
  bool parted = false;       ///< false: still touching after fifty times the expected contact; the rest says nothing
  double restitution = 0.0;  ///< speed of parting over speed of approach [-]
  double duration = 0.0;     ///< [s]
  double peak_force = 0.0;   ///< normal [N]
  double overlap = 0.0;      ///< largest, over the effective radius [-]
  double energy = 0.0;       ///< kinetic, after over before, rotation included, in the frame of their common centre [-]
  double tangential_speed = 0.0;  ///< [m/s]
  double angular_speed = 0.0;     ///< of the first body, positive against the slip [rad/s]
  double friction = 0.0;          ///< Σ |F_t| over Σ max(F_n, 0) [-]
  double momentum_error = 0.0;    ///< of momentum and angular momentum, over those of the impact [-]
  /// Step by step.
  std::vector<double> time, force, depth;  ///< [s], normal force [N], overlap over the effective radius [-]
};

/// Two bodies in the particle engine, from before they touch until they part.
/// \param time_step [s]
/// \param phase where in a step they meet, 0 to 1
/// \throws dem::EngineError where the motion is lost
Rebound collide(const ComparedContactLaw& law, const Impact& impact, double time_step, double phase = 0.5);

/// Some 1500 steps per contact: what the law itself says [s].
double resolving_step(const ComparedContactLaw& law, const Impact& impact);

/// The bed's own collisions: two of its spheres that approach at `speed` [m/s].
Impact bed_impact(const ComparisonBed& bed, double speed = 0.1);
/// A sphere of the bed that comes to a wall at 0.1 m/s along the normal, under this angle to it [degrees].
Impact oblique_impact(const ComparisonBed& bed, double degrees);

/// Restitution at the step of the scene, over sixteen phases of the impact in a step [-].
struct RestitutionAtStep {
  double mean, lowest, highest;
};
RestitutionAtStep restitution_at_step(const ComparedContactLaw& law, const Impact& impact);

/// Largest stable step 2/ω of a pair at the stiffness of its deepest overlap, without damping [s].
double stability_limit(const ComparedContactLaw& law, const Impact& impact, double overlap);

/// Properties that a contact law should have. \throws std::runtime_error where bodies do not part or are lost
std::vector<PropertyCheck> check_properties(const ComparedContactLaw& law, const ComparisonBed& bed);

/// Restitution of a sphere of the bed that hits a wall in the liquid at `speed` [m/s], over the dry one, under the
/// suite's lubrication force [-]; 0 where it comes to rest.
double wet_restitution(const ComparedContactLaw& law, const ComparisonBed& bed, double speed);
/// Gap within which that force acts, a tenth of the diameter unless the scene says more, and the roughness [m].
struct LubricationGaps {
  double outer, inner;
};
LubricationGaps lubrication_gaps(const ComparisonBed& bed);

/// Where the law is used outside its range of overlaps, one sentence each: in head-on collisions of the bed's spheres,
/// and in runs. A law has none where it states none.
std::vector<std::string> uses_outside_range(const ComparedContactLaw& law, const ComparisonBed& bed,
                                            const Measurements& measured);

/// Time of one contact between spheres of the bed in full batches on one core [s].
double seconds_per_contact(const ComparedContactLaw& law, const ComparisonBed& bed);

/// The speeds [m/s] and angles [degrees] at which laws are compared.
std::vector<double> impact_speeds(), wet_speeds(), impact_angles();

/// What is known of one law without a bed.
struct ContactFindings {
  std::vector<PropertyCheck> properties;
  std::vector<Rebound> head_on;            ///< bed_impact at impact_speeds()
  std::vector<RestitutionAtStep> at_step;  ///< the same
  Rebound usual;                           ///< bed_impact at 0.1 m/s
  RestitutionAtStep usual_at_step;         ///< the same
  std::vector<Rebound> oblique;            ///< oblique_impact at impact_angles()
  std::vector<double> wet;                 ///< wet_restitution at wet_speeds()
  double stability_limit;                  ///< of the pair of the bed [s]
  double seconds_per_contact;              ///< [s]
};
/// \throws std::runtime_error, naming the law, where it gives no numbers or bodies do not part or are lost
ContactFindings characterise(const ComparedContactLaw& law, const ComparisonBed& bed);

}  // namespace slfb::compare
