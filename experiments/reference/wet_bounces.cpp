#include "experiments/reference/wet_bounces.hpp"

#include "experiments/reference/reference_numbers.hpp"

namespace slfb {

std::vector<WetBounce> gondret_2002() {
  std::vector<WetBounce> bounces;
  for (const auto& row : read_columns(reference_data_folder() / "gondret_2002" / "bounces.csv", 2))
    bounces.push_back({row[0], row[1]});
  return bounces;
}

StokesLimits joseph_2001() {
  const auto row = read_columns(reference_data_folder() / "joseph_2001" / "stokes_limits.csv", 2).at(0);
  return {row[0], row[1]};
}

}  // namespace slfb
