#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "correlations/law.hpp"
#include "solver/run/model.hpp"

namespace slfb::simulation {

/// How often a run asks its drag law outside the range that the law states for itself, by species: a dropped sphere is
/// one sample among thousands of the bed's, and the one that is measured.
class LawRange {
 public:
  /// \param law of the scene
  LawRange(const LawInfo& law, const std::vector<Species>& species);

  /// Looks at all spheres; after a liquid step.
  void sample(const Model& model);

  /// Whether more than 0.1 % of a species' samples lay outside: what is rarer moves no mean that a run gives.
  [[nodiscard]] bool often_outside() const;

  /// "the drag law ergun-1952 was asked outside its range (…) in 12 % of 3400 samples of steel: …", of the species with
  /// the largest share; empty if no species ever was outside.
  [[nodiscard]] std::string sentence() const;

  void exchange(io::StateGroup& group);

 private:
  /// The species with the largest share outside.
  [[nodiscard]] std::size_t worst() const;
  [[nodiscard]] double share(std::size_t species) const;

  LawInfo law_;
  std::vector<std::string> names_;
  std::vector<std::int64_t> samples_, outside_;  ///< of each species
  // Of the samples outside.
  std::vector<double> least_voidage_, most_voidage_, least_reynolds_, most_reynolds_;
};

}  // namespace slfb::simulation
