#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/figures/figure.hpp"

/// Figures of the numerics: of the suite itself, whatever work is reproduced.
namespace slfb {

/// All of them, in the order of the report. They are drawn from this machine's results or else the committed ones.
std::vector<Figure> numerics_figures();

/// Fluctuation of the instantaneous pressure drop against the liquid's time step, for every void-fraction scheme.
Figure pressure_noise();
/// Collision frequency of an elastic gas of spheres against kinetic theory.
Figure kinetic_theory();
/// Error against cost of the particle integrators: a sphere in lasting contact, and impacts on a wall.
Figure frontier_integrators();
/// For the default of every study its error, and what is cheaper or better.
Figure default_knees();
/// Cheap answers beside the bands of the plan's rules.
Figure less_is_enough();
/// frontier-ID for every study of experiments/numerics/frontier/studies: its work-precision chart.
std::vector<Figure> frontier_charts();
/// stability-ID for every map of experiments/numerics/stability/maps.
std::vector<Figure> stability_maps();

/// Stands for figure `id` while its results do not exist: a picture that says so, and a note with the command that
/// computes them.
FigureOutput not_yet_computed(const std::string& id, const std::string& caption, const std::string& command,
                              const std::filesystem::path& folder);

}  // namespace slfb
