#include "experiments/figures/run_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "correlations/materials.hpp"
#include "experiments/figures/sphere_picture.hpp"
#include "experiments/quantities/analysis.hpp"
#include "reports/gnuplot.hpp"
#include "reports/html.hpp"
#include "solver/io/hdf5_file.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

fs::path plot_file(const std::string& name) {
  return source_folder() / "experiments" / "figures" / "run_page" / (name + ".gp");
}

/// Columns of equal length as a table.
DataTable table_of(const std::string& name, const std::vector<std::string>& headings,
                   const std::vector<const std::vector<double>*>& columns) {
  DataTable table{name, headings, {}};
  for (std::size_t i = 0; i < columns.front()->size(); ++i) {
    std::vector<double> row;
    for (const auto* column : columns) row.push_back(i < column->size() ? (*column)[i] : std::nan(""));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What a page shows of one plot; without a picture `text` says why.
struct Plot {
  std::string title, text, picture;
};

/// The largest height that matters: of bed and dropped spheres [m].
double height_in_use(const Scene& scene, const RunResult& result) {
  double height = 0.0;
  for (const double top : result.bed.bed_top) height = std::max(height, top);
  for (const DropSeries& drop : result.drops)
    for (const double z : drop.z) height = std::max(height, z);
  return height > 0.0 ? std::min(1.05 * height, scene.geometry.height) : scene.geometry.height;
}

double half_width(const Scene& scene) {
  return scene.geometry.shape == Shape::cylinder ? 0.5 * scene.geometry.diameter : 0.5 * scene.geometry.width[0];
}

Plot heights(const RunResult& result, const fs::path& folder) {
  Plot plot{"Heights", "Top of the bed, twice its centre of mass, and the centres of the dropped spheres.", ""};
  if (result.bed.time.empty()) return {plot.title, "No samples of the bed were recorded.", ""};
  std::vector<double> twice = result.bed.centre_of_mass_height;
  for (double& height : twice) height *= 2.0;
  write_csv(table_of("bed", {"time [s]", "top of the bed [m]", "twice its centre of mass [m]"},
                     {&result.bed.time, &result.bed.bed_top, &twice}),
            folder);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < result.drops.size(); ++i) {
    std::vector<double> time = result.drops[i].time;
    for (double& value : time) value += result.drops[i].release_time;
    names.push_back(fmt::format("drop_{:02}", i));
    write_csv(table_of(names.back(), {"time [s]", "height [m]"}, {&time, &result.drops[i].z}), folder);
  }
  PlotValues values;
  values.files("drop", names);
  draw_plot("heights", plot_file("heights"), values, {720, 400}, folder, {}, {"svg"});
  plot.picture = "heights.svg";
  return plot;
}

Plot pressure(const Scene& scene, const RunResult& result, const fs::path& folder) {
  Plot plot{"Pressure drop",
            "From inlet to outlet, the static head of the liquid removed; dashed: the weight of the bed "
            "less its buoyancy, over the cross-section.",
            ""};
  if (result.bed.time.empty()) return {plot.title, "No samples of the bed were recorded.", ""};
  write_csv(table_of("pressure", {"time [s]", "pressure drop [Pa]"}, {&result.bed.time, &result.bed.pressure_drop}),
            folder);
  double weight = 0.0;
  for (const Species& species : scene.species)
    weight += static_cast<double>(species.count) * (species.density - scene.liquid.density) *
              gravitational_acceleration * Sphere{species.diameter, species.density}.volume();
  PlotValues values;
  values.number("weight", weight / scene.geometry.cross_section());
  draw_plot("pressure", plot_file("pressure"), values, {720, 360}, folder, {}, {"svg"});
  plot.picture = "pressure.svg";
  return plot;
}

Plot track(const Scene& scene, const RunResult& result, const MeasuringRules& rules, const fs::path& folder) {
  if (result.drops.empty()) return {"Fall", "No sphere was dropped.", ""};
  const DropSeries& drop = result.drops.front();
  Plot plot{"Fall", "Height of the first dropped sphere over the time since its release.", "track.svg"};
  write_csv(table_of("track", {"time [s]", "height [m]", "velocity [m/s]"}, {&drop.time, &drop.z, &drop.velocity_z}),
            folder);
  PlotValues values;
  const auto fit = classification_of(drop, scene, rules);
  values.number("has_line", fit ? 1.0 : 0.0);
  if (fit) {
    values.number("velocity", fit->velocity);
    values.number("intercept", fit->intercept);
    plot.text +=
        fmt::format(" Its classification velocity V_2 is {:.4g} m/s, R² {:.4f}.", fit->velocity, fit->r_squared);
  } else {
    plot.text += " It has too few points in the window for a classification velocity.";
  }
  draw_plot("track", plot_file("track"), values, {720, 420}, folder, {}, {"svg"});
  return plot;
}

Plot forces(const RunResult& result, const fs::path& folder) {
  const BedSeries& bed = result.bed;
  if (bed.time.empty() || bed.pressure_force.empty())
    return {"Forces on bed and liquid", "No forces were recorded.", ""};
  write_csv(table_of("forces",
                     {"time [s]", "pressure [N]", "weight less buoyancy [N]", "bottom [N]", "walls [N]", "shear [N]",
                      "flow [N]", "inertia of spheres [N]", "inertia of liquid [N]"},
                     {&bed.time, &bed.pressure_force, &bed.buoyant_weight, &bed.bottom_force, &bed.wall_force,
                      &bed.shear_force, &bed.flow_force, &bed.sphere_inertia, &bed.liquid_inertia}),
            folder);
  draw_plot("forces", plot_file("forces"), {}, {720, 440}, folder, {}, {"svg"});
  return {"Forces on bed and liquid",
          "Vertical forces on spheres and liquid together, means between samples; they add up to zero.", "forces.svg"};
}

Plot voidage(const RunResult& result, const fs::path& folder) {
  const PlaneField& plane = result.plane;
  if (plane.voidage.empty()) return {"Voidage", "No plane was recorded: there is no flowing liquid.", ""};
  DataTable table{"plane", {"x [m]", "z [m]", "voidage [-]"}, {}};
  for (std::size_t iz = 0; iz < plane.z.size(); ++iz)
    for (std::size_t ix = 0; ix < plane.x.size(); ++ix)
      table.rows.push_back({plane.x[ix], plane.z[iz], plane.voidage[iz * plane.x.size() + ix]});
  write_csv(table, folder);
  PlotValues values;
  values.number("columns", static_cast<double>(plane.x.size()));
  draw_plot("voidage", plot_file("voidage"), values, {360, 640}, folder, {}, {"svg"});
  return {"Voidage", fmt::format("In the plane y = 0 at {:.3g} s, the end of the fluidise stage.", plane.time),
          "voidage.svg"};
}

/// Pixels per metre, and the size of a picture of a column up to a height.
struct Scale {
  Scale(const Scene& scene, double upper_height)
      : upper(upper_height), half(half_width(scene)), pixels(std::min(600.0 / upper_height, 260.0 / (2.0 * half))) {}
  [[nodiscard]] Canvas canvas() const {
    return {static_cast<int>(std::lround(2.0 * half * pixels)) + 80,
            static_cast<int>(std::lround(upper * pixels)) + 70};
  }
  double upper, half, pixels;
};

void draw_spheres(const std::string& id, const Snapshot& snapshot, const Scale& scale, const fs::path& folder,
                  const std::string& format) {
  const DataTable picture = sphere_picture(
      snapshot, {.lower_x = -scale.half, .upper_x = scale.half, .lower_z = 0.0, .upper_z = scale.upper}, id + "_discs");
  write_csv(picture, folder);
  PlotValues values;
  values.files("discs", {picture.name});
  values.number("half_width", scale.half);
  values.number("upper_height", scale.upper);
  values.number("scale", scale.pixels);
  values.text("moment", fmt::format("{:.3f} s", snapshot.time));
  draw_plot(id, plot_file("spheres"), values, scale.canvas(), folder, {}, {format});
}

Plot spheres(const Scene& scene, const RunResult& result, const fs::path& folder) {
  if (result.snapshots.empty()) return {"Spheres", "No positions of the spheres were kept.", ""};
  const Snapshot& last = result.snapshots.back();
  draw_spheres("spheres", last, Scale(scene, height_in_use(scene, result)), folder, "svg");
  return {"Spheres", fmt::format("At {:.3g} s; the front half is cut away, the dropped sphere is red.", last.time),
          "spheres.svg"};
}

std::vector<std::vector<std::string>> facts(const Scene& scene, const RunResult& result) {
  std::size_t count = 0;
  for (const Species& species : scene.species) count += static_cast<std::size_t>(species.count);
  return {{"Run", "<code>" + escape_html(result.name) + "</code>"},
          {"Spheres", fmt::format("{}", count)},
          {"Superficial velocity", fmt::format("{:.3g} m/s", scene.liquid.superficial_velocity)},
          {"Drag law", escape_html(scene.coupling.drag_law)},
          {"Packed bed", fmt::format("voidage {:.4f}, height {:.4f} m", result.packed_voidage, result.packed_height)},
          {"Simulated",
           fmt::format("{} in {}, {} thread{}", readable_duration(result.simulated_seconds),
                       readable_duration(result.wall_seconds), result.threads, result.threads == 1 ? "" : "s")},
          {"Made by", fmt::format("slfb {}{}, numerics version {}, {}, {}", escape_html(result.suite_version),
                                  result.commit.empty() ? "" : " commit " + escape_html(result.commit), result.numerics,
                                  escape_html(result.machine), escape_html(result.date))}};
}

}  // namespace

fs::path write_run_page(const Scene& scene, const RunResult& result, const MeasuringRules& rules,
                        const fs::path& folder) {
  fs::create_directories(folder);
  std::string html = table_html({"What", "Value"}, facts(scene, result));
  for (const Plot& plot :
       {heights(result, folder), pressure(scene, result, folder), track(scene, result, rules, folder),
        forces(result, folder), voidage(result, folder), spheres(scene, result, folder)}) {
    html += fmt::format("<h2>{}</h2>\n<p>{}</p>\n", plot.title, prose_html(plot.text));
    if (!plot.picture.empty())
      html += fmt::format("<div class=\"card picture\"><img src=\"{}\" alt=\"{}\" /></div>\n", plot.picture,
                          escape_html(plot.title + ": " + plot.text));
  }
  html += "<h2>Scene</h2>\n<pre>" + escape_html(result.scene_text) + "</pre>\n";
  const fs::path page = folder / "index.html";
  const std::string title = scene.title.empty() ? result.name : scene.title;
  write_file(page, html_page(escape_html(title), fmt::format("<header class=\"masthead slim\"><div><h1>{}</h1></div>"
                                                             "</header>\n<main>\n{}</main>\n",
                                                             escape_html(title), html)));
  return page;
}

std::vector<Snapshot> snapshots_of(const RunResult& result, const fs::path& run_folder) {
  std::vector<fs::path> files;
  const fs::path folder = run_folder / "snapshots";
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().starts_with("particles_")) files.push_back(entry.path());
  if (files.empty()) return result.snapshots;
  std::ranges::sort(files);
  std::vector<Snapshot> snapshots;
  for (const fs::path& file : files) {
    const auto source = io::Hdf5File::open(file);
    Snapshot snapshot;
    snapshot.time = source.read_double_attribute("VTKHDF", "time_seconds");
    const std::vector<double> points = source.read_doubles("VTKHDF/Points");
    for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
      snapshot.x.push_back(points[i]);
      snapshot.y.push_back(points[i + 1]);
      snapshot.z.push_back(points[i + 2]);
    }
    snapshot.radius = source.read_doubles("VTKHDF/PointData/radius");
    // The last species is that of the dropped spheres, where there is more than one.
    const std::vector<std::int64_t> species = source.read_integers("VTKHDF/PointData/species");
    const auto foreign = std::ranges::find_if(species, [](std::int64_t one) { return one > 0; });
    if (foreign != species.end()) snapshot.foreign = foreign - species.begin();
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

std::size_t draw_frames(const Scene& scene, const std::vector<Snapshot>& snapshots, const fs::path& folder) {
  fs::create_directories(folder);
  double height = 0.0;
  for (const Snapshot& snapshot : snapshots)
    for (std::size_t i = 0; i < snapshot.z.size(); ++i) height = std::max(height, snapshot.z[i] + snapshot.radius[i]);
  const Scale scale(scene, std::min(1.02 * height, scene.geometry.height));
  for (std::size_t i = 0; i < snapshots.size(); ++i)
    draw_spheres(fmt::format("frame_{:04}", i), snapshots[i], scale, folder, "png");
  return snapshots.size();
}

}  // namespace slfb
