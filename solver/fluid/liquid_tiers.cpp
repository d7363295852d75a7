#include <algorithm>
#include <array>

#include "solver/fluid/one_dimensional_liquid.hpp"
#include "solver/fluid/prescribed_liquid.hpp"
#include "solver/fluid/three_dimensional_liquid.hpp"

namespace slfb::fluid {
namespace {

struct Tier {
  FluidTier tier;
  std::unique_ptr<Liquid> (*make)(const Scene& scene, int threads);
};

/// The tiers of the liquid; a new one is a type in a file of its own and a line here.
constexpr std::array tiers{
    Tier{FluidTier::quiescent, make_prescribed_liquid},
    Tier{FluidTier::one_dimensional, make_one_dimensional_liquid},
    Tier{FluidTier::three_dimensional, make_three_dimensional_liquid},
};

}  // namespace

std::unique_ptr<Liquid> make_liquid(const Scene& scene, int threads) {
  return std::ranges::find(tiers, scene.fluid.tier, &Tier::tier)->make(scene, threads);
}

}  // namespace slfb::fluid
