#include "reports/law_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "correlations/check_values.hpp"
#include "reports/html.hpp"
#include "reports/law_plot.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

std::string escape(std::string_view text) { return escape_html(std::string(text)); }

std::string link(std::string_view name) {
  return fmt::format("<a href=\"{0}.html\"><code>{0}</code></a>", escape(name));
}

std::string range_text(const Range& range) { return readable_range(range.lower, range.upper); }

/// The entry of that key in the bibliography as one line: authors, year, title, journal, volume, pages.
std::string citation(const std::string& bibliography, std::string_view key) {
  const auto start = bibliography.find(fmt::format("{{{},", key));
  if (start == std::string::npos) throw std::runtime_error("no source \"" + std::string(key) + "\" in references.bib");
  const std::string entry = bibliography.substr(start, bibliography.find("\n@", start) - start);
  std::string text;
  for (const char* field : {"author", "year", "title", "journal", "publisher", "institution", "volume", "pages"}) {
    const std::string opening = std::string(field) + " = {";
    const auto found = entry.find(opening);
    if (found == std::string::npos) continue;
    const auto begin = found + opening.size();
    auto end = begin;
    for (int depth = 1; end < entry.size(); ++end) {
      depth += entry[end] == '{' ? 1 : entry[end] == '}' ? -1 : 0;
      if (depth == 0) break;
    }
    text += (text.empty() ? "" : ", ") + entry.substr(begin, end - begin);
  }
  // What TeX needs for accents and dashes is left out.
  static const std::regex accent(R"(\\[vcH](?=\{)|\\[`'^"~=.])"), braces(R"([{}\\])"), blanks(R"(\s+)");
  text = std::regex_replace(text, accent, "");
  text = std::regex_replace(text, braces, "");
  text = std::regex_replace(text, blanks, " ");
  return escape_html(std::regex_replace(text, std::regex("--"), "–"));
}

std::string page(const std::string& title, const std::string& body) {
  return html_page(title, fmt::format("<header class=\"masthead\"><div>\n<h1>{}</h1>\n</div></header>\n<nav><div><a "
                                      "href=\"../laws.html\">Report: "
                                      "laws</a><a href=\"variants.html\">Variants by source</a></div></nav>\n"
                                      "<main>\n{}</main>\n",
                                      title, body));
}

/// What a picture holds fixed: the paper's bed, for the drag a voidage in the middle of an expanded one.
LawArguments drawn_arguments(LawKind kind) {
  LawArguments arguments;
  if (kind == LawKind::drag) arguments.voidage = 0.7;
  return arguments;
}

/// The same with a voidage inside the range of the law.
LawArguments drawn_arguments(const LawInfo& info) {
  LawArguments arguments = drawn_arguments(info.kind);
  if (info.kind == LawKind::drag) {
    arguments.voidage = std::clamp(arguments.voidage, info.voidage.lower, info.voidage.upper);
  }
  return arguments;
}

std::string held_arguments(const CatalogueEntry& law) {
  const Sweep& way = sweep_of(law.info.kind);
  const LawArguments arguments = drawn_arguments(law.info);
  const LawArguments moved = way.at(arguments, 0.5 * (way.lower + way.upper));
  std::string text;
  for (const Argument* argument : arguments_of(law)) {
    if (arguments.*(argument->value) != moved.*(argument->value)) continue;
    const std::string unit = argument->unit == "1" ? "" : fmt::format(" {}", escape(argument->unit));
    text += fmt::format("{}{} = {}{}", text.empty() ? "" : ", ", escape(argument->symbol),
                        readable_number(arguments.*(argument->value)), unit);
  }
  return text;
}

std::string picture(const CatalogueEntry& law) {
  return fmt::format(
      "<article class=\"card figure wide\"><div class=\"picture\"><a href=\"{0}.svg\"><img src=\"{0}.svg\" "
      "alt=\"{0} against {1}\" width=\"620\" height=\"460\" loading=\"lazy\" /></a></div><div class=\"words\"><p>At "
      "{2}.</p><div class=\"files\"><a href=\"{0}.svg\">svg</a><a href=\"{0}.csv\">csv</a><a href=\"{0}.gp\">gp</a>"
      "</div></div></article>\n",
      escape(law.info.name), escape(sweep_of(law.info.kind).x.title), held_arguments(law));
}

std::string facts(const CatalogueEntry& entry, const std::string& bibliography) {
  const LawInfo& info = entry.info;
  std::string html = "<div class=\"card scroll\"><table><tbody>\n";
  const auto row = [&](const char* name, const std::string& text) {
    if (!text.empty()) html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", name, text);
  };
  row("Equation", "<code>" + escape(info.equation) + "</code>");
  row("Its number",
      info.equation_number.empty() ? "in the source, which is not at hand" : escape(info.equation_number));
  row("Source", citation(bibliography, info.source));
  row("Known by", escape(to_string(info.confidence)));
  row("Convention", escape(info.convention));
  row("Range of Re", range_text(info.reynolds));
  row("Range of the voidage", range_text(info.voidage));
  if (range_text(info.size_ratio) != "any") row("Range of the size ratio", range_text(info.size_ratio));
  if (range_text(info.stokes) != "any") row("Range of the Stokes number", range_text(info.stokes));
  row("Note", escape(info.note));
  if (!info.variant_of.empty()) row("Variant of", link(info.variant_of));
  std::string variants;
  for (const CatalogueEntry* variant : variants_of(info.name)) variants += link(variant->info.name) + " ";
  row("Variants", variants);
  for (const ParameterInfo& parameter : entry.parameters) row("Parameter", prose_html(parameter_text(parameter)));
  return html + "</tbody></table></div>\n";
}

std::string symbols(const CatalogueEntry& law) {
  std::string html =
      "<h2>Symbols</h2>\n<div class=\"card scroll\"><table class=\"stack\"><thead><tr><th>Symbol</th><th>Unit</th>"
      "<th>Meaning</th><th>Option</th></tr></thead><tbody>\n";
  for (const Argument* argument : arguments_of(law)) {
    std::string option(argument->name);
    std::ranges::replace(option, '_', '-');
    html += fmt::format(
        "<tr><td class=\"lead\"><code>{}</code></td><td data-label=\"Unit\">{}</td><td data-label=\"Meaning\">{}</td>"
        "<td data-label=\"Option\"><code>--{}</code></td></tr>\n",
        escape(argument->symbol), argument->unit == "1" ? "-" : escape(argument->unit), escape(argument->meaning),
        option);
  }
  return html + "</tbody></table></div>\n<p class=\"soft\">s = a = 1 - e is the solids fraction.</p>\n";
}

std::string check_table(const CatalogueEntry& entry, const std::vector<CheckValue>& checks) {
  std::string html =
      "<h2>Check values</h2>\n<p>Numbers from outside this code, which the tests hold to the digits written; arguments "
      "that are not named are those of the paper's bed. <i>Second program</i>: the law written once more, in the form "
      "of its source.</p>\n<div class=\"card scroll\"><table class=\"stack\"><thead><tr><th>Arguments</th><th>Quantity"
      "</th><th>Check value</th><th>Ours</th><th>From</th></tr></thead><tbody>\n";
  for (const CheckValue& check : checks) {
    if (check.law != entry.info.name) continue;
    std::string arguments;
    for (const auto& [name, value] : check.arguments) arguments += fmt::format("{} = {:.6g} ", name, value);
    html += fmt::format(
        "<tr><td class=\"lead\">{}</td><td data-label=\"Quantity\">{}</td><td data-label=\"Check value\"><span "
        "class=\"number\">{}</span></td><td data-label=\"Ours\"><span class=\"number\">{:.8g}</span></td><td "
        "data-label=\"From\">{}{}</td></tr>\n",
        escape(arguments), escape(check.quantity), escape(check.value),
        entry.evaluate(arguments_of(check)).at(check.quantity).value, escape(check.origin),
        check.remark.empty() ? "" : ": " + escape(check.remark));
  }
  return html + "</tbody></table></div>\n";
}

/// How far a variant is from its law along the sweep, inside the law's range.
struct Distance {
  double smallest = std::numeric_limits<double>::infinity();  ///< of variant over law [-]
  double largest = 0.0;
};

Distance distance(const CatalogueEntry& variant, const CatalogueEntry& law) {
  const LawArguments arguments = drawn_arguments(law.info);
  const std::vector<SweepPoint> ours = sweep(law, arguments), theirs = sweep(variant, arguments);
  Distance found;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double ratio = theirs[i].value / ours[i].value;
    if (!ours[i].in_range || !std::isfinite(ratio)) continue;
    found.smallest = std::min(found.smallest, ratio);
    found.largest = std::max(found.largest, ratio);
  }
  return found;
}

std::vector<const CatalogueEntry*> first_of_each_kind() {
  std::vector<const CatalogueEntry*> found;
  for (const CatalogueEntry& entry : catalogue()) {
    if (found.empty() || found.back()->info.kind != entry.info.kind) found.push_back(&entry);
  }
  return found;
}

std::string variants_page() {
  std::string html =
      "<p>Sources that print different formulas under one name, and how far apart they are: the ratio of the variant "
      "to "
      "the law along the line that its picture draws, inside the range of the law. No variant is right because it is "
      "first; the note of a law says what is known.</p>\n";
  for (const CatalogueEntry& law : catalogue()) {
    const auto variants = variants_of(law.info.name);
    if (variants.empty()) continue;
    html += fmt::format(
        "<section id=\"{0}\"><h2>{1}</h2>\n<p><code>{2}</code> ({3})</p>\n<div class=\"card scroll\"><table "
        "class=\"stack\"><thead><tr><th>Variant</th><th>Formula</th><th>Smallest ratio</th><th>Largest ratio</th></tr>"
        "</thead><tbody>\n",
        escape(law.info.name), escape(law.info.title), escape(law.info.equation), link(law.info.name));
    for (const CatalogueEntry* variant : variants) {
      const Distance found = distance(*variant, law);
      html += fmt::format(
          "<tr><td class=\"lead\">{}</td><td data-label=\"Formula\"><div><code>{}</code><span class=\"id\">{}</span>"
          "</div></td><td data-label=\"Smallest ratio\"><span class=\"number\">{}</span></td><td "
          "data-label=\"Largest ratio\"><span class=\"number\">{}</span></td></tr>\n",
          link(variant->info.name), escape(variant->info.equation), escape(variant->info.note),
          found.largest == 0.0 ? "–" : readable_number(found.smallest),
          found.largest == 0.0 ? "–" : readable_number(found.largest));
    }
    html += "</tbody></table></div>\n" + picture(law) + "</section>\n";
  }
  html +=
      "<section id=\"families\"><h2>All laws of each kind</h2>\n<p>How far apart the laws themselves are, on the bed "
      "of the paper unless the axis says otherwise, also where a law is outside its range.</p>\n";
  for (const CatalogueEntry* law : first_of_each_kind()) {
    html += fmt::format(
        "<article class=\"card figure wide\" id=\"{0}\"><div class=\"picture\"><img src=\"family-{0}.svg\" alt=\"all "
        "laws of the kind {0}\" loading=\"lazy\" /></div><div class=\"words\"><h3>{0}</h3><div class=\"files\"><a "
        "href=\"family-{0}.svg\">svg</a><a href=\"family-{0}.csv\">csv</a><a href=\"family-{0}.gp\">gp</a></div>"
        "</div></article>\n",
        escape(to_string(law->info.kind)));
  }
  html += "</section>\n";
  return page("How far apart the sources are", html);
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
        "</span></td><td data-label=\"Source\"><span class=\"number\">{8}</span></td><td data-label=\"Known "
        "by\">{9}</td></tr>\n",
        escape(info.name), escape(info.title), escape(to_string(info.kind)), escape(info.equation),
        escape(info.convention), info.note.empty() ? "" : " · " + escape(info.note), range_text(info.reynolds),
        range_text(info.voidage), escape(info.source), escape(to_string(info.confidence)));
  }
  return html + "</tbody></table></div>\n";
}

void write_law_pages(const fs::path& folder) {
  const fs::path laws = folder / "laws";
  fs::create_directories(laws);
  const fs::path data = source_folder() / "reference-data";
  const std::string bibliography = read_file(data / "references.bib");
  const std::vector<CheckValue> checks = read_check_values(data / "law_checks");
  for (const CatalogueEntry& entry : catalogue()) {
    const LawInfo& info = entry.info;
    draw_law(entry, drawn_arguments(info), std::string(info.name), laws, {"svg"});
    write_file(laws / (std::string(info.name) + ".html"),
               page(escape(info.title),
                    facts(entry, bibliography) + picture(entry) + symbols(entry) + check_table(entry, checks)));
  }
  for (const CatalogueEntry* law : first_of_each_kind()) {
    const LawInfo& info = law->info;
    draw_family(info.kind, drawn_arguments(info.kind), fmt::format("family-{}", to_string(info.kind)), laws, {"svg"});
  }
  write_file(laws / "variants.html", variants_page());
}

}  // namespace slfb
