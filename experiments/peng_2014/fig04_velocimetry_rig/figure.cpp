#include "experiments/figures/figure_folder.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "reports/gnuplot.hpp"

namespace slfb::fig04_velocimetry_rig {
namespace {

const FigureFolder folder{"peng_2014/fig04_velocimetry_rig"};

FigureOutput draw(const FigureContext& context) {
  draw_plot("fig04", folder.plot(), {}, {690, 750}, context.out);
  return {"fig04", {}, folder.caption(), {"No simulation stands behind this picture."}};
}

}  // namespace

Figure figure() { return {"fig04", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::fig04_velocimetry_rig
