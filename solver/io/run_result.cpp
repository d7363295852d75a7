#include "solver/io/run_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "solver/io/hdf5_file.hpp"
#include "solver/support/files.hpp"

namespace slfb {
namespace {

using io::Hdf5File;
using io::Storage;

/// One data set of a group: its name in the file, its unit (UDUNITS spelling), what it is, and where it belongs in
/// memory.
template <class Group>
struct Column {
  const char* name;
  const char* unit;
  const char* description;
  std::vector<double> Group::*values;
  Storage storage = Storage::float32;
  bool may_be_missing = false;  ///< from files of before it was recorded
};

constexpr std::array bed_columns{
    Column<BedSeries>{"time", "s", "time since fluidisation began", &BedSeries::time, Storage::float64},
    Column<BedSeries>{"pressure_drop", "Pa", "pressure at the inlet minus outlet, static head removed",
                      &BedSeries::pressure_drop},
    Column<BedSeries>{"centre_of_mass_height", "m", "height of the centre of mass of the bed spheres",
                      &BedSeries::centre_of_mass_height},
    Column<BedSeries>{"bed_top", "m", "99th percentile of the heights of the bed spheres' centres",
                      &BedSeries::bed_top},
    Column<BedSeries>{"fluctuating_energy", "m2 s-2",
                      "fluctuating kinetic energy of the bed spheres, 3/2 of the mean variance per component",
                      &BedSeries::fluctuating_energy},
    Column<BedSeries>{"contacts_per_particle", "1", "mean number of contacts of a bed sphere",
                      &BedSeries::contacts_per_particle},
    Column<BedSeries>{"local_fluctuating_energy", "m2 s-2", "the same about the mean velocity in boxes of 4 diameters",
                      &BedSeries::local_fluctuating_energy},
    Column<BedSeries>{"cumulative_contacts", "1", "new contacts with other spheres per bed sphere since the run began",
                      &BedSeries::cumulative_contacts},
    Column<BedSeries>{"contact_force_bed", "N", "mean normal force of the contacts of bed spheres",
                      &BedSeries::contact_force_bed},
    Column<BedSeries>{"contact_force_foreign", "N",
                      "mean normal force of the contacts of the dropped sphere with bed spheres",
                      &BedSeries::contact_force_foreign},
    Column<BedSeries>{"contact_force_wall", "N", "mean normal force of the contacts with walls",
                      &BedSeries::contact_force_wall},
    Column<BedSeries>{"network_step", "1", "step of the spheres times the bound of the contact network's frequency",
                      &BedSeries::network_step},
    Column<BedSeries>{"pressure_force", "N",
                      "vertical force of the pressure on spheres and liquid, mean since the last sample",
                      &BedSeries::pressure_force},
    Column<BedSeries>{"buoyant_weight", "N", "weight less buoyancy, mean since the last sample",
                      &BedSeries::buoyant_weight},
    Column<BedSeries>{"bottom_force", "N", "vertical force of the bottom on spheres, mean since the last sample",
                      &BedSeries::bottom_force},
    Column<BedSeries>{"wall_force", "N", "vertical force of the walls on spheres, mean since the last sample",
                      &BedSeries::wall_force},
    Column<BedSeries>{"shear_force", "N", "vertical force of wall shear on the liquid, mean since the last sample",
                      &BedSeries::shear_force},
    Column<BedSeries>{"flow_force", "N", "momentum that the liquid carries in less out, mean since the last sample",
                      &BedSeries::flow_force},
    Column<BedSeries>{"sphere_inertia", "N", "rate of change of the spheres' momentum, mean since the last sample",
                      &BedSeries::sphere_inertia},
    Column<BedSeries>{"liquid_inertia", "N", "rate of change of the liquid's momentum, mean since the last sample",
                      &BedSeries::liquid_inertia},
    Column<BedSeries>{"balance_residual", "1",
                      "largest sum of these forces in a step since the last sample, over the weight",
                      &BedSeries::balance_residual},
    Column<BedSeries>{"maximum_overlap", "1", "largest overlap over the radius of the sphere",
                      &BedSeries::maximum_overlap},
    Column<BedSeries>{"foreign_present", "1", "1 while a dropped sphere is in the column, else 0",
                      &BedSeries::foreign_present},
    Column<BedSeries>{"superficial_velocity", "m s-1", "of the liquid that enters", &BedSeries::superficial_velocity,
                      Storage::float32, true},
};

constexpr std::array drop_columns{
    Column<DropSeries>{"time", "s", "time since release", &DropSeries::time, Storage::float64},
    Column<DropSeries>{"x", "m", "centre of the dropped sphere", &DropSeries::x},
    Column<DropSeries>{"y", "m", "centre of the dropped sphere", &DropSeries::y},
    Column<DropSeries>{"z", "m", "centre of the dropped sphere, height above the bottom", &DropSeries::z},
    Column<DropSeries>{"velocity_x", "m s-1", "velocity of the dropped sphere", &DropSeries::velocity_x},
    Column<DropSeries>{"velocity_y", "m s-1", "velocity of the dropped sphere", &DropSeries::velocity_y},
    Column<DropSeries>{"velocity_z", "m s-1", "velocity of the dropped sphere, positive upwards",
                       &DropSeries::velocity_z},
    Column<DropSeries>{"angular_speed", "rad s-1", "magnitude of its angular velocity", &DropSeries::angular_speed},
    Column<DropSeries>{"voidage", "1", "volume fraction of liquid at the sphere", &DropSeries::voidage},
    Column<DropSeries>{"liquid_velocity_z", "m s-1", "interstitial velocity of the liquid at the sphere",
                       &DropSeries::liquid_velocity_z},
    Column<DropSeries>{"reynolds", "1", "Reynolds number of the superficial slip", &DropSeries::reynolds},
    Column<DropSeries>{"contact_force", "N", "magnitude of the resultant contact force at this instant",
                       &DropSeries::contact_force},
    Column<DropSeries>{"contact_force_mean_x", "N", "contact force, mean since the last sample",
                       &DropSeries::contact_force_mean_x},
    Column<DropSeries>{"contact_force_mean_y", "N", "contact force, mean since the last sample",
                       &DropSeries::contact_force_mean_y},
    Column<DropSeries>{"contact_force_mean_z", "N", "contact force, mean since the last sample",
                       &DropSeries::contact_force_mean_z},
    Column<DropSeries>{"drag_force_z", "N", "drag force", &DropSeries::drag_force_z},
    Column<DropSeries>{"pressure_force_z", "N", "force of the pressure gradient, static part included",
                       &DropSeries::pressure_force_z},
    Column<DropSeries>{"contacts", "1", "spheres in contact at this instant", &DropSeries::contacts},
    Column<DropSeries>{"cumulative_contacts", "1", "new contacts since release", &DropSeries::cumulative_contacts},
};

constexpr std::array plane_columns{
    Column<PlaneField>{"x", "m", "centres of the cells", &PlaneField::x, Storage::float64},
    Column<PlaneField>{"z", "m", "centres of the cells", &PlaneField::z, Storage::float64},
    Column<PlaneField>{"voidage", "1", "volume fraction of liquid in the plane y = 0, row after row from the bottom",
                       &PlaneField::voidage},
    Column<PlaneField>{"velocity_x", "m s-1", "interstitial velocity of the liquid, as voidage",
                       &PlaneField::velocity_x},
    Column<PlaneField>{"velocity_z", "m s-1", "interstitial velocity of the liquid, as voidage",
                       &PlaneField::velocity_z},
};

using Liquid = LiquidFluctuation;
constexpr std::array fluctuation_columns{
    Column<Liquid>{"time", "s", "times of the samples", &Liquid::time, Storage::float64},
    Column<Liquid>{"x", "m", "centre of each cell of the window", &Liquid::x, Storage::float64},
    Column<Liquid>{"z", "m", "centre of each cell of the window", &Liquid::z, Storage::float64},
    Column<Liquid>{"mean_x", "m s-1", "mean velocity of the liquid in each cell", &Liquid::mean_x},
    Column<Liquid>{"mean_y", "m s-1", "mean velocity of the liquid in each cell", &Liquid::mean_y},
    Column<Liquid>{"mean_z", "m s-1", "mean velocity of the liquid in each cell", &Liquid::mean_z},
    Column<Liquid>{"deviation_x", "m s-1", "mean absolute deviation from the mean, each cell", &Liquid::deviation_x},
    Column<Liquid>{"deviation_y", "m s-1", "mean absolute deviation from the mean, each cell", &Liquid::deviation_y},
    Column<Liquid>{"deviation_z", "m s-1", "mean absolute deviation from the mean, each cell", &Liquid::deviation_z},
    Column<Liquid>{"deviation_vector", "m s-1", "mean length of the deviation vector, each cell",
                   &Liquid::deviation_vector},
    Column<Liquid>{"rms_x", "m s-1", "root mean square deviation, each cell", &Liquid::rms_x},
    Column<Liquid>{"rms_y", "m s-1", "root mean square deviation, each cell", &Liquid::rms_y},
    Column<Liquid>{"rms_z", "m s-1", "root mean square deviation, each cell", &Liquid::rms_z},
    Column<Liquid>{"series_x", "m s-1", "absolute deviation at each sample, mean over the cells", &Liquid::series_x},
    Column<Liquid>{"series_y", "m s-1", "absolute deviation at each sample, mean over the cells", &Liquid::series_y},
    Column<Liquid>{"series_z", "m s-1", "absolute deviation at each sample, mean over the cells", &Liquid::series_z},
    Column<Liquid>{"series_vector", "m s-1", "length of the deviation vector at each sample, mean over the cells",
                   &Liquid::series_vector},
    Column<Liquid>{"sampled_velocity_x", "m s-1", "velocities, sample after sample, until they are reduced",
                   &Liquid::samples_x, Storage::float64},
    Column<Liquid>{"sampled_velocity_y", "m s-1", "velocities, sample after sample, until they are reduced",
                   &Liquid::samples_y, Storage::float64},
    Column<Liquid>{"sampled_velocity_z", "m s-1", "velocities, sample after sample, until they are reduced",
                   &Liquid::samples_z, Storage::float64},
};

constexpr std::array snapshot_columns{
    Column<Snapshot>{"x", "m", "centres of the spheres", &Snapshot::x},
    Column<Snapshot>{"y", "m", "centres of the spheres", &Snapshot::y},
    Column<Snapshot>{"z", "m", "centres of the spheres", &Snapshot::z},
    Column<Snapshot>{"radius", "m", "radii of the spheres", &Snapshot::radius},
};

template <class Columns, class Group>
void write_columns(Hdf5File& file, const std::string& group, const Columns& columns, const Group& values) {
  for (const auto& column : columns) {
    const std::string path = fmt::format("{}/{}", group, column.name);
    file.write(path, values.*column.values, column.unit, column.storage);
    file.write_attribute(path, "description", std::string(column.description));
  }
}

[[noreturn]] void fail(const Hdf5File& file, const std::string& item, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: \"{}\" {}", file.file().string(), item, what));
}

void check_length(const Hdf5File& file, const std::string& item, std::size_t length, std::size_t expected) {
  if (length != expected) fail(file, item, fmt::format("has {} values instead of {}", length, expected));
}

std::vector<double> read_column(const Hdf5File& file, const std::string& path) {
  std::vector<double> values = file.read_doubles(path);
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    fail(file, path, "holds a value that is no finite number");
  return values;
}

/// A data set of one number.
struct Single {
  const char* name;
  const char* unit;
  const char* description;
};
constexpr Single packed_voidage{"packed_bed/voidage", "1", "voidage of the settled bed, from twice its centre of mass"};
constexpr Single packed_height{"packed_bed/height", "m", "twice the height of the centre of mass of the settled bed"};
constexpr Single release_time{"release_time", "s", "when the sphere was released, on the clock of the bed"};
constexpr Single bottom_time{"bottom_time", "s", "first touch of the bottom after release; -1: never"};
constexpr Single plane_time{"plane/time", "s", "when the plane was recorded, on the clock of the bed"};
constexpr Single snapshot_time{"time", "s", "when the spheres were recorded, on the clock of the bed"};

void write_single(Hdf5File& file, const std::string& group, const Single& single, double value) {
  const std::string path = group + single.name;
  file.write(path, {value}, single.unit);
  file.write_attribute(path, "description", std::string(single.description));
}

template <class Columns, class Group>
void read_columns(const Hdf5File& file, const std::string& group, const Columns& columns, Group& values) {
  for (const auto& column : columns) {
    const std::string path = fmt::format("{}/{}", group, column.name);
    if (column.may_be_missing && !file.exists(path)) continue;
    values.*column.values = read_column(file, path);
  }
}

/// A group whose columns are as long as its first one.
template <class Columns, class Group>
void read_series(const Hdf5File& file, const std::string& group, const Columns& columns, Group& values) {
  read_columns(file, group, columns, values);
  for (const auto& column : columns) {
    const std::vector<double>& read = values.*column.values;
    if (column.may_be_missing && read.empty()) continue;
    check_length(file, fmt::format("{}/{}", group, column.name), read.size(), (values.*columns.front().values).size());
  }
}

void check_times(const Hdf5File& file, const std::string& item, const std::vector<double>& times) {
  if (!std::ranges::is_sorted(times)) fail(file, item, "goes back in time");
}

/// A single number with a unit is a data set of one value, so that it too carries the attribute.
double read_number(const Hdf5File& file, const std::string& path) {
  const std::vector<double> values = file.read_doubles(path);
  if (values.size() != 1) fail(file, path, fmt::format("holds {} values instead of one", values.size()));
  if (!std::isfinite(values.front())) fail(file, path, "is no finite number");
  return values.front();
}

double read_duration(const Hdf5File& file, const std::string& name) {
  const double value = file.read_double_attribute("/", name);
  if (!(std::isfinite(value) && value >= 0.0)) fail(file, "/@" + name, "is no positive number");
  return value;
}

/// A whole number from 0, or from `least`, to `most`.
std::int64_t read_whole(const Hdf5File& file, const std::string& object, const std::string& name, std::int64_t most,
                        std::int64_t least = 0) {
  const std::int64_t value = file.read_integer_attribute(object, name);
  if (value < least || value > most)
    fail(file, fmt::format("{}@{}", object, name), fmt::format("is {}, not from {} to {}", value, least, most));
  return value;
}

/// Number of groups 0000, 0001, … in a group.
std::int64_t read_count(const Hdf5File& file, const std::string& group) {
  return read_whole(file, group, "count", static_cast<std::int64_t>(file.children(group).size()));
}

/// HDF5 takes no attribute of 64 KiB or more; a longer scene is a data set of its characters.
constexpr std::size_t longest_attribute = 60'000;

void write_scene(Hdf5File& file, const std::string& text) {
  if (text.size() <= longest_attribute) return file.write_attribute("/", "scene", text);
  file.write("scene", std::vector<std::uint8_t>(text.begin(), text.end()));
}

std::string read_scene(const Hdf5File& file) {
  if (file.has_attribute("/", "scene") || !file.exists("scene")) return file.read_string_attribute("/", "scene");
  std::string text;
  for (const std::uint32_t character : file.read_unsigned("scene")) {
    if (character > 0xff) fail(file, "scene", "is no text");
    text += static_cast<char>(static_cast<unsigned char>(character));
  }
  return text;
}

/// n samples of m cells; the velocities themselves until they are reduced.
void check_fluctuation(const Hdf5File& file, const Liquid& liquid) {
  const std::string group = "liquid_fluctuation";
  const std::size_t times = liquid.time.size(), cells = liquid.x.size();
  const bool reduced = cells > 0;
  const std::size_t samples = liquid.samples_x.size();
  if (reduced ? samples != 0 : times == 0 ? samples != 0 : samples % times != 0)
    fail(file, group + "/sampled_velocity_x", fmt::format("has {} values for {} times", samples, times));
  for (const auto& column : fluctuation_columns) {
    const std::string name = column.name;
    const std::size_t length = (liquid.*column.values).size();
    const bool of_times = name.starts_with("series"), of_samples = name.starts_with("sampled");
    if (name != "time")
      check_length(file, group + "/" + name, length,
                   of_samples ? samples
                   : of_times ? (length == 0 && !reduced ? 0 : times)
                              : cells);
  }
  check_times(file, group + "/time", liquid.time);
}

void check_plane(const Hdf5File& file, const PlaneField& plane) {
  for (const auto& [name, field] : {std::pair{"voidage", &plane.voidage}, std::pair{"velocity_x", &plane.velocity_x},
                                    std::pair{"velocity_z", &plane.velocity_z}})
    check_length(file, fmt::format("plane/{}", name), field->size(), plane.x.size() * plane.z.size());
}

std::string drop_group(std::int64_t number) { return fmt::format("drops/{:04}", number); }

}  // namespace

void for_each_column(BedSeries& series, const std::function<void(std::vector<double>&)>& visit) {
  for (const auto& column : bed_columns) visit(series.*column.values);
}

void for_each_column(DropSeries& series, const std::function<void(std::vector<double>&)>& visit) {
  for (const auto& column : drop_columns) visit(series.*column.values);
}

std::vector<ResultDataSet> result_data_sets() {
  std::vector<ResultDataSet> all;
  const auto single = [&](const std::string& group, const Single& one) {
    all.push_back({group + one.name, one.unit, one.description});
  };
  const auto columns = [&](const std::string& group, const auto& of_group) {
    for (const auto& column : of_group) all.push_back({group + column.name, column.unit, column.description});
  };
  single("", packed_voidage);
  single("", packed_height);
  columns("bed/", bed_columns);
  single("drops/0000/", release_time);
  single("drops/0000/", bottom_time);
  columns("drops/0000/", drop_columns);
  single("", plane_time);
  columns("plane/", plane_columns);
  columns("liquid_fluctuation/", fluctuation_columns);
  single("snapshots/0000/", snapshot_time);
  columns("snapshots/0000/", snapshot_columns);
  return all;
}

void save_result(const RunResult& result, const std::filesystem::path& file) {
  const auto fill = [&](Hdf5File& target) {
    target.write_attribute("/", "name", result.name);
    write_scene(target, result.scene_text);
    target.write_attribute("/", "numerics_version", std::int64_t{result.numerics});
    target.write_attribute("/", "suite_version", result.suite_version);
    target.write_attribute("/", "commit", result.commit);
    target.write_attribute("/", "machine", result.machine);
    target.write_attribute("/", "date", result.date);
    target.write_attribute("/", "threads", std::int64_t{result.threads});
    target.write_attribute("/", "wall_seconds", result.wall_seconds);
    target.write_attribute("/", "cpu_seconds", result.cpu_seconds);
    target.write_attribute("/", "simulated_seconds", result.simulated_seconds);
    target.write_attribute("/", "particle_steps", result.particle_steps);
    target.write_attribute("/", "particles_removed", result.particles_removed);
    target.write_attribute("/", "steps_per_contact", result.steps_per_contact);
    write_single(target, "", packed_voidage, result.packed_voidage);
    write_single(target, "", packed_height, result.packed_height);
    write_columns(target, "bed", bed_columns, result.bed);
    target.write_attribute("drops", "count", static_cast<std::int64_t>(result.drops.size()));
    for (std::size_t i = 0; i < result.drops.size(); ++i) {
      const DropSeries& drop = result.drops[i];
      const std::string group = drop_group(static_cast<std::int64_t>(i));
      target.write_attribute(group, "species", drop.species);
      write_single(target, group + "/", release_time, drop.release_time);
      write_single(target, group + "/", bottom_time, drop.bottom_time);
      write_columns(target, group, drop_columns, drop);
    }
    write_single(target, "", plane_time, result.plane.time);
    write_columns(target, "plane", plane_columns, result.plane);
    write_columns(target, "liquid_fluctuation", fluctuation_columns, result.fluctuation);
    target.write_attribute("snapshots", "count", static_cast<std::int64_t>(result.snapshots.size()));
    for (std::size_t i = 0; i < result.snapshots.size(); ++i) {
      const Snapshot& snapshot = result.snapshots[i];
      const std::string group = fmt::format("snapshots/{:04}", i);
      target.write_attribute(group, "moment", snapshot.moment);
      target.write_attribute(group, "foreign", snapshot.foreign);
      write_single(target, group + "/", snapshot_time, snapshot.time);
      write_columns(target, group, snapshot_columns, snapshot);
    }
  };
  io::write_atomically(file, fill, io::Checksum::whole_file);
}

namespace {

RunResult read_result(const Hdf5File& source) {
  RunResult result;
  result.name = source.read_string_attribute("/", "name");
  if (!is_plain_name(result.name)) fail(source, "/@name", "is no name of a run");
  result.scene_text = read_scene(source);
  result.numerics = static_cast<int>(read_whole(source, "/", "numerics_version", 1'000'000));
  result.suite_version = source.read_string_attribute("/", "suite_version");
  if (source.has_attribute("/", "commit")) result.commit = source.read_string_attribute("/", "commit");
  result.machine = source.read_string_attribute("/", "machine");
  result.date = source.read_string_attribute("/", "date");
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  result.threads = static_cast<int>(read_whole(source, "/", "threads", 1'000'000));
  result.wall_seconds = read_duration(source, "wall_seconds");
  result.cpu_seconds = read_duration(source, "cpu_seconds");
  result.simulated_seconds = read_duration(source, "simulated_seconds");
  result.particle_steps = read_whole(source, "/", "particle_steps", any);
  result.particles_removed = read_whole(source, "/", "particles_removed", any);
  result.steps_per_contact = read_duration(source, "steps_per_contact");
  result.packed_voidage = read_number(source, "packed_bed/voidage");
  result.packed_height = read_number(source, "packed_bed/height");
  read_series(source, "bed", bed_columns, result.bed);
  check_times(source, "bed/time", result.bed.time);
  const std::int64_t drops = read_count(source, "drops");
  for (std::int64_t i = 0; i < drops; ++i) {
    DropSeries& drop = result.drops.emplace_back();
    const std::string group = drop_group(i);
    drop.species = source.read_string_attribute(group, "species");
    drop.release_time = read_number(source, group + "/release_time");
    drop.bottom_time = read_number(source, group + "/bottom_time");
    read_series(source, group, drop_columns, drop);
    check_times(source, group + "/time", drop.time);
  }
  result.plane.time = read_number(source, "plane/time");
  read_columns(source, "plane", plane_columns, result.plane);
  check_plane(source, result.plane);
  if (!source.exists("liquid_fluctuation")) return result;  // written before these were recorded
  // Earlier versions called the velocities samples_x; in a result they are reduced and none is left.
  const auto earlier_names = [](std::string name) {
    return name.starts_with("sampled_velocity") ? "samples" + name.substr(name.rfind('_')) : name;
  };
  const bool earlier = source.exists("liquid_fluctuation/samples_x");
  for (const auto& column : fluctuation_columns) {
    const std::string name = earlier ? earlier_names(column.name) : column.name;
    result.fluctuation.*column.values = read_column(source, "liquid_fluctuation/" + name);
  }
  check_fluctuation(source, result.fluctuation);
  const std::int64_t snapshots = read_count(source, "snapshots");
  for (std::int64_t i = 0; i < snapshots; ++i) {
    Snapshot& snapshot = result.snapshots.emplace_back();
    const std::string group = fmt::format("snapshots/{:04}", i);
    snapshot.moment = source.read_string_attribute(group, "moment");
    snapshot.time = read_number(source, group + "/time");
    read_series(source, group, snapshot_columns, snapshot);
    snapshot.foreign = read_whole(source, group, "foreign", static_cast<std::int64_t>(snapshot.x.size()) - 1, -1);
  }
  return result;
}

}  // namespace

RunResult load_result(const std::filesystem::path& file) {
  RunResult result;
  const bool checked = io::starts_with_checksum(file);
  const auto read = [&] { result = read_result(Hdf5File::open(file)); };
  // Results that were written before there were checksums stay readable.
  checked ? read() : io::read_with_care(file, read);
  return result;
}

}  // namespace slfb
