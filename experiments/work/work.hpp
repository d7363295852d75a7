#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/compare/comparison_bed.hpp"
#include "experiments/figures/figure.hpp"
#include "experiments/numerics/plan/figure_plan.hpp"
#include "experiments/quantities/quantity.hpp"
#include "experiments/reference/reference_numbers.hpp"
#include "reports/report_contents.hpp"

/// A work is a publication, or a set of measurements, that the suite reproduces.
namespace slfb {

/// Where the files of a work lie.
struct WorkFolders {
  std::filesystem::path experiments;     ///< profiles.toml, scenes/, and the code and texts of its figures
  std::filesystem::path reference_data;  ///< claims.toml and the numbers that it prints
  std::filesystem::path published;       ///< committed results of its runs: PROFILE/SYSTEM_VELOCITY_VARIANT.h5
};

/// experiments/ID, reference-data/ID and reports/published/ID/runs of the source tree.
WorkFolders folders_of(const std::string& id);

/// A bed, its liquid and the sphere that is dropped into it, by the name that runs, claims and profiles use.
struct System {
  std::string name;
  std::string title;
};

/// The runs of one variant of a profile.
struct ProfileVariant {
  std::string profile, variant;
};

/// Everything that a work hands to the general rooms. What a work does not have is left empty.
struct Work {
  std::string id;        ///< "author_2020": what --work takes
  std::string citation;  ///< authors, year, journal, pages, DOI
  WorkFolders folders;
  std::vector<System> systems;
  MeasuringRules measuring;                     ///< its own quantities, its clocks and windows
  const ReferenceNumbers* reference = nullptr;  ///< the numbers that it prints
  std::vector<Figure> figures;                  ///< in its order

  std::string default_profile = "quick";
  std::string shown_beside = {};  ///< profile whose runs figures and claims use beside those of any other
  /// Variants of profiles that are the unchanged scene under another name: more samples of its numbers, where the
  /// models agree (take_out_other_models).
  std::vector<ProfileVariant> unchanged = {};
  std::vector<std::string> read_by_figures = {};  ///< profiles whose runs single figures read by themselves
  /// Profiles and claims that follow from a table of the work row by row, beside those of profiles.toml and
  /// claims.toml.
  std::function<std::vector<Profile>()> profiles = {};
  std::function<std::vector<Claim>()> claims = {};
  std::optional<double> stated_liquid_step = {};    ///< liquid time step of the source [s]; empty: that of the scene
  std::function<Measurements()> without_runs = {};  ///< what laws and probes say

  /// Adds reasons to evaluations. \param results folder of runs/
  std::function<void(std::vector<Evaluation>&, const std::filesystem::path& results)> name_causes = {};
  std::function<std::vector<reports::InconsistencyRow>()> inconsistencies = {};
  std::function<reports::WorkTexts()> texts = {};
  /// The bed in which `slfb compare` puts laws side by side.
  std::function<compare::ComparisonBed()> comparison_bed = {};
  std::function<std::vector<plan::FigurePlan>()> figure_plans = {};  ///< for `slfb plan --figures`
};

using Works = std::vector<const Work*>;

/// The work with this id, or for "" the first that has figures. Throws std::invalid_argument that names the known ones.
const Work& find_work(const Works& works, const std::string& id);

std::set<std::string> system_names(const Work& work);

/// Whether a number is answered by simulations: its subject is a system of the work, or all of them.
bool needs_run(const Work& work, const MeasureKey& key);

/// The claims of folders.reference_data/claims.toml and Work::claims. Throws as the other load_claims; where there is
/// no such file, the others alone.
std::vector<Claim> load_claims(const Work& work);

}  // namespace slfb
