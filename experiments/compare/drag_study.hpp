#pragma once

#include <string>
#include <vector>

#include "correlations/drag/drag_law_kernels.hpp"
#include "experiments/compare/comparison_bed.hpp"
#include "experiments/compare/property_check.hpp"
#include "experiments/quantities/measurement.hpp"

/// What a drag law says before anything is simulated: its surface, its properties, and the homogeneous bed it makes.
namespace slfb::compare {

/// One of the laws that are compared: by name, or from a file.
struct ComparedDragLaw {
  std::string argument;  ///< as coupling.drag_law names it
  drag::DragLawKernels law;
  [[nodiscard]] std::string name() const { return std::string(law.info.name); }
};

/// The laws of a list of names and files. \throws UserLawError, std::invalid_argument; std::runtime_error where a law
/// gives no positive number in its own range, or two laws have one name
std::vector<ComparedDragLaw> compared_drag_laws(const std::vector<std::string>& arguments);

/// The points at which laws are compared: voidage 0.36 to 1, Re 0.01 to 10000 in even steps of its logarithm.
struct DragGrid {
  std::vector<double> voidage, reynolds;
};
DragGrid drag_grid();

/// F at every point of the grid, one voidage after the other [-].
std::vector<double> drag_on_grid(const drag::DragLawKernels& law);

/// A law over another one at the points of the grid that lie in the ranges of both.
struct DragRatio {
  double smallest, median, largest;
  std::size_t points;  ///< 0: the ranges do not meet, and the ratios are not numbers
};
DragRatio drag_ratio(const drag::DragLawKernels& law, const drag::DragLawKernels& other);

/// The properties that a drag law should have, looked for in the law's own range, and a steady expansion of the bed.
std::vector<PropertyCheck> check_properties(const drag::DragLawKernels& law, const ComparisonBed& bed);

/// Superficial velocity that carries the spheres of the bed at that voidage [m/s]; NaN where there is none.
double bed_velocity(const drag::DragLawKernels& law, const ComparisonBed& bed, double voidage);

/// Whether the law is meant for the spheres of the bed at that voidage [-] and superficial velocity [m/s].
bool bed_in_range(const drag::DragLawKernels& law, const ComparisonBed& bed, double voidage,
                  double superficial_velocity);

/// The homogeneous bed at a superficial velocity, and the foreign sphere in it.
struct HomogeneousBed {
  double voidage;                  ///< [-]
  double classification_velocity;  ///< by force balance, without collisions [m/s]; NaN without a steady bed
  bool bed_in_range;               ///< whether the law is meant for the spheres of the bed
  bool in_range;                   ///< whether it is meant for them and for the foreign sphere
};
/// \param superficial_velocity [m/s]
HomogeneousBed homogeneous_bed(const drag::DragLawKernels& law, const ComparisonBed& bed, double superficial_velocity);

/// What measure_runs would find, as far as the homogeneous bed answers it, under the same keys: minimum fluidisation
/// velocity, and voidage and classification velocity at the velocities of `bed.classification`.
Measurements measure_homogeneous_bed(const drag::DragLawKernels& law, const ComparisonBed& bed);

/// Where a law is used outside the range that it states for itself, one sentence each: at minimum fluidisation, in the
/// homogeneous bed at the velocities of `bed.classification`, and in runs, by the Reynolds numbers and voidages
/// measured in them.
std::vector<std::string> uses_outside_range(const drag::DragLawKernels& law, const ComparisonBed& bed,
                                            const Measurements& measured);

/// Time of one evaluation in blocks of 256 on one core [s].
double seconds_per_evaluation(const drag::DragLawKernels& law);

/// What is known of one law without a simulation.
struct DragFindings {
  std::vector<PropertyCheck> properties;
  double minimum_fluidisation;    ///< [m/s]
  double seconds_per_evaluation;  ///< [s]
};
DragFindings characterise(const drag::DragLawKernels& law, const ComparisonBed& bed);

}  // namespace slfb::compare
