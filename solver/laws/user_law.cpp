#include "solver/laws/user_law.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <vector>

#include "correlations/drag/drag_laws.hpp"
#include "solver/dem/contact_laws.hpp"
#include "solver/support/child_process.hpp"
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

thread_local int foreign_code_forbidden = 0;

constexpr std::uintmax_t largest_source = 16U << 20U;  // [bytes]

/// X of a line `#include "X"`; empty for another line.
std::string_view included(std::string_view line) {
  const auto skip_blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  const auto take = [&](std::string_view word) {
    skip_blanks();
    if (!line.starts_with(word)) return false;
    line.remove_prefix(word.size());
    return true;
  };
  if (!take("#") || !take("include") || !take("\"")) return {};
  return line.substr(0, line.find('"') == line.npos ? 0 : line.find('"'));
}

/// Adds the text of a file with the files beside it that it includes in the place of those lines, each once.
void append_source(const fs::path& file, std::set<fs::path>& seen, std::string& text) {
  seen.insert(fs::weakly_canonical(file));
  std::string own;
  try {
    if (fs::is_regular_file(file) && fs::file_size(file) > largest_source)
      throw std::runtime_error("larger than 16 MiB");
    own = read_file(file);
  } catch (const std::exception& error) {
    throw UserLawError(
        fmt::format("{}: cannot be read ({}); needed is a C++ file as `slfb compare --template` prints one",
                    file.string(), error.what()));
  }
  for (std::string_view rest = own; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n') == rest.npos ? rest.size() : rest.find('\n') + 1);
    rest.remove_prefix(line.size());
    const std::string name(included(line));
    const fs::path beside = file.parent_path() / name;
    if (name.empty() || !fs::is_regular_file(beside)) {
      text += line;
    } else if (!seen.contains(fs::weakly_canonical(beside))) {
      append_source(beside, seen, text);
    }
  }
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
  remove_unfinished(folder);
  const fs::path unfinished = object.string() + fmt::format(".{}-0.part", getpid());
  for (const std::string& word : {fs::absolute(file).string(), std::string("-o"), unfinished.string()})
    command.push_back(word);
  // A source that includes /dev/zero keeps a compiler busy, and eats memory, until somebody ends it.
  const std::string patience = "300", memory = "--as=8589934592";
  command.insert(command.begin(), {"prlimit", memory, "timeout", patience});
  const auto [message, status] = run_program(command, folder, "set CXX to a C++20 compiler, or apt-get install g++");
  if (status == 124) throw UserLawError(fmt::format("{} is not compiled within {} s", file.string(), patience));
  if (status != 0)
    throw UserLawError(fmt::format("{} does not compile:\n{}\nHint: {}", file.string(), message, hint(message, kind)));
  if (!fs::exists(unfinished))
    throw UserLawError(
        fmt::format("{}: {} ended without an error but made nothing of it; does CXX name a C++ compiler?",
                    file.string(), command[4]));
  fs::rename(unfinished, object);
  return object;
}

/// Loads a law and asks it at some states of a bed and of a sphere alone.
void try_law(const fs::path& object, const UserLawKind& kind) {
  void* const library = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const law = library == nullptr ? nullptr : dlsym(library, kind.symbol.c_str());
  if (law == nullptr || kind.word != "drag") return;
  const auto& drag = *static_cast<const drag::DragLawKernels*>(law);
  for (const double voidage : {0.4, 1.0})
    for (const double reynolds : {0.0, 1.0, 300.0}) drag({voidage, reynolds});
}

/// Compiles the file (once per content), loads it, and returns the address of the kind's symbol.
const void* load_user_law(const fs::path& file, const UserLawKind& kind) {
  static std::mutex mutex;
  static std::map<std::string, const void*> loaded;
  const std::lock_guard lock(mutex);
  if (NoForeignCode::holds())
    throw UserLawError(fmt::format("{}: a law from a file is neither compiled nor run here", file.string()));
  const std::string content = user_law_hash(file);
  const void*& address = loaded[content + kind.symbol];
  if (address != nullptr) return address;
  const fs::path object = compile(file, content, kind);
  // Loading runs code of the file already. A crash there is one of another process.
  constexpr unsigned seconds = 10;
  if (const auto trouble = trouble_in_child([&] { try_law(object, kind); }, seconds))
    throw UserLawError(fmt::format("{}: calling the law {}", file.string(), *trouble));
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

bool is_user_law(std::string_view name) { return name.substr(0, end_of_law_name(name)).ends_with(".cpp"); }

bool is_varied_law(std::string_view name) { return is_user_law(name) || end_of_law_name(name) < name.size(); }

std::string user_law_file(std::string_view law) { return std::string(law.substr(0, end_of_law_name(law))); }

std::string user_law_text(const fs::path& file) {
  std::set<fs::path> seen;
  std::string text;
  append_source(file, seen, text);
  return text;
}

std::string user_law_hash(const fs::path& file) { return digits(user_law_text(file)); }

NoForeignCode::NoForeignCode() { ++foreign_code_forbidden; }
NoForeignCode::~NoForeignCode() { --foreign_code_forbidden; }
bool NoForeignCode::holds() { return foreign_code_forbidden > 0; }

namespace {

/// A drag law as its source has it.
drag::DragLawKernels plain_drag_law(const std::string& name_or_file) {
  std::vector<std::string_view> names;
  for_each_law<drag::DragLaws>([&](const auto& law) { names.push_back(law.info.name); });
  if (is_user_law(name_or_file))
    return law_of_file<drag::DragLawKernels>(name_or_file, {"slfb_drag_law", "SLFB_DRAG_LAW", "drag"}, names);
  if (std::ranges::find(names, name_or_file) == names.end())
    throw std::invalid_argument(fmt::format("unknown drag law \"{}\"; known: {}, or a file that ends with .cpp",
                                            name_or_file, fmt::join(names, ", ")));
  return drag::with_drag_law(name_or_file, [](auto law) { return drag::kernels_of<decltype(law)>(); });
}

}  // namespace

drag::DragLawKernels find_drag_law(const std::string& name_or_file) {
  const LawCall call = parse_law_call(name_or_file);
  drag::DragLawKernels law = plain_drag_law(call.name);
  if (call.values.empty()) return law;
  // Kernels point to the name and to the values: they stay.
  static std::mutex mutex;
  struct Varied {
    std::string name;
    const void* law;
  };
  static auto& laws = *new std::map<std::string, Varied>;  // to the end of the program, as what points there
  const std::lock_guard lock(mutex);
  const std::string identity = law_call_text(is_user_law(call.name) ? user_law_hash(call.name) : call.name, call);
  auto found = laws.find(identity);
  if (found == laws.end())
    found = laws.emplace(identity, Varied{law_call_text(law.info.name, call), law.with(call)}).first;
  law.drag.law = law.slip_derivative.law = found->second.law;
  law.info.name = found->second.name;
  return law;
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
