#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/quantities/quantity.hpp"
#include "experiments/runs/campaign.hpp"
#include "experiments/runs/sphere_frames.hpp"

/// Records of an experiment or of another code, reduced as the runs of this suite are.
namespace slfb {

/// Where the records of one bed lie. Files have the formats of series_file.hpp and sphere_frames.hpp.
struct RecordsOfOthers {
  std::string name;                          ///< for messages and as the origin of its numbers
  RunSpec spec;                              ///< system, superficial velocity and variant that it answers
  Scene scene;                               ///< its column, liquid and spheres
  std::filesystem::path bed;                 ///< CSV: time, and any of pressure_drop, centre_of_mass_height, bed_top
  std::filesystem::path positions;           ///< the spheres at times
  std::filesystem::path settled;             ///< the spheres of the settled bed: the last frame counts
  std::vector<std::filesystem::path> drops;  ///< CSV, one sphere each: time, z and, where known, x and y
  DumpUnits dump;
  std::optional<std::int64_t> dropped_id, dropped_type;  ///< the dropped sphere in `positions` and `settled`
  double fluidised_from = 0.0;  ///< start of fluidisation on the clock of bed and positions [s]
  double undisturbed_until = std::numeric_limits<double>::infinity();  ///< first release on that clock [s]
};

/// The run that they stand for, with its summary. Of the quantities of the rules those are computed for which enough
/// was recorded (Quantity::needs), by the functions that reduce the runs of this suite; what was not recorded is
/// absent.
///
/// Time 0 of a drop is its first sample. It is at the bottom at the first sample at which its lowest point is at most
/// a hundredth of its diameter above z = 0. In `positions` the bed is undisturbed until the dropped sphere is there.
/// \param packing tells beds of different packings apart: it takes the place of their seed
/// \throws std::runtime_error with the file where a record cannot be read, or where its spheres fill another volume
/// than those of the scene by more than 1 %: another bed, or another unit of length.
FinishedRun reduce_records(const RecordsOfOthers& records, std::uint64_t packing, const MeasuringRules& rules);

/// The quantities of the rules that records of others can answer, with those that follow from several runs.
MeasuringRules rules_for_records(const MeasuringRules& rules);

/// What a record has to hold: "drops: time, z".
std::string recorded_as(Recorded recorded);

}  // namespace slfb
