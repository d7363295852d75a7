#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/dem/particles.hpp"
#include "solver/scene/scene.hpp"

/// How much the instantaneous pressure drop of a fluidised bed fluctuates with the void-fraction scheme and the step.
namespace slfb::noise {

/// Root mean square of the pressure drop about its mean, static head removed, one value per step of the liquid.
struct NoisePoint {
  std::string method;       ///< "exact-overlap" and so on, as in a scene file; or the scheme in intervals
  double time_step;         ///< of the liquid [s]
  double rms, low, high;    ///< with its 95 % interval from ten blocks of the time [Pa]
  double mean, bed_weight;  ///< of the pressure drop; buoyant weight of the bed over the section [Pa]
  double seconds;           ///< that were measured [s]
  std::string failure;      ///< why there is no value, empty where there is one
};

/// Goes on from `start` with the scene's own scheme and step: `transient` for the liquid to match the spheres, then
/// `seconds` of measurement [s]. A breakdown is kept as the point's failure.
NoisePoint measure(const Scene& scene, const dem::Particles& start, double transient, double seconds);

/// Every scheme at every step of the study; written with machine, date and `command` as comments.
void run_study(const std::filesystem::path& file, const std::string& command,
               const std::function<void(const std::string&)>& say);
/// The points of such a file. Throws std::runtime_error that names the file and the line.
std::vector<NoisePoint> load_study(const std::filesystem::path& file);

/// A way to come to the void fraction: its name, its scheme, and how often it is computed.
struct Method {
  std::string name;
  VoidFractionScheme scheme;
  double interval;  ///< [s]; 0: in every step of the liquid
};
const std::vector<Method>& methods();

}  // namespace slfb::noise
