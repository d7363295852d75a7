#pragma once

#include <string_view>

namespace slfb {

namespace detail {
using Residual = double (*)(double x, void* context);
double bracketed_root(Residual residual, void* context, double lower, double upper, std::string_view unknown);
}  // namespace detail

/// Solves residual(x) = 0 on [lower, upper] with GSL's Brent method, to 1e-12 relative.
///
/// Where the residual jumps through zero without a root, the place of the jump is returned.
/// \param residual a callable double → double that does not throw
/// \param unknown what x is, with its unit, for the message ("voidage [-]")
/// \throws std::domain_error if the residual has the same sign at both ends, or is not finite there
template <class Function>
double bracketed_root(Function residual, double lower, double upper, std::string_view unknown) {
  return detail::bracketed_root([](double x, void* context) { return (*static_cast<Function*>(context))(x); },
                                &residual, lower, upper, unknown);
}

}  // namespace slfb
