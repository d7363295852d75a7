#include "experiments/work/report_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "correlations/catalogue.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/certificate.hpp"
#include "experiments/work/findings.hpp"
#include "solver/io/run_result.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

reports::Gate shown(Gate gate) {
  switch (gate) {
    case Gate::holds:
      return reports::Gate::holds;
    case Gate::broken:
      return reports::Gate::broken;
    case Gate::none:
      return reports::Gate::none;
  }
  throw std::logic_error("report_pages: unknown gate");
}

const Figure& figure_named(const std::vector<Figure>& figures, const std::string& id) {
  const auto found = std::ranges::find(figures, id, &Figure::id);
  if (found == figures.end()) throw std::runtime_error("no figure is called " + id);
  return *found;
}

/// A study may have a profile of its own, which then has its name.
bool has_own_profile(const Work& work, const Figure& figure) {
  const std::vector<std::string> names = profile_names(work);
  return std::ranges::find(names, figure.id) != names.end();
}

std::string readme(const Figure& figure) {
  const fs::path file = source_folder() / "experiments" / figure.folder / "README.md";
  return figure.folder.empty() || !fs::exists(file) ? "" : figure_definitions(read_file(file));
}

/// Names of the catalogue's laws that the script of a drawn figure or the scenes of its runs name.
std::vector<std::string> laws_of(const FigureOutput& output, const std::vector<std::string>& run_keys,
                                 const ReportInputs& inputs) {
  const fs::path script = inputs.out / "figures" / (output.id + ".gp");
  std::string text = fs::exists(script) ? read_file(script) : "";
  for (const FinishedRun& run : inputs.runs)
    if (std::ranges::find(run_keys, run_key(run.spec)) != run_keys.end())
      text += fmt::format(" {} {}", run.scene.coupling.drag_law, run.scene.contact.law);
  std::vector<std::string> laws;
  for (const CatalogueEntry& law : catalogue())
    if (text.find(law.info.name) != std::string::npos) laws.emplace_back(law.info.name);
  return laws;
}

reports::ShownTable shown_table(const TextTable& table) {
  reports::ShownTable shown{{}, table.rows};
  for (const auto& [first, second] : table.headings)
    shown.headings.push_back(first.empty() ? second : first + " " + second);
  return shown;
}

reports::FigurePage figure_page(const FigureOutput& output, const ReportInputs& inputs) {
  const Work& work = inputs.work;
  const Figure& figure = figure_named(work.figures, output.id);
  const bool own_profile = has_own_profile(work, figure);
  reports::FigurePage page;
  page.id = output.id;
  page.title = figure.title;
  page.caption = output.caption;
  page.readme = readme(figure);
  page.notes = output.notes;
  page.table = shown_table(output.table);
  page.findings = output.findings;
  for (const fs::path& data : output.data) page.data_files.push_back(data.filename().string());
  page.run_keys = figure.needs(inputs.judgement.shown);
  if (page.run_keys.empty() && own_profile) page.run_keys = figure.needs(load_profile(work, figure.id));
  const Profile& asked = inputs.judgement.profile;
  const std::string profile = !figure.needs(asked).empty() ? asked.name : own_profile ? figure.id : work.shown_beside;
  page.options = page.run_keys.empty() ? "--no-run" : "--profile " + profile;
  page.laws = laws_of(output, page.run_keys, inputs);
  return page;
}

}  // namespace

reports::Verdict shown(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return reports::Verdict::reproduced;
    case Verdict::not_reproduced:
      return reports::Verdict::not_reproduced;
    case Verdict::not_decidable:
      return reports::Verdict::not_decidable;
  }
  throw std::logic_error("report_pages: unknown verdict");
}

reports::ClaimRow claim_row(const Evaluation& evaluation) {
  const Claim& claim = evaluation.claim;
  reports::ClaimRow row;
  row.id = claim.id;
  row.place = claim.figure;
  row.quantity = claim.quantity;
  row.source = claim.source;
  row.unit = claim.unit;
  row.paper = claim.paper_text();
  row.paper_in_words = claim.kind == StatementKind::increasing || claim.kind == StatementKind::decreasing ||
                       claim.kind == StatementKind::words;
  if (claim.paper_band) row.band = {claim.paper_band->lower, claim.paper_band->upper};
  if (claim.kind == StatementKind::value) row.paper_number = claim.paper;
  row.ours = evaluation.ours;
  row.interval = evaluation.interval;
  row.deviation = evaluation.deviation;
  row.verdict = shown(evaluation.verdict);
  row.gate = shown(evaluation.gate);
  row.reason = evaluation.reason;
  row.arithmetic = claim.origin == Origin::arithmetic;
  return row;
}

reports::RunRow run_row(const FinishedRun& run, const fs::path& out) {
  const fs::path published = published_file(run.spec);
  reports::RunRow row;
  row.key = run_key(run.spec);
  row.profile = run.spec.profile;
  row.name = run.result.name;
  row.numerics = run.result.numerics;
  row.older_numerics = run.stale;
  row.simulated_seconds = run.result.simulated_seconds;
  row.wall_seconds = run.result.wall_seconds;
  row.threads = run.result.threads;
  row.machine = run.result.machine;
  row.date = run.result.date;
  row.commit = run.result.commit;
  row.published = run.published;
  row.file = run.published ? published : result_file(out, run.result.name);
  row.download = fmt::format("{}_{}", published.parent_path().filename().string(), published.filename().string());
  return row;
}

reports::ReportContents report_contents(const ReportInputs& inputs) {
  const Work& work = inputs.work;
  const Profile& profile = inputs.judgement.profile;
  reports::ReportContents contents;
  if (work.texts) contents.texts = work.texts();
  contents.profile = profile.name;
  contents.differences = profile.differences;
  std::set<std::string> wanted, available;
  for (const RunSpec& spec : profile.runs) wanted.insert(run_key(spec));
  for (const FinishedRun& run : inputs.runs)
    if (wanted.contains(run_key(run.spec))) available.insert(run_key(run.spec));
  contents.runs_wanted = wanted.size();
  contents.runs_available = available.size();
  contents.numerics_version = numerics_version;
  contents.certificate = certificate();
  if (const fs::path citation = source_folder() / "CITATION.cff"; fs::exists(citation))
    contents.citation = read_file(citation);
  contents.findings = findings(work, inputs.judgement.evaluations);
  for (const ResultDataSet& set : result_data_sets())
    contents.data_sets.push_back({set.path, set.unit, set.description});
  for (const Evaluation& evaluation : inputs.judgement.evaluations) contents.claims.push_back(claim_row(evaluation));
  for (const FigureOutput& output : inputs.outputs) contents.figures.push_back(figure_page(output, inputs));
  for (const FinishedRun& run : inputs.runs) contents.runs.push_back(run_row(run, inputs.out));
  if (work.inconsistencies) contents.inconsistencies = work.inconsistencies();
  for (const Quantity& quantity : work.measuring.quantities)
    contents.quantities.push_back(
        {quantity.id, quantity.title, quantity.unit, quantity.definition,
         quantity.depends_on_contact_stiffness ? "changes with it" : "does not change with it"});
  contents.claims_json = claims_json(inputs.judgement.evaluations).dump(2) + "\n";
  return contents;
}

}  // namespace slfb
