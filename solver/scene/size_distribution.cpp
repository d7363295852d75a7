#include "solver/scene/size_distribution.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "solver/scene/scene_problems.hpp"
#include "solver/scene/units.hpp"

namespace slfb::description {
namespace {

/// One [[species]] with diameters.
class Distribution {
 public:
  Distribution(toml::table& table, std::size_t index, const std::string& file)
      : table_(table), index_(index), file_(file) {}

  /// Adds its species to `expanded`.
  void expand(toml::array& expanded) {
    const toml::array& diameters = list("diameters");
    if (table_.contains("diameter")) fail("diameter", "stands beside diameters; allowed is one of the two");
    if (table_.contains("count")) fail("count", "stands beside diameters; needed is counts, one for each of them");
    const bool by_mass = table_.contains("mass_fractions");
    if (by_mass == table_.contains("counts"))
      fail("diameters", "needed beside it is either counts, or mass_fractions with total_mass");
    if (by_mass != table_.contains("total_mass"))
      fail("total_mass", "belongs to mass_fractions, which need it; counts need none");
    const toml::array& shares = list(by_mass ? "mass_fractions" : "counts");
    if (shares.size() != diameters.size())
      fail(by_mass ? "mass_fractions" : "counts",
           fmt::format("has {} values for {} diameters", shares.size(), diameters.size()));
    const double mass = by_mass ? total_mass() : 0.0;
    if (by_mass) check_sum(shares);
    for (std::size_t k = 0; k < diameters.size(); ++k) {
      toml::table one;
      for (const auto& [key, node] : table_)
        if (key != "diameters" && key != "counts" && key != "mass_fractions" && key != "total_mass")
          one.insert(key, node);
      const auto name = table_["name"].value<std::string>();
      if (name) one.insert_or_assign("name", fmt::format("{}-{}", *name, k + 1));
      one.insert("diameter", *diameters.get(k));
      if (by_mass)
        one.insert("total_mass", mass * *shares.get(k)->value<double>());
      else
        one.insert("count", *shares.get(k));
      expanded.push_back(std::move(one));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    const toml::node* node = table_.get(key);
    const auto line = (node != nullptr ? *node : static_cast<const toml::node&>(table_)).source().begin.line;
    throw SceneError(fmt::format("{}: species[{}].{}: {}", line == 0 ? file_ : fmt::format("{}:{}", file_, line),
                                 index_, key, what));
  }

  [[nodiscard]] const toml::array& list(const std::string& key) const {
    const toml::array* found = table_.get(key) != nullptr ? table_.get(key)->as_array() : nullptr;
    if (found == nullptr || found->empty())
      fail(key, "is no list; needed are values in brackets, one for each diameter");
    return *found;
  }

  void check_sum(const toml::array& fractions) const {
    constexpr double rounding = 1e-3;
    double sum = 0.0;
    for (const toml::node& fraction : fractions) {
      const auto value = fraction.value<double>();
      if (!value || !(*value > 0.0)) fail("mass_fractions", "holds something else than numbers above zero");
      sum += *value;
    }
    if (!(std::abs(sum - 1.0) <= rounding)) fail("mass_fractions", fmt::format("add up to {:.6g}; needed is 1", sum));
  }

  [[nodiscard]] double total_mass() const {
    const toml::node& node = *table_.get("total_mass");
    if (node.is_number()) return *node.value<double>();
    const auto text = node.value<std::string>();
    if (!text) fail("total_mass", "is no mass");
    try {
      return units::parse_quantity(*text, units::mass);
    } catch (const units::UnitError& error) {
      fail("total_mass", error.what());
    }
  }

  toml::table& table_;
  std::size_t index_;
  const std::string& file_;
};

}  // namespace

void expand_size_distributions(toml::table& scene, const std::string& file) {
  toml::array* species = scene["species"].as_array();
  if (species == nullptr || !species->is_array_of_tables()) return;
  bool any = false;
  for (const toml::node& one : *species) any = any || one.as_table()->contains("diameters");
  if (!any) return;
  toml::array expanded;
  for (std::size_t i = 0; i < species->size(); ++i) {
    toml::table& one = *species->get(i)->as_table();
    if (one.contains("diameters"))
      Distribution(one, i, file).expand(expanded);
    else
      expanded.push_back(std::move(one));
  }
  scene.insert_or_assign("species", std::move(expanded));
}

}  // namespace slfb::description
