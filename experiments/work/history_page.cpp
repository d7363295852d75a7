#include "experiments/work/history_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "reports/html.hpp"
#include "reports/sparkline.hpp"

namespace slfb {
namespace {

bool another_verdict(const HistoryRow& row) {
  return row.before && (row.before->verdict != row.now.verdict || row.before->gate != row.now.gate);
}

bool changed(const HistoryRow& row) {
  const auto differs = [](const std::optional<PastChange>& change) {
    return change && (!change->significance || *change->significance > 0.0);
  };
  return another_verdict(row) || differs(row.since_before) || differs(row.since_first);
}

double rank(const HistoryRow& row) {
  const auto of = [](const std::optional<PastChange>& change) {
    return change ? change->significance.value_or(0.0) : -1.0;
  };
  return (another_verdict(row) ? 1e6 : 0.0) + std::min(1e5, std::max(of(row.since_before), of(row.since_first)));
}

std::string number_text(const std::optional<double>& value) { return value ? fmt::format("{:.5g}", *value) : "–"; }

/// "+2.1 % (0.6)": size, and significance in brackets.
std::string change_text(const std::optional<PastChange>& change) {
  if (!change) return "–";
  if (change->significance && *change->significance == 0.0) return "none";
  std::string text = change->relative ? fmt::format("{:+.2g} %", 100.0 * *change->relative)
                                      : fmt::format("{:+.3g}", change->difference);
  if (!change->significance) return text + " (?)";
  return text + (std::isinf(*change->significance) ? std::string(" (exact)")
                                                   : fmt::format(" ({:.2g})", *change->significance));
}

std::string verdict_text(const HistoryRow& row) {
  const std::string now = row.now.verdict + (row.now.gate == "none" ? "" : ", gate " + row.now.gate);
  if (!another_verdict(row)) return now;
  return row.before->verdict + (row.before->gate == "none" ? "" : ", gate " + row.before->gate) + " → " + now;
}

std::string band_text(const PastClaim& claim) {
  const auto place = place_in_band(claim);
  return place ? fmt::format("{:.0f} %", 100.0 * std::abs(*place)) : "–";
}

std::size_t count_of(const HistoryEntry& entry, std::string PastClaim::*member, std::string_view word) {
  return static_cast<std::size_t>(
      std::ranges::count_if(entry.claims, [&](const auto& one) { return one.second.*member == word; }));
}

std::vector<std::string> entry_cells(const HistoryEntry& entry) {
  return {entry.date,
          entry.version,
          entry.commit,
          entry.machine,
          fmt::format("{}", count_of(entry, &PastClaim::verdict, "reproduced")),
          fmt::format("{}", count_of(entry, &PastClaim::verdict, "not reproduced")),
          fmt::format("{}", count_of(entry, &PastClaim::verdict, "not decidable")),
          fmt::format("{}", count_of(entry, &PastClaim::gate, "broken"))};
}

const std::vector<std::string> entry_headings{"date",       "version",        "commit",        "machine",
                                              "reproduced", "not reproduced", "not decidable", "gates broken"};

const std::string legend =
    "Size of a change, and in brackets its significance: the difference over the half width of its own 95 % interval. "
    "Above {:.2f} it is no chance, at 5 % for all {} claims together; (exact) differs without any interval, (?) is a "
    "single sample. Band: how much of the way from the middle of the paper's band to its edge.";

std::string claim_picture(const std::vector<HistoryEntry>& entries, const HistoryRow& row) {
  std::vector<reports::SparkPoint> points;
  for (const HistoryEntry& entry : entries) {
    const auto found = entry.claims.find(row.name);
    points.push_back(found == entry.claims.end() ? reports::SparkPoint{}
                                                 : reports::SparkPoint{found->second.value, found->second.interval});
  }
  const auto band = row.now.band ? std::optional(std::pair{row.now.band->lower, row.now.band->upper}) : std::nullopt;
  return reports::sparkline(
      points, band, fmt::format("{} over {} entries, {} now", row.name, entries.size(), number_text(row.now.value)));
}

/// Times over that of the first entry of the same machine.
std::string bench_html(const std::vector<HistoryEntry>& entries) {
  std::vector<std::vector<std::string>> rows;
  std::set<std::pair<std::string, std::string>> series;
  for (const HistoryEntry& entry : entries)
    for (const auto& [name, time] : entry.bench) series.emplace(name, entry.machine);
  for (const auto& [name, machine] : series) {
    std::vector<reports::SparkPoint> points;
    double first = 0.0, last = 0.0;
    for (const HistoryEntry& entry : entries) {
      const auto found = entry.bench.find(name);
      if (entry.machine != machine || found == entry.bench.end()) continue;
      if (points.empty()) first = found->second;
      last = found->second;
      points.push_back({last / first, {}});
    }
    rows.push_back(
        {escape_html(name), escape_html(machine), readable_number(last), fmt::format("{:.2f}", last / first),
         reports::sparkline(points, std::pair{0.9, 1.1}, fmt::format("{}: {:.2f} of the first", name, last / first))});
  }
  if (rows.empty()) return "";
  return "<h2>Computing time</h2>\n<p>Over that of the first entry of the same machine; the band is 10 % on either "
         "side.</p>\n" +
         table_html({"what", "machine", "now", "over the first", "over the entries"}, rows);
}

}  // namespace

std::vector<HistoryRow> history_rows(const std::vector<HistoryEntry>& entries) {
  std::vector<HistoryRow> rows;
  for (const auto& [id, now] : entries.back().claims) {
    HistoryRow row{id, now, {}, {}, {}, {}};
    for (std::size_t k = 0; k + 1 < entries.size(); ++k)
      if (const auto found = entries[k].claims.find(id); found != entries[k].claims.end()) {
        row.before = found->second;
        if (!row.first) row.first = found->second;
      }
    if (row.before) row.since_before = change_since(*row.before, now);
    if (row.first) row.since_first = change_since(*row.first, now);
    rows.push_back(std::move(row));
  }
  const double limit = significance_of_all(rows.size());
  for (HistoryRow& row : rows)
    for (const auto& change : {row.since_before, row.since_first})
      row.significant = row.significant || (change && change->significance.value_or(0.0) > limit);
  std::ranges::stable_sort(rows, std::greater{}, rank);
  return rows;
}

std::string history_text(const std::vector<HistoryEntry>& entries) {
  std::string text;
  for (const HistoryEntry& entry : entries)
    text +=
        fmt::format("{:<20}  {:<12}  {:<18}  {} reproduced, {} not, {} not decidable, {} gates broken\n", entry.date,
                    entry.version, entry.commit, count_of(entry, &PastClaim::verdict, "reproduced"),
                    count_of(entry, &PastClaim::verdict, "not reproduced"),
                    count_of(entry, &PastClaim::verdict, "not decidable"), count_of(entry, &PastClaim::gate, "broken"));
  const std::vector<HistoryRow> rows = history_rows(entries);
  const auto number = static_cast<std::size_t>(std::ranges::count_if(rows, changed));
  if (number > 0) {
    text += fmt::format("\n{:<40} {:>12} {:>18} {:>18} {:>6}  {}\n", "claim", "now", "since the last",
                        "since the first", "band", "verdict");
    for (const HistoryRow& row : rows)
      if (changed(row))
        text += fmt::format("{:<40} {:>12} {:>18} {:>18} {:>6}  {}{}\n", row.name, number_text(row.now.value),
                            change_text(row.since_before), change_text(row.since_first), band_text(row.now),
                            verdict_text(row), row.significant ? "  SIGNIFICANT" : "");
    text += "\n" + fmt::format(fmt::runtime(legend), significance_of_all(rows.size()), rows.size()) + "\n";
  }
  return text + fmt::format("\n{} of {} claims changed, {} of them significantly\n", number, rows.size(),
                            std::ranges::count_if(rows, &HistoryRow::significant));
}

std::string history_html(const std::vector<HistoryEntry>& entries) {
  std::vector<std::vector<std::string>> list;
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    std::vector<std::string>& cells = list.emplace_back();
    for (const std::string& cell : entry_cells(*entry)) cells.push_back(escape_html(cell));
  }
  const std::vector<HistoryRow> rows = history_rows(entries);
  std::vector<std::vector<std::string>> claims;
  for (const HistoryRow& row : rows)
    claims.push_back({escape_html(row.name), claim_picture(entries, row),
                      escape_html(fmt::format("{} {}", number_text(row.now.value), row.now.unit)),
                      escape_html(change_text(row.since_before)) + (row.significant ? " <b>significant</b>" : ""),
                      escape_html(change_text(row.since_first)), band_text(row.now), escape_html(verdict_text(row))});
  const std::string title = "Deviations over time";
  return html_page(
      title, fmt::format("<header class=\"masthead\"><div>\n<h1>{}</h1>\n<p>{} entries, {} to {}.</p></div></header>\n"
                         "<main>\n<section>\n<h2>Entries</h2>\n{}<h2>Claims</h2>\n<p>{}</p>\n{}{}</section>\n</main>\n",
                         title, entries.size(), escape_html(entries.front().date), escape_html(entries.back().date),
                         table_html(entry_headings, list),
                         escape_html(fmt::format(fmt::runtime(legend), significance_of_all(rows.size()), rows.size())),
                         table_html({"claim", "over the entries", "now", "since the last", "since the first", "band",
                                     "verdict"},
                                    claims),
                         bench_html(entries)));
}

}  // namespace slfb
