#include "experiments/numerics/frontier/frontier_figures.hpp"

#include "experiments/numerics/frontier/frontier_chart.hpp"
#include "experiments/numerics/frontier/study_tables.hpp"
#include "experiments/numerics/stability/map_chart.hpp"
#include "experiments/peng_2014/from_66_hours/from_66_hours.hpp"
#include "experiments/peng_2014/planned_figures/figure_plans.hpp"

namespace slfb {
namespace {

std::vector<std::string> no_runs(const Profile&) { return {}; }

}  // namespace

std::vector<Figure> study_figures() {
  std::vector<Figure> list{from_66_hours()};
  for (Figure& table : study_tables()) list.push_back(std::move(table));
  list.push_back(plan::planned_figures());
  for (const auto& file : frontier::study_files()) {
    const auto study = frontier::load_study(file, frontier::Set::full);
    list.push_back({"frontier-" + study.id, study.title, no_runs,
                    [file](const FigureContext& context) {
                      const auto drawn = frontier::load_study(file, frontier::Set::full);
                      return frontier::draw_frontier(drawn, frontier::load_reduced(drawn, context.results),
                                                     frontier::load_beside(drawn, context.results), context.out);
                    },
                    "numerics/frontier"});
  }
  for (const auto& file : stability::map_files()) {
    const auto map = stability::load_map(file, stability::Set::full);
    list.push_back({"stability-" + map.id, map.title, no_runs,
                    [file](const FigureContext& context) {
                      const auto drawn = stability::load_map(file, stability::Set::full);
                      return stability::draw_map(drawn, stability::load_solved(drawn, context.results),
                                                 stability::load_beside(drawn, context.results), context.out);
                    },
                    "numerics/stability"});
  }
  return list;
}

}  // namespace slfb
