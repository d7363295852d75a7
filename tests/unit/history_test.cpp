// What versions said to the claims: kept in a file, compared, drawn.
#include "experiments/claims/history.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/work/history_page.hpp"
#include "solver/support/files.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

PastClaim past(double value, double half_width, const std::string& verdict = "reproduced") {
  return {"m/s", value, std::pair{value - half_width, value + half_width}, Band{0.0, 20.0}, verdict, "none"};
}

HistoryEntry entry(const std::string& date, double value, double half_width,
                   const std::string& verdict = "reproduced") {
  return {"1.0", "abc", date, "a machine", {{"fig99.speed", past(value, half_width, verdict)}}, {}};
}

TEST(History, ADifferenceIsMeasuredByItsOwnInterval) {
  const auto change = change_since(past(10.0, 3.0), past(11.0, 4.0));
  ASSERT_TRUE(change);
  EXPECT_DOUBLE_EQ(change->difference, 1.0);
  EXPECT_DOUBLE_EQ(*change->relative, 0.1);
  EXPECT_DOUBLE_EQ(*change->significance, 0.2) << "1 over the root of 3² + 4²";
  EXPECT_EQ(*change_since(past(10.0, 0.0), past(10.0, 0.0))->significance, 0.0);
  EXPECT_TRUE(std::isinf(*change_since(past(10.0, 0.0), past(10.1, 0.0))->significance)) << "exact numbers differ";
  PastClaim single = past(11.0, 0.0);
  single.interval.reset();
  EXPECT_FALSE(change_since(past(10.0, 1.0), single)->significance);
  PastClaim none = single;
  none.value.reset();
  EXPECT_FALSE(change_since(past(10.0, 1.0), none));
}

// Of the ends that face each other: an interval that is wide on the other side says nothing of this change.
TEST(History, AnIntervalMayBeOneSided) {
  PastClaim before = past(10.0, 0.0), now = past(11.0, 0.0);
  before.interval = {0.0, 10.3};
  now.interval = {10.6, 100.0};
  EXPECT_NEAR(*change_since(before, now)->significance, 1.0 / 0.5, 1e-9);
}

/// Two-sided normal quantiles: 1.9600 at 5 %, 3.4808 at 0.05 %.
TEST(History, ManyClaimsNeedALargerDifference) {
  EXPECT_NEAR(significance_of_all(1), 1.0, 1e-12);
  EXPECT_NEAR(significance_of_all(100), 3.4808 / 1.9600, 1e-4);
}

// Each step is well within its interval, but all together are not.
TEST(History, ADriftIsSeenBeforeAnyStepIs) {
  std::vector<HistoryEntry> entries;
  for (int k = 0; k < 12; ++k) entries.push_back(entry(fmt::format("2026-01-{:02}", k + 1), 10.0 + 0.03 * k, 0.1));
  const HistoryRow row = history_rows(entries).front();
  EXPECT_LT(*row.since_before->significance, 0.3);
  EXPECT_GT(*row.since_first->significance, 2.0);
  EXPECT_TRUE(row.significant);
  EXPECT_NE(history_text(entries).find("SIGNIFICANT"), std::string::npos);
}

TEST(History, SaysWhichVerdictsChanged) {
  const std::vector<HistoryEntry> entries{entry("2026-01-01", 10.0, 1.0),
                                          entry("2026-01-02", 10.1, 1.0, "not decidable")};
  EXPECT_NE(history_text(entries).find("reproduced → not decidable"), std::string::npos) << history_text(entries);
  const std::string page = history_html(entries);
  EXPECT_NE(page.find("reproduced → not decidable"), std::string::npos);
  EXPECT_NE(page.find("<svg role=\"img\""), std::string::npos);
}

TEST(History, WithoutAChangeThereIsNoRow) {
  const std::vector<HistoryEntry> entries{entry("2026-01-01", 10.0, 1.0), entry("2026-01-02", 10.0, 1.0)};
  EXPECT_NE(history_text(entries).find("0 of 1 claims changed"), std::string::npos) << history_text(entries);
}

TEST(History, KnowsHowMuchOfABandIsUsed) {
  EXPECT_DOUBLE_EQ(*place_in_band(past(10.0, 1.0)), 0.0);
  EXPECT_DOUBLE_EQ(*place_in_band(past(15.0, 1.0)), 0.5);
  PastClaim open = past(10.0, 1.0);
  open.band = Band{0.0, std::numeric_limits<double>::infinity()};
  EXPECT_FALSE(place_in_band(open));
}

TEST(History, KeepsWhatWasWritten) {
  const Folder folder;
  const auto file = folder.path() / "history.jsonl";
  HistoryEntry later = entry("2026-02-01", 10.5, 0.5), earlier = entry("2026-01-01", 10.0, 1.0);
  later.claims["fig99.speed"].band = Band{-std::numeric_limits<double>::infinity(), 9.0};
  later.bench["particles [ns]"] = 12.5;
  append_to_history(file, later);
  append_to_history(file, earlier);
  const auto entries = load_history(file);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].date, "2026-01-01") << "by date";
  const PastClaim& claim = entries[1].claims.at("fig99.speed");
  EXPECT_EQ(claim.value, 10.5);
  EXPECT_EQ(claim.interval, (std::pair{10.0, 11.0}));
  EXPECT_TRUE(std::isinf(claim.band->lower));
  EXPECT_EQ(claim.band->upper, 9.0);
  EXPECT_EQ(entries[1].bench.at("particles [ns]"), 12.5);
}

class HistoryCommand : public testing::Test {
 protected:
  std::string run(std::vector<std::string> words) {
    words.insert(words.begin(),
                 {"history", (folder_.path() / "history.jsonl").string(), "--out", folder_.path().string()});
    CLI::App app;
    add_history_command(app);
    testing::internal::CaptureStdout();
    std::string said;
    try {
      app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const std::exception& error) {
      said = error.what();
    }
    return testing::internal::GetCapturedStdout() + said;
  }
  std::string file(const std::string& name, const std::string& text) {
    write_file(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }
  /// As `slfb check --json` writes it.
  std::string checked(const std::string& version) {
    return file("claims.json",
                fmt::format(R"({{"made_by": {{"version": "{}", "commit": "", "date": "2026-01-01", "machine": "m"}},
  "claims": [{{"id": "a.b", "unit": "-", "ours": 1.5, "interval": [1, 2], "paper_band": null,
               "verdict": "reproduced", "gate": "holds"}}]}})",
                            version));
  }
  Folder folder_;
};

TEST_F(HistoryCommand, AddsAndDraws) {
  const std::string bench =
      file("dem.json", R"({"results": [{"scene": "A", "threads": 1, "particle_steps_per_second": 2e6}]})");
  const std::string said = run({"--add", checked("1.2"), "--bench", bench});
  EXPECT_NE(said.find("1 reproduced, 0 not, 0 not decidable, 0 gates broken"), std::string::npos) << said;
  const auto entries = load_history(folder_.path() / "history.jsonl");
  EXPECT_EQ(entries.front().version, "1.2");
  EXPECT_DOUBLE_EQ(entries.front().bench.begin()->second, 500.0) << "ns a particle-step";
  EXPECT_NE(read_file(folder_.path() / "history" / "index.html").find("Computing time"), std::string::npos);
}

TEST_F(HistoryCommand, ComplainsBeforeItWrites) {
  EXPECT_NE(run({"--add", checked("")}).find("--label"), std::string::npos) << "results of another code";
  EXPECT_NE(run({"--add", file("other.json", "{}")}).find("other.json"), std::string::npos);
  EXPECT_NE(run({}).find("history.jsonl"), std::string::npos) << "there is none yet";
  file("history.jsonl", "{}\n");
  EXPECT_NE(run({"--add", checked("1.2")}).find("history.jsonl:1"), std::string::npos);
  EXPECT_EQ(read_file(folder_.path() / "history.jsonl"), "{}\n");
}

}  // namespace
}  // namespace slfb
