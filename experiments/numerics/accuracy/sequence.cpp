#include "experiments/numerics/accuracy/sequence.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/runs/run_estimate.hpp"

namespace slfb::accuracy {
namespace {

constexpr int most_looks = 8;      ///< by then there are 384 beds
constexpr int longest_double = 3;  ///< times that a bed is given twice the time to become steady
constexpr int most_refined = 2;    ///< richer scenes that take the place of the planned one

/// Of Student's t with `samples` − 1 degrees of freedom at the level of a look.
double quantile(std::size_t samples, double level) {
  const double freedom = static_cast<double>(std::max<std::size_t>(2, samples)) - 1.0;
  return gsl_cdf_tdist_Qinv(0.5 * level, freedom);
}

/// Half width at the level of a look, from that of 95 %.
double at_look(const Answer& answer, int look) {
  return answer.half_width * quantile(answer.samples, level_of_look(look)) / quantile(answer.samples, 0.05);
}

double relative(double half_width, double value) { return half_width == 0.0 ? 0.0 : std::abs(half_width / value); }

int drops_of(const Scene& scene) {
  int drops = 0;
  for (const Stage& stage : scene.stages)
    if (stage.kind == StageKind::drop) drops += stage.repetitions;
  return drops;
}

class Sequence {
 public:
  Sequence(const Expectation& expected, const World& world, double budget)
      : goal_(expected.goal), expected_(expected), world_(world), budget_(budget) {
    outcome_.scene = expected.scene;
    checks_ = expected.check;
  }

  Outcome run() {
    int beds = fewest_beds;
    for (int look = 1;; ++look) {
      outcome_.looks = look;
      if (!look_at(beds, look)) return outcome_;
      if (const auto longer = twice_the_time()) {
        tell(fmt::format("the bed still changes: once more, over {:g} s", *longer));
        continue;
      }
      if (checks_ && !check(beds, look)) return outcome_;
      if (replaced_) {
        replaced_ = false;
        beds = fewest_beds;
        continue;
      }
      judge();
      if (outcome_.reached) return outcome_;
      const int more = beds_needed(beds, look);
      if (more == beds) return outcome_;
      if (look == most_looks) {
        outcome_.reason = "after as many looks as are taken, the interval is still wider than what the goal leaves";
        return outcome_;
      }
      beds = more;
    }
  }

 private:
  void tell(const std::string& text) const {
    if (world_.tell) world_.tell(text);
  }

  /// Simulates the beds that are new. False when the loop ends here.
  bool simulate(const std::vector<Scene>& scenes, std::size_t known, const std::string& what) {
    if (known >= scenes.size()) return true;
    const std::vector<Scene> fresh(scenes.begin() + static_cast<std::ptrdiff_t>(known), scenes.end());
    const double cost = static_cast<double>(fresh.size()) * estimate_run(fresh.front()).core_seconds;
    if (outcome_.core_seconds + cost > budget_) {
      outcome_.reason =
          fmt::format("{} would take about {} of CPU more, beyond the budget", what, format_duration(cost));
      return false;
    }
    tell(fmt::format("{}: {} bed{}, about {} of CPU", what, fresh.size(), fresh.size() == 1 ? "" : "s",
                     format_duration(cost)));
    const auto spent = world_.simulate(fresh);
    if (!spent) {
      outcome_.unfinished = true;
      return false;
    }
    outcome_.core_seconds += *spent;
    return true;
  }

  bool look_at(int beds, int look) {
    const std::size_t known = outcome_.beds.size();
    std::vector<Scene> scenes;
    for (int k = 0; k < beds; ++k) scenes.push_back(bed_of(outcome_.scene, k));
    if (!simulate(scenes, known, fmt::format("look {}", look))) return false;
    outcome_.beds = std::move(scenes);
    outcome_.answers = world_.measure(outcome_.beds);
    for (const std::string& quantity : goal_.asked) {
      const auto found = outcome_.answers.find(quantity);
      if (found != outcome_.answers.end() && std::isfinite(found->second.value)) continue;
      outcome_.reason = fmt::format("the runs have no {}{}", quantity,
                                    found == outcome_.answers.end() || found->second.remark.empty()
                                        ? std::string(": the sphere does not pass the window, or is not followed to it")
                                        : ": " + found->second.remark);
      return false;
    }
    parts_of_choices();
    for (const std::string& quantity : goal_.asked) {
      Answer& answer = outcome_.answers.at(quantity);
      const int samples = of_drops(quantity) ? beds * drops_of(outcome_.scene) : beds;
      outcome_.scatter[quantity] =
          relative(answer.half_width / quantile(answer.samples, 0.05) * std::sqrt(samples), answer.value);
      answer.half_width = at_look(answer, look);
      outcome_.parts.at(quantity).statistics = relative(answer.half_width, answer.value);
    }
    return true;
  }

  /// What models, grid and steps leave, without what the check is there to measure.
  void parts_of_choices() {
    for (const std::string& quantity : goal_.asked) outcome_.parts[quantity] = expected_.parts.at(quantity);
  }

  /// A quarter of the goal is what a change at the end may make; less than its interval is no change.
  std::optional<double> twice_the_time() {
    const auto drift = outcome_.answers.find("voidage_drift"), voidage = outcome_.answers.find("voidage");
    if (drift == outcome_.answers.end() || voidage == outcome_.answers.end() || doubled_ == longest_double) return {};
    const double change = std::abs(drift->second.value);
    if (change <= 0.25 * goal_.error * voidage->second.value) return {};
    if (!(change > drift->second.half_width)) return {};
    Stage* last = nullptr;
    for (Stage& stage : outcome_.scene.stages)
      if (stage.kind == StageKind::fluidise) last = &stage;
    if (last == nullptr) return {};
    last->duration *= 2.0;
    if (checks_)
      for (std::size_t k = 0; k < checks_->stages.size(); ++k) checks_->stages[k] = outcome_.scene.stages[k];
    outcome_.beds.clear();
    outcome_.richer.clear();
    ++doubled_;
    return last->duration;
  }

  /// Runs the richer scene in as many beds, at most as many as the first look has times the looks, and compares.
  bool check(int beds, int look) {
    const std::size_t known = outcome_.richer.size();
    std::vector<Scene> scenes;
    for (int k = 0; k < beds; ++k) scenes.push_back(bed_of(*checks_, k));
    // More beds only where the comparison is what is not sure enough.
    if (known > 0 && !unsure_) scenes.resize(known);
    if (!simulate(scenes, known, "check by a richer scene")) return false;
    outcome_.richer = std::move(scenes);
    const Answers other = world_.measure(outcome_.richer);
    unsure_ = false;
    bool too_far = false;
    for (const std::string& quantity : goal_.asked) {
      const auto found = other.find(quantity);
      const Answer& ours = outcome_.answers.at(quantity);
      if (found == other.end() || !std::isfinite(found->second.value)) continue;
      const double truth = found->second.value;
      const Deviation deviation{ours.value / truth - 1.0,
                                std::hypot(ours.half_width, at_look(found->second, look)) / std::abs(truth)};
      outcome_.check[quantity] = deviation;
      Parts& parts = outcome_.parts.at(quantity);
      set_checked_part(quantity, deviation, parts);
      if (parts.total() <= goal_.error) continue;
      const double size = std::abs(deviation.value);
      const bool sure = size > deviation.uncertainty;
      if (parts.systematic() < goal_.error)
        unsure_ = unsure_ || error_of_check(quantity, deviation) > size;  // more beds would say less of an error
      else
        (sure ? too_far : unsure_) = true;
    }
    if (too_far && refined_ < most_refined) take_richer();
    return true;
  }

  /// Errors of one quantity by choices that were checked, or by the others.
  [[nodiscard]] Parts errors_of(const std::string& quantity, bool of_check) const {
    Parts parts;
    for (const plan::Decision& decision : expected_.plan.decisions) {
      const auto found = decision.effect.find(quantity);
      if (found == decision.effect.end()) continue;
      if ((std::ranges::find(expected_.checked, decision.subject) != expected_.checked.end()) != of_check) continue;
      double& part = decision.part == plan::Part::model ? parts.model : parts.discretisation;
      part = std::hypot(part, found->second);
    }
    return parts;
  }

  /// A scene that was compared with a refined one has no estimate behind it but that comparison.
  [[nodiscard]] double error_of_check(const std::string& quantity, const Deviation& deviation) const {
    return error_by(deviation, refined_ > 0 ? 0.0 : errors_of(quantity, true).systematic());
  }

  /// The error of what was checked beside the errors of what was not: as one of models where these were expected to
  /// make most of it.
  void set_checked_part(const std::string& quantity, const Deviation& deviation, Parts& parts) const {
    const Parts checked = errors_of(quantity, true), others = errors_of(quantity, false);
    const double error = error_of_check(quantity, deviation);
    const bool of_model = refined_ == 0 && checked.model > checked.discretisation;
    parts.model = std::hypot(others.model, of_model ? error : 0.0);
    parts.discretisation = std::hypot(others.discretisation, of_model ? 0.0 : error);
  }

  void take_richer() {
    tell("the check finds more than the goal leaves: the richer scene takes the place of the planned one");
    outcome_.scene = *checks_;
    outcome_.beds = std::move(outcome_.richer);
    outcome_.richer.clear();
    checks_ = refined(outcome_.scene);
    ++refined_;
    replaced_ = true;
  }

  void judge() {
    outcome_.reached = std::ranges::all_of(
        goal_.asked, [&](const std::string& quantity) { return outcome_.parts.at(quantity).total() <= goal_.error; });
  }

  /// Beds of the next look; as many as there are when no number of beds would do.
  int beds_needed(int beds, int look) {
    double factor = 1.0;
    for (const std::string& quantity : goal_.asked) {
      const Parts& parts = outcome_.parts.at(quantity);
      if (parts.total() <= goal_.error) continue;
      const double left = goal_.error - parts.systematic();
      if (left <= 0.0 && !unsure_) {
        outcome_.reason = fmt::format("models, grid and steps make {:.2g} % of {}: no number of beds takes that away",
                                      100.0 * parts.systematic(), quantity);
        return beds;
      }
      factor = std::max(factor, left > 0.0 ? std::pow(parts.statistics / left, 2) : 2.0);
    }
    // The next look has wider intervals.
    factor *= std::pow(quantile(100, level_of_look(look + 1)) / quantile(100, level_of_look(look)), 2);
    // A handful more would hardly narrow an interval, and each look widens the next.
    constexpr double least_growth = 1.3;
    return std::clamp(static_cast<int>(std::ceil(beds * std::max(factor, least_growth))), beds + 1, 2 * beds);
  }

  const Goal& goal_;
  const Expectation& expected_;
  const World& world_;
  double budget_;
  Outcome outcome_;
  std::optional<Scene> checks_;
  int doubled_ = 0, refined_ = 0;
  bool unsure_ = false, replaced_ = false;
};

}  // namespace

double level_of_look(int look) { return 0.05 * 6.0 / std::pow(std::numbers::pi * look, 2); }

double half_width_of(double deviation, int samples, int look) {
  if (samples < 2) return std::numeric_limits<double>::infinity();
  return deviation * quantile(static_cast<std::size_t>(samples), level_of_look(look)) / std::sqrt(samples);
}

int samples_for(double deviation, double half_width) {
  constexpr int most = 10'000;
  int lowest = 2, highest = most;
  while (lowest < highest) {  // the half width falls with the number
    const int middle = (lowest + highest) / 2;
    (half_width_of(deviation, middle, 1) <= half_width ? highest : lowest) =
        half_width_of(deviation, middle, 1) <= half_width ? middle : middle + 1;
  }
  return lowest;
}

double error_by(const Deviation& deviation, double estimated) {
  const double size = std::abs(deviation.value);
  return std::min(size + deviation.uncertainty, std::max(estimated, size));
}

Outcome run_until(const Expectation& expected, const World& world, double budget) {
  return Sequence(expected, world, budget).run();
}

}  // namespace slfb::accuracy
