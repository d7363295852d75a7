#include "reports/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <regex>
#include <stdexcept>

#include "reports/claim_table.hpp"
#include "reports/figure_pages.hpp"
#include "reports/html.hpp"
#include "reports/law_pages.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb::reports {
namespace {

namespace fs = std::filesystem;

/// Links to all pages but the figures'; the one called `title` is marked as the present one.
std::string navigation(const ReportContents& contents, std::string_view title) {
  std::string html = "<nav><div>";
  const auto link = [&](const std::string& file, const std::string& label) {
    html += fmt::format("<a href=\"{}\"{}>{}</a>", file, label == title ? " aria-current=\"page\"" : "", label);
  };
  link("index.html", "Overview");
  link("claims.html", "Claims");
  for (const FeaturedPage& page : contents.texts.featured)
    link("figures/" + page.figure + ".html", escape_html(page.label));
  link("inconsistencies.html", "What does not add up");
  link("methods.html", "Methods");
  link("laws.html", "Laws");
  link("quantities.html", "Quantities");
  link("flow.html", "How data flows");
  link("provenance.html", "Provenance");
  link("print.html", "All on one page");
  return html + "</div></nav>\n";
}

std::string overview(const ReportContents& contents) {
  std::string html = fmt::format(
      "<header class=\"masthead\"><div>\n<h1>{}</h1>\n{}<p class=\"soft\">Profile <b>{}</b>: {} of {} "
      "simulations are available.{}</p>\n</div></header>\n",
      escape_html(contents.texts.title), markdown_html(contents.texts.introduction), escape_html(contents.profile),
      contents.runs_available, contents.runs_wanted,
      contents.runs_available < contents.runs_wanted
          ? fmt::format(" <code>build/slfb figures --profile {}</code> makes the others and draws everything again.",
                        escape_html(contents.profile))
          : "");
  html += navigation(contents, "Overview") + "<main>\n<section id=\"verdicts\">\n<h2>Verdicts at a glance</h2>\n";
  std::map<Verdict, std::size_t> verdicts{
      {Verdict::reproduced, 0}, {Verdict::not_reproduced, 0}, {Verdict::not_decidable, 0}};
  std::map<Gate, std::size_t> gates;
  for (const ClaimRow& claim : contents.claims) {
    ++verdicts[claim.verdict];
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
      "</div>\n<p class=\"soft\">{} in all. Beside the verdict on the paper, {} compared with our own accepted value: "
      "{} of these regression gates hold, {} broken.</p>\n<div class=\"mosaic\">\n",
      plural(contents.claims.size(), "claim"),
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
      "<p>A claim is one statement of the paper that a number can decide. It "
      "is "
      "reproduced when our number lies in the band beside the paper's; the band is never widened to fit. Not decidable "
      "means that the paper gives no number or no definition, or that the simulation is still to be made; the reason "
      "says which. Small print under our number: its 95 % interval.</p>\n"
      "<div class=\"filters\" role=\"group\" aria-label=\"filter the claims\"><button value=\"\" "
      "aria-pressed=\"true\">all"
      "</button><button value=\"reproduced\">reproduced</button><button value=\"not-reproduced\">not "
      "reproduced</button>"
      "<button value=\"not-decidable\">not decidable</button><select aria-label=\"place in the "
      "paper\">{}</select></div>\n"
      "<p class=\"soft\"><span id=\"claims-shown\">{}</span> · <a href=\"claims.json\">all claims as JSON</a></p>\n",
      options, plural(contents.claims.size(), "claim"));
  std::vector<const ClaimRow*> claims;
  for (const auto& [place, group] : claims_by_place(contents.claims))
    claims.insert(claims.end(), group.begin(), group.end());
  return html + claim_table(claims, "claim-rows");
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

std::string quantity_section(const ReportContents& contents) {
  std::vector<std::vector<std::string>> rows;
  for (const QuantityRow& quantity : contents.quantities)
    rows.push_back({fmt::format("{}<span class=\"id\">{}</span>", prose_html(quantity.title), escape_html(quantity.id)),
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
  double wall_seconds = 0.0;
  for (const RunRow& run : contents.runs) wall_seconds += run.wall_seconds;
  std::string html = fmt::format(
      "<p>Written {:%Y-%m-%d %H:%M} UTC by slfb {}, numerics version "
      "{}. "
      "A run is named by the hash of its scene and the numerics version, so that the same scene is never computed "
      "twice. "
      "{} took {} of computing.</p>\n",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())), escape_html(SLFB_VERSION),
      contents.numerics_version, plural(contents.runs.size(), "simulation"), readable_duration(wall_seconds));
  html += "<p>Where its simulations differ from the paper's:</p>" + list(contents.differences);
  if (contents.runs.empty()) return html + "<p>No simulation is available yet.</p>\n";
  html +=
      "<div class=\"card scroll\"><table class=\"stack\">\n<thead><tr><th>Run</th><th>Scene hash</th><th>Numerics</th>"
      "<th>Simulated</th><th>Wall "
      "time</th><th>Threads</th><th>Machine</th><th>Date</th><th>From</th></tr></thead>\n<tbody>\n";
  for (const RunRow& run : contents.runs)
    html += fmt::format(
        "<tr><td class=\"lead\">{}</td><td data-label=\"Scene hash\"><code>{}</code></td><td "
        "data-label=\"Numerics\">{}{}"
        "</td><td data-label=\"Simulated\"><span class=\"number\">{}</span></td><td data-label=\"Wall time\"><span "
        "class=\"number\">{}</span></td><td data-label=\"Threads\">{}</td><td data-label=\"Machine\">{}</td><td "
        "data-label=\"Date\"><span class=\"number\">{}</span></td><td data-label=\"From\">{}</td></tr>\n",
        escape_html(run.key), escape_html(run.name), run.numerics, run.older_numerics ? " (older)" : "",
        readable_duration(run.simulated_seconds), readable_duration(run.wall_seconds), run.threads,
        escape_html(run.machine), escape_html(run.date), run.published ? "committed results" : "this machine");
  return html + "</tbody></table></div>\n";
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

/// The whole report on one page, for paper or PDF. Links between pages become links between its sections, and those to
/// files beside it are left out: on paper nothing lies beside it.
std::string print_page(const ReportContents& contents, const fs::path& folder) {
  const auto section = [](const char* id, const char* title, const std::string& body) {
    return fmt::format("<section class=\"sheet\" id=\"{}\">\n<h1>{}</h1>\n{}</section>\n", id, title, body);
  };
  std::vector<const ClaimRow*> of_no_figure;
  for (const ClaimRow& claim : contents.claims)
    if (std::ranges::find(contents.figures, claim.place, &FigurePage::id) == contents.figures.end())
      of_no_figure.push_back(&claim);
  std::string html =
      overview(contents) + "</main>\n<main>\n" + figures_to_print(contents, folder / "figures") +
      section("claims", "Claims of the text",
              "<p>Statements of the paper that belong to no figure.</p>\n" + claim_table(of_no_figure, "")) +
      section("inconsistencies", "What does not add up", inconsistency_section(contents)) +
      section("methods", "Methods", markdown_html(contents.texts.methods)) + section("laws", "Laws", law_section()) +
      section("quantities", "Quantities", quantity_section(contents)) +
      section("flow", "How data flows", flow_section()) +
      section("provenance", "Provenance", provenance_section(contents));
  static const std::array<std::pair<std::regex, const char*>, 4> links{
      {{std::regex("href=\"[^\":#]*\\.html#([^\"]+)\""), "href=\"#$1\""},
       {std::regex("<a href=\"laws/variants\\.html\">|<a href=\"[^\":#]+\\.(svg|h5)\">"), "<a>"},
       {std::regex("href=\"laws/([^\":#]+)\\.html\""), "href=\"#law-$1\""},
       {std::regex("href=\"(?:\\.\\./)?(?:figures/)?(?!index|print)([a-z0-9-]+)\\.html\""), "href=\"#$1\""}}};
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

  write_figure_pages(contents, folder / "figures");
  write_law_pages(folder);

  write_file(folder / "claims.json", contents.claims_json);
  write_file(folder / "index.html",
             whole_page("slfb report", overview(contents) + figure_gallery(contents, figures_folder)));
  write_file(folder / "print.html", print_page(contents, folder));
  const auto write_page = [&](const char* file, const std::string& title, const std::string& body) {
    write_file(
        folder / file,
        whole_page(title, fmt::format("<header class=\"masthead slim\"><div><h1>{}</h1></div></header>\n{}<main>\n{}",
                                      title, navigation(contents, title), body)));
  };
  write_page(
      "claims.html", "Claims",
      claim_section(contents) + "<script>\n" + read_file(source_folder() / "reports" / "report.js") + "</script>\n");
  write_page("inconsistencies.html", "What does not add up", inconsistency_section(contents));
  write_page("methods.html", "Methods", "<div class=\"prose\">" + markdown_html(contents.texts.methods) + "</div>\n");
  write_page("laws.html", "Laws", law_section());
  write_page("quantities.html", "Quantities", quantity_section(contents));
  write_page("flow.html", "How data flows", flow_section());
  write_page("provenance.html", "Provenance", provenance_section(contents));
}

}  // namespace slfb::reports
