#include "reports/figure_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "reports/claim_table.hpp"
#include "reports/html.hpp"
#include "solver/support/files.hpp"

namespace slfb::reports {
namespace {

namespace fs = std::filesystem;

/// Attributes width and height of a picture, so that the page does not move while it loads. gnuplot writes its size as
/// viewBox="0 0 WIDTH HEIGHT".
std::string image_size(const fs::path& svg) {
  std::smatch match;
  const std::string head = read_file(svg).substr(0, 1000);
  static const std::regex view_box("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"");
  if (!std::regex_search(head, match, view_box)) return "";
  return fmt::format(" width=\"{}\" height=\"{}\"", match.str(1), match.str(2));
}

/// "Figure 5"; for studies of ours their place beside the paper.
std::string label_of(const std::string& id) {
  return id.starts_with("fig") || id.starts_with("table") ? place_name(id) : "Study";
}

std::vector<const ClaimRow*> claims_of(const ReportContents& contents, const std::string& id) {
  std::vector<const ClaimRow*> claims;
  for (const ClaimRow& claim : contents.claims)
    if (claim.place == id) claims.push_back(&claim);
  return claims;
}

std::string badges(const std::vector<const ClaimRow*>& claims) {
  std::map<Verdict, std::size_t> counted;
  for (const ClaimRow* claim : claims) ++counted[claim->verdict];
  std::string html;
  for (const auto& [verdict, number] : counted)
    html +=
        fmt::format("<span class=\"badge {}\">{} {}</span> ", verdict_class(verdict), number, verdict_words(verdict));
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
  for (const InconsistencyRow& row : contents.inconsistencies)
    if (std::regex_search(row.source, place))
      items += fmt::format("<li><b>{}</b> ({}): {}</li>\n", prose_html(row.subject), escape_html(row.source),
                           prose_html(row.explanation));
  return items.empty() ? "" : "<h2>What does not add up in the paper</h2>\n<ul class=\"doubts\">\n" + items + "</ul>\n";
}

/// Simulations that the figure draws, and what they cost.
std::string simulations(const ReportContents& contents, const FigurePage& figure, const fs::path& folder) {
  std::string rows;
  double wall = 0.0;
  std::size_t count = 0;
  for (const RunRow& run : contents.runs) {
    if (std::ranges::find(figure.run_keys, run.key) == figure.run_keys.end()) continue;
    wall += run.wall_seconds;
    ++count;
    const std::string file = "../runs/" + run.download;
    rows += fmt::format(
        "<tr><td class=\"lead\">{}</td><td data-label=\"Profile\">{}</td><td data-label=\"Simulated\"><span "
        "class=\"number\">{}</span></td><td data-label=\"Wall time\"><span class=\"number\">{}</span></td><td "
        "data-label=\"Threads\">{}</td><td data-label=\"Result\">{}</td><td "
        "data-label=\"From\">{}{}</td></tr>\n",
        escape_html(run.key), escape_html(run.profile), readable_duration(run.simulated_seconds),
        readable_duration(run.wall_seconds), run.threads,
        fs::exists(folder / file) ? fmt::format("<a href=\"{}\">HDF5</a>", escape_html(file)) : escape_html(run.name),
        run.published ? "committed results" : "this machine", run.older_numerics ? ", older numerics" : "");
  }
  const std::size_t wanted = figure.run_keys.size();
  std::string html = "<h2>Simulations and their cost</h2>\n";
  if (count == 0)
    return html + (wanted == 0 ? "<p>This figure needs no simulation.</p>\n"
                               : fmt::format("<p>None of its {} simulations exists yet.</p>\n", wanted));
  return html +
         fmt::format("<p>{} of {}, {} of computing. The results are HDF5 files.</p>\n", count,
                     plural(wanted, "simulation"), readable_duration(wall)) +
         "<div class=\"card scroll\"><table class=\"stack\">\n<thead><tr><th>Run</th><th>Profile</th><th>Simulated</th>"
         "<th>Wall time</th><th>Threads</th><th>Result</th><th>From</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string downloads(const FigurePage& figure) {
  std::string html = "<div class=\"files\">";
  for (const char* format : {"svg", "png", "pdf", "gp"})
    html += fmt::format("<a href=\"{0}.{1}\">{1}</a>", escape_html(figure.id), format);
  html += "</div>\n";
  if (figure.data_files.empty()) return html;
  html += fmt::format("<details><summary>{} of data (CSV)</summary><div class=\"files\">",
                      plural(figure.data_files.size(), "table"));
  for (const std::string& file : figure.data_files) html += fmt::format("<a href=\"{0}\">{0}</a>", escape_html(file));
  return html + "</div></details>\n";
}

std::string notes(const FigurePage& figure) {
  if (figure.notes.empty()) return "";
  std::string html = "<details><summary>What to know of the simulations behind it</summary><ul>";
  for (const std::string& note : figure.notes) html += "<li>" + prose_html(note) + "</li>";
  return html + "</ul></details>\n";
}

/// Links to the pages before and after the figure with this position among all.
std::string neighbours(const ReportContents& contents, std::size_t position) {
  std::string html = "<a href=\"../index.html#figures\">All figures</a>";
  const auto link = [&](std::size_t other, const char* before, const char* after) {
    const FigurePage& figure = contents.figures[other];
    const std::string label = label_of(figure.id);
    html += fmt::format("<a href=\"{}.html\">{}{}{}</a>", escape_html(figure.id), before,
                        label == "Study" ? prose_html(figure.title) : label, after);
  };
  if (position > 0) link(position - 1, "← ", "");
  if (position + 1 < contents.figures.size()) link(position + 1, "", " →");
  return html;
}

/// How the figure is measured; empty where nothing is written of it.
std::string measurement(const FigurePage& figure) {
  if (figure.readme.empty()) return "";
  return "<h2>How it is measured</h2>\n<div class=\"prose\">" + markdown_html(figure.readme) + "</div>\n";
}

/// What its numbers say; empty where nothing is computed of it.
std::string findings(const FigurePage& figure) {
  if (figure.findings.empty()) return "";
  return "<h2>What the numbers say</h2>\n<div class=\"prose\">" + markdown_html(figure.findings) + "</div>\n";
}

/// Picture, caption, claims, findings, `measured`, doubts, simulations and commands of one figure.
std::string body(const ReportContents& contents, const FigurePage& figure, const std::string& measured,
                 const fs::path& folder) {
  const auto claims = claims_of(contents, figure.id);
  std::string html = fmt::format(
      "<article class=\"card figure wide\">\n<div class=\"picture\"><a href=\"{0}.svg\"><img src=\"{0}.svg\" "
      "alt=\"{1}\"{2} /></a></div>\n<div class=\"words\"><p>{3}</p>\n{4}{5}</div>\n</article>\n",
      escape_html(figure.id), escape_html(figure.title), image_size(folder / (figure.id + ".svg")),
      prose_html(figure.caption), downloads(figure), notes(figure));
  if (!claims.empty())
    html +=
        "<h2>What the paper states, and ours</h2>\n" + claim_table(claims, "") +
        "<p class=\"soft\">A statement is reproduced when the whole 95 % interval of our number lies in the band. The "
        "<a href=\"../claims.html\">table of all claims</a> says how verdicts are made.</p>\n";
  html += findings(figure) + measured + doubts(contents, figure.id);
  html += "<div class=\"on-screen\">\n" + simulations(contents, figure, folder);
  return html +
         fmt::format(
             "<h2>Make it again</h2>\n<p>{}</p><code class=\"command\">build/slfb figures {} {}</code>\n"
             "<p class=\"soft\">Redraw it with a look of your own, in a folder with its files above:</p><code "
             "class=\"command\">gnuplot {}.gp</code>\n</div>\n",
             figure.run_keys.empty() ? "Draw it; nothing is simulated:" : "Simulate what is missing and draw it:",
             escape_html(figure.id), escape_html(figure.options), escape_html(figure.id));
}

std::string heading(const ReportContents& contents, const FigurePage& figure) {
  return fmt::format("<span class=\"label\">{}</span><h1>{}</h1>\n<p>{}</p>\n", label_of(figure.id),
                     prose_html(figure.title), badges(claims_of(contents, figure.id)));
}

std::string page(const ReportContents& contents, std::size_t position, const fs::path& folder) {
  const FigurePage& figure = contents.figures[position];
  return html_page(
      fmt::format("{}: {}", label_of(figure.id), prose_html(figure.title)),
      fmt::format("<header class=\"masthead slim\"><div>\n{}</div></header>\n<nav><div>{}</div></nav>\n<main>\n{}"
                  "<footer>slfb {}</footer>\n</main>\n",
                  heading(contents, figure), neighbours(contents, position),
                  body(contents, figure, measurement(figure), folder), escape_html(SLFB_VERSION)));
}

}  // namespace

std::string figure_gallery(const ReportContents& contents, const fs::path& folder) {
  std::string html = "<section id=\"figures\">\n<h2>Figures and tables</h2>\n" +
                     markdown_html(contents.texts.about_figures) + "<div class=\"gallery\">\n";
  for (const FigurePage& figure : contents.figures)
    html += fmt::format(
        "<a class=\"card tile\" id=\"{0}\" href=\"figures/{0}.html\"><span class=\"thumb\"><img "
        "src=\"figures/{0}.svg\" "
        "alt=\"\"{1} loading=\"lazy\" /></span><span class=\"words\"><span class=\"label\">{2}</span><b>{3}</b><span "
        "class=\"badges\">{4}</span></span></a>\n",
        escape_html(figure.id), image_size(folder / (figure.id + ".svg")), label_of(figure.id),
        prose_html(figure.title), badges(claims_of(contents, figure.id)));
  return html + "</div>\n</section>\n";
}

std::string figures_to_print(const ReportContents& contents, const fs::path& folder) {
  std::string html;
  std::set<std::string> texts;  // studies share theirs
  for (const FigurePage& figure : contents.figures) {
    std::string measured = measurement(figure);
    if (!texts.insert(measured).second) measured.clear();
    html += fmt::format("<section class=\"sheet\" id=\"{}\">\n{}{}</section>\n", escape_html(figure.id),
                        heading(contents, figure), body(contents, figure, measured, folder));
  }
  // Not every printer of pages can draw gnuplot's SVG.
  static const std::regex picture("src=\"([^\"]+)\\.svg\"");
  return std::regex_replace(html, picture, "src=\"figures/$1.png\"");
}

void write_figure_pages(const ReportContents& contents, const fs::path& folder) {
  for (std::size_t position = 0; position < contents.figures.size(); ++position)
    write_file(folder / (contents.figures[position].id + ".html"), page(contents, position, folder));
}

}  // namespace slfb::reports
