#pragma once

#include <string>

#include "correlations/law.hpp"
#include "solver/run/model.hpp"

namespace slfb::simulation {

/// How often a run asks its drag law outside the range that the law states for itself.
class LawRange {
 public:
  /// \param law of the scene
  explicit LawRange(const LawInfo& law) : law_(law) {}

  /// Looks at all spheres; after a liquid step.
  void sample(const Model& model);

  /// "the drag law ergun-1952 was asked outside its range (…) in 12 % of 3400 samples: …"; empty if it never was.
  [[nodiscard]] std::string sentence() const;

  void exchange(io::StateGroup& group);

 private:
  struct Extent {
    double least = 0.0, most = 0.0;
  };

  LawInfo law_;
  std::int64_t samples_ = 0, outside_ = 0;
  Extent voidage_, reynolds_;  ///< of the samples outside
};

}  // namespace slfb::simulation
