#include "solver/io/vtkhdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>

#include "solver/io/hdf5_file.hpp"
#include "solver/support/files.hpp"

namespace slfb::io {
namespace {

constexpr std::uint8_t vtk_vertex = 1;  // VTK_VERTEX of vtkCellType.h

void write_header(Hdf5File& target, const std::string& type, double time) {
  target.write_attribute("VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  target.write_attribute("VTKHDF", "Type", type);
  // An attribute, because VTK 9.1 cannot read the field data of an image.
  target.write_attribute("VTKHDF", "time_seconds", time);
}

void write_vectors(Hdf5File& target, const std::string& path, const dem::VectorField& field, const std::string& unit) {
  std::vector<double> interleaved;
  interleaved.reserve(3 * field.x.size());
  for (std::size_t i = 0; i < field.x.size(); ++i) {
    interleaved.insert(interleaved.end(), {field.x[i], field.y[i], field.z[i]});
  }
  target.write(path, interleaved, unit, Storage::float32, {field.x.size(), 3});
}

/// The points of the image along one axis: the cell centres, or both ends of a single cell, because VTK 9.1 cannot read
/// an image that is one point thick.
struct ImageAxis {
  ImageAxis(int cell_count, double lower, double cell_size)
      : cells(cell_count),
        points(std::max(cell_count, 2)),
        origin(cell_count > 1 ? lower + 0.5 * cell_size : lower),
        spacing(cell_size) {}
  [[nodiscard]] int cell_of(int point) const { return std::min(point, cells - 1); }

  int cells, points;
  double origin, spacing;
};

/// Point (ix, iy, iz) of a field over the cells, x fastest, as VTK stores images.
template <class ValueOfCell>
std::vector<double> image(const fluid::ColumnGrid& grid, const std::array<ImageAxis, 3>& axes, std::size_t components,
                          const ValueOfCell& value) {
  std::vector<double> values;
  for (int iz = 0; iz < axes[2].points; ++iz) {
    for (int iy = 0; iy < axes[1].points; ++iy) {
      for (int ix = 0; ix < axes[0].points; ++ix) {
        const int x = axes[0].cell_of(ix), y = axes[1].cell_of(iy), z = axes[2].cell_of(iz);
        const auto cell = static_cast<std::size_t>(grid.cell_of_square(x, y) * grid.layers() + z);
        for (std::size_t c = 0; c < components; ++c) {
          values.push_back(grid.square_inside(x, y) ? value(cell, c) : std::numeric_limits<double>::quiet_NaN());
        }
      }
    }
  }
  return values;
}

constexpr double microsecond = 1e-6;  // [s]

}  // namespace

std::filesystem::path snapshot_file(const std::filesystem::path& folder, const std::string& kind, double time) {
  return folder / fmt::format("{}_{:09}.hdf", kind, std::llround(time / microsecond));
}

void write_snapshot_series(const std::filesystem::path& folder, const std::string& kind) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".hdf" && entry.path().filename().string().starts_with(kind + "_"))
      names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  std::string files;
  for (const std::string& name : names)
    files += fmt::format("{}\n    {{\"name\": \"{}\", \"time\": {:.6f}}}", files.empty() ? "" : ",", name,
                         microsecond * std::stod(name.substr(kind.size() + 1)));
  write_file(folder / (kind + ".hdf.series"),
             fmt::format("{{\n  \"file-series-version\": \"1.0\",\n  \"files\": [{}\n  ]\n}}\n", files));
}

void write_particles_vtkhdf(const std::filesystem::path& file, const dem::Particles& particles, double time) {
  const auto count = static_cast<std::int64_t>(particles.size());
  // Vertex i is point i.
  std::vector<std::int64_t> connectivity(particles.size());
  std::iota(connectivity.begin(), connectivity.end(), 0);
  std::vector<std::int64_t> offsets = connectivity;
  offsets.push_back(count);
  std::vector<double> diameter(particles.radius);
  for (double& value : diameter) value *= 2.0;

  write_atomically(file, [&](Hdf5File& target) {
    write_header(target, "UnstructuredGrid", time);
    target.write("VTKHDF/NumberOfPoints", std::vector{count});
    target.write("VTKHDF/NumberOfCells", std::vector{count});
    target.write("VTKHDF/NumberOfConnectivityIds", std::vector{count});
    target.write("VTKHDF/Connectivity", connectivity);
    target.write("VTKHDF/Offsets", offsets);
    target.write("VTKHDF/Types", std::vector<std::uint8_t>(particles.size(), vtk_vertex));
    write_vectors(target, "VTKHDF/Points", particles.position, "m");
    target.write("VTKHDF/PointData/radius", particles.radius, "m", Storage::float32);
    target.write("VTKHDF/PointData/diameter", diameter, "m", Storage::float32);
    write_vectors(target, "VTKHDF/PointData/velocity", particles.velocity, "m s-1");
    write_vectors(target, "VTKHDF/PointData/angular_velocity", particles.angular_velocity, "rad s-1");
    target.write("VTKHDF/PointData/species",
                 std::vector<std::int64_t>(particles.species.begin(), particles.species.end()));
  });
}

void write_liquid_vtkhdf(const std::filesystem::path& file, const fluid::ColumnGrid& grid,
                         const std::vector<double>& voidage, const std::array<std::vector<double>, 3>& cell_velocity,
                         const std::vector<double>& pressure, double time) {
  const std::array<ImageAxis, 3> axes{ImageAxis(grid.squares(0), grid.lower(0), grid.spacing(0)),
                                      ImageAxis(grid.squares(1), grid.lower(1), grid.spacing(1)),
                                      ImageAxis(grid.layers(), 0.0, grid.cell_height())};
  std::vector<std::int64_t> extent;
  std::vector<double> origin, spacing;
  Shape scalar;
  for (const ImageAxis& axis : axes) {
    extent.insert(extent.end(), {0, axis.points - 1});
    origin.push_back(axis.origin);
    spacing.push_back(axis.spacing);
    scalar.insert(scalar.begin(), static_cast<std::size_t>(axis.points));
  }
  Shape vector = scalar;
  vector.push_back(3);

  // Values belong to points, because VTK 9.1 cannot read the cell data of an image.
  write_atomically(file, [&](Hdf5File& target) {
    write_header(target, "ImageData", time);
    target.write_attribute("VTKHDF", "WholeExtent", extent);
    target.write_attribute("VTKHDF", "Origin", origin);
    target.write_attribute("VTKHDF", "Spacing", spacing);
    target.write_attribute("VTKHDF", "Direction", std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    const auto write_scalar = [&](const char* path, const std::vector<double>& field, const char* unit) {
      target.write(path, image(grid, axes, 1, [&](std::size_t cell, std::size_t) { return field[cell]; }), unit,
                   Storage::float32, scalar);
    };
    write_scalar("VTKHDF/PointData/voidage", voidage, "1");
    write_scalar("VTKHDF/PointData/pressure", pressure, "Pa");
    target.write("VTKHDF/PointData/velocity",
                 image(grid, axes, 3, [&](std::size_t cell, std::size_t c) { return cell_velocity[c][cell]; }), "m s-1",
                 Storage::float32, vector);
  });
}

}  // namespace slfb::io
