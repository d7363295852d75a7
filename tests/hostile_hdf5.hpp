#pragma once

#include <fmt/format.h>
#include <hdf5.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

/// HDF5 files that somebody has changed with other tools, and given a checksum that fits again.
namespace slfb::hostile {

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void set_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// As solver/io/README.md says: a line and zeros up to byte 512, then the HDF5 part.
inline std::string sealed(const std::string& content) {
  std::string block = fmt::format("slfb file, XXH3-64 of the bytes from 512 on: {:016x}\n",
                                  static_cast<std::uint64_t>(XXH3_64bits(content.data(), content.size())));
  block.resize(512, '\0');
  return block + content;
}

/// Changes the HDF5 part of a file with a checksum and seals it again.
inline void change(const std::filesystem::path& file, const std::function<void(hid_t)>& edit) {
  set_bytes(file, bytes_of(file).substr(512));
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  if (handle < 0) throw std::runtime_error("the test cannot open " + file.string());
  edit(handle);
  H5Fclose(handle);
  set_bytes(file, sealed(bytes_of(file)));
}

/// Puts another data set of doubles in the place of one.
inline void replace(hid_t file, const std::string& path, const std::vector<double>& values) {
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const hsize_t length = values.size();
  const hid_t space = H5Screate_simple(1, &length, nullptr);
  const hid_t data = H5Dcreate2(file, path.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (length > 0) H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(data);
  H5Sclose(space);
}

/// Another whole number in an attribute. (HDF5 1.10.8 cannot write to one that it opened by the name of its object.)
inline void set_attribute(hid_t file, const char* object, const char* name, std::int64_t value) {
  const hid_t opened = H5Oopen(file, object, H5P_DEFAULT);
  if (H5Adelete(opened, name) < 0) throw std::runtime_error(std::string("the test finds no attribute ") + name);
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(opened, name, H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_INT64, &value);
  H5Aclose(attribute);
  H5Sclose(space);
  H5Oclose(opened);
}

/// All values of a data set set to one.
inline void fill(hid_t file, const std::string& path, double value) {
  const hid_t data = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  const std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), value);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(data);
}

}  // namespace slfb::hostile
