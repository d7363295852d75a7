#include "solver/run/law_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace slfb::simulation {
namespace {

std::string words_of(const Range& range) {
  return range.upper == std::numeric_limits<double>::infinity() ? fmt::format("{:g} and above", range.lower)
                                                                : fmt::format("{:g} to {:g}", range.lower, range.upper);
}

/// Above this share of samples a run is warned of them.
constexpr double told_share = 1e-3;

}  // namespace

LawRange::LawRange(const LawInfo& law, const std::vector<Species>& species)
    : law_(law),
      samples_(species.size()),
      outside_(species.size()),
      least_voidage_(species.size()),
      most_voidage_(species.size()),
      least_reynolds_(species.size()),
      most_reynolds_(species.size()) {
  for (const Species& one : species) names_.push_back(one.name);
}

void LawRange::sample(const Model& model) {
  const coupling::PhaseCoupling& coupling = model.coupling();
  const dem::Particles& particles = model.particles();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    // A sphere that has come since the last step has not asked yet.
    if (!coupling.knows(i)) continue;
    const double voidage = coupling.voidage(i), reynolds = coupling.reynolds(i);
    const auto s = static_cast<std::size_t>(particles.species[i]);
    ++samples_[s];
    if (law_.voidage.contains(voidage) && law_.reynolds.contains(reynolds)) continue;
    const bool first = outside_[s]++ == 0;
    const auto widen = [&](double& least, double& most, double value) {
      least = first ? value : std::min(least, value);
      most = first ? value : std::max(most, value);
    };
    widen(least_voidage_[s], most_voidage_[s], voidage);
    widen(least_reynolds_[s], most_reynolds_[s], reynolds);
  }
}

double LawRange::share(std::size_t species) const {
  return samples_[species] == 0 ? 0.0 : static_cast<double>(outside_[species]) / static_cast<double>(samples_[species]);
}

std::size_t LawRange::worst() const {
  std::size_t worst = 0;
  for (std::size_t s = 1; s < names_.size(); ++s)
    if (share(s) > share(worst)) worst = s;
  return worst;
}

bool LawRange::often_outside() const { return !names_.empty() && share(worst()) > told_share; }

std::string LawRange::sentence() const {
  if (std::ranges::all_of(outside_, [](std::int64_t count) { return count == 0; })) return "";
  const std::size_t s = worst();
  return fmt::format(
      "the drag law {} was asked outside its range (voidage {}, Re {}) in {:.3g} % of {} samples of {}, there at "
      "voidages of {:.3g} to {:.3g} and Re of {:.3g} to {:.3g}; its source does not claim that it holds there",
      law_.name, words_of(law_.voidage), words_of(law_.reynolds), 100.0 * share(s), samples_[s], names_[s],
      least_voidage_[s], most_voidage_[s], least_reynolds_[s], most_reynolds_[s]);
}

void LawRange::exchange(io::StateGroup& group) {
  const std::size_t species = names_.size();
  group.values("samples", samples_, species);
  group.values("outside", outside_, species);
  for (std::size_t s = 0; s < species; ++s)
    if (outside_[s] < 0 || samples_[s] < outside_[s]) group.fail("outside", "is no part of the samples");
  group.values("least_voidage", least_voidage_, "1", species);
  group.values("most_voidage", most_voidage_, "1", species);
  group.values("least_reynolds", least_reynolds_, "1", species);
  group.values("most_reynolds", most_reynolds_, "1", species);
}

}  // namespace slfb::simulation
