#pragma once

#include "solver/laws/user_law.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {

/// The drag of a scene as formulas for homogeneous beds need it: its law, times α where
/// coupling.drag_times_voidage asks for that.
struct SceneDragLaw {
  drag::DragLawKernels law;
  bool times_voidage;

  /// F [-]
  double operator()(drag::SuspensionFlow flow) const { return (times_voidage ? flow.voidage : 1.0) * law(flow); }
};

/// \throws as find_drag_law
inline SceneDragLaw scene_drag_law(const Scene& scene) {
  return {find_drag_law(scene.coupling.drag_law), scene.coupling.drag_times_voidage};
}

}  // namespace slfb
