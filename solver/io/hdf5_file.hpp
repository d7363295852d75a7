#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace slfb::io {

/// How real numbers are stored; reading always gives doubles.
enum class Storage { float64, float32 };

/// Extents of a data set, slowest index first; empty: one dimension, as long as the values.
using Shape = std::vector<std::size_t>;

/// What tells that a file is as it was written: nothing, or a checksum (XXH3, 64 bit) over all its bytes. It stands in
/// front of the HDF5 part, in a block of 512 bytes, which other readers of HDF5 skip.
enum class Checksum { none, whole_file };

/// An open HDF5 file.
///
/// Objects are named by their path, "bed/time"; the groups above a data set are made when it is written. Every function
/// but the destructor throws std::runtime_error on failure; it names the file, the object, what was tried and the
/// reason that HDF5 gives. Several threads may use files at the same time, but each file only one of them.
///
/// A file is made and read in memory, so that HDF5 meets neither a full disk nor a file that changes while it is read.
/// What is read may come from anywhere: only regular files, hard links within the file, and data sets of plain numbers
/// that can be as large as they say are taken.
class Hdf5File {
 public:
  /// An empty file, which close() writes; one that exists is replaced.
  static Hdf5File create(const std::filesystem::path& file, Checksum checksum = Checksum::none);
  /// An existing file, for reading only. A checksum is compared where the file has one; with Checksum::whole_file it
  /// must have one. HDF5 is not asked before the checksum is right.
  static Hdf5File open(const std::filesystem::path& file, Checksum required = Checksum::none);

  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&& other) noexcept;
  /// A file under construction that was not closed is thrown away.
  ~Hdf5File();

  /// Writes a file under construction, as a whole or not at all, and closes it.
  void close();

  /// A new data set; it is an error if the path exists or if the values do not fill the shape. `unit`, in UDUNITS
  /// spelling ("m s-1", "1" for a ratio), becomes the attribute `unit` of the data set, unless it is empty. Data sets
  /// of 512 values or more are compressed.
  void write(const std::string& path, const std::vector<double>& values, const std::string& unit = "",
             Storage storage = Storage::float64, const Shape& shape = {});
  void write(const std::string& path, const std::vector<std::int64_t>& values, const Shape& shape = {});
  void write(const std::string& path, const std::vector<std::uint32_t>& values, const Shape& shape = {});
  void write(const std::string& path, const std::vector<std::uint8_t>& values, const Shape& shape = {});

  /// A new attribute of a data set or group; a group that does not exist yet is made. "/" is the root.
  void write_attribute(const std::string& object, const std::string& name, double value);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void write_attribute(const std::string& object, const std::string& name, const std::vector<double>& values);
  void write_attribute(const std::string& object, const std::string& name, const std::vector<std::int64_t>& values);
  /// Stored with fixed length (VTK reads no other).
  void write_attribute(const std::string& object, const std::string& name, const std::string& value);

  /// All values of a data set, converted to the type asked for, slowest index first.
  [[nodiscard]] std::vector<double> read_doubles(const std::string& path) const;
  [[nodiscard]] std::vector<std::int64_t> read_integers(const std::string& path) const;
  [[nodiscard]] std::vector<std::uint32_t> read_unsigned(const std::string& path) const;
  /// Extents of a data set.
  [[nodiscard]] Shape shape(const std::string& path) const;

  /// The value, or all values, of an attribute.
  [[nodiscard]] double read_double_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::int64_t read_integer_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::vector<std::int64_t> read_integers_attribute(const std::string& object,
                                                                  const std::string& name) const;
  [[nodiscard]] std::vector<double> read_doubles_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::string read_string_attribute(const std::string& object, const std::string& name) const;

  [[nodiscard]] bool exists(const std::string& path) const;
  /// Whether a name that exists is a group; else it is a data set.
  [[nodiscard]] bool is_group(const std::string& path) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  /// Names of the data sets and groups in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> children(const std::string& group) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  Hdf5File(std::filesystem::path file, std::int64_t handle, Checksum checksum, std::size_t size)
      : file_(std::move(file)), handle_(handle), checksum_(checksum), size_(size) {}

  void write_values(const std::string& path, const void* values, std::size_t count, std::int64_t memory_type,
                    std::int64_t file_type, const Shape& shape, const std::string& unit);
  void write_attribute_values(const std::string& object, const std::string& name, const void* values,
                              std::int64_t memory_type, std::int64_t file_type, std::int64_t space);
  template <class Value>
  [[nodiscard]] std::vector<Value> read_values(const std::string& path, std::int64_t memory_type) const;
  template <class Value>
  [[nodiscard]] std::vector<Value> read_attribute_values(const std::string& object, const std::string& name,
                                                         std::int64_t memory_type) const;
  /// Opens a data set that is part of this file and holds numbers that its size allows. The caller closes it.
  [[nodiscard]] std::int64_t open_data_set(const std::string& path) const;
  void check_links(const std::string& path) const;
  void check_numbers(std::int64_t type, bool integers, const std::string& object) const;
  [[noreturn]] void fail(const std::string& tried, const std::string& object) const;
  [[noreturn]] void reject(const std::string& object, const std::string& why) const;

  std::filesystem::path file_;
  std::int64_t handle_ = -1;  ///< HDF5's hid_t; negative: closed
  Checksum checksum_ = Checksum::none;
  std::size_t size_ = 0;  ///< of a file that is read [bytes]; 0: under construction
};

/// Writes a file that a reader, even after a crash, finds whole or not at all: what `fill` puts in becomes a temporary
/// file in the same folder, which is then renamed to `file`. Missing folders are made. If `fill` or writing throws, the
/// temporary file is removed, an earlier `file` stays, and the exception goes on.
void write_atomically(const std::filesystem::path& file, const std::function<void(Hdf5File&)>& fill,
                      Checksum checksum = Checksum::none);

/// Whether a regular file begins as one with a checksum does.
bool starts_with_checksum(const std::filesystem::path& file);

/// Does `read` in a process of its own first, and in this one only if that process has come to its end: the HDF5
/// library crashes on some damaged files. For files without a checksum. Throws std::runtime_error that names `file` if
/// the process is killed or does not end within a minute; an exception of `read` goes on.
void read_with_care(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace slfb::io
