#include "solver/laws/scene_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "correlations/drag/drag_laws.hpp"
#include "solver/dem/contact_laws.hpp"
#include "solver/dem/packing.hpp"
#include "solver/dem/particles.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/scene/scene_checks.hpp"
#include "solver/scene/scene_text.hpp"
#include "solver/scene/units.hpp"
#include "solver/support/files.hpp"

namespace slfb {
namespace {

using description::Presence;
using description::Problems;

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", text); }

/// A law of the suite takes the keys that it declares; one from a file may take any.
Presence contact_key(const std::string& law, std::string_view key) {
  const auto laws = dem::contact_laws();
  const auto own = std::ranges::find(laws, law, [](const auto& known) { return known.info.name; });
  if (own == laws.end()) return description::optional;
  std::vector<std::string> takers;
  for (const dem::ContactLawKernels& known : laws)
    if (known.info.key(key) != nullptr) takers.push_back(in_quotes(known.info.name));
  if (takers.empty()) return description::optional;  // no law declares it: it is not of a law
  if (const dem::ContactKey* declared = own->info.key(key))
    return declared->required ? description::required : description::optional;
  return {Presence::Rule::meaningless, fmt::format("it belongs to law = {}", fmt::join(takers, " or "))};
}

/// Keys of the laws of the suite that make a contact stiffer: "contact.stiffness or contact.youngs_modulus".
std::string stiffness_keys() {
  std::vector<std::string> keys;
  for (const dem::ContactLawKernels& law : dem::contact_laws())
    keys.push_back(fmt::format("contact.{}", law.info.stiffness_key));
  return fmt::format("{}", fmt::join(keys, " or "));
}

void check_contact(const Scene& scene, Problems& problems) {
  const Contact& contact = scene.contact;
  const auto wrong_law = [&](const std::string& message) {
    problems.add("contact.law", in_quotes(contact.law), message);
  };
  std::string_view stiffness_key;
  try {
    if (is_user_law(contact.law) && NoForeignCode::holds()) {
      user_law_text(contact.law);  // that it can be read is all that is asked
      return;
    }
    stiffness_key = find_contact_law(contact.law).info.stiffness_key;
  } catch (const UserLawError& error) {
    return wrong_law(error.what());
  } catch (const std::invalid_argument&) {
    std::string names;
    for (const auto& known : dem::contact_laws()) names += in_quotes(known.info.name) + ", ";
    return wrong_law(fmt::format("unknown contact law; allowed is {}or a file that ends with .cpp", names));
  }
  double bound = 0.0;
  try {
    bound = contact_time_step_bound(scene);
  } catch (const std::exception& error) {
    return wrong_law(fmt::format("fails when it is asked for its stiffness: {}", error.what()));
  } catch (...) {
    return wrong_law("throws something that is no std::exception when it is asked for its stiffness");
  }
  if (is_user_law(contact.law) && !scene.species.empty() && !(bound > 0.0 && std::isfinite(bound)))
    return wrong_law(
        fmt::format("gives no stiffness above zero at an overlap of a hundredth of the effective radius; does it need "
                    "{}?",
                    stiffness_keys()));
  if (contact.allow_large_time_step || contact.time_step <= bound) return;
  std::string softer = stiffness_key.empty() ? "law" : fmt::format("contact.{}", stiffness_key);
  if (contact.wall.stiffness || contact.wall.youngs_modulus) softer += fmt::format(" or wall.{}", stiffness_key);
  problems.add("contact.time_step", units::with_unit(contact.time_step, units::time),
               fmt::format("is above the bound 1/ω_0 = sqrt(m_eff/k_n) = {} s of the stiffest pair; allowed is at most "
                           "that, a softer {}, or contact.allow_large_time_step = true",
                           units::rounded(bound), softer));
}

void check_start(const Scene& scene, Problems& problems) {
  const std::string problem = dem::start_problem(scene);
  if (!problem.empty())
    problems.add("geometry.height", units::with_unit(scene.geometry.height, units::length), problem);
}

void check_drag_law(const Scene& scene, Problems& problems) {
  const std::string& law = scene.coupling.drag_law;
  try {
    if (is_user_law(law) && NoForeignCode::holds())
      user_law_text(user_law_file(law));
    else
      find_drag_law(law);
  } catch (const UserLawError& error) {
    problems.add("coupling.drag_law", in_quotes(law), error.what());
  } catch (const std::invalid_argument& error) {
    const std::string name = law.substr(0, end_of_law_name(law));
    bool known = false;
    for_each_law<drag::DragLaws>([&](const auto& one) { known = known || one.info.name == name; });
    problems.add("coupling.drag_law", in_quotes(law),
                 known ? error.what()
                       : fmt::format("unknown drag law; allowed is {}, or a file that ends with .cpp",
                                     law_names<drag::DragLaws>()));
  }
}

std::string place(const std::string& law, const std::string& scene_file) {
  const std::filesystem::path file(user_law_file(law));
  if (!is_user_law(law) || file.is_absolute()) return law;
  const auto beside = std::filesystem::path(scene_file).parent_path() / file;
  return std::filesystem::exists(beside) ? beside.string() + law.substr(file.string().size()) : law;
}

/// A law from outside the suite is what its file says, not where the file lies.
std::string identity(const std::string& law) {
  if (!is_user_law(law)) return law;
  const std::string file = user_law_file(law);
  return user_law_hash(file) + law.substr(file.size());
}

constexpr description::SceneLaws laws_of_the_suite{contact_key,    check_contact, check_start,
                                                   check_drag_law, place,         identity};

}  // namespace

Scene load_scene(const std::filesystem::path& file, const Overrides& overrides) {
  std::string text;
  try {
    text = read_file(file);
  } catch (const std::runtime_error&) {
    throw SceneError(fmt::format("{}: cannot be read; needed is a scene file (TOML)", file.string()));
  }
  if (text.empty()) throw SceneError(fmt::format("{}: is empty; needed is a scene file (TOML)", file.string()));
  return parse_scene(text, file.string(), overrides);
}

Scene parse_scene(const std::string& text, const std::string& origin, const Overrides& overrides) {
  return description::read_scene(text, origin, overrides, laws_of_the_suite);
}

Scene parse_archived_scene(const std::string& text, const std::string& origin) {
  Scene unwritten;
  unwritten.coupling.own_volume = OwnVolume::counted;
  return description::read_scene(text, origin, {}, laws_of_the_suite, unwritten);
}

void validate_scene(const Scene& scene) {
  Problems problems("scene");
  description::check_scene(scene, problems, laws_of_the_suite);
}

std::string canonical_toml(const Scene& scene) { return description::canonical_text(scene, laws_of_the_suite); }

std::string scene_hash(const Scene& scene) { return description::hash_of(scene, laws_of_the_suite); }

double contact_time_step_bound(const Scene& scene) {
  const auto is_dropped = [&](const Species& species) {
    return std::ranges::any_of(scene.stages, [&](const Stage& stage) {
      return stage.kind == StageKind::drop && stage.species == species.name;
    });
  };
  const dem::ContactLawKernels law = find_contact_law(scene.contact.law);
  double bound = std::numeric_limits<double>::infinity();
  const Contact wall_contact = scene.contact.at_wall();
  const auto pair_of = [&](double effective_mass, double effective_radius, bool at_wall = false) {
    // Where the stiffness depends on the overlap: at a hundredth of the effective radius.
    const double stiffness =
        law.stiffness(at_wall ? wall_contact : scene.contact, at_wall, 0.01 * effective_radius, effective_radius);
    bound = std::min(bound, std::sqrt(effective_mass / stiffness));
  };
  for (const Species& a : scene.species) {
    const double mass = a.mass(), radius = 0.5 * a.diameter;
    const std::int64_t present = a.count + (is_dropped(a) ? 1 : 0);
    if (present >= 1) pair_of(mass, radius, true);
    if (present >= 2) pair_of(mass / 2.0, radius / 2.0);
    if (present == 0) continue;
    for (const Species& b : scene.species) {
      // Dropped spheres are in the column one at a time, so at least one of a pair is of the bed.
      if (&a == &b || a.count == 0 || (b.count == 0 && !is_dropped(b))) continue;
      const double other = b.mass(), other_radius = 0.5 * b.diameter;
      pair_of(mass * other / (mass + other), radius * other_radius / (radius + other_radius));
    }
  }
  return bound;
}

}  // namespace slfb
