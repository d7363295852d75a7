#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/gidaspow_1994.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/league/prediction.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::measured_neighbours {
namespace {

const FigureFolder folder{"peng_2014/measured_neighbours"};
constexpr const char* system = "6in5W";

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) { return spec.variant.empty() && spec.system == system; });
}

league::Bed paper_bed() {
  return {paper::glass(0.005), paper::water(), peng_2014().value("column_diameter"), BedMotion::fluidised};
}

/// Of the homogeneous bed [-].
template <class Law>
double homogeneous(const Law& law, double velocity) {
  return fluidisation::bed_voidage(law, paper_bed().sphere, paper_bed().liquid, velocity, paper::packed_voidage())
      .voidage;
}

/// A law's voidage less another one, mean over the printed velocities.
template <class Law, class Other>
double mean_difference(const Law& law, Other other) {
  double sum = 0.0;
  for (const VoidagePoint& point : peng_2014().figure13())
    sum += homogeneous(law, point.superficial_velocity) - other(point);
  return sum / static_cast<double>(peng_2014().figure13().size());
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"measured-neighbours", {}, "", run_notes(context, keys)};
  const league::Bed bed = paper_bed();
  const auto all = league::contenders();
  const auto& lines = league::measured().lines;
  const league::Contender& formula = league::recommended(all, lines);
  auto near = league::near_lines(bed, lines);
  near.resize(std::min<std::size_t>(near.size(), 3));

  DataTable curves{"measured_neighbours_curves",
                   {"superficial velocity [m/s]", "voidage by Eq. 36 [-]", "voidage by Gidaspow 1994 [-]",
                    fmt::format("voidage by {} [-]", formula.name()), "one sigma below [-]", "one sigma above [-]"},
                   {}};
  for (const ExpansionLine& line : near) curves.columns.push_back(fmt::format("voidage by {} [-]", line.name));
  for (int step = 45; step <= 240; step += 3) {
    const double velocity = 1e-3 * step;
    const auto predicted = league::predict_voidage(formula, bed, velocity, paper::packed_voidage(), lines);
    std::vector<double> row{velocity,
                            homogeneous(drag::Doroodchi2012{}, velocity),
                            homogeneous(drag::Gidaspow1994{}, velocity),
                            predicted.value,
                            predicted.one_sigma.first,
                            predicted.one_sigma.second};
    for (const ExpansionLine& line : near) row.push_back(league::voidage_by_line(line, bed, velocity));
    curves.rows.push_back(std::move(row));
  }
  DataTable printed{"measured_neighbours_printed", {"superficial velocity [m/s]", "voidage [-]"}, {}};
  double nearest = 0.0, by_formula = 0.0;
  const auto count = static_cast<double>(peng_2014().figure13().size());
  const auto measured_voidage = [&](const VoidagePoint& point) {
    return league::voidage_by_line(near.front(), bed, point.superficial_velocity);
  };
  for (const VoidagePoint& point : peng_2014().figure13()) {
    printed.rows.push_back({point.superficial_velocity, point.voidage});
    nearest += (point.voidage - measured_voidage(point)) / count;
    by_formula +=
        (point.voidage -
         league::predict_voidage(formula, bed, point.superficial_velocity, paper::packed_voidage(), lines).value) /
        count;
  }
  struct Row {
    std::string law;
    double less_printed, less_measured;
  };
  std::vector<Row> rows;
  for_each_law<drag::DragLaws>([&](const auto& law) {
    rows.push_back({std::string(law.info.name),
                    mean_difference(law, [](const VoidagePoint& point) { return point.voidage; }),
                    mean_difference(law, measured_voidage)});
  });
  // Laws that leave the frame say no more than that.
  std::erase_if(rows, [](const Row& row) { return std::abs(row.less_printed) > 0.2; });
  std::ranges::sort(rows, std::greater{}, [](const Row& row) { return std::abs(row.less_measured); });
  DataTable laws{"measured_neighbours_laws", {"place [-]", "less printed [-]", "less measured [-]"}, {}};
  std::vector<std::string> names;
  for (const Row& row : rows) {
    names.push_back(row.law);
    laws.rows.push_back({static_cast<double>(names.size()), row.less_printed, row.less_measured});
  }
  for (const DataTable* table : {&curves, &printed, &laws}) output.data.push_back(write_csv(*table, context.out));

  double our_difference = 0.0;
  const auto our_points = measured_points(context.measurements, "voidage_centre_of_mass", system);
  std::size_t compared = 0;
  for (const MeasuredPoint& point : our_points)
    if (point.superficial_velocity > 0.055) {
      our_difference += point.value - league::voidage_by_line(near.front(), bed, point.superficial_velocity);
      ++compared;
    }
  const std::string of_ours =
      compared == 0 ? ""
                    : fmt::format(" Our beds with the paper's drag law lie {:+.3f} from it ({} velocities).",
                                  our_difference / static_cast<double>(compared), compared);
  output.caption = folder.caption(
      {{"findings",
        fmt::format("The printed voidages lie {:+.3f} from the nearest measured line and {:+.3f} from the "
                    "formula, in the mean; Gidaspow's homogeneous bed {:+.3f} from that line, Eq. 36 {:+.3f}.",
                    nearest, by_formula, mean_difference(drag::Gidaspow1994{}, measured_voidage),
                    mean_difference(drag::Doroodchi2012{}, measured_voidage)) +
            of_ours}});
  PlotValues values;
  DataTable ours{"measured_neighbours_simulated", {"superficial velocity [m/s]", "voidage [-]"}, {}};
  for (const MeasuredPoint& point : our_points) ours.rows.push_back({point.superficial_velocity, point.value});
  add_series("simulated", {{std::move(ours), "our bed", 2}}, values, context, output);
  std::vector<std::string> titles;
  for (const ExpansionLine& line : near)
    titles.push_back(fmt::format("{:g} mm {}, {}, {:.0f} mm", 1e3 * line.sphere.diameter, line.particle,
                                 line.liquid_name, 1e3 * line.tube_diameter));
  values.texts("line", titles);
  values.texts("law", names);
  draw_plot_of_runs("measured-neighbours", folder.plot(), values, {1240, 580}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"measured-neighbours", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::measured_neighbours
