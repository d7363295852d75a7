#pragma once

#include "solver/coupling/void_fraction/share_scheme.hpp"

namespace slfb::coupling {

/// The exact volume of the overlap of the sphere with each cell: "exact-overlap" (Peng 2014, Eq. 29). Four spheres are
/// cut at once where each lies in at most two cells along every axis.
class ExactOverlap final : public ShareScheme {
 public:
  std::size_t share_out(const Balls& balls, ShareTable& table, int threads) const override;
};

}  // namespace slfb::coupling
