#pragma once

#include <tuple>

#include "correlations/fluidisation/expansion_exponent/garside_al_dibouni_1977.hpp"
#include "correlations/fluidisation/expansion_exponent/khan_richardson_1989.hpp"
#include "correlations/fluidisation/expansion_exponent/khan_richardson_1989_codes.hpp"
#include "correlations/fluidisation/expansion_exponent/richardson_zaki_1954.hpp"
#include "correlations/fluidisation/expansion_exponent/rowe_1987.hpp"
#include "correlations/fluidisation/minimum_fluidisation/doroodchi_2012.hpp"
#include "correlations/fluidisation/minimum_fluidisation/ergun_1952.hpp"
#include "correlations/fluidisation/minimum_fluidisation/gibilaro_1985.hpp"
#include "correlations/fluidisation/minimum_fluidisation/wen_yu_1966.hpp"
#include "correlations/fluidisation/wall_correction/haberman_sayre_1958.hpp"
#include "correlations/fluidisation/wall_correction/munroe_1888.hpp"
#include "correlations/fluidisation/wall_correction/newton_1687.hpp"
#include "correlations/fluidisation/wall_correction/richardson_zaki_wall_1954.hpp"

namespace slfb::fluidisation {

/// Laws for the velocity at which a packed bed fluidises. A new law is one new header and one line here.
using MinimumFluidisationLaws = std::tuple<minimum_fluidisation::Ergun1952,      //
                                           minimum_fluidisation::WenYu1966,      //
                                           minimum_fluidisation::Doroodchi2012,  //
                                           minimum_fluidisation::Gibilaro1985>;

/// Laws for the exponent n of the bed expansion U = U_i ε^n.
using ExpansionExponentLaws = std::tuple<RichardsonZaki1954,       //
                                         KhanRichardson1989,       //
                                         KhanRichardson1989Codes,  //
                                         Rowe1987,                 //
                                         GarsideAlDibouni1977>;

/// Laws for the effect of a tube on the terminal velocity.
using WallCorrectionLaws = std::tuple<Munroe1888,         //
                                      Newton1687,         //
                                      HabermanSayre1958,  //
                                      RichardsonZakiWall1954>;

}  // namespace slfb::fluidisation
