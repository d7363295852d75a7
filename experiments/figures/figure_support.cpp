#include "experiments/figures/figure_support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>

#include "experiments/runs/measure.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

std::string join(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const auto& part : parts) {
    if (!text.empty()) text += separator;
    text += part;
  }
  return text;
}

/// Lines of at most `width` characters, broken at spaces.
std::vector<std::string> wrap(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      lines.push_back(line);
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::vector<const FinishedRun*> present_runs(const FigureContext& context, const std::vector<std::string>& keys) {
  std::vector<const FinishedRun*> present;
  for (const auto& run : context.runs)
    if (std::find(keys.begin(), keys.end(), run_key(run.spec)) != keys.end()) present.push_back(&run);
  return present;
}

/// Sentences that set the runs apart from those of the source, profile by profile; what a profile shares with one
/// before it is not said twice.
std::vector<std::string> differences_of(const FigureContext& context, const std::vector<const FinishedRun*>& present) {
  std::vector<std::string> profiles, sentences;
  for (const FinishedRun* run : present) {
    const std::string& name = run->spec.profile.empty() ? context.profile.name : run->spec.profile;
    if (std::find(profiles.begin(), profiles.end(), name) != profiles.end()) continue;
    profiles.push_back(name);
    sentences.push_back(fmt::format("Profile {}.", name));
    for (const auto& sentence : name == context.profile.name ? context.profile.differences : run->spec.differences)
      if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end()) sentences.push_back(sentence);
  }
  return sentences;
}

/// What a run lacks that a figure may need; the least is best.
std::tuple<bool, bool, double> lack(const FinishedRun& run) {
  const auto& drops = run.result.drops;
  const double interval = drops.empty() ? std::nan("") : sample_interval(drops.front());
  // To a tenth of a millisecond: what rounding leaves of equal intervals is no difference.
  return {run.stale, run.result.snapshots.empty(),
          std::isnan(interval) ? std::numeric_limits<double>::infinity() : std::round(1e4 * interval)};
}

const FinishedRun* best_of(const std::vector<FinishedRun>& runs, std::string_view key) {
  const FinishedRun* found = nullptr;
  for (const auto& run : runs)
    if (run_key(run.spec) == key && (found == nullptr || lack(run) < lack(*found))) found = &run;
  return found;
}

}  // namespace

std::vector<std::string> select_run_keys(const Profile& profile, const std::function<bool(const RunSpec&)>& wanted) {
  std::vector<std::string> keys;
  for (const auto& spec : profile.runs) {
    const std::string key = run_key(spec);
    if (wanted(spec) && std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  }
  return keys;
}

double sample_interval(const DropSeries& drop) {
  if (drop.time.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (drop.time.back() - drop.time.front()) / static_cast<double>(drop.time.size() - 1);
}

const FinishedRun* find_run(const FigureContext& context, std::string_view key) { return best_of(context.runs, key); }

const FinishedRun* find_contact_run(const FigureContext& context, const std::vector<FinishedRun>& own_springs,
                                    std::string_view key) {
  const FinishedRun* own = best_of(own_springs, key);
  const FinishedRun* other = find_run(context, key);
  return own == nullptr || (other != nullptr && lack(*other) < lack(*own)) ? other : own;
}

std::string springs_note(const std::vector<FinishedRun>& own_springs) {
  std::set<std::string> keys;
  for (const FinishedRun& run : own_springs)
    keys.insert(run_key(run.spec.system, run.spec.superficial_velocity, run.spec.variant));
  std::string settings;
  if (!own_springs.empty())
    settings = fmt::format(" (profile {}: {}). Their settings: {}", own_springs.front().spec.profile,
                           fmt::join(keys, ", "), join(own_springs.front().spec.differences, " "));
  return "Contacts, collisions and single forces depend on the stiffness of the springs: with softer ones contacts "
         "last longer, with the root of mass over stiffness, and fewer collisions are counted. They are taken from "
         "runs with the springs of the source" +
         (settings.empty() ? std::string(": none yet.") : settings);
}

std::vector<MeasuredPoint> measured_points(const Measurements& measurements, std::string_view quantity,
                                           std::string_view system, std::string_view variant) {
  std::vector<MeasuredPoint> points;
  for (const auto& [velocity, measured] : over_numbers(measurements, quantity, system, variant))
    points.push_back({velocity, measured.value, measured.half_width});
  return points;
}

std::optional<double> mean_over_runs(const Measurements& measurements, std::string_view quantity,
                                     std::string_view system) {
  const auto points = measured_points(measurements, quantity, system);
  if (points.empty()) return std::nullopt;
  double sum = 0.0;
  for (const auto& point : points) sum += point.value;
  return sum / static_cast<double>(points.size());
}

std::vector<std::string> variants_of(const Profile& profile, std::string_view system) {
  std::vector<std::string> variants{""};
  for (const auto& spec : profile.runs)
    if (spec.system == system && std::find(variants.begin(), variants.end(), spec.variant) == variants.end())
      variants.push_back(spec.variant);
  return variants;
}

std::string series_title(const FigureContext& context, std::string_view system, const std::string& variant) {
  if (!variant.empty()) return "simulated, " + variant;
  for (const auto& run : context.runs)
    if (run.spec.system == system && run.spec.variant.empty()) return "simulated, " + run.scene.coupling.drag_law;
  return "simulated";
}

int line_style(std::size_t place) { return 2 + static_cast<int>(place % 4); }

DataTable against_bed(const FigureContext& context, std::string_view quantity, const std::string& heading,
                      std::string_view system, std::string_view variant, BedAbscissa abscissa) {
  const bool solids = abscissa == BedAbscissa::solid_fraction;
  const std::string unit = heading.substr(std::min(heading.find('['), heading.size()));
  DataTable table{fmt::format("{}_{}{}{}", quantity, system, variant.empty() ? "" : "_", variant),
                  {"superficial velocity [m/s]", solids ? "solid fraction [-]" : "voidage [-]",
                   "half width of its 95 % interval [-]", heading, "half width of its 95 % interval " + unit},
                  {}};
  for (const auto& point : measured_points(context.measurements, quantity, system, variant)) {
    const auto voidage =
        context.measurements.find(measure_key("voidage_centre_of_mass", system, point.superficial_velocity, variant));
    if (voidage == context.measurements.end()) continue;
    const double share = solids ? 1.0 - voidage->second.value : voidage->second.value;
    table.rows.push_back(
        {point.superficial_velocity, share, voidage->second.half_width, point.value, point.half_width});
  }
  return table;
}

void add_series(const std::string& name, const std::vector<Series>& series, PlotValues& values,
                const FigureContext& context, FigureOutput& output) {
  std::vector<std::string> tables, titles;
  std::vector<double> styles;
  for (const Series& one : series) {
    if (one.table.rows.empty()) continue;
    output.data.push_back(write_csv(one.table, context.out));
    tables.push_back(one.table.name);
    titles.push_back(one.title);
    styles.push_back(one.line_style);
  }
  values.files(name, tables);
  values.texts(name + "_title", titles);
  values.numbers(name + "_style", styles);
}

std::vector<Series> variants_against_bed(const std::string& id, std::string_view quantity, const std::string& heading,
                                         std::string_view system, BedAbscissa abscissa, const FigureContext& context) {
  std::vector<Series> series;
  const auto variants = variants_of(context.profile, system);
  for (std::size_t k = 0; k < variants.size(); ++k) {
    DataTable table = against_bed(context, quantity, heading, system, variants[k], abscissa);
    table.name = id + "_" + table.name;
    series.push_back({std::move(table), series_title(context, system, variants[k]), slfb::line_style(k)});
  }
  return series;
}

std::vector<std::string> run_notes(const FigureContext& context, const std::vector<std::string>& keys) {
  std::vector<std::string> notes;
  const auto present = present_runs(context, keys);
  for (auto& sentence : differences_of(context, present)) notes.push_back(std::move(sentence));
  std::vector<std::string> missing, published, stale, without_drop;
  for (const auto& key : keys)
    if (find_run(context, key) == nullptr) missing.push_back(key);
  for (const FinishedRun* run : present) {
    std::size_t asked = 0;
    for (const Stage& stage : run->scene.stages)
      if (stage.kind == StageKind::drop) asked += static_cast<std::size_t>(stage.repetitions);
    if (const std::size_t dropped = run->result.drops.size(); dropped < asked)
      without_drop.push_back(fmt::format("{} ({} of {})", run_key(run->spec), dropped, asked));
    if (run->published) published.push_back(run_key(run->spec));
    if (run->stale) stale.push_back(run_key(run->spec));
  }
  if (keys.empty()) notes.push_back("Neither this profile nor the full one has a simulation for this figure.");
  if (!missing.empty()) notes.push_back(fmt::format("Not yet simulated: {}.", join(missing, ", ")));
  if (!without_drop.empty())
    notes.push_back(
        fmt::format("Fewer spheres could be dropped than asked, for the bed reaches up to the place of release: {}.",
                    join(without_drop, ", ")));
  if (!published.empty()) notes.push_back(fmt::format("Read from the committed results: {}.", join(published, ", ")));
  if (!stale.empty()) notes.push_back(fmt::format("Made by an older version of the numerics: {}.", join(stale, ", ")));
  return notes;
}

void draw_plot_of_runs(const std::string& id, const std::filesystem::path& plot, PlotValues values, Canvas canvas,
                       const FigureContext& context, const std::vector<std::string>& keys) {
  std::vector<std::string> lines;
  if (present_runs(context, keys).empty())
    lines = wrap(
        fmt::format("Not yet simulated. \"build/slfb figures {} --profile full\" simulates it and draws it again.", id),
        static_cast<std::size_t>(std::max(40, canvas.width / 5)));
  const int footer_height = lines.empty() ? 0 : 13 * static_cast<int>(lines.size()) + 8;
  canvas.height += footer_height;
  values.texts("footer", lines);
  values.number("footer_height", footer_height);
  draw_plot(id, plot, values, canvas, context.out, source_folder() / "experiments" / "figures" / "footer.gp");
}

}  // namespace slfb
