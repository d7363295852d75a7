// A second work moves in: a folder with its profiles, scenes and figures, a folder with its numbers and claims, its
// committed results, and one value. Every number of it is made up. Nothing outside its folders knows of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr const char* profiles = R"(
[systems.sand]
scene = "bed.toml"

[common]
differences = ["The sand is made of spheres."]

[profiles.quick]
differences = ["Half a second, not an hour."]
overrides = ["stage[1].duration=0.5 s"]

[[profiles.quick.runs]]
system = "sand"
superficial_velocities = [0.07, 0.08]
)";

constexpr const char* numbers = R"(
[[value]]
id = "pressure"
quantity = "pressure drop of the sand"
value = 500.0
unit = "Pa"
uncertainty = 5.0
source = "p. 1"

[[value]]
id = "grains"
quantity = "grains in a spoon"
value = 42.0
unit = "-"
uncertainty = 0.5
source = "p. 2"

[[value]]
id = "hurried"
quantity = "share of hurried drops"
value = 1.0
unit = "-"
uncertainty = 0.1
source = "p. 3"
)";

/// Ids of the first work, which are ids of this one too.
constexpr const char* claims = R"(
[[claim]]
id = "fig05.pressure"
figure = "fig05"
quantity = "pressure drop at 0.07 m/s"
equals = "pressure"
paper_band = { relative = 0.1, why = "made up" }
measure = "pressure_drop/sand/0.07"

[[claim]]
id = "fig05.settling"
figure = "fig05"
quantity = "settling against the velocity"
trend = "increasing"
measure = ["classification_velocity/sand/0.07", "classification_velocity/sand/0.08"]
unit = "m/s"
source = "p. 1"

[[claim]]
id = "fig06.grains"
figure = "fig06"
quantity = "grains in a spoon by the law of spoons"
equals = "grains"
paper_band = { absolute = 1, why = "made up" }
measure = "spoonful/law-of-spoons"
regression = { value = 42.0, relative = 1e-6, why = "arithmetic" }

[[claim]]
id = "fig07.hurried"
figure = "fig07"
quantity = "share of drops that fall faster than 0.15 m/s"
at_most = "hurried"
paper_band = { absolute = 0.0, why = "made up" }
measure = "hurried_drops/sand/0.08"

[[claim]]
id = "fig07.missing"
figure = "fig07"
quantity = "share of drops that fall faster than 0.15 m/s in a run that nobody made"
at_most = "hurried"
paper_band = { absolute = 0.0, why = "made up" }
measure = "hurried_drops/sand/0.09"
)";

constexpr const char* readme =
    "# Figure of sand\n\n## Caption\n\nSand at rest and in motion.\n\n## Definitions\n\nNone.\n";
constexpr const char* plot = "set xlabel 'superficial velocity [m/s]'\nplot 'ID.csv' skip 1 using 1:2 with points\n";

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec&) { return true; });
}

/// A figure of one quantity in a folder that lies where the work lies.
Figure figure(const fs::path& experiments, const std::string& id, const std::string& quantity) {
  const FigureFolder folder{experiments / id};
  return {id, folder.title(), needs,
          [=](const FigureContext& context) {
            FigureOutput output{id, {}, folder.caption(), run_notes(context, needs(context.profile))};
            DataTable table{id, {"superficial velocity [m/s]", quantity + " [SI]"}, {}};
            for (const MeasuredPoint& point : measured_points(context.measurements, quantity, "sand"))
              table.rows.push_back({point.superficial_velocity, point.value});
            output.data.push_back(write_csv(table, context.out));
            draw_plot_of_runs(id, folder.plot(), {}, {400, 300}, context, needs(context.profile));
            return output;
          },
          folder.path().string()};
}

class SecondWork : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path experiments = folder_.path() / "experiments", data = folder_.path() / "data";
    fs::create_directories(experiments / "scenes");
    fs::create_directories(data);
    fs::create_directories(out());
    write_file(experiments / "profiles.toml", profiles);
    fs::copy_file(source_folder() / "experiments/scenes/fluidised_box.toml", experiments / "scenes/bed.toml");
    write_file(data / "numbers.toml", numbers);
    write_file(data / "claims.toml", claims);
    for (const char* id : {"fig05", "fig06", "fig07"}) {
      fs::create_directories(experiments / id);
      write_file(experiments / id / "README.md", readme);
      std::string commands = plot;
      write_file(experiments / id / "figure.gp", commands.replace(commands.find("ID"), 2, id));
    }
    printed_.read_values(data / "numbers.toml");

    work_.id = "sand_2099";
    work_.citation = "A. Nobody, Sand, made up";
    work_.folders = {experiments, data, folder_.path() / "published"};
    work_.systems = {{"sand", "sand in water"}};
    work_.measuring.quantities.push_back({"hurried_drops", "-", "share of hurried drops",
                                          "1 for a drop with V_2 above 0.15 m/s, else 0.",
                                          OfDrop([](const DropView& drop) -> std::optional<double> {
                                            if (!drop.statistics.classification) return std::nullopt;
                                            return drop.statistics.classification->velocity > 0.15 ? 1.0 : 0.0;
                                          })});
    work_.measuring.quantities.push_back({"spoonful", "-", "grains in a spoon", "By the law of spoons.", OfNoRun{}});
    work_.reference = &printed_;
    work_.without_runs = [] { return Measurements{{{"spoonful", "law-of-spoons"}, {42.0, 0.0, 1, "-", "law"}}}; };
    work_.figures = {figure(experiments, "fig05", "pressure_drop"),
                     figure(experiments, "fig06", "classification_velocity"),
                     figure(experiments, "fig07", "hurried_drops")};
    for (const RunSpec& run : load_profile(work_, "quick").runs) publish(run);
  }

  [[nodiscard]] fs::path out() const { return folder_.path() / "out"; }

  /// A committed result with three drops of made-up velocities.
  static void publish(const RunSpec& spec) {
    const Scene scene = load_run_scene(spec);
    RunResult result;
    result.name = scene_hash(scene);
    result.scene_text = canonical_toml(scene);
    result.numerics = numerics_version;
    RunSummary summary;
    summary.run = {{"wall_seconds", 1.0}, {"simulated_seconds", 1.0}, {"particles_removed", 0.0}};
    summary.bed["pressure_drop"] = {505.0, 2.0, 1.0, 40.0, 0};
    for (const double spread : {-0.001, 0.0, 0.001})
      summary.drops.push_back({{"classification_velocity", 2.0 * spec.superficial_velocity + spread},
                               {"hurried_drops", spec.superficial_velocity > 0.075 ? 1.0 : 0.0}});
    fs::create_directories(published_file(spec).parent_path());
    save_result(result, published_file(spec));
    save_summary(summary, published_summary(spec));
  }

  /// What `slfb ARGUMENTS --work sand_2099` prints.
  std::string slfb(std::vector<std::string> arguments) {
    const Works list{&peng_2014_work(), &work_};
    arguments.insert(arguments.end(), {"--work", "sand_2099"});
    std::ranges::reverse(arguments);  // as CLI11 takes a vector
    CLI::App app;
    add_figures_command(app, list);
    add_check_command(app, list);
    add_list_command(app, list);
    testing::internal::CaptureStdout();
    try {
      app.parse(arguments);
    } catch (const CLI::RuntimeError& status) {
      ADD_FAILURE() << "exit status " << status.get_exit_code();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    std::string text = testing::internal::GetCapturedStdout();
    EXPECT_EQ(text.find("left out a published result"), std::string::npos) << text;
    return text;
  }

  Folder folder_;
  ReferenceNumbers printed_{"sand_2099"};
  Work work_;
};

TEST_F(SecondWork, ItsClaimsAreChecked) {
  const auto answer = nlohmann::json::parse(slfb({"check", "--out", out().string(), "--json", "-"}));
  ASSERT_EQ(answer.at("claims").size(), 5U);
  const auto claim = [&](const std::string& id) {
    for (const auto& one : answer.at("claims"))
      if (one.at("id") == id) return one;
    throw std::out_of_range(id);
  };
  EXPECT_EQ(claim("fig05.pressure").at("ours"), 505.0);
  EXPECT_EQ(claim("fig05.pressure").at("verdict"), "reproduced");
  EXPECT_EQ(claim("fig05.settling").at("verdict"), "reproduced");
  EXPECT_EQ(claim("fig06.grains").at("gate"), "holds");
  EXPECT_EQ(claim("fig07.hurried").at("ours"), 1.0);
  EXPECT_EQ(claim("fig07.missing").at("reason"), "not yet simulated: hurried_drops/sand/0.09");
}

TEST_F(SecondWork, ItsFiguresAreDrawnAndReported) {
  slfb({"figures", "--no-run", "--out", out().string()});
  for (const char* id : {"fig05", "fig06", "fig07"}) {
    EXPECT_TRUE(fs::exists(out() / "figures" / (std::string(id) + ".svg"))) << id;
    EXPECT_TRUE(fs::exists(out() / "report" / "figures" / (std::string(id) + ".html"))) << id;
  }
  EXPECT_FALSE(fs::exists(out() / "figures" / "fig10.svg")) << "a figure of another work";
  const std::string table = read_file(out() / "figures" / "fig06.csv");
  EXPECT_NE(table.find("0.07,0.14"), std::string::npos) << table;
  EXPECT_NE(read_file(out() / "report" / "claims.html").find("fig07.missing"), std::string::npos);
}

TEST_F(SecondWork, ANamedFigureIsDrawnAlone) {
  const std::string said = slfb({"figures", "fig06", "--no-run", "--out", out().string()});
  EXPECT_NE(said.find("fig06.svg"), std::string::npos) << said;
  EXPECT_TRUE(fs::exists(out() / "figures" / "fig06.svg"));
  EXPECT_FALSE(fs::exists(out() / "figures" / "fig05.svg"));
  EXPECT_FALSE(fs::exists(out() / "report"));
}

TEST_F(SecondWork, IsListed) {
  const std::string list = slfb({"list"});
  EXPECT_NE(list.find("fig05      2 claims  Figure of sand"), std::string::npos) << list;
  EXPECT_NE(list.find("sand at 0.07 0.08 m/s"), std::string::npos) << list;
  EXPECT_EQ(list.find("fig10"), std::string::npos) << "a figure of another work";
  const std::string quantities = slfb({"list", "quantities"});
  EXPECT_NE(quantities.find("hurried_drops [-]: share of hurried drops"), std::string::npos) << quantities;
  EXPECT_NE(quantities.find("classification_velocity [m/s]"), std::string::npos) << quantities;
}

TEST_F(SecondWork, UnknownWorksAreNamedWithTheKnownOnes) {
  try {
    find_work({&peng_2014_work(), &work_}, "sand_2100");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "there is no work \"sand_2100\"; known: peng_2014, sand_2099");
  }
}

}  // namespace
}  // namespace slfb
