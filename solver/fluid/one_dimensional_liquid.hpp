#pragma once

#include "solver/fluid/staggered_liquid.hpp"

namespace slfb::fluid {

/// Liquid of a section of a single cell: velocity, void fraction and pressure vary with the height only.
///
/// No pressure equation is needed: continuity (Peng 2014, Eq. 26) alone gives α w A, layer by layer from the inlet, and
/// the momentum balance (Eq. 27) of each node then holds the pressure gradient as its only unknown. Walls hold nothing
/// back.
class OneDimensionalLiquid final : public StaggeredLiquid {
 public:
  explicit OneDimensionalLiquid(const Scene& scene, int threads = 1);

 private:
  void solve(const Exchange& exchange) override;
};

std::unique_ptr<Liquid> make_one_dimensional_liquid(const Scene& scene, int threads);

}  // namespace slfb::fluid
