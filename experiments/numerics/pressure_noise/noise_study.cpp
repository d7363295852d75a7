#include "experiments/numerics/pressure_noise/noise_study.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "correlations/materials.hpp"
#include "experiments/numerics/studies/coupled_bed.hpp"
#include "solver/support/files.hpp"
#include "solver/support/processor.hpp"

namespace slfb::noise {
namespace {

constexpr std::array time_steps{1e-3, 5e-4, 2e-4, 1e-4};

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> list{{"exact-overlap", VoidFractionScheme::exact_overlap, 0.0},
                                        {"exact-overlap every 0.5 ms", VoidFractionScheme::exact_overlap, 5e-4},
                                        {"exact-overlap every 1 ms", VoidFractionScheme::exact_overlap, 1e-3},
                                        {"particle-meshing", VoidFractionScheme::particle_meshing, 0.0},
                                        {"centroid", VoidFractionScheme::centroid, 0.0}};
  return list;
}

NoisePoint measure(const Scene& scene, const dem::Particles& start, double transient, double seconds) {
  NoisePoint point{};
  std::vector<double> signal;
  try {
    studies::CoupledBed bed(scene, start);
    bed.advance(transient);
    bed.advance(seconds, [&] { signal.push_back(bed.liquid.inlet_pressure()); });
  } catch (const std::runtime_error& error) {
    point.failure = error.what();
  }
  const auto n = static_cast<double>(signal.size());
  point.time_step = scene.fluid.time_step;
  point.seconds = seconds;
  const Species& species = scene.species.front();
  point.bed_weight = static_cast<double>(start.size()) * (species.density - scene.liquid.density) *
                     gravitational_acceleration * dem::Particles::volume_of(0.5 * species.diameter) /
                     scene.geometry.cross_section();
  if (!point.failure.empty()) return point;
  point.mean = std::accumulate(signal.begin(), signal.end(), 0.0) / n;
  // Neighbouring values belong together, blocks hardly: their scatter tells how sure the mean square is.
  constexpr std::size_t blocks = 10;
  std::array<double, blocks> square{};
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t first = signal.size() * b / blocks, last = signal.size() * (b + 1) / blocks;
    for (std::size_t k = first; k < last; ++k)
      square[b] += std::pow(signal[k] - point.mean, 2) / static_cast<double>(last - first);
  }
  const double mean_square = std::accumulate(square.begin(), square.end(), 0.0) / blocks;
  double variance = 0.0;
  for (const double s : square) variance += std::pow(s - mean_square, 2) / (blocks * (blocks - 1.0));
  const double half_width = 2.26 * std::sqrt(variance);  // Student's t for ten blocks
  point.rms = std::sqrt(mean_square);
  point.low = std::sqrt(std::max(0.0, mean_square - half_width));
  point.high = std::sqrt(mean_square + half_width);
  return point;
}

void run_study(const std::filesystem::path& file, const std::string& command,
               const std::function<void(const std::string&)>& say) {
  const Scene scene = studies::glass_bed();
  say("fluidising the bed for 1.5 s");
  const dem::Particles start = studies::fluidised(scene, 1.5);
  std::string text =
      fmt::format("# {} on one core of {}, {:%Y-%m-%d}\n", command, processor_name(), fmt::gmtime(std::time(nullptr)));
  text +=
      "method,time step [s],root mean square [Pa],low [Pa],high [Pa],mean [Pa],weight of the bed [Pa],measured "
      "[s],failure\n";
  for (const Method& method : methods())
    for (const double time_step : time_steps) {
      if (method.interval > 0.0 && time_step > 0.99 * method.interval) continue;  // that is every step
      if (std::abs(std::remainder(method.interval, time_step)) > 1e-9) continue;
      Scene changed = scene;
      changed.coupling.void_fraction = method.scheme;
      changed.coupling.void_fraction_interval = method.interval;
      changed.fluid.time_step = time_step;
      const NoisePoint p = measure(changed, start, 0.2, 1.0);
      text += fmt::format("{},{:g},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:g},{}\n", method.name, p.time_step, p.rms,
                          p.low, p.high, p.mean, p.bed_weight, p.seconds, p.failure);
      write_file(file, text);
      say(p.failure.empty() ? fmt::format("{}, {:g} s: {:.1f} Pa ({:.1f} to {:.1f}) about {:.0f}", method.name,
                                          time_step, p.rms, p.low, p.high, p.mean)
                            : fmt::format("{}, {:g} s: {}", method.name, time_step, p.failure));
    }
}

std::vector<NoisePoint> load_study(const std::filesystem::path& file) {
  std::istringstream in(read_file(file));
  std::vector<NoisePoint> points;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with('#') || line.starts_with("method")) continue;
    const auto comma = line.find(',');
    std::istringstream rest(line.substr(std::min(line.size(), comma)));
    NoisePoint p{};
    p.method = line.substr(0, comma);
    char separator = 0;
    for (double* value : {&p.time_step, &p.rms, &p.low, &p.high, &p.mean, &p.bed_weight, &p.seconds})
      rest >> separator >> *value;
    if (!rest) throw std::runtime_error(fmt::format("{}:{}: not a row of the study", file.string(), number));
    rest >> separator;
    std::getline(rest, p.failure);
    points.push_back(p);
  }
  return points;
}

}  // namespace slfb::noise
