#include "solver/coupling/void_fraction/centroid.hpp"

namespace slfb::coupling {

std::size_t Centroid::share_out(const Balls& balls, ShareTable& table, int threads) const {
  const auto never_cut = [](const CellBlock&, const std::array<double, 3>&, double, double*) {};
  return share_out_by_fours(balls.radius.size(), threads, [&](std::size_t first, std::size_t last) {
    return share_out_one_by_one(balls, first, last, *this, table, never_cut);
  });
}

}  // namespace slfb::coupling
