#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/compare/candidates.hpp"
#include "experiments/compare/property_check.hpp"

/// The parts of a comparison's report that do not depend on what is compared. Texts are plain unless it is said that
/// they are HTML; a `Section` holds HTML.
namespace slfb::compare {

/// A picture of a comparison: ID.svg, ID.png, ID.csv and ID.gp in the folder figures/ of the report, and what it shows.
struct Picture {
  std::string id, title, caption;
};

/// One part of the page, linked from its head.
struct Section {
  std::string id, title, html;
};

/// "✓ word" or "✗ word" as a badge with what was found below it (HTML).
std::string badge_html(bool good, const std::string& word, const std::string& found);

/// Which law has which of the properties, the laws side by side; `checks` by law.
Section property_section(const std::vector<std::string>& laws, const std::vector<std::vector<PropertyCheck>>& checks,
                         const std::string& introduction);

/// Sentences about each law that is used outside its range; empty without any.
struct RangeNotes {
  std::string law;
  std::vector<std::string> sentences;
};
Section range_section(const std::vector<RangeNotes>& notes);

/// The runs that failed, "label: reason" each.
Section failure_section(const std::vector<std::string>& failures);

/// What one call of each law takes [s], beside the first (HTML). `what`: a sentence above the table.
std::string time_html(const std::string& what, const std::vector<std::string>& laws,
                      const std::vector<double>& seconds);

/// The pictures one below the other, with their files (HTML).
std::string pictures_html(const std::vector<Picture>& pictures);

/// Each claim that some candidate answers: paper, every candidate with its interval and verdict, what got better and
/// what worse beside the first.
Section claims_section(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims);

/// What the runs of each candidate cost beside those of the first. `extra_html` (HTML) stands above the table.
Section cost_section(const std::vector<Candidate>& candidates, const std::string& extra_html);

/// {"candidates": […], "claims": [{"id", "paper", "answers": {NAME: {"ours", "interval", "verdict", "change"}}}]}.
nlohmann::ordered_json candidates_json(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims);

/// Writes `folder`/claims.csv: one line per claim and candidate. Throws std::runtime_error where it cannot be written.
void write_claims_csv(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims,
                      const std::filesystem::path& folder);

/// Writes `folder`/index.html; `introduction` is HTML. Throws std::runtime_error where it cannot be written.
void write_page(const std::string& title, const std::string& introduction, const std::vector<Section>& sections,
                const std::filesystem::path& folder);

}  // namespace slfb::compare
