#include "experiments/figures/figure_folder.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

constexpr std::string_view caption_heading = "## Caption";

std::filesystem::path readme_of(const std::filesystem::path& folder) {
  return source_folder() / "experiments" / folder / "README.md";
}

/// Where the caption begins and ends, its heading included; both npos without a caption.
std::pair<std::size_t, std::size_t> caption_range(const std::string& readme) {
  const std::size_t begin = readme.find(caption_heading);
  if (begin == std::string::npos) return {begin, begin};
  const std::size_t next = readme.find("\n## ", begin + caption_heading.size());
  return {begin, next == std::string::npos ? readme.size() : next + 1};
}

}  // namespace

std::string FigureFolder::title() const {
  const std::filesystem::path file = readme_of(folder_);
  const std::string readme = read_file(file);
  if (!readme.starts_with("# "))
    throw std::runtime_error(fmt::format("{}:1: no title; it begins \"# \"", file.string()));
  return readme.substr(2, readme.find('\n') - 2);
}

std::string FigureFolder::caption(const std::map<std::string, std::string>& words) const {
  const std::filesystem::path file = readme_of(folder_);
  const std::string readme = read_file(file);
  const auto [begin, end] = caption_range(readme);
  if (begin == std::string::npos)
    throw std::runtime_error(fmt::format("{}: no part \"{}\"", file.string(), caption_heading));
  std::string text = readme.substr(begin + caption_heading.size(), end - begin - caption_heading.size());
  std::set<std::string> used;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open)) {
    const std::size_t close = text.find('}', open);
    const std::string name = text.substr(open + 1, close - open - 1);
    const auto found = words.find(name);
    if (close == std::string::npos || found == words.end())
      throw std::runtime_error(
          fmt::format("{}: the figure gives nothing for \"{{{}}}\" in the caption", file.string(), name));
    used.insert(name);
    text.replace(open, close - open + 1, found->second);
    open += found->second.size();
  }
  for (const auto& [name, value] : words)
    if (!used.contains(name))
      throw std::runtime_error(fmt::format("{}: the caption does not use \"{{{}}}\"", file.string(), name));
  std::istringstream lines(text);
  std::string line;
  for (std::string word; lines >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

std::filesystem::path FigureFolder::plot(const std::string& name) const {
  return source_folder() / "experiments" / folder_ / name;
}

std::string figure_definitions(const std::string& readme) {
  constexpr std::string_view heading = "## Definitions\n";
  std::string text = readme;
  const auto [begin, end] = caption_range(text);
  if (begin != std::string::npos) text.erase(begin, end - begin);
  const std::size_t found = text.find(heading);
  return found == std::string::npos ? "" : text.substr(found + heading.size());
}

}  // namespace slfb
