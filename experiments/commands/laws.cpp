#include "experiments/commands/laws.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "reports/law_plot.hpp"

namespace slfb {

namespace {

using nlohmann::json;

// JSON has no infinity: an open end of a range is null.
json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json as_json(const Range& range) { return {number_or_null(range.lower), number_or_null(range.upper)}; }

std::string as_text(const Range& range) {
  if (!std::isfinite(range.upper) && range.lower == 0.0) return "any";
  return std::isfinite(range.upper) ? fmt::format("{:g} to {:g}", range.lower, range.upper)
                                    : fmt::format("{:g} up", range.lower);
}

json as_json(const CatalogueEntry& entry) {
  const LawInfo& info = entry.info;
  json parameters = json::array();
  for (const ParameterInfo& one : entry.parameters)
    parameters.push_back(
        {{"name", one.name}, {"of_source", one.of_source}, {"range", as_json(one.range)}, {"meaning", one.meaning}});
  return {{"name", info.name},
          {"kind", to_string(info.kind)},
          {"title", info.title},
          {"equation", info.equation},
          {"equation_number", info.equation_number},
          {"convention", info.convention},
          {"source", info.source},
          {"confidence", to_string(info.confidence)},
          {"note", info.note},
          {"variant_of", info.variant_of},
          {"range",
           {{"reynolds", as_json(info.reynolds)},
            {"voidage", as_json(info.voidage)},
            {"size_ratio", as_json(info.size_ratio)},
            {"stokes", as_json(info.stokes)}}},
          {"parameters", std::move(parameters)}};
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

// Complains of options that the law needs (to be evaluated, not to be drawn), does not take or cannot stand.
void check_arguments(const CatalogueEntry& law, const LawArguments& arguments, const CLI::App& command,
                     bool evaluated) {
  const std::string_view name = law.info.name;
  const auto taken = arguments_of(law);
  const auto required = evaluated ? required_arguments(law.info.kind) : std::vector<std::string_view>{};
  for (const Argument& argument : all_arguments()) {
    const std::string option = option_name(argument);
    if (command.count(option) == 0) {
      if (std::ranges::find(required, argument.name) == required.end()) continue;
      throw CLI::ValidationError(fmt::format("{} needs {}: {}", name, option, argument.meaning));
    }
    if (std::ranges::find(taken, &argument) == taken.end()) {
      std::string names;
      for (const Argument* one : taken) names += " " + option_name(*one);
      throw CLI::ValidationError(fmt::format("{} does not take {}; it takes{}", name, option, names));
    }
    const double value = arguments.*argument.value;
    if (!argument.allows(value)) {
      const std::string allowed =
          std::isfinite(argument.upper)
              ? fmt::format("0 {} {} <= {:g}", argument.zero_allowed ? "<=" : "<", argument.name, argument.upper)
              : fmt::format("{} {} 0", argument.name, argument.zero_allowed ? ">=" : ">");
      throw CLI::ValidationError(fmt::format("{} is {:g}, but {} is allowed", option, value, allowed));
    }
  }
}

// Where a plot goes: the folder, the name without its ending and the ending, which is its format.
struct PlotFile {
  std::filesystem::path folder;
  std::string id;
  std::string format;
};

PlotFile plot_file(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  PlotFile plot{folder, file.stem().string(), file.extension().string()};
  if (plot.format != ".svg" && plot.format != ".png" && plot.format != ".pdf") {
    throw CLI::ValidationError(
        fmt::format("--plot is {}, but a file that ends with .svg, .png or .pdf is allowed", file.string()));
  }
  plot.format.erase(0, 1);
  const bool plain = std::ranges::all_of(
      plot.id, [](unsigned char letter) { return std::isalnum(letter) || letter == '-' || letter == '_'; });
  if (!plain) {
    throw CLI::ValidationError(
        fmt::format("--plot is {}, but letters, digits, '-' and '_' are allowed in its name", file.string()));
  }
  if (!std::filesystem::is_directory(folder)) {
    throw CLI::ValidationError(fmt::format("--plot is {}, but there is no folder {}", file.string(), folder.string()));
  }
  return plot;
}

void say_where(const PlotFile& plot) {
  const std::string start = (plot.folder / plot.id).string();
  std::cout << fmt::format("{0}.{1}, its data {0}.csv and its script {0}.gp\n", start, plot.format);
}

void print_csv(const CatalogueEntry& entry, const LawArguments& arguments) {
  const LawAnswer evaluation = entry.evaluate(arguments);
  std::cout << "quantity,value,unit\n";
  for (const Argument* argument : arguments_of(entry)) {
    std::cout << fmt::format("{},{},{}\n", argument->name, arguments.*(argument->value), argument->unit);
  }
  for (const LawValue& quantity : evaluation.quantities) {
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
  line("number", info.equation_number.empty() ? "in the source not at hand" : info.equation_number);
  line("convention", info.convention);
  std::string range = fmt::format("Re {}, voidage {}", as_text(info.reynolds), as_text(info.voidage));
  if (as_text(info.size_ratio) != "any") range += fmt::format(", size ratio {}", as_text(info.size_ratio));
  if (as_text(info.stokes) != "any") range += fmt::format(", Stokes number {}", as_text(info.stokes));
  line("range", range);
  line("source", fmt::format("{} ({})", info.source, to_string(info.confidence)));
  line("note", info.note);
  line("variant of", info.variant_of);
  std::string variants;
  for (const CatalogueEntry* variant : variants_of(info.name)) {
    variants += (variants.empty() ? "" : ", ") + std::string(variant->info.name);
  }
  line("variants", variants);
  for (const ParameterInfo& parameter : entry.parameters) line("parameter", parameter_text(parameter));
  std::cout << "\nfor\n";
  for (const Argument* argument : arguments_of(entry)) {
    std::cout << fmt::format("  {:<30} {:>12.6g} {:<11} {}\n", argument->name, arguments.*(argument->value),
                             argument->unit, argument->meaning);
  }
  std::cout << "\nit gives\n";
  for (const LawValue& quantity : evaluation.quantities) {
    std::cout << fmt::format("  {:<30} {:>12.6g} {}\n", quantity.name, quantity.value, quantity.unit);
  }
  std::cout << (in_range(info, arguments, evaluation) ? "\nInside the range of the source.\n"
                                                      : "\nOUTSIDE the range of the source: an extrapolation.\n");
}

}  // namespace

json laws_as_json(const std::string& kind) {
  json laws = json::array();
  for (const CatalogueEntry* entry : laws_of(kind)) laws.push_back(as_json(*entry));
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
  for (const Argument* argument : arguments_of(entry)) {
    answer[argument->name] = arguments.*(argument->value);
    units[argument->name] = argument->unit;
  }
  for (const LawValue& quantity : evaluation.quantities) {
    answer[quantity.name] = number_or_null(quantity.value);
    units[quantity.name] = quantity.unit;
  }
  return answer;
}

void add_laws_command(CLI::App& app) {
  struct Options {
    std::string kind;
    bool json = false;
    std::filesystem::path plot;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("laws", "List the literature laws with their sources and ranges");
  command->add_flag("--json", options->json, "write JSON instead of a table");
  command->add_option("--kind", options->kind, "only the laws of this kind")->check(CLI::IsMember(kinds()));
  command->add_option("--plot", options->plot, "draw the laws of --kind in FILE (.svg, .png or .pdf)")
      ->type_name("FILE")
      ->needs("--kind");
  command->footer(
      "Examples:\n"
      "  slfb laws                 every law\n"
      "  slfb laws --kind drag     the drag laws a scene can name\n"
      "  slfb laws --json          the same for a script\n"
      "  slfb laws --kind drag --plot drag.svg   all drag laws in one picture");
  command->callback([options] {
    if (!options->plot.empty()) {
      const PlotFile plot = plot_file(options->plot);
      draw_family(laws_of(options->kind).front()->info.kind, {}, plot.id, plot.folder, {plot.format});
      say_where(plot);
    } else if (options->json) {
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
    std::filesystem::path plot;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("law", "Show one law and evaluate it");
  command
      ->add_option("NAME", options->name,
                   "name of the law, from 'slfb laws', with parameters that it takes: NAME:KEY=VALUE,KEY=VALUE")
      ->required();
  for (const Argument& argument : all_arguments()) {
    command
        ->add_option(option_name(argument), options->arguments.*argument.value,
                     fmt::format("{} [{}]", argument.meaning, argument.unit))
        ->capture_default_str();
  }
  CLI::Option* json_flag = command->add_flag("--json", options->json, "write JSON");
  command->add_flag("--csv", options->csv, "write lines of quantity,value,unit")->excludes(json_flag);
  command
      ->add_option("--plot", options->plot,
                   "draw the law among those of its kind in FILE (.svg, .png or .pdf; its data and script beside it)")
      ->type_name("FILE");
  command->footer(
      "All numbers are in SI units. A drag law needs --voidage and --re; the other defaults are 5 mm glass and a 6 mm\n"
      "steel sphere in water in the 50 mm column of Peng et al. (2014). Outside its range a law still answers, and "
      "says\n"
      "so.\n"
      "A drag law gives the dimensionless drag F = f_d/(3 pi mu d e w), w the slip, f_d the drag on one sphere "
      "without\n"
      "the pressure gradient (model A); beta = 18 mu e (1 - e) F/d^2; and the derivative of f_d with respect to w.\n\n"
      "Examples:\n"
      "  slfb law gidaspow-1994 --voidage 0.5 --re 100\n"
      "  slfb law gidaspow-1994 --voidage 0.5 --re 499.1 --diameter 5e-3 --viscosity 1e-3 --density 998.2 --json\n"
      "  slfb law ergun-1952:viscous=180,inertial=1.8 --voidage 0.42 --re 100   other constants; the law lists them\n"
      "  slfb law brown-lawler-2003 --re 2238\n"
      "  slfb law van-der-wielen-1996 --voidage 0.46 --superficial-velocity 0.06\n"
      "  slfb law doroodchi-2012-minimum-fluidisation --voidage 0.40\n"
      "  slfb law grbavcic-2009 --transition 0.8\n"
      "  slfb law tenneti-2011 --voidage 0.6 --plot tenneti.svg");
  command->callback([options, command] {
    try {
      const CatalogueEntry& entry = find_law(options->name);
      check_arguments(entry, options->arguments, *command, options->plot.empty());
      if (!options->plot.empty()) {
        const PlotFile plot = plot_file(options->plot);
        draw_law(entry, options->arguments, plot.id, plot.folder, {plot.format});
        say_where(plot);
      } else if (options->json) {
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
