// The pages of the report are made of plain values: those of a work that does not exist show what they are given.

#include "experiments/work/report_pages.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <pugixml.hpp>
#include <string>

#include "reports/claim_table.hpp"
#include "reports/figure_pages.hpp"
#include "reports/html.hpp"
#include "solver/support/files.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::reports {
namespace {

namespace fs = std::filesystem;

ClaimRow rise_of_a_lever() {
  ClaimRow claim;
  claim.id = "lever.rise";
  claim.place = "fig07";
  claim.quantity = "rise of the lever";
  claim.source = "page 3";
  claim.unit = "m";
  claim.paper = "at most 0.5";
  claim.band = {-std::numeric_limits<double>::infinity(), 0.5};
  claim.ours = 0.625;
  claim.interval = {0.6, 0.65};
  claim.deviation = 0.25;
  claim.verdict = Verdict::not_reproduced;
  claim.gate = Gate::broken;
  claim.reason = "0.6 < rise & rise > 0.5";
  return claim;
}

TEST(ClaimTable, ShowsStatementNumberIntervalAndVerdict) {
  const ClaimRow claim = rise_of_a_lever();
  const std::string table = claim_table({&claim});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(table.c_str())) << table;
  const auto row = document.select_node("//tr[@id='lever.rise']").node();
  EXPECT_STREQ(row.attribute("data-verdict").value(), "not-reproduced");
  EXPECT_STREQ(row.attribute("data-figure").value(), "fig07");
  for (const char* text : {"at most 0.5 m", "≤ 0.5", "0.625 m", "0.6 … 0.65", "+25.0 %", "gate broken",
                           "✗ not reproduced", "0.6 &lt; rise &amp; rise"})
    EXPECT_NE(table.find(text), std::string::npos) << text;
}

// A statement in words has no unit, and a number that does not exist leaves its cells empty.
TEST(ClaimTable, LeavesOutWhatDoesNotExist) {
  ClaimRow claim = rise_of_a_lever();
  claim.paper = "increasing";
  claim.paper_in_words = true;
  claim.ours.reset();
  claim.interval.reset();
  claim.deviation.reset();
  const std::string table = claim_table({&claim});
  EXPECT_EQ(table.find("increasing m"), std::string::npos);
  EXPECT_NE(table.find("<td data-label=\"Ours\"></td><td data-label=\"Deviation\"></td>"), std::string::npos) << table;
}

TEST(ClaimTable, LeadsToThePageOfAllClaims) {
  const ClaimRow claim = rise_of_a_lever();
  EXPECT_NE(claim_table({&claim}, "../claims.html").find("<a href=\"../claims.html#lever.rise\">lever.rise</a>"),
            std::string::npos);
}

TEST(ClaimsByPlace, AreSortedByPlaceAndKeepTheirOrder) {
  std::vector<ClaimRow> claims(3, rise_of_a_lever());
  claims[0].place = "text";
  claims[2].id = "second";
  const ClaimGroups groups = claims_by_place(claims);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(place_name(groups[0].first), "Figure 7");
  EXPECT_EQ(place_name(groups[1].first), "Text");
  EXPECT_EQ(groups[0].second[1]->id, "second");
}

TEST(FigurePages, ShowClaimsRunsAndDoubtsOfTheirFigureAlone) {
  const Folder folder;
  fs::create_directories(folder.path() / "figures");
  fs::create_directories(folder.path() / "runs");
  write_file(folder.path() / "figures" / "fig07.svg", "<svg viewBox=\"0 0 300 200\"></svg>");
  write_file(folder.path() / "runs" / "quick_lever.h5", "");
  ReportContents contents;
  FigurePage figure;
  figure.id = "fig07";
  figure.title = "The lever";
  figure.caption = "How the lever rises.";
  figure.readme = "# Lever\n\n**We measure** its rise.";
  figure.notes = {"Lever of 2 m, not 3 m.", "Not yet simulated: lever/0.20."};
  figure.laws = {"wen-yu-1966"};
  figure.data_files = {"fig07_rise.csv"};
  figure.run_keys = {"lever/0.10", "lever/0.20"};
  figure.options = "--profile quick";
  figure.findings = "It rises by **half**.";
  contents.figures = {figure};
  ClaimRow elsewhere = rise_of_a_lever();
  elsewhere.id = "other";
  elsewhere.place = "fig08";
  contents.claims = {rise_of_a_lever(), elsewhere};
  RunRow run;
  run.key = "lever/0.10";
  run.profile = "quick";
  run.name = "0123456789abcdef";
  run.download = "quick_lever.h5";
  contents.runs = {run};
  contents.inconsistencies = {{"length", "length of the lever", "Fig. 7, page 3", 1.0, 1.1, "m", "It is longer."},
                              {"mass", "mass of the lever", "Fig. 70", 1.0, 1.1, "kg", "It is heavier."}};
  write_figure_pages(contents, folder.path() / "figures");

  const std::string text = read_file(folder.path() / "figures" / "fig07.html");
  pugi::xml_document page;
  ASSERT_TRUE(page.load_string(text.c_str(), pugi::parse_default)) << text;
  EXPECT_EQ(page.select_nodes("//tr[@data-verdict]").size(), 1u);
  for (const char* part :
       {"<strong>We measure</strong>", "by <strong>half</strong>", "1 of 2 simulations",
        "href=\"../runs/quick_lever.h5\"", "It is longer.",
        "<td class=\"lead\" data-label=\"Here\">Lever of 2 m</td><td data-label=\"Paper\">3 m</td>",
        "<li>Not yet simulated: lever/0.20.</li>", "href=\"../laws/wen-yu-1966.html\"", "alt=\"How the lever rises.\"",
        "href=\"../claims.html#lever.rise\"", "build/slfb figures fig07 --profile quick", "width=\"300\""})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(text.find("It is heavier."), std::string::npos);
}

TEST(FigurePages, ATableIsTextAndNoPicture) {
  const Folder folder;
  fs::create_directories(folder.path() / "figures");
  write_file(folder.path() / "figures" / "table1.svg", "<svg viewBox=\"0 0 300 200\"></svg>");
  ReportContents contents;
  FigurePage figure;
  figure.id = "table1";
  figure.title = "Levers";
  figure.caption = "All levers.";
  figure.table = {{"lever", "U_L [m/s]"}, {{"first", "0.1 < 0.2"}}};
  contents.figures = {figure};
  write_figure_pages(contents, folder.path() / "figures");
  const std::string text = read_file(folder.path() / "figures" / "table1.html");
  EXPECT_EQ(text.find("<img"), std::string::npos);
  EXPECT_NE(text.find("<th>U<sub>L</sub> [m/s]</th>"), std::string::npos) << text;
  EXPECT_NE(text.find("0.1 &lt; 0.2"), std::string::npos);
}

TEST(Findings, SayWhenAClaimHasAnotherVerdict) {
  FindingRow finding{"It rises.", "fig07", {{"lever.rise", Verdict::reproduced, Verdict::reproduced}}};
  EXPECT_TRUE(finding.holds());
  finding.claims.push_back({"lever.fall", Verdict::not_reproduced, Verdict::not_decidable});
  EXPECT_FALSE(finding.holds());
}

TEST(ReadableRange, SaysOpenEnds) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(readable_range(0.0, infinity), "any");
  EXPECT_EQ(readable_range(2.0, infinity), "≥ 2");
  EXPECT_EQ(readable_range(0.1, 300.0), "0.1 … 300");
}

// What an evaluation says reaches the page without a change.
TEST(ClaimRow, IsTheEvaluation) {
  Evaluation evaluation;
  evaluation.claim.id = "fig07.rise";
  evaluation.claim.figure = "fig07";
  evaluation.claim.kind = StatementKind::at_most;
  evaluation.claim.paper = 0.5;
  evaluation.claim.paper_band = Band{0.0, 0.5};
  evaluation.ours = 0.4;
  evaluation.verdict = slfb::Verdict::reproduced;
  evaluation.gate = slfb::Gate::holds;
  const ClaimRow row = claim_row(evaluation);
  EXPECT_EQ(row.place, "fig07");
  EXPECT_EQ(row.paper, "at most 0.5");
  EXPECT_FALSE(row.paper_in_words);
  EXPECT_EQ(row.band, (std::pair{0.0, 0.5}));
  EXPECT_EQ(row.verdict, Verdict::reproduced);
  EXPECT_EQ(row.gate, Gate::holds);
  evaluation.claim.kind = StatementKind::increasing;
  EXPECT_TRUE(claim_row(evaluation).paper_in_words);
}

}  // namespace
}  // namespace slfb::reports
