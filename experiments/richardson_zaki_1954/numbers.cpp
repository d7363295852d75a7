#include "experiments/richardson_zaki_1954/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "correlations/fluidisation/expansion_exponent/richardson_zaki_1954.hpp"
#include "experiments/league/standings.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"

namespace slfb::richardson_zaki {
namespace {

// Of a bed that a law does not lift at a measured velocity [-].
constexpr double not_lifted_voidage = league::densest_packed_voidage;
constexpr const char* tables = "Tables III and IV";

std::string voidage_text(double voidage) { return fmt::format("{:.2f}", voidage); }

/// Pairs of lines of the same spheres in the same liquid.
template <class Use>
void for_each_pair(Use use) {
  for (std::size_t i = 0; i < beds().size(); ++i)
    for (std::size_t k = i + 1; k < beds().size(); ++k)
      if (beds()[i].group() == beds()[k].group()) use(beds()[i], beds()[k]);
}

/// Slope of ln U over ln ε through points, and its 95 % half-width.
struct Slope {
  double value, half_width;
};
std::optional<Slope> slope_of(const std::vector<std::pair<double, double>>& points) {
  const auto count = static_cast<double>(points.size());
  if (points.size() < 3) return std::nullopt;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (const auto& [voidage, velocity] : points) {
    const double log_voidage = std::log(voidage), log_velocity = std::log(velocity);
    x += log_voidage / count;
    y += log_velocity / count;
    xx += log_voidage * log_voidage;
    xy += log_voidage * log_velocity;
    yy += log_velocity * log_velocity;
  }
  xx -= count * x * x;
  xy -= count * x * y;
  yy -= count * y * y;
  if (!(xx > 0.0)) return std::nullopt;
  const double slope = xy / xx, rest = std::max(0.0, yy - slope * xy) / (count - 2.0);
  return Slope{slope, league::student_factor(0.95, points.size() - 2) * std::sqrt(rest / xx)};
}

std::optional<Measurement> exponent_of_runs(const Measurements& measured, const std::string& system,
                                            const MeasuringRules&) {
  std::vector<std::pair<double, double>> points;
  for (const auto& [velocity, voidage] : over_numbers(measured, "voidage_centre_of_mass", system))
    points.emplace_back(voidage.value, velocity);
  const auto slope = slope_of(points);
  if (!slope) return std::nullopt;
  return Measurement{slope->value, slope->half_width, points.size(), "-", "runs"};
}

Claim claim(const std::string& id, const std::string& figure, const std::string& quantity,
            const std::string& printed_id, MeasureKey measure, double half_band, const std::string& reason) {
  const ReferenceValue& value = printed().at(printed_id);
  Claim made;
  made.id = id;
  made.figure = figure;
  made.quantity = quantity;
  made.unit = value.unit;
  made.source = value.source;
  made.paper = value.value;
  made.paper_band = Band{value.value - half_band, value.value + half_band};
  made.band_reason = reason;
  made.measures = {std::move(measure)};
  for (const ExpansionLine& line : beds()) made.systems.insert(line.name);
  return made;
}

}  // namespace

std::string authors_formula() { return std::string(fluidisation::RichardsonZaki1954::info.name) + " + wall"; }

const ReferenceNumbers& printed() {
  static const ReferenceNumbers numbers = [] {
    ReferenceNumbers list("Richardson & Zaki (1954)");
    for (const ExpansionLine& line : beds()) {
      list.add({line.name + "/exponent", "exponent n of the line", line.exponent, "-", line_rounding, tables},
               line.name);
      list.add({line.name + "/intercept", "velocity at which the line meets voidage 1", line.intercept, "m/s",
                std::log(10.0) * line_rounding * line.intercept, tables},
               line.name);
      for (const double voidage : league::line_voidages)
        list.add(
            {line.name + "/voidage/" + voidage_text(voidage),
             fmt::format("voidage on the line at {} m/s", velocity_text(run_velocity(line, voidage))), voidage, "-",
             std::log(10.0) * line_rounding * voidage / line.exponent, std::string(tables) + ", line evaluated"},
            line.name);
    }
    return list;
  }();
  return numbers;
}

double voidage_band() {
  double sum = 0.0, count = 0.0;
  for_each_pair([&](const ExpansionLine& one, const ExpansionLine& other) {
    for (const double voidage : league::line_voidages) {
      const double same_velocity = std::pow(one.velocity(voidage) / other.intercept, 1.0 / other.exponent);
      sum += 0.5 * std::abs(same_velocity - voidage);
      count += 1.0;
    }
  });
  return sum / count;
}

double exponent_band() {
  double sum = 0.0, count = 0.0;
  for_each_pair([&](const ExpansionLine& one, const ExpansionLine& other) {
    sum += std::abs(one.exponent - other.exponent) / (one.exponent + other.exponent);
    count += 1.0;
  });
  return sum / count;
}

std::vector<Quantity> own_quantities() {
  return {{"expansion_exponent", "-", "exponent of the bed's expansion",
           "n of U ~ ε^n: slope of ln U over ln ε through the runs of a bed, the voidage by the centre of mass.",
           OfSystem(exponent_of_runs)},
          {"homogeneous_voidage", "-", "voidage of the homogeneous bed",
           "At which the law carries the bed at the superficial velocity; no simulation.", OfNoRun{}},
          {"homogeneous_exponent", "-", "exponent of the homogeneous bed's expansion",
           "n of the law: slope of ln U over ln ε through its velocities at voidages from 0.5 to 0.9.", OfNoRun{}}};
}

std::vector<Claim> claims() {
  const std::string reason =
      "half of what the columns of 62 and 38 mm differ by with the same spheres in the same liquid; the tables say "
      "nothing of the scatter of the points";
  std::vector<Claim> list;
  for (const ExpansionLine& line : beds()) {
    const double exponent = line.exponent * exponent_band();
    for (const double voidage : league::line_voidages) {
      const double velocity = run_velocity(line, voidage);
      const std::string at = voidage_text(voidage), value = line.name + "/voidage/" + at;
      const std::string where = fmt::format("{} at {} m/s", line.name, velocity_text(velocity));
      list.push_back(claim("expansion." + line.name + "." + at, "expansion", "voidage of the simulated bed: " + where,
                           value, measure_key("voidage_centre_of_mass", line.name, velocity), voidage_band(), reason));
      for (const std::string& law : {authors_formula(), std::string(scene_law)})
        list.push_back(claim("law." + law.substr(0, law.find(' ')) + "." + line.name + "." + at, "parity",
                             fmt::format("voidage by {}: {}", law, where), value,
                             measure_key("homogeneous_voidage", law, velocity, line.name), voidage_band(), reason));
    }
    list.push_back(claim("expansion." + line.name + ".exponent", "expansion",
                         "exponent n of the simulated bed: " + line.name, line.name + "/exponent",
                         {"expansion_exponent", line.name}, exponent, reason));
    for (const std::string& law : {authors_formula(), std::string(scene_law)})
      list.push_back(claim("law." + law.substr(0, law.find(' ')) + "." + line.name + ".exponent", "parity",
                           fmt::format("exponent n by {}: {}", law, line.name), line.name + "/exponent",
                           {"homogeneous_exponent", law, {}, line.name}, exponent, reason));
  }
  return list;
}

Measurements measure_laws() {
  Measurements measured;
  for (const league::Contender& law : league::contenders())
    for (const ExpansionLine& line : beds()) {
      const league::Bed bed = league::bed_of(line);
      std::vector<std::pair<double, double>> points;
      for (const double voidage : league::line_voidages) {
        const double velocity = run_velocity(line, voidage);
        measured[measure_key("homogeneous_voidage", law.name(), velocity, line.name)] = {
            law.voidage(bed, velocity, not_lifted_voidage).voidage, 0.0, 1, "-", "law"};
        if (const double own = law.velocity(bed, voidage); own > 0.0) points.emplace_back(voidage, own);
      }
      if (const auto slope = slope_of(points))
        measured[{"homogeneous_exponent", law.name(), {}, line.name}] = {slope->value, 0.0, 1, "-", "law"};
    }
  return measured;
}

}  // namespace slfb::richardson_zaki
