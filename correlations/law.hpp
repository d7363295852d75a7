#pragma once

#include <limits>
#include <string_view>

namespace slfb {

/// Closed interval in which a source states (or measured) its law to hold.
struct Range {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  [[nodiscard]] constexpr bool contains(double value) const { return value >= lower && value <= upper; }
};

/// How the printed form of a law came to us.
enum class Confidence {
  read,           ///< read in a source that quotes or implements the paper
  recalled,       ///< common knowledge of the field; no source opened
  derived,        ///< derived from first principles or settled by a limit
  reconstructed,  ///< the original is not at hand; a labelled stand-in
};

/// What a law answers, and with it which arguments it takes.
enum class LawKind {
  drag,                  ///< drag of one sphere in a suspension over Stokes drag
  single_sphere_drag,    ///< drag of one sphere alone over Stokes drag
  wall_correction,       ///< terminal velocity in a tube over that in unbounded liquid
  minimum_fluidisation,  ///< superficial velocity at which a packed bed fluidises
  expansion_exponent,    ///< n of Richardson and Zaki's U = U_i ε^n
  classification,        ///< settling velocity of a foreign sphere through a fluidised bed
  collision_force,       ///< mean collision force on a foreign sphere over its weight
  radial_distribution,   ///< g_0, the pair distribution of spheres at contact
  collision_frequency,   ///< collisions per sphere and time, made dimensionless
  restitution,           ///< rebound speed over impact speed in a liquid, over the dry value
};

/// What a reader needs to know of a law besides its formula.
struct LawInfo {
  std::string_view name;  ///< "author-year", lower case, as on the command line
  LawKind kind;
  std::string_view title;                 ///< one line for lists
  std::string_view equation;              ///< the formula in plain text
  std::string_view equation_number = "";  ///< its number in the source; empty where the source is not at hand
  std::string_view source;                ///< key in reference-data/references.bib
  std::string_view convention;            ///< which Reynolds number, which velocity, model A or B
  Range reynolds;                         ///< range of the Reynolds number named in `convention` [-]
  Range voidage;                          ///< range of the voidage [-]
  Confidence confidence;
  std::string_view note = "";
  std::string_view variant_of = "";  ///< the law that other sources print under the same name; empty for that law
  Range size_ratio = {};  ///< of d/D where a law takes a column, of d_2/d_1 where it takes a foreign sphere [-]
  Range stokes = {};      ///< of the Stokes number ρ_P √(q_p²) d / (9 μ) of the foreign sphere [-]
};

}  // namespace slfb
