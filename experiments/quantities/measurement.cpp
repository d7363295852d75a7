#include "experiments/quantities/measurement.hpp"

namespace slfb {

std::map<double, Measurement> over_numbers(const Measurements& measurements, std::string_view quantity,
                                           std::string_view subject, std::string_view detail) {
  std::map<double, Measurement> points;
  for (auto entry = measurements.lower_bound({std::string(quantity), std::string(subject)});
       entry != measurements.end() && entry->first.quantity == quantity && entry->first.subject == subject; ++entry)
    if (entry->first.at && entry->first.detail == detail) points.emplace(*entry->first.at, entry->second);
  return points;
}

}  // namespace slfb
