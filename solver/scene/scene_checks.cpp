#include "solver/scene/scene_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "correlations/fluidisation/fluidisation_laws.hpp"
#include "correlations/law_list.hpp"
#include "solver/scene/scene_description.hpp"

namespace slfb::description {
namespace {

using units::rounded, units::shortest, units::with_unit;

/// Beyond these a run would take years and its counts would overflow: almost surely a wrong unit.
constexpr double most_cells = 1e8, most_steps = 5e9;

/// Solid fraction of a random close packing of equal spheres: denser than any bed that settles on its own.
constexpr double densest_packing = 0.64;

/// Solid fraction at which spheres added at random find no place any more, in a wide column.
constexpr double densest_random_addition = 0.38;

/// Each value alone against its range.
class RangeCheck {
 public:
  explicit RangeCheck(Problems& problems) : problems_(problems) {}

  template <class Body>
  void section(const std::string& name, Body body) {
    prefix_ = name + ".";
    body();
  }
  template <class Item, class Body>
  void sections(const std::string& name, std::vector<Item>& items, Body body) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      prefix_ = fmt::format("{}[{}].", name, i);
      body(items[i]);
    }
  }
  void text(const std::string& key, const std::string& value, const Presence& presence) {
    if (presence.rule == Presence::Rule::required && value.empty()) {
      problems_.add(prefix_ + key, "\"\"", "is empty; needed is a text");
    }
  }
  void law(const std::string& key, const std::string& value, const Presence& presence) { text(key, value, presence); }
  void boolean(const std::string&, bool, const Presence&) {}
  template <class Integer>
  void integer(const std::string& key, Integer value, const Allowed& allowed, const Presence& presence) {
    check(key, static_cast<double>(value), fmt::format("{}", value), allowed, presence);
  }
  void number(const std::string& key, double value, const units::Dimension& dimension, const Allowed& allowed,
              const Presence& presence) {
    check(key, value, with_unit(value, dimension), allowed, presence);
  }
  void optional_number(const std::string& key, const std::optional<double>& value, const units::Dimension& dimension,
                       const Allowed& allowed, const Presence& presence) {
    if (value) number(key, *value, dimension, allowed, presence);
  }
  void pair(const std::string& key, const std::array<double, 2>& value, const units::Dimension& dimension,
            const Allowed& allowed, const Presence& presence) {
    for (const double item : value) check(key, item, with_unit(item, dimension), allowed, presence);
  }
  template <class Enum, std::size_t N>
  void choice(const std::string&, Enum, const std::array<Choice<Enum>, N>&, const Presence&) {}
  void particle_count(const Species& species) { integer("count", species.count, zero_to_a_billion, optional); }

 private:
  void check(const std::string& key, double value, const std::string& printed, const Allowed& allowed,
             const Presence& presence) {
    if (presence.rule == Presence::Rule::meaningless || (std::isfinite(value) && allowed.contains(value))) return;
    problems_.add(prefix_ + key, printed, fmt::format("out of range; allowed is {}", allowed.words));
  }

  Problems& problems_;
  std::string prefix_;
};

/// What the values mean together. Runs only on values that are in range.
class PhysicsCheck {
 public:
  PhysicsCheck(const Scene& scene, Problems& problems, const SceneLaws& laws)
      : scene_(scene), problems_(problems), laws_(laws) {}

  void run() {
    check_species();
    check_column();
    check_fluid();
    laws_.check_contact(scene_, problems_);
    check_coupling();
    check_stages();
    check_recording();
  }

 private:
  template <class... Args>
  void problem(const std::string& path, std::string_view value, fmt::format_string<Args...> message, Args&&... args) {
    problems_.add(path, value, fmt::format(message, std::forward<Args>(args)...));
  }

  [[nodiscard]] static std::string species_key(std::size_t i, std::string_view key) {
    return fmt::format("species[{}].{}", i, key);
  }

  /// Smallest lateral extent.
  [[nodiscard]] double column_width() const {
    const auto& g = scene_.geometry;
    return g.shape == Shape::cylinder ? g.diameter : std::min(g.width[0], g.width[1]);
  }

  [[nodiscard]] std::string width_path() const {
    return scene_.geometry.shape == Shape::cylinder ? "geometry.diameter" : "geometry.width";
  }

  /// Height that the bed takes at the least.
  [[nodiscard]] double densest_bed_height() const {
    double volume = 0.0;
    for (const Species& s : scene_.species) volume += static_cast<double>(s.count) * s.volume();
    return volume / (densest_packing * scene_.geometry.cross_section());
  }

  /// Mass of the bed's spheres less that of the liquid they displace [kg].
  [[nodiscard]] double buoyant_bed_mass() const {
    double mass = 0.0;
    for (const Species& s : scene_.species)
      mass += static_cast<double>(s.count) * s.volume() * (s.density - scene_.liquid.density);
    return mass;
  }

  void check_species() {
    const auto& species = scene_.species;
    if (species.empty()) problem("species", "[]", "is missing; needed is at least one table, written [[species]]");
    for (std::size_t i = 0; i < species.size(); ++i) {
      const std::string& name = species[i].name;
      const auto is_name_character = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
      if (!std::ranges::all_of(name, is_name_character)) {
        problem(species_key(i, "name"), name,
                "holds a character that names of data sets cannot hold; allowed are letters, digits, \"-\" and \"_\"");
      }
      const auto first = std::ranges::find(species, name, &Species::name);
      if (first != species.begin() + static_cast<std::ptrdiff_t>(i)) {
        problem(species_key(i, "name"), name, "is the name of an earlier species; allowed is a name of its own");
      }
      const bool dropped =
          std::ranges::any_of(scene_.stages, [&](const Stage& stage) { return stage.species == name; });
      if (species[i].count == 0 && !dropped) {
        problem(species_key(i, "count"), "0",
                "the species is neither in the bed nor dropped; needed is count, total_mass or a drop stage of it");
      }
    }
  }

  void check_column() {
    const auto& geometry = scene_.geometry;
    const bool periodic = scene_.fluid.wall == LateralBoundary::periodic;
    // Across a periodic direction a sphere must not meet a neighbour and that neighbour's image at once.
    const double room = (periodic ? 0.5 : 1.0) * column_width();
    for (std::size_t i = 0; i < scene_.species.size(); ++i) {
      const double diameter = scene_.species[i].diameter;
      if (diameter >= room) {
        problem(species_key(i, "diameter"), with_unit(diameter, units::length),
                "the sphere does not fit between the walls; allowed is less than {} m ({}{})", rounded(room),
                periodic ? "half of " : "", width_path());
      } else if (diameter >= geometry.height) {
        problem(species_key(i, "diameter"), with_unit(diameter, units::length),
                "the sphere is taller than the column; allowed is less than {} m (geometry.height)",
                rounded(geometry.height));
      }
    }
    if (geometry.inclination > 0.0 && periodic)
      problem("geometry.inclination", with_unit(geometry.inclination, units::angle),
              "spheres and liquid would slide through periodic sides ever faster; allowed is 0, or fluid.wall = "
              "\"no-slip\" or \"slip\"");
    const double needed = densest_bed_height();
    if (needed > geometry.height) {
      problem("geometry.height", with_unit(geometry.height, units::length),
              "the bed does not fit into the column; packed as densely as spheres go (solid fraction {}) it is {} m "
              "high, allowed is a greater height, a wider column or fewer particles",
              densest_packing, rounded(needed));
    }
    const double solids = densest_packing * needed / geometry.height;
    if (scene_.start.arrangement != Arrangement::lattice && solids > densest_random_addition)
      problem(
          "start.arrangement", fmt::format("\"{}\"", word_of(scene_.start.arrangement, arrangements)),
          "spheres put at random into the column end at a solid fraction of {}, and the bed needs {:.3g}; allowed is "
          "\"lattice\", a greater geometry.height or fewer particles",
          densest_random_addition, solids);
  }

  void check_fluid() {
    const auto& fluid = scene_.fluid;
    const auto& geometry = scene_.geometry;
    if (fluid.wall == LateralBoundary::periodic && geometry.shape == Shape::cylinder) {
      problem("fluid.wall", "\"periodic\"",
              "a cylinder has no opposite sides; allowed is \"no-slip\" or \"slip\", or "
              "geometry.shape = \"box\"");
    }
    if (fluid.tier == FluidTier::quiescent) return;
    const double steps = fluid.time_step / scene_.contact.time_step;
    if (steps < 1.0 - 1e-9 || std::abs(steps - std::round(steps)) > 1e-9 * steps) {
      problem("fluid.time_step", with_unit(fluid.time_step, units::time),
              "is {:.6g} contact steps; allowed is a whole multiple of contact.time_step = {} s", steps,
              shortest(scene_.contact.time_step));
    }
    if (fluid.cell_height > geometry.height) {
      problem("fluid.cell_height", with_unit(fluid.cell_height, units::length),
              "is more than the column; allowed is at most {} m (geometry.height)", shortest(geometry.height));
    }
    check_cell_size("fluid.cell_height", with_unit(fluid.cell_height, units::length), fluid.cell_height);
    if (fluid.tier == FluidTier::three_dimensional) {
      const bool round = geometry.shape == Shape::cylinder;
      const double width = round ? geometry.diameter : geometry.width[0], x = width / fluid.cells_across;
      const double depth = round ? geometry.diameter : geometry.width[1];
      const double y = depth / std::max(1.0, std::round(depth / x));
      check_cell_size("fluid.cells_across", fmt::format("{}", fluid.cells_across), std::min(x, y));
      check_cell_diagonal(x, y, geometry.height / std::max(1.0, std::round(geometry.height / fluid.cell_height)));
    }
    const double across = fluid.tier == FluidTier::three_dimensional ? fluid.cells_across : 1.0;
    const double deep = geometry.shape == Shape::box ? across * geometry.width[1] / geometry.width[0] : across;
    const double cells = across * std::max(1.0, deep) * geometry.height / fluid.cell_height;
    if (cells > most_cells)
      problem("fluid.cell_height", with_unit(fluid.cell_height, units::length),
              "makes {:.3g} cells of the column; allowed are {:g}", cells, most_cells);
  }

  /// A cell below half the smallest sphere shows nothing but slices of spheres; and the centroid scheme puts a whole
  /// sphere into one cell, which must then have room for the largest.
  void check_cell_size(const std::string& path, const std::string& value, double size) {
    if (scene_.species.empty()) return;
    const auto [small, large] = std::ranges::minmax(scene_.species, {}, &Species::diameter);
    const bool centroid = scene_.coupling.void_fraction == VoidFractionScheme::centroid;
    const double least = centroid ? large.diameter : 0.5 * small.diameter;
    if (size >= least * (1.0 - 1e-9)) return;
    problem(path, value, "gives cells of {} m, {}; allowed are cells of {} m or more", rounded(size),
            centroid ? "smaller than the largest sphere, which the centroid scheme puts into one cell as a whole"
                     : "smaller than half the smallest sphere, so that a cell could hold no liquid at all",
            rounded(least));
  }

  /// The averaged equations need some liquid in each cell. A cell lies wholly inside a sphere when its diagonal is
  /// shorter than the diameter; particle meshing puts each piece of a sphere into one cell as a whole.
  void check_cell_diagonal(double x, double y, double z) {
    const auto& coupling = scene_.coupling;
    if (scene_.species.empty() || coupling.void_fraction == VoidFractionScheme::centroid) return;
    const double large = std::ranges::max(scene_.species, {}, &Species::diameter).diameter;
    const bool meshing = coupling.void_fraction == VoidFractionScheme::particle_meshing;
    const double piece = meshing ? std::cbrt(std::numbers::pi / 6.0 / coupling.meshing_pieces) * large : 0.0;
    const double diagonal = std::sqrt(x * x + y * y + z * z), needed = large + std::sqrt(3.0) * piece;
    if (diagonal >= needed * (1.0 - 1e-9) || std::min({x, y, z}) >= large * (1.0 - 1e-9)) return;
    problem("fluid.cells_across", fmt::format("{}", scene_.fluid.cells_across),
            "gives cells of {} x {} x {} m, which can lie wholly inside the largest sphere ({} m{}); allowed are cells "
            "with a diagonal of {} m or more, such as cubes with sides of {} m",
            rounded(x), rounded(y), rounded(z), rounded(large),
            meshing ? fmt::format(", cut into {} pieces", coupling.meshing_pieces) : "", rounded(needed),
            rounded(needed / std::sqrt(3.0)));
  }

  void check_coupling() {
    laws_.check_drag_law(scene_, problems_);
    const auto& coupling = scene_.coupling;
    if (coupling.lubrication_range > 0.0 && coupling.lubrication_roughness >= coupling.lubrication_range)
      problem("coupling.lubrication_roughness", with_unit(coupling.lubrication_roughness, units::length),
              "leaves nothing of the range; allowed is less than coupling.lubrication_range = {} m",
              shortest(coupling.lubrication_range));
    const double intervals = coupling.void_fraction_interval / scene_.fluid.time_step;
    if (std::abs(intervals - std::round(intervals)) > 1e-9 * std::max(1.0, intervals))
      problem("coupling.void_fraction_interval", with_unit(coupling.void_fraction_interval, units::time),
              "is {:.6g} liquid steps; allowed is 0 or a whole multiple of fluid.time_step = {} s", intervals,
              shortest(scene_.fluid.time_step));
    check_wall_retardation();
    const double smoothing = scene_.coupling.smoothing_length;
    if (smoothing > column_width())
      problem("coupling.smoothing_length", with_unit(smoothing, units::length),
              "spreads a sphere over the whole section; allowed is at most the column's width, {} m",
              rounded(column_width()));
  }

  void check_wall_retardation() {
    const std::string& law = scene_.coupling.wall_retardation;
    if (law == "none") return;
    const auto wrong = [&](const std::string& what) {
      problem("coupling.wall_retardation", fmt::format("\"{}\"", law), "{}", what);
    };
    const auto of_bed = [](const Species& species) { return species.count > 0; };
    if (scene_.geometry.shape != Shape::cylinder)
      return wrong("the laws are for tubes; needed is shape = \"cylinder\"");
    if (scene_.geometry.inclination > 0.0)
      return wrong(
          "the laws are for a sphere on the axis, and in an inclined tube it lies on the wall; allowed is \"none\"");
    if (std::ranges::any_of(scene_.species, of_bed))
      return wrong("the laws are for a sphere alone; allowed is \"none\" where there is a bed");
    bool known = false;
    for_each_law<fluidisation::WallCorrectionLaws>([&](const auto& one) {
      if (one.info.name != law) return;
      known = true;
      for (const Species& species : scene_.species) {
        const double ratio = species.diameter / scene_.geometry.diameter, velocity = one(ratio);
        if (!(velocity > 0.0 && velocity <= 1.0))
          wrong(fmt::format("gives {:.3g} of the velocity at d/D = {:.3g} ({}); allowed is a law for that ratio",
                            velocity, ratio, species.name));
      }
    });
    if (!known) wrong(fmt::format("unknown law; allowed is none, {}", law_names<fluidisation::WallCorrectionLaws>()));
  }

  /// A time that a run counts in liquid steps. Rounding to whole steps may change it by a thousandth; a default adapts.
  void check_steps(const std::string& path, double time, std::optional<double> default_value = {}) {
    const double step = scene_.fluid.time_step, steps = time / step, whole = std::round(steps);
    if (time == default_value || (whole >= 1.0 && std::abs(steps - whole) <= 1e-3 * steps)) return;
    const std::string allowed =
        steps < 1.0 ? fmt::format("{} s or more", shortest(step))
                    : fmt::format("{} s or {} s", rounded(std::floor(steps) * step), rounded(std::ceil(steps) * step));
    problem(path, with_unit(time, units::time),
            "is {:.6g} liquid steps; allowed is a whole multiple of fluid.time_step = {} s, such as {}", steps,
            shortest(step), allowed);
  }

  void check_stages() {
    const auto& stages = scene_.stages;
    if (stages.empty()) problem("stage", "[]", "is missing; needed is at least one table, written [[stage]]");
    bool fluidised = false;
    for (std::size_t i = 0; i < stages.size(); ++i) {
      const Stage& stage = stages[i];
      const std::string kind_path = fmt::format("stage[{}].kind", i);
      const std::string kind = fmt::format("\"{}\"", word_of(stage.kind, stage_kinds));
      // One clock starts with the fluidisation; a bed that settles later would have no time zero.
      if (i > 0 &&
          (stage.kind < stages[i - 1].kind || (stage.kind == stages[i - 1].kind && stage.kind == StageKind::settle)))
        problem(kind_path, kind,
                "comes after \"{}\"; allowed is at most one settle, then any number of fluidise, then any number of "
                "drops",
                word_of(stages[i - 1].kind, stage_kinds));
      if (stage.kind == StageKind::fluidise) {
        fluidised = true;
        check_superficial_velocity(i);
        if (buoyant_bed_mass() < 0.0)
          problem(kind_path, kind,
                  "the bed is lighter than the liquid: it hangs under the lid, and a flow upwards only presses it "
                  "against that; needed is a species of greater density, or a scene that ends after \"settle\"");
      }
      if (stage.kind == StageKind::drop) check_drop(i, fluidised);
      check_steps(fmt::format("stage[{}].duration", i), stage.duration);
      if (stage.relaxation > 0.0) check_steps(fmt::format("stage[{}].relaxation", i), stage.relaxation);
      const double repetitions = stage.kind == StageKind::drop ? static_cast<double>(stage.repetitions) : 1.0;
      const double steps = repetitions * (stage.duration + stage.relaxation) / scene_.contact.time_step;
      if (steps > most_steps)
        problem(fmt::format("stage[{}].duration", i), with_unit(stage.duration, units::time),
                "takes {:.3g} steps of contact.time_step = {} s; allowed are {:g}", steps,
                shortest(scene_.contact.time_step), most_steps);
    }
  }

  /// Quantities and claims belong to liquid.superficial_velocity: the bed has it in the end.
  void check_superficial_velocity(std::size_t i) {
    const Stage& stage = scene_.stages[i];
    if (scene_.superficial_velocity(stage) == 0.0)
      problem(fmt::format("stage[{}].kind", i), fmt::format("\"{}\"", word_of(stage.kind, stage_kinds)),
              "nothing flows; needed is liquid.superficial_velocity greater than zero");
    const bool last = i + 1 == scene_.stages.size() || scene_.stages[i + 1].kind != StageKind::fluidise;
    if (last && stage.superficial_velocity > 0.0 && stage.superficial_velocity != scene_.liquid.superficial_velocity)
      problem(
          fmt::format("stage[{}].superficial_velocity", i), with_unit(stage.superficial_velocity, units::velocity),
          "is that of the last fluidise stage, which flows at liquid.superficial_velocity = {} m/s; allowed is that "
          "value, or another fluidise stage after this one",
          shortest(scene_.liquid.superficial_velocity));
  }

  void check_drop(std::size_t i, bool fluidised) {
    const Stage& stage = scene_.stages[i];
    if (!fluidised && scene_.liquid.superficial_velocity > 0.0) {
      problem(fmt::format("stage[{}].kind", i), "\"drop\"",
              "nothing has fluidised the bed yet; needed is a stage of kind = \"fluidise\" before it");
    }
    const auto species = std::ranges::find(scene_.species, stage.species, &Species::name);
    if (species == scene_.species.end()) {
      std::string names;
      for (const Species& s : scene_.species) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", s.name);
      problem(fmt::format("stage[{}].species", i), fmt::format("\"{}\"", stage.species),
              "no species of that name; allowed is {}", names);
      return;
    }
    const double radius = 0.5 * species->diameter;
    const double height = scene_.geometry.height;
    const std::string path = fmt::format("stage[{}].release_height", i);
    const std::string value = with_unit(stage.release_height, units::length);
    const double packed = densest_bed_height();
    const double slack = 1e-9 * height;
    if (stage.release_height + radius > height + slack || stage.release_height - radius < -slack) {
      problem(path, value, "the sphere would stick out of the column; allowed is {} m to {} m for its centre",
              shortest(radius), shortest(height - radius));
    } else if (stage.release_height - radius < packed) {
      problem(path, value,
              "the sphere would start inside the bed, which is at least {} m high; allowed is {} m or more",
              rounded(packed), rounded(packed + radius));
    }
  }

  void check_recording() {
    const auto& recording = scene_.recording;
    check_steps("recording.bed_interval", recording.bed_interval, Recording{}.bed_interval);
    check_steps("recording.drop_interval", recording.drop_interval, Recording{}.drop_interval);
    if (recording.snapshot_interval > 0.0) check_steps("recording.snapshot_interval", recording.snapshot_interval);
    if (recording.snapshot_interval > 0.0 && recording.snapshot_interval < 1e-6)
      problem("recording.snapshot_interval", with_unit(recording.snapshot_interval, units::time),
              "snapshots are named by microseconds, so that some would take the place of others; allowed is 1e-6 s or "
              "more");
    const auto& [low, high] = recording.fluctuation_window;
    if (low >= high)
      problem("recording.fluctuation_window", fmt::format("[{}, {}]", shortest(low), shortest(high)),
              "holds no height; allowed is a lower height and then a higher one");
  }

  const Scene& scene_;
  Problems& problems_;
  const SceneLaws& laws_;
};

}  // namespace

void check_scene(const Scene& scene, Problems& problems, const SceneLaws& laws) {
  RangeCheck ranges(problems);
  Scene copy = scene;
  describe(ranges, copy, laws);
  problems.raise();
  PhysicsCheck(scene, problems, laws).run();
  problems.raise();
  laws.check_start(scene, problems);
  problems.raise();
}

}  // namespace slfb::description
