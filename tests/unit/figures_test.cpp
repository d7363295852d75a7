#include "experiments/peng_2014/figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "correlations/catalogue.hpp"
#include "experiments/claims/claims.hpp"
#include "experiments/figures/figure.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/figures/sphere_picture.hpp"
#include "experiments/peng_2014/inconsistencies.hpp"
#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/report_texts.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/report_pages.hpp"
#include "reports/figure_pages.hpp"
#include "reports/gnuplot.hpp"
#include "reports/html.hpp"
#include "reports/report.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/synthetic_runs.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A heading says what it is and in which unit: "voidage [-]".
void expect_headings_with_units(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  ASSERT_TRUE(std::getline(stream, line)) << file;
  std::istringstream headings(line);
  const std::regex pattern(R"(\S.* \[[^\]]+\])");
  for (std::string heading; std::getline(headings, heading, ',');)
    EXPECT_TRUE(std::regex_match(heading, pattern)) << file << ": " << heading;
}

/// Every link and picture of a page that stands alone: those within it lead to an id of it, those beside it to a file.
void expect_links_lead_somewhere(const fs::path& file) {
  pugi::xml_document page;
  const auto parsed = page.load_file(file.c_str(), pugi::parse_default, pugi::encoding_utf8);
  ASSERT_TRUE(parsed) << file << ": " << parsed.description() << " at byte " << parsed.offset;
  std::set<std::string> ids;
  for (const auto& found : page.select_nodes("//@id")) ids.insert(found.attribute().value());
  for (const auto& found : page.select_nodes("//@href | //@src")) {
    const std::string target = found.attribute().value();
    if (target.starts_with("https://")) continue;
    if (target.starts_with("#"))
      EXPECT_TRUE(ids.contains(target.substr(1))) << file << ": " << target;
    else
      EXPECT_TRUE(fs::exists(file.parent_path() / target.substr(0, target.find('#')))) << file << ": " << target;
  }
}

struct Drawn {
  Profile profile = synthetic::profile();
  std::vector<FinishedRun> runs;
  Measurements measurements;
  std::vector<FigureOutput> outputs;
};

/// The report of what was drawn, in `folder`/report.
reports::ReportContents write_report_of(const Drawn& drawn, const std::vector<Evaluation>& evaluations,
                                        const fs::path& figures_folder, const fs::path& folder) {
  const Judgement judgement{drawn.profile, drawn.profile, drawn.runs, drawn.measurements, evaluations};
  const reports::ReportContents contents =
      report_contents({peng_2014_work(), judgement, drawn.runs, drawn.outputs, folder});
  reports::write_report(contents, figures_folder, folder / "report");
  return contents;
}

Drawn draw_all(bool with_runs, const fs::path& folder) {
  Drawn drawn;
  if (with_runs) drawn.runs = synthetic::runs(drawn.profile);
  drawn.measurements = measure_without_runs();
  drawn.measurements.merge(measure_runs(drawn.runs, peng_2014_work().measuring));
  for (const auto& figure : figures())
    drawn.outputs.push_back(figure.draw({drawn.profile, drawn.runs, drawn.measurements, folder, folder}));
  return drawn;
}

/// Titles of axes that stand in a script as they are, up to their first subscript: "voidage" of 'voidage α_L [-]'.
std::set<std::string> axis_titles(const std::string& script) {
  static const std::regex line("(^|\n) *set [xy]label ['\"]([^'\"_^]+)");
  std::set<std::string> titles;
  for (std::sregex_iterator found(script.begin(), script.end(), line), end; found != end; ++found)
    titles.insert((*found)[2]);
  return titles;
}

/// Turned texts of an SVG of gnuplot that begin left of the picture. A letter reaches 0.75 of its size above its line.
std::vector<std::string> cut_at_the_left(const std::string& picture) {
  static const std::regex turned(
      "translate\\(([-0-9.]+),[-0-9.]+\\) rotate\\(270\\)\"[^>]*font-size=\"([0-9.]+)\"[^>]*>\\s*<text>(.*)</text>");
  std::vector<std::string> cut;
  for (std::sregex_iterator found(picture.begin(), picture.end(), turned), end; found != end; ++found)
    if (std::stod((*found)[1]) < 0.75 * std::stod((*found)[2])) cut.push_back((*found)[3]);
  return cut;
}

class EveryFigure : public testing::TestWithParam<bool> {};

TEST_P(EveryFigure, LeavesPicturesScriptDataAndWords) {
  const Folder folder;
  const Drawn drawn = draw_all(GetParam(), folder.path());
  ASSERT_EQ(drawn.outputs.size(), figures().size());
  for (std::size_t i = 0; i < drawn.outputs.size(); ++i) {
    const FigureOutput& output = drawn.outputs[i];
    EXPECT_EQ(output.id, figures()[i].id);
    EXPECT_GT(output.caption.size(), 80u) << output.id;
    EXPECT_FALSE(output.notes.empty()) << output.id;
    for (const char* format : {"svg", "png", "pdf", "gp"}) {
      const fs::path file = folder.path() / (output.id + "." + format);
      ASSERT_TRUE(fs::exists(file)) << file;
      EXPECT_GT(fs::file_size(file), 500u) << file;
    }
    for (const auto& data : output.data) {
      ASSERT_TRUE(fs::exists(data)) << data;
      expect_headings_with_units(data);
    }
    const std::string script = read(folder.path() / (output.id + ".gp"));
    EXPECT_EQ(script.find(folder.path().string()), std::string::npos) << "the script names no folder";
    const std::string picture = read(folder.path() / (output.id + ".svg"));
    // gnuplot leaves out what would begin outside the picture.
    for (const std::string& title : axis_titles(script))
      EXPECT_NE(picture.find(escape_html(title)), std::string::npos) << output.id << " lost '" << title << "'";
    EXPECT_EQ(cut_at_the_left(picture), std::vector<std::string>{}) << output.id;
    const bool says_missing = picture.find("ot yet simulated") != std::string::npos;
    const auto needed = figures()[i].needs(drawn.profile);
    const auto exists = [&](const std::string& key) {
      return std::any_of(drawn.runs.begin(), drawn.runs.end(),
                         [&](const FinishedRun& run) { return run_key(run.spec) == key; });
    };
    const auto existing = static_cast<std::size_t>(std::count_if(needed.begin(), needed.end(), exists));
    if (existing == 0) {
      EXPECT_EQ(says_missing, !needed.empty()) << output.id;
    } else if (existing == needed.size()) {
      EXPECT_FALSE(says_missing) << output.id;
    }
  }
}

TEST_P(EveryFigure, IsRedrawnByItsScriptInAnyFolder) {
  const Folder folder, elsewhere;
  const Drawn drawn = draw_all(GetParam(), folder.path());
  for (const auto& output : drawn.outputs) {
    fs::copy_file(folder.path() / (output.id + ".gp"), elsewhere.path() / (output.id + ".gp"));
    for (const auto& data : output.data) fs::copy_file(data, elsewhere.path() / data.filename());
    const std::string command =
        "cd '" + elsewhere.path().string() + "' && gnuplot '" + output.id + ".gp' > messages 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << output.id << ": " << read(elsewhere.path() / "messages");
    EXPECT_EQ(read(elsewhere.path() / "messages"), "") << output.id;
    EXPECT_EQ(read(elsewhere.path() / (output.id + ".svg")), read(folder.path() / (output.id + ".svg"))) << output.id;
  }
}

TEST_P(EveryFigure, AppearsInTheReportWithEveryClaim) {
  const Folder folder;
  const fs::path figures_folder = folder.path() / "figures";
  fs::create_directories(figures_folder);
  const Drawn drawn = draw_all(GetParam(), figures_folder);
  const auto evaluations = evaluate(load_claims(), drawn.measurements);
  const reports::ReportContents contents = write_report_of(drawn, evaluations, figures_folder, folder.path());
  fs::remove_all(figures_folder);  // the report is a folder of its own

  std::set<std::string> ids, targets;
  for (const char* name : {"index.html", "claims.html", "inconsistencies.html", "methods.html", "laws.html",
                           "quantities.html", "data.html", "flow.html", "provenance.html", "search.html"}) {
    pugi::xml_document page;
    const auto parsed =
        page.load_file((folder.path() / "report" / name).c_str(), pugi::parse_default, pugi::encoding_utf8);
    ASSERT_TRUE(parsed) << name << ": " << parsed.description() << " at byte " << parsed.offset;
    for (const auto& found : page.select_nodes("//*[@id]")) {
      const std::string id = found.node().attribute("id").value();
      EXPECT_TRUE(ids.insert(id).second) << id << " is used twice";
    }
    for (const auto& found : page.select_nodes("//@href | //@src")) targets.insert(found.attribute().value());
  }
  for (const auto& evaluation : evaluations) EXPECT_TRUE(ids.contains(evaluation.claim.id)) << evaluation.claim.id;
  for (const auto& figure : figures()) EXPECT_TRUE(ids.contains(figure.id)) << figure.id;
  for (const auto& row : contents.inconsistencies) EXPECT_TRUE(ids.contains("inconsistency-" + row.id)) << row.id;
  for (const auto& figure : figures()) {
    const fs::path file = folder.path() / "report" / "figures" / (figure.id + ".html");
    pugi::xml_document figure_page;
    const auto figure_parsed = figure_page.load_file(file.c_str(), pugi::parse_default, pugi::encoding_utf8);
    ASSERT_TRUE(figure_parsed) << file << ": " << figure_parsed.description();
    const auto rows = figure_page.select_nodes("//tr[@data-verdict]").size();
    EXPECT_EQ(static_cast<std::ptrdiff_t>(rows),
              std::count_if(evaluations.begin(), evaluations.end(),
                            [&](const Evaluation& evaluation) { return evaluation.claim.figure == figure.id; }))
        << figure.id << ": every claim of the figure stands on its page";
    EXPECT_NE(read(file).find("How it is measured"), std::string::npos) << figure.id << " has no README";
    for (const auto& found : figure_page.select_nodes("//@href | //@src")) {
      const std::string target = found.attribute().value();
      EXPECT_TRUE(fs::exists(file.parent_path() / target.substr(0, target.find('#')))) << file << ": " << target;
    }
  }
  expect_links_lead_somewhere(folder.path() / "report" / "print.html");
  for (const CatalogueEntry& law : catalogue()) {
    const fs::path file = folder.path() / "report" / "laws" / (std::string(law.info.name) + ".html");
    pugi::xml_document law_page;
    const auto law_parsed = law_page.load_file(file.c_str(), pugi::parse_default, pugi::encoding_utf8);
    ASSERT_TRUE(law_parsed) << file << ": " << law_parsed.description();
    for (const auto& found : law_page.select_nodes("//@href | //@src")) {
      const std::string target = found.attribute().value();
      EXPECT_TRUE(fs::exists(file.parent_path() / target.substr(0, target.find('#')))) << file << ": " << target;
    }
  }
  for (const std::string& target : targets) {
    if (target.starts_with("https://doi.org/")) continue;
    const auto hash = target.find('#');
    EXPECT_TRUE(fs::exists(folder.path() / "report" / target.substr(0, hash))) << target;
    if (hash == std::string::npos) continue;
    EXPECT_TRUE(ids.contains(target.substr(hash + 1))) << target;
  }
  const auto listed = nlohmann::json::parse(read(folder.path() / "report" / "claims.json")).at("claims").size();
  EXPECT_EQ(listed, evaluations.size());
}

// A committed quick run, thinned, must not hide the whole one of the full profile.
TEST(FindRun, PrefersTheCurrentRunThatRecordsMost) {
  const Folder folder;
  const Profile profile = synthetic::profile();
  std::vector<FinishedRun> runs = synthetic::runs(profile);
  runs.resize(1);
  const std::string key = run_key(runs[0].spec);
  FinishedRun whole = runs[0], thinned = runs[0];
  ASSERT_FALSE(whole.result.snapshots.empty());
  thinned.result.snapshots.clear();
  const auto found = [&](std::vector<FinishedRun> candidates) {
    const FinishedRun* run = find_run({profile, candidates, {}, folder.path(), folder.path()}, key);
    return run == nullptr ? std::ptrdiff_t{-1} : run - candidates.data();
  };
  EXPECT_EQ(found({thinned, whole}), 1);
  EXPECT_EQ(found({whole, thinned}), 0);
  whole.stale = true;
  EXPECT_EQ(found({whole, thinned}), 1);
  EXPECT_EQ(found({}), -1);
}

// Figures of single contacts draw the springs that their footer names, also where the time of a sample is rounded
// otherwise in the softened run.
TEST(FindRun, PrefersTheScenesOwnSpringsToEquallyFineSoftenedOnes) {
  FinishedRun soft = synthetic::run("6in5W", 0.10, "", 1), stiff = soft;
  soft.result.name = "soft";
  stiff.result.name = "stiff";
  for (double& time : soft.result.drops.front().time) time *= 1.0 - 1e-12;
  const Profile profile;
  const Measurements measurements;
  const std::vector<FinishedRun> runs{soft}, own_springs{stiff};
  const FigureContext context{profile, runs, measurements, {}, {}};
  EXPECT_EQ(find_contact_run(context, own_springs, "6in5W/0.10")->result.name, "stiff");
  // A run that was recorded ten times as often shows peaks that the other has lost.
  std::vector<FinishedRun> thinned{stiff};
  for (double& time : thinned.front().result.drops.front().time) time *= 10.0;
  EXPECT_EQ(find_contact_run(context, thinned, "6in5W/0.10")->result.name, "soft");
}

TEST(Report, OffersTheResultOfEachRun) {
  const Folder folder;
  fs::create_directories(folder.path() / "figures");
  Drawn drawn;
  drawn.runs = synthetic::runs(drawn.profile);
  drawn.runs.resize(1);
  FinishedRun& run = drawn.runs.front();
  run.result.name = "0123456789abcdef";
  save_result(run.result, result_file(folder.path(), run.result.name));
  const auto evaluations = evaluate(load_claims(), drawn.measurements);
  const reports::ReportContents contents =
      write_report_of(drawn, evaluations, folder.path() / "figures", folder.path());
  EXPECT_EQ(load_result(folder.path() / "report" / "runs" / contents.runs.front().download).name, run.result.name);
}

INSTANTIATE_TEST_SUITE_P(Figures, EveryFigure, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "WithRuns" : "WithoutRuns"; });

TEST(Gnuplot, AFailingScriptThrowsWithItsMessage) {
  const Folder folder;
  std::ofstream(folder.path() / "figure.gp") << "plot 'absent.csv' using 1:2\n";
  try {
    draw_plot("broken", folder.path() / "figure.gp", {}, {}, folder.path());
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("absent.csv"), std::string::npos) << error.what();
  }
}

TEST(Gnuplot, APictureIsDrawnAgainOnlyWhereItsScriptOrItsNumbersChange) {
  const Folder folder;
  const fs::path plot = folder.path() / "figure.gp", picture = folder.path() / "line.svg";
  std::ofstream(plot) << "plot 'numbers.csv' skip 1 using 1:2 with lines notitle\n";
  const auto draw = [&] { draw_plot("line", plot, {}, {}, folder.path(), {}, {"svg"}); };
  write_csv({"numbers", {"a [-]", "b [-]"}, {{0.0, 1.0}, {1.0, 2.0}}}, folder.path());
  draw();
  std::ofstream(picture) << "as it was";
  draw();
  EXPECT_EQ(read(picture), "as it was");
  write_csv({"numbers", {"a [-]", "b [-]"}, {{0.0, 1.0}, {1.0, 3.0}}}, folder.path());
  draw();
  EXPECT_NE(read(picture).find("<svg"), std::string::npos) << "other numbers";
  std::ofstream(picture) << "as it was";
  std::ofstream(plot) << "plot 'numbers.csv' skip 1 using 1:2 with points notitle\n";
  draw();
  EXPECT_NE(read(picture).find("<svg"), std::string::npos) << "another script";
  fs::remove(picture);
  draw();
  EXPECT_TRUE(fs::exists(picture)) << "a picture that was removed";
}

TEST(Gnuplot, AnAbsentGnuplotThrowsAndSaysWhatToInstall) {
  const Folder folder;
  std::ofstream(folder.path() / "figure.gp") << "plot x\n";
  const char* search_path = getenv("PATH");
  ASSERT_NE(search_path, nullptr);
  const std::string path = search_path;
  setenv("PATH", folder.path().c_str(), 1);
  std::string message;
  try {
    draw_plot("absent", folder.path() / "figure.gp", {}, {}, folder.path());
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(message.find("gnuplot-nox"), std::string::npos) << message;
}

TEST(Gnuplot, ARowThatDoesNotMatchTheHeadingsIsRefused) {
  const Folder folder;
  EXPECT_THROW(write_csv({"table", {"a [-]", "b [-]"}, {{1.0}}}, folder.path()), std::runtime_error);
}

/// Spheres in a row away from the eye at y = −0.01, 0, 0.01, 0.02: the first is in front of the clipping plane, the
/// last two are hidden behind the second.
TEST(SpherePicture, ShowsWhatIsNotHiddenAndWhatIsNotClipped) {
  Snapshot snapshot{"ends", 0.0, -1, {0, 0, 0, 0}, {-0.01, 0.0, 0.01, 0.02}, {0.05, 0.05, 0.05, 0.05}, {}};
  snapshot.radius.assign(4, 0.0025);
  const SphereView view{.lower_x = -0.01, .upper_x = 0.01, .lower_z = 0.04, .upper_z = 0.06};
  const auto discs_per_sphere = sphere_picture(snapshot, view, "one").rows.size();
  ASSERT_GT(discs_per_sphere, 1u);
  snapshot.x[2] = 0.004;  // now it looks out from behind
  EXPECT_EQ(sphere_picture(snapshot, view, "two").rows.size(), 2 * discs_per_sphere);
  EXPECT_DOUBLE_EQ(sphere_picture(snapshot, view, "two").rows.front()[0], 0.004) << "the farthest is painted first";
  snapshot.foreign = 0;  // the dropped sphere is never clipped: it is in front of all and hides the second
  const auto rows = sphere_picture(snapshot, view, "three").rows;
  EXPECT_EQ(rows.size(), 2 * discs_per_sphere);
  const auto colour = static_cast<int>(rows.back()[3]);
  EXPECT_GE(colour >> 16, (colour >> 8 & 255)) << "it is red";
  snapshot.z.assign(4, 0.10);
  EXPECT_TRUE(sphere_picture(snapshot, view, "none").rows.empty());
}

TEST(Html, AReadmeKeepsItsParagraphsBoldWordsCodeAndTables) {
  EXPECT_EQ(markdown_html("# Title\n\n**We** measure\nV_2 < 1.\n\n# More\n\nSee `slfb law`.\n"),
            "<p><strong>We</strong> measure\nV<sub>2</sub> &lt; 1.</p>\n<h3>More</h3>\n<p>See <code>slfb "
            "law</code>.</p>\n");
  const std::string table = markdown_html("| key | meaning |\n|---|---|\n| `a` | first |\n");
  EXPECT_TRUE(table.find("<th>key</th>") != std::string::npos && table.find("<td>first</td>") != std::string::npos)
      << table;
}

TEST(Html, MarkupInTextStaysText) {
  EXPECT_EQ(escape_html("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
}

TEST(Html, SymbolsInProseGetSubscriptsAndNamesDoNot) {
  EXPECT_EQ(prose_html("V_2 at U_L = 0.1 m/s"), "V<sub>2</sub> at U<sub>L</sub> = 0.1 m/s");
  EXPECT_EQ(prose_html("mean |F_c|, α_L."), "mean |F<sub>c</sub>|, α<sub>L</sub>.");
  EXPECT_EQ(prose_html("fig05.u_mf_crossing, k_n.csv"), "fig05.u_mf_crossing, k_n.csv");
}

TEST(Html, NumbersReadAsOnPaper) {
  EXPECT_EQ(readable_number(0.0424), "0.0424");
  EXPECT_EQ(readable_number(-676.42), "−676.4");
  EXPECT_EQ(readable_number(51750.0), "51750");
  EXPECT_EQ(readable_number(1.5e-5), "1.5·10<sup>-5</sup>");
  EXPECT_EQ(readable_number(std::nan("")), "–");
}

}  // namespace
}  // namespace slfb
