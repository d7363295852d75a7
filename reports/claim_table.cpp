#include "reports/claim_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "reports/html.hpp"

namespace slfb {
namespace {

std::string percentage(double fraction) {
  if (std::fabs(fraction) < 5e-4) return "0.0 %";
  return fmt::format("{}{:.1f} %", fraction < 0.0 ? "−" : "+", std::fabs(100.0 * fraction));
}

std::string band_text(const Band& band) {
  if (std::isinf(band.lower)) return "≤ " + readable_number(band.upper);
  if (std::isinf(band.upper)) return "≥ " + readable_number(band.lower);
  return readable_number(band.lower) + " … " + readable_number(band.upper);
}

/// What the paper says, with its unit where it is a number.
std::string paper_side(const Claim& claim) {
  const std::string text = prose_html(claim.paper_text());
  const bool in_words = claim.kind == StatementKind::increasing || claim.kind == StatementKind::decreasing ||
                        claim.kind == StatementKind::words;
  return in_words ? text : with_unit(text, claim.unit);
}

std::string claim_row(const Evaluation& evaluation) {
  const Claim& claim = evaluation.claim;
  std::string ours, interval, deviation;
  if (evaluation.ours) ours = with_unit(readable_number(*evaluation.ours), claim.unit);
  if (evaluation.interval && evaluation.interval->second > evaluation.interval->first)
    interval = fmt::format("<span class=\"id number\">{} … {}</span>", readable_number(evaluation.interval->first),
                           readable_number(evaluation.interval->second));
  if (evaluation.deviation) deviation = percentage(*evaluation.deviation);
  std::string band;
  if (claim.paper_band)
    band = fmt::format("<span class=\"id\">band <span class=\"number\">{}</span></span>", band_text(*claim.paper_band));
  const std::string gate =
      evaluation.gate == Gate::broken ? " <span class=\"badge not-reproduced\">gate broken</span>" : "";
  return fmt::format(
      "<tr id=\"{0}\" data-verdict=\"{1}\" data-figure=\"{2}\"><td class=\"lead\">{3}<span class=\"id\">{0} · "
      "{4}</span>"
      "</td><td data-label=\"Verdict\"><div><span class=\"badge {1}\">{5} {6}</span>{7}</div></td><td "
      "data-label=\"Paper\">"
      "<div>{8}{9}</div></td>{10}{11}<td class=\"reason\" data-label=\"Reason\">{12}</td>"
      "</tr>\n",
      escape_html(claim.id), verdict_class(evaluation.verdict), escape_html(claim.figure), prose_html(claim.quantity),
      escape_html(claim.source), verdict_sign(evaluation.verdict), to_string(evaluation.verdict), gate,
      paper_side(claim), band,
      ours.empty()
          ? "<td data-label=\"Ours\"></td>"
          : fmt::format("<td data-label=\"Ours\"><div><span class=\"number\">{}</span>{}</div></td>", ours, interval),
      deviation.empty() ? "<td data-label=\"Deviation\"></td>"
                        : fmt::format("<td data-label=\"Deviation\"><span class=\"number\">{}</span></td>", deviation),
      prose_html(evaluation.reason));
}

}  // namespace

ClaimGroups claims_by_place(const std::vector<Evaluation>& evaluations) {
  ClaimGroups groups;
  for (const auto& evaluation : evaluations) {
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& group) { return group.first == evaluation.claim.figure; });
    if (known == groups.end()) {
      groups.push_back({evaluation.claim.figure, {&evaluation}});
    } else {
      known->second.push_back(&evaluation);
    }
  }
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return groups;
}

std::string place_in_paper(const std::string& name) {
  const auto digits = name.find_first_of("0123456789");
  const std::string word = name.substr(0, digits);
  if (digits == std::string::npos) {
    std::string capital = name;
    if (!capital.empty()) capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(capital[0])));
    return escape_html(capital);
  }
  const std::string number = std::to_string(std::stoi(name.substr(digits)));
  if (word == "fig") return "Figure " + number;
  if (word == "table") return "Table " + number;
  return escape_html(name);
}

std::string verdict_class(Verdict verdict) {
  std::string name(to_string(verdict));
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

const char* verdict_sign(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "✓";
    case Verdict::not_reproduced:
      return "✗";
    case Verdict::not_decidable:
      return "?";
  }
  return "?";
}

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit == "-" || unit.empty() ? text : text + " " + escape_html(unit);
}

std::string claim_table(const std::vector<const Evaluation*>& evaluations, const std::string& body_id) {
  std::string html = fmt::format(
      "<div class=\"card scroll\"><table class=\"stack "
      "claims\">\n<thead><tr><th>Claim</th><th>Verdict</th><th>Paper</th>"
      "<th>Ours</th><th>Deviation</th><th>Reason</th></tr></thead>\n<tbody{}>\n",
      body_id.empty() ? "" : fmt::format(" id=\"{}\"", body_id));
  for (const Evaluation* evaluation : evaluations) html += claim_row(*evaluation);
  return html + "</tbody></table></div>\n";
}

}  // namespace slfb
