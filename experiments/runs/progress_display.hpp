#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "solver/run/simulation.hpp"

namespace slfb {

/// Live account of several jobs on standard error: on a terminal one line per running job and one for all of them,
/// redrawn in place; elsewhere one line now and then. Safe to call from the threads of the jobs.
class ProgressDisplay {
 public:
  struct Job {
    std::string label;
    double expected_cost = 1.0;  ///< in any unit common to all jobs; jobs not yet started count with it
  };

  /// `enabled` = false, or warnings switched off (spdlog): only messages. `side_by_side`: jobs that run at once, for
  /// the time left of all. `heading`: what the jobs are, put before the line for all of them: "step 2 of 3,
  /// simulations".
  ProgressDisplay(std::vector<Job> jobs, int side_by_side, bool enabled, std::string heading = "");
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void start(std::size_t job);
  /// `fraction` of the job that is done; `text` says what is under way.
  void update(std::size_t job, double fraction, const std::string& text);
  void update(std::size_t job, const Progress& progress);
  /// The job is over; `message` stays on the screen, unless it is empty.
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
    std::string latest;
  };

  void erase_block();
  void print_line(const std::string& text);
  void draw_block();
  void draw_plain();
  [[nodiscard]] double seconds_running(const Entry& entry) const;
  [[nodiscard]] double seconds_left(const Entry& entry) const;
  [[nodiscard]] double seconds_left_of_all() const;
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] std::string running_jobs() const;

  std::mutex mutex_;
  std::vector<Entry> entries_;
  std::size_t side_by_side_;
  bool enabled_, terminal_;
  std::string heading_;
  std::size_t lines_drawn_ = 0;
  Clock::time_point last_drawn_ = Clock::now();
  double cost_done_ = 0.0, seconds_spent_ = 0.0;  ///< by the jobs that are over
};

/// Redraws a display until it goes out of scope, while jobs run that do not do so themselves.
class DisplayRefresher {
 public:
  explicit DisplayRefresher(ProgressDisplay& display);

 private:
  std::jthread thread_;
};

}  // namespace slfb
