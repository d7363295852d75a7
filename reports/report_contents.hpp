#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the pages of the report are made of: plain values, without a link back to where they were computed.
///
/// Texts marked "markdown" are read as GitHub markdown; all others are plain sentences, in which a symbol such as U_L
/// is set with its subscript. Units are the texts shown behind a number; "-" and "" show none.
namespace slfb::reports {

/// What a number of ours says to a statement of the work.
enum class Verdict { reproduced, not_reproduced, not_decidable };

/// Whether our number still agrees with the one accepted before; `none` where nothing was accepted.
enum class Gate { holds, broken, none };

/// One statement of the work beside our number: a line of the table of claims.
struct ClaimRow {
  std::string id;        ///< "fig05.u_mf_crossing"; unique in the report
  std::string place;     ///< where the work states it: "fig05", "table2", "text"
  std::string quantity;  ///< in words
  std::string source;    ///< page and section, table or figure
  std::string unit;
  std::string paper;                              ///< the statement: "0.0424", "at most 9", "increasing"
  bool paper_in_words = false;                    ///< true: no unit stands behind the statement
  std::optional<std::pair<double, double>> band;  ///< inside: reproduced; ±infinity for an open side
  std::optional<double> paper_number;             ///< where the statement is that a quantity equals a number
  std::optional<double> ours;
  std::optional<std::pair<double, double>> interval;  ///< 95 %, of `ours`
  std::optional<double> deviation;                    ///< signed, relative: 0.05 is 5 % above
  Verdict verdict = Verdict::not_decidable;
  Gate gate = Gate::none;
  std::string reason;       ///< one sentence behind the verdict or the broken gate
  bool arithmetic = false;  ///< no statement of the work: what follows from its numbers, or what a law gives
};

/// A table of texts; every row has one per heading.
struct ShownTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;
};

/// One figure or table, which has a page of its own.
struct FigurePage {
  std::string id;                       ///< "fig05": its files are ID.svg, ID.png, ID.pdf and ID.gp
  std::string title;                    ///< plain
  std::string caption;                  ///< what is shown, and what is not known
  std::string readme;                   ///< markdown: how it is measured; "" leaves the section out
  std::vector<std::string> data_files;  ///< names of its CSV files, which lie beside the pictures
  /// What to know of the simulations behind it. Those of the form "HERE, not THERE." become rows of two columns.
  std::vector<std::string> notes;
  ShownTable table;                   ///< shown instead of the picture, unless it is empty
  std::vector<std::string> run_keys;  ///< RunRow::key of the simulations that it draws
  std::string options;                ///< of `slfb figures ID` to make it again: "--no-run", "--profile quick"
  std::vector<std::string> laws;      ///< names of the laws that it draws or that its simulations use
  std::string findings = {};          ///< markdown: what its numbers say; "" leaves the section out
};

/// One sentence of what was found, with the claims that carry it.
struct FindingRow {
  struct Claim {
    std::string id;
    Verdict stated;  ///< the verdict that the sentence was written for
    Verdict now;
  };
  std::string text;    ///< plain, its numbers filled in
  std::string figure;  ///< FigurePage::id
  std::vector<Claim> claims;

  /// Whether every claim still has the verdict that the sentence was written for.
  [[nodiscard]] bool holds() const {
    return std::ranges::all_of(claims, [](const Claim& claim) { return claim.stated == claim.now; });
  }
};

/// Who computed what, and with what.
struct Certificate {
  std::string commit;
  std::string machine;
  std::string system;                                         ///< the operating system
  std::vector<std::pair<std::string, std::string>> packages;  ///< name and version of each that the suite is built on
};

/// A data set of a result file.
struct DataSetRow {
  std::string path, unit, description;
};

/// One simulation behind the report.
struct RunRow {
  std::string key;      ///< system, superficial velocity and variant: "6mm/0.06/wen-yu-1966"
  std::string profile;  ///< the set of settings that it belongs to
  std::string name;     ///< hash of its scene
  int numerics = 0;     ///< version of the numerics that made it
  bool older_numerics = false;
  double simulated_seconds = 0.0;
  double wall_seconds = 0.0;
  int threads = 1;
  std::string machine, date;
  std::string commit;          ///< of the program that made it; empty where it is not known
  bool published = false;      ///< one of the committed results, not one of this machine
  std::filesystem::path file;  ///< HDF5 result; the report offers a copy where it exists
  std::string download;        ///< name of that copy in the folder runs/ of the report
};

/// A place where the work disagrees with itself or with a law that it names.
struct InconsistencyRow {
  std::string id;           ///< "particle_density"
  std::string subject;      ///< "density of the fluidised glass"
  std::string source;       ///< where the work prints its number
  double paper = 0.0;       ///< the printed number
  double recomputed = 0.0;  ///< what the other numbers of the work, or the law it names, give
  std::string unit;
  std::string explanation;  ///< one sentence with every number in it computed
};

/// A quantity that runs, laws and claims are compared by.
struct QuantityRow {
  std::string id;  ///< "classification_velocity"
  std::string title;
  std::string unit;
  std::string definition;
  std::string contact_stiffness;  ///< how it depends on the contact stiffness, in words
};

/// A figure page that the navigation of every page names.
struct FeaturedPage {
  std::string figure;  ///< FigurePage::id
  std::string label;
};

/// What the work that is reproduced says of itself.
struct WorkTexts {
  std::string title;          ///< heading of the first page
  std::string introduction;   ///< markdown: what was done, by whom, with a link to the source
  std::string about_figures;  ///< markdown: how to read the figures
  std::string methods;        ///< markdown: page "Methods"
  std::vector<FeaturedPage> featured;
};

/// Everything that the report shows, beside the catalogue of laws.
struct ReportContents {
  WorkTexts texts;
  std::string profile;                   ///< name of the settings of the simulations
  std::vector<std::string> differences;  ///< of these settings from those of the work, a sentence each
  std::size_t runs_wanted = 0;           ///< simulations of the profile …
  std::size_t runs_available = 0;        ///< … and how many of them have a result
  int numerics_version = 0;
  Certificate certificate;
  std::string citation;  ///< how to cite the suite, CITATION.cff
  std::vector<FindingRow> findings;
  std::vector<ClaimRow> claims;
  std::vector<FigurePage> figures;  ///< in the order of the work
  std::vector<RunRow> runs;
  std::vector<InconsistencyRow> inconsistencies;
  std::vector<QuantityRow> quantities;
  std::vector<DataSetRow> data_sets;
  std::string claims_json;  ///< offered as claims.json
};

}  // namespace slfb::reports
