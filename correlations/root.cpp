#include "correlations/root.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace slfb::detail {

double bracketed_root(Residual residual, void* context, double lower, double upper, std::string_view unknown) {
  const double at_lower = residual(lower, context);
  const double at_upper = residual(upper, context);
  if (at_lower == 0.0) return lower;
  if (at_upper == 0.0) return upper;
  // GSL's default error handler aborts the program, so that what it would reject is rejected here.
  if (!std::isfinite(at_lower) || !std::isfinite(at_upper) || (at_lower > 0.0) == (at_upper > 0.0)) {
    std::ostringstream message;
    message << "no solution for the " << unknown << " between " << lower << " and " << upper << " (residuals "
            << at_lower << " and " << at_upper << ")";
    throw std::domain_error(message.str());
  }

  gsl_function function{residual, context};
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_root_fsolver_set(solver.get(), &function, lower, upper);
  constexpr int iterations = 200;
  for (int i = 0; i < iterations; ++i) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
    const int status = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                                              gsl_root_fsolver_x_upper(solver.get()), 0.0, 1e-12);
    if (status == GSL_SUCCESS) return gsl_root_fsolver_root(solver.get());
  }
  throw std::domain_error("the root search for the " + std::string(unknown) + " did not converge");
}

}  // namespace slfb::detail
