#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/league/prediction.hpp"
#include "solver/scene/scene.hpp"

/// The bed of a scene as the league sees it, and what is to be expected of it.
namespace slfb::league {

/// The spheres of the bed, the liquid, and the column: a box counts as a tube of four times its section over its
/// perimeter, and has no walls where they are periodic. \throws std::invalid_argument for a scene without a bed, with
/// several kinds of spheres in it, or with spheres that do not sink
Bed bed_of(const Scene& scene);

/// What is predicted of a scene before it runs.
struct ScenePrediction {
  const Contender* law;  ///< of the voidage
  fluidisation::BedRegime regime;
  Predicted voidage;               ///< [-]
  Predicted bed_height;            ///< that the spheres fill evenly [m]
  Predicted minimum_fluidisation;  ///< U_mf by Ergun (1952) [m/s]
  Predicted pressure_drop;  ///< without the static part [Pa]: the buoyant weight of the bed over the section, and its
                            ///< sigma the momentum that the liquid gains as it enters the bed, ρ U² (1/ε − 1), which
                            ///< is given back or not; of a packed bed by Ergun (1952), of a bed that is washed out none
};

/// \param law that gives the voidage \param packed_voidage of the bed at rest [-] \param tier_error relative error of
/// the voidage by the way the law is solved [-]
ScenePrediction predict_scene(const Scene& scene, const Contender& law, double packed_voidage, double tier_error);

/// Laws for the bed of a scene, by the measured beds that are near.
struct Recommendation {
  Evidence formula;                      ///< the nearest of all, for an answer without a run
  Evidence drag_law;                     ///< the nearest drag law as it is, for a simulation
  std::optional<Evidence> of_the_scene;  ///< the drag law of the scene; empty where it has no answer for these beds
};

/// Empty for a scene without a bed of one kind of spheres that sink. \param laws has to live as long as the answer
/// \param scene_law name of the drag law of the scene
std::optional<Recommendation> recommend(const Scene& scene, const std::vector<Contender>& laws,
                                        const std::string& scene_law);

}  // namespace slfb::league
