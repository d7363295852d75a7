#include "experiments/richardson_zaki_1954/simulations.hpp"

#include <algorithm>
#include <string>

#include "experiments/league/standings.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"
#include "solver/support/folders.hpp"

namespace slfb::richardson_zaki {
namespace {

RunSpec run_of(const ExpansionLine& line, double voidage, Model model, const std::string& variant,
               const Profile& profile) {
  return {line.name,
          run_velocity(line, voidage),
          variant,
          scene_of(line, model),
          overrides_of(line, model),
          profile.name,
          profile.differences,
          source_folder() / "reports" / "published" / "richardson_zaki_1954" / "runs"};
}

void add(Profile& profile, RunSpec run, const Overrides& more = {}) {
  run.overrides.insert(run.overrides.end(), more.begin(), more.end());
  run.overrides.push_back("liquid.superficial_velocity=" + velocity_text(run.superficial_velocity) + " m/s");
  profile.runs.push_back(std::move(run));
}

std::vector<std::string> differences(const std::string& how) {
  return {how, "Contacts softened: two spheres that meet at the terminal velocity overlap by 3 % of the diameter.",
          "Beds of 10 or 20 diameters at rest, not of unknown mass."};
}

}  // namespace

std::vector<Profile> profiles() {
  const std::string columns = "Columns in three dimensions; periodic boxes of ten diameters for those of more than 20.";
  const auto profile = [](const char* name, const std::string& how) {
    return Profile{.name = name, .differences = differences(how), .runs = {}, .goes_on_from_published = true};
  };
  Profile quick = profile("quick", columns), full = profile("full", columns), laws = profile("laws", columns);
  for (const ExpansionLine& line : beds()) {
    for (const double voidage : quick_voidages) {
      add(quick, run_of(line, voidage, Model::column, "", quick));
      for (const char* law : near_laws)
        add(laws, run_of(line, voidage, Model::column, law, laws), {std::string("coupling.drag_law=") + law});
    }
    for (const double voidage : league::line_voidages) {
      add(quick, run_of(line, voidage, Model::slice, one_dimensional, quick));
      // A run that quick has too is one run, published once.
      const bool in_quick = std::ranges::find(quick_voidages, voidage) != quick_voidages.end();
      add(full, run_of(line, voidage, Model::column, "", in_quick ? quick : full));
    }
    // What a narrower box costs: the same bed without walls, six diameters wide.
    if (!has_walls(line)) {
      const std::string width = std::to_string(6.0 * line.sphere.diameter) + " m";
      add(full, run_of(line, 0.7, Model::column, in_narrower_box, full),
          {"geometry.width=[\"" + width + "\", \"" + width + "\"]", "fluid.cells_across=5", "species[0].count=413"});
    }
  }
  return {quick, full, laws};
}

}  // namespace slfb::richardson_zaki
