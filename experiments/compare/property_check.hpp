#pragma once

#include <string>

namespace slfb::compare {

/// One property that a law should have, looked for where the law is meant to hold.
struct PropertyCheck {
  std::string property;
  bool holds;
  std::string found;  ///< the number behind the verdict, and where
};

}  // namespace slfb::compare
