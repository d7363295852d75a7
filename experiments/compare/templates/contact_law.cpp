// A contact law for `slfb compare --contact A,B,THIS_FILE.cpp` and for contact.law = "THIS_FILE.cpp" in a scene.
//
// Change the formula, the name and the range. The struct has the shape of the laws in solver/dem/
// (linear_spring_dashpot.hpp, hertz_mindlin.hpp), so that any of them can be copied here, and this one moved there once
// it is wanted in the suite.

#include "solver/dem/contact_law.hpp"

#include <cmath>

namespace {

using namespace slfb;

struct MyLaw {
  static constexpr dem::ContactLawInfo info{
      .name = "my-law",  // lower-case letters, digits and '-'; not the name of a law of the suite
      .title = "Linear spring and dashpot without corrections for the step",
      .equation = "F_n = k_n d + c_n d', c_n = 2 zeta sqrt(k_n m_eff)",
      .source = "mine",
      .overlap = {0.0, 0.05},         // largest overlap over effective radius for which it is meant
      .stiffness_key = "stiffness"};  // the key of [contact] that makes it stiffer, for messages

  /// Takes what it needs from [contact] of the scene (solver/scene/scene.hpp); stiffness and youngs_modulus are 0 where
  /// the scene does not give them. `at_wall`: the second body is a wall.
  explicit MyLaw(const Contact& contact, bool /*at_wall*/)
      : stiffness_(contact.stiffness),
        damping_(2.0 * dem::damping_ratio(contact.restitution) * std::sqrt(contact.stiffness)),
        tangential_stiffness_(contact.tangential_stiffness_ratio * contact.stiffness),
        tangential_damping_ratio_(contact.tangential_damping_ratio) {}

  /// Called for every contact in every step. `overlap` δ > 0 [m]; `approach` δ', positive while they near each other
  /// [m/s]; `root_effective_mass` √(m_1 m_2/(m_1 + m_2)) [kg^½]; `effective_radius` r_1 r_2/(r_1 + r_2) [m]; at a wall
  /// mass and radius of the sphere.
  dem::NormalContact operator()(double overlap, double approach, double root_effective_mass,
                                double /*effective_radius*/) const {
    const double damping = damping_ * root_effective_mass;
    const double force = stiffness_ * overlap + damping * approach;
    return {.force = force,           // on the spheres, compressive positive [N]
            .load = force,            // what friction goes by [N]
            .stiffness = stiffness_,  // ∂F_n/∂δ without damping: the bound of the step comes from it [N/m]
            .tangential_stiffness = tangential_stiffness_,               // of the friction's spring [N/m]
            .tangential_damping = tangential_damping_ratio_ * damping};  // of its dashpot [N s/m]
  }

  // Friction is Coulomb's with that spring and dashpot (solver/dem/coulomb_friction.hpp). For another one, write a type
  // of the same shape and name it here: using Friction = MyFriction;

 private:
  double stiffness_, damping_, tangential_stiffness_, tangential_damping_ratio_;
};

}  // namespace

SLFB_CONTACT_LAW(MyLaw)
