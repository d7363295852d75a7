#include "experiments/figures/figure_folder.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "reports/gnuplot.hpp"

namespace slfb::fig03_settling_rig {
namespace {

const FigureFolder folder{"peng_2014/fig03_settling_rig"};

FigureOutput draw(const FigureContext& context) {
  draw_plot("fig03", folder.plot(), {}, {645, 750}, context.out);
  return {"fig03", {}, folder.caption(), {"No simulation stands behind this picture."}};
}

}  // namespace

Figure figure() { return {"fig03", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::fig03_settling_rig
