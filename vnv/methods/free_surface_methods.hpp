#pragma once
/// Methods made of parts (solvers/mpm/lanes/in_lanes.hpp, solvers/sph/free_surface/free_surface.hpp), as flows with
/// a free surface run them.

#include "vnv/methods/methods.hpp"

namespace touchstone::vnv {

/// MPM with quadratic B-splines, MUSL and affine densities; sound travels half a cell in a step. Affine particle
/// velocities [Jiang et al. 2015].
Method mpm_apic(const auto& scene, double output_interval);
/// The same with XPIC(5) [Hammerquist & Nairn 2017].
Method mpm_xpic(const auto& scene, double output_interval);

/// The parameters of a method of smoothed particle hydrodynamics for free surfaces besides its parts.
struct SphChoice {
  double ratio = 2;      // -  h over the spacing
  double alpha = 0.02;   // -  artificial viscosity, where the fluid has none of its own
  double courant = 0.5;  // -  acoustic Courant number c dt / h
};

/// delta-SPH [Antuono et al. 2010].
Method sph_delta(const auto& scene, double output_interval, const SphChoice& choice = {});

/// The same with particles that are shifted from where they are crowded [Lind et al. 2012; Sun et al. 2017].
Method sph_shifted(const auto& scene, double output_interval, const SphChoice& choice = {});

/// delta-SPH with gradients of the kernel that are exact for linear fields.
Method sph_corrected(const auto& scene, double output_interval, const SphChoice& choice = {});

}  // namespace touchstone::vnv
