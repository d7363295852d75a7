#include "solver/run/checkpoint_files.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "solver/io/hdf5_file.hpp"

namespace slfb::simulation {
namespace {

/// Of the names in a checkpoint and their meaning; raised when they change.
constexpr std::int64_t state_version = 3;

bool is_records(const std::string& name) { return name.starts_with("records_") && name.find('/') == std::string::npos; }

/// Removes all records but those in the file `kept`.
void remove_records(const std::filesystem::path& directory, const std::filesystem::path& kept) {
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (is_records(entry.path().filename().string()) && entry.path().filename() != kept)
      std::filesystem::remove(entry.path());
}

}  // namespace

void CheckpointFiles::write(const std::filesystem::path& file, const std::string& records,
                            const io::StateGroup::Exchange& state) const {
  const auto fill = [&](io::Hdf5File& target) {
    target.write_attribute("/", "scene_hash", scene_hash_);
    target.write_attribute("/", "state_version", state_version);
    target.write_attribute("/", "records", records);
    io::write_state(target, state);
  };
  io::write_atomically(file, fill, io::Checksum::whole_file);
}

void CheckpointFiles::save(const RunResult& result, std::int64_t number, const io::StateGroup::Exchange& state) const {
  if (!std::filesystem::is_directory(directory_))
    throw std::runtime_error(
        fmt::format("{}: the folder of the run has vanished; nothing can be saved in it", directory_.string()));
  const std::string records = fmt::format("records_{}.h5", number);
  // The records go first, and the old ones last: the checkpoint always finds its own.
  save_result(result, directory_ / records);
  write(checkpoint(), records, state);
  remove_records(directory_, records);
}

bool CheckpointFiles::load(RunResult& result, const io::StateGroup::Exchange& state) const {
  if (!std::filesystem::exists(checkpoint())) return false;
  try {
    const auto source = io::Hdf5File::open(checkpoint(), io::Checksum::whole_file);
    if (source.read_string_attribute("/", "scene_hash") != scene_hash_) return false;
    if (!source.has_attribute("/", "state_version") ||
        source.read_integer_attribute("/", "state_version") != state_version)
      throw std::runtime_error(fmt::format("{}: made by an earlier or later version of slfb", checkpoint().string()));
    const std::string records = source.read_string_attribute("/", "records");
    if (!is_records(records) || !io::starts_with_checksum(directory_ / records))
      throw std::runtime_error(
          fmt::format("{}: its records \"{}\" are missing or damaged", checkpoint().string(), records));
    result = load_result(directory_ / records);
    io::read_state(source, state);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("the run cannot go on from its checkpoint: {}; remove {} to start anew",
                                         error.what(), directory_.string()));
  }
  return true;
}

std::filesystem::path CheckpointFiles::save_failure(const io::StateGroup::Exchange& state) const {
  auto file = directory_ / "failure.h5";
  write(file, "", state);
  return file;
}

void CheckpointFiles::remove(const std::filesystem::path& directory) {
  for (const char* file : {"checkpoint.h5", "failure.h5"}) std::filesystem::remove(directory / file);
  remove_records(directory, {});
}

}  // namespace slfb::simulation
