#include "reports/law_section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "correlations/catalogue.hpp"
#include "reports/html.hpp"

namespace slfb {
namespace {

std::string escape(std::string_view text) { return escape_html(std::string(text)); }

std::string range_text(const Range& range) {
  if (std::isinf(range.upper)) return range.lower == 0.0 ? "any" : "≥ " + readable_number(range.lower);
  return readable_number(range.lower) + " … " + readable_number(range.upper);
}

}  // namespace

std::string law_section() {
  std::string html = fmt::format(
      "<p>Every law of the suite with the range that its source states. How a "
      "formula came to us: <i>read</i> in a source that quotes or implements the original, <i>recalled</i> as common "
      "knowledge of the field, <i>derived</i> or settled by a limit, or <i>reconstructed</i> as a labelled stand-in "
      "for "
      "an original that is not at hand. <code>slfb law NAME</code> evaluates one; its page shows its symbols, its "
      "curve and its check values. <a href=\"laws/variants.html\">Variants by source</a> shows how far apart sources "
      "are that print different formulas under one name.</p>\n"
      "<div class=\"card scroll\"><table class=\"stack\">\n<thead><tr><th>Law</th><th>Kind</th><th>Formula and "
      "convention</th><th>Re</th><th>Voidage</th><th>Source</th><th>Known by</th></tr></thead>\n<tbody>\n");
  for (const CatalogueEntry& entry : catalogue()) {
    const LawInfo& info = entry.info;
    html += fmt::format(
        "<tr id=\"law-{0}\"><td class=\"lead\"><a href=\"laws/{0}.html\">{1}</a><span class=\"id\">{0}</span></td><td "
        "data-label=\"Kind\">{2}</td>"
        "<td data-label=\"Formula\"><div><code>{3}</code><span class=\"id\">{4}{5}</span></div></td>"
        "<td data-label=\"Re\"><span class=\"number\">{6}</span></td><td data-label=\"Voidage\"><span "
        "class=\"number\">{7}"
        "</span></td><td data-label=\"Source\">{8}</td><td data-label=\"Known by\">{9}</td></tr>\n",
        escape(info.name), escape(info.title), escape(to_string(info.kind)), escape(info.equation),
        escape(info.convention), info.note.empty() ? "" : " · " + escape(info.note), range_text(info.reynolds),
        range_text(info.voidage), escape(info.source), escape(to_string(info.confidence)));
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace slfb
