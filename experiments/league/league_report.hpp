#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/figures/figure.hpp"
#include "experiments/league/prediction.hpp"
#include "experiments/league/standings.hpp"

/// The league as text, table, chart and page.
namespace slfb::league {

/// The tables of the league as text: the first `rows` laws of each, and those of `marked` wherever they stand.
std::string tables_text(const std::vector<Table>& tables, std::size_t rows, const std::vector<std::string>& marked);

/// "for your bed …": the laws that were near in the near measured beds, the others, and the beds.
std::string evidence_text(const Bed& bed, const std::vector<Evidence>& evidence,
                          const std::vector<std::string>& marked);

/// {"tables": [{"id", "title", "kind", "measured_spread", "laws": [{"law", "points", "groups", "bias", "spread",
/// "spread_interval", "mean", "mean_half_width", "root_mean_square", "without_answer", …}]}]}.
nlohmann::ordered_json tables_json(const std::vector<Table>& tables);

/// [{"law", "groups", "points", "bias", "spread", "root_mean_square", "largest", "beds"}].
nlohmann::ordered_json evidence_json(const std::vector<Evidence>& evidence);

/// Writes league.csv, one line per regime and law, league.json, and the chart league.svg, .png, .pdf with its script
/// and tables into `folder`. Laws of the user have their places in them. Throws std::runtime_error where a file cannot
/// be written. Returns the CSV files of the chart.
std::vector<std::filesystem::path> write_league(const std::vector<Table>& tables, const std::filesystem::path& folder);

/// The places of these laws in each table, for the page of a comparison (HTML).
std::string places_html(const std::vector<Table>& tables, const std::vector<std::string>& laws);

/// The chart as a figure of a work.
Figure figure();

}  // namespace slfb::league
