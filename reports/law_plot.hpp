#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "correlations/catalogue.hpp"

/// Pictures of laws: tables that gnuplot draws with reports/laws.gp.
namespace slfb {

/// One point of a law along the sweep of its kind (sweep_of).
struct SweepPoint {
  double x;       ///< in the unit of the sweep's x
  double value;   ///< the quantity that the sweep draws, in its unit; not a number where the law has no answer
  bool in_range;  ///< whether the law states that it holds there
};

/// The law along the sweep of its kind, 121 points; `arguments` are what the sweep holds fixed.
std::vector<SweepPoint> sweep(const CatalogueEntry& entry, const LawArguments& arguments);

/// Draws a law among the laws of its kind: the law bold, where it lies outside its range dotted, its variants in
/// colour, the others grey. Leaves ID.csv, ID.gp and ID.svg, ID.png or ID.pdf, one for each of `formats`, in `folder`.
/// Throws std::runtime_error where a file cannot be written or gnuplot fails.
void draw_law(const CatalogueEntry& entry, const LawArguments& arguments, const std::string& id,
              const std::filesystem::path& folder, const std::vector<std::string>& formats);

/// Draws all laws of a kind, each with its name; leaves and throws the same.
void draw_family(LawKind kind, const LawArguments& arguments, const std::string& id,
                 const std::filesystem::path& folder, const std::vector<std::string>& formats);

}  // namespace slfb
