#pragma once

#include <tuple>

#include "correlations/collision/collision_force/grbavcic_2009.hpp"
#include "correlations/collision/collision_force/peng_2014.hpp"
#include "correlations/collision/collision_force/van_der_wielen_1996.hpp"
#include "correlations/collision/collision_frequency/gidaspow_1994.hpp"
#include "correlations/collision/collision_frequency/gidaspow_1994_unequal.hpp"
#include "correlations/collision/collision_frequency/gjaltema_1997.hpp"
#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/carnahan_starling_1969.hpp"
#include "correlations/collision/radial_distribution/ding_gidaspow_1990.hpp"
#include "correlations/collision/radial_distribution/lebowitz_1964.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "correlations/collision/radial_distribution/ma_ahmadi_1986.hpp"
#include "correlations/collision/radial_distribution/sinclair_jackson_1989.hpp"
#include "correlations/collision/radial_distribution/torquato_1995.hpp"
#include "correlations/collision/restitution/barnocky_davis_1988.hpp"
#include "correlations/collision/restitution/legendre_2005.hpp"

namespace slfb::collision {

/// Laws for g_0, the pair distribution of spheres at contact. A new law is one new header and one line here.
using RadialDistributionLaws = std::tuple<LunSavage1986,         //
                                          SinclairJackson1989,   //
                                          DingGidaspow1990,      //
                                          CarnahanStarling1969,  //
                                          MaAhmadi1986,          //
                                          Torquato1995,          //
                                          Lebowitz1964>;

/// Laws for the collision frequency of one sphere.
using CollisionFrequencyLaws = std::tuple<Simonin1991,          //
                                          Gidaspow1994,         //
                                          Gidaspow1994Unequal,  //
                                          Gjaltema1997>;

/// Laws for the mean collision force on a foreign sphere.
using CollisionForceLaws = std::tuple<Peng2014,                                        //
                                      VanDerWielen1996,                                //
                                      Grbavcic2009<DisplacedDrag::of_foreign_sphere>,  //
                                      Grbavcic2009<DisplacedDrag::of_bed_spheres>>;

/// Laws for the restitution in a liquid over the dry value.
using RestitutionLaws = std::tuple<Legendre2005,  //
                                   BarnockyDavis1988>;

}  // namespace slfb::collision
