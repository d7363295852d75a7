#pragma once

#include <array>
#include <utility>
#include <vector>

#include "solver/dem/engine.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb {

/// The particle engine with the law that `contact` names. `period`: see dem::Engine.
/// Throws UserLawError, and std::invalid_argument listing the known names.
inline dem::Engine make_engine(const Contact& contact, std::vector<dem::Wall> walls, std::array<double, 3> period,
                               int threads) {
  return {contact, find_contact_law(contact.law), std::move(walls), period, threads};
}

}  // namespace slfb
