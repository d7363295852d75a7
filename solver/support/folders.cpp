#include "solver/support/folders.hpp"

namespace slfb {

std::filesystem::path source_folder() { return SLFB_SOURCE_DIR; }

std::filesystem::path build_folder() { return SLFB_BUILD_DIR; }

}  // namespace slfb
