#include "experiments/peng_2014/planned_figures/figure_plans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/support/folders.hpp"

namespace slfb {

std::vector<plan::FigurePlan> figure_plans() {
  const auto folder = source_folder() / "experiments" / "peng_2014";
  const auto file = folder / "planned_figures" / "figures.toml";
  const plan::Rules rules = plan::load_rules();
  std::vector<plan::FigurePlan> plans;
  for (const plan::FigureQuestion& question : plan::load_questions(file)) {
    const Scene scene = load_scene(folder / "scenes" / "6in5W.toml", question.scene);
    auto published = question.scene;
    published.emplace_back("contact.allow_large_time_step=true");
    const Scene as_published = load_scene(folder / "scenes" / "6in5W_paper-literal.toml", published);
    const std::size_t before = plans.size();
    for (const char* name : {"quick", "full"}) {
      const Profile profile = load_profile(name);
      const auto spec =
          std::ranges::find_if(profile.runs, [&](const RunSpec& run) { return run_key(run) == question.run; });
      if (spec == profile.runs.end()) continue;
      const Scene simulated = load_scene(spec->scene, spec->overrides);
      plans.push_back(plan::plan_figure(question, scene, as_published, simulated, name, rules));
      break;
    }
    if (plans.size() == before)
      throw std::runtime_error(fmt::format("{}: no profile has the run {}", file.string(), question.run));
  }
  return plans;
}

}  // namespace slfb
