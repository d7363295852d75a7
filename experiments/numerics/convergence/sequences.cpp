#include "experiments/numerics/convergence/sequences.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "experiments/numerics/frontier/solved_study.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::convergence {

Refined refined_by_name(const std::string& name) {
  if (name == "cells") return Refined::cells;
  if (name == "liquid-step") return Refined::liquid_step;
  if (name == "solid-step") return Refined::solid_step;
  throw std::invalid_argument(fmt::format("unknown \"{}\"; known: \"cells\", \"liquid-step\", \"solid-step\"", name));
}

std::string name_of(Refined refined) {
  switch (refined) {
    case Refined::cells:
      return "cells";
    case Refined::liquid_step:
      return "liquid step";
    case Refined::solid_step:
      break;
  }
  return "contact step";
}

std::string size_text(Refined refined, double size) {
  return fmt::format("{:.2g} {}", 1e3 * size, refined == Refined::cells ? "mm" : "ms");
}

std::vector<Sequence> study_sequences(const std::filesystem::path& results) {
  const auto file = source_folder() / "experiments/numerics/convergence/sequences.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  std::vector<Sequence> sequences;
  for (TomlTable& one : table.tables("sequence")) {
    Sequence sequence{one.text("title"), refined_by_name(one.text("refined")), {}};
    const frontier::SolvedStudy solved = frontier::load_solved(one.text("study"), results);
    for (const std::string& quantity : one.texts("quantities")) sequence.quantities.push_back({quantity, {}});
    for (TomlTable& level : one.tables("level")) {
      const double size = level.number("size");
      const bool is_reference = level.flag("reference");
      const frontier::ReducedPoint* point =
          is_reference ? nullptr : solved.at(level.text("series"), level.number("axis", size));
      level.reject_others();
      if (point == nullptr && !is_reference) continue;
      const auto& values = is_reference ? solved.reduced.reference : point->values;
      for (QuantitySequence& of : sequence.quantities)
        if (const auto found = values.find(of.quantity); found != values.end())
          of.levels.push_back({size, found->second.value, found->second.half_width});
    }
    one.reject_others();
    sequences.push_back(std::move(sequence));
  }
  table.reject_others();
  return sequences;
}

}  // namespace slfb::convergence
