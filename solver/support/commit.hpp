#pragma once

#include <string>

namespace slfb {

/// The commit that this program was built from, twelve digits; "-dirty" behind it where files had been changed,
/// "unknown" where the sources were no clone.
std::string suite_commit();

}  // namespace slfb
