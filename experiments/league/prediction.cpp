#include "experiments/league/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace slfb::league {
namespace {

constexpr double one_sigma = 0.682689, two_sigma = 0.9545;  // shares of a Gaussian within one and two sigmas
constexpr double wall_scale = 0.1;                          // of d/D that counts as one decade of Ar

bool any_voidage(const ExpansionLine& line, double) { return line.motion == BedMotion::fluidised; }

double distance(const Bed& bed, const ExpansionLine& line) {
  const Bed other = bed_of(line);
  return std::hypot(std::log10(bed.archimedes() / other.archimedes()),
                    (bed.diameter_ratio() - other.diameter_ratio()) / wall_scale);
}

Statistic statistic_of_law(const Contender& law, const std::vector<ExpansionLine>& lines, double measured_spread) {
  return statistic_of(compare_lines(law, lines, any_voidage), measured_spread);
}

/// Root mean square of ln(law / measured) over all fluidised lines; empty where the law lacks an answer.
std::optional<double> error_of(const Contender& law, const std::vector<ExpansionLine>& lines) {
  const auto points = std::size(line_voidages) *
                      static_cast<std::size_t>(std::ranges::count(lines, BedMotion::fluidised, &ExpansionLine::motion));
  const auto comparisons = compare_lines(law, lines, any_voidage);
  if (comparisons.size() < points) return std::nullopt;
  return statistic_of(comparisons, 0.0).root_mean_square;
}

/// Voidage with the velocity off by each share of the spread.
Predicted predict(const Contender& law, const Statistic& statistic, const Bed& bed, double velocity, double packed,
                  double tier_error) {
  const auto groups = static_cast<double>(statistic.groups);
  const double spread = statistic.total_spread * std::sqrt(1.0 + 1.0 / groups);
  // The law gives e^mean times the true velocity, so that the bed stands where the law has that much more.
  const auto voidage = [&](double shift) {
    return law.voidage(bed, velocity * std::exp(statistic.mean + shift), packed).voidage;
  };
  Predicted result;
  result.value = voidage(0.0);
  const auto interval = [&](double probability) {
    const double factor = student_factor(probability, statistic.groups - 1);
    const double tier = factor * tier_error * result.value;
    const double below = std::hypot(result.value - voidage(-factor * spread), tier);
    const double above = std::hypot(voidage(factor * spread) - result.value, tier);
    return std::pair{std::max(packed, result.value - below), std::min(1.0, result.value + above)};
  };
  result.one_sigma = interval(one_sigma);
  result.two_sigma = interval(two_sigma);
  return result;
}

void add_points(std::vector<Blind>& list, const Contender& law, const Statistic& statistic, const ExpansionLine& line) {
  for (const double voidage : line_voidages) {
    const Predicted found = predict(law, statistic, bed_of(line), line.velocity(voidage), densest_packed_voidage, 0.0);
    const auto inside = [&](std::pair<double, double> range) {
      return voidage >= range.first && voidage <= range.second;
    };
    list.push_back(
        {line.name, law.name(), voidage, found.value, found.sigma(), inside(found.one_sigma), inside(found.two_sigma)});
  }
}

}  // namespace

std::vector<ExpansionLine> near_lines(const Bed& bed, const std::vector<ExpansionLine>& lines, std::size_t groups) {
  std::map<std::string, double> nearest;
  for (const ExpansionLine& line : lines)
    if (line.motion == BedMotion::fluidised) {
      const double away = distance(bed, line);
      const auto [found, is_new] = nearest.emplace(line.group(), away);
      if (!is_new) found->second = std::min(found->second, away);
    }
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [group, away] : nearest) order.emplace_back(away, group);
  std::ranges::sort(order);
  std::set<std::string> chosen;
  for (const auto& [away, group] : order)
    if (chosen.size() < groups || away <= 1.0) chosen.insert(group);
  std::vector<ExpansionLine> near;
  std::ranges::copy_if(lines, std::back_inserter(near), [&](const ExpansionLine& line) {
    return line.motion == BedMotion::fluidised && chosen.contains(line.group());
  });
  std::ranges::stable_sort(near, {}, [&](const ExpansionLine& line) { return distance(bed, line); });
  return near;
}

double voidage_by_line(const ExpansionLine& line, const Bed& bed, double superficial_velocity) {
  const double intercept = line.intercept * terminal_velocity(bed) / terminal_velocity(bed_of(line));
  return std::pow(superficial_velocity / intercept, 1.0 / line.exponent);
}

std::vector<Evidence> evidence_for(const Bed& bed, const std::vector<Contender>& laws,
                                   const std::vector<ExpansionLine>& lines) {
  const auto near = near_lines(bed, lines);
  const double spread = line_spread(lines, BedMotion::fluidised);
  const std::size_t points = near.size() * std::size(line_voidages);
  std::vector<Evidence> list;
  for (const Contender& law : laws) {
    const auto comparisons = compare_lines(law, near, any_voidage);
    if (comparisons.size() < points) continue;
    Evidence evidence{&law, statistic_of(comparisons, spread), 0.0, {}};
    for (const Comparison& one : comparisons)
      evidence.largest = std::max(evidence.largest, std::abs(std::exp(one.log_ratio) - 1.0));
    for (const ExpansionLine& line : near) evidence.beds.push_back(line.name);
    list.push_back(std::move(evidence));
  }
  std::ranges::stable_sort(list, {}, [](const Evidence& one) { return one.statistic.root_mean_square; });
  return list;
}

Predicted predict_voidage(const Contender& law, const Bed& bed, double superficial_velocity, double packed_voidage,
                          const std::vector<ExpansionLine>& lines, double tier_error) {
  return predict(law, statistic_of_law(law, lines, line_spread(lines, BedMotion::fluidised)), bed, superficial_velocity,
                 packed_voidage, tier_error);
}

const Contender& recommended(const std::vector<Contender>& laws, const std::vector<ExpansionLine>& lines) {
  const Contender* best = nullptr;
  double smallest = 0.0;
  for (const Contender& law : laws) {
    const auto error = error_of(law, lines);
    if (error && (best == nullptr || *error < smallest)) {
      best = &law;
      smallest = *error;
    }
  }
  if (best == nullptr) throw std::invalid_argument("no law has an answer for every measured bed");
  return *best;
}

std::vector<Blind> leave_one_group_out(const std::vector<Contender>& laws, const std::vector<ExpansionLine>& lines) {
  std::vector<Blind> list;
  std::set<std::string> done;
  for (const ExpansionLine& left_out : lines) {
    if (left_out.motion != BedMotion::fluidised || !done.insert(left_out.group()).second) continue;
    std::vector<ExpansionLine> others;
    std::ranges::copy_if(lines, std::back_inserter(others), [&](const ExpansionLine& line) {
      return line.motion == BedMotion::fluidised && line.group() != left_out.group();
    });
    const Contender& law = recommended(laws, others);
    const Statistic statistic = statistic_of_law(law, others, 0.0);
    for (const ExpansionLine& line : lines)
      if (line.motion == BedMotion::fluidised && line.group() == left_out.group())
        add_points(list, law, statistic, line);
  }
  return list;
}

Calibration calibration_of(const std::vector<Blind>& blind) {
  if (blind.empty()) throw std::invalid_argument("calibration_of: no predictions");
  const auto points = static_cast<double>(blind.size());
  Calibration found;
  found.points = blind.size();
  double squares = 0.0;
  for (const Blind& one : blind) {
    found.in_one_sigma += one.in_one_sigma ? 1.0 / points : 0.0;
    found.in_two_sigma += one.in_two_sigma ? 1.0 / points : 0.0;
    squares += one.error() * one.error();
    found.worst = std::max(found.worst, std::abs(one.error()));
  }
  found.root_mean_square = std::sqrt(squares / points);
  return found;
}

std::vector<FormulaChoice> formula_choices(const std::vector<ExpansionLine>& lines, std::size_t shown) {
  const std::vector<Contender> formulas = formula_contenders();
  std::vector<std::pair<double, const Contender*>> order;
  for (const Contender& formula : formulas)
    if (const auto error = error_of(formula, lines)) order.emplace_back(*error, &formula);
  std::ranges::stable_sort(order, {}, [](const auto& one) { return one.first; });
  std::vector<FormulaChoice> choices;
  for (std::size_t i = 0; i < std::min(shown, order.size()); ++i)
    choices.push_back({order[i].second->name(), calibration_of(leave_one_group_out({*order[i].second}, lines))});
  choices.push_back({"", calibration_of(leave_one_group_out(formulas, lines))});
  return choices;
}

std::vector<Blind> predict_settling(const std::vector<Contender>& laws, const std::vector<ExpansionLine>& lines) {
  const Contender& law = recommended(laws, lines);
  const Statistic statistic = statistic_of_law(law, lines, 0.0);
  std::vector<Blind> list;
  for (const ExpansionLine& line : lines)
    if (line.motion == BedMotion::settling) add_points(list, law, statistic, line);
  return list;
}

Predicted predict_minimum_fluidisation(const drag::DragLawKernels& law, const Bed& bed,
                                       const std::vector<PackedBedPoint>& points, double packed_voidage) {
  const Statistic statistic = statistic_of(compare_packed(law, points), 0.0);
  const auto velocity = [&](double voidage, double drag_factor) {
    // More drag on the same bed is a lighter sphere by the same factor.
    const double lighter = bed.liquid.density + (bed.sphere.density - bed.liquid.density) / drag_factor;
    return fluidisation::minimum_fluidisation_velocity(law, Sphere{bed.sphere.diameter, lighter}, bed.liquid, voidage);
  };
  // Where the law has too much drag in the mean, the bed has less.
  const double mean = std::exp(-statistic.mean);
  Predicted result;
  result.value = velocity(packed_voidage, mean);
  const auto interval = [&](double probability) {
    const double factor = student_factor(probability, statistic.groups - 1);
    const double gaussian = student_factor(probability, 10000);
    const double by_drag = velocity(packed_voidage, mean * std::exp(-factor * statistic.total_spread)) - result.value;
    const double by_voidage = velocity(packed_voidage + gaussian * packed_voidage_sigma, mean) - result.value;
    const double half = std::hypot(by_drag, by_voidage);
    return std::pair{std::max(0.0, result.value - half), result.value + half};
  };
  result.one_sigma = interval(one_sigma);
  result.two_sigma = interval(two_sigma);
  return result;
}

}  // namespace slfb::league
