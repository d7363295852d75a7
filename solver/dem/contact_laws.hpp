#pragma once

#include <span>

#include "solver/dem/contact_law.hpp"

namespace slfb::dem {

/// The contact laws of the suite. A new law is one new header and one line in contact_laws.cpp.
std::span<const ContactLawKernels> contact_laws();

}  // namespace slfb::dem
