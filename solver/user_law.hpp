#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "correlations/drag/drag_law_kernels.hpp"

/// Laws from outside the suite: a C++ file is compiled with the suite's compiler, loaded, and called once per block of
/// spheres like a law of the suite.
namespace slfb {

/// A file that cannot be used as a law; what() holds the compiler's message and a hint.
struct UserLawError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether the name of a law is that of a file ("mine.cpp", relative to the working directory).
bool is_user_law(std::string_view name);

/// Sixteen hexadecimal digits of the text of the file and of what it includes from its own folder, so that runs with
/// different versions of a law do not share a name. \throws UserLawError if it cannot be read
std::string user_law_hash(const std::filesystem::path& file);

/// Compiles the file (once per content; $CXX replaces the suite's compiler), loads it, and returns the address of
/// `symbol`, which `macro` of the template of that `kind` defines. \throws UserLawError
const void* load_user_law(const std::filesystem::path& file, const std::string& symbol, const std::string& macro,
                          const std::string& kind);

/// The drag law of that name, or of that file.
/// \throws UserLawError, and std::invalid_argument listing the known names
drag::DragLawKernels find_drag_law(const std::string& name_or_file);

}  // namespace slfb
