#pragma once

#include <array>
#include <cstddef>

#include "solver/dem/contact_batch.hpp"
#include "solver/dem/contact_law_info.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::dem {

/// Forces and torques of the first `count` contacts of a batch, a multiple of four. `contact`: at walls that of
/// Contact::at_wall(); `spring_phase`: see CoulombFriction.
using ContactKernel = void (*)(ContactBatch& batch, std::size_t count, const Contact& contact, double spring_phase);

/// A contact law that is chosen while the program runs: by name, or from a C++ file outside the suite.
struct ContactLawKernels {
  ContactLawInfo info;
  /// One batch per call, law, friction and rolling resistance inlined in the loop: by the rolling resistance (none,
  /// constant torque, elastic-plastic), between spheres and at a wall.
  std::array<std::array<ContactKernel, 2>, 3> compute;
  /// The normal law alone.
  NormalContact (*normal)(const Contact& contact, bool at_wall, double overlap, double approach,
                          double root_effective_mass, double effective_radius);

  /// ∂F_n/∂δ of the elastic part [N/m]. `overlap` δ [m], `effective_radius` r_i r_j/(r_i + r_j), at a wall r_i [m].
  [[nodiscard]] double stiffness(const Contact& contact, bool at_wall, double overlap, double effective_radius) const {
    return normal(contact, at_wall, overlap, 0.0, 1.0, effective_radius).stiffness;
  }
};

/// Index of the rolling resistance of a scene in ContactLawKernels::compute.
inline std::size_t rolling_index(const Contact& contact) {
  if (contact.rolling_friction == 0.0) return 0;
  return contact.rolling_model == RollingModel::constant_torque ? 1 : 2;
}

/// The tangential law of a contact law: its own type `Friction`, or Coulomb's.
template <class Law>
struct FrictionOf {
  using Type = CoulombFriction;
};
template <class Law>
requires requires { typename Law::Friction; }
struct FrictionOf<Law> {
  using Type = typename Law::Friction;
};

template <class Law>
constexpr ContactLawKernels contact_kernels_of() {
  constexpr auto kernel = []<bool at_wall, class Rolling>() -> ContactKernel {
    return [](ContactBatch& batch, std::size_t count, const Contact& contact, double spring_phase) {
      compute_contacts<at_wall>(batch, count, Law(contact, at_wall),
                                typename FrictionOf<Law>::Type{contact.sliding_friction, spring_phase},
                                Rolling(contact, spring_phase), contact.time_step);
    };
  };
  constexpr auto both = [kernel]<class Rolling>() {
    return std::array{kernel.template operator()<false, Rolling>(), kernel.template operator()<true, Rolling>()};
  };
  return {Law::info,
          {both.template operator()<NoRollingResistance>(), both.template operator()<ConstantRollingTorque>(),
           both.template operator()<ElasticPlasticRolling>()},
          [](const Contact& contact, bool at_wall, double overlap, double approach, double root_effective_mass,
             double effective_radius) -> NormalContact {
            return Law(contact, at_wall)(overlap, approach, root_effective_mass, effective_radius);
          }};
}

}  // namespace slfb::dem

/// Hands the contact law of a file outside the suite over: the last line of that file.
#define SLFB_CONTACT_LAW(Law)                                     \
  extern "C" const slfb::dem::ContactLawKernels slfb_contact_law; \
  const slfb::dem::ContactLawKernels slfb_contact_law = slfb::dem::contact_kernels_of<Law>();
