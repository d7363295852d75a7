#include <algorithm>
#include <array>

#include "solver/coupling/void_fraction/centroid.hpp"
#include "solver/coupling/void_fraction/exact_overlap.hpp"
#include "solver/coupling/void_fraction/particle_meshing.hpp"

namespace slfb::coupling {
namespace {

using Made = std::unique_ptr<ShareScheme>;

struct Scheme {
  VoidFractionScheme scheme;
  Made (*make)(const Coupling& keys);
};

/// The void-fraction schemes; a new one is a type in a file of its own and a line here.
constexpr std::array schemes{
    Scheme{VoidFractionScheme::centroid, [](const Coupling&) -> Made { return std::make_unique<Centroid>(); }},
    Scheme{VoidFractionScheme::particle_meshing,
           [](const Coupling& keys) -> Made { return std::make_unique<ParticleMeshing>(keys.meshing_pieces); }},
    Scheme{VoidFractionScheme::exact_overlap, [](const Coupling&) -> Made { return std::make_unique<ExactOverlap>(); }},
};

}  // namespace

std::unique_ptr<ShareScheme> make_share_scheme(const Coupling& keys) {
  return std::ranges::find(schemes, keys.void_fraction, &Scheme::scheme)->make(keys);
}

}  // namespace slfb::coupling
