#include "experiments/work/article.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/work/profiles.hpp"
#include "experiments/work/report_pages.hpp"
#include "reports/article.hpp"
#include "reports/html.hpp"
#include "solver/support/files.hpp"

namespace slfb {

const char* const article_places =
    R"(  claims, reproduced, not_reproduced, not_decidable   how many claims there are of each verdict
  runs, computing_time, simulated_time                  simulations behind the article
  profile, numerics_version, citation                   what was run, and of which work
  printed ID                                            a number of reference-data/WORK with its unit
  measured QUANTITY/SYSTEM/U_L                          ours with its 95 % interval and unit
  claims_of FIGURE                                      table of the claims of a figure or table
  inconsistencies                                       table of numbers of the work that contradict each other
  choices                                               table of the choices that the work leaves open
  figure ID                                             a figure with its caption
  findings ID                                           what a figure computes in words)";

namespace {

namespace fs = std::filesystem;

/// Bars end cells of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() || unit == "-" ? number : number + " " + unit;
}

std::string verdict_text(reports::Verdict verdict) {
  switch (verdict) {
    case reports::Verdict::reproduced:
      return "reproduced";
    case reports::Verdict::not_reproduced:
      return "not reproduced";
    case reports::Verdict::not_decidable:
      return "not decidable";
  }
  throw std::logic_error("article: unknown verdict");
}

/// Answers the places of an article.
class Places {
 public:
  Places(const Work& work, const Judgement& judgement, const fs::path& out, fs::path folder)
      : work_(work), judgement_(judgement), out_(out), folder_(std::move(folder)) {
    const ClaimCounts counts = count(judgement.evaluations);
    words_["claims"] = fmt::format("{}", judgement.evaluations.size());
    words_["reproduced"] = fmt::format("{}", counts.reproduced);
    words_["not_reproduced"] = fmt::format("{}", counts.not_reproduced);
    words_["not_decidable"] = fmt::format("{}", counts.not_decidable);
    std::vector<FinishedRun> all = judgement.runs;
    for (const std::string& name : work.read_by_figures)
      if (name != judgement.profile.name)
        for (FinishedRun& run : finished_runs(load_profile(work, name), out)) all.push_back(std::move(run));
    double computing = 0.0, simulated = 0.0;
    for (const FinishedRun& run : all) {
      computing += run.result.wall_seconds * run.result.threads;
      simulated += run.result.simulated_seconds;
    }
    words_["runs"] = fmt::format("{}", all.size());
    words_["computing_time"] = readable_duration(computing);
    words_["simulated_time"] = readable_duration(simulated);
    words_["profile"] = judgement.profile.name;
    words_["numerics_version"] = fmt::format("{}", numerics_version);
    words_["citation"] = work.citation;
  }

  std::string operator()(const std::string& words) {
    if (const auto known = words_.find(words); known != words_.end()) return known->second;
    const auto space = words.find(' ');
    const std::string what = words.substr(0, space), of = space == std::string::npos ? "" : words.substr(space + 1);
    if (what == "printed") return printed(of);
    if (what == "measured") return measured(of);
    if (what == "claims_of") return claims_of(of);
    if (what == "inconsistencies" && of.empty()) return inconsistencies();
    if (what == "choices" && of.empty()) return choices();
    if (what == "figure") return figure(of);
    if (what == "findings") return drawn(of).findings;
    throw std::invalid_argument(fmt::format("\"{}\" is no place of an article; known:\n{}", words, article_places));
  }

 private:
  [[nodiscard]] std::string printed(const std::string& id) const {
    if (work_.reference == nullptr || !work_.reference->values().contains(id))
      throw std::invalid_argument(fmt::format("the work prints no number \"{}\"", id));
    const ReferenceValue& value = work_.reference->at(id);
    return with_unit(readable_number(value.value), value.unit);
  }

  [[nodiscard]] std::string measured(const std::string& key) const {
    const auto found = judgement_.measurements.find(parse_measure_key(key));
    if (found == judgement_.measurements.end())
      throw std::invalid_argument(fmt::format("nothing measured is called \"{}\" (`slfb check` lists what is)", key));
    const Measurement& value = found->second;
    std::string text = readable_number(value.value);
    if (value.half_width > 0.0) text += " ± " + readable_number(value.half_width);
    return with_unit(text, value.unit);
  }

  [[nodiscard]] std::string claims_of(const std::string& place) const {
    std::string table = "\n| statement | paper | ours | verdict |\n|---|---|---|---|\n";
    std::size_t rows = 0;
    for (const Evaluation& evaluation : judgement_.evaluations) {
      const reports::ClaimRow row = claim_row(evaluation);
      if (row.place != place) continue;
      ++rows;
      table += fmt::format("| {} | {} | {} | {} |\n", cell(row.quantity),
                           cell(row.paper_in_words ? row.paper : with_unit(row.paper, row.unit)),
                           row.ours ? with_unit(readable_number(*row.ours), row.unit) : "–", verdict_text(row.verdict));
    }
    if (rows == 0) throw std::invalid_argument(fmt::format("there are no claims of \"{}\"", place));
    return table;
  }

  [[nodiscard]] std::string inconsistencies() const {
    if (!work_.inconsistencies) throw std::invalid_argument("the work has no list of inconsistencies");
    std::string table = "\n| subject | printed | recomputed | why |\n|---|---|---|---|\n";
    for (const reports::InconsistencyRow& row : work_.inconsistencies())
      table += fmt::format("| {} ({}) | {} | {} | {} |\n", cell(row.subject), cell(row.source),
                           with_unit(readable_number(row.paper), row.unit),
                           with_unit(readable_number(row.recomputed), row.unit), cell(row.explanation));
    return table;
  }

  [[nodiscard]] std::string choices() const {
    std::string table = "\n| choice | what the paper says | tried |\n|---|---|---|\n";
    for (const readings::Factor& factor : load_choices(work_).factors) {
      std::vector<std::string> levels;
      for (const readings::Level& level : factor.levels) levels.push_back(level.title);
      table += fmt::format("| {} | {} | {} |\n", cell(factor.title), cell(factor.source),
                           cell(fmt::format("{}", fmt::join(levels, "; "))));
    }
    return table;
  }

  std::string figure(const std::string& id) {
    const FigureOutput& output = drawn(id);
    // PNG, since the printer (WeasyPrint) takes no "currentColor", which the points of gnuplot's SVG have.
    return fmt::format(
        "\n<figure><img src=\"figures/{0}.png\" alt=\"{1}\" />\n<figcaption>Figure {2}. {3}</figcaption>"
        "</figure>\n",
        id, escape_html(id), ++figures_, prose_html(output.caption));
  }

  const FigureOutput& drawn(const std::string& id) {
    if (const auto known = outputs_.find(id); known != outputs_.end()) return known->second;
    const auto figure = std::ranges::find(work_.figures, id, &Figure::id);
    if (figure == work_.figures.end()) throw std::invalid_argument(fmt::format("there is no figure \"{}\"", id));
    const fs::path figures = folder_ / "figures";
    fs::create_directories(figures);
    return outputs_
        .emplace(id, figure->draw({judgement_.shown, judgement_.runs, judgement_.measurements, figures, out_}))
        .first->second;
  }

  const Work& work_;
  const Judgement& judgement_;
  const fs::path& out_;
  fs::path folder_;
  std::map<std::string, std::string> words_;
  std::map<std::string, FigureOutput> outputs_;
  int figures_ = 0;
};

}  // namespace

void write_article(const Work& work, const Judgement& judgement, const fs::path& out, const fs::path& folder) {
  const fs::path source = work.folders.experiments / "article";
  if (!fs::exists(source / "article.md"))
    throw std::invalid_argument(
        fmt::format("{} has no article; needed is {}", work.id, (source / "article.md").string()));
  fs::create_directories(folder);
  Places places(work, judgement, out, folder);
  const auto fill = [&](const std::string& words) { return places(words); };
  const auto filled = [&](const char* name) {
    const fs::path file = source / name;
    return reports::fill_template(read_file(file), file.string(), fill);
  };
  const std::string article = filled("article.md");
  write_file(folder / "article.md", article);
  write_file(folder / "article.html", reports::article_html(article));
  write_file(folder / "metadata.yaml", filled("metadata.yaml"));
}

}  // namespace slfb
