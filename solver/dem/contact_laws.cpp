#include "solver/dem/contact_laws.hpp"

#include "solver/dem/hertz_mindlin.hpp"
#include "solver/dem/linear_spring_dashpot.hpp"

namespace slfb::dem {

std::span<const ContactLawKernels> contact_laws() {
  static constexpr std::array laws{contact_kernels_of<LinearSpringDashpot>(), contact_kernels_of<HertzMindlin>()};
  return laws;
}

}  // namespace slfb::dem
