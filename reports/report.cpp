#include "reports/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <regex>
#include <stdexcept>

#include "correlations/catalogue.hpp"
#include "reports/claim_table.hpp"
#include "reports/figure_pages.hpp"
#include "reports/html.hpp"
#include "reports/law_pages.hpp"
#include "reports/navigation.hpp"
#include "reports/parity_plot.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb::reports {
namespace {

namespace fs = std::filesystem;

/// What was found, each sentence with its figure and the claims that carry it. A sentence that was written for other
/// verdicts than those of now says so.
std::string findings(const ReportContents& contents) {
  if (contents.findings.empty()) return "";
  std::string html = "<section id=\"findings\">\n<h2>What was found</h2>\n<ol class=\"findings\">\n";
  for (const FindingRow& finding : contents.findings) {
    std::string claims, changed;
    for (const FindingRow::Claim& claim : finding.claims) {
      claims += fmt::format(" <a class=\"badge {0}\" href=\"claims.html#{1}\">{2} {1}</a>", verdict_class(claim.now),
                            escape_html(claim.id), verdict_sign(claim.now));
      if (claim.now != claim.stated)
        changed += fmt::format(" Claim {} is now {}; the sentence was written when it was {}.", escape_html(claim.id),
                               verdict_words(claim.now), verdict_words(claim.stated));
    }
    html += fmt::format(
        "<li class=\"{0}\"><a href=\"figures/{1}.html\"><img src=\"figures/{1}.svg\" alt=\"figure of this finding\" "
        "loading=\"lazy\" /></a><div><p>{2}</p>{3}<p class=\"soft\">It rests on{4}</p></div></li>\n",
        finding.holds() ? "holds" : "changed", escape_html(finding.figure), prose_html(finding.text),
        changed.empty() ? "" : "<p class=\"warning\">This sentence no longer stands:" + changed + "</p>", claims);
  }
  return html + "</ol>\n</section>\n";
}

/// Every number of the paper beside ours, in one picture.
std::string parity(bool is_drawn) {
  if (!is_drawn) return "";
  return "<section id=\"parity\">\n<h2>Everything measured, over the paper's number</h2>\n<p>A mark is a claim that "
         "states "
         "a number: ours over the paper's, with the 95 % interval of ours. On the line both are the same; the grey "
         "band "
         "is ±10 %. A mark at the edge lies beyond a factor of ten.</p>\n<div class=\"card picture\"><a "
         "href=\"figures/parity.svg\"><img src=\"figures/parity.svg\" alt=\"Ours over the paper's number for every "
         "claim, "
         "a row for each figure and table, coloured by verdict\" /></a></div>\n</section>\n";
}

/// Who computed what with what, the licence, and how to cite.
std::string certificate(const ReportContents& contents) {
  double wall_seconds = 0.0;
  std::size_t own = 0;
  for (const RunRow& run : contents.runs) {
    wall_seconds += run.wall_seconds;
    own += run.published ? 0 : 1;
  }
  const Certificate& made = contents.certificate;
  std::vector<std::vector<std::string>> rows{
      {"Program", fmt::format("slfb {}, commit <code>{}</code>, numerics version {}", escape_html(SLFB_VERSION),
                              escape_html(made.commit), contents.numerics_version)},
      {"Written", fmt::format("{:%Y-%m-%d %H:%M} UTC",
                              fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())))},
      {"Machine",
       fmt::format("{}{}{}", escape_html(made.machine), made.system.empty() ? "" : ", ", escape_html(made.system))},
      {"Simulations", fmt::format("{}, {} of computing; {} by this machine, the others from the committed results. <a "
                                  "href=\"provenance.html\">Each of them</a> with its machine, date and settings",
                                  contents.runs.size(), readable_duration(wall_seconds), own)}};
  std::string packages;
  for (const auto& [name, version] : made.packages)
    packages += fmt::format("{}{} {}", packages.empty() ? "" : ", ", escape_html(name), escape_html(version));
  if (!packages.empty()) rows.push_back({"Packages", packages});
  rows.push_back({"Licence", "GNU General Public License, version 3 or later"});
  std::string html = "<section id=\"certificate\">\n<h2>Certificate</h2>\n" + table_html({"What", "By what"}, rows);
  if (!contents.citation.empty())
    html += "<details><summary>How to cite it (CITATION.cff)</summary><pre>" + escape_html(contents.citation) +
            "</pre></details>\n";
  return html + "</section>\n";
}

std::string overview(const ReportContents& contents, bool has_parity) {
  std::string html = fmt::format(
      "<header class=\"masthead\"><div>\n<h1>{}</h1>\n{}<p class=\"soft\">Profile <b>{}</b>: {} of {} "
      "simulations are available.{}</p>\n</div></header>\n",
      escape_html(contents.texts.title), markdown_html(contents.texts.introduction), escape_html(contents.profile),
      contents.runs_available, contents.runs_wanted,
      contents.runs_available < contents.runs_wanted
          ? fmt::format(" <code>build/slfb figures --profile {}</code> makes the others and draws everything again.",
                        escape_html(contents.profile))
          : "");
  html += navigation(contents, "Overview", "") + "<main>\n" + findings(contents) + parity(has_parity) +
          "<section id=\"verdicts\">\n<h2>Verdicts at a glance</h2>\n";
  std::map<Verdict, std::size_t> verdicts{
      {Verdict::reproduced, 0}, {Verdict::not_reproduced, 0}, {Verdict::not_decidable, 0}};
  std::map<Gate, std::size_t> gates;
  std::map<Verdict, std::size_t> of_arithmetic;
  std::size_t checks = 0;
  for (const ClaimRow& claim : contents.claims) {
    ++(claim.arithmetic ? of_arithmetic : verdicts)[claim.verdict];
    checks += claim.arithmetic;
    ++gates[claim.gate];
  }
  html += "<div class=\"verdict-bar\" role=\"img\" aria-label=\"share of the verdicts\">";
  for (const auto& [verdict, number] : verdicts)
    if (number > 0) html += fmt::format("<span class=\"{}\" style=\"flex:{}\"></span>", verdict_class(verdict), number);
  html += "</div>\n<div class=\"counts\">\n";
  for (const auto& [verdict, number] : verdicts)
    html += fmt::format("<div class=\"count {}\"><b>{}</b><span>{}</span></div>\n", verdict_class(verdict), number,
                        verdict_words(verdict));
  const std::size_t holding = gates[Gate::holds], broken = gates[Gate::broken];
  html += fmt::format(
      "</div>\n<p class=\"soft\">{} of the paper. {} by arithmetic, laws and probes, which the paper does not state, "
      "{} apart: {} agree with it, {} do not, {} not decidable. Beside the verdict on the paper, {} compared with our "
      "own "
      "accepted value: {} of these regression gates hold, {} broken.</p>\n<div class=\"mosaic\">\n",
      plural(contents.claims.size() - checks, "statement"), plural(checks, "check"), checks == 1 ? "is" : "are",
      of_arithmetic[Verdict::reproduced], of_arithmetic[Verdict::not_reproduced],
      of_arithmetic[Verdict::not_decidable] == 1 ? "1 is"
                                                 : fmt::format("{} are", of_arithmetic[Verdict::not_decidable]),
      holding + broken == 1 ? "1 claim is" : fmt::format("{} claims are", holding + broken), holding,
      broken == 1 ? "1 is" : fmt::format("{} are", broken));
  for (const auto& [place, group] : claims_by_place(contents.claims)) {
    const bool has_page = std::ranges::find(contents.figures, place, &FigurePage::id) != contents.figures.end();
    const std::string label = place_name(place);
    html += fmt::format("<div><span class=\"soft\">{}</span><span class=\"cells\">",
                        has_page ? fmt::format("<a href=\"figures/{}.html\">{}</a>", place, label) : label);
    for (const ClaimRow* claim : group) {
      html += fmt::format("<a class=\"{0}-cell\" href=\"claims.html#{1}\" title=\"{1}: {2} ({3})\">{4}</a>",
                          verdict_class(claim->verdict), escape_html(claim->id), escape_html(claim->quantity),
                          verdict_words(claim->verdict), verdict_sign(claim->verdict));
    }
    html += "</span></div>\n";
  }
  return html + "</div>\n</section>\n";
}

std::string list(const std::vector<std::string>& items) {
  std::string html = "<ul>";
  for (const auto& item : items) html += "<li>" + prose_html(item) + "</li>";
  return html + "</ul>";
}

std::string claim_section(const ReportContents& contents) {
  std::string options = "<option value=\"\">all of the paper</option>";
  for (const auto& [place, group] : claims_by_place(contents.claims))
    options += fmt::format("<option value=\"{}\">{}</option>", escape_html(place), place_name(place));
  std::string html = fmt::format(
      "<p>A claim is one statement of the paper that a number can decide. It is reproduced when our number lies in the "
      "band beside the paper's; the band is never widened to fit. Not decidable "
      "means that the paper gives no number or no definition, or that the simulation is still to be made; the reason "
      "says which. Small print under our number: its 95 % interval, or for a printed number that is one drop the "
      "interval "
      "of one drop of ours.</p>\n"
      "<div class=\"filters\" role=\"group\" aria-label=\"filter the claims\"><button value=\"\" "
      "aria-pressed=\"true\">all"
      "</button><button value=\"reproduced\">reproduced</button><button value=\"not-reproduced\">not "
      "reproduced</button>"
      "<button value=\"not-decidable\">not decidable</button><select aria-label=\"place in the "
      "paper\">{}</select></div>\n"
      "<p class=\"soft\"><span id=\"claims-shown\">{}</span> · <a href=\"claims.json\">all claims as JSON</a></p>\n",
      options, plural(contents.claims.size(), "claim"));
  for (const auto& [place, group] : claims_by_place(contents.claims))
    html += fmt::format("<details class=\"group\"><summary><b>{}</b> {}</summary>\n{}</details>\n", place_name(place),
                        verdict_badges(group), claim_table(group));
  return html;
}

std::string inconsistency_section(const ReportContents& contents) {
  std::string html =
      "<p>Places where the paper disagrees with "
      "itself or "
      "with the laws it names. Every number here is computed by the suite from the printed ones; none is typed "
      "in.</p>\n"
      "<div class=\"card scroll\"><table "
      "class=\"stack\">\n<thead><tr><th>Subject</th><th>Printed</th><th>Recomputed</th>"
      "<th>Why</th></tr></thead>\n<tbody>\n";
  for (const InconsistencyRow& row : contents.inconsistencies) {
    html += fmt::format(
        "<tr id=\"inconsistency-{}\"><td class=\"lead\">{}<span class=\"id\">{}</span></td><td "
        "data-label=\"Printed\"><span "
        "class=\"number\">{}</span></td><td data-label=\"Recomputed\"><span class=\"number\">{}</span></td><td "
        "class=\"reason\" data-label=\"Why\">{}</td></tr>\n",
        escape_html(row.id), prose_html(row.subject), escape_html(row.source),
        with_unit(readable_number(row.paper), row.unit), with_unit(readable_number(row.recomputed), row.unit),
        prose_html(row.explanation));
  }
  return html + "</tbody></table></div>\n";
}

/// The data sets of a result file and how to read one.
std::string data_section(const ReportContents& contents) {
  std::vector<std::vector<std::string>> rows;
  for (const DataSetRow& row : contents.data_sets)
    rows.push_back({"<code>" + escape_html(row.path) + "</code>", escape_html(row.unit), prose_html(row.description)});
  return "<div class=\"prose\">" + markdown_html(read_file(source_folder() / "reports" / "data.md")) + "</div>\n" +
         table_html({"Data set", "Unit", "What it is"}, rows);
}

/// Everything that can be searched for: a line for each figure, claim, law, quantity and page. Without scripts it is a
/// list of all of them.
std::string search_section(const ReportContents& contents) {
  std::string entries;
  const auto entry = [&](const std::string& link, const std::string& title, const std::string& text) {
    entries += fmt::format("<li><a href=\"{}\">{}</a> <span class=\"soft\">{}</span></li>\n", escape_html(link),
                           prose_html(title), prose_html(text));
  };
  for (const FigurePage& figure : contents.figures)
    entry("figures/" + figure.id + ".html", figure.title, figure.id + ": " + figure.caption);
  for (const ClaimRow& claim : contents.claims)
    entry("claims.html#" + claim.id, claim.quantity,
          fmt::format("claim {}, {}: {}. {}", claim.id, claim.source, verdict_words(claim.verdict), claim.reason));
  for (const CatalogueEntry& law : catalogue())
    entry("laws/" + std::string(law.info.name) + ".html", std::string(law.info.title),
          fmt::format("law {}, {}", law.info.name, law.info.source));
  for (const QuantityRow& quantity : contents.quantities)
    entry("quantities.html#quantity-" + quantity.id, quantity.title,
          fmt::format("quantity {} [{}]: {}", quantity.id, quantity.unit, quantity.definition));
  for (const InconsistencyRow& row : contents.inconsistencies)
    entry("inconsistencies.html#inconsistency-" + row.id, row.subject, "does not add up: " + row.explanation);
  for (const DataSetRow& row : contents.data_sets)
    entry("data.html", row.path, fmt::format("data set [{}]: {}", row.unit, row.description));
  return "<p id=\"search-shown\" class=\"soft\"></p>\n<ul class=\"search\">\n" + entries + "</ul>\n<script>\n" +
         read_file(source_folder() / "reports" / "search.js") + "</script>\n";
}

std::string quantity_section(const ReportContents& contents) {
  std::vector<std::vector<std::string>> rows;
  for (const QuantityRow& quantity : contents.quantities)
    rows.push_back({fmt::format("<span id=\"quantity-{1}\">{0}</span><span class=\"id\">{1}</span>",
                                prose_html(quantity.title), escape_html(quantity.id)),
                    escape_html(quantity.unit), prose_html(quantity.definition),
                    prose_html(quantity.contact_stiffness)});
  return "<p>What is measured in simulations and by laws. Claims, figures and comparisons use these quantities by "
         "their names; each is computed in one place. A softer contact spring makes contacts last longer, which "
         "changes "
         "some quantities and not others.</p>\n" +
         table_html({"Quantity", "Unit", "Definition", "With the contact stiffness"}, rows);
}

/// From a scene to the report, as a picture and in words. The picture is part of the page, so that it follows its
/// colours in light and dark.
std::string flow_section() {
  const fs::path folder = source_folder() / "reports";
  return "<div class=\"card scroll flow\">\n" + read_file(folder / "flow.svg") + "</div>\n<div class=\"prose\">" +
         markdown_html(read_file(folder / "flow.md")) + "</div>\n";
}

std::string provenance_section(const ReportContents& contents) {
  std::string html =
      "<p>A run is named by the hash of its scene and the numerics version, so that the same scene is never computed "
      "twice. The <a href=\"index.html#certificate\">certificate</a> says what wrote these pages.</p>\n<p>Where the "
      "simulations of the profile differ from the paper's:</p>" +
      list(contents.differences);
  if (contents.runs.empty()) return html + "<p>No simulation is available yet.</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (const RunRow& run : contents.runs) {
    const auto number = [](const std::string& text) { return "<span class=\"number\">" + text + "</span>"; };
    rows.push_back({fmt::format("{}<span class=\"id\">{} · <code>{}</code></span>", escape_html(run.key),
                                escape_html(run.profile), escape_html(run.name)),
                    fmt::format("{}{}", run.numerics, run.older_numerics ? " (older)" : ""),
                    number(readable_duration(run.simulated_seconds)), number(readable_duration(run.wall_seconds)),
                    fmt::format("{}<span class=\"id\">{}</span>", escape_html(run.machine),
                                plural(static_cast<std::size_t>(run.threads), "thread")),
                    fmt::format("{}<span class=\"id\">{}</span>", escape_html(run.date.substr(0, 10)),
                                run.commit.empty() ? "" : "commit " + escape_html(run.commit)),
                    run.published ? "committed results" : "this machine"});
  }
  return html + table_html({"Run", "Numerics", "Simulated", "Wall time", "Machine", "Date", "From"}, rows);
}

/// A page of the folder of the report; `body` opens <main>.
std::string whole_page(const std::string& title, const std::string& body) {
  return html_page(
      title,
      fmt::format("{}<footer>slfb {}. The numbers of the paper are facts quoted with their place in it.</footer>\n"
                  "</main>\n",
                  body, escape_html(SLFB_VERSION)),
      "no-script");
}

/// The whole report on one page, for paper or PDF. Links between pages become links between its sections; those to
/// files lead to the files beside it.
std::string print_page(const ReportContents& contents, bool has_parity, const fs::path& folder) {
  const auto section = [](const char* id, const char* title, const std::string& body) {
    return fmt::format("<section class=\"sheet\" id=\"{}\">\n<h1>{}</h1>\n{}</section>\n", id, title, body);
  };
  std::vector<const ClaimRow*> of_no_figure;
  for (const ClaimRow& claim : contents.claims)
    if (std::ranges::find(contents.figures, claim.place, &FigurePage::id) == contents.figures.end())
      of_no_figure.push_back(&claim);
  std::string html =
      overview(contents, has_parity) + certificate(contents) + "</main>\n<main>\n" +
      figures_to_print(contents, folder / "figures") +
      section("claims", "Claims of the text",
              "<p>Statements of the paper that belong to no figure.</p>\n" + claim_table(of_no_figure)) +
      section("inconsistencies", "What does not add up", inconsistency_section(contents)) +
      section("methods", "Methods", markdown_html(contents.texts.methods)) + section("laws", "Laws", law_section()) +
      section("quantities", "Quantities", quantity_section(contents)) +
      section("data", "Data of a run", data_section(contents)) + section("flow", "How data flows", flow_section()) +
      section("provenance", "Provenance", provenance_section(contents));
  static const std::array<std::pair<std::regex, const char*>, 5> links{
      {{std::regex("href=\"[^\":#]*\\.html#([^\"]+)\""), "href=\"#$1\""},
       {std::regex("<a href=\"(?:\\.\\./)?laws/variants\\.html\">"), "<a>"},
       {std::regex("href=\"(?:\\.\\./)?laws/([^\":#]+)\\.html\""), "href=\"#law-$1\""},
       {std::regex("href=\"(?:\\.\\./)?(?:figures/)?(?!index\\.|print\\.)([a-z0-9-]+)\\.html\""), "href=\"#$1\""},
       {std::regex("href=\"\\.\\./"), "href=\""}}};
  for (const auto& [from, to] : links) html = std::regex_replace(html, from, to);
  return whole_page("slfb report", html);
}

/// The files of one figure, and only those: a figures folder may hold remains of earlier versions.
void copy_figure(const FigurePage& figure, const fs::path& from, const fs::path& to) {
  std::vector<std::string> files = figure.data_files;
  for (const char* format : {"svg", "png", "pdf", "gp"}) files.push_back(figure.id + "." + format);
  for (const std::string& file : files) {
    write_file(to / file, read_file(from / file));  // a link in its place is not followed
  }
}

/// The result of a run beside the pages, so that they can offer it: a second name of the file where it is of this
/// machine.
void add_run(const RunRow& run, const fs::path& folder) {
  const fs::path to = folder / run.download;
  std::error_code error;
  if (!fs::exists(run.file) || fs::exists(to)) return;
  if (!run.published) fs::create_hard_link(run.file, to, error);
  if (run.published || error) fs::copy_file(run.file, to, error);
  if (error) throw std::runtime_error(fmt::format("cannot copy {}: {}", run.file.string(), error.message()));
}

}  // namespace

void write_report(const ReportContents& contents, const fs::path& figures_folder, const fs::path& folder) {
  fs::create_directories(folder / "figures");
  for (const FigurePage& figure : contents.figures) copy_figure(figure, figures_folder, folder / "figures");
  fs::remove_all(folder / "runs");
  fs::create_directories(folder / "runs");
  for (const RunRow& run : contents.runs) add_run(run, folder / "runs");

  const bool has_parity = draw_parity(contents.claims, folder / "figures");
  write_figure_pages(contents, folder / "figures");
  write_law_pages(folder);

  write_file(folder / "claims.json", contents.claims_json);
  write_file(folder / "index.html",
             whole_page("slfb report", overview(contents, has_parity) + figure_gallery(contents, figures_folder) +
                                           certificate(contents)));
  write_file(folder / "print.html", print_page(contents, has_parity, folder));
  const auto write_page = [&](const char* file, const std::string& title, const std::string& body) {
    write_file(
        folder / file,
        whole_page(title, fmt::format("<header class=\"masthead slim\"><div><h1>{}</h1></div></header>\n{}<main>\n{}",
                                      title, navigation(contents, title, ""), body)));
  };
  write_page(
      "claims.html", "Claims",
      claim_section(contents) + "<script>\n" + read_file(source_folder() / "reports" / "report.js") + "</script>\n");
  write_page("inconsistencies.html", "What does not add up", inconsistency_section(contents));
  write_page("methods.html", "Methods", "<div class=\"prose\">" + markdown_html(contents.texts.methods) + "</div>\n");
  write_page("laws.html", "Laws", law_section());
  write_page("quantities.html", "Quantities", quantity_section(contents));
  write_page("data.html", "Data of a run", data_section(contents));
  write_page("search.html", "Search", search_section(contents));
  write_page("flow.html", "How data flows", flow_section());
  write_page("provenance.html", "Provenance", provenance_section(contents));
}

}  // namespace slfb::reports
