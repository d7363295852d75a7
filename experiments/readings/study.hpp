#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/readings/collect.hpp"

/// The whole inference about a source, and how a report tells it.
namespace slfb::readings {

/// What a reading comes to.
struct StudiedReading {
  std::string name;
  ReadingRuns runs;
  Assessment assessment;                ///< by the numbers that count
  std::optional<double> with_disputed;  ///< Assessment::test with the disputed numbers
  std::size_t departures = 0;           ///< from printed statements
  std::optional<double>
      log10_evidence;  ///< calibration and test less the penalty, over the best; empty: not all was run
  std::optional<double> without_penalty;  ///< the same without it
  /// Test numbers within the 95 % prediction interval, and all it has; without disputed ones and those that chose.
  std::size_t inside = 0, tested = 0;
};

struct Study {
  Choices choices;
  std::vector<Evidence> evidence;
  Widths widths;
  std::vector<bool> reached;  ///< by number, see reached_by_any
  std::vector<bool> counted;  ///< by number: reached, not disputed, and run for at least half of the readings
  std::vector<StudiedReading> readings;  ///< the best evidence first; behind them those without, by their calibration
  /// By all counted numbers, with and without the penalty, and by the calibration numbers alone. Empty where fewer than
  /// three readings have a number.
  std::optional<Posterior> penalised, unpenalised, calibrated;
  std::vector<std::vector<Sensitivity>> sensitivities;  ///< by factor
  std::vector<Identification> identification;           ///< by factor
};

/// \param grid name of the factor whose levels are grids; "" where none is varied
/// Throws std::invalid_argument for an unknown factor.
Study study(Choices choices, std::vector<Evidence> evidence, const std::vector<FinishedRun>& runs,
            const MeasuringRules& rules, const std::string& grid);

/// Every number of it, for other programs.
nlohmann::ordered_json study_json(const Study& study);

/// The findings in words and tables, as Markdown: ranking, what decides, what no reading satisfies, what can be told at
/// all, and what could be measured to decide.
std::string study_text(const Study& study);

}  // namespace slfb::readings
