#pragma once

#include <tuple>

#include "correlations/classification/di_felice_1991.hpp"
#include "correlations/classification/galvin_1999.hpp"
#include "correlations/classification/grbavcic_2009.hpp"
#include "correlations/classification/joshi_1983_reconstruction.hpp"
#include "correlations/classification/kennedy_bretton_1966.hpp"
#include "correlations/classification/kunii_levenspiel_1969.hpp"
#include "correlations/classification/van_der_wielen_1996.hpp"

namespace slfb::classification {

/// Laws for the settling velocity V_2 of a foreign sphere through a fluidised bed. A new law is one new header and one
/// line here.
using ClassificationLaws = std::tuple<KennedyBretton1966,                              //
                                      KuniiLevenspiel1969,                             //
                                      Joshi1983Reconstruction,                         //
                                      DiFelice1991,                                    //
                                      VanDerWielen1996,                                //
                                      Grbavcic2009<DisplacedDrag::of_foreign_sphere>,  //
                                      Grbavcic2009<DisplacedDrag::of_bed_spheres>,     //
                                      Galvin1999>;

}  // namespace slfb::classification
