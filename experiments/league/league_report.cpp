#include "experiments/league/league_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/figures/figure_folder.hpp"
#include "reports/gnuplot.hpp"
#include "reports/html.hpp"
#include "solver/support/files.hpp"

namespace slfb::league {
namespace {

using nlohmann::ordered_json;

const FigureFolder chart{"league/chart"};

std::string percent(double ratio) { return fmt::format("{:+.1f} %", 100.0 * ratio); }

/// A number that may not exist.
ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

/// With two or three groups the upper end says nothing.
std::string interval_text(const Statistic& found) {
  return found.spread_upper > 1.0
             ? fmt::format("from {:.1f} %", 100.0 * found.spread_lower)
             : fmt::format("{:.1f}-{:.1f} %", 100.0 * found.spread_lower, 100.0 * found.spread_upper);
}

bool is_marked(const std::string& law, const std::vector<std::string>& marked) {
  return std::ranges::any_of(marked, [&](const std::string& name) { return law == name || law == name + " + wall"; });
}

std::string bed_columns(const Table& table, const Standing& standing) {
  if (table.regime.kind != "bed") return "";
  return fmt::format("{:>+10.3f}{:>9.3f}{:>9.3f}", standing.mean_voidage_error, standing.root_mean_square_voidage_error,
                     standing.worst_voidage_error);
}

/// The laws of a chart from the bottom up: by their error in fluidised beds, formulas and drag laws together.
std::vector<std::string> chart_order(const Table& fluidised) {
  std::vector<std::string> order;
  std::set<std::string> known;
  for (const Standing& standing : fluidised.standings) {
    const std::string law = standing.law.substr(0, standing.law.find(" + "));
    if (known.insert(law).second) order.push_back(law);
  }
  std::ranges::reverse(order);
  return order;
}

const Table& table_named(const std::vector<Table>& tables, const std::string& id) {
  return *std::ranges::find(tables, id, [](const Table& table) { return table.regime.id; });
}

/// Bias and spread of the laws in a regime at their heights in the chart.
DataTable series(const Table& table, const std::vector<std::string>& order, const std::string& name, bool with_wall) {
  DataTable data{
      "league_" + name,
      {"bias less 1 [%]", "place [-]", "spread of the law [%]", "half width of the mean's 95 % interval [%]"},
      {}};
  for (std::size_t place = 0; place < order.size(); ++place)
    for (const Standing& standing : table.standings)
      if (standing.law == order[place] + (with_wall ? " + wall" : "") && standing.statistic.points > 0 &&
          standing.without_answer == 0)
        data.rows.push_back({100.0 * (standing.statistic.bias - 1.0), static_cast<double>(place + 1),
                             100.0 * standing.statistic.spread, 100.0 * standing.statistic.mean_half_width});
  return data;
}

std::vector<std::filesystem::path> draw_chart(const std::vector<Table>& tables, const std::filesystem::path& folder) {
  const std::vector<std::string> order = chart_order(table_named(tables, "fluidised"));
  std::vector<std::filesystem::path> files;
  PlotValues values;
  const auto add = [&](const std::string& variable, const std::string& id, bool with_wall) {
    const DataTable data = series(table_named(tables, id), order, id + (with_wall ? "_wall" : ""), with_wall);
    files.push_back(write_csv(data, folder));
    values.files(variable, {data.name});
  };
  add("fluidised", "fluidised", false);
  add("fluidised_wall", "fluidised", true);
  add("creeping", "settling-creeping", false);
  add("slow", "settling-slow", false);
  add("packed", "packed", false);
  values.texts("law", order);
  draw_plot("league", chart.plot(), values, {980, 136 + 22 * static_cast<int>(order.size())}, folder);
  return files;
}

std::string groups_text(const Statistic& statistic) {
  return fmt::format("{} points of {} kinds of spheres and liquid", statistic.points, statistic.groups);
}

}  // namespace

std::string tables_text(const std::vector<Table>& tables, std::size_t rows, const std::vector<std::string>& marked) {
  std::string text;
  for (const Table& table : tables) {
    if (table.standings.empty()) continue;
    const Statistic& first = table.standings.front().statistic;
    text += fmt::format("\n{}: {} points in {} groups, measured to {:.1f} %\n", table.regime.title, first.points,
                        first.groups, 100.0 * first.measured_spread);
    text += fmt::format(
        "  {:<4}{:<38}{:>9}{:>16}{:>9}{:>17}{:>9}{}\n", "", "law", "bias", "± 95 %", "spread", "95 %", "r.m.s.",
        table.regime.kind == "bed" ? fmt::format("{:>10}{:>9}{:>9}", "voidage", "r.m.s.", "worst") : "");
    for (std::size_t i = 0; i < table.standings.size(); ++i) {
      const Standing& standing = table.standings[i];
      const Statistic& found = standing.statistic;
      if (i >= rows && !is_marked(standing.law, marked)) continue;
      if (standing.without_answer > 0) {
        text += fmt::format("  {:<4}{:<38}  no answer at {} points\n", i + 1, standing.law, standing.without_answer);
        continue;
      }
      text += fmt::format("  {:<4}{:<38}{:>9}{:>16}{:>9}{:>17}{:>9}{}\n", i + 1, standing.law,
                          percent(found.bias - 1.0), fmt::format("{:.1f} %", 100.0 * found.mean_half_width),
                          fmt::format("{:.1f} %", 100.0 * found.spread), interval_text(found),
                          fmt::format("{:.1f} %", 100.0 * found.root_mean_square), bed_columns(table, standing));
    }
  }
  return text;
}

std::string evidence_text(const Bed& bed, const std::vector<Evidence>& evidence,
                          const std::vector<std::string>& marked) {
  if (evidence.empty()) return "no measured bed is near\n";
  constexpr double near = 0.1;
  std::string text = fmt::format(
      "For spheres of {:.4g} mm and {:.4g} kg/m³ in a liquid of {:.4g} kg/m³ and {:.4g} mPa s{} (Ar {:.3g}, terminal "
      "Re "
      "{:.3g}) the nearest measured beds are\n  {}\nSuperficial velocity at one voidage, law over measured, in these "
      "({}):\n",
      1e3 * bed.sphere.diameter, bed.sphere.density, bed.liquid.density, 1e3 * bed.liquid.viscosity,
      bed.tube_diameter > 0.0 ? fmt::format(" in a column of {:.4g} mm", 1e3 * bed.tube_diameter) : " without walls",
      bed.archimedes(), terminal_reynolds(bed), fmt::join(evidence.front().beds, ", "),
      groups_text(evidence.front().statistic));
  text += fmt::format("  {:<38}{:>16}{:>11}{:>9}\n", "law", "typically within", "at most", "mean");
  const auto line = [&](const Evidence& one) {
    text += fmt::format("  {:<38}{:>16}{:>11}{:>9}\n", one.law->name(),
                        fmt::format("{:.0f} %", 100.0 * one.statistic.root_mean_square),
                        fmt::format("{:.0f} %", 100.0 * one.largest), percent(std::expm1(one.statistic.mean)));
  };
  std::vector<std::string> within_20, within_30, beyond;
  std::size_t shown = 0;
  for (const Evidence& one : evidence) {
    const double error = one.statistic.root_mean_square;
    if (error <= near || shown < 3 || is_marked(one.law->name(), marked)) {
      line(one);
      ++shown;
    } else {
      (error <= 2.0 * near ? within_20 : error <= 3.0 * near ? within_30 : beyond).push_back(one.law->name());
    }
  }
  const auto list = [&](const std::string& title, const std::vector<std::string>& names) {
    if (!names.empty()) text += fmt::format("{}: {}\n", title, fmt::join(names, ", "));
  };
  list("Typically within 20 %", within_20);
  list("Typically within 30 %", within_30);
  list("Farther off", beyond);
  return text;
}

ordered_json tables_json(const std::vector<Table>& tables) {
  ordered_json json{{"tables", ordered_json::array()}};
  for (const Table& table : tables) {
    ordered_json laws = ordered_json::array();
    for (const Standing& standing : table.standings) {
      const Statistic& found = standing.statistic;
      ordered_json law{{"law", standing.law},
                       {"points", found.points},
                       {"groups", found.groups},
                       {"without_answer", standing.without_answer},
                       {"bias", number(found.bias)},
                       {"spread", number(found.spread)},
                       {"spread_interval", {number(found.spread_lower), number(found.spread_upper)}},
                       {"mean_log_ratio", number(found.mean)},
                       {"mean_half_width", number(found.mean_half_width)},
                       {"total_spread", number(found.total_spread)},
                       {"root_mean_square", number(found.root_mean_square)}};
      if (table.regime.kind == "bed") {
        law["voidage_error_mean"] = standing.mean_voidage_error;
        law["voidage_error_root_mean_square"] = standing.root_mean_square_voidage_error;
        law["voidage_error_worst"] = standing.worst_voidage_error;
      }
      laws.push_back(std::move(law));
    }
    json["tables"].push_back(
        {{"id", table.regime.id},
         {"title", table.regime.title},
         {"kind", table.regime.kind},
         {"measured_spread", table.standings.empty() ? 0.0 : table.standings.front().statistic.measured_spread},
         {"laws", std::move(laws)}});
  }
  return json;
}

ordered_json evidence_json(const std::vector<Evidence>& evidence) {
  ordered_json json = ordered_json::array();
  for (const Evidence& one : evidence)
    json.push_back({{"law", one.law->name()},
                    {"groups", one.statistic.groups},
                    {"points", one.statistic.points},
                    {"bias", number(one.statistic.bias)},
                    {"spread", number(one.statistic.spread)},
                    {"root_mean_square", number(one.statistic.root_mean_square)},
                    {"largest", one.largest},
                    {"beds", one.beds}});
  return json;
}

std::vector<std::filesystem::path> write_league(const std::vector<Table>& tables, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::string csv =
      "regime,law,points,groups,without answer,bias [-],spread of the law [-],lower end of its 95 % interval [-],upper "
      "end [-],spread of the measurements [-],root mean square [-],mean voidage error [-],root mean square voidage "
      "error "
      "[-],largest voidage error [-]\n";
  for (const Table& table : tables)
    for (const Standing& standing : table.standings) {
      const Statistic& found = standing.statistic;
      csv += fmt::format("{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},", table.regime.id, standing.law,
                         found.points, found.groups, standing.without_answer, found.bias, found.spread,
                         found.spread_lower, found.spread_upper, found.measured_spread, found.root_mean_square);
      csv += table.regime.kind == "bed"
                 ? fmt::format("{:.4f},{:.4f},{:.4f}\n", standing.mean_voidage_error,
                               standing.root_mean_square_voidage_error, standing.worst_voidage_error)
                 : ",,\n";
    }
  write_file(folder / "league.csv", csv);
  write_file(folder / "league.json", tables_json(tables).dump(2) + "\n");
  std::vector<std::filesystem::path> files = draw_chart(tables, folder);
  files.insert(files.begin(), folder / "league.csv");
  return files;
}

std::string places_html(const std::vector<Table>& tables, const std::vector<std::string>& laws) {
  std::string html =
      "<p>Each law against all measurements that the suite holds: its place among all laws, its bias, its spread and "
      "its "
      "root mean square. For beds the velocity at a measured voidage is compared, for packed beds the friction factor. "
      "\"+ wall\": with the factor 10<sup>-d/D</sup> of Richardson &amp; Zaki (1954).</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (const Table& table : tables)
    for (std::size_t i = 0; i < table.standings.size(); ++i) {
      const Standing& standing = table.standings[i];
      if (!is_marked(standing.law, laws)) continue;
      const Statistic& found = standing.statistic;
      rows.push_back({escape_html(table.regime.title), escape_html(standing.law),
                      fmt::format("{} of {}", i + 1, table.standings.size()),
                      standing.without_answer > 0 ? fmt::format("no answer at {} points", standing.without_answer)
                                                  : percent(found.bias - 1.0),
                      fmt::format("{:.1f} %", 100.0 * found.spread),
                      fmt::format("{:.1f} %", 100.0 * found.root_mean_square)});
    }
  return html + table_html({"measurements", "law", "place", "bias", "spread", "r.m.s."}, rows);
}

Figure figure() {
  return {
      "league", chart.title(), no_runs,
      [](const FigureContext& context) {
        const std::vector<Table> tables = league_tables();
        FigureOutput output{"league", write_league(tables, context.out), "", {}};
        const Standing& first = table_named(tables, "fluidised").standings.front();
        output.caption = chart.caption(
            {{"first", fmt::format("In fluidised beds {} is nearest: {} in the mean, {:.1f} % apart; voidage {:.3f} "
                                   "off (root mean square), at most {:.3f}.",
                                   first.law, percent(first.statistic.bias - 1.0), 100.0 * first.statistic.spread,
                                   first.root_mean_square_voidage_error, first.worst_voidage_error)}});
        return output;
      },
      chart.path().string()};
}

}  // namespace slfb::league
