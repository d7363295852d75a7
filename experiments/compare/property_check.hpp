#pragma once

#include <limits>
#include <string>

namespace slfb::compare {

/// One property that a law should have, looked for where the law is meant to hold.
struct PropertyCheck {
  std::string property;
  bool holds;
  std::string found;  ///< the number behind the verdict, and where
};

/// The largest of several values, and where it was found. A value that is not a number counts as larger than any.
struct LargestValue {
  double value = -std::numeric_limits<double>::infinity();
  std::string where;

  void update(double candidate, const std::string& position) {
    if (candidate <= value) return;
    value = candidate;
    where = position;
  }
};

}  // namespace slfb::compare
