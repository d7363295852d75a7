#include "solver/laws/user_law.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "correlations/drag/drag_laws.hpp"
#include "solver/dem/contact_laws.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/run_program.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// What a law of a file answers: the name that its macro exports, the macro, and the word for its template.
struct UserLawKind {
  std::string symbol, macro, word;
};

/// The text of a file followed by that of each file beside it that it includes.
void append_source(const fs::path& file, std::set<fs::path>& seen, std::string& text) {
  if (!seen.insert(fs::weakly_canonical(file)).second) return;
  std::string own;
  try {
    own = read_file(file);
  } catch (const std::runtime_error&) {
    throw UserLawError(
        fmt::format("{}: cannot be read; needed is a C++ file as `slfb compare --template` prints one", file.string()));
  }
  text += own;
  static const std::regex include(R"(#\s*include\s*"([^"]+)\")");
  for (std::sregex_iterator found(own.begin(), own.end(), include), end; found != end; ++found)
    if (const fs::path beside = file.parent_path() / (*found)[1].str(); fs::exists(beside))
      append_source(beside, seen, text);
}

std::string digits(const std::string& text) { return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size())); }

std::vector<std::string> compiler_words() {
  const char* chosen = std::getenv("CXX");
  std::istringstream words(
      fmt::format("{} {}", chosen != nullptr && *chosen != '\0' ? chosen : SLFB_LAW_COMPILER, SLFB_LAW_FLAGS));
  std::vector<std::string> command;
  for (std::string word; words >> word;) command.push_back(word);
  command.push_back("-I" + source_folder().string());
  return command;
}

std::string hint(const std::string& message, const UserLawKind& kind) {
  std::string compiles = fmt::format("`slfb compare --template {}` prints a file that compiles.", kind.word);
  if (message.find("Dual") != std::string::npos)
    return "The formula is also evaluated for numbers that carry their derivative: write `using std::pow;` and then "
           "pow(x, y) without std::, likewise exp, log10 and sqrt; or take SuspensionFlow instead of a template. " +
           compiles;
  if (message.find("info") != std::string::npos)
    return fmt::format("{}(Law) needs a type with a `static constexpr` member `info`. {}", kind.macro, compiles);
  return compiles;
}

/// The shared object of a file: made anew when there is none of this content or when the suite is newer.
fs::path compile(const fs::path& file, const std::string& content, const UserLawKind& kind) {
  std::vector<std::string> command = compiler_words();
  const fs::path folder = cache_folder() / "user-laws";
  fs::path object = folder / (digits(fmt::format("{} {}", content, fmt::join(command, " "))) + ".so");
  if (fs::exists(object) && fs::last_write_time(object) > fs::last_write_time("/proc/self/exe")) return object;
  fs::create_directories(folder);
  // Another process may want the same: each writes its own file, and renaming is one step.
  const fs::path unfinished = object.string() + fmt::format(".{}", getpid());
  for (const std::string& word : {fs::absolute(file).string(), std::string("-o"), unfinished.string()})
    command.push_back(word);
  const auto [message, status] = run_program(command, folder, "set CXX to a C++20 compiler, or apt-get install g++");
  if (status != 0)
    throw UserLawError(fmt::format("{} does not compile:\n{}\nHint: {}", file.string(), message, hint(message, kind)));
  fs::rename(unfinished, object);
  return object;
}

/// Compiles the file (once per content), loads it, and returns the address of the kind's symbol.
const void* load_user_law(const fs::path& file, const UserLawKind& kind) {
  static std::mutex mutex;
  static std::map<std::string, const void*> loaded;
  const std::lock_guard lock(mutex);
  const std::string content = user_law_hash(file);
  const void*& address = loaded[content + kind.symbol];
  if (address != nullptr) return address;
  const fs::path object = compile(file, content, kind);
  void* library = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays loaded: results point into it
  if (library == nullptr) throw UserLawError(fmt::format("{} does not load: {}", file.string(), dlerror()));
  address = dlsym(library, kind.symbol.c_str());
  if (address == nullptr)
    throw UserLawError(fmt::format(
        "{} compiles but hands no law over.\nHint: its last line has to be {}(TheNameOfYourLaw). `slfb compare "
        "--template {}` prints an example.",
        file.string(), kind.macro, kind.word));
  return address;
}

/// The law that a file hands over, under a name that is none of `taken`.
template <class Kernels>
Kernels law_of_file(const std::string& file, const UserLawKind& kind, const std::vector<std::string_view>& taken) {
  const auto law = *static_cast<const Kernels*>(load_user_law(file, kind));
  const std::string_view name = law.info.name;
  const bool plain = !name.empty() && std::ranges::all_of(name, [](unsigned char letter) {
    return std::islower(letter) || std::isdigit(letter) || letter == '-';
  });
  if (!plain)
    throw UserLawError(
        fmt::format("{}: info.name = \"{}\"; allowed are lower-case letters, digits and '-'", file, name));
  if (std::ranges::find(taken, name) != taken.end())
    throw UserLawError(
        fmt::format("{}: info.name = \"{}\" is the name of a law of the suite; needed is one of its own", file, name));
  return law;
}

}  // namespace

bool is_user_law(std::string_view name) { return name.ends_with(".cpp"); }

std::string user_law_hash(const fs::path& file) {
  std::set<fs::path> seen;
  std::string text;
  append_source(file, seen, text);
  return digits(text);
}

drag::DragLawKernels find_drag_law(const std::string& name_or_file) {
  std::vector<std::string_view> names;
  for_each_law<drag::DragLaws>([&](const auto& law) { names.push_back(law.info.name); });
  if (is_user_law(name_or_file))
    return law_of_file<drag::DragLawKernels>(name_or_file, {"slfb_drag_law", "SLFB_DRAG_LAW", "drag"}, names);
  if (std::ranges::find(names, name_or_file) == names.end())
    throw std::invalid_argument(fmt::format("unknown drag law \"{}\"; known: {}, or a file that ends with .cpp",
                                            name_or_file, fmt::join(names, ", ")));
  return drag::with_drag_law(name_or_file, [](auto law) { return drag::kernels_of<decltype(law)>(); });
}

dem::ContactLawKernels find_contact_law(const std::string& name_or_file) {
  std::vector<std::string_view> names;
  for (const dem::ContactLawKernels& law : dem::contact_laws()) {
    if (law.info.name == name_or_file) return law;
    names.push_back(law.info.name);
  }
  if (!is_user_law(name_or_file))
    throw std::invalid_argument(fmt::format("unknown contact law \"{}\"; known: {}, or a file that ends with .cpp",
                                            name_or_file, fmt::join(names, ", ")));
  return law_of_file<dem::ContactLawKernels>(name_or_file, {"slfb_contact_law", "SLFB_CONTACT_LAW", "contact"}, names);
}

}  // namespace slfb
