// One fuzz target of libFuzzer: the reader SLFB_READER.
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slfb::fuzz;
  static const Reader reader = [] {
    spdlog::set_level(spdlog::level::off);
    const auto all = readers();
    return *std::ranges::find(all, SLFB_READER, &Reader::name);
  }();
  static const auto folder = [] {
    auto made = std::filesystem::temp_directory_path() / fmt::format("slfb-fuzz-{}", getpid());
    std::filesystem::create_directories(made);
    return made;
  }();
  const std::string fault = fault_of(reader, {reinterpret_cast<const char*>(data), size}, folder);
  if (fault.empty()) return 0;
  fmt::print(stderr, "{}\n", fault);
  std::abort();
}
