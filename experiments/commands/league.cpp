#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/league/league_report.hpp"
#include "experiments/league/scene_bed.hpp"
#include "experiments/numerics/plan/plan.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/scene/units.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* league_examples = R"(Examples:
  slfb league                                   every law against every measurement, by regime
  slfb league experiments/scenes/fluidised_box.toml       which laws were near in beds like this one
  slfb league --diameter 3mm --density 2500kg/m3 --column 50mm   the same without a scene, in water
  slfb league --drag mine.cpp                   your own law among the others
  slfb league --json                            as JSON

Tables and chart lie in DIR/league: league.csv, league.json, league.svg, .png, .pdf. A bias is law over truth; the spread
is one relative standard deviation of the law, the measurements' own taken out (McGrattan & Toman 2011, as in the
validation of fire models); intervals are over the kinds of spheres and liquid. "+ wall" is the law with the factor
10^(-d/D) of Richardson & Zaki (1954) on the velocity. How each number is made: experiments/league/README.md.)";

struct LeagueOptions {
  fs::path scene;
  std::vector<std::string> overrides, drag;
  std::string diameter, density, liquid_density = "998.2 kg/m3", viscosity = "1.0 mPa s", column;
  fs::path out = build_folder();
  std::size_t rows = 8;
  bool json = false;

  [[nodiscard]] bool asks_for_a_bed() const { return !scene.empty() || !diameter.empty() || !density.empty(); }
};

/// With its unit, or a bare number in SI units.
double quantity(const std::string& option, const std::string& text, const units::Dimension& dimension) {
  try {
    char* end = nullptr;
    const double bare = std::strtod(text.c_str(), &end);
    const double value = !text.empty() && *end == '\0' ? bare : units::parse_quantity(text, dimension);
    if (!(value > 0.0)) throw std::invalid_argument("is not above zero");
    return value;
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(option, fmt::format("\"{}\": {}", text, error.what()));
  }
}

league::Bed asked_bed(const LeagueOptions& options) {
  if (!options.scene.empty()) return league::bed_of(load_scene(options.scene, options.overrides));
  if (options.diameter.empty() || options.density.empty())
    throw CLI::ValidationError("a bed needs both --diameter and --density, or a scene");
  league::Bed bed{
      {quantity("--diameter", options.diameter, units::length), quantity("--density", options.density, units::density)},
      {quantity("--liquid-density", options.liquid_density, units::density),
       quantity("--viscosity", options.viscosity, units::viscosity)},
      options.column.empty() ? 0.0 : quantity("--column", options.column, units::length),
      BedMotion::fluidised};
  if (!(bed.sphere.density > bed.liquid.density))
    throw CLI::ValidationError("--density", "the spheres do not sink in the liquid");
  return bed;
}

void show_league(const LeagueOptions& options) {
  std::vector<drag::DragLawKernels> user;
  std::vector<std::string> marked;
  for (const std::string& name : options.drag) {
    const drag::DragLawKernels law = find_drag_law(name);
    marked.emplace_back(law.info.name);
    if (is_varied_law(name)) user.push_back(law);
  }
  if (options.asks_for_a_bed()) {
    const league::Bed bed = asked_bed(options);
    std::vector<league::Contender> laws = league::contenders();
    for (const auto& law : user)
      for (league::Contender& contender : league::contenders_of(law)) laws.push_back(std::move(contender));
    const auto evidence = league::evidence_for(bed, laws, league::measured().lines);
    if (options.json)
      fmt::print("{}\n", league::evidence_json(evidence).dump(2));
    else
      fmt::print("{}", league::evidence_text(bed, evidence, marked));
    return;
  }
  const auto tables = league::league_tables(user);
  league::write_league(tables, options.out / "league");
  if (options.json)
    fmt::print("{}\n", league::tables_json(tables).dump(2));
  else
    fmt::print("{}\nchart and tables: {}\n", league::tables_text(tables, options.rows, marked),
               (options.out / "league").string());
}

constexpr const char* predict_examples = R"(Examples:
  slfb predict experiments/scenes/fluidised_box.toml             voidage, height, U_mf, pressure drop before any run
  slfb predict scene.toml --set "liquid.superficial_velocity=0.1 m/s"
  slfb predict scene.toml --law gidaspow-1994     by another law, with what that law has been worth
  slfb predict scene.toml --json
  slfb predict --calibration                      how often such predictions were right for measured beds left out

The law is the one with the smallest error over all measured fluidised beds (slfb league). Its bias is taken off, and its
spread over these beds makes the intervals: a measurement falls into one sigma two times of three, into two sigmas 95
times of a hundred. For a law that has to be simulated the error of the planned tier and steps is added (slfb plan); the
scatter of a run's own mean is not in it. The drag law of the scene plays no part unless --law names it.)";

struct PredictOptions {
  fs::path scene;
  std::vector<std::string> overrides;
  std::string law;
  double packed_voidage = league::packed_voidage_mean;
  bool json = false, calibration = false;
};

/// What does not exist, such as the height of a bed that is washed out, is null.
ordered_json json_of(const league::Predicted& predicted) {
  const auto number = [](double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); };
  return {{"value", number(predicted.value)},
          {"sigma", number(predicted.sigma())},
          {"one_sigma", {number(predicted.one_sigma.first), number(predicted.one_sigma.second)}},
          {"two_sigma", {number(predicted.two_sigma.first), number(predicted.two_sigma.second)}}};
}

std::string text_of(fluidisation::BedRegime regime) {
  switch (regime) {
    case fluidisation::BedRegime::packed:
      return "packed";
    case fluidisation::BedRegime::expanded:
      return "fluidised";
    case fluidisation::BedRegime::at_jump:
      return "at a jump of the law";
    case fluidisation::BedRegime::washed_out:
      return "washed out";
  }
  throw std::logic_error("unknown regime");
}

std::string summary_of(const league::Calibration& found) {
  return fmt::format(
      "{} points: {:.0f} % within one sigma, {:.0f} % within two; voidage {:.3f} off (root mean square), at most "
      "{:.3f}",
      found.points, 100.0 * found.in_one_sigma, 100.0 * found.in_two_sigma, found.root_mean_square, found.worst);
}

ordered_json json_of(const league::Calibration& found) {
  return {{"points", found.points},
          {"in_one_sigma", found.in_one_sigma},
          {"in_two_sigma", found.in_two_sigma},
          {"root_mean_square", found.root_mean_square},
          {"worst", found.worst}};
}

ordered_json json_of(const std::vector<league::Blind>& blind) {
  ordered_json json = json_of(league::calibration_of(blind));
  json["beds"] = ordered_json::array();
  for (const league::Blind& one : blind)
    json["beds"].push_back({{"bed", one.line},
                            {"law", one.law},
                            {"measured", one.measured},
                            {"predicted", one.predicted},
                            {"sigma", one.sigma},
                            {"in_one_sigma", one.in_one_sigma},
                            {"in_two_sigma", one.in_two_sigma}});
  return json;
}

/// One line for each bed: the errors at the voidages of a line, and the largest sigma.
std::string errors_text(const std::vector<league::Blind>& blind) {
  std::string text = fmt::format("    {:<24}", "predicted less measured, at");
  for (const double voidage : league::line_voidages) text += fmt::format("{:>8.1f}", voidage);
  text += fmt::format("{:>9}  law chosen without it\n", "sigma");
  constexpr std::size_t points = std::size(league::line_voidages);
  for (std::size_t first = 0; first < blind.size(); first += points) {
    text += fmt::format("    {:<27}", blind[first].line);
    double sigma = 0.0;
    for (std::size_t i = first; i < first + points; ++i) {
      text += fmt::format("{:>+8.3f}", blind[i].error());
      sigma = std::max(sigma, blind[i].sigma);
    }
    text += fmt::format("{:>9.3f}  {}\n", sigma, blind[first].law);
  }
  return text;
}

void show_calibration(bool as_json) {
  constexpr std::size_t shown_formulas = 6;
  const auto laws = league::contenders();
  const auto& lines = league::measured().lines;
  const std::string chosen = league::recommended(laws, lines).name();
  const auto left_out = league::leave_one_group_out(laws, lines), settling = league::predict_settling(laws, lines);
  const auto formulas = league::formula_choices(lines, shown_formulas);
  if (as_json) {
    ordered_json json{{"law", chosen}, {"left_out", json_of(left_out)}, {"settling", json_of(settling)}};
    for (const league::FormulaChoice& one : formulas) {
      ordered_json choice = json_of(one.left_out);
      choice["parts"] = one.parts.empty() ? ordered_json(nullptr) : ordered_json(one.parts);
      json["formulas"].push_back(std::move(choice));
    }
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("Fluidised beds, each kind of spheres and liquid predicted from the others:\n  {}\n{}",
             summary_of(league::calibration_of(left_out)), errors_text(left_out));
  fmt::print("Suspensions that settle, predicted from the fluidised beds:\n  {}\n",
             summary_of(league::calibration_of(settling)));
  fmt::print(
      "The law chosen from all: {}. Its authors fitted it to these experiments; leaving out a bed here cannot\n"
      "undo that.\n\n",
      chosen);
  fmt::print(
      "The same beds left out, with other laws for one sphere, for n and for the wall; the first are the nearest to "
      "all\n"
      "beds, the last line has the parts chosen anew for each bed left out:\n    {:<64}{:>8}{:>8}{:>7}{:>7}\n",
      "one sphere, n, wall", "r.m.s.", "worst", "in 1", "in 2");
  for (const league::FormulaChoice& one : formulas)
    fmt::print("    {:<64}{:>8.3f}{:>8.3f}{:>5.0f} %{:>5.0f} %\n", one.parts.empty() ? "chosen anew" : one.parts,
               one.left_out.root_mean_square, one.left_out.worst, 100.0 * one.left_out.in_one_sigma,
               100.0 * one.left_out.in_two_sigma);
}

void predict(const PredictOptions& options) {
  if (options.calibration) return show_calibration(options.json);
  if (options.scene.empty()) throw CLI::ValidationError("a scene is needed, or --calibration");
  const Scene scene = load_scene(options.scene, options.overrides);
  std::vector<league::Contender> laws = league::contenders();
  if (is_varied_law(options.law))
    for (league::Contender& contender : league::contenders_of(find_drag_law(options.law)))
      laws.push_back(std::move(contender));
  const auto& lines = league::measured().lines;
  const std::string name = is_varied_law(options.law) ? std::string(find_drag_law(options.law).info.name) : options.law;
  const league::Contender& law = name.empty() ? league::recommended(laws, lines) : league::find_contender(laws, name);
  double tier_error = 0.0;
  if (law.kind() == league::ContenderKind::drag_law) {
    const auto made = plan::make_plan(scene, {"voidage"}, plan::load_rules());
    if (const auto found = made.effect.find("voidage"); found != made.effect.end()) tier_error = found->second;
  }
  const league::ScenePrediction found = league::predict_scene(scene, law, options.packed_voidage, tier_error);
  const std::vector<std::tuple<std::string, std::string, const league::Predicted*>> rows{
      {"voidage", "-", &found.voidage},
      {"bed_height", "m", &found.bed_height},
      {"minimum_fluidisation_velocity", "m/s", &found.minimum_fluidisation},
      {"pressure_drop", "Pa", &found.pressure_drop}};
  if (options.json) {
    ordered_json json{{"scene", options.scene.string()},
                      {"superficial_velocity", scene.liquid.superficial_velocity},
                      {"law", law.name()},
                      {"regime", text_of(found.regime)},
                      {"tier_error", tier_error}};
    for (const auto& [id, unit, predicted] : rows) json[id] = json_of(*predicted);
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{} at {:g} m/s: {}, by {}\n\n", options.scene.string(), scene.liquid.superficial_velocity,
             text_of(found.regime), law.name());
  fmt::print("{:<36}{:>10}{:>24}{:>24}\n", "", "", "one sigma (2 of 3)", "two sigmas (95 of 100)");
  const auto range = [](std::pair<double, double> ends) {
    return fmt::format("{:.4g} to {:.4g}", ends.first, ends.second);
  };
  for (const auto& [id, unit, predicted] : rows)
    fmt::print("{:<36}{:>10.4g}{:>24}{:>24}\n", unit == "-" ? id : fmt::format("{} [{}]", id, unit), predicted->value,
               range(predicted->one_sigma), range(predicted->two_sigma));
  if (tier_error > 0.0) fmt::print("tier and steps as planned: {:.2g} % of the voidage\n", 100.0 * tier_error);
  fmt::print("\n{}", league::evidence_text(league::bed_of(scene),
                                           league::evidence_for(league::bed_of(scene), laws, lines), {law.law()}));
}

}  // namespace

void add_league_command(CLI::App& app) {
  auto options = std::make_shared<LeagueOptions>();
  CLI::App* command = app.add_subcommand("league", "Every law against all measurements that the suite holds");
  CLI::Option* scene =
      command->add_option("SCENE", options->scene, "scene file (TOML): which laws were near in beds like its")
          ->check(CLI::ExistingFile);
  command->add_option("--set", options->overrides, "replace a value of the scene: KEY=VALUE, may be repeated")
      ->allow_extra_args(false)
      ->needs(scene);
  for (const auto& [name, value, text] : std::vector<std::tuple<const char*, std::string*, const char*>>{
           {"--diameter", &options->diameter, "Of the spheres, such as 3mm"},
           {"--density", &options->density, "Of the spheres, such as 2500kg/m3"},
           {"--liquid-density", &options->liquid_density, "Of the liquid"},
           {"--viscosity", &options->viscosity, "Of the liquid"},
           {"--column", &options->column, "Inner diameter of the column (default: no walls)"}})
    command->add_option(name, *value, text)->capture_default_str()->excludes(scene);
  command->add_option("--drag", options->drag, "drag laws to show wherever they stand: names, or C++ files of your own")
      ->delimiter(',')
      ->type_name("LAW,...");
  command->add_option("--rows", options->rows, "laws shown in each table")->capture_default_str();
  command->add_option("--out", options->out, "folder of league/")->type_name("DIR")->capture_default_str();
  command->add_flag("--json", options->json, "write JSON");
  command->footer(league_examples);
  command->callback([options] {
    try {
      show_league(*options);
    } catch (const std::invalid_argument& error) {  // an unknown law, or a scene without a bed
      throw CLI::ValidationError(error.what());
    }
  });
}

void add_predict_command(CLI::App& app) {
  auto options = std::make_shared<PredictOptions>();
  CLI::App* command = app.add_subcommand(
      "predict", "Voidage, U_mf and pressure drop of a scene's bed before it runs, with how sure they are");
  command->add_option("SCENE", options->scene, "scene file (TOML)")->check(CLI::ExistingFile);
  command->add_option("--set", options->overrides, "replace a value of the scene: KEY=VALUE, may be repeated")
      ->allow_extra_args(false);
  command->add_option("--law", options->law,
                      "law of the voidage: a name of `slfb league`, or a C++ file (default: the recommended)");
  command->add_option("--packed-voidage", options->packed_voidage, "of the bed at rest")
      ->check(CLI::Range(0.26, 0.6))
      ->capture_default_str();
  command->add_flag("--calibration", options->calibration, "instead of a scene: predictions of measured beds left out");
  command->add_flag("--json", options->json, "write JSON");
  command->footer(predict_examples);
  command->callback([options] {
    try {
      predict(*options);
    } catch (const std::invalid_argument& error) {  // an unknown law, or a scene without a bed
      throw CLI::ValidationError(error.what());
    }
  });
}

}  // namespace slfb
