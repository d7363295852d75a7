// Changed inputs for every reader, the same ones each time (tests/fuzz).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

#include "tests/fuzz/readers.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::fuzz {
namespace {

/// Changes an input in one to six places: bytes flipped, cut out, doubled or put in, numbers and words exchanged.
class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  std::string changed(std::string text) {
    for (std::size_t k = below(6) + 1; k > 0; --k) change(text);
    return text;
  }
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

 private:
  void change(std::string& text) {
    static constexpr std::array<std::string_view, 20> words{
        "1e308",  "-1",      "nan",  "inf", "0",  "99999999999999999999",
        "[]",     "{}",      "\"",   "\n",  "= ", "[[species]]\n",
        "1e-308", "../",     "null", "\0",  ",",  "true",
        "'",      "\xff\xfe"};
    const std::size_t at = below(text.size() + 1), length = std::min(below(20) + 1, text.size() - at);
    switch (below(7)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.insert(at, words[below(words.size())]);
        break;
      case 4:
        text.replace(at, length, words[below(words.size())]);
        break;
      case 5:
        text.resize(at);
        break;
      default:
        exchange_number(text, at);
    }
  }

  /// The number after a place, if there is one near.
  void exchange_number(std::string& text, std::size_t at) {
    static constexpr std::array<std::string_view, 8> numbers{"0", "-1",  "1e300", "1e-300", "9223372036854775807",
                                                             "1", "0.5", "-0.0"};
    const std::size_t from = text.find_first_of("0123456789", at);
    if (from == std::string::npos) return;
    const std::size_t to = std::min(text.find_first_not_of("0123456789.e", from), text.size());
    text.replace(from, to - from, numbers[below(numbers.size())]);
  }

  std::mt19937 random_;
};

std::vector<std::string> reader_names() {
  return {"scene", "overrides",   "measured", "spheres", "claims", "rules",         "profiles",  "values",
          "table", "noise-study", "summary",  "json",    "result", "sealed-result", "checkpoint"};
}

class Fuzz : public testing::TestWithParam<std::string> {};

TEST_P(Fuzz, EachInputIsReadOrRefusedInWords) {
  static const std::vector<Reader> all = readers();
  const Reader& reader = *std::ranges::find(all, GetParam(), &Reader::name);
  const char* const asked = std::getenv("SLFB_FUZZ_INPUTS");
  const std::size_t inputs = asked != nullptr ? std::stoull(asked) : 200;
  const Folder folder;
  for (const std::string& seed : reader.seeds)
    ASSERT_EQ(fault_of(reader, seed, folder.path()), "") << "the valid input itself";
  Mutator mutator(20'140'440);
  for (std::size_t k = 0; k < inputs; ++k) {
    const std::string input = mutator.changed(reader.seeds[mutator.below(reader.seeds.size())]);
    ASSERT_EQ(fault_of(reader, input, folder.path()), "") << "input " << k << ":\n" << input.substr(0, 4000);
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, Fuzz, testing::ValuesIn(reader_names()), [](const auto& one) {
  std::string name = one.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Fuzz, EveryReaderHasItsTest) {
  std::vector<std::string> names;
  for (const Reader& reader : readers()) names.push_back(reader.name);
  EXPECT_EQ(names, reader_names());
}

}  // namespace
}  // namespace slfb::fuzz
