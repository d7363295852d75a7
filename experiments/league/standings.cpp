#include "experiments/league/standings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/single_sphere/single_sphere_laws.hpp"
#include "correlations/fluidisation/expansion_exponent/richardson_zaki_1954.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"

namespace slfb::league {
namespace {

constexpr double slow_below = 1.0, fast_above = 500.0;  // of the terminal Reynolds number
constexpr double dense_up_to = 0.65;                    // of the voidage
constexpr double narrow_from = 0.04;  // of d/D: the range that Richardson & Zaki (1954) state for their laws

bool fluidised(const ExpansionLine& line) { return line.motion == BedMotion::fluidised; }

double reynolds_of(const ExpansionLine& line) { return terminal_reynolds(bed_of(line)); }

Standing stand(const Contender& contender, const std::vector<ExpansionLine>& lines, const Regime& regime,
               double measured_spread) {
  const auto comparisons = compare_lines(contender, lines, regime.has);
  Standing standing{contender.name(), {}, 0, 0.0, 0.0, 0.0};
  std::size_t points = 0;
  double sum = 0.0, squares = 0.0;
  for (const ExpansionLine& line : lines) {
    const Bed bed = bed_of(line);
    for (const double voidage : line_voidages) {
      if (!regime.has(line, voidage)) continue;
      ++points;
      const double error = contender.voidage(bed, line.velocity(voidage), densest_packed_voidage).voidage - voidage;
      sum += error;
      squares += error * error;
      standing.worst_voidage_error = std::max(standing.worst_voidage_error, std::abs(error));
    }
  }
  standing.without_answer = points - comparisons.size();
  if (!comparisons.empty()) standing.statistic = statistic_of(comparisons, measured_spread);
  standing.mean_voidage_error = sum / static_cast<double>(points);
  standing.root_mean_square_voidage_error = std::sqrt(squares / static_cast<double>(points));
  return standing;
}

void sort(std::vector<Standing>& standings) {
  std::ranges::stable_sort(standings, [](const Standing& a, const Standing& b) {
    if ((a.without_answer > 0) != (b.without_answer > 0)) return a.without_answer == 0;
    return a.statistic.root_mean_square < b.statistic.root_mean_square;
  });
}

/// Suspensions that settle, extrapolated to one sphere, against the laws for one sphere.
Table single_spheres(const std::vector<ExpansionLine>& lines, double measured_spread) {
  Table table{{"one-sphere", "one sphere: the lines of suspensions that settle, extrapolated to voidage 1",
               "one sphere", BedMotion::settling, [](const ExpansionLine& line, double) { return !fluidised(line); }},
              {}};
  for_each_law<drag::single_sphere::SingleSphereLaws>([&](const auto& law) {
    std::vector<Comparison> comparisons;
    for (const ExpansionLine& line : lines)
      if (!fluidised(line))
        comparisons.push_back(
            {line.group(), std::log(fluidisation::terminal_velocity(law, line.sphere, line.liquid) / line.intercept)});
    if (!comparisons.empty())
      table.standings.push_back(
          {std::string(law.info.name), statistic_of(comparisons, measured_spread), 0, 0.0, 0.0, 0.0});
  });
  sort(table.standings);
  return table;
}

template <class Use>
void for_each_drag_law(const std::vector<drag::DragLawKernels>& user, Use use) {
  for_each_law<drag::DragLaws>([&]<class Law>(const Law&) { use(drag::kernels_of<Law>()); });
  for (const drag::DragLawKernels& law : user) use(law);
}

Table packed_beds(const std::vector<drag::DragLawKernels>& user, const std::vector<PackedBedPoint>& points) {
  Table table{{"packed", "packed beds, Re/(1 − ε) from 0.5 to 3000", "packed bed", BedMotion::fluidised,
               [](const ExpansionLine&, double) { return false; }},
              {}};
  if (points.empty()) return table;
  const double spread = packed_spread(points);
  for_each_drag_law(user, [&](const drag::DragLawKernels& law) {
    const auto comparisons = compare_packed(law, points);
    Standing standing{std::string(law.info.name), {}, points.size() - comparisons.size(), 0.0, 0.0, 0.0};
    if (!comparisons.empty()) standing.statistic = statistic_of(comparisons, spread);
    table.standings.push_back(std::move(standing));
  });
  sort(table.standings);
  return table;
}

}  // namespace

const Measured& measured() {
  static const Measured all = [] {
    Measured found;
    for (const auto& folder : reference_data_folders()) {
      for (ExpansionLine& line : expansion_lines(folder))
        if (line.sphere.density > line.liquid.density) found.lines.push_back(std::move(line));
      std::ranges::copy(packed_bed_points(folder), std::back_inserter(found.packed));
    }
    return found;
  }();
  return all;
}

double line_spread(const std::vector<ExpansionLine>& lines, BedMotion motion) {
  const auto all = contenders();
  const Contender& tube = find_contender(all, std::string(fluidisation::RichardsonZaki1954::info.name) + " + wall");
  std::map<std::string, std::vector<const ExpansionLine*>> groups;
  for (const ExpansionLine& line : lines)
    if (line.motion == motion) groups[line.group()].push_back(&line);
  double squares = 0.0, degrees = 0.0;
  for (const auto& [name, group] : groups) {
    if (group.size() < 2) continue;
    const auto count = static_cast<double>(group.size());
    for (const double voidage : line_voidages) {
      double sum = 0.0, square = 0.0;
      for (const ExpansionLine* line : group) {
        const double rest = std::log(line->velocity(voidage) / tube.velocity(bed_of(*line), voidage));
        sum += rest;
        square += rest * rest;
      }
      squares += square - sum * sum / count;
      degrees += count - 1.0;
    }
  }
  // The rounding of U_i, evenly distributed over twice the half digit, is the least of it.
  const double rounding = std::log(10.0) * line_rounding / std::sqrt(3.0);
  return degrees > 0.0 ? std::max(rounding, std::sqrt(squares / degrees)) : rounding;
}

double packed_spread(const std::vector<PackedBedPoint>& points) {
  std::map<std::string, std::vector<std::pair<double, double>>> series;
  for (const PackedBedPoint& point : points)
    series[point.series].emplace_back(std::log(point.reynolds_over_solids), std::log(point.viscous_friction));
  double squares = 0.0, count = 0.0;
  for (auto& [name, one] : series) {
    std::ranges::sort(one);
    // Against the straight line between the neighbours on both sides, whose variance is 3/2 of a point's in the mean.
    for (std::size_t i = 1; i + 1 < one.size(); ++i) {
      const double width = one[i + 1].first - one[i - 1].first;
      const double share = width > 0.0 ? (one[i].first - one[i - 1].first) / width : 0.5;
      const double rest = one[i].second - (1.0 - share) * one[i - 1].second - share * one[i + 1].second;
      squares += rest * rest / (1.0 + share * share + (1.0 - share) * (1.0 - share));
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

const std::vector<Regime>& regimes() {
  static const std::vector<Regime> list{
      {"fluidised", "fluidised beds", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double) { return fluidised(line); }},
      {"fluidised-slow", "fluidised beds, terminal Re from 1 to 500", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double) {
         return fluidised(line) && reynolds_of(line) >= slow_below && reynolds_of(line) <= fast_above;
       }},
      {"fluidised-fast", "fluidised beds, terminal Re above 500", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double) { return fluidised(line) && reynolds_of(line) > fast_above; }},
      {"fluidised-dense", "fluidised beds, voidage 0.5 and 0.6", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double voidage) { return fluidised(line) && voidage <= dense_up_to; }},
      {"fluidised-dilute", "fluidised beds, voidage 0.7 to 0.9", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double voidage) { return fluidised(line) && voidage > dense_up_to; }},
      {"fluidised-wide", "fluidised beds in tubes of more than 25 diameters", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double) { return fluidised(line) && line.diameter_ratio() < narrow_from; }},
      {"fluidised-narrow", "fluidised beds in tubes of less than 25 diameters", "bed", BedMotion::fluidised,
       [](const ExpansionLine& line, double) { return fluidised(line) && line.diameter_ratio() >= narrow_from; }},
      {"settling-creeping", "suspensions that settle, terminal Re below 1", "bed", BedMotion::settling,
       [](const ExpansionLine& line, double) { return !fluidised(line) && reynolds_of(line) < slow_below; }},
      {"settling-slow", "suspensions that settle, terminal Re from 1 to 500", "bed", BedMotion::settling,
       [](const ExpansionLine& line, double) { return !fluidised(line) && reynolds_of(line) >= slow_below; }},
  };
  return list;
}

std::vector<Comparison> compare_lines(const Contender& contender, const std::vector<ExpansionLine>& lines,
                                      const std::function<bool(const ExpansionLine&, double voidage)>& has) {
  std::vector<Comparison> comparisons;
  for (const ExpansionLine& line : lines) {
    const Bed bed = bed_of(line);
    for (const double voidage : line_voidages) {
      if (!has(line, voidage)) continue;
      const double velocity = contender.velocity(bed, voidage);
      if (velocity > 0.0) comparisons.push_back({line.group(), std::log(velocity / line.velocity(voidage))});
    }
  }
  return comparisons;
}

std::vector<Comparison> compare_packed(const drag::DragLawKernels& law, const std::vector<PackedBedPoint>& points) {
  std::vector<Comparison> comparisons;
  constexpr double voidage = packed_voidage_mean, solids = 1.0 - voidage;
  for (const PackedBedPoint& point : points) {
    // ε Δp/L = β U/ε with β = 18 μ ε (1 − ε) F/d² makes Δp d² ε³/(L μ U (1 − ε)²) = 18 F ε²/(1 − ε).
    const double friction = 18.0 * law({voidage, point.reynolds_over_solids * solids}) * voidage * voidage / solids;
    if (friction > 0.0) comparisons.push_back({point.series, std::log(friction / point.viscous_friction)});
  }
  return comparisons;
}

std::vector<Table> league_tables(const std::vector<drag::DragLawKernels>& user) {
  const Measured& all = measured();
  std::vector<Contender> laws = contenders();
  for (const drag::DragLawKernels& law : user)
    for (Contender& contender : contenders_of(law)) laws.push_back(std::move(contender));
  const double of_beds = line_spread(all.lines, BedMotion::fluidised);
  const double of_suspensions = line_spread(all.lines, BedMotion::settling);
  std::vector<Table> tables;
  for (const Regime& regime : regimes()) {
    Table table{regime, {}};
    const bool of_bed = regime.motion == BedMotion::fluidised;
    for (const Contender& contender : laws)
      if (of_bed || !contender.with_wall())
        table.standings.push_back(stand(contender, all.lines, regime, of_bed ? of_beds : of_suspensions));
    sort(table.standings);
    tables.push_back(std::move(table));
  }
  tables.push_back(packed_beds(user, all.packed));
  tables.push_back(single_spheres(all.lines, of_suspensions));
  return tables;
}

}  // namespace slfb::league
