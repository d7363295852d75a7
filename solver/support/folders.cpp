#include "solver/support/folders.hpp"

#include <cstdlib>
#include <system_error>

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// Where the data of an installed program lie: ../share/slfb beside the folder of the program. Empty for one that was
/// built and not installed.
fs::path installed_data() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path data = program.parent_path().parent_path() / "share" / "slfb";
  return !unknown && fs::exists(data / "reports" / "style.gp") ? data : fs::path();
}

}  // namespace

fs::path source_folder() {
  static const fs::path data = installed_data();
  return data.empty() ? fs::path(SLFB_SOURCE_DIR) : data;
}

fs::path build_folder() {
  static const bool installed = !installed_data().empty();
  return installed ? fs::current_path() : fs::path(SLFB_BUILD_DIR);
}

fs::path cache_folder() {
  static const bool installed = !installed_data().empty();
  if (!installed) return SLFB_BUILD_DIR;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
    return fs::path(cache) / "slfb";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".cache" / "slfb";
  return fs::temp_directory_path() / "slfb";
}

}  // namespace slfb
