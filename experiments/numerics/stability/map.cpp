#include "experiments/numerics/stability/map.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "experiments/quantities/json_file.hpp"
#include "experiments/runs/stop_signals.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::stability {
namespace {

using nlohmann::ordered_json;
using studies::Set;
using studies::Trial;
using studies::TrialResult;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view quantity_prefix = "quantity:";

std::filesystem::path folder() { return source_folder() / "experiments" / "numerics" / "stability"; }

struct Verdict {
  bool holds;
  std::string diagnosis;
};

Verdict judge(const Map& map, const MapSeries& series, const TrialResult& result) {
  if (!result.failure.empty()) return {false, result.failure};
  const double value = result.values.at(map.quantity).value;
  const bool fails = !std::isfinite(value) || (map.fails_above ? value > series.limit : value < series.limit);
  return {!fails, fails ? fmt::format("{} = {:.3g}, limit {:g}", map.quantity, value, series.limit) : ""};
}

constexpr std::array kinds{"found", "never fails", "always fails"};

/// What save_solved wrote; no boundaries where there is no file.
SolvedMap load_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  return read_json(file, "a solved map", [](const ordered_json& json) {
    SolvedMap solved;
    solved.set = json.at("set");
    solved.machine = json.at("machine");
    solved.date = json.at("date");
    solved.numerics = static_cast<int>(whole_number(json.at("numerics")));
    for (const auto& one : json.at("boundaries")) {
      Boundary b;
      b.series = one.at("series");
      b.x = one.at("x");
      const auto kind = std::ranges::find(kinds, one.at("kind").get<std::string>());
      if (kind == kinds.end()) throw std::runtime_error("unknown kind of a boundary");
      b.kind = static_cast<BoundaryKind>(kind - kinds.begin());
      b.y = one.at("y");
      b.low = one.at("low");
      b.high = one.at("high");
      b.trials = static_cast<int>(whole_number(one.at("trials")));
      b.diagnosis = one.at("diagnosis");
      for (const auto& value : one.at("theory")) b.theory.push_back(number_or_nan(value));
      solved.boundaries.push_back(std::move(b));
    }
    return solved;
  });
}

}  // namespace

Trial Map::trial(const MapSeries& of, double x, double y) const {
  std::vector<std::string> all = settings;
  all.insert(all.end(), of.settings.begin(), of.settings.end());
  for (const std::string& setting : x_settings) all.push_back(studies::fill_in(setting, x));
  for (const std::string& setting : y_settings) all.push_back(studies::fill_in(setting, y));
  return {problem, all, 0};
}

std::vector<std::filesystem::path> map_files() { return toml_files(folder() / "maps"); }

std::filesystem::path map_file(const std::string& id) { return folder() / "maps" / (id + ".toml"); }

Map load_map(const std::filesystem::path& file, Set set) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  Map map;
  map.id = file.stem().string();
  map.title = table.text("title");
  map.caption = table.text("caption");
  map.problem = table.text("problem");
  map.settings = table.texts("settings");
  map.tolerance = table.number("tolerance", 0.05);
  TomlTable x = table.table("x");
  map.x_label = x.text("label");
  map.x_settings = x.texts("set");
  map.x_values = x.numbers("values");
  const auto quick = x.numbers("quick_values");
  if (set == Set::quick && !quick.empty()) map.x_values = quick;
  map.x_logarithmic = !x.flag("linear");
  x.reject_others();
  TomlTable y = table.table("y");
  map.y_label = y.text("label");
  map.y_settings = y.texts("set");
  map.y_low = y.number("low");
  map.y_high = y.number("high");
  const std::string side = y.text("fails_at", "high");
  if (side != "high" && side != "low") throw y.problem("fails_at", "must be \"high\" or \"low\"");
  map.fails_high = side == "high";
  if (!(map.y_low > 0.0 && map.y_high > map.y_low)) throw y.problem("low", "must lie above 0 and below high");
  y.reject_others();
  TomlTable criterion = table.table("criterion");
  map.quantity = criterion.text("quantity");
  studies::find_quantity(studies::find_problem(map.problem), map.quantity);
  map.criterion_text = criterion.text("text");
  const std::string fails = criterion.text("fails", "above");
  if (fails != "above" && fails != "below") throw criterion.problem("fails", "must be \"above\" or \"below\"");
  map.fails_above = fails == "above";
  const double limit = criterion.number("limit");
  criterion.reject_others();
  for (TomlTable& series : table.tables("series")) {
    const bool full_only = series.flag("full_only");
    MapSeries one{series.text("name"), series.texts("settings"), series.number("limit", limit)};
    series.reject_others();
    if (!full_only || set == Set::full) map.series.push_back(std::move(one));
  }
  for (TomlTable& theory : table.tables("theory")) {
    Theory one{theory.text("name"), theory.text("formula"), theory.number("value", nothing), theory.texts("settings")};
    theory.reject_others();
    const auto known = theory_formulas();
    if (one.formula != "value" && !one.formula.starts_with(quantity_prefix) &&
        std::find(known.begin(), known.end(), one.formula) == known.end())
      throw theory.problem("formula", "is not known");
    map.theories.push_back(std::move(one));
  }
  for (TomlTable& mark : table.tables("mark")) {
    map.marks.push_back({mark.number("x"), mark.number("y"), mark.text("text")});
    mark.reject_others();
  }
  table.reject_others();
  for (const MapSeries& series : map.series)
    for (const double value : map.x_values) {
      try {
        for (const double end : {map.y_low, map.y_high}) map.trial(series, value, end).check();
      } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
      }
    }
  return map;
}

std::optional<Boundary> find_boundary(const Map& map, const MapSeries& series, double x,
                                      const studies::TrialStore& store, const std::function<bool()>& stop) {
  Boundary boundary;
  boundary.series = series.name;
  boundary.x = x;
  TrialResult last_that_held;
  bool stopped = false;
  const auto holds = [&](double y) {
    if (stop && stop()) {
      stopped = true;
      return false;
    }
    const Trial trial = map.trial(series, x, y);
    auto result = store.find(trial);
    if (!result) {
      result = studies::solve(trial);
      store.keep(trial, *result);
    }
    ++boundary.trials;
    const Verdict verdict = judge(map, series, *result);
    if (verdict.holds)
      last_that_held = *result;
    else
      boundary.diagnosis = verdict.diagnosis;
    return verdict.holds;
  };
  // `good` on the side where methods hold, `bad` on the other.
  double good = map.fails_high ? map.y_low : map.y_high, bad = map.fails_high ? map.y_high : map.y_low;
  if (!holds(good)) {
    boundary.kind = BoundaryKind::always_fails;
    boundary.y = good;
  } else if (holds(bad)) {
    boundary.kind = BoundaryKind::never_fails;
    boundary.y = bad;
  } else {
    while (!stopped && std::max(good / bad, bad / good) > 1.0 + map.tolerance) {
      const double middle = std::sqrt(good * bad);
      (holds(middle) ? good : bad) = middle;
    }
    boundary.y = std::sqrt(good * bad);
  }
  if (stopped) return std::nullopt;
  boundary.low = std::min(good, bad);
  boundary.high = std::max(good, bad);
  for (const Theory& theory : map.theories) {
    double value = nothing;
    if (theory.formula == "value") {
      value = theory.value;
    } else if (theory.formula.starts_with(quantity_prefix)) {
      const auto found = last_that_held.values.find(theory.formula.substr(quantity_prefix.size()));
      if (found != last_that_held.values.end()) value = found->second.value;
    } else {
      Trial trial = map.trial(series, x, boundary.y);
      trial.settings.insert(trial.settings.end(), theory.settings.begin(), theory.settings.end());
      value = theory_value(theory.formula, trial.scene(), trial.parameters());
    }
    boundary.theory.push_back(value);
  }
  return boundary;
}

std::filesystem::path committed_file(const std::string& id) { return folder() / "results" / (id + ".json"); }

std::size_t boundaries_of(const Map& map) { return map.series.size() * map.x_values.size(); }

MapAnswer solve_map(const Map& map, studies::Set set, const std::filesystem::path& out, int jobs,
                    const std::function<void(const Boundary&)>& found) {
  MapAnswer answer{{{map.id, studies::name_of(set), "", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))),
                     numerics_version},
                    {}}};
  const studies::TrialStore store(out / "trials");
  const StopSignals signals;
  std::vector<std::optional<Boundary>> boundaries(boundaries_of(map));
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::size_t i = next++; i < boundaries.size(); i = next++) {
      try {
        boundaries[i] = find_boundary(map, map.series[i / map.x_values.size()], map.x_values[i % map.x_values.size()],
                                      store, [&] { return signals.requested().load(); });
        const std::lock_guard lock(mutex);
        if (boundaries[i] && found) found(*boundaries[i]);
      } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
        next = boundaries.size();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int job = 0; job < jobs; ++job) threads.emplace_back(work);
  }
  if (error) std::rethrow_exception(error);
  for (auto& boundary : boundaries) {
    if (boundary)
      answer.solved.boundaries.push_back(std::move(*boundary));
    else
      answer.whole = false;
  }
  if (answer.whole) {
    std::filesystem::create_directories(out / "stability");
    save_solved(answer.solved, solved_file(out, map.id));
  }
  return answer;
}

std::filesystem::path solved_file(const std::filesystem::path& out, const std::string& id) {
  return out / "stability" / (id + ".json");
}

void save_solved(const SolvedMap& solved, const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  ordered_json json{{"map", solved.id},    {"set", solved.set},           {"machine", solved.machine},
                    {"date", solved.date}, {"numerics", solved.numerics}, {"boundaries", ordered_json::array()}};
  for (const Boundary& b : solved.boundaries) {
    ordered_json theory = ordered_json::array();
    for (const double value : b.theory) theory.push_back(number_or_null(value));
    json["boundaries"].push_back({{"series", b.series},
                                  {"x", b.x},
                                  {"kind", kinds[static_cast<std::size_t>(b.kind)]},
                                  {"y", b.y},
                                  {"low", b.low},
                                  {"high", b.high},
                                  {"trials", b.trials},
                                  {"diagnosis", b.diagnosis},
                                  {"theory", theory}});
  }
  write_file(file, json.dump(1) + "\n");
}

SolvedMap load_solved(const Map& map, const std::filesystem::path& out) {
  SolvedMap own = load_file(solved_file(out, map.id)), committed = load_file(committed_file(map.id));
  SolvedMap drawn = committed_is_better(own, committed) ? std::move(committed) : std::move(own);
  drawn.id = map.id;
  return drawn;
}

SolvedMap load_beside(const Map& map, const std::filesystem::path& out) {
  SolvedMap own = load_file(solved_file(out, map.id));
  return committed_is_better(own, load_file(committed_file(map.id))) ? own : SolvedMap{};
}

}  // namespace slfb::stability
