#include "experiments/claims/records_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "experiments/runs/measure.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/scene/units.hpp"
#include "solver/support/close_names.hpp"

namespace slfb {
namespace {

double quantity_in(TomlTable& table, const std::string& key, const units::Dimension& dimension) {
  try {
    return units::parse_quantity(table.text(key), dimension);
  } catch (const units::UnitError& error) {
    throw table.problem(key, error.what());
  }
}
double quantity_in(TomlTable& table, const std::string& key, const units::Dimension& dimension, double otherwise) {
  return table.has(key) ? quantity_in(table, key, dimension) : otherwise;
}

/// What one of the units is in SI.
double unit_in(TomlTable& table, const std::string& key, const units::Dimension& dimension) {
  const std::string unit = table.text(key, std::string(dimension.unit));
  const auto factor = units::unit_factor(unit, dimension.unit);
  if (!factor)
    throw table.problem(key,
                        fmt::format("\"{}\" is no unit of {}, such as \"{}\"", unit, dimension.name, dimension.unit));
  return *factor;
}

std::optional<std::int64_t> whole_in(TomlTable& table, const std::string& key) {
  if (!table.has(key)) return std::nullopt;
  const double value = table.number(key);
  if (value != std::floor(value) || std::abs(value) > 1e15) throw table.problem(key, "has to be a whole number");
  return static_cast<std::int64_t>(value);
}

/// A file of the folder that a key names.
std::filesystem::path existing_file(const TomlTable& table, const std::string& key, const std::filesystem::path& folder,
                                    const std::string& name) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(folder / name, unreadable))
    throw table.problem(key, fmt::format("there is no file {}", (folder / name).string()));
  return folder / name;
}

std::filesystem::path file_in(TomlTable& table, const std::string& key, const std::filesystem::path& folder) {
  const std::string name = table.text(key, "");
  if (name.empty()) return {};
  return existing_file(table, key, folder, name);
}

RecordsOfOthers read_table(TomlTable& table, const std::filesystem::path& folder, const MeasuredSystems& systems) {
  RecordsOfOthers records;
  records.spec.system = table.text("system");
  if (std::ranges::find(systems.names, records.spec.system) == systems.names.end())
    throw table.problem("system", fmt::format("there is no system \"{}\"; known: {}", records.spec.system,
                                              fmt::join(systems.names, ", ")));
  records.spec.superficial_velocity = quantity_in(table, "superficial_velocity", units::velocity);
  records.spec.variant = table.text("variant", "");
  records.bed = file_in(table, "bed", folder);
  records.positions = file_in(table, "positions", folder);
  records.settled = file_in(table, "settled", folder);
  for (const std::string& name : table.text_or_texts("drops"))
    records.drops.push_back(existing_file(table, "drops", folder, name));
  if (records.bed.empty() && records.positions.empty() && records.settled.empty() && records.drops.empty())
    throw table.problem("system", "has no file; needed is one or more of bed, positions, settled, drops");
  records.dump.time_step = quantity_in(table, "time_step", units::time, records.dump.time_step);
  records.dump.length = unit_in(table, "length_unit", units::length);
  records.dump.velocity = unit_in(table, "velocity_unit", units::velocity);
  records.dropped_id = whole_in(table, "dropped_id");
  records.dropped_type = whole_in(table, "dropped_type");
  records.fluidised_from = quantity_in(table, "fluidised_from", units::time, records.fluidised_from);
  records.undisturbed_until = quantity_in(table, "undisturbed_until", units::time, records.undisturbed_until);
  if (const auto own = file_in(table, "scene", folder); own.empty()) {
    records.scene = systems.scene_of(records.spec.system);
  } else {
    records.scene = load_scene(own);
    records.spec.scene = own;
  }
  table.reject_others();
  return records;
}

}  // namespace

Measurements measure_records(TomlTable& table, const std::filesystem::path& folder, const std::string& file,
                             const MeasuredSystems& systems) {
  std::vector<FinishedRun> runs;
  std::map<std::string, std::string> scenes;  // by what they answer
  std::set<std::filesystem::path> seen;
  for (TomlTable& one : table.tables("series")) {
    RecordsOfOthers records = read_table(one, folder, systems);
    const std::string key = run_key(records.spec), scene = canonical_toml(records.scene);
    if (scenes.try_emplace(key, scene).first->second != scene)
      throw one.problem(one.has("scene") ? "scene" : "system",
                        fmt::format("its scene is another one than that of a [[series]] of {} before: these are no "
                                    "samples of one number",
                                    key));
    std::vector<std::filesystem::path> files = records.drops;
    files.insert(files.end(), {records.bed, records.positions, records.settled});
    for (const std::filesystem::path& path : files)
      if (!path.empty() && !seen.insert(std::filesystem::canonical(path)).second)
        throw one.problem("system", fmt::format("{} is named twice: it would count as two samples", path.string()));
    records.name = fmt::format("{}, [[series]] {}", file, runs.size() + 1);
    runs.push_back(reduce_records(records, runs.size() + 1, systems.rules));
  }
  if (runs.empty()) return {};
  Measurements measured = measure_runs(runs, rules_for_records(systems.rules));
  std::erase_if(measured, [](const auto& entry) { return std::isnan(entry.second.value); });
  return measured;
}

std::string records_help(const MeasuredSystems& systems) {
  std::string text = fmt::format(
      R"(# Raw records are reduced by the definitions of this suite. A bed is one [[series]]; more beds of one system and
# velocity are samples of one number. Files lie beside this one:
#
# [[series]]
# system = "{0}"                       # one of {1}
# superficial_velocity = "0.10 m/s"       # every quantity takes any unit of its kind
# bed = "bed.csv"                         # time and any of pressure_drop, centre_of_mass_height, bed_top
# drops = ["first.csv", "second.csv"]     # one dropped sphere each: time, z and, where known, x and y
# positions = "spheres.csv"               # instead of bed: x, y, z of each sphere at each time; drops too
# settled = "settled.dump"                # the same of the settled bed; its last time counts
# time_step = "1e-5 s"                    # of a dump, which counts steps
# length_unit = "m"                       # of a dump; velocity_unit = "m/s"
# dropped_type = 2                        # the dropped sphere in positions, or dropped_id
# fluidised_from = "0 s"                  # start of fluidisation on the clock of bed and positions
# undisturbed_until = "20 s"              # first release on that clock
# scene = "mine.toml"                     # another column, liquid or number of spheres than the work's
#
# A CSV names its columns with their units in its first line: "time [ms],z [cm]". Positions have the columns time, x, y, z
# and, where known, id, type, diameter, vx, vy, vz; or they are a text dump of LIGGGHTS or LAMMPS ("ITEM: TIMESTEP" …
# "ITEM: ATOMS id type x y z radius …").
# z = 0 is the distributor, z points up. A pressure drop is without its static part. Time 0 of a drop is its first line.
# centre_of_mass_height is of the bed's spheres, bed_top the 99th percentile of the heights of their centres.
# A mean over a bed runs from fluidised_from, or the end of the transient by the rule MSER-5 (White 1997), to
# undisturbed_until; its interval is from the integrated autocorrelation time (Sokal 1997). A bed whose voidage still
# changes by more than {2} at its end is not steady.
)",
      systems.names.empty() ? "SYSTEM" : systems.names.front(), fmt::join(systems.names, ", "),
      systems.rules.steady_voidage);
  if (systems.rules.classification_window)
    text += fmt::format("# The line of V_2 is fitted to the first passage through {} m < z < {} m.\n",
                        (*systems.rules.classification_window)[0], (*systems.rules.classification_window)[1]);
  return text;
}

}  // namespace slfb
