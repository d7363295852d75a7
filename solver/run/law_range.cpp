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

}  // namespace

void LawRange::sample(const Model& model) {
  const coupling::PhaseCoupling& coupling = model.coupling();
  for (std::size_t i = 0; i < model.particles().size(); ++i) {
    // A sphere that has come since the last step has not asked yet.
    if (!coupling.knows(i)) continue;
    const double voidage = coupling.voidage(i), reynolds = coupling.reynolds(i);
    ++samples_;
    if (law_.voidage.contains(voidage) && law_.reynolds.contains(reynolds)) continue;
    const auto widen = [&](Extent& extent, double value) {
      extent =
          outside_ == 0 ? Extent{value, value} : Extent{std::min(extent.least, value), std::max(extent.most, value)};
    };
    widen(voidage_, voidage);
    widen(reynolds_, reynolds);
    ++outside_;
  }
}

std::string LawRange::sentence() const {
  if (outside_ == 0) return "";
  return fmt::format(
      "the drag law {} was asked outside its range (voidage {}, Re {}) in {:.3g} % of {} samples, there at voidages of "
      "{:.3g} to {:.3g} and Re of {:.3g} to {:.3g}; its source does not claim that it holds there",
      law_.name, words_of(law_.voidage), words_of(law_.reynolds),
      100.0 * static_cast<double>(outside_) / static_cast<double>(samples_), samples_, voidage_.least, voidage_.most,
      reynolds_.least, reynolds_.most);
}

void LawRange::exchange(io::StateGroup& group) {
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  group.value("samples", samples_, 0, any);
  group.value("outside", outside_, 0, samples_);
  group.value("least_voidage", voidage_.least, "1");
  group.value("most_voidage", voidage_.most, "1");
  group.value("least_reynolds", reynolds_.least, "1");
  group.value("most_reynolds", reynolds_.most, "1");
}

}  // namespace slfb::simulation
