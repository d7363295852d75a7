#pragma once

#include <filesystem>

/// Where the suite lies on this machine.
namespace slfb {

/// The source tree: scenes, reference data, published results.
std::filesystem::path source_folder();

/// The build tree: where results, figures and the report go unless a command says otherwise.
std::filesystem::path build_folder();

}  // namespace slfb
