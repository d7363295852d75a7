#pragma once

#include <cstddef>
#include <vector>

#include "correlations/drag/drag_law.hpp"
#include "correlations/law_parameters.hpp"

namespace slfb::drag {

/// Fills result[i] from voidage[i] and reynolds[i]: one call per block of spheres, the law inlined in the loop.
struct DragKernel {
  void (*function)(const void* law, const double* voidage, const double* reynolds, double* result, std::size_t count);
  const void* law = nullptr;  ///< with its parameters; null: as its source has it

  void operator()(const double* voidage, const double* reynolds, double* result, std::size_t count) const {
    function(law, voidage, reynolds, result, count);
  }
};

/// A drag law that is chosen while the program runs: by name, or from a C++ file outside the suite.
struct DragLawKernels {
  LawInfo info;
  DragKernel drag;             ///< F [-]
  DragKernel slip_derivative;  ///< F + Re ∂F/∂Re [-]
  std::vector<ParameterInfo> (*parameters)();
  /// The law with these values, which the caller keeps for as long as its kernels are used. Throws as with_values.
  const void* (*with)(const LawCall& call);

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

/// Calls `use` with the law whose parameters `law` points to. Without, they are constants of the code that is compiled.
template <class Law, class Use>
void with_parameters_at(const void* law, Use use) {
  if constexpr (HasParameters<Law>)
    if (law != nullptr) return use(Law(*static_cast<const Law*>(law)));
  use(Law{});
}

template <class Law>
constexpr DragLawKernels kernels_of() {
  return {
      Law::info,
      {[](const void* parameters, const double* voidage, const double* reynolds, double* result, std::size_t count) {
        with_parameters_at<Law>(parameters, [=](const Law law) {
          for (std::size_t i = 0; i < count; ++i) result[i] = law(SuspensionFlow{voidage[i], reynolds[i]});
        });
      }},
      {[](const void* parameters, const double* voidage, const double* reynolds, double* result, std::size_t count) {
        with_parameters_at<Law>(parameters, [=](const Law law) {
          for (std::size_t i = 0; i < count; ++i)
            result[i] = any_slip_derivative(law, SuspensionFlow{voidage[i], reynolds[i]});
        });
      }},
      [] { return parameters_of<Law>(); },
      [](const LawCall& call) -> const void* { return new Law(with_values<Law>(call)); }};
}

}  // namespace slfb::drag

/// Hands the law of a file outside the suite over: the last line of that file.
#define SLFB_DRAG_LAW(Law)                                   \
  extern "C" const slfb::drag::DragLawKernels slfb_drag_law; \
  const slfb::drag::DragLawKernels slfb_drag_law = slfb::drag::kernels_of<Law>();
