#pragma once

#include <string_view>
#include <tuple>
#include <utility>

#include "correlations/drag/beetstra_2007.hpp"
#include "correlations/drag/di_felice_1994.hpp"
#include "correlations/drag/di_felice_1994_mfix.hpp"
#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/drag/eisfeld_schnitzlein_2001.hpp"
#include "correlations/drag/ergun_1952.hpp"
#include "correlations/drag/ergun_1952_refit.hpp"
#include "correlations/drag/gibilaro_1985.hpp"
#include "correlations/drag/gidaspow_1994.hpp"
#include "correlations/drag/gidaspow_1994_blend.hpp"
#include "correlations/drag/hill_koch_ladd_2001.hpp"
#include "correlations/drag/koch_hill_2001.hpp"
#include "correlations/drag/koch_hill_2001_ladd.hpp"
#include "correlations/drag/rong_2013.hpp"
#include "correlations/drag/syamlal_obrien_1993.hpp"
#include "correlations/drag/tang_2015.hpp"
#include "correlations/drag/tenneti_2011.hpp"
#include "correlations/drag/tenneti_2011_mfix.hpp"
#include "correlations/drag/tenneti_2011_openfoam.hpp"
#include "correlations/drag/wen_yu_1966.hpp"
#include "correlations/law_list.hpp"

namespace slfb::drag {

/// Every drag law of the suite. A new law is one new header and one line here.
using DragLaws = std::tuple<Ergun1952,               //
                            Ergun1952Refit,          //
                            EisfeldSchnitzlein2001,  //
                            WenYu1966,               //
                            Gidaspow1994,            //
                            Gidaspow1994Blend,       //
                            DiFelice1994,            //
                            DiFelice1994Mfix,        //
                            Gibilaro1985,            //
                            Doroodchi2012,           //
                            SyamlalOBrien1993,       //
                            HillKochLadd2001,        //
                            KochHill2001,            //
                            KochHill2001Ladd,        //
                            Beetstra2007,            //
                            Tang2015,                //
                            Tenneti2011,             //
                            Tenneti2011Mfix,         //
                            Tenneti2011Openfoam,     //
                            Rong2013>;

/// Calls `use(law)` with the drag law of that name, e.g. "gidaspow-1994", and returns its result. The law has its own
/// type there, so that a kernel inside `use` inlines the formula.
/// \throws std::invalid_argument naming the unknown law and listing the known ones
template <class Use>
decltype(auto) with_drag_law(std::string_view name, Use&& use) {
  return with_law<DragLaws>("drag law", name, std::forward<Use>(use));
}

}  // namespace slfb::drag
