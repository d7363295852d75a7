#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/figures/figure.hpp"
#include "reports/gnuplot.hpp"

/// What the figures have in common: which runs they draw, what is still missing, and how a series is named.
namespace slfb {

/// Keys ("system/U_L[/variant]") of the runs of a profile for which `wanted` holds, each once.
std::vector<std::string> select_run_keys(const Profile& profile, const std::function<bool(const RunSpec&)>& wanted);

/// A run with this key; null when it is not simulated yet. Of several (profiles share keys) one of the current numerics
/// version, then one that keeps the positions of the spheres, then the one whose first drop is sampled most finely:
/// committed results are thinned.
const FinishedRun* find_run(const FigureContext& context, std::string_view key);

/// The same for figures of single contacts: the run is one of `own_springs` (runs_with_own_springs), unless another was
/// recorded more often.
const FinishedRun* find_contact_run(const FigureContext& context, const std::vector<FinishedRun>& own_springs,
                                    std::string_view key);

/// Says which of these runs stand behind the contacts, collisions and single forces of a figure.
std::string springs_note(const std::vector<FinishedRun>& own_springs);

/// One measured quantity at one superficial velocity.
struct MeasuredPoint {
  double superficial_velocity = 0.0;  ///< [m/s]
  double value = 0.0;
  double half_width = std::numeric_limits<double>::quiet_NaN();  ///< of the 95 % interval; NaN for a single sample
};

/// All points of "quantity/system/*[/variant]", by rising velocity.
std::vector<MeasuredPoint> measured_points(const Measurements& measurements, std::string_view quantity,
                                           std::string_view system, std::string_view variant = "");

/// Mean over the runs of a system without variant, for numbers that hardly depend on U_L (the packed bed's voidage).
std::optional<double> mean_over_runs(const Measurements& measurements, std::string_view quantity,
                                     std::string_view system);

/// The variants of a system that the profile names, the default ("") first.
std::vector<std::string> variants_of(const Profile& profile, std::string_view system);

/// Mean time between two samples of a drop [s]: committed results hold every twentieth, unless they are kept whole.
double sample_interval(const DropSeries& drop);

/// "simulated, Gidaspow-1994 drag" for the default once a run tells which law that is; the variant's name otherwise.
std::string series_title(const FigureContext& context, std::string_view system, const std::string& variant);

/// gnuplot line style of the variant with this place in variants_of: 2, 3, 4, 5, then from the start.
int line_style(std::size_t place);

/// What stands on the abscissa of a plot against the state of the bed.
enum class BedAbscissa { voidage, solid_fraction };

/// One quantity over the runs of a system against the mean state of its bed, by rising velocity. Columns: superficial
/// velocity, abscissa, half width of its 95 % interval, the quantity (`heading`), half width of its interval.
DataTable against_bed(const FigureContext& context, std::string_view quantity, const std::string& heading,
                      std::string_view system, std::string_view variant, BedAbscissa abscissa);

/// A table that is drawn as one series: points with error bars.
struct Series {
  DataTable table;
  std::string title;  ///< in the key, shown as written; may be empty
  int line_style;     ///< of reports/style.gp
};

/// Writes the tables of those series that have rows and gives a plot their lists: NAME[i] (the file), NAME_title[i],
/// NAME_style[i] and NAME_count.
void add_series(const std::string& name, const std::vector<Series>& series, PlotValues& values,
                const FigureContext& context, FigureOutput& output);

/// against_bed for the default and every variant of a system, titled by series_title. Each table is named
/// ID_QUANTITY_SYSTEM[_VARIANT].
std::vector<Series> variants_against_bed(const std::string& id, std::string_view quantity, const std::string& heading,
                                         std::string_view system, BedAbscissa abscissa, const FigureContext& context);

/// What a reader must know of the runs behind a figure: differences of the profile from the source, missing runs, runs
/// read from the committed results, runs of an older numerics version.
std::vector<std::string> run_notes(const FigureContext& context, const std::vector<std::string>& keys);

/// Draws the gnuplot file `plot` as ID (draw_plot); when no run of `keys` exists, how to simulate it is printed below.
///
/// The plot may use `width` and `height` (of the picture, in pixels) and `base` (the part of the height that this text
/// takes, experiments/figures/footer.gp). A figure of several plots begins with `set multiplot` and says
/// `eval footer_drawn` after its first plot, so that the text is drawn once.
void draw_plot_of_runs(const std::string& id, const std::filesystem::path& plot, PlotValues values, Canvas canvas,
                       const FigureContext& context, const std::vector<std::string>& keys);

}  // namespace slfb
