#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

struct Model {
  const char *law, *title, *colour;
  int point_type;
};
constexpr std::array models{Model{"kunii-levenspiel-1969", "Kunii, Levenspiel", "law_four", 8},
                            Model{"di-felice-1991", "Di Felice", "law_two", 12},
                            Model{"kennedy-bretton-1966", "Kennedy, Bretton", "law_three", 10},
                            Model{"joshi-1983-reconstruction", "Joshi (reconstructed)", "law_one", 4},
                            Model{"van-der-wielen-1996", "van der Wielen", "quiet", 14}};

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const auto& table2 = peng_2014().table2();
  FigureOutput output{"fig11", {}, "", run_notes(context, keys)};
  output.caption =
      "Classification velocity of the 6 mm steel sphere in 5 mm glass: six correlations and our simulation against the "
      "paper's own simulation (Table 2), at the same superficial velocity. The paper compares with measurements, which "
      "are lost: its 18 simulated values stand in for them, so this plot shows how far models and simulations are "
      "from each other, not from the truth. Grey bars: Grbavčić's model over all values of the transition function "
      "that "
      "is not available. Joshi's model is reconstructed. Solid: equality; dashed and dotted: 10 and 20 %. Filled "
      "symbols: "
      "our runs with 95 % intervals.";

  DataTable laws{"fig11_laws", {"superficial velocity [m/s]", "classification velocity of Table 2 [m/s]"}, {}};
  for (const Model& model : models) laws.columns.push_back(fmt::format("{} [m/s]", model.law));
  for (const char* end : {"lower", "upper"}) laws.columns.push_back(fmt::format("grbavcic-2009 {} [m/s]", end));
  for (const auto& row : table2) {
    std::vector<double> values{row.superficial_velocity, row.classification_velocity};
    const auto value = [&](const char* quantity, const char* law) {
      return context.measurements.at(measure_key(quantity, law, row.superficial_velocity)).value;
    };
    for (const Model& model : models) values.push_back(value("classification_velocity", model.law));
    values.push_back(value("classification_velocity_lower", "grbavcic-2009"));
    values.push_back(value("classification_velocity_upper", "grbavcic-2009"));
    laws.rows.push_back(values);
  }
  std::sort(laws.rows.begin(), laws.rows.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  output.data.push_back(write_csv(laws, context.out));

  std::string correlations;
  for (std::size_t place = 0; place < models.size(); ++place)
    correlations += fmt::format(
        ", 'fig11_laws.csv' skip 1 using 2:{} with points linecolor rgb {} pointtype {} pointsize 0.65 title '{}'",
        place + 3, models[place].colour, models[place].point_type, models[place].title);

  std::string simulated;
  const auto variants = variants_of(context.profile, system_name);
  for (std::size_t place = 0; place < variants.size(); ++place) {
    DataTable table{"fig11_simulated_" + (variants[place].empty() ? std::string("default") : variants[place]),
                    {"superficial velocity [m/s]", "classification velocity of Table 2 [m/s]",
                     "simulated classification velocity [m/s]", "half width of its 95 % interval [m/s]"},
                    {}};
    for (const auto& point :
         measured_points(context.measurements, "classification_velocity", system_name, variants[place]))
      for (const auto& row : table2)
        if (std::fabs(row.superficial_velocity - point.superficial_velocity) < 1e-6)
          table.rows.push_back({row.superficial_velocity, row.classification_velocity, point.value, point.half_width});
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, context.out));
    const int style = line_style(place);
    simulated += fmt::format(", {}'{}.csv' skip 1 using 2:3 with points linestyle {} title {}",
                             error_bars(table, {2, 3, 4}, "yerrorbars", style), table.name, style,
                             gnuplot_text(series_title(context, system_name, variants[place])));
  }
  const std::string script =
      "set key tmargin left vertical maxrows 6 Left reverse font ',11'\nset xrange [0.05:0.45]\nset yrange [0:0.8]\n"
      "set xtics 0.1\nset ytics 0.1\n"
      "set xlabel 'V_2 simulated by the paper [m/s]'\nset ylabel 'V_2 predicted [m/s]'\n"
      "plot 'fig11_laws.csv' skip 1 using 2:8:2:2:8:9 with xyerrorbars linecolor rgb '#c3c9d0' linewidth 2.5 pointsize "
      "0 "
      "title 'Grbavčić, f from 0 to 1', "
      "x with lines linecolor rgb paper linewidth 1.2 title 'equality', 0.9*x with lines linestyle 1 linewidth 1 title "
      "'10 "
      "%', 1.1*x with lines linestyle 1 linewidth 1 notitle, 0.8*x with lines linestyle 20 linecolor rgb paper title "
      "'20 "
      "%', 1.2*x with lines linestyle 20 linecolor rgb paper notitle" +
      correlations + simulated + "\n";
  draw_figure_of_runs("fig11", script, {560, 560}, context, keys);
  return output;
}

}  // namespace

Figure fig11() {
  return {"fig11", "Classification velocity: models against simulation", needs, draw,
          "peng_2014/fig11_velocity_parity"};
}

}  // namespace slfb
