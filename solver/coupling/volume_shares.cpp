#include "solver/coupling/volume_shares.hpp"

#include <stdexcept>
#include <utility>

namespace slfb::coupling {

VolumeShares::VolumeShares(std::unique_ptr<ShareScheme> scheme, const fluid::ColumnGrid& grid, double largest_radius)
    : scheme_(std::move(scheme)),
      grid_(grid),
      largest_radius_(largest_radius),
      table_(grid, scheme_->reach(largest_radius)) {}

void VolumeShares::update(const dem::VectorField& centres, const std::vector<double>& radius, int threads) {
  if (!radius.empty() && *std::max_element(radius.begin(), radius.end()) > largest_radius_)
    throw std::invalid_argument("void fraction: a sphere is larger than the largest of the scene's species");
  table_.resize(radius.size());
  occupied_layers_ = scheme_->share_out({centres, radius}, table_, threads);
}

}  // namespace slfb::coupling
