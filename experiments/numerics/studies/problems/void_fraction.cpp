#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "experiments/numerics/studies/hard_spheres.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "experiments/numerics/studies/scheme_study.hpp"
#include "solver/coupling/volume_shares.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

TrialResult solve(const Scene& scene, const Parameters& parameters, int replicate) {
  namespace vf = void_fraction_study;
  // A cube of spheres at the solids fraction that is `across` cells wide: the number of spheres follows.
  const double solids = parameters.at("solids");
  constexpr int across = 5;
  const double side = across * parameters.at("cell");
  const int count = std::max(8, static_cast<int>(std::lround(solids * side * side * side * 6.0 / std::numbers::pi)));
  const vf::Assembly assembly = vf::hard_spheres(count, solids, static_cast<unsigned>(replicate) + 1);
  const double diameter = scene.species.front().diameter;
  const vf::Method method{"", scene.coupling.void_fraction, scene.coupling.meshing_pieces,
                          scene.coupling.smoothing_length / diameter};
  const auto outcome = vf::compare(assembly, across, 4, 0.02, {method}).front();
  TrialResult result;
  // A cell's solids fraction over the mean is 1 on average; its deviation from exact overlap is the error.
  result.values["solids_fraction"] = {1.0, outcome.root_mean_square, 1.0};
  result.values["worst_cell"] = {1.0, outcome.largest, 1.0};
  const double pieces =
      scene.coupling.void_fraction == VoidFractionScheme::particle_meshing ? scene.coupling.meshing_pieces : 1.0;
  result.counts["pieces per sphere"] = pieces;
  result.cpu_seconds = 1e-9 * outcome.nanoseconds;
  return result;
}

/// Largest solids fraction that a scheme gives any cell over many placements of the grid.
TrialResult fullest(const Scene& scene, const Parameters& parameters, int replicate) {
  namespace vf = void_fraction_study;
  const double solids = parameters.at("solids"), cell = parameters.at("cell");
  const int across = std::max(3, static_cast<int>(std::ceil(5.0 / cell)));
  const double side = across * cell;
  const int count = std::max(8, static_cast<int>(std::lround(solids * side * side * side * 6.0 / std::numbers::pi)));
  const vf::Assembly assembly = vf::hard_spheres(count, solids, static_cast<unsigned>(replicate) + 1);
  Scene cubes = scene;
  cubes.geometry.width = {assembly.side, assembly.side};
  cubes.geometry.height = assembly.side;
  cubes.fluid.wall = LateralBoundary::periodic;
  cubes.fluid.cells_across = across;
  cubes.fluid.cell_height = assembly.side / across;
  const double foreign = 0.5 * parameters.at("foreign");
  const fluid::ColumnGrid grid(cubes);
  coupling::VolumeShares shares(coupling::make_share_scheme(scene.coupling), grid, std::max(0.5, foreign));
  const double cell_volume = std::pow(assembly.side / across, 3);
  std::mt19937_64 generator(1);
  const double start = thread_cpu_seconds();
  double fullest = 0.0;
  const int placements = static_cast<int>(parameters.at("placements"));
  for (int placement = 0; placement < placements; ++placement) {
    std::array<double, 3> shift{};
    for (double& s : shift) s = assembly.side * static_cast<double>(generator() >> 11) * 0x1p-53;
    const auto within = [&](double x) { return x - assembly.side * std::floor(x / assembly.side); };
    dem::Particles spheres;
    for (const auto& centre : assembly.centres) {
      const double x = within(centre[0] + shift[0]) - 0.5 * assembly.side,
                   y = within(centre[1] + shift[1]) - 0.5 * assembly.side, z = within(centre[2] + shift[2]);
      // The grid is not periodic upwards: what lies over its ends is there again at the other one.
      for (const double image : {z - assembly.side, z, z + assembly.side})
        if (image > -0.5 && image < assembly.side + 0.5) spheres.add({x, y, image}, 0.5, 1.0, 0);
    }
    std::vector<double> volumes(spheres.size(), std::numbers::pi / 6.0);
    if (foreign > 0.0) {
      // In place of the spheres that it covers.
      for (std::size_t i = spheres.size(); i-- > 0;) {
        const auto c = spheres.position.at(i);
        if (std::hypot(c[0], c[1], c[2] - 0.5 * assembly.side) < foreign + 0.5) {
          spheres.remove(i);
          volumes.pop_back();
        }
      }
      spheres.add({0.0, 0.0, 0.5 * assembly.side}, foreign, 1.0, 0);
      volumes.push_back(4.0 / 3.0 * std::numbers::pi * foreign * foreign * foreign);
    }
    std::vector<double> solid;
    shares.update(spheres, 1);
    shares.scatter(volumes, solid);
    for (std::size_t c = 0; c < solid.size(); ++c) {
      const auto layer = static_cast<int>(c) % grid.layers();
      if (layer > 0 && layer + 1 < grid.layers()) fullest = std::max(fullest, solid[c] / cell_volume);
    }
  }
  TrialResult result;
  result.values["fullest_cell"].value = fullest;
  result.counts["placements"] = placements;
  result.cpu_seconds = thread_cpu_seconds() - start;
  return result;
}

}  // namespace

Problem void_fraction_problem() {
  return {"void-fraction",
          "Solids fraction of cubic cells among hard spheres at random, against exact overlap.",
          "sphere",
          "numerics/studies/scenes/box.toml",
          {{"solids_fraction", "solids fraction of a cell", "of the mean"},
           {"worst_cell", "solids fraction of the worst cell", "of the mean"}},
          {{"cell", 1.25}, {"solids", 0.45}},  // cell width in diameters
          solve};
}

Problem fullest_cell_problem() {
  return {"fullest-cell",
          "Largest solids fraction that a scheme gives any cell among hard spheres at random.",
          "run",
          "numerics/studies/scenes/box.toml",
          {{"fullest_cell", "largest solids fraction of a cell", "-"}},
          {{"cell", 1.25}, {"solids", 0.5}, {"foreign", 0.0}, {"placements", 12.0}},
          fullest};
}

}  // namespace slfb::studies
