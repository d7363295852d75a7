#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "correlations/law_parameters.hpp"
#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/compare/bed_figures.hpp"
#include "experiments/compare/contact_report.hpp"
#include "experiments/compare/drag_report.hpp"
#include "experiments/league/league_report.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "reports/html.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/scene/scene_description.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;
using compare::Candidate;
using compare::ComparisonBed;
using compare::Tier;

constexpr const char* examples = R"(Examples:
  slfb compare --template drag > mine.cpp             a law to start from; change its formula and its name
  slfb compare --drag mine.cpp                        beside the paper's law, gidaspow-1994
  slfb compare --drag gidaspow-1994,di-felice-1994,mine.cpp --tier correlation
  slfb compare --drag mine.cpp --tier 3d --experiments fig10,table2
  slfb compare --drag ergun-1952 ergun-1952:viscous=180 ergun-1952:viscous=180,inertial=1.8   sweep its constants
  slfb compare --template contact > contact.cpp       a contact law to start from
  slfb compare --contact linear,hertz,contact.cpp
  slfb compare --contact linear "linear:stiffness=4e3 N/m,time_step=5e-5 s" --tier correlation
  slfb compare --void-fraction exact-overlap,particle-meshing,centroid

The first of a list is what the others are compared with. Laws take parameters: LAW:KEY=VALUE,KEY=VALUE. Those of a drag
law are its constants, which `slfb law LAW` lists and a file declares; those of a contact law are keys of [contact] of a
scene, and `hertz` alone has the modulus that makes collisions of the bed as long as those of `linear`.

Tiers: `correlation` simulates no bed (seconds: formulas, and collisions of two bodies); `1d` drops the sphere through
a slice of the bed in a one-dimensional liquid (about a minute); `3d` is the bed of the paper with the settings of the
profile quick (minutes per law and velocity). Simulations are kept in DIR/runs and not repeated; the report lies in
DIR/compare/KIND/NAMES/index.html, with the figures, claims.csv and compare.json beside it; what the terminal shows
stands at its top. A law from a file is compiled when it is used: that needs a C++20 compiler, $CXX or the one that built slfb.)";

struct Options {
  std::string work;
  std::vector<std::string> drag, contact, void_fraction, experiments;
  std::string template_kind;
  std::string tier = "1d";
  std::vector<double> velocities;
  fs::path out = build_folder();
  int jobs = 0;
  int threads = 1;
};

const std::vector<std::pair<std::string, Tier>> tiers{
    {"correlation", Tier::correlation}, {"1d", Tier::one_dimensional}, {"3d", Tier::three_dimensional}};

Tier tier_named(const std::string& name) {
  return std::ranges::find(tiers, name, &std::pair<std::string, Tier>::first)->second;
}

std::string about_tier(const ComparisonBed& bed, Tier tier, const std::vector<RunSpec>& runs) {
  if (tier == Tier::correlation) return "No bed was simulated.";
  std::vector<std::string> velocities;
  for (const RunSpec& run : runs) velocities.push_back(fmt::format("{:.2f}", run.superficial_velocity));
  const std::string at = fmt::format(" At {} m/s.", fmt::join(velocities, ", "));
  return (tier == Tier::one_dimensional ? bed.about_one_dimensional : bed.about_three_dimensional) + at;
}

/// What is asked for: the bed, and the claims and runs chosen from it.
struct Question {
  ComparisonBed bed;
  Tier tier;
  std::vector<Claim> claims;
  std::vector<RunSpec> runs;
};

Question question(const Work& work, const Options& options) {
  if (!work.comparison_bed)
    throw std::invalid_argument(fmt::format("--work {}: it hands over no bed to compare laws in", work.id));
  Question asked{work.comparison_bed(), tier_named(options.tier), {}, {}};
  asked.claims = compare::claims_of_runs(asked.bed, options.experiments);
  asked.runs = compare::runs_of(asked.bed, asked.tier, asked.claims, options.velocities);
  return asked;
}

/// What the candidates are, and what to say of them before and beside the simulations.
struct Comparison {
  std::string kind;  ///< "drag"
  std::string title;
  std::vector<Candidate> candidates;
};

/// Where the report of a comparison lies: a folder for each set of candidates, tier, claims and velocities.
fs::path folder_of(const Comparison& comparison, const Options& options) {
  std::vector<std::string> names;
  for (const Candidate& candidate : comparison.candidates) names.push_back(candidate.name);
  std::string name = fmt::format("{}_{}", fmt::join(names, "+"), options.tier);
  if (!options.experiments.empty()) name += fmt::format("_{}", fmt::join(options.experiments, "+"));
  if (!options.velocities.empty()) name += fmt::format("_{}", fmt::join(options.velocities, "+"));
  const std::string identity = name;
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter)) &&
        std::string_view("-_.=+,").find(letter) == std::string::npos)
      letter = '_';
  constexpr std::size_t longest = 120;
  // Names of many laws are too long for a folder, and others differ only in what a folder's name cannot have.
  if (name.size() > longest || name != identity)
    name = fmt::format("{}-{:08x}", name.substr(0, longest),
                       static_cast<std::uint32_t>(XXH3_64bits(identity.data(), identity.size())));
  return options.out / "compare" / comparison.kind / name;
}

/// Runs the simulations and fills the candidates. Everything is checked before anything is computed.
CampaignOutcome compute(Comparison& comparison, const Question& asked, const Options& options) {
  const std::vector<RunSpec>& runs = asked.runs;
  double core_seconds = 0.0;
  for (const Candidate& candidate : comparison.candidates)
    for (RunSpec run : runs) {
      run.overrides.insert(run.overrides.end(), candidate.overrides.begin(), candidate.overrides.end());
      const Scene scene = load_run_scene(run);
      if (!fs::exists(result_file(options.out, scene_hash(scene)))) core_seconds += estimate_run(scene).core_seconds;
    }
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = options.jobs > 0 ? options.jobs : std::max(1, cores / options.threads);
  CampaignOutcome outcome;
  if (asked.tier != Tier::correlation) {
    fmt::print(stderr, "{} simulations, about {} on {} core{}\n", comparison.candidates.size() * runs.size(),
               format_duration(core_seconds / (jobs * options.threads)), jobs * options.threads,
               jobs * options.threads == 1 ? "" : "s");
    outcome = compare::simulate(asked.bed, comparison.candidates, runs,
                                {.out = options.out, .jobs = jobs, .threads_per_run = options.threads});
  }
  compare::evaluate_candidates(comparison.candidates, asked.claims);
  return outcome;
}

/// What the terminal shows at the end and the page at its top: names, then a column per candidate.
class Summary {
 public:
  explicit Summary(std::vector<std::string> candidates) : candidates_(std::move(candidates)) {}

  void add(std::string name, std::vector<std::string> cells) { rows_.push_back({std::move(name), std::move(cells)}); }
  [[nodiscard]] const std::vector<std::string>& candidates() const { return candidates_; }

  void print() const {
    std::size_t width = 20;
    for (const std::string& name : candidates_) width = std::max(width, name.size() + 2);
    const auto line = [width](const std::string& name, const std::vector<std::string>& cells) {
      fmt::print("{:<38}", name);
      for (const std::string& cell : cells) fmt::print("{:>{}}", cell, width);
      fmt::print("\n");
    };
    line("", candidates_);
    for (const Row& row : rows_) line(row.name, row.cells);
  }

  [[nodiscard]] compare::Section section() const {
    std::vector<std::string> headings{""};
    for (const std::string& name : candidates_) headings.push_back(escape_html(name));
    std::vector<std::vector<std::string>> rows;
    for (const Row& row : rows_) {
      std::vector<std::string>& cells = rows.emplace_back();
      cells.push_back(escape_html(row.name));
      for (const std::string& cell : row.cells) cells.push_back(escape_html(cell));
    }
    return {"summary", "Summary", table_html(headings, rows)};
  }

 private:
  struct Row {
    std::string name;
    std::vector<std::string> cells;
  };
  std::vector<std::string> candidates_;
  std::vector<Row> rows_;
};

void write_report(const Comparison& comparison, const Summary& summary, const Question& asked,
                  std::vector<compare::Section> sections, const std::string& extra_cost,
                  const nlohmann::ordered_json& extra_json, const CampaignOutcome& outcome, const fs::path& folder) {
  const auto& [bed, tier, claims, runs] = asked;
  sections.insert(sections.begin(), summary.section());
  if (!outcome.failures.empty()) sections.push_back(compare::failure_section(outcome.failures));
  if (tier != Tier::correlation || comparison.kind == "drag")
    sections.push_back(compare::claims_section(comparison.candidates, claims));
  sections.push_back(compare::cost_section(comparison.candidates, extra_cost));
  compare::write_page(
      comparison.title,
      fmt::format("<p>{}. {}</p>", escape_html(fmt::format("{}", fmt::join(summary.candidates(), ", "))),
                  about_tier(bed, tier, runs)),
      sections, folder);
  compare::write_claims_csv(comparison.candidates, claims, folder);
  nlohmann::ordered_json answer = compare::candidates_json(comparison.candidates, claims);
  if (!extra_json.is_null()) answer["laws"] = extra_json;
  write_file(folder / "compare.json", answer.dump(2) + "\n");
}

void add_candidates(Summary& summary, const std::vector<Candidate>& candidates) {
  using compare::Change;
  for (const Change which : {Change::better, Change::worse, Change::same, Change::undecided}) {
    std::vector<std::string> cells{"-"};
    for (std::size_t i = 1; i < candidates.size(); ++i)
      cells.push_back(fmt::format("{}", compare::count_changes(candidates[0], candidates[i])[which]));
    summary.add(fmt::format("claims {}", to_string(which)), cells);
  }
  std::vector<std::string> cells;
  for (const Candidate& candidate : candidates)
    cells.push_back(
        candidate.runs == 0 ? "-" : fmt::format("{:.3g} s", candidate.core_seconds / candidate.simulated_seconds));
  summary.add("core time per simulated second", cells);
}

void print_missing_properties(const std::string& law, const std::vector<compare::PropertyCheck>& properties) {
  for (const auto& check : properties)
    if (!check.holds) fmt::print("{}: not so: {} ({})\n", law, check.property, check.found);
}

void print_range_notes(const std::vector<compare::RangeNotes>& notes) {
  for (const auto& [law, sentences] : notes)
    for (const std::string& sentence : sentences) fmt::print("{}: outside its range: {}\n", law, sentence);
}

int finish(const CampaignOutcome& outcome, const fs::path& folder) {
  fmt::print("\nreport: {}\n", (folder / "index.html").string());
  if (outcome.unfinished() > 0)
    fmt::print(stderr,
               "{} of the simulations did not finish; the report shows what exists. The same command goes on.\n",
               outcome.unfinished());
  return outcome.exit_status();
}

/// The league with the laws of the user, and those with parameters, among those of the suite.
std::vector<league::Table> league_of(const std::vector<compare::ComparedDragLaw>& laws) {
  std::vector<drag::DragLawKernels> user;
  for (const auto& compared : laws)
    if (is_varied_law(compared.argument)) user.push_back(compared.law);
  return league::league_tables(user);
}

/// Place and root mean square of each law in the league, one line for each kind of measurement that has drag laws.
void add_places(Summary& summary, const std::vector<league::Table>& tables) {
  const std::vector<std::string>& laws = summary.candidates();
  for (const league::Table& table : tables) {
    std::vector<std::string> cells;
    for (const std::string& law : laws) {
      const auto found = std::ranges::find(table.standings, law, &league::Standing::law);
      if (found == table.standings.end()) continue;
      cells.push_back(found->without_answer > 0
                          ? "no answer"
                          : fmt::format("{} of {}, {:.0f} %", found - table.standings.begin() + 1,
                                        table.standings.size(), 100.0 * found->statistic.root_mean_square));
    }
    if (cells.size() == laws.size()) summary.add("measured: " + table.regime.id, cells);
  }
}

int compare_drag(const Work& work, const Options& options) {
  const Question asked = question(work, options);
  const ComparisonBed& bed = asked.bed;
  std::vector<std::string> arguments = options.drag;
  if (arguments.size() == 1 && arguments[0] != bed.drag_law) arguments.insert(arguments.begin(), bed.drag_law);
  const auto laws = compare::compared_drag_laws(arguments);
  if (laws.size() < 2)
    throw std::invalid_argument(
        fmt::format("--drag {}: nothing to compare the paper's law with; name another law too", bed.drag_law));
  Comparison comparison{"drag", "Drag laws side by side", {}};
  std::vector<compare::DragFindings> findings;
  for (const auto& compared : laws) {
    Candidate candidate{compared.name(), {"coupling.drag_law=" + compared.argument}, {}, {}};
    if (asked.tier == Tier::correlation) candidate.measurements = compare::measure_homogeneous_bed(compared.law, bed);
    comparison.candidates.push_back(std::move(candidate));
    findings.push_back(compare::characterise(compared.law, bed));
  }
  const CampaignOutcome outcome = compute(comparison, asked, options);

  const fs::path folder = folder_of(comparison, options);
  auto sections = compare::drag_sections(laws, findings, comparison.candidates, bed, folder);
  std::vector<compare::RangeNotes> notes;
  for (std::size_t i = 0; i < laws.size(); ++i)
    notes.push_back(
        {laws[i].name(), compare::uses_outside_range(laws[i].law, bed, comparison.candidates[i].measurements)});
  sections.push_back(compare::range_section(notes));
  const std::vector<league::Table> tables = league_of(laws);
  std::vector<std::string> in_league;
  for (const auto& compared : laws) in_league.push_back(compared.name());
  sections.push_back({"league", "Against measurements", league::places_html(tables, in_league)});
  std::vector<std::string> properties, fluidisation, classification, nanoseconds;
  const double velocity = bed.tabulated_velocities.back();
  for (std::size_t i = 0; i < laws.size(); ++i) {
    properties.push_back(fmt::format("{} of {}",
                                     std::ranges::count(findings[i].properties, true, &compare::PropertyCheck::holds),
                                     findings[i].properties.size()));
    fluidisation.push_back(fmt::format("{:.4g}", findings[i].minimum_fluidisation));
    classification.push_back(
        fmt::format("{:.4g}", compare::homogeneous_bed(laws[i].law, bed, velocity).classification_velocity));
    nanoseconds.push_back(fmt::format("{:.1f} ns", 1e9 * findings[i].seconds_per_evaluation));
  }
  Summary summary(in_league);
  summary.add("properties that hold", properties);
  summary.add("U_mf [m/s]", fluidisation);
  summary.add(fmt::format("V_2 by force balance at {:.2f} m/s [m/s]", velocity), classification);
  summary.add("one evaluation", nanoseconds);
  add_places(summary, tables);
  add_candidates(summary, comparison.candidates);
  write_report(comparison, summary, asked, sections, compare::evaluation_cost_html(laws, findings),
               compare::drag_json(laws, findings, bed), outcome, folder);

  summary.print();
  for (std::size_t i = 0; i < laws.size(); ++i) print_missing_properties(laws[i].name(), findings[i].properties);
  print_range_notes(notes);
  return finish(outcome, folder);
}

int compare_contact(const Work& work, const Options& options) {
  const Question asked = question(work, options);
  const ComparisonBed& bed = asked.bed;
  std::vector<std::string> arguments = options.contact;
  if (arguments.size() == 1 && arguments[0] != bed.contact_law) arguments.insert(arguments.begin(), bed.contact_law);
  if (arguments.size() < 2)
    throw std::invalid_argument(
        fmt::format("--contact {}: nothing to compare it with; name another law too, or parameters", bed.contact_law));
  // Without a simulation of the bed, the contacts are still those of the slice.
  const RunSpec scene = asked.runs.empty()
                            ? compare::runs_of(bed, Tier::one_dimensional, asked.claims, options.velocities).front()
                            : asked.runs.front();
  const auto laws = compare::compared_contact_laws(arguments, scene, bed);
  Comparison comparison{"contact", "Contact laws side by side", {}};
  std::vector<compare::ContactFindings> findings;
  for (const auto& law : laws) {
    comparison.candidates.push_back({law.name, law.overrides, {}, {}});
    findings.push_back(compare::characterise(law, bed));
  }
  const CampaignOutcome outcome = compute(comparison, asked, options);

  const fs::path folder = folder_of(comparison, options);
  auto sections = compare::contact_sections(laws, findings, comparison.candidates, bed, folder);
  std::vector<compare::RangeNotes> notes;
  for (std::size_t i = 0; i < laws.size(); ++i)
    notes.push_back({laws[i].name, compare::uses_outside_range(laws[i], bed, comparison.candidates[i].measurements)});
  sections.push_back(compare::range_section(notes));
  std::vector<std::string> names;
  for (const auto& law : laws) names.push_back(law.name);
  Summary summary(names);
  const auto row = [&](const std::string& name, auto cell) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < laws.size(); ++i) cells.push_back(cell(laws[i], findings[i]));
    summary.add(name, cells);
  };
  using Law = compare::ComparedContactLaw;
  using Found = compare::ContactFindings;
  row("properties that hold", [](const Law&, const Found& found) {
    return fmt::format("{} of {}", std::ranges::count(found.properties, true, &compare::PropertyCheck::holds),
                       found.properties.size());
  });
  row("restitution at 0.1 m/s",
      [](const Law&, const Found& found) { return fmt::format("{:.4f}", found.usual.restitution); });
  row("  with the step of the scene", [](const Law&, const Found& found) {
    return fmt::format("{:.4f} to {:.4f}", found.usual_at_step.lowest, found.usual_at_step.highest);
  });
  row("contact time [s]", [](const Law&, const Found& found) { return fmt::format("{:.3g}", found.usual.duration); });
  row("peak force [N]", [](const Law&, const Found& found) { return fmt::format("{:.3g}", found.usual.peak_force); });
  row("steps per contact", [](const Law& law, const Found& found) {
    return fmt::format("{:.1f}", found.usual.duration / law.contact.time_step);
  });
  row("largest stable step 2/ω [s]",
      [](const Law&, const Found& found) { return fmt::format("{:.3g}", found.stability_limit); });
  row("one contact",
      [](const Law&, const Found& found) { return fmt::format("{:.1f} ns", 1e9 * found.seconds_per_contact); });
  if (asked.tier != Tier::correlation) add_candidates(summary, comparison.candidates);
  write_report(comparison, summary, asked, sections, compare::contact_cost_html(laws, findings),
               compare::contact_json(laws, findings), outcome, folder);

  summary.print();
  for (std::size_t i = 0; i < laws.size(); ++i) print_missing_properties(laws[i].name, findings[i].properties);
  print_range_notes(notes);
  return finish(outcome, folder);
}

int compare_void_fraction(const Work& work, const Options& options) {
  std::vector<std::string> known;
  for (const auto& choice : description::void_fractions) known.emplace_back(choice.word);
  for (const std::string& name : options.void_fraction)
    if (std::ranges::find(known, name) == known.end())
      throw std::invalid_argument(
          fmt::format("--void-fraction: unknown scheme \"{}\"; known: {}", name, fmt::join(known, ", ")));
  if (std::set<std::string>(options.void_fraction.begin(), options.void_fraction.end()).size() <
      options.void_fraction.size())
    throw std::invalid_argument(
        fmt::format("--void-fraction {}: a scheme is compared twice", fmt::join(options.void_fraction, ",")));
  if (options.void_fraction.size() < 2)
    throw std::invalid_argument(
        fmt::format("--void-fraction: needs two schemes or more; known: {}", fmt::join(known, ", ")));
  if (tier_named(options.tier) == Tier::correlation)
    throw std::invalid_argument(
        "--tier correlation: a void-fraction scheme exists in simulations only; allowed are 1d and 3d");
  const Question asked = question(work, options);
  Comparison comparison{"void-fraction", "Void-fraction schemes side by side", {}};
  for (const std::string& name : options.void_fraction)
    comparison.candidates.push_back({name, {"coupling.void_fraction=" + name}, {}, {}});
  const CampaignOutcome outcome = compute(comparison, asked, options);
  const fs::path folder = folder_of(comparison, options);
  std::vector<compare::Section> sections{
      {"bed", "In the bed",
       "<p>What the runs measured, beside the paper and the correlations.</p>\n" +
           compare::pictures_html(compare::draw_bed_pictures(comparison.candidates, asked.bed, folder / "figures"))}};
  Summary summary(options.void_fraction);
  add_candidates(summary, comparison.candidates);
  write_report(comparison, summary, asked, sections, "", nullptr, outcome, folder);
  summary.print();
  return finish(outcome, folder);
}

/// Each of them alone, of words that hold one or more, "A,B:KEY=1,KEY=2".
std::vector<std::string> laws_in(const std::vector<std::string>& words) {
  std::vector<std::string> laws;
  for (const std::string& word : words)
    for (std::string& law : split_laws(word)) laws.push_back(std::move(law));
  return laws;
}

}  // namespace

void add_compare_command(CLI::App& app, const Works& works) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Compare laws, also your own, in formulas and in simulations");
  std::vector<std::string> tier_names;
  for (const auto& [name, tier] : tiers) tier_names.push_back(name);
  auto* drag = command
                   ->add_option("--drag", options->drag,
                                "drag laws: names from `slfb laws --kind drag`, or C++ files, each with parameters")
                   ->type_name("LAW[:KEY=VALUE,...],...");
  auto* contact =
      command
          ->add_option("--contact", options->contact, "contact laws: linear, hertz, or C++ files, each with parameters")
          ->type_name("LAW[:KEY=VALUE,...],...");
  auto* void_fraction = command->add_option("--void-fraction", options->void_fraction, "void-fraction schemes")
                            ->delimiter(',')
                            ->type_name("SCHEME,...");
  auto* print_template =
      command
          ->add_option("--template", options->template_kind, "print a file to start an own law from: drag or contact")
          ->check(CLI::IsMember({"drag", "contact"}));
  drag->excludes(contact)->excludes(void_fraction)->excludes(print_template);
  contact->excludes(void_fraction)->excludes(print_template);
  void_fraction->excludes(print_template);
  add_work_option(*command, works, options->work);
  command->add_option("--tier", options->tier, "how much to simulate: correlation, 1d or 3d")
      ->check(CLI::IsMember(tier_names))
      ->capture_default_str();
  command
      ->add_option("--experiments", options->experiments,
                   "only claims whose id begins so, such as fig10 (default: all)")
      ->delimiter(',')
      ->type_name("ID,...");
  command->add_option("--velocities", options->velocities, "superficial velocities of the runs [m/s]")
      ->delimiter(',')
      ->type_name("U,...");
  command->add_option("--out", options->out, "folder of runs/ and compare/")->type_name("DIR")->capture_default_str();
  command->add_option("--jobs", options->jobs, "simulations side by side (default: cores over threads)")
      ->check(above_zero());
  command->add_option("--threads", options->threads, "threads of each simulation")
      ->check(above_zero())
      ->capture_default_str();
  command->footer(examples);
  command->callback([options, &works] {
    int status = 0;
    try {
      const Work& work = find_work(works, options->work);
      for (auto* list : {&options->drag, &options->contact}) *list = laws_in(*list);
      if (!options->template_kind.empty()) {
        std::cout << read_file(source_folder() / "experiments" / "compare" / "templates" /
                               (options->template_kind + "_law.cpp"));
      } else if (!options->drag.empty()) {
        status = compare_drag(work, *options);
      } else if (!options->contact.empty()) {
        status = compare_contact(work, *options);
      } else if (!options->void_fraction.empty()) {
        status = compare_void_fraction(work, *options);
      } else {
        throw CLI::ValidationError("needed is one of --drag, --contact, --void-fraction and --template");
      }
    } catch (const std::invalid_argument& error) {  // an unknown name
      throw CLI::ValidationError(error.what());
    }
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
