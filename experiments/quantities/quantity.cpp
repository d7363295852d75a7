#include "experiments/quantities/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace slfb {

const Species& RunView::bed_species() const {
  const auto found = std::ranges::find_if(scene.species, [](const Species& species) { return species.count > 0; });
  if (found == scene.species.end()) throw std::runtime_error("a run has no bed particles");
  return *found;
}

double RunView::solids_volume() const {
  double volume = 0.0;
  std::int64_t count = 0;
  for (const Species& species : scene.species) {
    volume += static_cast<double>(species.count) * std::numbers::pi / 6.0 * std::pow(species.diameter, 3);
    count += species.count;
  }
  const double remaining = static_cast<double>(count - result.particles_removed) / static_cast<double>(count);
  return volume * remaining;
}

double RunView::bed_top() const { return mean_of_bed("bed_top").value_or(result.packed_height); }

std::optional<double> RunView::mean_of_bed(const std::string& quantity) const {
  const auto found = bed.find(quantity);
  return found == bed.end() ? std::nullopt : std::optional(found->second.mean);
}

std::optional<double> DropNumbers::of_drop(const std::string& quantity) const {
  const auto found = drop.find(quantity);
  return found == drop.end() ? std::nullopt : std::optional(found->second);
}

double MeasuringRules::release_clock(const std::string& system) const {
  const auto found = release_clocks.find(system);
  return found == release_clocks.end() ? 0.0 : found->second;
}

const MeasuringRules& general_rules() {
  static const MeasuringRules rules;
  return rules;
}

const Quantity* find_quantity(const MeasuringRules& rules, std::string_view id) {
  for (const std::string_view reading : {"_at_voidage", "_at_printed_voidage"})
    if (id.ends_with(reading) && std::ranges::find(rules.quantities, id, &Quantity::id) == rules.quantities.end())
      id.remove_suffix(reading.size());
  const auto found = std::ranges::find(rules.quantities, id, &Quantity::id);
  return found == rules.quantities.end() ? nullptr : &*found;
}

bool depends_on_contact_stiffness(const MeasuringRules& rules, std::string_view id) {
  const Quantity* quantity = find_quantity(rules, id);
  return quantity != nullptr && quantity->depends_on_contact_stiffness;
}

std::optional<ClassificationFit> classification_of(const DropSeries& drop, const Scene& scene,
                                                   const MeasuringRules& rules, double release_clock) {
  const auto [bottom, top] = rules.classification_window.value_or(scene.recording.fluctuation_window);
  return fit_classification(drop, bottom, top, release_clock);
}

}  // namespace slfb
