#include "experiments/claims/claims.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/quantities/analysis.hpp"
#include "experiments/quantities/json_file.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One claim being read.
class ClaimReader {
 public:
  ClaimReader(TomlTable& table, const ReferenceNumbers& reference) : table_(table), reference_(reference) {}

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
    read_regression(claim);
    table_.reject_others();
    return claim;
  }

 private:
  [[nodiscard]] std::runtime_error problem(const std::string& key, const std::string& message) const {
    return table_.problem(key, fmt::format("claim {}: {}", id_, message));
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
    for (const std::string& measure : table_.text_or_texts("measure")) try {
        claim.measures.push_back(parse_measure_key(measure));
      } catch (const std::invalid_argument& error) {
        throw problem("measure", error.what());
      }
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

/// Several measurements as one number with its half-width.
Measurement reduce(Reduction reduction, const std::vector<Measurement>& values) {
  const auto by_value = [](const Measurement& a, const Measurement& b) { return a.value < b.value; };
  const auto by_magnitude = [](const Measurement& a, const Measurement& b) {
    return std::abs(a.value) < std::abs(b.value);
  };
  switch (reduction) {
    case Reduction::single:
      return values.front();
    case Reduction::largest:
      return *std::max_element(values.begin(), values.end(), by_value);
    case Reduction::smallest:
      return *std::min_element(values.begin(), values.end(), by_value);
    case Reduction::largest_magnitude: {
      Measurement result = *std::max_element(values.begin(), values.end(), by_magnitude);
      result.value = std::abs(result.value);
      return result;
    }
    case Reduction::ratio: {
      Measurement result = values[0];
      result.value = values[0].value / values[1].value;
      result.half_width = std::abs(result.value) *
                          std::hypot(values[0].half_width / values[0].value, values[1].half_width / values[1].value);
      return result;
    }
    case Reduction::relative_spread: {
      const auto [lowest, highest] = std::minmax_element(values.begin(), values.end(), by_value);
      double sum = 0.0;
      for (const Measurement& value : values) sum += value.value;
      const double mean = sum / static_cast<double>(values.size());
      Measurement result = *highest;
      result.value = (highest->value - lowest->value) / mean;
      result.half_width = std::hypot(highest->half_width, lowest->half_width) / mean;
      return result;
    }
  }
  throw std::logic_error("reduce: unknown reduction");
}

/// Change from the first measurement to the last, and the verdict of the rule in reference-data/README.md.
void judge_trend(Evaluation& evaluation, const std::vector<Measurement>& values) {
  const double sign = evaluation.claim.kind == StatementKind::increasing ? 1.0 : -1.0;
  const double change = values.back().value - values.front().value;
  const double half_width = std::hypot(values.back().half_width, values.front().half_width);
  evaluation.ours = change;
  if (std::any_of(values.begin(), values.end(), [](const Measurement& m) { return std::isnan(m.half_width); })) {
    evaluation.reason = "one sample only, so no interval";
    return;
  }
  evaluation.interval = {change - half_width, change + half_width};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = sign * (values[i].value - values[i - 1].value);
    if (step < -std::hypot(values[i].half_width, values[i - 1].half_width)) {
      evaluation.verdict = Verdict::not_reproduced;
      evaluation.reason =
          fmt::format("from {} to {} the change is in the other direction", to_string(evaluation.claim.measures[i - 1]),
                      to_string(evaluation.claim.measures[i]));
      return;
    }
  }
  if (sign * change > half_width) {
    evaluation.verdict = Verdict::reproduced;
    evaluation.reason = "no step goes the other way beyond its interval";
  } else if (half_width == 0.0) {
    evaluation.verdict = Verdict::not_reproduced;
    evaluation.reason = "there is no change";
  } else {
    evaluation.reason = "the change is smaller than its interval";
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
  if (std::isnan(measurement.half_width)) {
    evaluation.reason =
        fmt::format("one sample only, so no interval; the value lies {} the band", inside ? "inside" : "outside");
    return;
  }
  const double lower = measurement.value - measurement.half_width;
  const double upper = measurement.value + measurement.half_width;
  evaluation.interval = {lower, upper};
  if (band.contains(lower) && band.contains(upper)) {
    evaluation.verdict = Verdict::reproduced;
    evaluation.reason = measurement.half_width > 0.0 ? "the whole interval lies in the band" : "inside the band";
  } else if (upper < band.lower || lower > band.upper) {
    evaluation.verdict = Verdict::not_reproduced;
    evaluation.reason = measurement.half_width > 0.0 ? "the whole interval lies outside the band" : "outside the band";
  } else {
    evaluation.reason = "the interval straddles the edge of the band: more samples are needed";
  }
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

Evaluation evaluate_claim(const Claim& claim, const Measurements& measurements) {
  Evaluation evaluation;
  evaluation.claim = claim;
  std::vector<Measurement> values;
  std::string missing;
  for (const MeasureKey& measure : claim.measures) {
    const auto keys = expand(measure, measurements);
    bool found = !keys.empty();
    for (const MeasureKey& key : keys) {
      const auto entry = measurements.find(key);
      if (entry == measurements.end() || std::isnan(entry->second.value)) {
        found = false;
      } else {
        values.push_back(entry->second);
      }
    }
    if (found) continue;
    missing += (missing.empty() ? "" : "; ") + missing_text(claim, measure, measurements);
  }

  if (!missing.empty()) {
    evaluation.reason = missing;
  } else if (claim.measures.empty()) {
    evaluation.reason = claim.undecidable;
  } else if (of_both(values, Springs::own, Springs::softened)) {
    evaluation.reason =
        "runs with the paper's springs would be compared with softened ones: more of the former are needed";
  } else if (is_trend(claim)) {
    judge_trend(evaluation, values);
  } else {
    judge_band(evaluation, reduce(claim.reduction, values));
  }
  if (!claim.undecidable.empty()) {
    evaluation.verdict = Verdict::not_decidable;
    evaluation.reason = claim.undecidable;
  }
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
  for (TomlTable& entry : root.tables("claim")) {
    Claim claim = ClaimReader(entry, reference).read();
    claim.systems = systems;
    if (!ids.insert(claim.id).second) throw entry.problem("id", fmt::format("claim {} occurs twice", claim.id));
    claims.push_back(std::move(claim));
  }
  root.reject_others();
  if (claims.empty()) throw std::runtime_error(file.string() + ": no [[claim]] in it");
  return claims;
}

std::vector<Evaluation> evaluate(const std::vector<Claim>& claims, const Measurements& measurements) {
  std::vector<Evaluation> evaluations;
  evaluations.reserve(claims.size());
  for (const Claim& claim : claims) evaluations.push_back(evaluate_claim(claim, measurements));
  return evaluations;
}

ClaimCounts count(const std::vector<Evaluation>& evaluations) {
  ClaimCounts counts;
  for (const Evaluation& evaluation : evaluations) {
    counts.reproduced += evaluation.verdict == Verdict::reproduced;
    counts.not_reproduced += evaluation.verdict == Verdict::not_reproduced;
    counts.not_decidable += evaluation.verdict == Verdict::not_decidable;
    counts.gates_holding += evaluation.gate == Gate::holds;
    counts.gates_broken += evaluation.gate == Gate::broken;
  }
  return counts;
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
        {"reason", evaluation.reason},
    });
  }
  return {{"claims", std::move(list)}};
}

std::string claims_junit(const std::vector<Evaluation>& evaluations) {
  pugi::xml_document document;
  pugi::xml_node suite = document.append_child("testsuite");
  std::size_t tests = 0, failures = 0, skipped = 0;
  for (const Evaluation& evaluation : evaluations) {
    if (!evaluation.claim.regression_band && evaluation.gate == Gate::none) continue;
    ++tests;
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = evaluation.claim.figure.c_str();
    test.append_attribute("name") = evaluation.claim.id.c_str();
    if (evaluation.gate == Gate::broken) {
      ++failures;
      test.append_child("failure").append_attribute("message") = evaluation.reason.c_str();
    } else if (evaluation.gate == Gate::none) {
      ++skipped;
      test.append_child("skipped").append_attribute("message") = evaluation.reason.c_str();
    }
  }
  suite.append_attribute("name") = "slfb check";
  suite.append_attribute("tests") = tests;
  suite.append_attribute("failures") = failures;
  suite.append_attribute("skipped") = skipped;
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace slfb
