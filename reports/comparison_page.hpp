#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/compare/candidates.hpp"
#include "experiments/compare/drag_figures.hpp"

/// The parts of a comparison's report that do not depend on what is compared.
namespace slfb::compare {

/// One part of the page, linked from its head.
struct Section {
  std::string id, title, html;
};

/// An HTML table that folds up on a phone. The cells are HTML; the first of a row leads it.
std::string table_html(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows);

/// "✓ text" or "✗ text" as a badge with what was found below it.
std::string badge_html(bool good, const std::string& word, const std::string& found);

std::string pictures_html(const std::vector<Picture>& pictures);

/// Each claim that some candidate answers: paper, every candidate with its interval and verdict, what got better and
/// what worse beside the first.
Section claims_section(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims);

/// What the runs of each candidate cost beside those of the first.
Section cost_section(const std::vector<Candidate>& candidates, const std::string& extra_html);

/// {"candidates": […], "claims": [{"id", "paper", "answers": {NAME: {"ours", "interval", "verdict", "change"}}}]}.
nlohmann::ordered_json candidates_json(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims);

/// claims.csv: one line per claim and candidate.
void write_claims_csv(const std::vector<Candidate>& candidates, const std::vector<Claim>& claims,
                      const std::filesystem::path& folder);

/// Writes `folder`/index.html.
void write_page(const std::string& title, const std::string& introduction, const std::vector<Section>& sections,
                const std::filesystem::path& folder);

}  // namespace slfb::compare
