#include "experiments/runs/runs_of_others.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/runs/series_file.hpp"
#include "solver/dem/granular_temperature.hpp"
#include "solver/run/bed_heights.hpp"

namespace slfb {
namespace {

constexpr double not_recorded = std::numeric_limits<double>::quiet_NaN();

const Species& dropped_species(const RecordsOfOthers& records) {
  const Scene& scene = records.scene;
  const auto stage = std::ranges::find(scene.stages, StageKind::drop, &Stage::kind);
  if (stage == scene.stages.end())
    throw std::runtime_error(fmt::format(
        "{}: has drops, but its scene no stage of kind = \"drop\" that says of which sphere", records.name));
  return *std::ranges::find(scene.species, stage->species, &Species::name);
}

double volume_of_bed(const Scene& scene) {
  return std::accumulate(scene.species.begin(), scene.species.end(), 0.0, [](double sum, const Species& species) {
    return sum + static_cast<double>(species.count) * species.volume();
  });
}

/// Adds a row of a series in which only what is named was recorded.
std::size_t add_row(BedSeries& bed, double time, double superficial_velocity) {
  const std::size_t row = bed.time.size();
  for_each_column(bed, [row](std::vector<double>& column) { column.resize(row + 1, not_recorded); });
  bed.time[row] = time;
  bed.superficial_velocity[row] = superficial_velocity;
  return row;
}

/// Walks through the records of one bed.
class Reduction {
 public:
  Reduction(const RecordsOfOthers& records, const MeasuringRules& rules) : records_(records), rules_(rules) {
    run_.spec = records.spec;
    run_.scene = records.scene;
    run_.result.name = records.name;
    run_.result.packed_voidage = not_recorded;
    scene_ = records.scene;
  }

  FinishedRun reduce(std::uint64_t packing) {
    if (!(volume_of_bed(records_.scene) > 0.0))
      throw std::runtime_error(fmt::format("{}: its scene has no spheres of a bed", records_.name));
    if (!records_.bed.empty()) read_bed();
    if (!records_.positions.empty()) read_positions();
    if (!records_.settled.empty()) read_settled();
    for (const auto& file : records_.drops) read_drop(file);
    MeasuringRules known = rules_;
    std::erase_if(known.quantities, [&](const Quantity& quantity) {
      return quantity.needs.empty() ||
             !std::ranges::includes(recorded_, std::set(quantity.needs.begin(), quantity.needs.end()));
    });
    run_.summary = summarise(records_.spec.system, scene_, run_.result, known);
    for (const char* fact : {"wall_seconds", "simulated_seconds", "particles_removed"}) run_.summary->run.erase(fact);
    // The summary has all that can be said; what measure_runs would look for in the series is not in them.
    run_.result.bed = {};
    run_.result.drops.clear();
    run_.scene.seed = packing;
    return std::move(run_);
  }

 private:
  void read_bed() {
    if (!records_.positions.empty())
      throw std::runtime_error(
          fmt::format("{}: has a record of the bed beside the positions of its spheres; one of "
                      "them is needed",
                      records_.name));
    const std::array<SeriesColumn, 4> columns{{{"time", units::time},
                                               {"pressure_drop", units::pressure},
                                               {"centre_of_mass_height", units::length},
                                               {"bed_top", units::length}}};
    const std::array<std::string_view, 1> needed{"time"};
    const SeriesTable table = read_series(records_.bed, columns, needed);
    require_rising(table, "time");
    BedSeries& bed = run_.result.bed;
    for (std::size_t k = 0; k < table.lines.size(); ++k) {
      const std::size_t row =
          add_row(bed, table.at("time")[k] - records_.fluidised_from, records_.spec.superficial_velocity);
      bed.foreign_present[row] = table.at("time")[k] >= records_.undisturbed_until ? 1.0 : 0.0;
    }
    const auto take = [&](std::string_view column, std::vector<double> BedSeries::*series, Recorded what) {
      if (!table.has(column)) return;
      bed.*series = table.at(column);
      recorded_.insert(what);
    };
    take("pressure_drop", &BedSeries::pressure_drop, Recorded::pressure_drop);
    take("centre_of_mass_height", &BedSeries::centre_of_mass_height, Recorded::bed_centre_of_mass);
    take("bed_top", &BedSeries::bed_top, Recorded::bed_top);
    if (recorded_.empty())
      throw std::runtime_error(fmt::format("{}: has none of the columns pressure_drop, centre_of_mass_height, bed_top",
                                           records_.bed.string()));
  }

  [[nodiscard]] bool is_dropped(const SphereFrame& frame, std::size_t i) const {
    return (records_.dropped_id && frame.id[i] == *records_.dropped_id) ||
           (records_.dropped_type && frame.type[i] == *records_.dropped_type);
  }

  /// The spheres of a frame apart from the dropped one.
  struct Bed {
    std::vector<double> heights, volumes;
    std::optional<std::size_t> dropped;
  };

  Bed bed_of(const SphereFrame& frame, const std::filesystem::path& file) const {
    if ((records_.dropped_id && frame.id.empty()) || (records_.dropped_type && frame.type.empty()))
      throw std::runtime_error(fmt::format("{}: has no column {}, by which the dropped sphere is named", file.string(),
                                           frame.id.empty() && records_.dropped_id ? "id" : "type"));
    const auto species = std::ranges::find_if(scene_.species, [](const Species& one) { return one.count > 0; });
    Bed bed;
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (is_dropped(frame, i)) {
        if (bed.dropped)
          throw std::runtime_error(
              fmt::format("{}: more than one sphere at one time is the dropped one", file.string()));
        bed.dropped = i;
        continue;
      }
      bed.heights.push_back(frame.position.z[i]);
      bed.volumes.push_back(frame.radius.empty() ? species->volume() : dem::Particles::volume_of(frame.radius[i]));
    }
    const double volume = std::accumulate(bed.volumes.begin(), bed.volumes.end(), 0.0);
    constexpr double same = 0.01;
    if (const double of_scene = volume_of_bed(records_.scene); std::abs(volume / of_scene - 1.0) > same)
      throw std::runtime_error(fmt::format(
          "{}: its {} spheres of the bed fill {:.4g} m3, but those of its scene {:.4g} m3. Another bed: name "
          "a scene of it by scene = \"FILE\". Another unit of length: length_unit. A dropped sphere among "
          "them: dropped_id or dropped_type",
          file.string(), bed.heights.size(), volume, of_scene));
    return bed;
  }

  void read_positions() {
    DropSeries drop;
    bool moving = false;
    for_each_frame(records_.positions, records_.dump, [&](const SphereFrame& frame) {
      if (std::isnan(frame.time))
        throw std::runtime_error(fmt::format("{}: a dump counts steps: time_step is needed, such as \"1e-5 s\"",
                                             records_.positions.string()));
      const Bed bed = bed_of(frame, records_.positions);
      if (run_.result.bed.time.empty()) {
        take_spheres(bed.volumes);
        moving = !frame.velocity.z.empty();
      }
      add_bed(frame, bed, moving && !frame.velocity.z.empty());
      if (bed.dropped) add_to(drop, frame, *bed.dropped);
    });
    recorded_.insert({Recorded::bed_centre_of_mass, Recorded::bed_top});
    if (moving) recorded_.insert(Recorded::sphere_velocities);
    if (!drop.time.empty()) {
      recorded_.insert(Recorded::sphere_path);
      add_drop(std::move(drop));
    }
  }

  /// Number and mean volume of the bed's spheres are those that there are.
  void take_spheres(const std::vector<double>& volumes) {
    bool first = true;
    const double volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    for (Species& species : scene_.species) {
      if (species.count == 0) continue;
      species.count = first ? static_cast<std::int64_t>(volumes.size()) : 0;
      if (std::exchange(first, false))
        species.diameter = std::cbrt(6.0 * volume / (std::numbers::pi * static_cast<double>(volumes.size())));
    }
  }

  void add_bed(const SphereFrame& frame, const Bed& bed, bool moving) {
    BedSeries& series = run_.result.bed;
    const std::size_t row = add_row(series, frame.time - records_.fluidised_from, records_.spec.superficial_velocity);
    const auto heights = simulation::bed_heights(bed.heights, bed.volumes);
    series.centre_of_mass_height[row] = heights.centre_of_mass;
    series.bed_top[row] = heights.top;
    series.foreign_present[row] = bed.dropped || frame.time >= records_.undisturbed_until ? 1.0 : 0.0;
    if (!moving) return;
    dem::Particles particles;
    particles.position = frame.position;
    particles.velocity = frame.velocity;
    particles.radius.resize(frame.size(), 0.5 * scene_.species.front().diameter);
    if (!frame.radius.empty()) particles.radius = frame.radius;
    const double box = 8.0 * *std::ranges::max_element(particles.radius);
    series.fluctuating_energy[row] = dem::fluctuating_energy(particles, bed.dropped);
    series.local_fluctuating_energy[row] = dem::local_fluctuating_energy(particles, {box, box, box}, bed.dropped);
  }

  static void add_to(DropSeries& drop, const SphereFrame& frame, std::size_t i) {
    drop.time.push_back(frame.time);
    drop.x.push_back(frame.position.x[i]);
    drop.y.push_back(frame.position.y[i]);
    drop.z.push_back(frame.position.z[i]);
  }

  void read_settled() {
    SphereFrame last;
    for_each_frame(records_.settled, records_.dump, [&](const SphereFrame& frame) { last = frame; });
    const Bed bed = bed_of(last, records_.settled);
    const auto settled =
        simulation::settled_bed(bed.heights, bed.volumes, {}, scene_.geometry.height, scene_.geometry.cross_section());
    run_.result.packed_height = settled.height;
    run_.result.packed_voidage = settled.voidage;
    recorded_.insert(Recorded::settled_bed);
  }

  void read_drop(const std::filesystem::path& file) {
    const std::array<SeriesColumn, 4> columns{
        {{"time", units::time}, {"x", units::length}, {"y", units::length}, {"z", units::length}}};
    const std::array<std::string_view, 2> needed{"time", "z"};
    const SeriesTable table = read_series(file, columns, needed);
    require_rising(table, "time");
    const auto fail = [&](std::size_t row, const std::string& problem) {
      return std::runtime_error(fmt::format("{}:{}: {}", table.file, table.lines[row], problem));
    };
    if (table.lines.size() < 2) throw fail(0, "is the only line of numbers; a fall has two or more");
    // A marker on a sphere lies up to a radius off its centre.
    const double beyond = 0.5 * dropped_species(records_).diameter, height = scene_.geometry.height;
    for (std::size_t row = 0; row < table.lines.size(); ++row)
      if (const double z = table.at("z")[row]; !(z >= -beyond && z <= height + beyond))
        throw fail(row, fmt::format("column z: {:g} m lies outside the column of its scene, 0 to {:g} m", z, height));
    DropSeries drop;
    drop.time = table.at("time");
    drop.z = table.at("z");
    drop.x = table.has("x") ? table.at("x") : std::vector<double>(drop.z.size(), not_recorded);
    drop.y = table.has("y") ? table.at("y") : std::vector<double>(drop.z.size(), not_recorded);
    if (table.has("x") && table.has("y")) recorded_.insert(Recorded::sphere_path);
    add_drop(std::move(drop));
  }

  void add_drop(DropSeries drop) {
    const Species& species = dropped_species(records_);
    drop.species = species.name;
    const double release = drop.time.front();
    for (double& time : drop.time) time -= release;
    constexpr double touching = 0.01;  // of the diameter
    for (std::size_t k = 0; k < drop.z.size() && drop.bottom_time < 0.0; ++k)
      if (drop.z[k] <= (0.5 + touching) * species.diameter) drop.bottom_time = drop.time[k];
    const std::size_t size = drop.time.size();
    for_each_column(drop, [size](std::vector<double>& column) { column.resize(size, not_recorded); });
    run_.result.drops.push_back(std::move(drop));
    recorded_.insert(Recorded::sphere_height);
  }

  const RecordsOfOthers& records_;
  const MeasuringRules& rules_;
  Scene scene_;  ///< with the spheres that there are
  FinishedRun run_;
  std::set<Recorded> recorded_;
};

}  // namespace

FinishedRun reduce_records(const RecordsOfOthers& records, std::uint64_t packing, const MeasuringRules& rules) {
  return Reduction(records, rules).reduce(packing);
}

MeasuringRules rules_for_records(const MeasuringRules& rules) {
  MeasuringRules answered = rules;
  std::erase_if(answered.quantities, [](const Quantity& quantity) {
    return quantity.needs.empty() && !std::holds_alternative<OfSystem>(quantity.computed) &&
           !std::holds_alternative<OfAllSystems>(quantity.computed);
  });
  return answered;
}

std::string recorded_as(Recorded recorded) {
  switch (recorded) {
    case Recorded::pressure_drop:
      return "bed: time, pressure_drop";
    case Recorded::bed_centre_of_mass:
      return "bed: time, centre_of_mass_height; or positions";
    case Recorded::bed_top:
      return "bed: time, bed_top; or positions";
    case Recorded::sphere_velocities:
      return "positions with velocities";
    case Recorded::settled_bed:
      return "settled";
    case Recorded::sphere_height:
      return "drops: time, z; or positions";
    case Recorded::sphere_path:
      return "drops: time, x, y, z; or positions";
  }
  return "";
}

}  // namespace slfb
