#include "experiments/commands/laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

namespace slfb {

namespace {

using nlohmann::json;

// JSON has no infinity: an open end of a range is null.
json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json as_json(const Range& range) { return {number_or_null(range.lower), number_or_null(range.upper)}; }

std::string as_text(const Range& range) {
  return std::isfinite(range.upper) ? fmt::format("{:g} to {:g}", range.lower, range.upper)
                                    : fmt::format("{:g} up", range.lower);
}

json as_json(const LawInfo& info) {
  return {{"name", info.name},
          {"kind", to_string(info.kind)},
          {"title", info.title},
          {"equation", info.equation},
          {"convention", info.convention},
          {"source", info.source},
          {"confidence", to_string(info.confidence)},
          {"note", info.note},
          {"range", {{"reynolds", as_json(info.reynolds)}, {"voidage", as_json(info.voidage)}}}};
}

std::vector<const CatalogueEntry*> laws_of(const std::string& kind) {
  std::vector<const CatalogueEntry*> found;
  for (const CatalogueEntry& entry : catalogue()) {
    if (kind.empty() || to_string(entry.info.kind) == kind) found.push_back(&entry);
  }
  return found;
}

// The names of all kinds, in the order of the catalogue.
std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue()) {
    const std::string name(to_string(entry.info.kind));
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

void print_table(const std::vector<const CatalogueEntry*>& laws) {
  constexpr const char* row = "{:<35} {:<21} {:<18} {:<14} {:<14} {}\n";
  std::cout << fmt::format(row, "name", "kind", "source", "Re", "voidage", "confidence");
  for (const CatalogueEntry* entry : laws) {
    const LawInfo& info = entry->info;
    std::cout << fmt::format(row, info.name, to_string(info.kind), info.source, as_text(info.reynolds),
                             as_text(info.voidage), to_string(info.confidence));
  }
  std::cout << fmt::format(
      "\n{} laws. 'slfb law NAME' shows one with its equation and evaluates it. Confidence: read in a source that\n"
      "quotes or implements the paper, recalled, derived, or reconstructed (a stand-in for a formula not at hand).\n",
      laws.size());
}

std::string option_name(const Argument& argument) {
  std::string name(argument.name);
  std::ranges::replace(name, '_', '-');
  return "--" + name;
}

// Arguments without a sensible default: a law of this kind is asked for at a given voidage or Reynolds number.
std::vector<std::string_view> required_arguments(LawKind kind) {
  switch (kind) {
    case LawKind::drag:
      return {"voidage", "re"};
    case LawKind::single_sphere_drag:
      return {"re"};
    case LawKind::minimum_fluidisation:
    case LawKind::radial_distribution:
      return {"voidage"};
    default:
      return {};
  }
}

// Complains of options that the law needs, does not take or cannot stand.
void check_arguments(const LawInfo& info, const LawArguments& arguments, const CLI::App& command) {
  const auto taken = arguments_of(info.kind);
  const auto required = required_arguments(info.kind);
  for (const Argument& argument : all_arguments()) {
    const std::string option = option_name(argument);
    if (command.count(option) == 0) {
      if (std::ranges::find(required, argument.name) == required.end()) continue;
      throw CLI::ValidationError(fmt::format("{} needs {}: {}", info.name, option, argument.meaning));
    }
    if (std::ranges::find(taken, &argument) == taken.end()) {
      std::string names;
      for (const Argument* one : taken) names += " " + option_name(*one);
      throw CLI::ValidationError(fmt::format("{} does not take {}; it takes{}", info.name, option, names));
    }
    const double value = arguments.*argument.value;
    if (!argument.allows(value)) {
      const std::string allowed = std::isfinite(argument.upper)
                                      ? fmt::format("0 < {} <= {:g}", argument.name, argument.upper)
                                      : fmt::format("{} {} 0", argument.name, argument.zero_allowed ? ">=" : ">");
      throw CLI::ValidationError(fmt::format("{} is {:g}, but {} is allowed", option, value, allowed));
    }
  }
}

void print_csv(const CatalogueEntry& entry, const LawArguments& arguments) {
  const LawAnswer evaluation = entry.evaluate(arguments);
  std::cout << "quantity,value,unit\n";
  for (const Argument* argument : arguments_of(entry.info.kind)) {
    std::cout << fmt::format("{},{},{}\n", argument->name, arguments.*(argument->value), argument->unit);
  }
  for (const Quantity& quantity : evaluation.quantities) {
    std::cout << fmt::format("{},{},{}\n", quantity.name, quantity.value, quantity.unit);
  }
  std::cout << fmt::format("in_range,{:d},1\n", in_range(entry.info, arguments, evaluation));
}

void print_text(const CatalogueEntry& entry, const LawArguments& arguments) {
  const LawInfo& info = entry.info;
  const LawAnswer evaluation = entry.evaluate(arguments);
  std::cout << fmt::format("{}: {}\n", info.name, info.title);
  auto line = [](std::string_view label, std::string_view text) {
    if (!text.empty()) std::cout << fmt::format("  {:<11} {}\n", label, text);
  };
  line("equation", info.equation);
  line("convention", info.convention);
  line("range", fmt::format("Re {}, voidage {}", as_text(info.reynolds), as_text(info.voidage)));
  line("source", fmt::format("{} ({})", info.source, to_string(info.confidence)));
  line("note", info.note);
  std::cout << "\nfor\n";
  for (const Argument* argument : arguments_of(info.kind)) {
    std::cout << fmt::format("  {:<30} {:>12.6g} {:<11} {}\n", argument->name, arguments.*(argument->value),
                             argument->unit, argument->meaning);
  }
  std::cout << "\nit gives\n";
  for (const Quantity& quantity : evaluation.quantities) {
    std::cout << fmt::format("  {:<30} {:>12.6g} {}\n", quantity.name, quantity.value, quantity.unit);
  }
  std::cout << (in_range(info, arguments, evaluation) ? "\nInside the range of the source.\n"
                                                      : "\nOUTSIDE the range of the source: an extrapolation.\n");
}

}  // namespace

json laws_as_json(const std::string& kind) {
  json laws = json::array();
  for (const CatalogueEntry* entry : laws_of(kind)) laws.push_back(as_json(entry->info));
  return {{"laws", laws}};
}

json evaluation_as_json(const CatalogueEntry& entry, const LawArguments& arguments) {
  const LawAnswer evaluation = entry.evaluate(arguments);
  json answer{{"law", entry.info.name},
              {"kind", to_string(entry.info.kind)},
              {"source", entry.info.source},
              {"convention", entry.info.convention},
              {"in_range", in_range(entry.info, arguments, evaluation)}};
  json& units = answer["units"] = json::object();
  for (const Argument* argument : arguments_of(entry.info.kind)) {
    answer[argument->name] = arguments.*(argument->value);
    units[argument->name] = argument->unit;
  }
  for (const Quantity& quantity : evaluation.quantities) {
    answer[quantity.name] = number_or_null(quantity.value);
    units[quantity.name] = quantity.unit;
  }
  return answer;
}

void add_laws_command(CLI::App& app) {
  struct Options {
    std::string kind;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("laws", "List the literature laws with their sources and ranges");
  command->add_flag("--json", options->json, "Write JSON instead of a table");
  command->add_option("--kind", options->kind, "Only the laws of this kind")->check(CLI::IsMember(kinds()));
  command->footer(
      "Examples:\n"
      "  slfb laws                 every law\n"
      "  slfb laws --kind drag     the drag laws a scene can name\n"
      "  slfb laws --json          the same for a script");
  command->callback([options] {
    if (options->json) {
      std::cout << laws_as_json(options->kind).dump(2) << '\n';
    } else {
      print_table(laws_of(options->kind));
    }
  });
}

void add_law_command(CLI::App& app) {
  struct Options {
    std::string name;
    LawArguments arguments;
    bool json = false;
    bool csv = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("law", "Show one law and evaluate it");
  command->add_option("NAME", options->name, "Name of the law, from 'slfb laws'")->required();
  for (const Argument& argument : all_arguments()) {
    command
        ->add_option(option_name(argument), options->arguments.*argument.value,
                     fmt::format("{} [{}]", argument.meaning, argument.unit))
        ->capture_default_str();
  }
  CLI::Option* json_flag = command->add_flag("--json", options->json, "Write JSON");
  command->add_flag("--csv", options->csv, "Write lines of quantity,value,unit")->excludes(json_flag);
  command->footer(
      "All numbers are in SI units. A drag law needs --voidage and --re; the other defaults are 5 mm glass and a 6 mm\n"
      "steel sphere in water in the 50 mm column of Peng et al. (2014). Outside its range a law still answers, and "
      "says\n"
      "so.\n\n"
      "Examples:\n"
      "  slfb law gidaspow-1994 --voidage 0.5 --re 100\n"
      "  slfb law gidaspow-1994 --voidage 0.5 --re 499.1 --diameter 5e-3 --viscosity 1e-3 --density 998.2 --json\n"
      "  slfb law brown-lawler-2003 --re 2238\n"
      "  slfb law van-der-wielen-1996 --voidage 0.46 --superficial-velocity 0.06\n"
      "  slfb law doroodchi-2012-minimum-fluidisation --voidage 0.40");
  command->callback([options, command] {
    try {
      const CatalogueEntry& entry = find_law(options->name);
      check_arguments(entry.info, options->arguments, *command);
      if (options->json) {
        std::cout << evaluation_as_json(entry, options->arguments).dump(2) << '\n';
      } else if (options->csv) {
        print_csv(entry, options->arguments);
      } else {
        print_text(entry, options->arguments);
      }
    } catch (const std::logic_error& error) {  // an unknown name, or arguments for which the law has no solution
      throw CLI::ValidationError(error.what());
    }
  });
}

}  // namespace slfb
