#include "experiments/quantities/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace slfb {

// An interval cut at a bound of nature still holds the true value as often: what is cut off cannot be it.
double Measurement::lower() const {
  return interval ? interval->first : std::isnan(half_width) ? half_width : std::max(lowest, value - half_width);
}

double Measurement::upper() const {
  return interval ? interval->second : std::isnan(half_width) ? half_width : std::min(highest, value + half_width);
}

bool Measurement::has_interval() const { return interval.has_value() || !std::isnan(half_width); }

std::map<double, Measurement> over_numbers(const Measurements& measurements, std::string_view quantity,
                                           std::string_view subject, std::string_view detail) {
  std::map<double, Measurement> points;
  for (auto entry = measurements.lower_bound({std::string(quantity), std::string(subject)});
       entry != measurements.end() && entry->first.quantity == quantity && entry->first.subject == subject; ++entry)
    if (entry->first.at && entry->first.detail == detail) points.emplace(*entry->first.at, entry->second);
  return points;
}

}  // namespace slfb
