#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/figures/figure.hpp"
#include "experiments/numerics/convergence/sequences.hpp"

/// Discretisation error of what the figures show, over the runs that differ in cells or steps alone.
namespace slfb::grid_convergence {

/// The quantities that are looked at, by their names in measurements.
inline constexpr const char *velocity = "classification_velocity", *voidage = "voidage_centre_of_mass",
                            *pressure_drop = "pressure_drop", *force_ratio = "collision_force_ratio";

/// The sequences of sequences.toml, one for each superficial velocity, with what the runs of `results`/runs or the
/// committed ones say; their quantities have the names above.
/// \throws std::runtime_error with file, line and key
std::vector<convergence::Sequence> run_sequences(const std::filesystem::path& results);

/// Adds to a figure's notes, for each of the quantities that it rests on, what is known of its discretisation error in
/// the default scene and in its nearest kin.
void add_note(const std::vector<std::string>& quantities, const FigureContext& context, FigureOutput& output);

}  // namespace slfb::grid_convergence
