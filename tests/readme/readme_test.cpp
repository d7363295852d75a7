// README says what commands print: each is run, and what it prints is compared. A line "..." stands for any lines, "…"
// at the end of a line for the rest of it; numbers agree within a percent or their last digit. README is also a read of
// five minutes.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

constexpr double number_tolerance = 0.01;  // relative
constexpr std::size_t most_words = 900;

struct Example {
  std::vector<std::string> commands;
  std::vector<std::string> output;  ///< empty: nothing is shown
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string readme() {
  std::ifstream stream(std::string(SLFB_SOURCE_DIR) + "/README.md");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Blocks of ```sh, each with the block without a language that follows it.
std::vector<Example> examples() {
  std::vector<Example> found;
  std::vector<std::string>* block = nullptr;
  for (const std::string& line : lines_of(readme())) {
    if (line.starts_with("```")) {
      if (block != nullptr) {
        block = nullptr;
      } else if (line == "```sh") {
        block = &found.emplace_back().commands;
      } else if (line == "```" && !found.empty()) {
        block = &found.back().output;
      }
    } else if (block != nullptr && !line.empty()) {
      block->push_back(line);
    }
  }
  return found;
}

std::optional<double> number(std::string word) {
  while (!word.empty() && std::string_view(",;:)").find(word.back()) != std::string_view::npos) word.pop_back();
  if (!word.empty() && word.front() == '(') word.erase(0, 1);
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return std::nullopt;
  return value;
}

/// One unit of the last digit that a number is written with; 0 for one with an exponent.
double last_digit(const std::string& word) {
  const std::size_t point = word.find('.');
  if (word.find_first_of("eE") != std::string::npos) return 0.0;
  std::size_t decimals = 0;
  if (point != std::string::npos)
    while (point + 1 + decimals < word.size() && std::isdigit(static_cast<unsigned char>(word[point + 1 + decimals])))
      ++decimals;
  return point == std::string::npos ? 0.0 : std::pow(10.0, -static_cast<double>(decimals));
}

bool same_word(const std::string& expected, const std::string& printed) {
  if (expected == printed) return true;
  const auto one = number(expected), other = number(printed);
  if (!one || !other) return false;
  return std::fabs(*one - *other) <= std::max(number_tolerance * std::fabs(*one), 1.001 * last_digit(expected));
}

bool same_line(const std::string& expected, const std::string& printed) {
  std::istringstream one(expected), other(printed);
  std::string wanted, found;
  while (one >> wanted) {
    if (wanted == "…") return true;
    if (!(other >> found) || !same_word(wanted, found)) return false;
  }
  return !(other >> found);
}

/// Whether `printed` is what is expected; if not, the line of it that is missing.
std::optional<std::string> missing_line(const std::vector<std::string>& expected,
                                        const std::vector<std::string>& printed) {
  std::size_t place = 0;
  bool skips = false;
  for (const std::string& line : expected) {
    if (line == "...") {
      skips = true;
      continue;
    }
    while (place < printed.size() && (printed[place].empty() || (skips && !same_line(line, printed[place])))) ++place;
    if (place == printed.size() || !same_line(line, printed[place])) return line;
    ++place;
    skips = false;
  }
  while (place < printed.size() && printed[place].empty()) ++place;
  if (!skips && place < printed.size()) return "nothing more, but it prints: " + printed[place];
  return std::nullopt;
}

std::pair<std::string, int> run(const std::string& command) {
  const std::string whole = "cd '" SLFB_SOURCE_DIR "' && " + command + " 2>&1";
  FILE* pipe = popen(whole.c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe)) output.append(buffer.data(), count);
  const int status = pclose(pipe);
  return {output, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

TEST(Readme, IsAReadOfFiveMinutes) {
  std::istringstream words(readme());
  std::size_t count = 0;
  for (std::string word; words >> word;) ++count;
  EXPECT_LT(count, most_words);
}

TEST(Readme, EveryCommandPrintsWhatItSays) {
  std::size_t run_commands = 0;
  for (const Example& example : examples()) {
    for (std::string command : example.commands) {
      SCOPED_TRACE(command);
      ++run_commands;
      if (command.starts_with("make ")) {
        // It installs and builds; whether make knows it and its rules can be followed is what a test can say.
        EXPECT_EQ(run("make --dry-run " + command.substr(5) + " >/dev/null").second, 0);
        continue;
      }
      const std::string program = "build/slfb ";
      ASSERT_TRUE(command.starts_with(program));
      const auto [output, status] = run(std::string(SLFB_PROGRAM) + " " + command.substr(program.size()));
      EXPECT_EQ(status, 0) << output;
      const auto missing = missing_line(example.output, lines_of(output));
      EXPECT_FALSE(missing) << "expected: " << *missing << "\nprinted:\n" << output;
      EXPECT_FALSE(example.output.empty()) << "README shows what it prints";
    }
  }
  EXPECT_GE(run_commands, 6U) << "two front doors and four uses";
}

// The comparison itself can fail.
TEST(Readme, OtherNumbersAndOtherLinesAreSeen) {
  EXPECT_TRUE(same_line("fig05  1450  Pa  holds  …", "fig05    1451 Pa holds inside the band"));
  EXPECT_FALSE(same_line("fig05  1450  Pa", "fig05 1480 Pa"));
  EXPECT_FALSE(same_line("fig05  1450  Pa", "fig05 1450 kPa"));
  EXPECT_FALSE(missing_line({"first", "...", "last"}, {"first", "second", "third", "last"}));
  EXPECT_TRUE(missing_line({"first", "last"}, {"first", "second", "last"}));
  EXPECT_TRUE(missing_line({"first", "...", "last"}, {"first", "second"}));
  EXPECT_TRUE(missing_line({"first"}, {"first", "second"}));
}

}  // namespace
