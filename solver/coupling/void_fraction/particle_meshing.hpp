#pragma once

#include "solver/coupling/void_fraction/share_scheme.hpp"

namespace slfb::coupling {

/// Centroids of N pieces of equal volume that make up the unit ball: shells of equal-area spiral points [-].
std::vector<std::array<double, 3>> meshing_template(int pieces);

/// A sphere is made of pieces of equal volume, each of which lies whole in the cell of its centroid: "particle-meshing"
/// (Peng 2014, Eqs. 32-34). The shares are wrong by about the surface's part of the pieces, N^(−1/3).
class ParticleMeshing final : public ShareScheme {
 public:
  /// \param pieces N, coupling.meshing_pieces
  explicit ParticleMeshing(int pieces);

  std::size_t share_out(const Balls& balls, ShareTable& table, int threads) const override;

 private:
  std::array<std::vector<double>, 3> centroids_;  ///< of the unit ball's pieces along each axis [-]
};

}  // namespace slfb::coupling
