#pragma once

#include <array>
#include <vector>

#include "solver/coupling/volume_shares.hpp"
#include "solver/fluid/column_grid.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::coupling {

/// Spheres without neighbours, whose volume and forces are spread over the section so that they do not read themselves.
///
/// In a bed a sphere's own share of its cells stands where a neighbour could be: the voidage that it reads is that of
/// the bed. Alone it reads a voidage, a liquid velocity and a pressure gradient that it has made itself, and that hang
/// on the cells. The drag laws mean the undisturbed ones. Alone a sphere therefore gives what it gives to the liquid,
/// volume as well as momentum, to all cells of the layers around it: with the share of each layer in the hat
/// max(0, 1 − |z − z_i|/b)/b, and within a layer by area. A force that is uniform over the section moves no liquid
/// (pressure alone carries it), and the own volume is at most V/(A b) of a layer. Voidage and velocity are still read
/// where the sphere is, in the cells of its shares.
///
/// Between the two stands the weight λ of what is spread:
///
///   λ = 1 − 3 x² + 2 x³,  x = min(1, s/s_c),  s_c = 0.1,
///
/// s the solid fraction that other spheres make up, the larger one of that in its own cells and that in its hat. At
/// s_c spheres stand 1.7 diameters apart; in cells of about a sphere's size, neighbours then begin to fill a sphere's
/// own cells. Above, in any bed, nothing is changed. λ is continuous, also in its slope, and has no memory: an entry
/// into a bed is as smooth as the hat is wide, and what is given is conserved at any λ.
///
/// b = 2 d, or more so that the own volume is at most 0.5 % of a layer, but not above 10 d; a cell's height at the
/// least. Limits: in a column narrower than about 3 d the own volume exceeds that; of spheres that fall apart from each
/// other in a wide column none feels the other's wake.
class LoneSpheres {
 public:
  /// The grid must outlive the spheres. \param spread whether there are any, Coupling::own_volume
  LoneSpheres(const fluid::ColumnGrid& grid, bool spread) : grid_(grid), spread_(spread) {}

  /// Finds them. \param heights of the centres [m]; \param shares of all spheres; \param sphere_volume [m³]
  /// \param solid Σ_i φ_ic V_i per cell [m³]
  void update(const std::vector<double>& heights, const std::vector<double>& radii, const VolumeShares& shares,
              const std::vector<double>& sphere_volume, const std::vector<double>& solid);

  [[nodiscard]] bool any() const { return !lone_.empty(); }
  /// λ of sphere i [-].
  [[nodiscard]] double weight(std::size_t i) const { return any() && number_[i] >= 0 ? of(i).weight : 0.0; }
  /// What of the voidage that sphere i reads in its cells is its own spread volume [-].
  [[nodiscard]] double own_spread_fraction(std::size_t i) const { return weight(i) > 0.0 ? of(i).own_fraction : 0.0; }

  /// Takes λ of what scatter() has given to the cells of each lone sphere away from them and spreads it.
  /// \param values per sphere; \param cells Σ_i φ_ic value_i per cell
  void spread(const std::vector<double>& values, const VolumeShares& shares, std::vector<double>& cells) const;

  /// Means over the section of what the cells hold, per layer: what mean() reads. `fields` values per cell, at
  /// value(cell, field).
  template <std::size_t fields, class Value>
  [[nodiscard]] std::vector<std::array<double, fields>> section_means(const Value& value) const {
    const auto layers = static_cast<std::size_t>(grid_.layers());
    std::vector<std::array<double, fields>> means(layers);
    for (int s = 0; s < grid_.cells(); ++s) {
      const double share = grid_.area(s) / grid_.section_area();
      for (std::size_t k = 0; k < layers; ++k)
        for (std::size_t f = 0; f < fields; ++f)
          means[k][f] += share * value(static_cast<std::size_t>(s) * layers + k, f);
    }
    return means;
  }
  /// What sphere i reads with the weights by which it gives, the adjoint of scatter and spread().
  /// \param by_shares Σ_c φ_ic value_c; \param means section_means()
  template <std::size_t fields>
  [[nodiscard]] std::array<double, fields> mean(std::size_t i, std::array<double, fields> by_shares,
                                                const std::vector<std::array<double, fields>>& means) const {
    const double own = weight(i);
    if (own == 0.0) return by_shares;
    const Lone& sphere = of(i);
    for (double& value : by_shares) value *= 1.0 - own;
    for (std::size_t k = 0; k < sphere.count; ++k)
      for (std::size_t f = 0; f < fields; ++f)
        by_shares[f] += own * hat_[sphere.start + k] * means[sphere.first + k][f];
    return by_shares;
  }

 private:
  struct Lone {
    std::size_t sphere;
    double weight, own_fraction;
    std::size_t first, count;  ///< layers of its hat
    std::size_t start;         ///< of their shares in hat_
  };
  [[nodiscard]] const Lone& of(std::size_t i) const { return lone_[static_cast<std::size_t>(number_[i])]; }

  const fluid::ColumnGrid& grid_;
  bool spread_;
  std::vector<Lone> lone_;
  std::vector<int> number_;  ///< of each sphere in lone_, or -1; empty if there are none
  std::vector<double> hat_;
  std::vector<double> layer_solid_;  ///< of all spheres, per layer [m³]
};

}  // namespace slfb::coupling
