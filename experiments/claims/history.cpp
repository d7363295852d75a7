#include "experiments/claims/history.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "experiments/quantities/json_file.hpp"
#include "solver/support/files.hpp"

namespace slfb {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> number_in(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

/// [lower, upper], where null is an open side; nothing for null.
std::optional<std::pair<double, double>> ends_in(const Json& json) {
  if (json.is_null()) return std::nullopt;
  constexpr double open = std::numeric_limits<double>::infinity();
  return std::pair{number_in(json.at(0)).value_or(-open), number_in(json.at(1)).value_or(open)};
}

Json json_of(const std::optional<double>& value) { return value ? number_or_null(*value) : Json(nullptr); }
Json json_of(const std::optional<std::pair<double, double>>& ends) {
  return ends ? Json::array({number_or_null(ends->first), number_or_null(ends->second)}) : Json(nullptr);
}
std::optional<std::pair<double, double>> ends_of(const std::optional<Band>& band) {
  return band ? std::optional(std::pair{band->lower, band->upper}) : std::nullopt;
}

/// `value`, `band`: the names that the JSON has for them.
PastClaim claim_in(const Json& json, const char* value, const char* band) {
  PastClaim claim{json.at("unit").get<std::string>(),    number_in(json.at(value)),
                  ends_in(json.at("interval")),          {},
                  json.at("verdict").get<std::string>(), json.at("gate").get<std::string>()};
  if (const auto ends = ends_in(json.at(band))) claim.band = Band{ends->first, ends->second};
  return claim;
}

Json json_of(const HistoryEntry& entry) {
  Json claims = Json::object();
  for (const auto& [id, claim] : entry.claims)
    claims[id] = {{"unit", claim.unit},
                  {"value", json_of(claim.value)},
                  {"interval", json_of(claim.interval)},
                  {"band", json_of(ends_of(claim.band))},
                  {"verdict", claim.verdict},
                  {"gate", claim.gate}};
  return {{"version", entry.version}, {"commit", entry.commit},      {"date", entry.date},
          {"machine", entry.machine}, {"claims", std::move(claims)}, {"bench", entry.bench}};
}

HistoryEntry entry_in(const Json& json) {
  HistoryEntry entry{json.at("version").get<std::string>(),
                     json.at("commit").get<std::string>(),
                     json.at("date").get<std::string>(),
                     json.at("machine").get<std::string>(),
                     {},
                     {}};
  for (const auto& [id, claim] : json.at("claims").items()) entry.claims[id] = claim_in(claim, "value", "band");
  for (const auto& [name, time] : json.at("bench").items()) entry.bench[name] = time.get<double>();
  return entry;
}

}  // namespace

HistoryEntry history_entry(const Json& checked, const std::string& label) {
  HistoryEntry entry;
  if (checked.contains("made_by")) {
    const Json& made_by = checked.at("made_by");
    entry.version = made_by.at("version").get<std::string>();
    entry.commit = made_by.at("commit").get<std::string>();
    entry.date = made_by.at("date").get<std::string>();
    entry.machine = made_by.at("machine").get<std::string>();
  }
  if (entry.version.empty() && label.empty())
    throw std::runtime_error("does not say what made these results: --label names that version");
  if (!label.empty()) entry.version = label;
  for (const Json& claim : checked.at("claims"))
    entry.claims[claim.at("id").get<std::string>()] = claim_in(claim, "ours", "paper_band");
  return entry;
}

void add_bench(HistoryEntry& entry, const Json& measured) {
  for (const Json& result : measured.at("results")) {
    const auto threads = [&] { return whole_number(result.at("threads")); };
    if (result.contains("particle_steps_per_second"))
      entry.bench[fmt::format("particles, scene {}, {} threads [ns a particle-step]",
                              result.at("scene").get<std::string>(), threads())] =
          1e9 / result.at("particle_steps_per_second").get<double>();
    else if (result.contains("nanoseconds_per_cell_step"))
      entry.bench[fmt::format("liquid, {} cells across, {} threads [ns a cell-step]",
                              whole_number(result.at("cells_across")), threads())] =
          result.at("nanoseconds_per_cell_step").get<double>();
    else if (result.contains("wall_seconds_per_simulated_second"))
      entry.bench[fmt::format("coupled, case {}, {} threads [s a simulated second]",
                              result.at("case").get<std::string>(), threads())] =
          result.at("wall_seconds_per_simulated_second").get<double>();
    else
      throw std::runtime_error("has a result that is none of `slfb bench dem`, `fluid` or `coupled`");
  }
}

void append_to_history(const std::filesystem::path& file, const HistoryEntry& entry) {
  std::string text = std::filesystem::exists(file) ? read_file(file) : "";
  if (!text.empty() && text.back() != '\n') text += '\n';
  write_named_file(file, text + json_of(entry).dump() + "\n");
}

std::vector<HistoryEntry> load_history(const std::filesystem::path& file) {
  std::istringstream text(read_file(file));
  std::vector<HistoryEntry> entries;
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.empty()) continue;
    try {
      entries.push_back(entry_in(Json::parse(line)));
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}:{}: damaged, or not an entry of a history: {}", file.string(), number, error.what()));
    }
  }
  if (entries.empty()) throw std::runtime_error(fmt::format("{}: has no entry; --add adds one", file.string()));
  std::ranges::stable_sort(entries, {}, &HistoryEntry::date);
  return entries;
}

std::optional<PastChange> change_since(const PastClaim& before, const PastClaim& now) {
  if (!before.value || !now.value) return std::nullopt;
  PastChange change{*now.value - *before.value, {}, {}};
  if (*before.value != 0.0) change.relative = change.difference / std::abs(*before.value);
  constexpr double exact = 1e-9;
  if (std::abs(change.difference) <= exact * std::abs(*before.value)) {
    change.significance = 0.0;
  } else if (before.interval && now.interval) {
    // The ends that face each other.
    const bool up = change.difference > 0.0;
    const double own = up ? *now.value - now.interval->first : now.interval->second - *now.value;
    const double other = up ? before.interval->second - *before.value : *before.value - before.interval->first;
    change.significance = std::abs(change.difference) / std::hypot(own, other);
  }
  return change;
}

double significance_of_all(std::size_t comparisons) {
  constexpr double level = 0.05;
  return gsl_cdf_ugaussian_Qinv(0.5 * level / static_cast<double>(std::max<std::size_t>(1, comparisons))) /
         gsl_cdf_ugaussian_Qinv(0.5 * level);
}

std::optional<double> place_in_band(const PastClaim& claim) {
  if (!claim.value || !claim.band || !std::isfinite(claim.band->lower) || !std::isfinite(claim.band->upper) ||
      !(claim.band->upper > claim.band->lower))
    return std::nullopt;
  return (2.0 * *claim.value - claim.band->lower - claim.band->upper) / (claim.band->upper - claim.band->lower);
}

}  // namespace slfb
