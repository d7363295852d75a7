#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/reference/expansion_lines.hpp"
#include "solver/laws/scene_file.hpp"

/// The fluidised beds of Richardson & Zaki (1954) and the scenes that simulate them.
namespace slfb::richardson_zaki {

/// The measured lines of fluidised beds, in the order of the tables; read once.
const std::vector<ExpansionLine>& beds();

/// The line of that name. \throws std::out_of_range
const ExpansionLine& bed(const std::string& name);

/// Superficial velocity of the measured line at a voidage, rounded to 0.01 mm/s, as keys of runs have it [m/s].
double run_velocity(const ExpansionLine& line, double voidage);

/// How a bed is simulated.
enum class Model {
  slice,   ///< six diameters wide, periodic sides, one-dimensional liquid
  column,  ///< three-dimensional liquid: the column itself where it is at most 20 diameters wide, else a periodic box
           ///< of ten diameters
};

/// The scene of a model, and what a bed changes in it. Lengths go with the diameter d of the spheres, times with d/u_t;
/// the contacts are so stiff that two spheres that meet at u_t overlap by 3 % of d.
std::filesystem::path scene_of(const ExpansionLine& line, Model model);
Overrides overrides_of(const ExpansionLine& line, Model model);

/// Whether the three-dimensional model has the walls of the column.
bool has_walls(const ExpansionLine& line);

}  // namespace slfb::richardson_zaki
