#include "solver/run/liquid_recorder.hpp"

#include <utility>
#include <vector>

namespace slfb::simulation {

LiquidRecorder::LiquidRecorder(const Scene& scene, const Model& model, RunResult& result) : result_(result) {
  if (model.liquid().two_way()) window_.emplace(model.liquid().grid(), scene.recording.fluctuation_window);
}

void LiquidRecorder::sample_fluctuation(const Model& model, double time) {
  if (window_) window_->sample(time, model.coupling().cell_velocity(), result_.fluctuation);
}

void LiquidRecorder::finish(const Model& model, double time) {
  if (!model.liquid().two_way()) return;
  record_plane(model, time);
  window_->reduce(result_.fluctuation);
}

/// Void fraction and velocity on the cells of the plane y = 0; their mean where the plane lies between two rows.
void LiquidRecorder::record_plane(const Model& model, double time) {
  const fluid::ColumnGrid& grid = model.liquid().grid();
  const auto voidage = model.coupling().void_fraction();
  const auto& velocity = model.coupling().cell_velocity();
  if (voidage.empty()) return;
  PlaneField plane;
  plane.time = time;
  const int rows = grid.squares(1), upper = rows / 2, lower = rows % 2 == 0 ? upper - 1 : upper;
  for (int ix = 0; ix < grid.squares(0); ++ix) plane.x.push_back(grid.lower(0) + (ix + 0.5) * grid.spacing(0));
  for (int k = 0; k < grid.layers(); ++k) {
    plane.z.push_back((k + 0.5) * grid.cell_height());
    for (int ix = 0; ix < grid.squares(0); ++ix) {
      const auto mean = [&](const std::vector<double>& field) {
        const auto at = [&](int iy) {
          return field[static_cast<std::size_t>(grid.cell_of_square(ix, iy) * grid.layers() + k)];
        };
        return 0.5 * (at(lower) + at(upper));
      };
      plane.voidage.push_back(mean(voidage));
      plane.velocity_x.push_back(mean(velocity[0]));
      plane.velocity_z.push_back(mean(velocity[2]));
    }
  }
  result_.plane = std::move(plane);
}

}  // namespace slfb::simulation
