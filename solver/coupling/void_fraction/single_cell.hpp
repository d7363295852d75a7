#pragma once

#include "solver/coupling/void_fraction/share_scheme.hpp"

namespace slfb::coupling {

/// Every sphere lies whole in the only cell of the grid: for a liquid of given velocity, whatever the scene's scheme.
class SingleCell final : public ShareScheme {
 public:
  [[nodiscard]] double reach(double) const override { return 0.0; }
  std::size_t share_out(const Balls& balls, ShareTable& table, int) const override {
    for (std::size_t i = 0; i < balls.radius.size(); ++i) {
      table.cells(i)[0] = 0;
      table.shares(i)[0] = 1.0;
      table.set_count(i, 1);
    }
    return 1;
  }
};

}  // namespace slfb::coupling
