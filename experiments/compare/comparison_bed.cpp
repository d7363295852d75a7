#include "experiments/compare/comparison_bed.hpp"

#include <fmt/format.h>

namespace slfb::compare {

std::string NamedSphere::words() const { return fmt::format("{:g} mm {}", 1e3 * sphere.diameter, material); }

}  // namespace slfb::compare
