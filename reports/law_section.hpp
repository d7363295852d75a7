#pragma once

#include <string>

namespace slfb {

/// The report's list of laws, from the catalogue: an HTML table with range, source and how each formula came to us.
std::string law_section();

}  // namespace slfb
