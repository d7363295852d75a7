#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/convergence/sequences.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "reports/gnuplot.hpp"

namespace slfb::grid_convergence {
namespace {

using convergence::GridConvergence, convergence::Level, convergence::Refined, convergence::Sequence;

const FigureFolder folder{"peng_2014/grid_convergence"};

/// A panel: its quantity by the names of the runs and of the studies.
struct Shown {
  const char *of_runs, *of_studies, *title;
};
constexpr std::array shown{Shown{velocity, "classification_velocity", "V_2"}, Shown{voidage, "voidage", "voidage"},
                           Shown{pressure_drop, "pressure_drop", "{/Symbol D}p"},
                           Shown{force_ratio, "force_ratio", "|F_c|/mg"}};

const std::vector<Level>& levels_of(const Sequence& sequence, const Shown& quantity) {
  static const std::vector<Level> none;
  for (const auto& of : sequence.quantities)
    if (of.quantity == quantity.of_runs || of.quantity == quantity.of_studies) return of.levels;
  return none;
}

/// Value and half width of every quantity over that of the finest level, one row for each size.
DataTable table_of(const Sequence& sequence, std::size_t number) {
  DataTable table{fmt::format("grid-convergence_{}", number),
                  {sequence.refined == Refined::cells ? "cell width [mm]" : "step [ms]"},
                  {}};
  std::map<double, std::vector<double>> rows;
  for (std::size_t q = 0; q < shown.size(); ++q) {
    table.columns.push_back(fmt::format("{} over that of the finest [-]", shown[q].of_runs));
    table.columns.emplace_back("half width [-]");
    const std::vector<Level>& levels = levels_of(sequence, shown[q]);
    if (levels.empty()) continue;
    const double finest = std::ranges::min(levels, {}, &Level::size).value;
    for (const Level& level : levels) {
      auto& row = rows.try_emplace(level.size, 1 + 2 * shown.size(), std::nan("")).first->second;
      row[0] = 1e3 * level.size;
      row[1 + 2 * q] = level.value / finest;
      row[2 + 2 * q] = level.half_width / std::abs(finest);
    }
  }
  for (auto& [size, row] : rows) table.rows.push_back(std::move(row));
  return table;
}

/// "0.0931 ± 0.0040 (7.1 mm)".
std::string level_text(Refined refined, const Level& level) {
  return fmt::format("{:.4g} ± {:.1g} ({})", level.value, level.half_width,
                     convergence::size_text(refined, level.size));
}

/// Of all runs of the profile that refines the default scene.
std::string cost_of_profile() {
  double core_seconds = 0.0;
  for (const RunSpec& run : load_profile("grid-convergence").runs)
    core_seconds += estimate_run(load_run_scene(run)).core_seconds;
  return format_duration(core_seconds);
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"grid-convergence", {}, folder.caption(), {}};
  std::vector<Sequence> sequences = run_sequences(context.results);
  for (Sequence& of_study : convergence::study_sequences(context.results)) sequences.push_back(std::move(of_study));

  DataTable results{"grid-convergence",
                    {"sequence [-]", "quantity [-]", "finest size [m or s]", "middle size [m or s]",
                     "coarsest size [m or s]", "behaviour [-]", "part that converges [-]", "observed order [-]",
                     "order from [-]", "order to [-]", "index [-]", "index from [-]", "index to [-]", "half range [-]"},
                    {}};
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::string findings =
      "| what is refined | bed | quantity | finest | coarsest | what the levels say |\n"
      "|---|---|---|---|---|---|\n";
  std::vector<std::string> tables, names;
  // Panels of cells, then of steps: the sequences that have a number there, by their place in the list.
  std::vector<std::string> panels(2 * shown.size());
  std::set<std::string> lacking;
  for (std::size_t s = 0; s < sequences.size(); ++s) {
    const Sequence& sequence = sequences[s];
    DataTable table = table_of(sequence, s + 1);
    if (table.rows.empty()) continue;
    if (table.rows.size() > 1) {
      output.data.push_back(write_csv(table, context.out));
      tables.push_back(table.name);
      names.push_back(sequence.title);
      const std::size_t row = sequence.refined == Refined::cells ? 0 : 1;
      for (std::size_t q = 0; q < shown.size(); ++q)
        if (std::ranges::any_of(table.rows, [&](const auto& one) { return std::isfinite(one[1 + 2 * q]); }))
          panels[row * shown.size() + q] += fmt::format("{} ", names.size());
    }
    if (table.rows.size() < 3)
      lacking.insert(
          fmt::format("{} ({}): {} of 3", sequence.title, convergence::name_of(sequence.refined), table.rows.size()));
    for (std::size_t q = 0; q < shown.size(); ++q) {
      const std::vector<Level>& levels = levels_of(sequence, shown[q]);
      if (levels.size() < 3) continue;
      const GridConvergence found = convergence::analyse(levels);
      const auto [order_low, order_high] = found.order_interval.value_or(std::pair(nothing, nothing));
      const auto [index_low, index_high] = found.index_interval.value_or(std::pair(nothing, nothing));
      const auto& [fine, middle, coarse] = found.levels;
      results.rows.push_back({static_cast<double>(s + 1), static_cast<double>(q + 1), fine.size, middle.size,
                              coarse.size, static_cast<double>(found.behaviour), found.shares.front(), found.order,
                              order_low, order_high, found.index, index_low, index_high, found.half_range});
      findings += fmt::format("| {} | {} | {} | {} | {} | {} |\n", convergence::name_of(sequence.refined),
                              sequence.title, shown[q].of_studies, level_text(sequence.refined, fine),
                              level_text(sequence.refined, coarse), convergence::describe(found));
    }
  }
  output.data.push_back(write_csv(results, context.out));
  output.findings = std::move(findings);
  if (!lacking.empty())
    output.notes.push_back(
        fmt::format("Too few levels for an order: {}. `slfb figures --profile grid-convergence --only-runs` simulates "
                    "what the default scene lacks, in about {} of one core.",
                    fmt::join(lacking, "; "), cost_of_profile()));

  PlotValues values;
  values.files("sequence", tables);
  values.texts("sequence_title", names);
  values.texts("panel", panels);
  std::vector<std::string> quantity_titles;
  for (const Shown& quantity : shown) quantity_titles.emplace_back(quantity.title);
  values.markups("quantity", quantity_titles);
  draw_plot("grid-convergence", folder.plot(), values, {1180, 640}, context.out);
  return output;
}

}  // namespace

Figure figure() { return {"grid-convergence", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::grid_convergence
