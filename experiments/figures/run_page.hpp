#pragma once

#include <filesystem>
#include <vector>

#include "experiments/quantities/quantity.hpp"
#include "solver/io/run_result.hpp"

/// A finished run as a reader looks at it first.
namespace slfb {

/// Draws the standard plots of a run into `folder` and puts them on one page, index.html, which it returns: heights of
/// the bed and of the dropped spheres, pressure drop, the fall with its straight line, forces on bed and liquid,
/// voidage in the plane y = 0, and the spheres. What was not recorded is left out and said. \param rules window of the
/// straight line \throws std::runtime_error as draw_plot and write_file
std::filesystem::path write_run_page(const Scene& scene, const RunResult& result, const MeasuringRules& rules,
                                     const std::filesystem::path& folder);

/// The spheres of a run at its snapshots, in order of time: those for ParaView in `run_folder`/snapshots, or without
/// these the ones of the result, which hold a few moments of the first drop.
std::vector<Snapshot> snapshots_of(const RunResult& result, const std::filesystem::path& run_folder);

/// Draws one picture per snapshot into `folder`, frame_0000.png and so on, all to one scale, and returns how many.
/// \throws std::runtime_error as draw_plot
std::size_t draw_frames(const Scene& scene, const std::vector<Snapshot>& snapshots,
                        const std::filesystem::path& folder);

}  // namespace slfb
