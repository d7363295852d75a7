#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/io/hdf5_file.hpp"
#include "solver/io/vtkhdf.hpp"
#include "tests/unit/synthetic_runs.hpp"

namespace slfb::io {
namespace {

class VtkHdfTest : public ::testing::Test {
 protected:
  VtkHdfTest()
      : file_(std::filesystem::path(::testing::TempDir()) /
              (std::string("slfb_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".vtkhdf")) {}
  ~VtkHdfTest() override { std::filesystem::remove(file_); }
  std::filesystem::path file_;
};

/// VTK reads the type only as an ASCII string of fixed length.
void expect_fixed_ascii_type(const std::filesystem::path& file, const std::string& expected) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen_by_name(handle, "VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  EXPECT_EQ(H5Tis_variable_str(type), 0);
  EXPECT_EQ(H5Tget_cset(type), H5T_CSET_ASCII);
  EXPECT_EQ(H5Tget_size(type), expected.size());
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(handle);
  EXPECT_EQ(Hdf5File::open(file).read_string_attribute("VTKHDF", "Type"), expected);
}

TEST_F(VtkHdfTest, SpheresAreVerticesWithTheirState) {
  dem::Particles particles;
  particles.add({0.001, 0.002, 0.003}, 0.0025, 2230.0, 0);
  particles.add({0.004, 0.005, 0.006}, 0.003, 7800.0, 1);
  particles.velocity.x[1] = 7.0;
  particles.angular_velocity.z[0] = -3.0;
  write_particles_vtkhdf(file_, particles, 1.25);

  expect_fixed_ascii_type(file_, "UnstructuredGrid");
  const Hdf5File source = Hdf5File::open(file_);
  using Integers = std::vector<std::int64_t>;
  EXPECT_EQ(source.read_integers_attribute("VTKHDF", "Version"), (Integers{1, 0}));
  EXPECT_EQ(source.read_integers("VTKHDF/NumberOfPoints"), Integers{2});
  EXPECT_EQ(source.read_integers("VTKHDF/NumberOfCells"), Integers{2});
  EXPECT_EQ(source.read_integers("VTKHDF/NumberOfConnectivityIds"), Integers{2});
  EXPECT_EQ(source.read_integers("VTKHDF/Connectivity"), (Integers{0, 1}));
  EXPECT_EQ(source.read_integers("VTKHDF/Offsets"), (Integers{0, 1, 2}));
  EXPECT_EQ(source.read_integers("VTKHDF/Types"), (Integers{1, 1}));
  EXPECT_EQ(source.shape("VTKHDF/Points"), (Shape{2, 3}));
  EXPECT_FLOAT_EQ(static_cast<float>(source.read_doubles("VTKHDF/Points")[4]), 0.005F);
  EXPECT_FLOAT_EQ(static_cast<float>(source.read_doubles("VTKHDF/PointData/diameter")[1]), 0.006F);
  EXPECT_FLOAT_EQ(static_cast<float>(source.read_doubles("VTKHDF/PointData/radius")[0]), 0.0025F);
  EXPECT_EQ(source.shape("VTKHDF/PointData/velocity"), (Shape{2, 3}));
  EXPECT_EQ(source.read_doubles("VTKHDF/PointData/velocity")[3], 7.0);
  EXPECT_EQ(source.read_doubles("VTKHDF/PointData/angular_velocity")[2], -3.0);
  EXPECT_EQ(source.read_integers("VTKHDF/PointData/species"), (Integers{0, 1}));
  EXPECT_EQ(source.read_double_attribute("VTKHDF", "time_seconds"), 1.25);
}

TEST_F(VtkHdfTest, LiquidIsAnImageWithNothingOutsideTheColumn) {
  Scene scene = synthetic::scene(0.06);
  scene.geometry.height = 0.05;
  const fluid::ColumnGrid grid(scene);
  std::vector<double> voidage(grid.size()), pressure(grid.size());
  std::array<std::vector<double>, 3> velocity{voidage, voidage, voidage};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    voidage[i] = static_cast<double>(i);  // the index itself: shows which cell went where
    velocity[2][i] = -static_cast<double>(i);
  }
  write_liquid_vtkhdf(file_, grid, voidage, velocity, pressure, 2.5);

  expect_fixed_ascii_type(file_, "ImageData");
  const Hdf5File source = Hdf5File::open(file_);
  const auto nx = static_cast<std::size_t>(grid.squares(0)), ny = static_cast<std::size_t>(grid.squares(1)),
             nz = static_cast<std::size_t>(grid.layers());
  EXPECT_EQ(source.read_integers_attribute("VTKHDF", "WholeExtent"),
            (std::vector<std::int64_t>{0, grid.squares(0) - 1, 0, grid.squares(1) - 1, 0, grid.layers() - 1}));
  EXPECT_EQ(source.read_doubles_attribute("VTKHDF", "Direction"), (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  const auto origin = source.read_doubles_attribute("VTKHDF", "Origin");
  const auto spacing = source.read_doubles_attribute("VTKHDF", "Spacing");
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Half a square inside the wall on both sides.
    EXPECT_NEAR(origin[axis] - 0.5 * spacing[axis], -0.025, 1e-12);
    EXPECT_NEAR(origin[axis] + spacing[axis] * (grid.squares(axis) - 0.5), 0.025, 1e-12);
  }
  EXPECT_NEAR(spacing[2] * grid.layers(), scene.geometry.height, 1e-12);
  EXPECT_NEAR(origin[2], 0.5 * spacing[2], 1e-12);

  EXPECT_EQ(source.shape("VTKHDF/PointData/voidage"), (Shape{nz, ny, nx}));
  EXPECT_EQ(source.shape("VTKHDF/PointData/velocity"), (Shape{nz, ny, nx, 3}));
  EXPECT_EQ(source.shape("VTKHDF/PointData/pressure"), (Shape{nz, ny, nx}));
  const auto image = source.read_doubles("VTKHDF/PointData/voidage");
  const auto vectors = source.read_doubles("VTKHDF/PointData/velocity");
  std::size_t outside = 0;
  for (std::size_t iz = 0; iz < nz; ++iz) {
    for (std::size_t iy = 0; iy < ny; ++iy) {
      for (std::size_t ix = 0; ix < nx; ++ix) {
        const std::size_t place = (iz * ny + iy) * nx + ix;
        const double x = origin[0] + static_cast<double>(ix) * spacing[0];
        const double y = origin[1] + static_cast<double>(iy) * spacing[1];
        if (std::hypot(x, y) > 0.025) {
          EXPECT_TRUE(std::isnan(image[place]));
          EXPECT_TRUE(std::isnan(vectors[3 * place + 2]));
          ++outside;
          continue;
        }
        const auto index = static_cast<double>(
            grid.cell_of_square(static_cast<int>(ix), static_cast<int>(iy)) * grid.layers() + static_cast<int>(iz));
        EXPECT_EQ(image[place], index);
        EXPECT_EQ(vectors[3 * place + 2], -index);
        EXPECT_EQ(vectors[3 * place], 0.0);
      }
    }
  }
  EXPECT_GT(outside, 0U);
}

TEST_F(VtkHdfTest, AOneDimensionalLiquidFillsTheWidthOfTheColumn) {
  Scene scene = synthetic::scene(0.06);
  scene.fluid.tier = FluidTier::one_dimensional;
  const fluid::ColumnGrid grid(scene);
  ASSERT_EQ(grid.squares(0), 1);
  const auto layers = static_cast<std::size_t>(grid.layers());
  const std::vector<double> field(grid.size(), 0.5);
  write_liquid_vtkhdf(file_, grid, field, {field, field, field}, field, 0.0);
  const Hdf5File source = Hdf5File::open(file_);
  EXPECT_EQ(source.read_integers_attribute("VTKHDF", "WholeExtent"),
            (std::vector<std::int64_t>{0, 1, 0, 1, 0, grid.layers() - 1}));
  EXPECT_EQ(source.shape("VTKHDF/PointData/voidage"), (Shape{layers, 2, 2}));
  EXPECT_EQ(source.shape("VTKHDF/PointData/velocity"), (Shape{layers, 2, 2, 3}));
  EXPECT_EQ(source.read_doubles("VTKHDF/PointData/voidage"), std::vector<double>(4 * layers, 0.5));
  const double lower = source.read_doubles_attribute("VTKHDF", "Origin")[0];
  EXPECT_NEAR(lower, grid.lower(0), 1e-12);
  EXPECT_NEAR(lower + source.read_doubles_attribute("VTKHDF", "Spacing")[0], -grid.lower(0), 1e-12);
}

}  // namespace
}  // namespace slfb::io
