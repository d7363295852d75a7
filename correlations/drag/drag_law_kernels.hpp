#pragma once

#include <cstddef>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Fills result[i] from voidage[i] and reynolds[i]: one call per block of spheres, the law inlined in the loop.
using DragKernel = void (*)(const double* voidage, const double* reynolds, double* result, std::size_t count);

/// A drag law that is chosen while the program runs: by name, or from a C++ file outside the suite.
struct DragLawKernels {
  LawInfo info;
  DragKernel drag;             ///< F [-]
  DragKernel slip_derivative;  ///< F + Re ∂F/∂Re [-]

  double operator()(SuspensionFlow flow) const {
    double result = 0.0;
    drag(&flow.voidage, &flow.reynolds, &result, 1);
    return result;
  }
};

/// slip_derivative of any law: of one that is written for doubles only by central differences.
template <class Law>
double any_slip_derivative(const Law& law, SuspensionFlow flow) {
  if constexpr (requires { law(SuspensionFlowOf<Dual>{flow.voidage, {flow.reynolds, 1.0}}); }) {
    return slip_derivative(law, flow);
  } else {
    constexpr double step = 1e-5;
    const auto product = [&](double factor) {
      return factor * law(SuspensionFlow{flow.voidage, factor * flow.reynolds});
    };
    return (product(1.0 + step) - product(1.0 - step)) / (2.0 * step);
  }
}

template <class Law>
constexpr DragLawKernels kernels_of() {
  return {Law::info,
          [](const double* voidage, const double* reynolds, double* result, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) result[i] = Law{}(SuspensionFlow{voidage[i], reynolds[i]});
          },
          [](const double* voidage, const double* reynolds, double* result, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i)
              result[i] = any_slip_derivative(Law{}, SuspensionFlow{voidage[i], reynolds[i]});
          }};
}

}  // namespace slfb::drag

/// Hands the law of a file outside the suite over: the last line of that file.
#define SLFB_DRAG_LAW(Law)                                   \
  extern "C" const slfb::drag::DragLawKernels slfb_drag_law; \
  const slfb::drag::DragLawKernels slfb_drag_law = slfb::drag::kernels_of<Law>();
