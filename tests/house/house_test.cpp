// The house keeps its order: who may include whom, no circles of folders, no work in general rooms. Each rule is also
// shown a small tree that breaks it.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Problems = std::vector<std::string>;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Lines that are neither empty nor a comment.
std::vector<std::string> entries_of(const fs::path& file) {
  std::istringstream stream(text_of(file));
  std::vector<std::string> entries;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && line.front() != '#') entries.push_back(line);
  return entries;
}

bool lies_in(const std::string& file, const std::string& folder) { return file.starts_with(folder + "/"); }

/// A source tree with the rooms of its tests/house/rooms.txt. Paths are relative to the tree.
class Tree {
 public:
  explicit Tree(fs::path root) : root_(std::move(root)) {
    if (fs::exists(root_ / "experiments"))
      for (const auto& entry : fs::directory_iterator(root_ / "experiments"))
        if (fs::exists(entry.path() / "own_words.txt"))
          works_.push_back("experiments/" + entry.path().filename().string());
    std::ranges::sort(works_);
    const auto names = entries_of(root_ / "tests/house/rooms.txt");
    for (std::size_t level = 0; level < names.size(); ++level)
      for (const std::string& folder : names[level] == "works" ? works_ : std::vector{names[level]})
        rooms_.emplace_back(folder, level);
    for (const char* top : {"correlations", "solver", "reports", "experiments"})
      if (fs::exists(root_ / top))
        for (const auto& entry : fs::recursive_directory_iterator(root_ / top))
          if (entry.is_regular_file()) read(fs::relative(entry.path(), root_));
  }

  [[nodiscard]] Problems files_without_a_room() const {
    Problems problems;
    for (const auto& [file, included] : includes_)
      if (room_of(file) == nullptr && file != "experiments/slfb.cpp") problems.push_back(file);
    return problems;
  }

  [[nodiscard]] Problems includes_upwards() const {
    Problems problems;
    for (const auto& [file, included] : includes_)
      for (const std::string& other : included) {
        const Room *from = room_of(file), *to = room_of(other);
        if (from == nullptr || to == from || (to != nullptr && to->second < from->second)) continue;
        problems.push_back(file + " includes " + other);
      }
    return problems;
  }

  /// Circles between folders neither of which lies in the other: a folder may list what its own folders hold.
  [[nodiscard]] Problems circles() const {
    const auto folder_of = [](const std::string& file) { return file.substr(0, file.rfind('/')); };
    std::map<std::string, std::map<std::string, std::string>> next;  // folder, folder, an example
    for (const auto& [file, included] : includes_)
      for (const std::string& other : included) {
        const std::string a = folder_of(file), b = folder_of(other);
        if (a != b && !lies_in(a, b) && !lies_in(b, a)) next[a].emplace(b, file + " includes " + other);
      }
    Problems problems;
    std::set<std::string> done;
    std::vector<std::string> path;
    const auto visit = [&](const auto& self, const std::string& folder) -> void {
      if (const auto begin = std::ranges::find(path, folder); begin != path.end()) {
        std::string circle = "circle:";
        for (auto entry = begin; entry != path.end(); ++entry)
          circle += " " + next[*entry][std::next(entry) == path.end() ? folder : *std::next(entry)] + ";";
        problems.push_back(std::move(circle));
        return;
      }
      if (done.contains(folder)) return;
      path.push_back(folder);
      for (const auto& [other, example] : std::map(next[folder])) self(self, other);
      path.pop_back();
      done.insert(folder);
    };
    for (const auto& [folder, others] : std::map(next)) visit(visit, folder);
    return problems;
  }

  /// Words of a work (its own_words.txt) in the code of other rooms. Laws keep their authors' names.
  [[nodiscard]] Problems words_of_works_elsewhere() const {
    Problems problems;
    for (const std::string& work : works_) {
      const auto words = entries_of(root_ / work / "own_words.txt");
      if (words.empty()) problems.push_back(work + "/own_words.txt lists nothing");
      for (const auto& [file, code] : code_) {
        if (lies_in(file, work) || lies_in(file, "correlations") || file == "experiments/commands/works.cpp") continue;
        for (const std::string& word : words) {
          std::smatch found;
          if (std::regex_search(code, found, std::regex(word, std::regex::icase)))
            problems.push_back(file + " has \"" + found.str() + "\", which belongs to " + work);
        }
      }
    }
    return problems;
  }

  [[nodiscard]] Problems loose_files() const {
    Problems problems;
    for (const char* top : {"solver", "experiments"})
      for (const auto& entry : fs::directory_iterator(root_ / top)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && name != "CMakeLists.txt" && name != "README.md" && name != "slfb.cpp")
          problems.push_back(std::string(top) + "/" + name);
      }
    return problems;
  }

  [[nodiscard]] std::size_t size() const { return includes_.size(); }
  [[nodiscard]] const std::vector<std::string>& works() const { return works_; }

 private:
  using Room = std::pair<std::string, std::size_t>;  ///< folder, place from the bottom

  void read(const fs::path& file) {
    const std::string ending = file.extension().string();
    const bool source = ending == ".cpp" || ending == ".hpp";
    if (!source && ending != ".gp" && ending != ".toml") return;
    const std::string text = text_of(root_ / file);
    static const std::regex line_comment("(^|[^:\"])//[^\n]*"), hash_comment("(^|\n)[ \t]*#[^\n]*");
    code_[file.string()] = std::regex_replace(text, source ? line_comment : hash_comment, "$1");
    if (!source) return;
    static const std::regex include("#include \"((?:correlations|solver|reports|experiments)/[^\"]+)\"");
    auto& included = includes_[file.string()];
    for (std::sregex_iterator found(text.begin(), text.end(), include), end; found != end; ++found)
      included.push_back((*found)[1]);
  }

  [[nodiscard]] const Room* room_of(const std::string& file) const {
    for (const Room& room : rooms_)
      if (lies_in(file, room.first)) return &room;
    return nullptr;
  }

  fs::path root_;
  std::vector<std::string> works_;
  std::vector<Room> rooms_;
  std::map<std::string, std::vector<std::string>> includes_;
  std::map<std::string, std::string> code_;  ///< without comments
};

const Tree& suite() {
  static const Tree tree(SLFB_SOURCE_DIR);
  return tree;
}

TEST(House, EveryFileStandsInARoom) {
  EXPECT_GT(suite().size(), 300u);
  EXPECT_EQ(suite().files_without_a_room(), Problems{});
}

TEST(House, NoIncludeRunsUpwards) { EXPECT_EQ(suite().includes_upwards(), Problems{}); }

TEST(House, NoCircleOfFolders) { EXPECT_EQ(suite().circles(), Problems{}); }

TEST(House, WorksStayInTheirFolders) {
  EXPECT_FALSE(suite().works().empty());
  EXPECT_EQ(suite().words_of_works_elsewhere(), Problems{});
}

TEST(House, NoLooseFiles) { EXPECT_EQ(suite().loose_files(), Problems{}); }

/// A tree of three rooms that breaks every rule once.
class BrokenHouse : public testing::Test {
 protected:
  BrokenHouse() : root_(fs::temp_directory_path() / ("slfb_house_" + std::to_string(getpid()))) {
    write("tests/house/rooms.txt", "solver/dem\nsolver/fluid\nexperiments/figures\nworks\n");
    write("solver/loose.hpp", "#pragma once\n");
    write("solver/dem/engine.hpp", "#include \"solver/fluid/liquid.hpp\"\n");
    write("solver/fluid/liquid.hpp", "#include \"solver/dem/engine.hpp\"\n");
    write("experiments/figures/figure.cpp", "// Smith 2030 may be cited here.\nconst char* name = \"smith_2030\";\n");
    write("experiments/smith_2030/work.cpp", "#include \"experiments/figures/figure.hpp\"\n");
    write("experiments/smith_2030/own_words.txt", "# what is his\nsmith[_ ]2030\n");
  }
  ~BrokenHouse() override { fs::remove_all(root_); }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  fs::path root_;
};

TEST_F(BrokenHouse, IsToldSo) {
  const Tree tree(root_);
  EXPECT_EQ(tree.files_without_a_room(), Problems{"solver/loose.hpp"});
  EXPECT_EQ(tree.loose_files(), Problems{"solver/loose.hpp"});
  EXPECT_EQ(tree.includes_upwards(), Problems{"solver/dem/engine.hpp includes solver/fluid/liquid.hpp"});
  ASSERT_EQ(tree.circles().size(), 1u);
  EXPECT_NE(tree.circles().front().find("solver/fluid/liquid.hpp includes solver/dem/engine.hpp"), std::string::npos);
  EXPECT_EQ(tree.words_of_works_elsewhere(),
            Problems{"experiments/figures/figure.cpp has \"smith_2030\", which belongs to experiments/smith_2030"});
}

}  // namespace
