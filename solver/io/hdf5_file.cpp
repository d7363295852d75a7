#include "solver/io/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace slfb::io {
namespace {

static_assert(sizeof(hid_t) <= sizeof(std::int64_t));

/// Values from which a data set is cut into chunks and compressed; smaller ones cost more that way.
constexpr std::size_t compression_threshold = 512;
constexpr hsize_t largest_chunk = 1U << 17U;

/// Held during each call of HDF5, which need not be built for threads; errors are collected instead of printed.
class LibraryLock {
 public:
  LibraryLock() : lock_(mutex()) { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

 private:
  static std::recursive_mutex& mutex() {
    static std::recursive_mutex instance;
    return instance;
  }
  std::lock_guard<std::recursive_mutex> lock_;
};

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), closer_(closer) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }
  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*closer_)(hid_t);
};

/// The innermost message of HDF5's error stack: the cause, "file signature not found". Empties the stack: what a thread
/// leaves in it keeps HDF5 from closing at the end of the program.
std::string reason() {
  std::string text;
  const auto take_first = [](unsigned depth, const H5E_error2_t* error, void* target) -> herr_t {
    if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(target) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &text);
  H5Eclear2(H5E_DEFAULT);
  return text.substr(0, text.find(": time = "));  // further come buffers and offsets
}

[[noreturn]] void fail_on(const std::filesystem::path& file, const std::string& tried, const std::string& object) {
  const std::string why = reason();
  throw std::runtime_error(fmt::format("{}: cannot {}{}{}", file.string(), tried,
                                       object.empty() ? "" : fmt::format(" \"{}\"", object),
                                       why.empty() ? "" : fmt::format(" ({})", why)));
}

std::size_t product(const Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

}  // namespace

Hdf5File Hdf5File::create(const std::filesystem::path& file) {
  const LibraryLock lock;
  const hid_t handle = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (handle < 0) fail_on(file, "create the HDF5 file", "");
  return {file, handle};
}

Hdf5File Hdf5File::open(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    throw std::runtime_error(fmt::format("{}: cannot open the HDF5 file (it does not exist)", file.string()));
  }
  const LibraryLock lock;
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (handle < 0) fail_on(file, "open the HDF5 file", "");
  return {file, handle};
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : file_(std::move(other.file_)), handle_(std::exchange(other.handle_, -1)) {}

Hdf5File& Hdf5File::operator=(Hdf5File&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(handle_, other.handle_);
  return *this;
}

Hdf5File::~Hdf5File() {
  if (handle_ < 0) return;
  const LibraryLock lock;
  H5Fclose(handle_);
}

void Hdf5File::close() {
  if (handle_ < 0) return;
  const LibraryLock lock;
  if (H5Fclose(std::exchange(handle_, -1)) < 0) fail("write and close the file", "");
}

void Hdf5File::fail(const std::string& tried, const std::string& object) const { fail_on(file_, tried, object); }

void Hdf5File::write_values(const std::string& path, const void* values, std::size_t count, std::int64_t memory_type,
                            std::int64_t file_type, const Shape& shape, const std::string& unit) {
  const Shape extents = shape.empty() ? Shape{count} : shape;
  if (product(extents) != count) {
    throw std::runtime_error(
        fmt::format("{}: cannot write \"{}\" ({} values do not fill its shape)", file_.string(), path, count));
  }
  const LibraryLock lock;
  const std::vector<hsize_t> dimensions(extents.begin(), extents.end());
  const Handle space(H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr), H5Sclose);
  const Handle link(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (!space.valid() || !link.valid() || !layout.valid()) fail("describe", path);
  H5Pset_create_intermediate_group(link.get(), 1);
  if (count >= compression_threshold) {
    // Whole rows of the slowest index, as many as fit the largest chunk.
    std::vector<hsize_t> chunk = dimensions;
    const hsize_t row = count / dimensions.front();
    chunk.front() = std::clamp<hsize_t>(largest_chunk / row, 1, dimensions.front());
    H5Pset_chunk(layout.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(layout.get());
    H5Pset_deflate(layout.get(), 6);
  }
  const Handle data(H5Dcreate2(handle_, path.c_str(), file_type, space.get(), link.get(), layout.get(), H5P_DEFAULT),
                    H5Dclose);
  if (!data.valid()) fail("create the data set", path);
  if (count > 0 && H5Dwrite(data.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) {
    fail("write the data set", path);
  }
  if (!unit.empty()) write_attribute(path, "unit", unit);
}

void Hdf5File::write(const std::string& path, const std::vector<double>& values, const std::string& unit,
                     Storage storage, const Shape& shape) {
  const LibraryLock lock;
  const hid_t type = storage == Storage::float32 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
  write_values(path, values.data(), values.size(), H5T_NATIVE_DOUBLE, type, shape, unit);
}

void Hdf5File::write(const std::string& path, const std::vector<std::int64_t>& values, const Shape& shape) {
  const LibraryLock lock;
  write_values(path, values.data(), values.size(), H5T_NATIVE_INT64, H5T_STD_I64LE, shape, "");
}

void Hdf5File::write(const std::string& path, const std::vector<std::uint32_t>& values, const Shape& shape) {
  const LibraryLock lock;
  write_values(path, values.data(), values.size(), H5T_NATIVE_UINT32, H5T_STD_U32LE, shape, "");
}

void Hdf5File::write(const std::string& path, const std::vector<std::uint8_t>& values, const Shape& shape) {
  const LibraryLock lock;
  write_values(path, values.data(), values.size(), H5T_NATIVE_UINT8, H5T_STD_U8LE, shape, "");
}

void Hdf5File::write_attribute_values(const std::string& object, const std::string& name, const void* values,
                                      std::int64_t memory_type, std::int64_t file_type, std::int64_t space) {
  const std::string item = fmt::format("{}@{}", object, name);
  if (!exists(object)) {
    const Handle link(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(link.get(), 1);
    const Handle group(H5Gcreate2(handle_, object.c_str(), link.get(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    if (!group.valid()) fail("create the group", object);
  }
  const Handle attribute(
      H5Acreate_by_name(handle_, object.c_str(), name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (!attribute.valid()) fail("create the attribute", item);
  if (H5Awrite(attribute.get(), memory_type, values) < 0) fail("write the attribute", item);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, double value) {
  const LibraryLock lock;
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write_attribute_values(object, name, &value, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, space.get());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  const LibraryLock lock;
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write_attribute_values(object, name, &value, H5T_NATIVE_INT64, H5T_STD_I64LE, space.get());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, const std::vector<double>& values) {
  const LibraryLock lock;
  const hsize_t length = values.size();
  const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
  write_attribute_values(object, name, values.data(), H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, space.get());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               const std::vector<std::int64_t>& values) {
  const LibraryLock lock;
  const hsize_t length = values.size();
  const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
  write_attribute_values(object, name, values.data(), H5T_NATIVE_INT64, H5T_STD_I64LE, space.get());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, const std::string& value) {
  const LibraryLock lock;
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(value.size(), 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  const bool ascii =
      std::all_of(value.begin(), value.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
  H5Tset_cset(type.get(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  write_attribute_values(object, name, value.c_str(), type.get(), type.get(), space.get());
}

Shape Hdf5File::shape(const std::string& path) const {
  const LibraryLock lock;
  const Handle data(H5Dopen2(handle_, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) fail("open the data set", path);
  const Handle space(H5Dget_space(data.get()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 0) fail("read the shape of", path);
  std::vector<hsize_t> dimensions(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.get(), dimensions.data(), nullptr);
  return {dimensions.begin(), dimensions.end()};
}

template <class Value>
std::vector<Value> Hdf5File::read_values(const std::string& path, std::int64_t memory_type) const {
  std::vector<Value> values(product(shape(path)));
  const Handle data(H5Dopen2(handle_, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) fail("open the data set", path);
  if (!values.empty() && H5Dread(data.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail("read the data set", path);
  }
  return values;
}

std::vector<double> Hdf5File::read_doubles(const std::string& path) const {
  const LibraryLock lock;
  return read_values<double>(path, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5File::read_integers(const std::string& path) const {
  const LibraryLock lock;
  return read_values<std::int64_t>(path, H5T_NATIVE_INT64);
}

std::vector<std::uint32_t> Hdf5File::read_unsigned(const std::string& path) const {
  const LibraryLock lock;
  return read_values<std::uint32_t>(path, H5T_NATIVE_UINT32);
}

template <class Value>
std::vector<Value> Hdf5File::read_attribute_values(const std::string& object, const std::string& name,
                                                   std::int64_t memory_type) const {
  const std::string item = fmt::format("{}@{}", object, name);
  const Handle attribute(H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) fail("open the attribute", item);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0) fail("read the shape of the attribute", item);
  std::vector<Value> values(static_cast<std::size_t>(count));
  if (H5Aread(attribute.get(), memory_type, values.data()) < 0) fail("read the attribute", item);
  return values;
}

double Hdf5File::read_double_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  return read_attribute_values<double>(object, name, H5T_NATIVE_DOUBLE).at(0);
}

std::int64_t Hdf5File::read_integer_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  return read_attribute_values<std::int64_t>(object, name, H5T_NATIVE_INT64).at(0);
}

std::vector<double> Hdf5File::read_doubles_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  return read_attribute_values<double>(object, name, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5File::read_integers_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  return read_attribute_values<std::int64_t>(object, name, H5T_NATIVE_INT64);
}

std::string Hdf5File::read_string_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  const std::string item = fmt::format("{}@{}", object, name);
  const Handle attribute(H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) fail("open the attribute", item);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0) {
    fail("read as fixed-length text the attribute", item);
  }
  std::string value(H5Tget_size(type.get()), '\0');
  if (H5Aread(attribute.get(), type.get(), value.data()) < 0) fail("read the attribute", item);
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

bool Hdf5File::exists(const std::string& path) const {
  const LibraryLock lock;
  // H5Lexists wants every group on the way to exist, so the path is walked.
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string part = path.substr(0, end);
    if (part != "/" && H5Lexists(handle_, part.c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return true;
}

bool Hdf5File::is_group(const std::string& path) const {
  const LibraryLock lock;
  const Handle object(H5Oopen(handle_, path.c_str(), H5P_DEFAULT), H5Oclose);
  if (!object.valid()) fail("open", path);
  return H5Iget_type(object.get()) == H5I_GROUP;
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  return exists(object) && H5Aexists_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::children(const std::string& group) const {
  const LibraryLock lock;
  const Handle opened(H5Gopen2(handle_, group.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info;
  if (!opened.valid() || H5Gget_info(opened.get(), &info) < 0) fail("open the group", group);
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const ssize_t length =
        H5Lget_name_by_idx(opened.get(), ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
    if (length < 0) fail("list the group", group);
    std::string name(static_cast<std::size_t>(length) + 1, '\0');
    H5Lget_name_by_idx(opened.get(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
    name.pop_back();
    names.push_back(name);
  }
  return names;
}

void write_atomically(const std::filesystem::path& file, const std::function<void(Hdf5File&)>& fill) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  // The name differs between processes and threads, so that two writers of one file do not share a temporary.
  static std::atomic<unsigned> counter{0};
  std::filesystem::path temporary = file;
  temporary += fmt::format(".{}-{}.part", getpid(), counter++);
  try {
    Hdf5File target = Hdf5File::create(temporary);
    fill(target);
    target.close();
    std::filesystem::rename(temporary, file);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

}  // namespace slfb::io
