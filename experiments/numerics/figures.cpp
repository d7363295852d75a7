#include "experiments/numerics/figures.hpp"

#include <fmt/format.h>

#include <utility>

#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"

namespace slfb {

FigureOutput not_yet_computed(const std::string& id, const std::string& caption, const std::string& command,
                              const std::filesystem::path& folder) {
  draw_plot(id, source_folder() / "experiments/numerics/not_yet_computed.gp", {}, {600, 200}, folder);
  return {id, {}, caption, {fmt::format("Not yet computed: {}.", command)}};
}

std::vector<Figure> numerics_figures() {
  std::vector<Figure> all{pressure_noise(), kinetic_theory(), frontier_integrators(), default_knees(),
                          less_is_enough()};
  for (auto* list : {frontier_charts, stability_maps})
    for (Figure& figure : list()) all.push_back(std::move(figure));
  return all;
}

}  // namespace slfb
