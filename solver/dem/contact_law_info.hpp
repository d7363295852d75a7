#pragma once

#include <span>
#include <string_view>

#include "correlations/law.hpp"

namespace slfb::dem {

/// A key of [contact] in a scene that a contact law takes.
struct ContactKey {
  std::string_view name;  ///< as in solver/scene/scene_description.hpp
  bool required = false;  ///< the law has no value without it
};

/// What a reader needs to know of a contact law besides its formula.
struct ContactLawInfo {
  std::string_view name;      ///< as contact.law names it
  std::string_view title;     ///< one line for lists
  std::string_view equation;  ///< the formula in plain text
  std::string_view source;    ///< key in reference-data/references.bib, or words
  Range overlap;              ///< of overlap over effective radius, where the law is meant to hold [-]
  /// What it takes of [contact] beside friction and numerics. A scene may not give a key that only other laws declare.
  /// Not asked of a law from a file, which may take any key.
  std::span<const ContactKey> keys = {};
  std::string_view stiffness_key = {};  ///< that key which makes it stiffer: what errors about the step advise to lower

  /// The declared key of that name, or null.
  [[nodiscard]] constexpr const ContactKey* key(std::string_view key_name) const {
    for (const ContactKey& declared : keys)
      if (declared.name == key_name) return &declared;
    return nullptr;
  }
};

}  // namespace slfb::dem
