#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "correlations/drag/drag_law_kernels.hpp"
#include "solver/dem/contact_law.hpp"

/// Laws from outside the suite: a C++ file is compiled with the suite's compiler, loaded, and called once per block of
/// spheres or contacts like a law of the suite.
namespace slfb {

/// A file that cannot be used as a law; what() holds the compiler's message and a hint.
struct UserLawError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether the name of a law, parameters aside, is that of a file ("mine.cpp", relative to the working directory; in a
/// scene file to that of the scene).
bool is_user_law(std::string_view name);

/// The text of the file with what it includes from its own folder in the place of those lines: all that a copy needs.
/// \throws UserLawError if it cannot be read
std::string user_law_text(const std::filesystem::path& file);

/// While one lives, this thread compiles, loads and calls no law from a file: for scenes that came with a result, and
/// for looking at a scene without running it. find_drag_law and find_contact_law then throw UserLawError for a file.
class NoForeignCode {
 public:
  NoForeignCode();
  ~NoForeignCode();
  NoForeignCode(const NoForeignCode&) = delete;
  NoForeignCode& operator=(const NoForeignCode&) = delete;
  [[nodiscard]] static bool holds();
};

/// Sixteen hexadecimal digits of that text, so that runs with
/// different versions of a law do not share a name. \throws UserLawError if it cannot be read
std::string user_law_hash(const std::filesystem::path& file);

/// Whether a law is none that the suite lists: a file, or a law with parameters.
bool is_varied_law(std::string_view name);

/// The file of a law "mine.cpp:KEY=VALUE", "mine.cpp".
std::string user_law_file(std::string_view law);

/// The law of that name, or of that file, which is compiled once per content ($CXX replaces the suite's compiler). A
/// drag law takes parameters, "ergun-1952:viscous=180,inertial=1.8" or "mine.cpp:KEY=VALUE"; its info.name has them
/// too. Throws UserLawError for a file that is no law, and std::invalid_argument with the known names for another name,
/// or with the parameters of the law for one that it does not have or a value outside of its range.
drag::DragLawKernels find_drag_law(const std::string& name_or_file);
dem::ContactLawKernels find_contact_law(const std::string& name_or_file);

}  // namespace slfb
