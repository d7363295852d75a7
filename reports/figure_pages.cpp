#include "reports/figure_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"
#include "reports/claim_table.hpp"
#include "reports/html.hpp"
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

/// Attributes width and height of a picture, so that the page does not move while it loads. gnuplot writes its size as
/// viewBox="0 0 WIDTH HEIGHT".
std::string image_size(const fs::path& svg) {
  std::smatch match;
  const std::string head = read_file(svg).substr(0, 1000);
  static const std::regex view_box("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"");
  if (!std::regex_search(head, match, view_box)) return "";
  return fmt::format(" width=\"{}\" height=\"{}\"", match.str(1), match.str(2));
}

const Figure& figure_named(const std::string& id) {
  const auto found = std::find_if(figures().begin(), figures().end(), [&](const Figure& f) { return f.id == id; });
  if (found == figures().end()) throw std::runtime_error("no figure is called " + id);
  return *found;
}

/// "Figure 5"; for studies of ours their place beside the paper.
std::string label_of(const std::string& id) {
  return id.starts_with("fig") || id.starts_with("table") ? place_in_paper(id) : "Study";
}

std::vector<const Evaluation*> claims_of(const ReportContents& contents, const std::string& id) {
  std::vector<const Evaluation*> claims;
  for (const auto& evaluation : contents.evaluations)
    if (evaluation.claim.figure == id) claims.push_back(&evaluation);
  return claims;
}

std::string badges(const std::vector<const Evaluation*>& claims) {
  std::map<Verdict, std::size_t> counted;
  for (const Evaluation* evaluation : claims) ++counted[evaluation->verdict];
  std::string html;
  for (const auto& [verdict, number] : counted)
    html += fmt::format("<span class=\"badge {}\">{} {}</span> ", verdict_class(verdict), number, to_string(verdict));
  return html;
}

/// Rows of "what does not add up" whose source names this figure or table.
std::string doubts(const ReportContents& contents, const std::string& id) {
  const auto digits = id.find_first_of("0123456789");
  if (digits == std::string::npos) return "";
  const std::regex place(fmt::format("(^|[^A-Za-z]){}s?\\. ?{}([^0-9]|$)|Table {}([^0-9]|$)",
                                     id.starts_with("fig") ? "Fig" : "never", std::stoi(id.substr(digits)),
                                     id.starts_with("table") ? std::to_string(std::stoi(id.substr(digits))) : "never"));
  std::string items;
  for (const auto& row : contents.inconsistencies)
    if (std::regex_search(row.source, place))
      items += fmt::format("<li><b>{}</b> ({}): {}</li>\n", prose_html(row.subject), escape_html(row.source),
                           prose_html(row.explanation));
  return items.empty() ? "" : "<h2>What does not add up in the paper</h2>\n<ul class=\"doubts\">\n" + items + "</ul>\n";
}

/// The figures with a profile of their own, which has their name.
bool has_own_profile(const Figure& figure) { return figure.id == "drag-law" || figure.id == "causes"; }

/// Keys of the runs that the figure draws; of one with a profile of its own, theirs.
std::vector<std::string> keys_of(const ReportContents& contents, const Figure& figure) {
  auto keys = figure.needs(contents.shown);
  return keys.empty() && has_own_profile(figure) ? figure.needs(load_profile(figure.id)) : keys;
}

/// Simulations that the figure draws, and what they cost.
std::string simulations(const ReportContents& contents, const Figure& figure, const fs::path& folder) {
  const auto keys = keys_of(contents, figure);
  std::string rows;
  double wall = 0.0;
  std::size_t count = 0;
  for (const auto& run : contents.runs) {
    if (std::find(keys.begin(), keys.end(), run_key(run.spec)) == keys.end()) continue;
    wall += run.result.wall_seconds;
    ++count;
    const std::string file = "../runs/" + run_download(run);
    rows += fmt::format(
        "<tr><td class=\"lead\">{}</td><td data-label=\"Profile\">{}</td><td data-label=\"Simulated\"><span "
        "class=\"number\">{}</span></td><td data-label=\"Wall time\"><span class=\"number\">{}</span></td><td "
        "data-label=\"Threads\">{}</td><td data-label=\"Result\">{}</td><td "
        "data-label=\"From\">{}{}</td></tr>\n",
        escape_html(run_key(run.spec)), escape_html(run.spec.profile), readable_duration(run.result.simulated_seconds),
        readable_duration(run.result.wall_seconds), run.result.threads,
        fs::exists(folder / file) ? fmt::format("<a href=\"{}\">HDF5</a>", escape_html(file))
                                  : escape_html(run.result.name),
        run.published ? "committed results" : "this machine", run.stale ? ", older numerics" : "");
  }
  std::string html = "<h2>Simulations and their cost</h2>\n";
  if (count == 0)
    return html + (keys.empty() ? "<p>This figure needs no simulation.</p>\n"
                                : fmt::format("<p>None of its {} simulations exists yet.</p>\n", keys.size()));
  return html +
         fmt::format("<p>{} of {}, {} of computing. The results are HDF5 files.</p>\n", count,
                     plural(keys.size(), "simulation"), readable_duration(wall)) +
         "<div class=\"card scroll\"><table class=\"stack\">\n<thead><tr><th>Run</th><th>Profile</th><th>Simulated</th>"
         "<th>Wall time</th><th>Threads</th><th>Result</th><th>From</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string downloads(const FigureOutput& output) {
  std::string html = "<div class=\"files\">";
  for (const char* format : {"svg", "png", "pdf", "gp"})
    html += fmt::format("<a href=\"{0}.{1}\">{1}</a>", escape_html(output.id), format);
  html += "</div>\n";
  if (output.data.empty()) return html;
  html += fmt::format("<details><summary>{} of data (CSV)</summary><div class=\"files\">",
                      plural(output.data.size(), "table"));
  for (const auto& data : output.data)
    html += fmt::format("<a href=\"{0}\">{0}</a>", escape_html(data.filename().string()));
  return html + "</div></details>\n";
}

std::string notes(const FigureOutput& output) {
  if (output.notes.empty()) return "";
  std::string html = "<details><summary>What to know of the simulations behind it</summary><ul>";
  for (const auto& note : output.notes) html += "<li>" + prose_html(note) + "</li>";
  return html + "</ul></details>\n";
}

/// Links to the pages before and after this one.
std::string neighbours(const ReportContents& contents, std::size_t place) {
  std::string html = "<a href=\"../index.html#figures\">All figures</a>";
  const auto link = [&](std::size_t other, const char* before, const char* after) {
    const std::string& id = contents.figures[other].id;
    const std::string label = label_of(id);
    html += fmt::format("<a href=\"{}.html\">{}{}{}</a>", escape_html(id), before,
                        label == "Study" ? prose_html(figure_named(id).title) : label, after);
  };
  if (place > 0) link(place - 1, "← ", "");
  if (place + 1 < contents.figures.size()) link(place + 1, "", " →");
  return html;
}

/// How the figure is measured; empty where nothing is written of it.
std::string measurement(const Figure& figure) {
  const fs::path readme = source_folder() / "experiments" / figure.folder / "README.md";
  if (figure.folder.empty() || !fs::exists(readme)) return "";
  return "<h2>How it is measured</h2>\n<div class=\"prose\">" + markdown_html(figure_definitions(read_file(readme))) +
         "</div>\n";
}

/// Picture, caption, claims, `measured`, doubts, simulations and commands of one figure.
std::string body(const ReportContents& contents, const FigureOutput& output, const std::string& measured,
                 const fs::path& folder) {
  const Figure& figure = figure_named(output.id);
  const auto claims = claims_of(contents, output.id);
  const bool simulated = !keys_of(contents, figure).empty();
  const std::string profile = !figure.needs(contents.profile).empty() ? contents.profile.name
                              : has_own_profile(figure)               ? figure.id
                                                                      : "full";

  std::string html = fmt::format(
      "<article class=\"card figure wide\">\n<div class=\"picture\"><a href=\"{0}.svg\"><img src=\"{0}.svg\" "
      "alt=\"{1}\"{2} /></a></div>\n<div class=\"words\"><p>{3}</p>\n{4}{5}</div>\n</article>\n",
      escape_html(output.id), escape_html(figure.title), image_size(folder / (output.id + ".svg")),
      prose_html(output.caption), downloads(output), notes(output));
  if (!claims.empty())
    html +=
        "<h2>What the paper states, and ours</h2>\n" + claim_table(claims, "") +
        "<p class=\"soft\">A statement is reproduced when the whole 95 % interval of our number lies in the band. The "
        "<a href=\"../claims.html\">table of all claims</a> says how verdicts are made.</p>\n";
  html += measured + doubts(contents, output.id);
  html += "<div class=\"on-screen\">\n" + simulations(contents, figure, folder);
  return html + fmt::format(
                    "<h2>Make it again</h2>\n<p>{}</p><code class=\"command\">build/slfb figures {}{}</code>\n"
                    "<p class=\"soft\">Redraw it with a look of your own, in a folder with its files above:</p><code "
                    "class=\"command\">gnuplot {}.gp</code>\n</div>\n",
                    simulated ? "Simulate what is missing and draw it:" : "Draw it; nothing is simulated:",
                    escape_html(output.id), simulated ? " --profile " + escape_html(profile) : " --no-run",
                    escape_html(output.id));
}

std::string heading(const ReportContents& contents, const FigureOutput& output) {
  return fmt::format("<span class=\"label\">{}</span><h1>{}</h1>\n<p>{}</p>\n", label_of(output.id),
                     prose_html(figure_named(output.id).title), badges(claims_of(contents, output.id)));
}

std::string page(const ReportContents& contents, std::size_t place, const fs::path& folder) {
  const FigureOutput& output = contents.figures[place];
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n<meta name=\"viewport\" "
             "content=\"width=device-width, initial-scale=1\" />\n<title>{}: "
             "{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
             "<header class=\"masthead slim\"><div>\n{}</div></header>\n<nav><div>{}</div></nav>\n<main>\n",
             label_of(output.id), prose_html(figure_named(output.id).title),
             read_file(source_folder() / "reports" / "report.css"), heading(contents, output),
             neighbours(contents, place)) +
         body(contents, output, measurement(figure_named(output.id)), folder) +
         fmt::format("<footer>slfb {}</footer>\n</main>\n</body>\n</html>\n", escape_html(SLFB_VERSION));
}

}  // namespace

std::string run_download(const FinishedRun& run) {
  const fs::path file = published_file(run.spec);
  return fmt::format("{}_{}", file.parent_path().filename().string(), file.filename().string());
}

std::string figure_gallery(const ReportContents& contents, const fs::path& figures_folder) {
  std::string html =
      "<section id=\"figures\">\n<h2>Figures and tables</h2>\n<p>The paper is drawn in black with open symbols or "
      "dashed "
      "lines, our simulations in colour with 95 % intervals, laws as thin lines. A symbol stands only where a number "
      "exists: the points of the paper's plots were never published as numbers, so only printed values appear. Each "
      "picture leads to its page, with the statements of the paper beside our numbers.</p>\n<div class=\"gallery\">\n";
  for (const auto& output : contents.figures)
    html += fmt::format(
        "<a class=\"card tile\" id=\"{0}\" href=\"figures/{0}.html\"><span class=\"thumb\"><img "
        "src=\"figures/{0}.svg\" "
        "alt=\"\"{1} loading=\"lazy\" /></span><span class=\"words\"><span class=\"label\">{2}</span><b>{3}</b><span "
        "class=\"badges\">{4}</span></span></a>\n",
        escape_html(output.id), image_size(figures_folder / (output.id + ".svg")), label_of(output.id),
        prose_html(figure_named(output.id).title), badges(claims_of(contents, output.id)));
  return html + "</div>\n</section>\n";
}

std::string figures_to_print(const ReportContents& contents, const fs::path& folder) {
  std::string html;
  std::set<std::string> texts;  // studies share theirs
  for (const FigureOutput& output : contents.figures) {
    std::string measured = measurement(figure_named(output.id));
    if (!texts.insert(measured).second) measured.clear();
    html += fmt::format("<section class=\"sheet\" id=\"{}\">\n{}{}</section>\n", escape_html(output.id),
                        heading(contents, output), body(contents, output, measured, folder));
  }
  // Not every printer of pages can draw gnuplot's SVG.
  static const std::regex picture("src=\"([^\"]+)\\.svg\"");
  return std::regex_replace(html, picture, "src=\"figures/$1.png\"");
}

void write_figure_pages(const ReportContents& contents, const fs::path& folder) {
  for (std::size_t place = 0; place < contents.figures.size(); ++place) {
    const fs::path file = folder / (contents.figures[place].id + ".html");
    std::ofstream stream(file, std::ios::binary);
    stream << page(contents, place, folder);
    stream.close();
    if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
  }
}

}  // namespace slfb
