#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "solver/run/simulation.hpp"

namespace slfb {

/// Live account of several runs on standard error: on a terminal one line per running job, redrawn in place, elsewhere
/// a plain line per job now and then. Safe to call from the threads of the runs.
class ProgressDisplay {
 public:
  struct Job {
    std::string label;
    double expected_cost = 1.0;  ///< in any unit common to all jobs; jobs not yet started count with it
  };

  /// `enabled` = false: only messages. `side_by_side`: jobs that run at once, for the time left of all.
  ProgressDisplay(std::vector<Job> jobs, int side_by_side, bool enabled);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void start(std::size_t job);
  void update(std::size_t job, const Progress& progress);
  /// The job is over; `message` stays on the screen.
  void end(std::size_t job, const std::string& message);
  /// A line that stays on the screen.
  void message(const std::string& text);
  /// Draws when it is due.
  void refresh();

 private:
  using Clock = std::chrono::steady_clock;
  enum class State { waiting, running, over };
  struct Entry {
    Job job;
    State state = State::waiting;
    Clock::time_point started;
    bool reported = false;
    double fraction_at_start = 0.0;  ///< of a resumed run
    double fraction = 0.0;
    Progress latest;
  };

  void erase_block();
  void print_line(const std::string& text);
  void draw_block();
  void draw_plain();
  [[nodiscard]] double seconds_running(const Entry& entry) const;
  [[nodiscard]] double seconds_left(const Entry& entry) const;
  [[nodiscard]] double seconds_left_of_all() const;
  [[nodiscard]] std::string summary() const;

  std::mutex mutex_;
  std::vector<Entry> entries_;
  std::size_t side_by_side_;
  bool enabled_, terminal_;
  std::size_t lines_drawn_ = 0;
  Clock::time_point last_drawn_ = Clock::now();
  double cost_done_ = 0.0, seconds_spent_ = 0.0;  ///< by the jobs that are over
};

}  // namespace slfb
