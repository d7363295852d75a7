#pragma once

#include <string_view>

#include "correlations/law.hpp"

namespace slfb::dem {

/// What a reader needs to know of a contact law besides its formula.
struct ContactLawInfo {
  std::string_view name;      ///< as contact.law names it
  std::string_view title;     ///< one line for lists
  std::string_view equation;  ///< the formula in plain text
  std::string_view source;    ///< key in reference-data/references.bib, or words
  Range overlap;              ///< of overlap over effective radius, where the law is meant to hold [-]
};

}  // namespace slfb::dem
