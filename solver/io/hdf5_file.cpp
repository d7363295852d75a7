#include "solver/io/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "solver/support/child_process.hpp"
#include "solver/support/files.hpp"

namespace slfb::io {
namespace {

static_assert(sizeof(hid_t) <= sizeof(std::int64_t));

/// Values from which a data set is cut into chunks and compressed; smaller ones cost more that way.
constexpr std::size_t compression_threshold = 512;
constexpr hsize_t largest_chunk = 1U << 17U;

/// Held during each call of HDF5, which need not be built for threads; errors are collected instead of printed. A
/// thread may hold several. Not a std::recursive_mutex: that one knows its thread by a number which is another one in a
/// copy of the process (read_with_care), where it would wait for itself.
class LibraryLock {
 public:
  LibraryLock() {
    if (depth()++ == 0) mutex().lock();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  LibraryLock(const LibraryLock&) = delete;
  LibraryLock& operator=(const LibraryLock&) = delete;
  ~LibraryLock() {
    if (--depth() == 0) mutex().unlock();
  }

  /// For a process that was copied while the lock was held. Its only thread is another one to the system, and would
  /// wait for the lock for ever; it starts with a new one.
  static void renew() { new (&mutex()) std::recursive_mutex; }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  static int& depth() {
    thread_local int held = 0;
    return held;
  }
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

/// Number of values of a shape. Throws std::runtime_error if no memory could hold them.
std::size_t product(const Shape& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape)
    if (__builtin_mul_overflow(count, extent, &count)) throw std::runtime_error("its shape has too many values");
  return count;
}

/// What stands in front of the HDF5 part of a file with a checksum. HDF5 looks for its own part at 0, 512, 1024, ….
constexpr std::size_t block_size = 512;
constexpr std::string_view block_start = "slfb file, XXH3-64 of the bytes from 512 on: ";
constexpr std::string_view hdf5_start("\x89HDF\r\n\x1a\n", 8);

std::string checksum_block(std::string_view content) {
  std::string block =
      fmt::format("{}{:016x}\n", block_start, static_cast<std::uint64_t>(XXH3_64bits(content.data(), content.size())));
  block.resize(block_size, '\0');
  return block;
}

/// Properties of a file that HDF5 keeps in memory; `image` is what it holds at first. The caller closes them.
hid_t file_in_memory(std::string_view image, const std::filesystem::path& file) {
  constexpr std::size_t growth = 1U << 20U;
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  bool made = H5Pset_fapl_core(access, growth, false) >= 0;
  if (!image.empty()) {
    // HDF5 copies the image, though its interface does not promise to leave it as it is.
    made = made && H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()) >= 0;
  }
  if (!made) fail_on(file, "prepare memory for the HDF5 file", "");
  return access;
}

/// HDF5 takes files of one name for the same file.
std::string name_in_memory(const std::filesystem::path& file) {
  static std::atomic<unsigned> counter{0};
  return fmt::format("{}#{}", file.string(), counter++);
}

}  // namespace

Hdf5File Hdf5File::create(const std::filesystem::path& file, Checksum checksum) {
  const LibraryLock lock;
  const Handle access(file_in_memory({}, file), H5Pclose);
  const hid_t handle = H5Fcreate(name_in_memory(file).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get());
  if (handle < 0) fail_on(file, "create the HDF5 file", "");
  return {file, handle, checksum, 0};
}

Hdf5File Hdf5File::open(const std::filesystem::path& file, Checksum required) {
  const auto status = std::filesystem::status(file);
  const auto unfit = [&](const std::string& why) {
    return std::runtime_error(fmt::format("{}: cannot open the HDF5 file ({})", file.string(), why));
  };
  if (!std::filesystem::exists(status)) throw unfit("it does not exist");
  if (!std::filesystem::is_regular_file(status)) throw unfit("it is no regular file");
  const std::string bytes = read_file(file);
  std::string_view content = bytes;
  const bool checked = content.starts_with(block_start);
  if (checked) {
    content.remove_prefix(std::min(block_size, content.size()));
    if (checksum_block(content) != std::string_view(bytes).substr(0, block_size))
      throw unfit("it is damaged: its checksum does not fit its content");
  } else if (required == Checksum::whole_file) {
    throw unfit(content.starts_with(hdf5_start) ? "it has no checksum: an earlier version of slfb wrote it"
                                                : "it is damaged: the checksum at its start is missing");
  }
  if (!content.starts_with(hdf5_start)) throw unfit("it is damaged or of another kind: file signature not found");
  const LibraryLock lock;
  const Handle access(file_in_memory(content, file), H5Pclose);
  const hid_t handle = H5Fopen(name_in_memory(file).c_str(), H5F_ACC_RDONLY, access.get());
  if (handle < 0) fail_on(file, "open the HDF5 file", "");
  return {file, handle, checked ? Checksum::whole_file : Checksum::none, content.size()};
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : file_(std::move(other.file_)),
      handle_(std::exchange(other.handle_, -1)),
      checksum_(other.checksum_),
      size_(other.size_) {}

Hdf5File& Hdf5File::operator=(Hdf5File&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(handle_, other.handle_);
  std::swap(checksum_, other.checksum_);
  std::swap(size_, other.size_);
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
  std::string image;
  if (size_ == 0) {
    if (H5Fflush(handle_, H5F_SCOPE_LOCAL) < 0) fail("complete the file", "");
    const ssize_t size = H5Fget_file_image(handle_, nullptr, 0);
    if (size <= 0) fail("complete the file", "");
    image.resize(static_cast<std::size_t>(size));
    if (H5Fget_file_image(handle_, image.data(), image.size()) != size) fail("complete the file", "");
  }
  if (H5Fclose(std::exchange(handle_, -1)) < 0) fail("close the file", "");
  if (size_ == 0)
    write_file(file_, {checksum_ == Checksum::none ? std::string() : checksum_block(image), image}, Durability::disk);
}

void Hdf5File::fail(const std::string& tried, const std::string& object) const { fail_on(file_, tried, object); }

void Hdf5File::reject(const std::string& object, const std::string& why) const {
  throw std::runtime_error(fmt::format("{}: \"{}\" {}", file_.string(), object, why));
}

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
  H5Pset_obj_track_times(layout.get(), false);  // the same numbers are the same bytes, whenever they are written
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

/// Links that lead out of the file, or nowhere, are refused.
void Hdf5File::check_links(const std::string& path) const {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string part = path.substr(0, end);
    H5L_info_t info;
    if (part == "/" || part.empty()) continue;
    if (H5Lget_info(handle_, part.c_str(), &info, H5P_DEFAULT) < 0) fail("open the data set", path);
    if (info.type != H5L_TYPE_HARD) reject(part, "is a link to something else, which this suite never writes");
  }
}

void Hdf5File::check_numbers(std::int64_t type, bool integers, const std::string& object) const {
  const std::array whole{H5T_STD_I64LE, H5T_STD_U32LE, H5T_STD_U8LE};
  const std::array real{H5T_IEEE_F64LE, H5T_IEEE_F32LE};
  const auto is = [&](hid_t known) { return H5Tequal(type, known) > 0; };
  if (std::any_of(whole.begin(), whole.end(), is)) return;
  if (integers) reject(object, "holds no whole numbers");
  if (std::none_of(real.begin(), real.end(), is)) reject(object, "holds no numbers");
}

std::int64_t Hdf5File::open_data_set(const std::string& path) const {
  check_links(path);
  const hid_t data = H5Dopen2(handle_, path.c_str(), H5P_DEFAULT);
  if (data < 0) fail("open the data set", path);
  try {
    const Handle layout(H5Dget_create_plist(data), H5Pclose);
    if (!layout.valid()) fail("read the layout of", path);
    const H5D_layout_t kind = H5Pget_layout(layout.get());
    if (kind == H5D_VIRTUAL || H5Pget_external_count(layout.get()) != 0) reject(path, "lies in other files");
    for (int k = 0; k < H5Pget_nfilters(layout.get()); ++k) {
      unsigned flags = 0, settings = 0;
      std::size_t count = 0;
      const H5Z_filter_t filter =
          H5Pget_filter2(layout.get(), static_cast<unsigned>(k), &flags, &count, nullptr, 0, nullptr, &settings);
      if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE)
        reject(path, fmt::format("is packed in a way that this suite does not use (filter {})", filter));
    }
    // Deflate makes nothing smaller than 1/1032 (zlib's manual), so that a file bounds what it can hold.
    constexpr std::size_t largest_ratio = 1032;
    const Handle space(H5Dget_space(data), H5Sclose);
    const Handle type(H5Dget_type(data), H5Tclose);
    if (!space.valid() || !type.valid()) fail("read the shape of", path);
    const hssize_t count = H5Sget_simple_extent_npoints(space.get());
    const std::size_t bytes_each = H5Tget_size(type.get());
    if (count < 0 || bytes_each == 0) fail("read the shape of", path);
    if (static_cast<std::size_t>(count) > largest_ratio * size_ / bytes_each)
      reject(path, fmt::format("claims to hold {} values, more than the file of {} bytes can", count, size_));
  } catch (...) {
    H5Dclose(data);
    throw;
  }
  return data;
}

Shape Hdf5File::shape(const std::string& path) const {
  const LibraryLock lock;
  const Handle data(open_data_set(path), H5Dclose);
  const Handle space(H5Dget_space(data.get()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 0) fail("read the shape of", path);
  std::vector<hsize_t> dimensions(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.get(), dimensions.data(), nullptr);
  return {dimensions.begin(), dimensions.end()};
}

template <class Value>
std::vector<Value> Hdf5File::read_values(const std::string& path, std::int64_t memory_type) const {
  const Handle data(open_data_set(path), H5Dclose);
  const Handle space(H5Dget_space(data.get()), H5Sclose), type(H5Dget_type(data.get()), H5Tclose);
  check_numbers(type.get(), std::is_integral_v<Value>, path);
  std::vector<Value> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
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
  const Handle space(H5Aget_space(attribute.get()), H5Sclose), type(H5Aget_type(attribute.get()), H5Tclose);
  check_numbers(type.get(), std::is_integral_v<Value>, item);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0) fail("read the shape of the attribute", item);
  if (static_cast<std::size_t>(count) > size_)  // HDF5 stores attributes as they are
    reject(item, fmt::format("claims to hold {} values, more than the file of {} bytes can", count, size_));
  std::vector<Value> values(static_cast<std::size_t>(count));
  if (H5Aread(attribute.get(), memory_type, values.data()) < 0) fail("read the attribute", item);
  return values;
}

double Hdf5File::read_double_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  const auto values = read_attribute_values<double>(object, name, H5T_NATIVE_DOUBLE);
  if (values.size() != 1) reject(fmt::format("{}@{}", object, name), "is not one number");
  return values.front();
}

std::int64_t Hdf5File::read_integer_attribute(const std::string& object, const std::string& name) const {
  const LibraryLock lock;
  const auto values = read_attribute_values<std::int64_t>(object, name, H5T_NATIVE_INT64);
  if (values.size() != 1) reject(fmt::format("{}@{}", object, name), "is not one number");
  return values.front();
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
  const Handle type(H5Aget_type(attribute.get()), H5Tclose), space(H5Aget_space(attribute.get()), H5Sclose);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 ||
      H5Sget_simple_extent_npoints(space.get()) != 1 || H5Tget_size(type.get()) > size_) {
    fail("read as one text of fixed length the attribute", item);
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

void write_atomically(const std::filesystem::path& file, const std::function<void(Hdf5File&)>& fill,
                      Checksum checksum) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  Hdf5File target = Hdf5File::create(file, checksum);
  fill(target);
  target.close();
}

bool starts_with_checksum(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) return false;
  std::string start(block_start.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == block_start;
}

void read_with_care(const std::filesystem::path& file, const std::function<void()>& read) {
  constexpr unsigned patience = 60;  // [s]
  // Files that a child has read as they are now: figures read the same ones many times.
  using Version = std::tuple<std::filesystem::path, std::filesystem::file_time_type, std::uintmax_t>;
  static std::set<Version> known_as_good;
  std::error_code missing;
  const Version version{std::filesystem::absolute(file), std::filesystem::last_write_time(file, missing),
                        std::filesystem::file_size(file, missing)};
  {
    const LibraryLock lock;  // no other thread is within the library when the process is copied
    if (!missing && known_as_good.contains(version)) return read();
    const auto read_in_child = [&] {
      LibraryLock::renew();
      read();
    };
    if (const auto trouble = trouble_in_child(read_in_child, patience))
      throw std::runtime_error(fmt::format("{}: damaged: reading it {}", file.string(), *trouble));
    known_as_good.insert(version);
  }
  read();
}

}  // namespace slfb::io
