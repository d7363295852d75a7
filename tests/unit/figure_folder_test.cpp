#include "experiments/figures/figure_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>

#include "experiments/figures/figure.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/run_files.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/run_program.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// What is thrown says where the mistake is and what it is about.
template <class Call>
void expect_error(Call call, const fs::path& file, const std::string& about) {
  try {
    call();
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    EXPECT_NE(message.find(about), std::string::npos) << message;
  }
}

TEST(FigureFolder, ReadsTitleAndCaptionOfTheReadme) {
  const Folder folder;
  write(folder.path() / "README.md",
        "# A title\n\n## Caption\n\nThe weight is\n{weight} Pa, twice {weight} Pa.\n\n## Definitions\n\nHow.\n");
  const FigureFolder figure(folder.path());
  EXPECT_EQ(figure.title(), "A title");
  EXPECT_EQ(figure.caption({{"weight", "676"}}), "The weight is 676 Pa, twice 676 Pa.");
}

TEST(FigureFolder, ACaptionMayBeTheLastPart) {
  const Folder folder;
  write(folder.path() / "README.md", "# A title\n\n## Caption\n\nAll of it.\n");
  EXPECT_EQ(FigureFolder(folder.path()).caption(), "All of it.");
}

TEST(FigureFolder, SaysWhatIsMissingInTheReadme) {
  const Folder folder;
  const fs::path readme = folder.path() / "README.md";
  const FigureFolder figure(folder.path());
  expect_error([&] { (void)figure.title(); }, readme, "README.md");
  write(readme, "No heading.\n");
  expect_error([&] { (void)figure.title(); }, readme, "title");
  expect_error([&] { (void)figure.caption(); }, readme, "## Caption");
}

TEST(FigureFolder, WordsOfCaptionAndFigureMustAgree) {
  const Folder folder;
  const fs::path readme = folder.path() / "README.md";
  write(readme, "# A title\n\n## Caption\n\nThe weight is {weight} Pa.\n\n## Definitions\n\nHow {it} is.\n");
  const FigureFolder figure(folder.path());
  expect_error([&] { (void)figure.caption(); }, readme, "{weight}");
  expect_error([&] { (void)figure.caption({{"weight", "676"}, {"height", "1"}}); }, readme, "{height}");
  EXPECT_EQ(figure.caption({{"weight", "676"}}), "The weight is 676 Pa.");
}

TEST(FigureFolder, DefinitionsAreWhatStandsUnderTheirHeading) {
  EXPECT_EQ(figure_definitions("# A title\n\n## Caption\n\nAll.\n\n## Definitions\n\nHow.\n\n## More\n\nWhy.\n"),
            "\nHow.\n\n## More\n\nWhy.\n");
  EXPECT_EQ(figure_definitions("# A title\n\nFor those who work on it.\n"), "");
}

TEST(AddSeries, ListsTheSeriesThatHaveRows) {
  const Folder folder;
  const Profile profile;
  const FigureContext context{profile, {}, {}, folder.path(), folder.path()};
  FigureOutput output;
  PlotValues values;
  add_series("mean", {{{"first", {"a [-]"}, {{1.0}}}, "the first", 2}, {{"empty", {"a [-]"}, {}}, "without rows", 3}},
             values, context, output);
  ASSERT_EQ(output.data.size(), 1u);
  EXPECT_EQ(read_file(output.data.front()), "a [-]\n1\n");
  EXPECT_FALSE(fs::exists(folder.path() / "empty.csv"));
  EXPECT_EQ(values.commands(),
            "mean_count = 1\narray mean[1] = ['first.csv']\nmean_title_count = 1\narray mean_title[1] = ['the first']\n"
            "mean_style_count = 1\narray mean_style[1] = [2]\n");
}

// gnuplot reads the first item of a list even where it has nothing to loop over.
TEST(AddSeries, AnEmptyListDrawsWithoutAnErrorOrAWarning) {
  const Folder folder;
  const Profile profile;
  const FigureContext context{profile, {}, {}, folder.path(), folder.path()};
  FigureOutput output;
  PlotValues values;
  add_series("mean", {{{"empty", {"a [-]", "b [-]"}, {}}, "", 3}}, values, context, output);
  values.numbers("shift", {});
  write(folder.path() / "figure.gp",
        "plot sin(x), for [i=1:mean_count] mean[i] skip 1 using ($1+shift[i]):2:(half_width(3)):(half_width(4)) "
        "with xyerrorbars linestyle mean_style[i] @bars, "
        "for [i=1:mean_count] mean[i] skip 1 using 1:2 linestyle mean_style[i] title mean_title[i]\n");
  draw_plot("drawn", folder.path() / "figure.gp", values, {}, folder.path(), {}, {"svg"});
  EXPECT_EQ(run_program({"gnuplot", "drawn.gp"}, folder.path(), "").output, "");
}

TEST(DrawPlot, WhatAPlotLoadsStandsInItsScript) {
  const Folder sources, out;
  fs::create_directories(sources.path() / "figure");
  write(sources.path() / "shared.gp", "shared = height\n");
  write(sources.path() / "figure" / "figure.gp", "load '../shared.gp'\nplot shared + offset\n");
  PlotValues values;
  values.number("offset", 2.0);
  draw_plot("drawn", sources.path() / "figure" / "figure.gp", values, {300, 200}, out.path(), {}, {"svg"});
  fs::remove_all(sources.path() / "figure");
  const std::string script = read_file(out.path() / "drawn.gp");
  EXPECT_NE(script.find("height = 200.0\n"), std::string::npos) << script;
  EXPECT_NE(script.find("offset = 2\n\nshared = height\nplot shared + offset\n"), std::string::npos) << script;
}

/// gnuplot commands inside a C++ text: they belong into figure.gp.
bool holds_gnuplot_commands(const std::string& code) {
  static const std::regex command(R"((^|"|\\n|\n)(set|unset|plot|splot) )");
  return std::regex_search(code, command);
}

// The numerics draw many charts from one folder; every other figure has a folder of its own.
TEST(EveryFigureFolder, HasCodePlotTitleAndCaption) {
  EXPECT_TRUE(holds_gnuplot_commands("f(\"set key\\n\")"));
  EXPECT_TRUE(holds_gnuplot_commands("f(\"unset key\\nplot x\")"));
  EXPECT_FALSE(holds_gnuplot_commands("  /// The set of plots\n  const auto set = plot (x);"));
  for (const Figure& figure : figures()) {
    const fs::path folder = source_folder() / "experiments" / figure.folder;
    if (figure.folder.starts_with("numerics/") && !fs::exists(folder / "figure.cpp")) continue;
    EXPECT_EQ(FigureFolder(figure.folder).title(), figure.title) << figure.id;
    EXPECT_NE(read_file(folder / "README.md").find("\n## Caption\n"), std::string::npos) << folder;
    EXPECT_TRUE(fs::exists(folder / "figure.gp")) << folder;
    ASSERT_TRUE(fs::exists(folder / "figure.cpp")) << folder;
    EXPECT_FALSE(holds_gnuplot_commands(read_file(folder / "figure.cpp"))) << folder / "figure.cpp";
  }
}

}  // namespace
}  // namespace slfb
