#include "experiments/numerics/plan/figure_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "experiments/runs/run_estimate.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::plan {
namespace {

double per_simulated_second(const Scene& scene) {
  const RunEstimate estimate = estimate_run(scene);
  return estimate.core_seconds / estimate.simulated_seconds;
}

double steps_per_contact(const Scene& scene) {
  return std::numbers::pi * contact_time_step_bound(scene) / scene.contact.time_step;
}

std::string tier_text(FluidTier tier) {
  switch (tier) {
    case FluidTier::quiescent:
      return "still liquid";
    case FluidTier::one_dimensional:
      return "1-D liquid";
    case FluidTier::three_dimensional:
      return "3-D liquid";
  }
  return "";
}

std::string steps_text(const Scene& scene) {
  return fmt::format("{:.0e} N/m, {:.2g}/{:.2g} ms", scene.contact.stiffness, 1e3 * scene.contact.time_step,
                     1e3 * scene.fluid.time_step);
}

/// In which of tier, stiffness and steps a scene is coarser or richer than the planned one. Steps may differ by an
/// eighth: they are rounded to divisors of each other.
std::string compared(const Scene& scene, const Scene& planned) {
  std::vector<std::string> coarser, richer;
  const auto compare = [&](const char* what, double own, double wanted, double tolerance) {
    if (own < wanted * (1.0 - tolerance)) coarser.emplace_back(what);
    if (own > wanted * (1.0 + tolerance)) richer.emplace_back(what);
  };
  compare("tier", static_cast<int>(scene.fluid.tier), static_cast<int>(planned.fluid.tier), 0.0);
  if (planned.fluid.tier == FluidTier::three_dimensional && scene.fluid.tier == planned.fluid.tier)
    compare("cells", 1.0 / scene.fluid.cell_height, 1.0 / planned.fluid.cell_height, 0.02);
  compare("stiffness", scene.contact.stiffness, planned.contact.stiffness, 1e-9);
  compare("solid step", steps_per_contact(scene), steps_per_contact(planned), 0.125);
  compare("liquid step", 1.0 / scene.fluid.time_step, 1.0 / planned.fluid.time_step, 0.125);
  std::string text;
  if (!coarser.empty()) text = fmt::format("coarser: {}", fmt::join(coarser, ", "));
  if (!richer.empty()) text += fmt::format("{}richer: {}", text.empty() ? "" : "; ", fmt::join(richer, ", "));
  return text.empty() ? "as planned" : text;
}

}  // namespace

std::vector<FigureQuestion> load_questions(const std::filesystem::path& file) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  std::vector<FigureQuestion> questions;
  for (TomlTable& one : table.tables("figure")) {
    questions.push_back({one.text("id"), one.texts("asked"), one.texts("scene"), one.text("run"), one.flag("fields")});
    one.reject_others();
  }
  table.reject_others();
  return questions;
}

FigurePlan plan_figure(const FigureQuestion& question, const Scene& scene, const Scene& published,
                       const Scene& simulated, const std::string& profile, const Rules& rules) {
  FigurePlan entry;
  entry.figure = question.figure;
  entry.asked = question.asked;
  const Plan made = make_plan(scene, question.asked, rules, Forces::of_the_scene);
  for (const std::string& quantity : question.asked) {
    const auto effect = made.effect.find(quantity);
    const double share = effect == made.effect.end() ? 0.0 : effect->second / made.band.at(quantity);
    if (entry.worst.empty() || share > entry.error_over_band) {
      entry.error_over_band = share;
      entry.worst = quantity;
    }
  }
  Scene planned = changed(scene, made.overrides);
  if (question.fields) planned.fluid.tier = FluidTier::three_dimensional;
  entry.by_formula = made.by_formula && !question.fields;
  entry.tier = entry.by_formula ? "root of the law" : tier_text(planned.fluid.tier);
  entry.steps = entry.by_formula ? "" : steps_text(planned);
  entry.core_seconds = entry.by_formula ? 0.0 : per_simulated_second(planned);
  entry.published_core_seconds = per_simulated_second(published);
  entry.profile = profile;
  entry.profile_core_seconds = per_simulated_second(simulated);
  entry.agreement = entry.by_formula ? "richer: simulated" : compared(simulated, planned);
  return entry;
}

std::string figure_plans_text(const std::vector<FigurePlan>& plans) {
  std::string text = fmt::format(
      "{:<17}{:<17}{:<26}{:>10}{:>10}{:>10}{:>10}  {}\n{:<17}{:<17}{:<26}{:>10}{:>10}{:>10}{:>10}  {}\n", "",
      "cheapest model", "springs, steps", "error", "planned", "published", "profile", "the profile", "figure",
      "that answers", "of solids/liquid", "of band", "CPU s/s", "CPU s/s", "CPU s/s", "beside the plan");
  for (const FigurePlan& plan : plans)
    text += fmt::format("{:<17}{:<17}{:<26}{:>10}{:>10}{:>10.3g}{:>10.3g}  {}: {}\n{:<17}  asked: {}\n", plan.figure,
                        plan.tier, plan.steps, fmt::format("{:.0f} %", 100.0 * plan.error_over_band),
                        plan.by_formula ? "ms" : fmt::format("{:.3g}", plan.core_seconds), plan.published_core_seconds,
                        plan.profile_core_seconds, plan.profile, plan.agreement, "", fmt::join(plan.asked, ", "));
  return text;
}

}  // namespace slfb::plan
