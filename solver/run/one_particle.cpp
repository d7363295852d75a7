#include "solver/run/one_particle.hpp"

#include <cvode/cvode.h>
#include <fmt/core.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "correlations/materials.hpp"
#include "solver/dem/lubrication.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {
namespace {

struct Problem {
  const OneParticleFall& fall;
  std::function<double(drag::SuspensionFlow)> law;
};

int derivative(realtype /*time*/, N_Vector state, N_Vector rate, void* data) {
  const auto& [fall, law] = *static_cast<const Problem*>(data);
  const double velocity = NV_Ith_S(state, 1), slip = fall.liquid_velocity - velocity;
  const double volume = std::numbers::pi / 6.0 * std::pow(fall.diameter, 3);
  const double reynolds = fall.liquid_density * fall.voidage * std::abs(slip) * fall.diameter / fall.viscosity;
  const double drag =
      volume *
      drag::exchange_per_solid_volume(law({fall.voidage, reynolds}), fall.voidage, fall.diameter, fall.viscosity) *
      slip;
  double wall_drag = fall.wall_drag;
  if (fall.above_bottom) {
    const double relative_gap = NV_Ith_S(state, 0) / (0.5 * fall.diameter) - 1.0;
    if (relative_gap <= 0.0) return 1;  // too long a step: CVODE tries a shorter one
    wall_drag += dem::brenner_wall_drag(relative_gap) - 1.0;
  }
  const double wall_force = -3.0 * std::numbers::pi * fall.viscosity * fall.diameter * wall_drag * velocity;
  const double inertia = (fall.density + fall.added_mass * fall.liquid_density) * volume;
  NV_Ith_S(rate, 0) = velocity;
  NV_Ith_S(rate, 1) =
      (drag + wall_force - (fall.density - fall.surrounding_density) * volume * gravitational_acceleration) / inertia;
  return std::isfinite(drag) ? 0 : -1;
}

void check(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(fmt::format("one-particle motion: {} failed with CVODE flag {}", what, flag));
}

}  // namespace

std::vector<FallState> integrate_fall(const OneParticleFall& fall, const std::vector<double>& times) {
  Problem problem{fall, find_drag_law(fall.drag_law)};
  SUNContext raw_context = nullptr;
  check(SUNContext_Create(nullptr, &raw_context), "SUNContext_Create");
  const auto free_context = [](SUNContext context) { SUNContext_Free(&context); };
  const std::unique_ptr<std::remove_pointer_t<SUNContext>, decltype(free_context)> context(raw_context, free_context);
  const std::unique_ptr<std::remove_pointer_t<N_Vector>, decltype(&N_VDestroy)> state(N_VNew_Serial(2, raw_context),
                                                                                      &N_VDestroy);
  NV_Ith_S(state.get(), 0) = fall.height;
  NV_Ith_S(state.get(), 1) = fall.velocity;
  const auto free_solver = [](void* solver) { CVodeFree(&solver); };
  const std::unique_ptr<void, decltype(free_solver)> solver(CVodeCreate(CV_BDF, raw_context), free_solver);
  const std::unique_ptr<std::remove_pointer_t<SUNMatrix>, decltype(&SUNMatDestroy)> matrix(
      SUNDenseMatrix(2, 2, raw_context), &SUNMatDestroy);
  const std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, decltype(&SUNLinSolFree)> linear(
      SUNLinSol_Dense(state.get(), matrix.get(), raw_context), &SUNLinSolFree);
  if (times.empty()) return {};
  check(CVodeInit(solver.get(), derivative, times.front(), state.get()), "CVodeInit");
  check(CVodeSStolerances(solver.get(), 1e-10, 1e-12), "CVodeSStolerances");
  check(CVodeSetUserData(solver.get(), &problem), "CVodeSetUserData");
  check(CVodeSetLinearSolver(solver.get(), linear.get(), matrix.get()), "CVodeSetLinearSolver");
  check(CVodeSetMaxNumSteps(solver.get(), 100000), "CVodeSetMaxNumSteps");

  std::vector<FallState> states{{times.front(), fall.height, fall.velocity}};
  for (std::size_t k = 1; k < times.size(); ++k) {
    realtype reached = 0.0;
    check(CVode(solver.get(), times[k], state.get(), &reached, CV_NORMAL), "CVode");
    states.push_back({reached, NV_Ith_S(state.get(), 0), NV_Ith_S(state.get(), 1)});
  }
  return states;
}

}  // namespace slfb
