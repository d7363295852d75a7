#include "experiments/runs/progress_display.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>

#include "experiments/runs/run_estimate.hpp"

namespace slfb {
namespace {

constexpr std::chrono::milliseconds terminal_interval{250};
constexpr std::chrono::seconds plain_interval{30};
constexpr std::size_t bar_width = 16;

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string bar(double fraction) {
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * bar_width);
  return fmt::format("[{}{}]", std::string(filled, '='), std::string(bar_width - filled, ' '));
}

std::string figures_of(const Progress& progress) {
  return fmt::format("{}, {:.2f} of {:.2f} s, {:.1f} M particle steps/s", progress.stage, progress.simulated_seconds,
                     progress.planned_seconds, 1e-6 * progress.particle_steps_per_second);
}

}  // namespace

ProgressDisplay::ProgressDisplay(std::vector<Job> jobs, int side_by_side, bool enabled, std::string heading)
    : side_by_side_(static_cast<std::size_t>(std::max(1, side_by_side))),
      enabled_(enabled && spdlog::should_log(spdlog::level::warn)),
      terminal_(isatty(STDERR_FILENO) != 0),
      heading_(std::move(heading)) {
  for (Job& job : jobs) entries_.emplace_back().job = std::move(job);
}

ProgressDisplay::~ProgressDisplay() { erase_block(); }

void ProgressDisplay::start(std::size_t job) {
  const std::lock_guard lock(mutex_);
  entries_[job].state = State::running;
  entries_[job].started = Clock::now();
}

void ProgressDisplay::update(std::size_t job, double fraction, const std::string& text) {
  const std::lock_guard lock(mutex_);
  Entry& entry = entries_[job];
  entry.fraction = fraction;
  if (!entry.reported) entry.fraction_at_start = entry.fraction;
  entry.reported = true;
  entry.latest = text;
}

void ProgressDisplay::update(std::size_t job, const Progress& progress) {
  update(job, progress.planned_seconds > 0.0 ? progress.simulated_seconds / progress.planned_seconds : 0.0,
         figures_of(progress));
}

void ProgressDisplay::end(std::size_t job, const std::string& text) {
  const std::lock_guard lock(mutex_);
  Entry& entry = entries_[job];
  if (entry.state == State::running) {
    cost_done_ += entry.job.expected_cost * (1.0 - entry.fraction_at_start);
    seconds_spent_ += seconds_running(entry);
  }
  entry.state = State::over;
  print_line(text);
}

void ProgressDisplay::message(const std::string& text) {
  const std::lock_guard lock(mutex_);
  print_line(text);
}

void ProgressDisplay::refresh() {
  const std::lock_guard lock(mutex_);
  if (!enabled_ || Clock::now() - last_drawn_ < (terminal_ ? Clock::duration(terminal_interval) : plain_interval))
    return;
  last_drawn_ = Clock::now();
  if (terminal_) {
    draw_block();
  } else {
    draw_plain();
  }
}

void ProgressDisplay::erase_block() {
  if (lines_drawn_ > 0) fmt::print(stderr, "\x1b[{}A\x1b[J", lines_drawn_);
  lines_drawn_ = 0;
  std::fflush(stderr);
}

void ProgressDisplay::print_line(const std::string& text) {
  erase_block();
  if (!text.empty()) fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
}

void ProgressDisplay::draw_block() {
  erase_block();
  // A wrapped line would take more than one row and could not be erased.
  const std::size_t width = terminal_width() - 1;
  const auto draw = [&](const std::string& line) {
    fmt::print(stderr, "{}\n", line.substr(0, width));
    ++lines_drawn_;
  };
  std::size_t label_width = 0;
  for (const Entry& entry : entries_) label_width = std::max(label_width, entry.job.label.size());
  for (const Entry& entry : entries_) {
    if (entry.state != State::running) continue;
    // What matters most comes first, since a narrow terminal cuts the end.
    draw(fmt::format("{:<{}} {} {:3.0f} %  {:>11} left  {}", entry.job.label, label_width, bar(entry.fraction),
                     100.0 * entry.fraction, format_duration(seconds_left(entry)), entry.latest));
  }
  if (entries_.size() > 1 || !heading_.empty()) draw(summary());
  std::fflush(stderr);
}

void ProgressDisplay::draw_plain() {
  const std::string running = running_jobs();
  print_line(entries_.size() > 1 || !heading_.empty()
                 ? fmt::format("{}{}", summary(), running.empty() ? "" : ": " + running)
                 : running);
}

std::string ProgressDisplay::summary() const {
  const auto over =
      std::count_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.state == State::over; });
  return fmt::format("{}{} of {} done, {} left", heading_.empty() ? "" : heading_ + ": ", over, entries_.size(),
                     format_duration(seconds_left_of_all()));
}

std::string ProgressDisplay::running_jobs() const {
  std::string text;
  for (const Entry& entry : entries_)
    if (entry.state == State::running)
      // A job that has told nothing yet, as a figure that is drawn, is only named.
      text += fmt::format("{}{}{}", text.empty() ? "" : "; ", entry.job.label,
                          entry.reported ? fmt::format(" {:.0f} % ({}, {} left)", 100.0 * entry.fraction, entry.latest,
                                                       format_duration(seconds_left(entry)))
                                         : "");
  return text;
}

double ProgressDisplay::seconds_running(const Entry& entry) const {
  return std::chrono::duration<double>(Clock::now() - entry.started).count();
}

double ProgressDisplay::seconds_left(const Entry& entry) const {
  const double gained = entry.fraction - entry.fraction_at_start;
  if (gained <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  return (1.0 - entry.fraction) * seconds_running(entry) / gained;
}

double ProgressDisplay::seconds_left_of_all() const {
  // What a unit of cost has taken so far, over the jobs done and running, prices those that wait.
  double cost = cost_done_, seconds = seconds_spent_;
  for (const Entry& entry : entries_) {
    if (entry.state != State::running) continue;
    cost += entry.job.expected_cost * (entry.fraction - entry.fraction_at_start);
    seconds += seconds_running(entry);
  }
  if (cost <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double seconds_per_cost = seconds / cost;

  // Each waiting job goes, in order, to the place that is free first.
  std::vector<double> places(side_by_side_, 0.0);
  const auto assign = [&](double duration) { *std::min_element(places.begin(), places.end()) += duration; };
  for (const Entry& entry : entries_) {
    if (entry.state == State::running) assign((1.0 - entry.fraction) * entry.job.expected_cost * seconds_per_cost);
  }
  for (const Entry& entry : entries_) {
    if (entry.state == State::waiting) assign(entry.job.expected_cost * seconds_per_cost);
  }
  return *std::max_element(places.begin(), places.end());
}

DisplayRefresher::DisplayRefresher(ProgressDisplay& display)
    : thread_([&display](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
          display.refresh();
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
      }) {}

}  // namespace slfb
