#include "experiments/peng_2014/report_texts.hpp"

#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb::paper {

reports::WorkTexts report_texts() {
  return {
      .title = "Solid–liquid fluidised beds, simulated again",
      .introduction =
          "A steel sphere settles through a bed of glass spheres in water. Peng et al. ([Chem. Eng. Sci., "
          "2014](https://doi.org/10.1016/j.ces.2014.04.040)) simulated it with coupled CFD and DEM; this report "
          "simulates it again with `slfb`, draws their figures, and holds each statement of the paper that can be "
          "checked against our own numbers.",
      .about_figures =
          "The paper is drawn in black with open symbols or dashed lines, our simulations in colour with 95 % "
          "intervals, laws as thin lines. A symbol stands only where a number exists: the points of the paper's plots "
          "were never published as numbers, so only printed values appear. Each picture leads to its page, with the "
          "statements of the paper beside our numbers.",
      .methods = read_file(source_folder() / "experiments" / "peng_2014" / "methods.md"),
      .featured = {{.figure = "drag-law", .label = "Drag law"}}};
}

}  // namespace slfb::paper
