#include "reports/figure_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

#include "reports/claim_table.hpp"
#include "reports/html.hpp"
#include "reports/navigation.hpp"
#include "solver/support/files.hpp"

namespace slfb::reports {
namespace {

namespace fs = std::filesystem;

/// Width and height of a picture [pixel]; gnuplot writes them as viewBox="0 0 WIDTH HEIGHT".
std::optional<std::pair<int, int>> size_of(const fs::path& svg) {
  std::smatch match;
  const std::string head = read_file(svg).substr(0, 1000);
  static const std::regex view_box("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"");
  if (!std::regex_search(head, match, view_box)) return std::nullopt;
  return std::pair{std::stoi(match.str(1)), std::stoi(match.str(2))};
}

/// Attributes width and height of a picture, so that the page does not move while it loads.
std::string image_size(const fs::path& svg) {
  const auto size = size_of(svg);
  return size ? fmt::format(" width=\"{}\" height=\"{}\"", size->first, size->second) : "";
}

/// Whether a picture would be too small to read on a phone if it were as wide as the screen: there it scrolls.
bool is_wide(const fs::path& svg) {
  const auto size = size_of(svg);
  return size && size->first > 700;
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
  std::set<std::string> found;  // a run may have been made by several profiles
  for (const RunRow& run : contents.runs) {
    if (std::ranges::find(figure.run_keys, run.key) == figure.run_keys.end()) continue;
    wall += run.wall_seconds;
    found.insert(run.key);
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
  if (found.empty())
    return html + (wanted == 0 ? "<p>This figure needs no simulation.</p>\n"
                               : fmt::format("<p>None of its {} simulations exists yet.</p>\n", wanted));
  return html +
         fmt::format("<p>{} of {}, {} of computing. The results are HDF5 files.</p>\n", found.size(),
                     plural(wanted, "simulation"), readable_duration(wall)) +
         "<div class=\"card scroll\"><table class=\"stack\">\n<thead><tr><th>Run</th><th>Profile</th><th>Simulated</th>"
         "<th>Wall time</th><th>Threads</th><th>Result</th><th>From</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

/// \param files where the files of the figure lie, from the page
std::string downloads(const FigurePage& figure, const std::string& files) {
  std::string html = "<div class=\"files\">";
  for (const char* format : {"svg", "png", "pdf", "gp"})
    html += fmt::format("<a href=\"{0}{1}.{2}\">{2}</a>", files, escape_html(figure.id), format);
  html += "</div>\n";
  if (figure.data_files.empty()) return html;
  html += fmt::format("<details><summary>{} of data (CSV)</summary><div class=\"files\">",
                      plural(figure.data_files.size(), "table"));
  for (const std::string& file : figure.data_files)
    html += fmt::format("<a href=\"{0}{1}\">{1}</a>", files, escape_html(file));
  return html + "</div></details>\n";
}

/// A sentence "HERE, not THERE." as its two sides.
std::optional<std::pair<std::string, std::string>> two_sides(const std::string& sentence) {
  constexpr std::string_view middle = ", not ";
  const std::size_t found = sentence.find(middle);
  if (found == std::string::npos || sentence.find(middle, found + 1) != std::string::npos || !sentence.ends_with('.') ||
      sentence.find(". ") != std::string::npos)
    return std::nullopt;
  const std::size_t there = found + middle.size();
  return std::pair{sentence.substr(0, found), sentence.substr(there, sentence.size() - there - 1)};
}

/// What sets the simulations apart from those of the source, in two columns, and what else to know of them.
std::string notes(const FigurePage& figure) {
  std::vector<std::vector<std::string>> rows;
  std::string others;
  for (const std::string& note : figure.notes) {
    if (const auto sides = two_sides(note))
      rows.push_back({prose_html(sides->first), prose_html(sides->second)});
    else
      others += "<li>" + prose_html(note) + "</li>";
  }
  std::string html;
  if (!rows.empty())
    html += "<h2>What sets the simulations apart from the paper's</h2>\n<div class=\"pairs\">" +
            table_html({"Here", "Paper"}, rows) + "</div>\n";
  if (!others.empty()) html += "<details><summary>What else to know of it</summary><ul>" + others + "</ul></details>\n";
  return html;
}

/// Links to the pages of the laws that the figure draws or that its simulations use.
std::string laws(const FigurePage& figure) {
  std::string html;
  for (const std::string& law : figure.laws)
    html += fmt::format("{0}<a href=\"../laws/{1}.html\">{1}</a>", html.empty() ? "" : " · ", escape_html(law));
  return html.empty() ? "" : "<h2>Laws behind it</h2>\n<p>" + html + "</p>\n";
}

/// The picture of a figure, or its table.
std::string shown(const FigurePage& figure, const fs::path& folder, const std::string& files, const char* format) {
  if (!figure.table.rows.empty()) {
    std::vector<std::string> headings;
    for (const std::string& heading : figure.table.headings) headings.push_back(prose_html(heading));
    std::vector<std::vector<std::string>> rows = figure.table.rows;
    for (auto& row : rows)
      for (std::string& cell : row) cell = prose_html(cell);
    return table_html(headings, rows);
  }
  return fmt::format(
      "<div class=\"picture{4}\"><a href=\"{0}{1}.svg\"><img src=\"{0}{1}.{5}\" alt=\"{2}\"{3} /></a></div>", files,
      escape_html(figure.id), escape_html(figure.caption), image_size(folder / (figure.id + ".svg")),
      is_wide(folder / (figure.id + ".svg")) ? " broad" : "", format);
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

/// Picture, caption, claims, findings, `measured`, doubts, simulations and commands of one figure. \param files where
/// its files lie, from the page \param format of the picture
std::string body(const ReportContents& contents, const FigurePage& figure, const std::string& measured,
                 const fs::path& folder, const std::string& files, const char* format) {
  const auto claims = claims_of(contents, figure.id);
  std::string html =
      fmt::format("<article class=\"card figure wide\">\n{}\n<div class=\"words\"><p>{}</p>\n{}</div>\n</article>\n",
                  shown(figure, folder, files, format), prose_html(figure.caption), downloads(figure, files));
  if (!claims.empty())
    html += "<h2>What the paper states, and ours</h2>\n" + claim_table(claims, "../claims.html") +
            "<p class=\"soft\">A statement is reproduced when the whole 95 % interval of our number lies in the band, "
            "or where the paper has one drop when that drop is one that ours give. The "
            "<a href=\"../claims.html\">table of all claims</a> says how verdicts are made.</p>\n";
  html += findings(figure) + notes(figure) + measured + doubts(contents, figure.id) + laws(figure);
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
                     prose_html(figure.title), verdict_badges(claims_of(contents, figure.id)));
}

/// What the navigation calls the page; empty where it does not name it.
std::string featured_label(const ReportContents& contents, const std::string& id) {
  for (const FeaturedPage& page : contents.texts.featured)
    if (page.figure == id) return escape_html(page.label);
  return "";
}

std::string page(const ReportContents& contents, std::size_t position, const fs::path& folder) {
  const FigurePage& figure = contents.figures[position];
  return html_page(
      fmt::format("{}: {}", label_of(figure.id), prose_html(figure.title)),
      fmt::format(
          "<header class=\"masthead slim\"><div>\n{}</div></header>\n{}<main>\n<p class=\"neighbours\">{}</p>\n{}"
          "<footer>slfb {}</footer>\n</main>\n",
          heading(contents, figure), navigation(contents, featured_label(contents, figure.id), "../"),
          neighbours(contents, position), body(contents, figure, measurement(figure), folder, "", "svg"),
          escape_html(SLFB_VERSION)));
}

}  // namespace

std::string figure_gallery(const ReportContents& contents, const fs::path& folder) {
  std::string html = "<section id=\"figures\">\n<h2>Figures and tables</h2>\n" +
                     markdown_html(contents.texts.about_figures) + "<div class=\"gallery\">\n";
  for (const FigurePage& figure : contents.figures)
    html += fmt::format(
        "<a class=\"card tile\" id=\"{0}\" href=\"figures/{0}.html\"><span class=\"thumb\"><img "
        "src=\"figures/{0}.svg\" "
        "alt=\"{3}\"{1} loading=\"lazy\" /></span><span class=\"words\"><span "
        "class=\"label\">{2}</span><b>{4}</b><span "
        "class=\"badges\">{5}</span></span></a>\n",
        escape_html(figure.id), image_size(folder / (figure.id + ".svg")), label_of(figure.id),
        escape_html(figure.caption), prose_html(figure.title), verdict_badges(claims_of(contents, figure.id)));
  return html + "</div>\n</section>\n";
}

std::string figures_to_print(const ReportContents& contents, const fs::path& folder) {
  std::string html;
  std::set<std::string> texts;  // studies share theirs
  for (const FigurePage& figure : contents.figures) {
    std::string measured = measurement(figure);
    if (!texts.insert(measured).second) measured.clear();
    html += fmt::format("<section class=\"sheet\" id=\"{}\">\n{}{}</section>\n", escape_html(figure.id),
                        heading(contents, figure),
                        // Not every printer of pages can draw gnuplot's SVG.
                        body(contents, figure, measured, folder, "figures/", "png"));
  }
  return html;
}

void write_figure_pages(const ReportContents& contents, const fs::path& folder) {
  for (std::size_t position = 0; position < contents.figures.size(); ++position)
    write_file(folder / (contents.figures[position].id + ".html"), page(contents, position, folder));
}

}  // namespace slfb::reports
