#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

/// What a finished (or interrupted) run hands to the analysis, and its HDF5 file.
namespace slfb {

/// Bed-scale history; all vectors have the same length. Time 0 is the start of fluidisation.
struct BedSeries {
  std::vector<double> time;                   ///< [s]
  std::vector<double> pressure_drop;          ///< inlet minus outlet, static head removed [Pa]
  std::vector<double> centre_of_mass_height;  ///< of the bed particles [m]
  std::vector<double> bed_top;                ///< 99th percentile of the bed particles' centre heights [m]
  std::vector<double>
      fluctuating_energy;  ///< q_p² = 3/2 u'² (Peng 2014, Eq. 39), u'² the mean per-component variance [m²/s²]
  std::vector<double> contacts_per_particle;     ///< mean coordination number [-]
  std::vector<double> local_fluctuating_energy;  ///< q_p² about the mean velocity in boxes of 4 diameters [m²/s²]
  std::vector<double>
      cumulative_contacts;                ///< new contacts with other spheres per bed particle since the run began [-]
  std::vector<double> contact_force_bed;  ///< mean normal force of the contacts of bed particles [N]
  std::vector<double> contact_force_foreign;  ///< of the contacts of the dropped sphere with bed particles [N]
  std::vector<double> contact_force_wall;     ///< of the contacts with walls [N]
  std::vector<double> network_step;           ///< DEM step times the bound of the contact network's frequency [-]
  std::vector<double> maximum_overlap;        ///< largest overlap over particle radius [-]
  // Vertical forces on spheres and liquid together, means since the last sample (coupling::ForceBalance) [N].
  std::vector<double> pressure_force, buoyant_weight, bottom_force, wall_force, shear_force, flow_force, sphere_inertia,
      liquid_inertia;
  std::vector<double> balance_residual;  ///< largest sum of them over a step since the last sample, of the weight [-]
  std::vector<double> foreign_present;   ///< 1 while a dropped sphere is in the column, else 0
  std::vector<double> superficial_velocity;  ///< U_L at the inlet [m/s]; empty in results from before it was recorded
};

/// History of one dropped sphere; all vectors have the same length. Time 0 is its release.
struct DropSeries {
  double release_time = 0.0;  ///< on the clock of BedSeries [s]
  double bottom_time = -1.0;  ///< first touch of the distributor, after release [s]; -1: never
  std::string species;
  std::vector<double> time;                                ///< [s]
  std::vector<double> x, y, z;                             ///< centre [m]
  std::vector<double> velocity_x, velocity_y, velocity_z;  ///< [m/s]
  std::vector<double> angular_speed;                       ///< [rad/s]
  std::vector<double> voidage;                             ///< at the particle [-]
  std::vector<double> liquid_velocity_z;                   ///< interstitial, at the particle [m/s]
  std::vector<double> reynolds;                            ///< Peng 2014, Eq. 25 [-]
  std::vector<double> contact_force;  ///< |F_c|, magnitude of the resultant contact force, instantaneous [N]
  std::vector<double> contact_force_mean_x, contact_force_mean_y,
      contact_force_mean_z;                 ///< mean over the sampling interval [N]
  std::vector<double> drag_force_z;         ///< [N]
  std::vector<double> pressure_force_z;     ///< -V ∂p/∂z, static part included [N]
  std::vector<double> contacts;             ///< spheres in contact now [-]
  std::vector<double> cumulative_contacts;  ///< new contacts since release [-]
};

/// Void fraction and liquid velocity in the plane y = 0 at one instant, row after row from the bottom: fields have
/// x.size() * z.size() values, with the index iz * x.size() + ix. Empty without a flowing liquid.
struct PlaneField {
  double time = 0.0;                           ///< on the clock of BedSeries [s]
  std::vector<double> x, z;                    ///< centres of the cells along each axis [m]
  std::vector<double> voidage;                 ///< [-]; outside a round column that of the nearest cell
  std::vector<double> velocity_x, velocity_z;  ///< interstitial liquid velocity at the centres of the cells [m/s]
};

/// Fluctuation of the liquid's velocity (Peng 2014, Eq. 37) in a window: cells of the plane y = 0, those on its
/// positive side, with centres at the heights of Scene::recording.fluctuation_window, over the second half of the
/// fluidise stage. Empty until that stage is over, and without a flowing liquid. n samples, m cells.
struct LiquidFluctuation {
  std::vector<double> time;                                   ///< n, of the samples, on the clock of BedSeries [s]
  std::vector<double> x, z;                                   ///< m, centres of the cells [m]
  std::vector<double> mean_x, mean_y, mean_z;                 ///< m, mean velocity ū [m/s]
  std::vector<double> deviation_x, deviation_y, deviation_z;  ///< m, mean |u − ū| per component [m/s]
  std::vector<double> deviation_vector;                       ///< m, mean length of the vector u − ū [m/s]
  std::vector<double> rms_x, rms_y, rms_z;                    ///< m, root mean square of u − ū [m/s]
  std::vector<double> series_x, series_y, series_z, series_vector;  ///< n, mean over the cells of |u − ū| [m/s]
  std::vector<double> samples_x, samples_y, samples_z;  ///< n m velocities, sample after sample, until reduced [m/s]
};

/// Where the spheres were at one instant, to 1/65536 m.
struct Snapshot {
  std::string moment;           ///< of the first dropped sphere: "release", "enters", "halfway", "ends"
  double time = 0.0;            ///< on the clock of BedSeries [s]
  std::int64_t foreign = -1;    ///< index of the dropped sphere
  std::vector<double> x, y, z;  ///< centres [m]
  std::vector<double> radius;   ///< [m]
};

/// Everything that a run hands on.
struct RunResult {
  std::string name;        ///< hash of the scene and the numerics version
  std::string scene_text;  ///< canonical TOML of the scene, every value in SI
  int numerics = numerics_version;
  std::string suite_version;
  std::string commit;  ///< of the sources of the program; empty in results of before it was recorded
  std::string machine;
  std::string date;  ///< ISO 8601, UTC
  int threads = 1;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of the leading thread times the threads, which keep in step
  double simulated_seconds = 0.0;
  std::int64_t particle_steps = 0;
  double steps_per_contact = 0.0;      ///< DEM steps in π/ω_0 of the stiffest pair [-]
  std::int64_t particles_removed = 0;  ///< through the outlet
  double packed_voidage = 0.0;         ///< of the settled bed, from twice its centre of mass [-]
  double packed_height = 0.0;          ///< twice the centre of mass of the settled bed [m]
  BedSeries bed;
  std::vector<DropSeries> drops;
  PlaneField plane;  ///< at the end of the fluidise stage
  LiquidFluctuation fluctuation;
  std::vector<Snapshot> snapshots;
};

/// Calls `visit` with each column of a series, in the order of the file.
void for_each_column(BedSeries& series, const std::function<void(std::vector<double>&)>& visit);
void for_each_column(DropSeries& series, const std::function<void(std::vector<double>&)>& visit);

/// A data set of a result file.
struct ResultDataSet {
  std::string path;  ///< "bed/time"; of the first drop and of the first snapshot
  std::string unit;  ///< UDUNITS spelling; "1" for a ratio
  std::string description;
};

/// All of them, in the order of the file: what its attributes `unit` and `description` say.
std::vector<ResultDataSet> result_data_sets();

/// Writes a result to an HDF5 file with a checksum, whose groups solver/io/README.md lists. A temporary file takes the
/// place of `file` when it is complete. Series are stored in single precision, times in double. Throws
/// std::runtime_error that names the file if it cannot be written.
void save_result(const RunResult& result, const std::filesystem::path& file);

/// Reads what save_result wrote; the file may come from anywhere. Its checksum is compared, if it has one; the columns
/// of a group have one length, numbers are finite, times do not go back, counts and indices are within bounds. Throws
/// std::runtime_error that names the file and the item that is missing or damaged. A result written before fluctuations
/// and snapshots were recorded has none of them.
RunResult load_result(const std::filesystem::path& file);

}  // namespace slfb
