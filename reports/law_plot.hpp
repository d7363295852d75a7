#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "correlations/catalogue.hpp"

namespace slfb {

/// One law along the sweep of its kind: x and the quantity drawn there, with whether it lies in the law's range.
struct SweepPoint {
  double x;
  double value;  ///< not a number where the law has no answer
  bool in_range;
};
std::vector<SweepPoint> sweep(const CatalogueEntry& entry, const LawArguments& arguments);

/// Draws a law among the laws of its kind: the law bold, where it lies outside its range dotted, its variants in
/// colour, the others grey. Leaves ID.csv, ID.gp and ID.svg, ID.png or ID.pdf, one for each of `formats`, in `folder`.
void draw_law(const CatalogueEntry& entry, const LawArguments& arguments, const std::string& id,
              const std::filesystem::path& folder, const std::vector<std::string>& formats);

/// Draws all laws of a kind, each with its name.
void draw_family(LawKind kind, const LawArguments& arguments, const std::string& id,
                 const std::filesystem::path& folder, const std::vector<std::string>& formats);

}  // namespace slfb
