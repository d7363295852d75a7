#pragma once

#include "solver/coupling/void_fraction/share_scheme.hpp"

namespace slfb::coupling {

/// A sphere lies whole in the cell of its centre: "centroid". Its share of a cell is wrong by up to all of it, and
/// jumps when the centre passes a face.
class Centroid final : public ShareScheme {
 public:
  [[nodiscard]] double reach(double) const override { return 0.0; }
  std::size_t share_out(const Balls& balls, ShareTable& table, int threads) const override;
};

}  // namespace slfb::coupling
