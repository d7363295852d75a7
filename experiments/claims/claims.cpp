#include "experiments/claims/claims.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "experiments/quantities/analysis.hpp"
#include "experiments/quantities/json_file.hpp"
#include "solver/support/stopwatch.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One claim being read.
class ClaimReader {
 public:
  /// `readings`: names of what `measure` and `other_measure` read.
  ClaimReader(TomlTable& table, const ReferenceNumbers& reference, std::array<std::string, 2> readings)
      : table_(table), reference_(reference), readings_(std::move(readings)) {}

  Claim read() {
    Claim claim;
    claim.id = id_ = table_.text("id");
    claim.figure = table_.text("figure");
    claim.quantity = table_.text("quantity");
    claim.undecidable = table_.text("undecidable", "");
    read_statement(claim);
    claim.unit = table_.text("unit", claim.unit);
    claim.source = table_.text("source", claim.source);
    if (claim.unit.empty()) throw problem("unit", "is missing and no reference value gives one");
    if (claim.source.empty()) throw problem("source", "is missing and no reference value gives one");
    read_measures(claim);
    read_other_measures(claim);
    claim.origin = choice<Origin>("origin", {{"paper", Origin::paper}, {"arithmetic", Origin::arithmetic}});
    claim.printed_from =
        choice<PrintedFrom>("printed_from", {{"mean", PrintedFrom::mean}, {"one drop", PrintedFrom::one_drop}});
    read_regression(claim);
    table_.reject_others();
    return claim;
  }

 private:
  [[nodiscard]] std::runtime_error problem(const std::string& key, const std::string& message) const {
    return table_.problem(key, fmt::format("claim {}: {}", id_, message));
  }

  /// One of the words; the first where the key is left out.
  template <class Choice>
  Choice choice(const std::string& key, const std::vector<std::pair<std::string, Choice>>& words) const {
    const std::string given = table_.text(key, words.front().first);
    for (const auto& [word, meaning] : words)
      if (given == word) return meaning;
    throw problem(key, fmt::format("\"{}\" is neither \"{}\" nor \"{}\"", given, words[0].first, words[1].first));
  }

  std::vector<MeasureKey> measures_of(const std::string& key) const {
    std::vector<MeasureKey> measures;
    for (const std::string& measure : table_.text_or_texts(key)) try {
        measures.push_back(parse_measure_key(measure));
      } catch (const std::invalid_argument& error) {
        throw problem(key, error.what());
      }
    return measures;
  }

  void read_other_measures(Claim& claim) const {
    if (!table_.has("other_measure")) return;
    claim.other_measures = measures_of("other_measure");
    if (claim.other_measures.size() != claim.measures.size())
      throw problem("other_measure", "needs as many measures as \"measure\"");
    if (readings_[0].empty() || readings_[1].empty())
      throw problem("other_measure", "needs \"measure_is\" and \"other_measure_is\" at the top of the file");
    std::tie(claim.reading, claim.other_reading) = std::tie(readings_[0], readings_[1]);
  }

  /// Relative or absolute half-width of a band around `value`.
  double tolerance(TomlTable& band, const std::string& key, double value) const {
    if (band.has("relative") == band.has("absolute"))
      throw problem(key, "a band needs either \"relative\" or \"absolute\"");
    const double width = band.has("relative") ? band.number("relative") * std::abs(value) : band.number("absolute");
    if (!(width >= 0.0)) throw problem(key, "a band cannot be negative");
    return width;
  }

  [[nodiscard]] const ReferenceValue& reference(const std::string& key, const std::string& id) const {
    try {
      return reference_.at(id);
    } catch (const std::out_of_range& error) {
      throw problem(key, error.what());
    }
  }

  void read_statement(Claim& claim) {
    static const std::map<std::string, StatementKind> kinds{
        {"equals", StatementKind::value},      {"at_most", StatementKind::at_most},
        {"at_least", StatementKind::at_least}, {"between", StatementKind::between},
        {"trend", StatementKind::increasing},  {"states", StatementKind::words}};
    std::vector<std::string> given;
    for (const auto& [key, kind] : kinds)
      if (table_.has(key)) given.push_back(key);
    if (given.size() != 1)
      throw problem("id", "needs exactly one of equals, at_most, at_least, between, trend, states");
    const std::string& key = given.front();
    claim.kind = kinds.at(key);
    if (claim.kind == StatementKind::words) {
      claim.words = table_.text(key);
      if (claim.undecidable.empty()) throw problem(key, "words without a number need \"undecidable\"");
    } else if (claim.kind == StatementKind::increasing) {
      const std::string trend = table_.text(key);
      if (trend != "increasing" && trend != "decreasing")
        throw problem(key, "a trend is \"increasing\" or \"decreasing\"");
      if (trend == "decreasing") claim.kind = StatementKind::decreasing;
      if (table_.has("paper_band")) throw problem("paper_band", "a trend has none");
    } else {
      read_number(claim, key);
    }
  }

  void read_number(Claim& claim, const std::string& key) {
    const auto ids = table_.text_or_texts(key);
    if (ids.size() != (claim.kind == StatementKind::between ? 2u : 1u))
      throw problem(key, "wrong number of reference values");
    const ReferenceValue& first = reference(key, ids.front());
    const ReferenceValue& last = reference(key, ids.back());
    claim.paper = first.value;
    claim.paper_upper = last.value;
    claim.paper_uncertainty = first.uncertainty;
    claim.unit = first.unit;
    claim.source = first.source;

    TomlTable band = table_.table("paper_band");
    claim.band_reason = band.text("why");
    const double below = tolerance(band, "paper_band", first.value), above = tolerance(band, "paper_band", last.value);
    band.reject_others();
    claim.paper_band = Band{claim.kind == StatementKind::at_most ? -infinity : first.value - below,
                            claim.kind == StatementKind::at_least ? infinity : last.value + above};
  }

  void read_measures(Claim& claim) {
    static const std::map<std::string, Reduction> reductions{{"largest", Reduction::largest},
                                                             {"smallest", Reduction::smallest},
                                                             {"largest_magnitude", Reduction::largest_magnitude},
                                                             {"ratio", Reduction::ratio},
                                                             {"relative_spread", Reduction::relative_spread}};
    claim.measures = measures_of("measure");
    if (claim.measures.empty() && claim.undecidable.empty()) throw problem("measure", "is missing");
    if (const std::string name = table_.text("reduce", ""); !name.empty()) {
      const auto found = reductions.find(name);
      if (found == reductions.end()) throw problem("reduce", fmt::format("\"{}\" is unknown", name));
      claim.reduction = found->second;
    }
    const bool trend = claim.kind == StatementKind::increasing || claim.kind == StatementKind::decreasing;
    const bool several = claim.measures.size() > 1 || (!claim.measures.empty() && claim.measures[0].for_all_at);
    if (several && !trend && claim.reduction == Reduction::single)
      throw problem("measure", "several measures need \"reduce\"");
    if (trend && claim.undecidable.empty() && claim.measures.size() < 2)
      throw problem("measure", "a trend needs two measures");
    if (claim.reduction == Reduction::ratio && claim.measures.size() != 2)
      throw problem("measure", "a ratio needs two measures");
  }

  void read_regression(Claim& claim) {
    if (!table_.has("regression")) return;
    TomlTable band = table_.table("regression");
    const double accepted = band.number("value");
    const double width = tolerance(band, "regression", accepted);
    claim.regression_band = Band{accepted - width, accepted + width};
    claim.regression_reason = band.text("why");
    band.reject_others();
  }

  TomlTable& table_;
  const ReferenceNumbers& reference_;
  std::array<std::string, 2> readings_;
  std::string id_;
};

/// The keys that a measure stands for; itself where it is no pattern.
std::vector<MeasureKey> expand(const MeasureKey& measure, const Measurements& measurements) {
  if (!measure.for_all_at) return {measure};
  std::vector<MeasureKey> keys;
  for (const auto& [key, measurement] : measurements)
    if (stands_for(measure, key)) keys.push_back(key);
  return keys;
}

bool is_trend(const Claim& claim) {
  return claim.kind == StatementKind::increasing || claim.kind == StatementKind::decreasing;
}

/// Half-width of an interval that misses the truth with this probability, over that of the 95 % interval.
double over_95(double significance, std::size_t samples) {
  const double freedom = static_cast<double>(std::max<std::size_t>(2, samples)) - 1.0;
  return gsl_cdf_tdist_Qinv(0.5 * significance, freedom) / gsl_cdf_tdist_Qinv(0.025, freedom);
}

/// The same where `trials` comparisons share the 5 % (Šidák 1967).
double widening(std::size_t trials, std::size_t samples) {
  return trials < 2 ? 1.0 : over_95(1.0 - std::pow(0.95, 1.0 / static_cast<double>(trials)), samples);
}

/// A measurement with the interval of another level.
Measurement at_significance(Measurement measurement, double significance) {
  if (significance == 0.05) return measurement;
  const double wider = over_95(significance, measurement.samples);
  measurement.half_width *= wider;
  if (measurement.interval)
    measurement.interval = {
        std::max(measurement.lowest, measurement.value - wider * (measurement.value - measurement.interval->first)),
        std::min(measurement.highest, measurement.value + wider * (measurement.interval->second - measurement.value))};
  return measurement;
}

/// The largest of several means. The largest of n noisy numbers is large by chance: it is below what any of n numbers
/// may be at a level that all of them share, and above every single lower end.
Measurement largest_of(const std::vector<Measurement>& values) {
  Measurement result = *std::ranges::max_element(values, {}, &Measurement::value);
  if (!std::ranges::all_of(values, &Measurement::has_interval)) {
    result.half_width = std::numeric_limits<double>::quiet_NaN();
    result.interval.reset();
    return result;
  }
  double lower = -infinity, upper = -infinity;
  for (const Measurement& value : values) {
    const double wider = widening(values.size(), value.samples);
    lower = std::max(lower, std::max(value.lowest, value.value - wider * (value.value - value.lower())));
    upper = std::max(upper, value.upper());
  }
  result.interval = {lower, upper};
  return result;
}

Measurement negated(Measurement value) {
  value.value = -value.value;
  if (value.interval) value.interval = {-value.interval->second, -value.interval->first};
  std::tie(value.lowest, value.highest) = std::pair{-value.highest, -value.lowest};
  return value;
}

Measurement magnitude_of(const Measurement& value) {
  Measurement result = value.value < 0.0 ? negated(value) : value;
  if (result.has_interval())
    result.interval = {std::max(0.0, result.lower()), std::max(-result.lower(), result.upper())};
  return result;
}

/// Several measurements as one number with its interval.
Measurement reduce(Reduction reduction, const std::vector<Measurement>& values) {
  const auto mapped = [&](auto change) {
    std::vector<Measurement> changed;
    std::ranges::transform(values, std::back_inserter(changed), change);
    return changed;
  };
  switch (reduction) {
    case Reduction::single:
      return values.front();
    case Reduction::largest:
      return largest_of(values);
    case Reduction::smallest:
      return negated(largest_of(mapped(negated)));
    case Reduction::largest_magnitude:
      return largest_of(mapped(magnitude_of));
    case Reduction::ratio: {
      Measurement result = values[0];
      result.value = values[0].value / values[1].value;
      result.half_width = std::abs(result.value) *
                          std::hypot(values[0].half_width / values[0].value, values[1].half_width / values[1].value);
      return result;
    }
    case Reduction::relative_spread: {
      const auto [lowest, highest] = std::ranges::minmax_element(values, {}, &Measurement::value);
      double sum = 0.0;
      for (const Measurement& value : values) sum += value.value;
      const double mean = sum / static_cast<double>(values.size());
      Measurement result = *highest;
      result.value = (highest->value - lowest->value) / mean;
      result.half_width = std::hypot(highest->half_width, lowest->half_width) / mean;
      result.lowest = 0.0;
      return result;
    }
  }
  throw std::logic_error("reduce: unknown reduction");
}

/// How many times as many samples bring the half-width down to a distance.
double samples_for(double half_width, double distance) {
  return distance > 0.0 ? std::max(1.0, std::pow(half_width / distance, 2)) : infinity;
}

void undecided(Evaluation& evaluation, Lack lack, std::string reason) {
  evaluation.verdict = Verdict::not_decidable;
  evaluation.lack = lack;
  evaluation.reason = std::move(reason);
}

void decided(Evaluation& evaluation, Verdict verdict, std::string reason) {
  evaluation.verdict = verdict;
  evaluation.lack = Lack::nothing;
  evaluation.reason = std::move(reason);
}

/// Change from the first measurement to the last, and the verdict of the rule in reference-data/README.md.
void judge_trend(Evaluation& evaluation, const std::vector<Measurement>& values) {
  const double sign = evaluation.claim.kind == StatementKind::increasing ? 1.0 : -1.0;
  const double change = values.back().value - values.front().value;
  const double half_width = std::hypot(values.back().half_width, values.front().half_width);
  evaluation.ours = change;
  if (std::ranges::any_of(values, [](const Measurement& m) { return std::isnan(m.half_width); })) {
    undecided(evaluation, Lack::more_samples, "one sample only, so no interval");
    return;
  }
  evaluation.interval = {change - half_width, change + half_width};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = sign * (values[i].value - values[i - 1].value);
    const auto chance = [&](const Measurement& value) {
      return value.half_width * widening(values.size() - 1, value.samples);
    };
    if (step < -std::hypot(chance(values[i]), chance(values[i - 1]))) {
      decided(evaluation, Verdict::not_reproduced,
              fmt::format("from {} to {} the change is in the other direction",
                          to_string(evaluation.claim.measures[i - 1]), to_string(evaluation.claim.measures[i])));
      return;
    }
  }
  if (sign * change > half_width) {
    decided(evaluation, Verdict::reproduced, "no step goes the other way beyond its interval");
  } else if (sign * change < -half_width) {
    decided(evaluation, Verdict::not_reproduced, "the change is in the other direction");
  } else if (half_width == 0.0) {
    decided(evaluation, Verdict::not_reproduced, "there is no change");
  } else {
    undecided(evaluation, Lack::more_samples, "the change is smaller than its interval");
    evaluation.samples_needed = samples_for(half_width, std::abs(change));
  }
}

std::optional<double> deviation_of(const Claim& claim, double ours) {
  const auto relative = [&](double reference) -> std::optional<double> {
    if (reference == 0.0) return std::nullopt;
    return (ours - reference) / std::abs(reference);
  };
  switch (claim.kind) {
    case StatementKind::value:
      return relative(claim.paper);
    case StatementKind::at_most:
      return ours <= claim.paper ? 0.0 : relative(claim.paper);
    case StatementKind::at_least:
      return ours >= claim.paper ? 0.0 : relative(claim.paper);
    case StatementKind::between:
      if (ours < claim.paper) return relative(claim.paper);
      return ours > claim.paper_upper ? relative(claim.paper_upper) : 0.0;
    case StatementKind::increasing:
    case StatementKind::decreasing:
    case StatementKind::words:
      return std::nullopt;
  }
  throw std::logic_error("deviation_of: unknown statement");
}

void judge_band(Evaluation& evaluation, const Measurement& measurement) {
  evaluation.ours = measurement.value;
  evaluation.deviation = deviation_of(evaluation.claim, measurement.value);
  if (!evaluation.claim.paper_band) {  // a statement in words: our number is shown, and nothing is judged
    evaluation.reason = evaluation.claim.undecidable;
    return;
  }
  const Band band = *evaluation.claim.paper_band;
  const bool inside = band.contains(measurement.value);
  const double lower = measurement.lower(), upper = measurement.upper();
  if (!measurement.has_interval() || std::isnan(lower) || std::isnan(upper)) {
    undecided(
        evaluation, Lack::more_samples,
        fmt::format("one sample only, so no interval; the value lies {} the band", inside ? "inside" : "outside"));
    return;
  }
  evaluation.interval = {lower, upper};
  const bool exact = lower == upper;
  if (band.contains(lower) && band.contains(upper)) {
    decided(evaluation, Verdict::reproduced, exact ? "inside the band" : "the whole interval lies in the band");
  } else if (upper < band.lower || lower > band.upper) {
    decided(evaluation, Verdict::not_reproduced,
            exact ? "outside the band" : "the whole interval lies outside the band");
  } else {
    undecided(evaluation, Lack::more_samples, "the interval straddles the edge of the band: more samples are needed");
    const auto to_edge = [&](double end, double edge) {
      const bool crosses = std::isfinite(edge) && (end - edge) * (measurement.value - edge) < 0.0;
      return crosses ? samples_for(std::abs(end - measurement.value), std::abs(edge - measurement.value)) : 1.0;
    };
    evaluation.samples_needed = std::max({to_edge(lower, band.lower), to_edge(lower, band.upper),
                                          to_edge(upper, band.lower), to_edge(upper, band.upper)});
    if (*evaluation.samples_needed <= 1.0) evaluation.samples_needed = infinity;  // the mean is on an edge
  }
}

/// What one more drop would give: our mean is known with an error, and a drop scatters about it.
class OneDrop {
 public:
  OneDrop(const Measurement& measured, double significance)
      : significance_(significance),
        mean_(measured.value),
        scatter_(measured.scatter),
        error_(standard_error(measured.half_width, measured.samples)),
        freedom_(static_cast<double>(measured.samples) - 1.0),
        lowest_(measured.lowest),
        highest_(measured.highest) {}

  /// Whether the drops of a measurement have a scatter.
  static bool known(const Measurement& measured) {
    return measured.scatter >= 0.0 && measured.half_width >= 0.0 && measured.samples >= 2;
  }

  [[nodiscard]] double mean() const { return mean_; }
  /// Half-widths: of the mean, of a drop about the mean, and of a drop about our estimate of it.
  [[nodiscard]] double of_mean() const { return quantile() * error_; }
  [[nodiscard]] double of_drop() const { return gsl_cdf_ugaussian_Pinv(0.975) * scatter_; }
  [[nodiscard]] double of_prediction() const { return quantile() * spread(); }

  /// Probability that a drop gives no more than `value`.
  [[nodiscard]] double probability_up_to(double value) const {
    if (value >= highest_) return 1.0;
    if (value < lowest_) return 0.0;
    if (!(spread() > 0.0)) return value >= mean_ ? 1.0 : 0.0;
    return gsl_cdf_tdist_P((value - mean_) / spread(), freedom_);
  }
  [[nodiscard]] double probability_within(const Band& band) const {
    return probability_up_to(band.upper) - (std::isfinite(band.lower) ? probability_up_to(band.lower) : 0.0);
  }

 private:
  [[nodiscard]] double quantile() const { return gsl_cdf_tdist_Qinv(0.5 * significance_, freedom_); }
  [[nodiscard]] double spread() const { return std::hypot(scatter_, error_); }

  double significance_, mean_, scatter_, error_, freedom_, lowest_, highest_;
};

/// A printed value that is one drop: is it one that our drops give?
void judge_one_value(Evaluation& evaluation, const Measurement& measurement, double significance) {
  const Claim& claim = evaluation.claim;
  const OneDrop drop(measurement, significance);
  evaluation.ours = drop.mean();
  evaluation.deviation = deviation_of(claim, drop.mean());
  evaluation.interval = {std::max(measurement.lowest, drop.mean() - drop.of_prediction()),
                         std::min(measurement.highest, drop.mean() + drop.of_prediction())};
  const double distance = std::max(0.0, std::abs(claim.paper - drop.mean()) - claim.paper_uncertainty);
  const double farthest = std::max(std::abs(claim.paper_band->upper - claim.paper), claim.paper_uncertainty);
  if (distance > drop.of_prediction()) {
    decided(evaluation, Verdict::not_reproduced, "the printed drop lies outside the interval of one drop of ours");
  } else if (distance + drop.of_mean() > std::max(drop.of_drop(), 0.0)) {
    undecided(evaluation, Lack::more_samples,
              "the printed drop lies within the interval of one drop of ours, but our mean is not known well enough to "
              "say that it is one of them: more drops are needed");
    // Inside the scatter of our drops the error of the mean has to shrink to what is left of it, outside to the excess.
    evaluation.samples_needed = samples_for(drop.of_mean(), std::abs(drop.of_drop() - distance));
  } else if (std::abs(claim.paper - drop.mean()) + drop.of_mean() > farthest) {
    undecided(evaluation, Lack::paper,
              "the printed drop is one that ours give, but ours scatter so much that a mean outside the band gives it "
              "too: one printed drop cannot tell");
  } else {
    decided(evaluation, Verdict::reproduced, "the printed drop is one that ours give, and our mean lies in the band");
  }
}

/// Probability that single drops, one of each measurement, reduced to one number, give no more than `value`: the
/// largest of n drops is judged by the distribution of the largest of n.
double probability_up_to(Reduction reduction, const std::vector<OneDrop>& drops, double value) {
  double all_below = 1.0, all_above = 1.0, all_within = 1.0;
  for (const OneDrop& drop : drops) {
    const double below = drop.probability_up_to(value);
    all_below *= below;
    all_above *= 1.0 - below;
    all_within *= value < 0.0 ? 0.0 : drop.probability_within({-value, value});
  }
  return reduction == Reduction::smallest            ? 1.0 - all_above
         : reduction == Reduction::largest_magnitude ? all_within
                                                     : all_below;
}

/// Its central 95 %.
std::pair<double, double> interval_of_drops(Reduction reduction, const std::vector<OneDrop>& drops) {
  double farthest = 0.0;
  for (const OneDrop& drop : drops) farthest = std::max(farthest, std::abs(drop.mean()) + 20.0 * drop.of_prediction());
  const auto quantile = [&](double level) {
    double below = -farthest, above = farthest;
    for (int step = 0; step < 100; ++step) {
      const double middle = 0.5 * (below + above);
      (probability_up_to(reduction, drops, middle) < level ? below : above) = middle;
    }
    return above;
  };
  return {quantile(0.025), quantile(0.975)};
}

/// Bounds on printed drops, one of each measurement: how often would drops of ours keep them?
void judge_bound_on_drops(Evaluation& evaluation, const std::vector<Measurement>& values, double significance) {
  const Claim& claim = evaluation.claim;
  std::vector<OneDrop> drops;
  for (const Measurement& value : values) drops.emplace_back(value, significance);
  const Band band = *claim.paper_band;
  const double probability = (std::isfinite(band.upper) ? probability_up_to(claim.reduction, drops, band.upper) : 1.0) -
                             (std::isfinite(band.lower) ? probability_up_to(claim.reduction, drops, band.lower) : 0.0);
  evaluation.interval = interval_of_drops(claim.reduction, drops);
  evaluation.ours = reduce(claim.reduction, values).value;
  evaluation.deviation = deviation_of(claim, *evaluation.ours);
  const std::string how_often =
      fmt::format("{} of ours would lie in the band with probability {:.2g}",
                  values.size() == 1 ? "one drop" : fmt::format("the extreme of {} drops", values.size()), probability);
  constexpr double ordinary = 0.5, excluded = 0.05;
  if (probability >= ordinary) {
    decided(evaluation, Verdict::reproduced, how_often);
  } else if (probability < excluded) {
    decided(evaluation, Verdict::not_reproduced, how_often);
  } else {
    undecided(evaluation, Lack::paper, how_often + ": what was printed once is neither ordinary nor excluded");
  }
}

/// Printed numbers of single drops. Where our drops have no scatter (one only, or a median of drops of which some had
/// not arrived), the band decides.
void judge_drops(Evaluation& evaluation, const std::vector<Measurement>& values, double significance) {
  if (!std::ranges::all_of(values, OneDrop::known)) {
    std::vector<Measurement> widened;
    for (const Measurement& value : values) widened.push_back(at_significance(value, significance));
    return judge_band(evaluation, reduce(evaluation.claim.reduction, widened));
  }
  if (evaluation.claim.kind == StatementKind::value && values.size() == 1)
    return judge_one_value(evaluation, values[0], significance);
  judge_bound_on_drops(evaluation, values, significance);
}

void judge_gate(Evaluation& evaluation) {
  const auto& band = evaluation.claim.regression_band;
  if (!band) return;
  if (!evaluation.ours) {
    // A law answers at once on every machine, so a missing answer is a fault; a run may simply not exist yet.
    if (!evaluation.claim.needs_run()) {
      evaluation.gate = Gate::broken;
      evaluation.reason += "; a measure that needs no run must exist";
    }
    return;
  }
  evaluation.gate = band->contains(*evaluation.ours) ? Gate::holds : Gate::broken;
  if (evaluation.gate == Gate::broken) {
    evaluation.reason +=
        fmt::format("; {:.6g} is outside the accepted {:.6g} … {:.6g}", *evaluation.ours, band->lower, band->upper);
  }
}

bool of_both(const std::vector<Measurement>& values, Springs one, Springs other) {
  return std::ranges::count(values, one, &Measurement::springs) > 0 &&
         std::ranges::count(values, other, &Measurement::springs) > 0;
}

/// Why a measure is missing: its run is, or the run is there and has no such number; or no run is near its voidage.
std::string missing_text(const Claim& claim, const MeasureKey& measure, const Measurements& measurements) {
  const std::string text = to_string(measure);
  if (!claim.needs_run(measure)) return "not yet measured: " + text;
  if (measure.quantity.ends_with("_at_voidage")) return "no runs about this voidage: " + text;
  const bool simulated = std::ranges::any_of(measurements, [&](const auto& entry) {
    MeasureKey same_run = measure;
    same_run.quantity = entry.first.quantity;
    return entry.first == same_run;
  });
  return (simulated ? "simulated, but without such a number: " : "not yet simulated: ") + text;
}

/// The statement with these measures, without its gate.
Evaluation judge_reading(const Claim& claim, const std::vector<MeasureKey>& measures, const Measurements& measurements,
                         double significance) {
  Evaluation evaluation;
  evaluation.claim = claim;
  evaluation.claim.measures = measures;
  std::vector<Measurement> values;
  std::string missing;
  std::set<std::string> remarked;
  for (const MeasureKey& measure : measures) {
    const auto keys = expand(measure, measurements);
    bool found = !keys.empty();
    for (const MeasureKey& key : keys) {
      const auto entry = measurements.find(key);
      if (entry == measurements.end() || std::isnan(entry->second.value)) {
        found = false;
      } else {
        values.push_back(entry->second);
        if (const std::string& remark = entry->second.remark; !remark.empty()) remarked.insert(remark);
      }
    }
    if (found) continue;
    missing += (missing.empty() ? "" : "; ") + missing_text(claim, measure, measurements);
  }

  if (!missing.empty()) {
    undecided(evaluation, Lack::run, missing);
  } else if (measures.empty()) {
    undecided(evaluation, Lack::paper, claim.undecidable);
  } else if (of_both(values, Springs::own, Springs::softened)) {
    undecided(evaluation, Lack::run,
              "runs with the paper's springs would be compared with softened ones: more of the former are needed");
  } else if (!is_trend(claim) && claim.printed_from == PrintedFrom::one_drop) {
    judge_drops(evaluation, values, significance);
  } else {
    for (Measurement& value : values) value = at_significance(std::move(value), significance);
    if (is_trend(claim)) {
      judge_trend(evaluation, values);
    } else {
      judge_band(evaluation, reduce(claim.reduction, values));
    }
  }
  const auto unsteady = std::ranges::count(values, false, &Measurement::steady);
  if (evaluation.lack == Lack::more_samples && unsteady > 0) evaluation.lack = Lack::steadiness;
  if (remarked.size() == 1) {
    evaluation.reason += "; " + *remarked.begin();
  } else if (unsteady > 0) {
    evaluation.reason += fmt::format("; {} of {} beds were not steady", unsteady, values.size());
  }
  evaluation.claim = claim;
  return evaluation;
}

/// Both readings of a claim whose abscissa is not said: where they agree, or where only one can be judged, that is the
/// verdict; where they do not, the paper does not say enough.
Evaluation judge_both(const Claim& claim, const Measurements& measurements, double significance) {
  Evaluation one = judge_reading(claim, claim.measures, measurements, significance);
  if (claim.other_measures.empty()) return one;
  const Evaluation other = judge_reading(claim, claim.other_measures, measurements, significance);
  const auto account = [](const std::string& reading, const Evaluation& evaluation) {
    return fmt::format("at {}: {}{} ({})", reading,
                       evaluation.ours ? fmt::format("{:.4g}, ", *evaluation.ours) : std::string(),
                       to_string(evaluation.verdict), evaluation.reason);
  };
  const std::string reason = fmt::format("{}; {}", account(claim.reading, one), account(claim.other_reading, other));
  const bool only_other = one.verdict == Verdict::not_decidable && other.verdict != Verdict::not_decidable;
  const bool differ =
      one.verdict != Verdict::not_decidable && other.verdict != Verdict::not_decidable && one.verdict != other.verdict;
  if (only_other || (!one.ours && other.ours)) one = other;
  one.reason = reason;
  if (differ) undecided(one, Lack::paper, "it hangs on whose voidage is meant: " + reason);
  return one;
}

Evaluation evaluate_claim(const Claim& claim, const Measurements& measurements, double significance) {
  Evaluation evaluation = judge_both(claim, measurements, significance);
  if (!claim.undecidable.empty()) undecided(evaluation, Lack::paper, claim.undecidable);
  judge_gate(evaluation);
  return evaluation;
}

/// A mean with its standard error and degrees of freedom.
struct Mean {
  double value, error, freedom;
};

std::optional<Mean> mean_of(const Measurements& measurements, const MeasureKey& key) {
  const auto found = measurements.find(key);
  if (found == measurements.end() || !(found->second.half_width >= 0.0) || found->second.samples < 2)
    return std::nullopt;
  const Measurement& mean = found->second;
  return Mean{mean.value, standard_error(mean.half_width, mean.samples), static_cast<double>(mean.samples) - 1.0};
}

/// |a − b| over what chance allows with probability 1 − `level` (Welch 1947, Biometrika 34, 28).
double difference_over_chance(const Mean& a, const Mean& b, double level) {
  const double variance = a.error * a.error + b.error * b.error;
  // Rounding alone, where neither has a spread (counts that are all the same).
  if (!(variance > 0.0)) return std::abs(a.value - b.value) > 1e-9 * std::abs(a.value) ? 2.0 : 0.0;
  const double freedom = variance * variance / (std::pow(a.error, 4) / a.freedom + std::pow(b.error, 4) / b.freedom);
  return std::abs(a.value - b.value) / (std::sqrt(variance) * gsl_cdf_tdist_Qinv(0.5 * level, freedom));
}

}  // namespace

void judge_run_gates(std::vector<Evaluation>& evaluations, const Measurements& fresh, const Measurements& accepted) {
  constexpr double false_alarms = 1e-3;  // of all gates together
  std::set<MeasureKey> tested;
  const auto keys_of = [&](const Evaluation& evaluation) {
    std::vector<MeasureKey> keys;
    if (evaluation.claim.regression_band) return keys;
    for (const MeasureKey& measure : evaluation.claim.measures)
      for (const MeasureKey& key : expand(measure, fresh))
        if (evaluation.claim.needs_run(key) && mean_of(fresh, key) && mean_of(accepted, key)) keys.push_back(key);
    return keys;
  };
  for (const Evaluation& evaluation : evaluations)
    for (MeasureKey& key : keys_of(evaluation)) tested.insert(std::move(key));
  for (Evaluation& evaluation : evaluations)
    for (const MeasureKey& key : keys_of(evaluation)) {
      if (evaluation.gate == Gate::none) evaluation.gate = Gate::holds;
      const Mean ours = *mean_of(fresh, key), theirs = *mean_of(accepted, key);
      if (difference_over_chance(ours, theirs, false_alarms / static_cast<double>(tested.size())) <= 1.0) continue;
      evaluation.gate = Gate::broken;
      evaluation.reason += fmt::format("; {} is {:.6g} here and {:.6g} in the published runs, more than chance allows",
                                       to_string(key), ours.value, theirs.value);
    }
}

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::not_reproduced:
      return "not reproduced";
    case Verdict::not_decidable:
      return "not decidable";
  }
  throw std::logic_error("to_string: unknown verdict");
}

std::string_view to_string(Gate gate) {
  switch (gate) {
    case Gate::holds:
      return "holds";
    case Gate::broken:
      return "broken";
    case Gate::none:
      return "none";
  }
  throw std::logic_error("to_string: unknown gate");
}

std::string_view to_string(Origin origin) { return origin == Origin::paper ? "paper" : "arithmetic"; }

std::string_view to_string(Lack lack) {
  switch (lack) {
    case Lack::nothing:
      return "nothing";
    case Lack::paper:
      return "paper";
    case Lack::run:
      return "run";
    case Lack::steadiness:
      return "steady bed";
    case Lack::more_samples:
      return "samples";
  }
  throw std::logic_error("to_string: unknown lack");
}

std::string Claim::paper_text() const {
  switch (kind) {
    case StatementKind::value:
      return fmt::format("{:.6g}", paper);
    case StatementKind::at_most:
      return fmt::format("at most {:.6g}", paper);
    case StatementKind::at_least:
      return fmt::format("at least {:.6g}", paper);
    case StatementKind::between:
      return fmt::format("between {:.6g} and {:.6g}", paper, paper_upper);
    case StatementKind::increasing:
      return "increasing";
    case StatementKind::decreasing:
      return "decreasing";
    case StatementKind::words:
      return words;
  }
  throw std::logic_error("paper_text: unknown statement");
}

bool Claim::needs_run(const MeasureKey& measure) const {
  return measure.subject == all_systems || systems.contains(measure.subject);
}

bool Claim::needs_run() const {
  return std::ranges::any_of(measures, [&](const MeasureKey& measure) { return needs_run(measure); });
}

std::vector<Claim> load_claims(const std::filesystem::path& file, const ReferenceNumbers& reference,
                               const std::set<std::string>& systems) {
  const toml::table document = parse_toml_file(file);
  TomlTable root(document, file.string());
  std::vector<Claim> claims;
  std::set<std::string> ids;
  const std::array<std::string, 2> readings{root.text("measure_is", ""), root.text("other_measure_is", "")};
  for (TomlTable& entry : root.tables("claim")) {
    Claim claim = ClaimReader(entry, reference, readings).read();
    claim.systems = systems;
    if (!ids.insert(claim.id).second) throw entry.problem("id", fmt::format("claim {} occurs twice", claim.id));
    claims.push_back(std::move(claim));
  }
  root.reject_others();
  if (claims.empty()) throw std::runtime_error(file.string() + ": no [[claim]] in it");
  return claims;
}

double significance_of_look(int look) {
  // 6/π² is one over the sum of 1/k².
  return look <= 1 ? 0.05 : 0.05 * 6.0 / std::pow(std::numbers::pi * look, 2);
}

std::vector<Evaluation> evaluate(const std::vector<Claim>& claims, const Measurements& measurements,
                                 const Looks& looks) {
  std::vector<Evaluation> evaluations;
  evaluations.reserve(claims.size());
  for (const Claim& claim : claims) {
    const auto look = looks.find(claim.id);
    double seconds = 0.0;
    {
      const Stopwatch watch(seconds);
      evaluations.push_back(
          evaluate_claim(claim, measurements, significance_of_look(look == looks.end() ? 1 : look->second)));
    }
    evaluations.back().seconds = seconds;
    if (look != looks.end() && look->second > 1)
      evaluations.back().reason +=
          fmt::format("; judged {} times as runs were added, so the interval is one of {:.4g} %", look->second,
                      100.0 * (1.0 - significance_of_look(look->second)));
  }
  return evaluations;
}

namespace {

ClaimCounts count_of(const std::vector<Evaluation>& evaluations, std::optional<Origin> wanted) {
  ClaimCounts counts;
  for (const Evaluation& evaluation : evaluations) {
    if (wanted && evaluation.claim.origin != *wanted) continue;
    counts.reproduced += evaluation.verdict == Verdict::reproduced;
    counts.not_reproduced += evaluation.verdict == Verdict::not_reproduced;
    counts.not_decidable += evaluation.verdict == Verdict::not_decidable;
    counts.gates_holding += evaluation.gate == Gate::holds;
    counts.gates_broken += evaluation.gate == Gate::broken;
  }
  return counts;
}

}  // namespace

ClaimCounts count(const std::vector<Evaluation>& evaluations) { return count_of(evaluations, std::nullopt); }
ClaimCounts count(const std::vector<Evaluation>& evaluations, Origin origin) { return count_of(evaluations, origin); }

std::string counts_text(const std::vector<Evaluation>& evaluations) {
  const ClaimCounts all_counts = count(evaluations);
  std::string text = fmt::format("{} claims: {} reproduced, {} not reproduced, {} not decidable", evaluations.size(),
                                 all_counts.reproduced, all_counts.not_reproduced, all_counts.not_decidable);
  for (const auto& [origin, title] : {std::pair{Origin::paper, "statements of the paper"},
                                      {Origin::arithmetic, "checks by arithmetic, laws and probes"}}) {
    const ClaimCounts counts = count(evaluations, origin);
    const std::size_t all = counts.reproduced + counts.not_reproduced + counts.not_decidable;
    if (all > 0)
      text += fmt::format("\n  {} {}: {} reproduced, {} not reproduced, {} not decidable", all, title,
                          counts.reproduced, counts.not_reproduced, counts.not_decidable);
  }
  return text;
}

nlohmann::ordered_json claims_json(const std::vector<Evaluation>& evaluations) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Evaluation& evaluation : evaluations) {
    const Claim& claim = evaluation.claim;
    list.push_back({
        {"id", claim.id},
        {"figure", claim.figure},
        {"quantity", claim.quantity},
        {"unit", claim.unit},
        {"paper", claim.kind == StatementKind::value ? Json(claim.paper) : Json(claim.paper_text())},
        {"ours", evaluation.ours ? number_or_null(*evaluation.ours) : Json(nullptr)},
        {"interval", evaluation.interval ? Json::array({number_or_null(evaluation.interval->first),
                                                        number_or_null(evaluation.interval->second)})
                                         : Json(nullptr)},
        {"deviation", evaluation.deviation ? number_or_null(*evaluation.deviation) : Json(nullptr)},
        {"paper_band", claim.paper_band ? Json::array({number_or_null(claim.paper_band->lower),
                                                       number_or_null(claim.paper_band->upper)})
                                        : Json(nullptr)},
        {"verdict", to_string(evaluation.verdict)},
        {"gate", to_string(evaluation.gate)},
        {"origin", to_string(claim.origin)},
        {"lack", to_string(evaluation.lack)},
        {"reason", evaluation.reason},
    });
  }
  return {{"claims", std::move(list)}};
}

namespace {

/// What is beside the reason of a broken gate: our number and what it may be.
std::string failure_text(const Evaluation& evaluation) {
  const Claim& claim = evaluation.claim;
  std::string text;
  if (evaluation.ours) text += fmt::format("ours {:.6g} {}", *evaluation.ours, claim.unit);
  if (evaluation.interval)
    text += fmt::format(" in [{:.6g}, {:.6g}]", evaluation.interval->first, evaluation.interval->second);
  const std::optional<Band>& band = claim.regression_band ? claim.regression_band : claim.paper_band;
  if (band) text += fmt::format(", allowed [{:.6g}, {:.6g}]", band->lower, band->upper);
  return text + (text.empty() ? "" : ": ") + evaluation.reason;
}

}  // namespace

std::string claims_junit(const std::vector<Evaluation>& evaluations) {
  pugi::xml_document document;
  pugi::xml_node suite = document.append_child("testsuite");
  std::size_t failures = 0, skipped = 0;
  double seconds = 0.0;
  for (const Evaluation& evaluation : evaluations) {
    seconds += evaluation.seconds;
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = evaluation.claim.figure.c_str();
    test.append_attribute("name") = evaluation.claim.id.c_str();
    test.append_attribute("time") = fmt::format("{:.6f}", evaluation.seconds).c_str();
    if (evaluation.gate == Gate::broken) {
      ++failures;
      test.append_child("failure").append_attribute("message") = failure_text(evaluation).c_str();
    } else if (evaluation.gate == Gate::none) {
      ++skipped;
      test.append_child("skipped").append_attribute("message") =
          fmt::format("no gate; {}: {}", to_string(evaluation.verdict), evaluation.reason).c_str();
    }
  }
  suite.append_attribute("name") = "slfb check";
  suite.append_attribute("tests") = evaluations.size();
  suite.append_attribute("failures") = failures;
  suite.append_attribute("skipped") = skipped;
  suite.append_attribute("time") = fmt::format("{:.6f}", seconds).c_str();
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace slfb
