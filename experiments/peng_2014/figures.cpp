#include "experiments/peng_2014/figures.hpp"

#include "experiments/figures/figure.hpp"
#include "experiments/numerics/figures.hpp"

namespace slfb {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = [] {
    std::vector<Figure> all{table1(),
                            table2(),
                            fig01(),
                            fig02(),
                            fig03(),
                            fig04(),
                            fig05(),
                            fig06(),
                            fig07(),
                            fig08(),
                            fig09(),
                            fig10(),
                            fig11(),
                            fig12(),
                            fig13(),
                            fig14(),
                            fig15(),
                            fig16(),
                            fig17(),
                            fig18(),
                            fig19(),
                            fig20(),
                            fig21(),
                            fig22(),
                            fig23(),
                            fig24(),
                            fig25(),
                            fig26(),
                            drag_law_question(),
                            printed_voidage(),
                            causes(),
                            from_66_hours(),
                            paper_steps(),
                            planned_figures()};
    for (Figure& figure : numerics_figures()) all.push_back(std::move(figure));
    return all;
  }();
  return list;
}

}  // namespace slfb
