#include "experiments/compare/contact_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "experiments/figures/figure_support.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/hertz_mindlin.hpp"
#include "solver/dem/lubrication.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

constexpr double usual_speed = 0.1;  ///< of the spheres of a bed, about [m/s]
constexpr double grazing_angle = 80.0;

double mass_of(const Sphere& sphere) { return sphere.density * dem::Particles::volume_of(0.5 * sphere.diameter); }

double effective_mass(const Impact& impact) {
  const double mass = mass_of(impact.first);
  return impact.second ? mass * mass_of(*impact.second) / (mass + mass_of(*impact.second)) : mass;
}

double effective_radius(const Impact& impact) {
  const double radius = 0.5 * impact.first.diameter;
  return impact.second ? dem::reduced_radius(radius, 0.5 * impact.second->diameter) : radius;
}

/// The pairs of the bed: two of its spheres, the foreign sphere and one of them, one of them and a wall.
std::array<Impact, 3> pairs(const ComparisonBed& bed, double speed) {
  const Sphere& sphere = bed.bed.sphere;
  return {Impact{sphere, sphere, speed}, {bed.foreign.sphere, sphere, speed}, {sphere, {}, speed}};
}

std::string words_of(const Impact& impact, const ComparisonBed& bed) {
  const auto& [sphere, material] = bed.bed;
  const bool foreign = impact.first.density != sphere.density || impact.first.diameter != sphere.diameter;
  return fmt::format("{} on {} at {:.3g} m/s", foreign ? bed.foreign.material : material,
                     impact.second ? material : "a wall", impact.speed);
}

double modulus_of_equal_contact_time(const Contact& linear, const ComparisonBed& bed) {
  const Impact impact = bed_impact(bed);
  const double mass = effective_mass(impact);
  const double wanted = dem::LinearSpringDashpot::contact_time(linear.stiffness, linear.restitution, mass);
  // The contact time goes with the modulus to the power −2/5.
  const double at_one = dem::HertzMindlin::contact_time(1.0, effective_radius(impact), mass, impact.speed);
  const double effective_modulus = std::pow(at_one / wanted, 2.5);
  return effective_modulus * 2.0 * (1.0 - linear.poisson_ratio * linear.poisson_ratio);
}

/// What is measured of the bodies before and after: in the frame of their common centre.
struct Motion {
  double energy = 0.0;  ///< [J]
  Vec3 momentum, angular_momentum;
};

Motion motion_of(const dem::Engine& engine) {
  const auto& particles = engine.particles;
  const auto at = [](const dem::VectorField& field, std::size_t i) { return Vec3{field.x[i], field.y[i], field.z[i]}; };
  Motion motion;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3 velocity = at(particles.velocity, i), angular_velocity = at(particles.angular_velocity, i);
    const double mass = particles.mass[i], inertia = particles.inertia(i);
    motion.energy += 0.5 * (mass * dot(velocity, velocity) + inertia * dot(angular_velocity, angular_velocity));
    motion.momentum = motion.momentum + mass * velocity;
    motion.angular_momentum =
        motion.angular_momentum + mass * cross(at(particles.position, i), velocity) + inertia * angular_velocity;
  }
  return motion;
}

double relative(const std::vector<double>& component) {
  return component.size() > 1 ? component[0] - component[1] : component[0];
}

/// The bodies of an impact along z, the first from above, `gap` [m] apart.
struct TwoBodySetup {
  TwoBodySetup(const ComparedContactLaw& law, const Impact& impact, double time_step, double gap,
               const std::optional<dem::Lubrication>& lubrication = {}) {
    Contact contact = law.contact;
    contact.time_step = time_step;
    contact.rolling_friction = 0.0;
    std::vector<dem::Wall> walls;
    if (!impact.second) walls.push_back({dem::Wall::Kind::plane, 2, 1.0, 0.0});
    engine = std::make_unique<dem::Engine>(contact, law.law, walls, std::array{0.0, 0.0, 0.0}, 1);
    if (lubrication) engine->lubricate(*lubrication);
    // The frame of the common centre: each has the share of the speed that the other's mass gives.
    const double share = effective_mass(impact) / mass_of(impact.first);
    const auto add = [&](const Sphere& sphere, double height, double part) {
      const std::size_t i = engine->add_particle({0.0, 0.0, height}, 0.5 * sphere.diameter, sphere.density, 0);
      engine->particles.velocity.z[i] = -part * impact.speed;
      engine->particles.velocity.x[i] = part * impact.tangential_speed;
      return i;
    };
    add(impact.first, 0.5 * impact.first.diameter + gap, share);
    // The foot of the first moves with −ω_y r.
    engine->particles.angular_velocity.y[0] = -impact.angular_speed;
    if (impact.second) add(*impact.second, -0.5 * impact.second->diameter, share - 1.0);
  }
  std::unique_ptr<dem::Engine> engine;
};

std::string at_speed(double value, const Impact& impact, const ComparisonBed& bed) {
  return fmt::format("{:.4g} for {}", value, words_of(impact, bed));
}

/// With steps small enough to show the law itself.
Rebound resolved(const ComparedContactLaw& law, const ComparisonBed& bed, const Impact& impact) {
  Rebound rebound = collide(law, impact, resolving_step(law, impact));
  if (!rebound.parted)
    throw std::runtime_error(fmt::format("{}: {} do not part again", law.name, words_of(impact, bed)));
  return rebound;
}

// Round-off of thousands of steps, and nothing more.
constexpr double round_off = 1e-9;

PropertyCheck check_energy(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (const double speed : impact_speeds())
    for (const Impact& impact : pairs(bed, speed))
      worst.update(resolved(law, bed, impact).energy, words_of(impact, bed));
  return {"A head-on collision gives no energy", worst.value <= 1.0 + round_off,
          fmt::format("after over before at most {:.4g}, {}", worst.value, worst.where)};
}

PropertyCheck check_oblique_energy(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (const bool rotating : {false, true})
    for (double degrees = 10.0; degrees < 90.0; degrees += 10.0) {
      Impact impact = oblique_impact(bed, degrees);
      if (rotating) impact.angular_speed = impact.tangential_speed / (0.5 * impact.first.diameter);  // doubles the slip
      worst.update(resolved(law, bed, impact).energy,
                   fmt::format("{} degrees{}", degrees, rotating ? " with spin" : ""));
    }
  return {"An oblique one neither, spin counted", worst.value <= 1.0 + round_off,
          fmt::format("after over before at most {:.4g}, {}", worst.value, worst.where)};
}

PropertyCheck check_energy_at_step(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (int phase = 0; phase < 16; ++phase)
    for (double degrees = 0.0; degrees < 90.0; degrees += 10.0) {
      const Rebound rebound = collide(law, oblique_impact(bed, degrees), law.contact.time_step, (phase + 0.5) / 16.0);
      worst.update(rebound.parted ? rebound.energy : std::numeric_limits<double>::infinity(),
                   fmt::format("{} degrees", degrees));
    }
  return {
      "Nor does the step of the scene", worst.value <= 1.0 + round_off,
      fmt::format("after over before at most {:.4g} at {:.3g} s, {}", worst.value, law.contact.time_step, worst.where)};
}

PropertyCheck check_restitution(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (const double speed : impact_speeds())
    for (const Impact& impact : pairs(bed, speed)) {
      const double restitution = resolved(law, bed, impact).restitution;
      worst.update(std::abs(restitution - law.contact.restitution), at_speed(restitution, impact, bed));
    }
  return {"The restitution is contact.restitution within 0.01, at any speed", worst.value < 0.01,
          fmt::format("{} asked for; {}", law.contact.restitution, worst.where)};
}

PropertyCheck check_step(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (const Impact& impact : pairs(bed, usual_speed)) {
    const double true_value = resolved(law, bed, impact).restitution;
    const RestitutionAtStep found = restitution_at_step(law, impact);
    for (const double value : {found.lowest, found.highest})
      worst.update(std::abs(value - true_value),
                   fmt::format("{}, {:.4g} with small steps", at_speed(value, impact, bed), true_value));
  }
  return {"The step of the scene changes the restitution by less than 0.02", worst.value < 0.02, worst.where};
}

/// Overlaps over the effective radius, from a hair to a tenth, and the law there at one speed of approach [m/s].
std::vector<std::pair<double, dem::NormalContact>> normal_forces(const ComparedContactLaw& law,
                                                                 const ComparisonBed& bed, double approach) {
  const Impact impact = bed_impact(bed);
  Contact contact = law.contact;
  contact.time_step = 1e-6 * resolving_step(law, impact);  // laws may look half a step ahead
  std::vector<std::pair<double, dem::NormalContact>> points;
  for (int i = 0; i <= 100; ++i) {
    const double overlap = std::pow(10.0, -6.0 + 0.05 * i);
    points.emplace_back(overlap, law.law.normal(contact, false, overlap * effective_radius(impact), approach,
                                                std::sqrt(effective_mass(impact)), effective_radius(impact)));
  }
  return points;
}

void require_numbers(const ComparedContactLaw& law, const ComparisonBed& bed) {
  for (const double approach : {0.0, usual_speed, -usual_speed})
    for (const auto& [overlap, contact] : normal_forces(law, bed, approach))
      for (const double value :
           {contact.force, contact.load, contact.stiffness, contact.tangential_stiffness, contact.tangential_damping})
        if (!std::isfinite(value))
          throw std::runtime_error(fmt::format(
              "{}: force {} N, load {} N, stiffness {} N/m at an overlap of {:.2g} R* and an approach of {} "
              "m/s; needed are finite numbers",
              law.argument, contact.force, contact.load, contact.stiffness, overlap, approach));
}

PropertyCheck check_push(const ComparedContactLaw& law, const ComparisonBed& bed) {
  const auto points = normal_forces(law, bed, 0.0);
  const double start = points.front().second.force / points.back().second.force;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double before = i == 0 ? 0.0 : points[i - 1].second.force;
    if (!(points[i].second.force > before))
      return {"At rest the spheres push, the more the deeper, from nothing", false,
              fmt::format("{:.3g} N at an overlap of {:.2g} R*, {:.3g} N before", points[i].second.force,
                          points[i].first, before)};
  }
  return {"At rest the spheres push, the more the deeper, from nothing", start < 1e-3,
          fmt::format("{:.2g} of the force at R*/10 where they touch", start)};
}

PropertyCheck check_slope(const ComparedContactLaw& law, const ComparisonBed& bed) {
  const auto points = normal_forces(law, bed, 0.0);
  const double radius = effective_radius(bed_impact(bed));
  LargestValue worst;
  // Each power law between two neighbours has its slope in the middle.
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [lower, before] = points[i - 1];
    const auto& [upper, after] = points[i];
    const double power = std::log(after.force / before.force) / std::log(upper / lower);
    const double slope = power * std::sqrt(before.force * after.force) / std::sqrt(lower * upper) / radius;
    const double stated = std::sqrt(before.stiffness * after.stiffness);
    const double off = std::abs(stated / slope - 1.0);
    worst.update(std::isfinite(off) ? off : std::numeric_limits<double>::infinity(),
                 fmt::format("at an overlap of {:.2g} R*", std::sqrt(lower * upper)));
  }
  return {"The stiffness it states, from which the bound of the step comes, is the slope of its force",
          worst.value < 0.01, fmt::format("off by at most {:.2g} {}", worst.value, worst.where)};
}

PropertyCheck check_friction(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (double degrees = 5.0; degrees < 90.0; degrees += 5.0)
    worst.update(resolved(law, bed, oblique_impact(bed, degrees)).friction, fmt::format("at {} degrees", degrees));
  return {"Friction carries at most the sliding friction times the normal impulse",
          worst.value <= 1.005 * law.contact.sliding_friction,
          fmt::format("{:.4g} {} under a friction of {}", worst.value, worst.where, law.contact.sliding_friction)};
}

PropertyCheck check_grazing(const ComparedContactLaw& law, const ComparisonBed& bed) {
  const double found = resolved(law, bed, oblique_impact(bed, grazing_angle)).friction;
  return {
      "A grazing impact (80 degrees) slides all along",
      std::abs(found - law.contact.sliding_friction) <= 0.01 * law.contact.sliding_friction,
      fmt::format("tangential over normal impulse {:.4g} under a friction of {}", found, law.contact.sliding_friction)};
}

PropertyCheck check_momentum(const ComparedContactLaw& law, const ComparisonBed& bed) {
  LargestValue worst;
  for (Impact impact : pairs(bed, usual_speed)) {
    if (!impact.second) continue;
    impact.tangential_speed = usual_speed;
    impact.angular_speed = 10.0;
    worst.update(resolved(law, bed, impact).momentum_error, words_of(impact, bed));
  }
  return {"Momentum and angular momentum are kept to round-off", worst.value < round_off,
          fmt::format("off by {:.1g}, {}", worst.value, worst.where)};
}

PropertyCheck check_memory(const ComparedContactLaw& law, const ComparisonBed& bed) {
  const auto bits = [&](const Impact& impact) {
    const Rebound rebound = resolved(law, bed, impact);
    return std::tuple(rebound.restitution, rebound.tangential_speed, rebound.angular_speed, rebound.force);
  };
  const Impact impact = oblique_impact(bed, 45.0);
  const auto before = bits(impact);
  static_cast<void>(bits(oblique_impact(bed, 70.0)));
  const bool same = bits(impact) == before;
  return {"It remembers nothing of other contacts: the same collision twice is the same to the last bit", same,
          same ? "the same" : "differs after another collision"};
}

}  // namespace

std::vector<ComparedContactLaw> compared_contact_laws(const std::vector<std::string>& arguments, const RunSpec& run,
                                                      const ComparisonBed& bed) {
  const Contact of_scene = load_run_scene(run).contact;
  std::vector<ComparedContactLaw> laws;
  std::set<std::string> names;
  for (const std::string& argument : arguments) {
    // LAW:KEY=VALUE,KEY=VALUE; a colon between parameters is the same as a comma.
    std::string law = argument.substr(0, argument.find(':')), parameters = argument.substr(law.size());
    if (!parameters.empty()) parameters.erase(0, 1);
    std::ranges::replace(parameters, ',', ':');
    std::istringstream parts(parameters);
    ComparedContactLaw compared;
    compared.law = find_contact_law(law);
    compared.name = compared.law.info.name;
    compared.argument = law;
    compared.overrides = {"contact.law=" + law};
    bool has_modulus = false;
    for (std::string parameter; std::getline(parts, parameter, ':');) {
      if (parameter.find('=') == std::string::npos)
        throw std::invalid_argument(
            fmt::format("{}: \"{}\" is no parameter; needed is LAW:KEY=VALUE with a key of [contact], for example "
                        "linear:stiffness=2e3 N/m",
                        argument, parameter));
      has_modulus = has_modulus || parameter.starts_with("youngs_modulus");
      compared.overrides.push_back("contact." + parameter);
      compared.name += ":" + parameter;
    }
    if (law == "hertz" && !has_modulus && of_scene.law == "linear")
      compared.overrides.push_back(
          fmt::format("contact.youngs_modulus={:.3g} Pa", modulus_of_equal_contact_time(of_scene, bed)));
    if (!names.insert(compared.name).second)
      throw std::runtime_error(
          fmt::format("{}: \"{}\" is compared twice; each law needs a name of its own", argument, compared.name));
    RunSpec own = run;
    own.overrides.insert(own.overrides.end(), compared.overrides.begin(), compared.overrides.end());
    compared.contact = load_run_scene(own).contact;
    laws.push_back(std::move(compared));
  }
  return laws;
}

Impact bed_impact(const ComparisonBed& bed, double speed) { return pairs(bed, speed)[0]; }

Impact oblique_impact(const ComparisonBed& bed, double degrees) {
  Impact impact{bed.bed.sphere, {}, usual_speed};
  impact.tangential_speed = usual_speed * std::tan(degrees * std::numbers::pi / 180.0);
  return impact;
}

double resolving_step(const ComparedContactLaw& law, const Impact& impact) {
  const double radius = effective_radius(impact);
  const double stiffness = law.law.stiffness(law.contact, !impact.second, 0.01 * radius, radius);
  return 0.002 * std::sqrt(effective_mass(impact) / stiffness);
}

Rebound collide(const ComparedContactLaw& law, const Impact& impact, double time_step, double phase) {
  const TwoBodySetup setup(law, impact, time_step, (2.0 + phase) * time_step * impact.speed);
  dem::Engine& engine = *setup.engine;
  const Motion before = motion_of(engine);
  const double radius = effective_radius(impact),
               smaller = 0.5 * std::min(impact.first.diameter,
                                        impact.second ? impact.second->diameter : impact.first.diameter);
  const auto longest =
      static_cast<std::int64_t>(50.0 * 500.0 * std::numbers::pi * resolving_step(law, impact) / time_step) + 100;
  Rebound rebound;
  double tangential_impulse = 0.0, normal_impulse = 0.0;
  for (std::int64_t step = 0; step < longest && !rebound.parted; ++step) {
    engine.step();
    const auto touching = engine.touching_pairs();
    if (touching.empty()) {
      rebound.parted = !rebound.time.empty();
      continue;
    }
    const double force = touching[0].normal_force, depth = engine.maximum_overlap() * smaller / radius;
    rebound.time.push_back(static_cast<double>(rebound.time.size()) * time_step);
    rebound.force.push_back(force);
    rebound.depth.push_back(depth);
    rebound.peak_force = std::max(rebound.peak_force, force);
    rebound.overlap = std::max(rebound.overlap, depth);
    tangential_impulse += touching[0].tangential_force;
    normal_impulse += std::max(force, 0.0);
  }
  const Motion after = motion_of(engine);
  rebound.restitution = relative(engine.particles.velocity.z) / impact.speed;
  rebound.tangential_speed = relative(engine.particles.velocity.x);
  rebound.angular_speed = engine.particles.angular_velocity.y[0];
  rebound.duration = static_cast<double>(rebound.time.size()) * time_step;
  rebound.energy = after.energy / before.energy;
  rebound.friction = normal_impulse > 0.0 ? tangential_impulse / normal_impulse : 0.0;
  const double momentum = effective_mass(impact) * std::hypot(impact.speed, impact.tangential_speed);
  rebound.momentum_error = std::max(norm(after.momentum - before.momentum),
                                    norm(after.angular_momentum - before.angular_momentum) / impact.first.diameter) /
                           momentum;
  return rebound;
}

RestitutionAtStep restitution_at_step(const ComparedContactLaw& law, const Impact& impact) {
  constexpr int phases = 16;
  RestitutionAtStep found{0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int phase = 0; phase < phases; ++phase) {
    const double value = collide(law, impact, law.contact.time_step, (phase + 0.5) / phases).restitution;
    found.mean += value / phases;
    found.lowest = std::min(found.lowest, value);
    found.highest = std::max(found.highest, value);
  }
  return found;
}

ContactFindings characterise(const ComparedContactLaw& law, const ComparisonBed& bed) try {
  require_numbers(law, bed);
  ContactFindings findings;
  for (const double speed : impact_speeds()) {
    findings.head_on.push_back(resolved(law, bed, bed_impact(bed, speed)));
    findings.at_step.push_back(restitution_at_step(law, bed_impact(bed, speed)));
  }
  findings.usual = resolved(law, bed, bed_impact(bed));
  findings.usual_at_step = restitution_at_step(law, bed_impact(bed));
  for (const double degrees : impact_angles())
    findings.oblique.push_back(resolved(law, bed, oblique_impact(bed, degrees)));
  for (const double speed : wet_speeds()) findings.wet.push_back(wet_restitution(law, bed, speed));
  findings.stability_limit = stability_limit(law, bed_impact(bed), findings.usual.overlap);
  findings.seconds_per_contact = seconds_per_contact(law, bed);
  findings.properties = check_properties(law, bed);
  return findings;
} catch (const dem::EngineError& error) {
  throw std::runtime_error(fmt::format("{}: two bodies that meet: {}", law.argument, error.what()));
}

std::vector<double> impact_angles() {
  std::vector<double> angles;
  for (int i = 1; i <= 34; ++i) angles.push_back(2.5 * i);
  return angles;
}

std::vector<double> wet_speeds() {
  std::vector<double> speeds;
  for (int i = 0; i <= 20; ++i) speeds.push_back(0.003 * std::pow(10.0, 0.125 * i));
  return speeds;
}

double stability_limit(const ComparedContactLaw& law, const Impact& impact, double overlap) {
  const double radius = effective_radius(impact);
  return 2.0 *
         std::sqrt(effective_mass(impact) / law.law.stiffness(law.contact, !impact.second, overlap * radius, radius));
}

std::vector<double> impact_speeds() {
  std::vector<double> speeds;
  for (int i = 0; i <= 12; ++i) speeds.push_back(std::pow(10.0, -2.0 + i / 6.0));
  return speeds;
}

std::vector<PropertyCheck> check_properties(const ComparedContactLaw& law, const ComparisonBed& bed) {
  return {check_energy(law, bed),      check_oblique_energy(law, bed), check_energy_at_step(law, bed),
          check_restitution(law, bed), check_step(law, bed),           check_push(law, bed),
          check_slope(law, bed),       check_friction(law, bed),       check_grazing(law, bed),
          check_momentum(law, bed),    check_memory(law, bed)};
}

LubricationGaps lubrication_gaps(const ComparisonBed& bed) {
  return {0.1 * bed.bed.sphere.diameter, Coupling{}.lubrication_roughness};
}

double wet_restitution(const ComparedContactLaw& law, const ComparisonBed& bed, double speed) {
  const Impact impact{bed.bed.sphere, {}, speed};
  const auto [outer, inner] = lubrication_gaps(bed);
  const double step = 10.0 * resolving_step(law, impact);
  TwoBodySetup setup(law, impact, step, outer, dem::Lubrication{bed.liquid.viscosity, inner, outer});
  const auto& particles = setup.engine->particles;
  const double away = 0.5 * impact.first.diameter + outer;
  // At a thousandth of its speed it would need a thousand times as long: it has come to rest.
  const auto longest = static_cast<std::int64_t>(1000.0 * outer / (speed * step));
  for (std::int64_t done = 0; done < longest; done += 10) {
    setup.engine->advance(10);
    const double velocity = particles.velocity.z[0];
    if (velocity > 0.0 && particles.position.z[0] > away)
      return velocity / (speed * resolved(law, bed, impact).restitution);
    if (std::abs(velocity) < 1e-3 * speed && particles.position.z[0] > 0.5 * impact.first.diameter) break;
  }
  return 0.0;
}

std::vector<std::string> uses_outside_range(const ComparedContactLaw& law, const ComparisonBed& bed,
                                            const Measurements& measured) {
  const Range& range = law.law.info.overlap;
  std::vector<std::string> sentences;
  const auto look = [&](double overlap, const std::string& where) {
    if (!range.contains(overlap))
      sentences.push_back(fmt::format("{} {:.2g} R*; the law is meant for at most {:g}", where, overlap, range.upper));
  };
  for (const double speed : {usual_speed, 1.0}) {
    const Impact impact = bed_impact(bed, speed);
    look(resolved(law, bed, impact).overlap, words_of(impact, bed) + ": overlap of");
  }
  // Recorded over the radius, of which a wall makes all the effective one and an equal sphere half.
  for (const MeasuredPoint& point : measured_points(measured, "maximum_overlap_mean", bed.system))
    look(2.0 * point.value, fmt::format("Runs at {:.2f} m/s: deepest overlap in the bed, mean over time, up to",
                                        point.superficial_velocity));
  return sentences;
}

double seconds_per_contact(const ComparedContactLaw& law, const ComparisonBed& bed) {
  using Clock = std::chrono::steady_clock;
  const auto batch = std::make_unique<dem::ContactBatch>();
  const Impact impact = bed_impact(bed);
  const double radius = 0.5 * impact.first.diameter;
  for (std::size_t k = 0; k < dem::ContactBatch::capacity; ++k) {
    batch->radius_i(k) = batch->radius_j(k) = radius;
    batch->position_j.z[k] = radius * (2.0 - 1e-3 * (1.0 + static_cast<double>(k % 7)));
    batch->relative_velocity.z[k] = 0.01 * (static_cast<double>(k % 5) - 2.0);
    batch->relative_velocity.x[k] = 0.01 * static_cast<double>(k % 3);
    batch->root_effective_mass(k) = std::sqrt(effective_mass(impact));
  }
  const dem::ContactKernel kernel = law.law.compute[dem::rolling_index(law.contact)][0];
  // The fastest of several rounds: others use the machine too.
  double fastest = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 50; ++round) {
    constexpr int batches = 100;
    const auto start = Clock::now();
    for (int k = 0; k < batches; ++k) kernel(*batch, dem::ContactBatch::capacity, law.contact, 1.0);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    fastest = std::min(fastest, seconds / (batches * static_cast<double>(dem::ContactBatch::capacity)));
  }
  return fastest;
}

}  // namespace slfb::compare
