#include "reports/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"
#include "reports/claim_table.hpp"
#include "reports/figure_pages.hpp"
#include "reports/html.hpp"
#include "reports/law_pages.hpp"
#include "reports/law_section.hpp"
#include "reports/markdown.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("cannot read {}", file.string()));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct Page {
  const char *file, *title;
};
constexpr std::array pages{Page{"index.html", "Overview"},
                           Page{"claims.html", "Claims"},
                           Page{"figures/drag-law.html", "Drag law"},
                           Page{"inconsistencies.html", "What does not add up"},
                           Page{"methods.html", "Methods"},
                           Page{"laws.html", "Laws"},
                           Page{"provenance.html", "Provenance"},
                           Page{"print.html", "All on one page"}};

/// Links to all pages but the figures'; the one called `title` is marked as the present one.
std::string navigation(std::string_view title) {
  std::string html = "<nav><div>";
  for (const Page& page : pages)
    html += fmt::format("<a href=\"{}\"{}>{}</a>", page.file, page.title == title ? " aria-current=\"page\"" : "",
                        page.title);
  return html + "</div></nav>\n";
}

std::string overview(const ReportContents& contents) {
  const ClaimCounts counts = count(contents.evaluations);
  std::set<std::string> wanted, present;
  for (const auto& spec : contents.profile.runs) wanted.insert(run_key(spec));
  for (const auto& run : contents.runs)
    if (wanted.contains(run_key(run.spec))) present.insert(run_key(run.spec));
  std::string html = fmt::format(
      "<header class=\"masthead\"><div>\n<h1>Solid–liquid fluidised beds, simulated again</h1>\n"
      "<p>A steel sphere settles through a bed of glass spheres in water. Peng et al. "
      "(<a href=\"https://doi.org/10.1016/j.ces.2014.04.040\">Chem. Eng. Sci., 2014</a>) simulated it with coupled CFD "
      "and DEM; this report simulates it again with <code>slfb</code> {}, draws their figures, and holds each "
      "statement "
      "of the paper that can be checked against our own numbers.</p>\n<p class=\"soft\">Profile <b>{}</b>: {} of {} "
      "simulations are available.{}</p>\n</div></header>\n",
      escape_html(SLFB_VERSION), escape_html(contents.profile.name), present.size(), wanted.size(),
      present.size() < wanted.size()
          ? fmt::format(" <code>build/slfb figures --profile {}</code> makes the others and draws everything again.",
                        escape_html(contents.profile.name))
          : "");
  html += navigation("Overview") + "<main>\n<section id=\"verdicts\">\n<h2>Verdicts at a glance</h2>\n";
  const std::array<std::pair<Verdict, std::size_t>, 3> parts{{{Verdict::reproduced, counts.reproduced},
                                                              {Verdict::not_reproduced, counts.not_reproduced},
                                                              {Verdict::not_decidable, counts.not_decidable}}};
  html += "<div class=\"verdict-bar\" role=\"img\" aria-label=\"share of the verdicts\">";
  for (const auto& [verdict, number] : parts)
    if (number > 0) html += fmt::format("<span class=\"{}\" style=\"flex:{}\"></span>", verdict_class(verdict), number);
  html += "</div>\n<div class=\"counts\">\n";
  for (const auto& [verdict, number] : parts)
    html += fmt::format("<div class=\"count {}\"><b>{}</b><span>{}</span></div>\n", verdict_class(verdict), number,
                        to_string(verdict));
  html += fmt::format(
      "</div>\n<p class=\"soft\">{} in all. Beside the verdict on the paper, {} compared with our own accepted value: "
      "{} of these regression gates hold, {} broken.</p>\n<div class=\"mosaic\">\n",
      plural(contents.evaluations.size(), "claim"),
      counts.gates_holding + counts.gates_broken == 1
          ? "1 claim is"
          : fmt::format("{} claims are", counts.gates_holding + counts.gates_broken),
      counts.gates_holding, counts.gates_broken == 1 ? "1 is" : fmt::format("{} are", counts.gates_broken));
  for (const auto& [place, group] : claims_by_place(contents.evaluations)) {
    const bool has_page = std::any_of(contents.figures.begin(), contents.figures.end(),
                                      [&name = place](const FigureOutput& figure) { return figure.id == name; });
    const std::string label = place_in_paper(place);
    html += fmt::format("<div><span class=\"soft\">{}</span><span class=\"cells\">",
                        has_page ? fmt::format("<a href=\"figures/{}.html\">{}</a>", place, label) : label);
    for (const Evaluation* evaluation : group) {
      html += fmt::format("<a class=\"{0}-cell\" href=\"claims.html#{1}\" title=\"{1}: {2} ({3})\">{4}</a>",
                          verdict_class(evaluation->verdict), escape_html(evaluation->claim.id),
                          escape_html(evaluation->claim.quantity), to_string(evaluation->verdict),
                          verdict_sign(evaluation->verdict));
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
  for (const auto& [place, group] : claims_by_place(contents.evaluations))
    options += fmt::format("<option value=\"{}\">{}</option>", escape_html(place), place_in_paper(place));
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
      options, plural(contents.evaluations.size(), "claim"));
  std::vector<const Evaluation*> claims;
  for (const auto& [place, group] : claims_by_place(contents.evaluations))
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
  for (const auto& row : contents.inconsistencies) {
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

std::string provenance_section(const ReportContents& contents) {
  double wall_seconds = 0.0;
  for (const auto& run : contents.runs) wall_seconds += run.result.wall_seconds;
  std::string html = fmt::format(
      "<p>Written {:%Y-%m-%d %H:%M} UTC by slfb {}, numerics version "
      "{}. "
      "A run is named by the hash of its scene and the numerics version, so that the same scene is never computed "
      "twice. "
      "{} took {} of computing.</p>\n",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())), escape_html(SLFB_VERSION),
      numerics_version, plural(contents.runs.size(), "simulation"), readable_duration(wall_seconds));
  html += "<p>Where its simulations differ from the paper's:</p>" + list(contents.profile.differences);
  if (contents.runs.empty()) return html + "<p>No simulation is available yet.</p>\n";
  html +=
      "<div class=\"card scroll\"><table class=\"stack\">\n<thead><tr><th>Run</th><th>Scene hash</th><th>Numerics</th>"
      "<th>Simulated</th><th>Wall "
      "time</th><th>Threads</th><th>Machine</th><th>Date</th><th>From</th></tr></thead>\n<tbody>\n";
  for (const auto& run : contents.runs) {
    const RunResult& result = run.result;
    html += fmt::format(
        "<tr><td class=\"lead\">{}</td><td data-label=\"Scene hash\"><code>{}</code></td><td "
        "data-label=\"Numerics\">{}{}"
        "</td><td data-label=\"Simulated\"><span class=\"number\">{}</span></td><td data-label=\"Wall time\"><span "
        "class=\"number\">{}</span></td><td data-label=\"Threads\">{}</td><td data-label=\"Machine\">{}</td><td "
        "data-label=\"Date\"><span class=\"number\">{}</span></td><td data-label=\"From\">{}</td></tr>\n",
        escape_html(run_key(run.spec)), escape_html(result.name), result.numerics, run.stale ? " (older)" : "",
        readable_duration(result.simulated_seconds), readable_duration(result.wall_seconds), result.threads,
        escape_html(result.machine), escape_html(result.date), run.published ? "committed results" : "this machine");
  }
  return html + "</tbody></table></div>\n";
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

/// A page of the folder of the report; `body` opens <main>.
std::string whole_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" class=\"no-script\">\n<head>\n<meta charset=\"utf-8\" />\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n<title>{}</title>\n<style>\n{}</style>\n"
      "</head>\n<body>\n{}<footer>slfb {}. The numbers of the paper are facts quoted with their place in it.</footer>\n"
      "</main>\n</body>\n</html>\n",
      title, read_file(source_folder() / "reports" / "report.css"), body, escape_html(SLFB_VERSION));
}

/// The whole report on one page, for paper or PDF. Links between pages become links between its sections, and those to
/// files beside it are left out: on paper nothing lies beside it.
std::string print_page(const ReportContents& contents, const fs::path& folder) {
  const auto section = [](const char* id, const char* title, const std::string& body) {
    return fmt::format("<section class=\"sheet\" id=\"{}\">\n<h1>{}</h1>\n{}</section>\n", id, title, body);
  };
  std::vector<const Evaluation*> of_no_figure;
  for (const Evaluation& evaluation : contents.evaluations)
    if (std::ranges::none_of(contents.figures, [&](const auto& f) { return f.id == evaluation.claim.figure; }))
      of_no_figure.push_back(&evaluation);
  std::string html =
      overview(contents) + "</main>\n<main>\n" + figures_to_print(contents, folder / "figures") +
      section("claims", "Claims of the text",
              "<p>Statements of the paper that belong to no figure.</p>\n" + claim_table(of_no_figure, "")) +
      section("inconsistencies", "What does not add up", inconsistency_section(contents)) +
      section("methods", "Methods", markdown_html(read_file(source_folder() / "reports" / "methods.md"))) +
      section("laws", "Laws", law_section()) + section("provenance", "Provenance", provenance_section(contents));
  static const std::array<std::pair<std::regex, const char*>, 4> links{
      {{std::regex("href=\"[^\":#]*\\.html#([^\"]+)\""), "href=\"#$1\""},
       {std::regex("<a href=\"laws/variants\\.html\">|<a href=\"[^\":#]+\\.(svg|h5)\">"), "<a>"},
       {std::regex("href=\"laws/([^\":#]+)\\.html\""), "href=\"#law-$1\""},
       {std::regex("href=\"(?:\\.\\./)?(?:figures/)?(?!index|print)([a-z0-9-]+)\\.html\""), "href=\"#$1\""}}};
  for (const auto& [from, to] : links) html = std::regex_replace(html, from, to);
  return whole_page("slfb report", html);
}

/// The files of one figure, and only those: a figures folder may hold remains of earlier versions.
void copy_figure(const FigureOutput& figure, const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files;
  for (const char* format : {"svg", "png", "pdf", "gp"}) files.push_back(from / (figure.id + "." + format));
  for (const auto& data : figure.data) files.push_back(from / data.filename());
  for (const auto& file : files) {
    std::error_code error;
    fs::copy_file(file, to / file.filename(), fs::copy_options::overwrite_existing, error);
    if (error) throw std::runtime_error(fmt::format("cannot copy {}: {}", file.string(), error.message()));
  }
}

/// The result of a run beside the pages, so that they can offer it: a second name of the file where it is of this
/// machine.
void add_run(const FinishedRun& run, const fs::path& out, const fs::path& folder) {
  const fs::path from = run.published ? published_file(run.spec) : result_file(out, run.result.name);
  const fs::path to = folder / run_download(run);
  std::error_code error;
  if (!fs::exists(from) || fs::exists(to)) return;
  if (!run.published) fs::create_hard_link(from, to, error);
  if (run.published || error) fs::copy_file(from, to, error);
  if (error) throw std::runtime_error(fmt::format("cannot copy {}: {}", from.string(), error.message()));
}

}  // namespace

void write_report(const ReportContents& contents, const fs::path& figures_folder, const fs::path& folder) {
  fs::create_directories(folder / "figures");
  for (const auto& figure : contents.figures) copy_figure(figure, figures_folder, folder / "figures");
  fs::remove_all(folder / "runs");
  fs::create_directories(folder / "runs");
  for (const auto& run : contents.runs) add_run(run, contents.out, folder / "runs");

  write_figure_pages(contents, folder / "figures");
  write_law_pages(folder);

  write_file(folder / "claims.json", claims_json(contents.evaluations).dump(2) + "\n");
  write_file(folder / "index.html",
             whole_page("slfb report", overview(contents) + figure_gallery(contents, figures_folder)));
  write_file(folder / "print.html", print_page(contents, folder));
  const auto write_page = [&](const char* file, const std::string& title, const std::string& body) {
    write_file(
        folder / file,
        whole_page(title, fmt::format("<header class=\"masthead slim\"><div><h1>{}</h1></div></header>\n{}<main>\n{}",
                                      title, navigation(title), body)));
  };
  const fs::path source = source_folder() / "reports";
  write_page("claims.html", "Claims",
             claim_section(contents) + "<script>\n" + read_file(source / "report.js") + "</script>\n");
  write_page("inconsistencies.html", "What does not add up", inconsistency_section(contents));
  write_page("methods.html", "Methods",
             "<div class=\"prose\">" + markdown_html(read_file(source / "methods.md")) + "</div>\n");
  write_page("laws.html", "Laws", law_section());
  write_page("provenance.html", "Provenance", provenance_section(contents));
}

}  // namespace slfb
