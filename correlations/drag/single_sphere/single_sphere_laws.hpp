#pragma once

#include <string_view>
#include <tuple>
#include <utility>

#include "correlations/drag/single_sphere/abraham_1970.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/drag/single_sphere/clift_gauvin_1971.hpp"
#include "correlations/drag/single_sphere/clift_gauvin_1971_refit.hpp"
#include "correlations/drag/single_sphere/dalla_valle_1948.hpp"
#include "correlations/drag/single_sphere/haider_levenspiel_1989.hpp"
#include "correlations/drag/single_sphere/schiller_naumann_1935.hpp"
#include "correlations/drag/single_sphere/turton_levenspiel_1986.hpp"
#include "correlations/law_list.hpp"

namespace slfb::drag::single_sphere {

/// Every law for the drag of a sphere alone. A new law is one new header and one line here.
///
/// Each law returns C_D Re / 24, which stays finite as Re → 0.
using SingleSphereLaws = std::tuple<SchillerNaumann1935,   //
                                    BrownLawler2003,       //
                                    TurtonLevenspiel1986,  //
                                    HaiderLevenspiel1989,  //
                                    DallaValle1948,        //
                                    CliftGauvin1971,       //
                                    CliftGauvin1971Refit,  //
                                    Abraham1970>;

/// Calls `use(law)` with the single-sphere law of that name and returns its result.
/// \throws std::invalid_argument naming the unknown law and listing the known ones
template <class Use>
decltype(auto) with_single_sphere_law(std::string_view name, Use&& use) {
  return with_law<SingleSphereLaws>("single-sphere drag law", name, std::forward<Use>(use));
}

/// Drag coefficient C_D [-] = F / (½ ρ w² π d²/4) of a single-sphere law; infinite at Re = 0.
template <class Law>
double drag_coefficient(const Law& law, double reynolds) {
  return 24.0 * law(reynolds) / reynolds;
}

}  // namespace slfb::drag::single_sphere
