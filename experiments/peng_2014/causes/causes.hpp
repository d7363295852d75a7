#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/quantities/measurement.hpp"
#include "experiments/runs/campaign.hpp"

/// What one change of the scene does to the bed of 5 mm glass, and which claims it would bring inside the paper's band.
namespace slfb::single_changes {

/// The system and the superficial velocities [m/s] of the changed runs.
inline constexpr const char* system_name = "6in5W";
inline constexpr std::array velocities{0.06, 0.10};

/// The unchanged scene: 6in5W.toml, or 6in5W_lattice.toml, which was the default before.
enum class Base { default_scene, lattice };

/// One thing that the runs of a profile, or those of one variant of it, have otherwise than the unchanged scene.
struct Change {
  Base base;
  const char *profile, *variant, *title;
};

/// Those of the default scene first: contacts, start, values of the liquid, drag law. Then those of the other:
/// numerics, liquid, forces, contacts, drag law.
std::span<const Change> changes();

/// The current runs of one variant of the system, under the keys of the unchanged scene (without the variant).
std::vector<FinishedRun> runs_of(const Profile& profile, const std::string& variant,
                                 const std::filesystem::path& results);

/// Measurements of the runs with this change, and of the unchanged ones, under the same keys (without a variant). Empty
/// where nothing is simulated. `results`: folder of runs/.
Measurements measure(const Change& change, const std::filesystem::path& results);
Measurements measure_unchanged(Base base, const std::filesystem::path& results);

}  // namespace slfb::single_changes

namespace slfb {

/// Adds to the reason of each claim that is not reproduced which single changes of the default scene would bring it
/// inside, with their runs as evidence; nothing where no run says so. `results`: folder of runs/.
void name_causes(std::vector<Evaluation>& evaluations, const std::filesystem::path& results);

}  // namespace slfb
