#include "reports/claim_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <stdexcept>

#include "reports/html.hpp"

namespace slfb::reports {
namespace {

std::string percentage(double fraction) {
  if (std::fabs(fraction) < 5e-4) return "0.0 %";
  return fmt::format("{}{:.1f} %", fraction < 0.0 ? "−" : "+", std::fabs(100.0 * fraction));
}

std::string band_text(const std::pair<double, double>& band) {
  const auto [lower, upper] = band;
  if (std::isinf(lower)) return "≤ " + readable_number(upper);
  if (std::isinf(upper)) return "≥ " + readable_number(lower);
  return readable_number(lower) + " … " + readable_number(upper);
}

/// What the work states, with its unit where it is a number.
std::string paper_side(const ClaimRow& claim) {
  const std::string text = prose_html(claim.paper);
  return claim.paper_in_words ? text : with_unit(text, claim.unit);
}

std::string row_html(const ClaimRow& claim, const std::string& claims_page) {
  std::string ours, interval, deviation;
  if (claim.ours) ours = with_unit(readable_number(*claim.ours), claim.unit);
  if (claim.interval && claim.interval->second > claim.interval->first)
    interval = fmt::format("<span class=\"id number\">{} … {}</span>", readable_number(claim.interval->first),
                           readable_number(claim.interval->second));
  if (claim.deviation) deviation = percentage(*claim.deviation);
  std::string band;
  if (claim.band)
    band = fmt::format("<span class=\"id\">band <span class=\"number\">{}</span></span>", band_text(*claim.band));
  if (claim.arithmetic) band += "<span class=\"id\">by arithmetic, not stated</span>";
  const std::string gate = claim.gate == Gate::broken ? " <span class=\"badge not-reproduced\">gate broken</span>" : "";
  return fmt::format(
      "<tr id=\"{0}\" data-verdict=\"{1}\" data-figure=\"{2}\"><td class=\"lead\">{3}<span class=\"id\">{13} · "
      "{4}</span>"
      "</td><td data-label=\"Verdict\"><div><span class=\"badge {1}\">{5} {6}</span>{7}</div></td><td "
      "data-label=\"Paper\">"
      "<div>{8}{9}</div></td>{10}{11}<td class=\"reason\" data-label=\"Reason\">{12}</td>"
      "</tr>\n",
      escape_html(claim.id), verdict_class(claim.verdict), escape_html(claim.place), prose_html(claim.quantity),
      escape_html(claim.source), verdict_sign(claim.verdict), verdict_words(claim.verdict), gate, paper_side(claim),
      band,
      ours.empty()
          ? "<td data-label=\"Ours\"></td>"
          : fmt::format("<td data-label=\"Ours\"><div><span class=\"number\">{}</span>{}</div></td>", ours, interval),
      deviation.empty() ? "<td data-label=\"Deviation\"></td>"
                        : fmt::format("<td data-label=\"Deviation\"><span class=\"number\">{}</span></td>", deviation),
      prose_html(claim.reason),
      claims_page.empty() ? escape_html(claim.id)
                          : fmt::format("<a href=\"{0}#{1}\">{1}</a>", claims_page, escape_html(claim.id)));
}

}  // namespace

ClaimGroups claims_by_place(const std::vector<ClaimRow>& claims) {
  ClaimGroups groups;
  for (const ClaimRow& claim : claims) {
    const auto known = std::ranges::find(groups, claim.place, &ClaimGroups::value_type::first);
    if (known == groups.end()) {
      groups.push_back({claim.place, {&claim}});
    } else {
      known->second.push_back(&claim);
    }
  }
  std::ranges::stable_sort(groups, {}, &ClaimGroups::value_type::first);
  return groups;
}

std::string place_name(const std::string& place) {
  const auto digits = place.find_first_of("0123456789");
  const std::string word = place.substr(0, digits);
  if (digits == std::string::npos) {
    std::string capital = place;
    if (!capital.empty()) capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(capital[0])));
    return escape_html(capital);
  }
  const std::string number = std::to_string(std::stoi(place.substr(digits)));
  if (word == "fig") return "Figure " + number;
  if (word == "table") return "Table " + number;
  return escape_html(place);
}

std::string verdict_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::not_reproduced:
      return "not reproduced";
    case Verdict::not_decidable:
      return "not decidable";
  }
  throw std::logic_error("verdict_words: unknown verdict");
}

std::string verdict_class(Verdict verdict) {
  std::string name = verdict_words(verdict);
  std::ranges::replace(name, ' ', '-');
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
  throw std::logic_error("verdict_sign: unknown verdict");
}

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit == "-" || unit.empty() ? text : text + " " + escape_html(unit);
}

std::string claim_table(const std::vector<const ClaimRow*>& claims, const std::string& claims_page) {
  std::string html =
      "<div class=\"card scroll\"><table class=\"stack "
      "claims\">\n<thead><tr><th>Claim</th><th>Verdict</th><th>Paper</th>"
      "<th>Ours</th><th>Deviation</th><th>Reason</th></tr></thead>\n<tbody>\n";
  for (const ClaimRow* claim : claims) html += row_html(*claim, claims_page);
  return html + "</tbody></table></div>\n";
}

std::string verdict_badges(const std::vector<const ClaimRow*>& claims) {
  std::map<Verdict, std::size_t> counted;
  for (const ClaimRow* claim : claims) ++counted[claim->verdict];
  std::string html;
  for (const auto& [verdict, number] : counted)
    html +=
        fmt::format("<span class=\"badge {}\">{} {}</span> ", verdict_class(verdict), number, verdict_words(verdict));
  return html;
}

}  // namespace slfb::reports
