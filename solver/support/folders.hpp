#pragma once

#include <filesystem>

/// Where the suite lies on this machine.
namespace slfb {

/// What comes with the program: scenes, reference data, published results, headers for laws from files. The source
/// tree, or PREFIX/share/slfb of an installed program (`cmake --install`), which may be moved as a whole.
std::filesystem::path source_folder();

/// Where results, figures and the report go unless a command says otherwise: the build tree, or for an installed
/// program the current folder.
std::filesystem::path build_folder();

/// For what can be made again, such as compiled laws: the build tree, or for an installed program a folder of the user,
/// who need not be able to write where it is installed.
std::filesystem::path cache_folder();

}  // namespace slfb
