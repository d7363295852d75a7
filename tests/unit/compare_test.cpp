// What a comparison says of laws: planted faults are found, and nothing else; claims side by side are judged by their
// intervals; errors come before any work.

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "correlations/classification/force_balance.hpp"
#include "correlations/drag/drag_laws.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/compare/candidates.hpp"
#include "experiments/compare/drag_study.hpp"
#include "experiments/peng_2014/comparison.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/support/files.hpp"
#include "tests/unit/synthetic_runs.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

const ComparisonBed& bed() {
  static const ComparisonBed the_bed = paper::comparison_bed();
  return the_bed;
}

constexpr LawInfo planted_info(double largest_reynolds) {
  LawInfo info = drag::WenYu1966::info;
  info.name = "planted";
  info.reynolds = {0.0, largest_reynolds};
  return info;
}

/// Wen and Yu's law in its smooth range times a factor of the voidage and the Reynolds number.
template <class Factor>
struct Planted {
  static constexpr LawInfo info = planted_info(900.0);
  double operator()(drag::SuspensionFlow flow) const { return Factor{}(flow)*drag::WenYu1966{}(flow); }
};

struct Nothing {
  double operator()(drag::SuspensionFlow) const { return 1.0; }
};
struct HalfOfStokes {
  double operator()(drag::SuspensionFlow) const { return 0.5; }
};
struct Jump {
  double operator()(drag::SuspensionFlow flow) const { return flow.voidage > 0.7123 ? 0.95 : 1.0; }
};
struct LooserIsMoreDrag {
  double operator()(drag::SuspensionFlow flow) const { return std::pow(flow.voidage, 7.0); }
};
struct FasterIsLessDrag {
  double operator()(drag::SuspensionFlow flow) const { return 1.0 / (1.0 + std::pow(flow.reynolds / 30.0, 2)); }
};
struct FasterThanSquare {
  double operator()(drag::SuspensionFlow flow) const { return 1.0 + std::pow(flow.reynolds / 100.0, 2); }
};

/// Which of the properties do not hold, by their place.
template <class Law>
std::vector<int> failing() {
  std::vector<int> places;
  const auto checks = check_properties(drag::kernels_of<Law>(), bed());
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (!checks[i].holds) places.push_back(static_cast<int>(i));
  return places;
}

enum Place { stokes, single_sphere, crowding, slip, square, derivative, jumps, expansion };

TEST(DragProperties, ASoundLawHasAll) { EXPECT_EQ(failing<Planted<Nothing>>(), (std::vector<int>{})); }

TEST(DragProperties, PlantedFaultsAreFound) {
  EXPECT_EQ(failing<Planted<HalfOfStokes>>(), (std::vector<int>{stokes, single_sphere}));
  EXPECT_EQ(failing<Planted<Jump>>(), (std::vector<int>{jumps}));
  EXPECT_EQ(failing<Planted<LooserIsMoreDrag>>(), (std::vector<int>{crowding, expansion}));
  const auto less = failing<Planted<FasterIsLessDrag>>();
  EXPECT_NE(std::ranges::find(less, slip), less.end());
  const auto more = failing<Planted<FasterThanSquare>>();
  EXPECT_NE(std::ranges::find(more, square), more.end());
}

TEST(DragProperties, AWrongDerivativeIsFound) {
  auto law = drag::kernels_of<Planted<Nothing>>();
  law.slip_derivative.function = [](const void*, const double* voidage, const double* reynolds, double* result,
                                    std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      result[i] = 1.01 * drag::slip_derivative(drag::WenYu1966{}, {voidage[i], reynolds[i]});
  };
  const auto checks = check_properties(law, bed());
  EXPECT_FALSE(checks[derivative].holds) << checks[derivative].found;
}

// Gidaspow's law changes its formula at a voidage of 0.8; his blend of the two was made to mend that.
TEST(DragProperties, GidaspowsJumpIsWhereHisFormulaChanges) {
  const auto jump = check_properties(find_drag_law("gidaspow-1994"), bed())[jumps];
  EXPECT_FALSE(jump.holds);
  EXPECT_NE(jump.found.find("e = 0.8,"), std::string::npos) << jump.found;
}

TEST(DragRatio, IsOneForTheLawItselfAndAFactorForAFactor) {
  const auto law = drag::kernels_of<Planted<Nothing>>(), half = drag::kernels_of<Planted<HalfOfStokes>>();
  EXPECT_DOUBLE_EQ(drag_ratio(law, law).largest, 1.0);
  EXPECT_DOUBLE_EQ(drag_ratio(half, law).smallest, 0.5);
  EXPECT_DOUBLE_EQ(drag_ratio(half, law).median, 0.5);
}

// With a constant F the balance is linear: slip = (ρ_2 − ρ_M) g d² / (18 μ ε F).
TEST(ForceBalance, HasAClosedFormForLinearDrag) {
  const auto law = [](drag::SuspensionFlow) { return 250.0; };
  const ForeignSphereInBed state{paper::glass(0.005), paper::steel(0.006), paper::water(), 0.6, 0.1};
  const double mixture = 0.6 * state.liquid.density + 0.4 * state.bed.density;
  const double slip = (state.foreign.density - mixture) * 9.81 * 36e-6 / (18.0 * state.liquid.viscosity * 0.6 * 250.0);
  EXPECT_NEAR(classification::force_balance_velocity(law, state), slip - 0.1 / 0.6, 1e-10);
}

TEST(HomogeneousBed, AnswersUnderTheKeysOfTheSimulations) {
  const Measurements found = measure_homogeneous_bed(find_drag_law("di-felice-1994"), bed());
  const double fluidisation = found.at({"minimum_fluidisation_velocity", "6in5W"}).value;
  EXPECT_NEAR(homogeneous_bed(find_drag_law("di-felice-1994"), bed(), 1.0001 * fluidisation).voidage,
              paper::packed_voidage(), 1e-4);
  EXPECT_GT(found.at(measure_key("classification_velocity", "6in5W", 0.10)).value,
            found.at(measure_key("classification_velocity", "6in5W", 0.06)).value);
}

// Another work's bed: other spheres, liquid and names, nothing of the first one left in the answers.
TEST(ComparisonBed, NamesAndNumbersAreThoseOfTheWork) {
  ComparisonBed other;
  other.system = "beads";
  other.bed = {{0.002, 2500.0}, "bead"};
  other.foreign = {{0.003, 4000.0}, "garnet"};
  other.liquid = {1260.0, 0.9};
  other.liquid_name = "glycerol";
  other.packed_voidage = 0.42;
  other.classification = {"measured", {{0.002, 0.01}}};
  const auto law = find_drag_law("wen-yu-1966");
  EXPECT_EQ(other.bed.words(), "2 mm bead");
  EXPECT_NE(check_properties(law, other)[expansion].property.find("2 mm bead in glycerol"), std::string::npos);
  const Measurements found = measure_homogeneous_bed(law, other);
  EXPECT_TRUE(found.contains({"minimum_fluidisation_velocity", "beads"}));
  // Viscous: the velocity that carries the packed bed follows Stokes, U = (ρ_s − ρ) g d² ε / (18 μ F), F = ε^−3.65.
  const double stokes = (2500.0 - 1260.0) * 9.81 * 4e-6 / (18.0 * 0.9);
  EXPECT_NEAR(bed_velocity(law, other, 0.42), stokes * std::pow(0.42, 4.65), 0.001 * stokes * std::pow(0.42, 4.65));
}

Evaluation answer(double ours, double half_width) {
  Evaluation evaluation;
  evaluation.claim.paper = 2.0;
  evaluation.ours = ours;
  if (std::isfinite(half_width)) evaluation.interval = {ours - half_width, ours + half_width};
  return evaluation;
}

TEST(Change, NeedsMoreThanBothIntervals) {
  EXPECT_EQ(change(answer(2.5, 0.1), answer(2.2, 0.1)), Change::better);
  EXPECT_EQ(change(answer(2.5, 0.1), answer(1.8, 0.1)), Change::better);  // nearer on the other side
  EXPECT_EQ(change(answer(2.2, 0.1), answer(1.5, 0.1)), Change::worse);
  EXPECT_EQ(change(answer(2.5, 0.3), answer(2.2, 0.3)), Change::same);
  EXPECT_EQ(change(answer(2.5, 0.1), answer(2.2, std::nan(""))), Change::undecided);
  EXPECT_EQ(change(answer(2.5, 0.1), Evaluation{}), Change::undecided);
}

TEST(Change, OfABoundCountsOnlyWhatLiesBeyondIt) {
  Evaluation first = answer(2.5, 0.1), other = answer(1.0, 0.1);
  first.claim.kind = other.claim.kind = StatementKind::at_most;
  EXPECT_EQ(change(first, other), Change::better);
  first.ours = 1.9;
  EXPECT_EQ(change(first, other), Change::same);
}

TEST(Change, OfATrendGoesByItsVerdict) {
  Evaluation first = answer(1.0, 0.1), other = answer(1.0, 0.1);
  first.claim.kind = other.claim.kind = StatementKind::increasing;
  first.verdict = Verdict::not_reproduced;
  other.verdict = Verdict::reproduced;
  EXPECT_EQ(change(first, other), Change::better);
  EXPECT_EQ(change(other, first), Change::worse);
}

// Of the claims that a candidate answers; one that it does not answer counts nowhere.
TEST(CountChanges, CountsWhatTheCandidateAnswers) {
  Candidate first, other;
  first.evaluations = {answer(2.5, 0.1),          answer(2.2, 0.1), answer(2.5, 0.3),
                       answer(2.5, std::nan("")), Evaluation{},     answer(2.5, 0.1)};
  other.evaluations = {answer(2.2, 0.1), answer(1.5, 0.1), answer(2.2, 0.3),
                       answer(2.2, 0.1), answer(2.2, 0.1), Evaluation{}};
  EXPECT_EQ(count_changes(first, other),
            (std::map<Change, std::size_t>{
                {Change::better, 1}, {Change::worse, 1}, {Change::same, 1}, {Change::undecided, 2}}));
}

TEST(RunsOf, AreThoseThatTheClaimsAskFor) {
  const auto claims = claims_of_runs(bed(), {"fig10"});
  EXPECT_TRUE(runs_of(bed(), Tier::correlation, claims, {}).empty());
  const auto slice = runs_of(bed(), Tier::one_dimensional, claims, {0.10});
  ASSERT_EQ(slice.size(), 1u);
  EXPECT_EQ(slice[0].superficial_velocity, 0.10);
  EXPECT_THROW(runs_of(bed(), Tier::one_dimensional, claims, {0.123}), std::invalid_argument);
  EXPECT_THROW(claims_of_runs(bed(), {"fig99"}), std::invalid_argument);
}

class CompareCommand : public testing::Test {
 protected:
  CompareCommand()
      : out_(fs::path(testing::TempDir()) /
             (std::string("slfb_compare_") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(out_);
  }
  ~CompareCommand() override { fs::remove_all(out_); }

  std::string run(std::vector<std::string> words) {
    CLI::App app{"slfb"};
    add_compare_command(app);
    words.insert(words.begin(), "compare");
    words.insert(words.end(), {"--out", out_.string()});
    testing::internal::CaptureStdout();
    try {
      app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the words last first
    } catch (...) {
      testing::internal::GetCapturedStdout();
      throw;
    }
    return testing::internal::GetCapturedStdout();
  }

  std::string error_of(const std::vector<std::string>& words) {
    try {
      run(words);
    } catch (const std::exception& error) {
      EXPECT_FALSE(fs::exists(out_)) << "something was done before the error";
      return error.what();
    }
    return "";
  }

  fs::path out_;
};

TEST_F(CompareCommand, ErrorsComeBeforeAnyWork) {
  EXPECT_NE(error_of({"--drag", "gidaspow-1994,wenyu"}).find("known: ergun-1952"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966,wen-yu-1966"}).find("compared twice"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966", "--experiments", "fig99"}).find("fig99"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966", "--velocities", "0.5"}).find("allowed are 0.06"), std::string::npos);
  EXPECT_NE(error_of({"--void-fraction", "centroid,exact"}).find("exact-overlap"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966", "--tier", "4d"}).find("4d"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966:n=3"}).find("exponent (0 to 10, 3.65 of the source)"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966:exponent=30"}).find("outside of its range"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "rong-2013:exponent=3"}).find("no parameters"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966:exponent=x"}).find("KEY=NUMBER"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "none.cpp"}).find("none.cpp"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "none.txt"}).find("or a file that ends with .cpp"), std::string::npos);
  EXPECT_NE(error_of({"--contact", "linear"}).find("nothing to compare"), std::string::npos);
  EXPECT_NE(error_of({"--contact", "linear,hertzian"}).find("known: linear, hertz"), std::string::npos);
  EXPECT_NE(error_of({"--contact", "none.cpp"}).find("none.cpp"), std::string::npos);
  EXPECT_NE(error_of({"--contact", "linear,hertz:stiffness"}).find("LAW:KEY=VALUE"), std::string::npos);
  EXPECT_NE(error_of({"--contact", "linear:stiffness=1e5 N/m"}).find("above the bound"), std::string::npos);
  EXPECT_NE(error_of({"--contact", "linear,linear:stifness=1e3"}).find("did you mean \"stiffness\""),
            std::string::npos);
  EXPECT_NE(error_of({"--void-fraction", "centroid,centroid"}).find("compared twice"), std::string::npos);
  EXPECT_NE(error_of({"--void-fraction", "centroid"}).find("two schemes"), std::string::npos);
  EXPECT_NE(error_of({"--void-fraction", "centroid,exact-overlap", "--tier", "correlation"}).find("1d and 3d"),
            std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966", "--contact", "hertz"}).find("excludes"), std::string::npos);
  EXPECT_NE(error_of({"--drag", "wen-yu-1966", "--work", "nobody_1900"}).find("nobody_1900"), std::string::npos);
  EXPECT_NE(error_of({}).find("--drag"), std::string::npos);
}

TEST_F(CompareCommand, ALawThatFailsInItsOwnRangeStopsTheComparison) {
  const fs::path file = fs::path(testing::TempDir()) / "slfb_negative.cpp";
  std::string text = run({"--template", "drag"});
  text.replace(text.find("return one_sphere"), 17, "return (0.5 - flow.voidage) * one_sphere");
  std::ofstream(file) << text;
  const std::string message = error_of({"--drag", file.string()});
  EXPECT_NE(message.find("needed is a number above zero"), std::string::npos) << message;
  EXPECT_NE(message.find("e = 0.5"), std::string::npos) << message;
}

TEST_F(CompareCommand, WritesTheReportOfTheCorrelations) {
  const std::string summary = run({"--drag", "gidaspow-1994,di-felice-1994", "--tier", "correlation"});
  EXPECT_NE(summary.find("di-felice-1994"), std::string::npos);
  const fs::path folder = out_ / "compare" / "drag" / "gidaspow-1994+di-felice-1994_correlation";
  for (const char* file : {"index.html", "claims.csv", "compare.json", "figures/drag_maps.png",
                           "figures/ratio_di-felice-1994.csv", "figures/bed_expansion.svg"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  EXPECT_FALSE(fs::exists(out_ / "runs"));
  const std::string page = read_file(folder / "index.html");
  EXPECT_LT(page.find(">U_mf [m/s]<"), page.find("<figure")) << "what the terminal shows is at its top";
  std::ifstream stream(folder / "compare.json");
  const auto answer = nlohmann::json::parse(stream);
  EXPECT_EQ(answer.at("candidates").size(), 2u);
  EXPECT_GT(answer.at("claims").size(), 10u);
  EXPECT_EQ(answer.at("laws").at(1).at("ratio_to").at("di-felice-1994").at("median"), 1.0);
}

// Ergun's viscous constant up by a fifth: a bed of small spheres is carried by less, and the sweep has a folder of its
// own.
TEST_F(CompareCommand, SweepsTheConstantsOfALaw) {
  run({"--drag", "ergun-1952", "ergun-1952:viscous=180,inertial=1.75", "ergun-1952:viscous=150", "--tier",
       "correlation"});
  const fs::path drag = out_ / "compare" / "drag";
  ASSERT_EQ(std::distance(fs::directory_iterator(drag), {}), 1);
  std::ifstream stream(fs::directory_iterator(drag)->path() / "compare.json");
  const auto answer = nlohmann::json::parse(stream);
  const auto umf = [&](std::size_t law) {
    return answer.at("laws").at(law).at("minimum_fluidisation_velocity").get<double>();
  };
  EXPECT_LT(umf(1), umf(0));
  EXPECT_EQ(umf(2), umf(0)) << "the value of the source";
}

// The steel sphere falls at Re of thousands: inside the range of Di Felice's law, outside that of Tenneti's.
TEST_F(CompareCommand, DrawsALawOutsideItsRangeApart) {
  run({"--drag", "di-felice-1994,tenneti-2011", "--tier", "correlation"});
  std::ifstream stream(out_ / "compare" / "drag" / "di-felice-1994+tenneti-2011_correlation" / "figures" /
                       "classification.csv");
  std::string line;
  std::getline(stream, line);
  ASSERT_TRUE(line.ends_with(
      "di-felice-1994 in its range V_2 [m/s],di-felice-1994 outside its range V_2 [m/s],tenneti-2011 in its "
      "range V_2 [m/s],tenneti-2011 outside its range V_2 [m/s]"))
      << line;
  for (std::string last; std::getline(stream, last);) line = last;
  EXPECT_EQ(line.substr(0, 6), "0.245,");  // [m/s]
  std::vector<double> values;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
  const std::size_t end = values.size();
  EXPECT_TRUE(std::isfinite(values[end - 4]) && std::isnan(values[end - 3])) << line;
  EXPECT_TRUE(std::isnan(values[end - 2]) && std::isfinite(values[end - 1])) << line;
}

TEST_F(CompareCommand, WritesTheReportOfTwoBodies) {
  const std::string summary = run({"--contact", "hertz", "--tier", "correlation"});
  EXPECT_NE(summary.find("restitution at 0.1 m/s"), std::string::npos) << summary;
  EXPECT_NE(summary.find("hertz: outside its range"), std::string::npos) << summary;
  const fs::path folder = out_ / "compare" / "contact" / "linear+hertz_correlation";
  for (const char* file : {"index.html", "compare.json", "figures/one_collision.png", "figures/impact_speed.csv",
                           "figures/oblique_impact.svg", "figures/wet_restitution.gp"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  EXPECT_FALSE(fs::exists(out_ / "runs"));
  std::ifstream stream(folder / "compare.json");
  const auto answer = nlohmann::json::parse(stream);
  EXPECT_NEAR(answer.at("laws").at(0).at("restitution").get<double>(), 0.9, 1e-3);
}

TEST_F(CompareCommand, AContactLawThatNeverLetsGoStopsTheComparison) {
  const fs::path file = fs::path(testing::TempDir()) / "slfb_sticky.cpp";
  std::string text = run({"--template", "contact"});
  text.replace(text.find(".force = force"), 14, ".force = approach > 0.0 ? force : 0.0");
  std::ofstream(file) << text;
  EXPECT_NE(error_of({"--contact", file.string(), "--tier", "correlation"}).find("do not part"), std::string::npos);
}

// With results that exist, made up, nothing is simulated: schemes side by side, their claims and pictures.
TEST_F(CompareCommand, ComparesVoidFractionSchemesByTheirRuns) {
  const std::vector<std::string> schemes{"exact-overlap", "particle-meshing", "centroid"};
  unsigned seed = 0;
  for (const std::string& scheme : schemes)
    for (RunSpec spec : runs_of(bed(), Tier::one_dimensional, claims_of_runs(bed(), {"table2"}), {0.10})) {
      spec.overrides.push_back("coupling.void_fraction=" + scheme);
      RunResult result = synthetic::run("6in5W", 0.10, "", ++seed).result;
      for (DropSeries& drop : result.drops) drop.species = "steel";
      result.name = scene_hash(load_run_scene(spec));
      const fs::path target = result_file(out_, result.name);
      fs::create_directories(target.parent_path());
      save_result(result, target);
    }
  const std::string summary = run({"--void-fraction", "exact-overlap,particle-meshing,centroid", "--experiments",
                                   "table2", "--velocities", "0.10"});
  EXPECT_NE(summary.find("claims better"), std::string::npos) << summary;
  const fs::path folder = out_ / "compare" / "void-fraction" / "exact-overlap+particle-meshing+centroid_1d_table2_0.1";
  for (const char* file : {"index.html", "claims.csv", "figures/simulated_classification.png",
                           "figures/collision_force.svg", "figures/collision_frequency_simulated_3.csv"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  std::ifstream stream(folder / "compare.json");
  const auto answer = nlohmann::json::parse(stream);
  for (const std::string& scheme : schemes)
    EXPECT_TRUE(answer.at("claims").at(0).at("answers").at(scheme).at("ours").is_number()) << scheme;
}

// Tenneti's law is meant for voidages from 0.5: the packed bed of 0.4 lies outside, and Re = 276 of its spheres inside.
TEST(UsesOutsideRange, MinimumFluidisationIsOne) {
  const auto law = find_drag_law("tenneti-2011");
  const auto sentences = uses_outside_range(law, bed(), {});
  ASSERT_FALSE(sentences.empty());
  EXPECT_EQ(sentences[0].find("Minimum fluidisation: voidage 0.3999 at 0.06 m/s"), 0u) << sentences[0];
  EXPECT_EQ(sentences[1].find("Homogeneous bed: "), 0u) << sentences[1];
  EXPECT_FALSE(homogeneous_bed(law, bed(), 0.06).bed_in_range);
  EXPECT_TRUE(homogeneous_bed(find_drag_law("di-felice-1994"), bed(), 0.06).in_range);
}

TEST(UsesOutsideRange, AreThoseOfTheMeasuredFlow) {
  const drag::DragLawKernels law = drag::kernels_of<Planted<Nothing>>();  // Re up to 900
  const auto none = uses_outside_range(law, bed(), {});
  const auto more = uses_outside_range(law, bed(),
                                       {{measure_key("terminal_reynolds", "6in5W", 0.06), {1234.0, 1.0, 3, "-", ""}},
                                        {measure_key("terminal_reynolds", "6in5W", 0.08), {800.0, 1.0, 3, "-", ""}}});
  ASSERT_EQ(more.size(), none.size() + 1);
  EXPECT_NE(more.back().find("1234 at 0.06 m/s"), std::string::npos) << more.back();
}

}  // namespace
}  // namespace slfb::compare
