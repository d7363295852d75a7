#pragma once

#include <string>

namespace slfb::compare {

/// A picture of a comparison: ID.svg, ID.png, ID.csv and ID.gp in its folder, and what it shows.
struct Picture {
  std::string id, title, caption;
};

}  // namespace slfb::compare
