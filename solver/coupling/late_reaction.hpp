#pragma once

#include "solver/scene/scene.hpp"

/// The liquid learns of what the spheres did only in its next step.
namespace slfb::coupling {

/// Least density of spheres over that of the liquid with which a uniform bed of this voidage is stable without contacts
/// and without drag [-].
///
/// Through a section flows as much as the inlet gives: with s = (1 − α)/α the liquid's velocity answers that of the
/// spheres as u^(n+1) = −s ṽ^n, where ṽ is what the void fractions of the steps before say, and the pressure that turns
/// the liquid moves the spheres by v^(n+1) − v^n = (ρ_L/ρ_P)(u^(n+1) − u^n). A disturbance that changes sign in each
/// step grows unless ρ_P/ρ_L > s in first order (ṽ = v^n); > 4 s in second order, where both differences in time reach
/// over three steps; > (3 − 2/N) s with void fractions every N steps, which extrapolate the spheres' way. With added
/// mass C in first order, whose force and reaction are one step late too, (ρ_P/ρ_L + C) a^(n+1) = −s (1 + C) a^n − s C
/// (1 + s) a^(n−1) for the accelerations a: stable for ρ_P/ρ_L > s − C (1 + s²) and > C (s + s² − 1); with the others
/// it is left out here. Drag, and contacts that last no longer than a liquid step, damp it. The same instability is
/// known of light structures in liquids (Causin et al. 2005, Comput. Methods Appl. Mech. Eng. 194, 4506). 0 for a
/// liquid that does not feel the spheres.
double least_density_ratio(const Scene& scene, double voidage);

/// Least density of the scene's bed spheres over that of the liquid [-]; infinite without bed spheres.
double density_ratio_of_bed(const Scene& scene);

}  // namespace slfb::coupling
