#include "experiments/compare/comparison_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/html.hpp"
#include "solver/support/files.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string verdict_class(Verdict verdict) {
  std::string name(to_string(verdict));
  std::ranges::replace(name, ' ', '-');
  return name;
}

const char* change_class(Change change) {
  return change == Change::better ? "reproduced" : change == Change::worse ? "not-reproduced" : "not-decidable";
}

std::string answer_html(const Evaluation& evaluation, const Change* change) {
  if (!evaluation.ours) return "–";
  std::string text = fmt::format("<span class=\"number\">{}</span>", readable_number(*evaluation.ours));
  if (evaluation.interval && evaluation.interval->second > evaluation.interval->first)
    text += fmt::format("<span class=\"id number\">{} … {}</span>", readable_number(evaluation.interval->first),
                        readable_number(evaluation.interval->second));
  text += fmt::format("<span class=\"badge {}\">{}</span>", verdict_class(evaluation.verdict),
                      to_string(evaluation.verdict));
  if (change != nullptr)
    text += fmt::format(" <span class=\"badge {}\">{}</span>", change_class(*change), to_string(*change));
  return "<div>" + text + "</div>";
}

ordered_json number_or_null(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

}  // namespace

std::string badge_html(bool good, const std::string& word, const std::string& found) {
  return fmt::format("<div><span class=\"badge {}\">{} {}</span><span class=\"id\">{}</span></div>",
                     good ? "reproduced" : "not-reproduced", good ? "✓" : "✗", escape_html(word), escape_html(found));
}

Section property_section(const std::vector<std::string>& laws, const std::vector<std::vector<PropertyCheck>>& checks,
                         const std::string& introduction) {
  std::vector<std::string> headings{"Property"};
  for (const std::string& law : laws) headings.push_back(escape_html(law));
  std::vector<std::vector<std::string>> rows;
  for (std::size_t p = 0; p < checks[0].size(); ++p) {
    std::vector<std::string> row{escape_html(checks[0][p].property)};
    for (const auto& of_law : checks)
      row.push_back(badge_html(of_law[p].holds, of_law[p].holds ? "holds" : "does not", of_law[p].found));
    rows.push_back(std::move(row));
  }
  return {"properties", "Properties", "<p>" + escape_html(introduction) + "</p>\n" + table_html(headings, rows)};
}

Section range_section(const std::vector<RangeNotes>& notes) {
  std::string html;
  for (const RangeNotes& note : notes)
    for (const std::string& sentence : note.sentences)
      html += fmt::format("<li><b>{}</b>: {}</li>\n", escape_html(note.law), prose_html(sentence));
  return {"ranges", "Outside their ranges",
          html.empty() ? "<p>No law is used outside the range that it states for itself.</p>\n"
                       : "<p>A law gives a number outside its range too, but its source does not claim that it holds "
                         "there.</p>\n<ul>\n" +
                             html + "</ul>\n"};
}

Section failure_section(const std::vector<std::string>& failures) {
  std::string html = "<p>These simulations failed; nothing of them is drawn.</p>\n<ul>\n";
  for (const std::string& failure : failures) html += "<li>" + escape_html(failure) + "</li>\n";
  return {"failures", "What failed", html + "</ul>\n"};
}

std::string time_html(const std::string& what, const std::vector<std::string>& laws,
                      const std::vector<double>& seconds) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < laws.size(); ++i)
    rows.push_back({escape_html(laws[i]), fmt::format("{:.1f} ns", 1e9 * seconds[i]),
                    fmt::format("{:.2f}", seconds[i] / seconds[0])});
  return "<p>" + escape_html(what) + "</p>\n" + table_html({"Law", "Time", "Beside the first"}, rows);
}

std::string pictures_html(const std::vector<Picture>& pictures) {
  std::string html;
  for (const Picture& picture : pictures)
    html += fmt::format(
        "<article class=\"card figure wide\" id=\"{0}\"><div class=\"picture\"><a href=\"figures/{0}.svg\"><img "
        "src=\"figures/{0}.svg\" alt=\"{1}\" loading=\"lazy\" /></a></div><div "
        "class=\"words\"><h3>{1}</h3><p>{2}</p><div class=\"files\"><a href=\"figures/{0}.svg\">svg</a><a "
        "href=\"figures/{0}.png\">png</a><a href=\"figures/{0}.csv\">csv</a><a "
        "href=\"figures/{0}.gp\">gp</a></div></div></article>\n",
        escape_html(picture.id), prose_html(picture.title), prose_html(picture.caption));
  return html;
}

Section claims_section(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims) {
  std::vector<std::string> headings{"Claim", "Paper"};
  for (const Candidate& candidate : candidates) headings.push_back(escape_html(candidate.name));
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < claims.size(); ++k) {
    if (!answered(candidates, k)) continue;
    const std::string unit = claims[k].unit == "-" ? "" : fmt::format(" {}", escape_html(claims[k].unit));
    std::vector<std::string> row{
        fmt::format("{}<span class=\"id\">{}</span>", prose_html(claims[k].quantity), escape_html(claims[k].id)),
        prose_html(claims[k].paper_text()) + unit};
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Change changed = change(candidates[0].evaluations[k], candidates[i].evaluations[k]);
      row.push_back(answer_html(candidates[i].evaluations[k], i == 0 ? nullptr : &changed));
    }
    rows.push_back(std::move(row));
  }
  std::string html = fmt::format(
      "<p>What the paper states and what each candidate gives, with 95 % intervals. Beside the first, <b>{}</b>, a "
      "candidate is better or worse where it lies nearer to or farther from the paper's number by more than both "
      "intervals together; a trend goes by its verdict; the rest is the same, or undecided where a single sample has "
      "no "
      "interval. {} of {} claims of simulations are answered here; the others need other runs.</p>\n",
      escape_html(candidates[0].name), rows.size(), claims.size());
  std::vector<std::vector<std::string>> summary;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    auto counts = count_changes(candidates[0], candidates[i]);
    const auto number = [&](Change which) { return fmt::format("{}", counts[which]); };
    summary.push_back({escape_html(candidates[i].name), number(Change::better), number(Change::worse),
                       number(Change::same), number(Change::undecided)});
  }
  html += table_html({"Candidate", "Better", "Worse", "Same", "Undecided"}, summary) + table_html(headings, rows);
  return {"claims", "Claims side by side", html};
}

Section cost_section(const std::vector<Candidate>& candidates, const std::string& extra_html) {
  std::vector<std::vector<std::string>> rows;
  const auto cost = [](const Candidate& candidate) { return candidate.core_seconds / candidate.simulated_seconds; };
  for (const Candidate& candidate : candidates) {
    if (candidate.runs == 0) continue;
    rows.push_back({escape_html(candidate.name), fmt::format("{}", candidate.runs),
                    readable_duration(candidate.core_seconds), fmt::format("{:.3g} s", cost(candidate)),
                    fmt::format("{:.2f}", cost(candidate) / cost(candidates[0]))});
  }
  const std::string runs =
      rows.empty()
          ? "<p>Nothing was simulated in this tier.</p>\n"
          : table_html({"Candidate", "Runs", "Core time", "Core time per simulated second", "Beside the first"}, rows);
  return {"cost", "What it costs", extra_html + runs};
}

ordered_json candidates_json(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims) {
  ordered_json answer;
  for (const Candidate& candidate : candidates)
    answer["candidates"].push_back({{"name", candidate.name},
                                    {"overrides", candidate.overrides},
                                    {"runs", candidate.runs},
                                    {"core_seconds", candidate.core_seconds},
                                    {"simulated_seconds", candidate.simulated_seconds}});
  answer["claims"] = ordered_json::array();
  for (std::size_t k = 0; k < claims.size(); ++k) {
    if (!answered(candidates, k)) continue;
    ordered_json row{{"id", claims[k].id}, {"paper", claims[k].paper_text()}, {"unit", claims[k].unit}};
    for (const Candidate& candidate : candidates) {
      const Evaluation& evaluation = candidate.evaluations[k];
      ordered_json& cell = row["answers"][candidate.name];
      cell["ours"] = evaluation.ours ? number_or_null(*evaluation.ours) : ordered_json(nullptr);
      cell["interval"] = evaluation.interval ? ordered_json{number_or_null(evaluation.interval->first),
                                                            number_or_null(evaluation.interval->second)}
                                             : ordered_json(nullptr);
      cell["verdict"] = to_string(evaluation.verdict);
      cell["change"] = to_string(change(candidates[0].evaluations[k], evaluation));
    }
    answer["claims"].push_back(std::move(row));
  }
  return answer;
}

void write_claims_csv(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims,
                      const fs::path& folder) {
  std::string text = "claim,paper,unit,candidate,ours,lower,upper,verdict,change\n";
  const auto number = [](double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : "NaN"; };
  for (std::size_t k = 0; k < claims.size(); ++k) {
    if (!answered(candidates, k)) continue;
    for (const Candidate& candidate : candidates) {
      const Evaluation& evaluation = candidate.evaluations[k];
      const double none = std::nan("");
      const auto [lower, upper] = evaluation.interval.value_or(std::pair{none, none});
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", claims[k].id, claims[k].paper_text(), claims[k].unit,
                          candidate.name, number(evaluation.ours.value_or(none)), number(lower), number(upper),
                          to_string(evaluation.verdict), to_string(change(candidates[0].evaluations[k], evaluation)));
    }
  }
  write_file(folder / "claims.csv", text);
}

void write_page(const std::string& title, const std::string& introduction, const std::vector<Section>& sections,
                const fs::path& folder) {
  std::string links, body;
  for (const Section& section : sections) {
    links += fmt::format("<a href=\"#{}\">{}</a>", section.id, section.title);
    body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.id, section.title, section.html);
  }
  write_file(folder / "index.html",
             html_page(escape_html(title),
                       fmt::format("<header class=\"masthead\"><div>\n<h1>{}</h1>\n{}</div></header>\n<nav><div>{}"
                                   "</div></nav>\n<main>\n{}</main>\n",
                                   escape_html(title), introduction, links, body)));
}

}  // namespace slfb::compare
