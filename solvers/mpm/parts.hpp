#pragma once
/// Parts of which a material point method is made besides a shape. They are names: what they do is written once in
/// plain loops (plain/plain.hpp) and once in vector lanes (lanes/); `MlsApic` in lanes alone.

#include <limits>

namespace touchstone::mpm {

/// Particles keep their velocities and take from the nodes by how much these change (FLIP, Brackbill & Ruppel 1986).
/// Linear momentum is conserved; what no node sees is never damped.
struct Flip {};

/// Particles take from the nodes their velocity and how it changes around them, v + C (x - x_p) (APIC, Jiang,
/// Schroeder, Selle, Teran & Stomakhin, ACM Trans. Graph. 34 (2015) 51), with C = sum v_i (w_i (x_i - x_p) / D)^T.
///
/// Linear momentum is conserved; angular momentum, sum m_p (x_p x v_p + D_x C_yx - D_y C_xy), with shapes whose spread
/// D is the same everywhere: B-splines of second and third degree away from edges. With hats C is the slope of the
/// velocity.
struct Apic {};

/// APIC whose particles hold the stress as part of their affine velocity and give both at once (MLS-MPM, Hu et al., ACM
/// Trans. Graph. 37 (2018) 150), on quadratic B-splines that are whole up to walls. The fluid is strained by C, by the
/// velocities with which the nodes move, so that nothing is remapped. A change of the time step reaches the stress,
/// which particles hold as what it gives in a step, one step later.
///
/// Particles take their velocity from the nodes and remember no other: with many particles a wave of wave number k is
/// damped by (k cell)^4 / 40 a step. So the error of a viscous flow grows as the step gets shorter, and at a fixed
/// ratio of step to cell it is of third order. Measured in L2 with 4 particles per cell: Poiseuille flow at 1 s in 10,
/// 20, 40 and 80 cells 23.4, 3.80, 0.52 and 0.068 %, Couette flow at 0.1 s 9.4, 1.39, 0.18 and 0.022 %, with sound
/// crossing 0.8 cells a step; with 0.2 cells a step, in 10, 20 and 40 cells, 55, 13.2, 1.95 % and 25, 5.1, 0.71 %. Use
/// the longest stable step: 0.8 cells last; 1.2 last for thousands of steps from an even lattice, but not always
/// longer.
struct MlsApic {};

/// PIC whose smoothing is taken back to the order m (XPIC(m), Hammerquist & Nairn, Comput. Methods Appl. Mech. Eng. 318
/// (2017), 724-738): with S from nodes to particles and S⁺ from particles to nodes, velocities become
/// (I - (I - S S⁺)^m) v_p + S dv_i. XPIC(1) is PIC (Harlow 1964); for large m only what no node sees is damped. Linear
/// momentum is conserved. Places move with the nodes, as in the other transfers.
template <int m>
struct Xpic {
  static_assert(m >= 1);
};

/// Each particle carries its own density, changed by the divergence that it sees (19).
struct CarriedDensity {};

/// Densities go over the nodes in every step as velocities do in APIC: each particle gives the nodes its own and how it
/// changes around it, and takes back what they make of it. What the divergence at particles leaves between nodes, a
/// checkerboard or the noise of particles that cross cells, no longer gathers in the pressure; a linear field of
/// densities passes unchanged up to walls and surfaces, so a pressure that bears a weight is not flattened. The sum of
/// all specific volumes is kept.
///
/// Measured with B-splines of second degree, XPIC(5) in 25 x 25 cells, 4 particles each, sound 80 times as
/// fast as the flow: Taylor-Green vortices at 0.1 s are wrong by 0.51 % in velocity and 18 % in pressure, with carried
/// densities by 0.81 % and 1150 %. With APIC the pressure is wrong by 34 %, not 1090 %, and the velocity by 16 % either
/// way. Water 1 m deep in cells of 0.05 m, sound at 10 sqrt(g H), after 10 s: pressure 0.09 % with XPIC(5), 0.15 % with
/// APIC, kinetic below 2e-10 of the potential energy. Smoothing by plain means in place of the affine ones flattens the
/// pressure at the floor and at the surface: 2.5 % (means over cells) to 6.7 % (over nodes) after 2 s with APIC.
///
/// Where fluid does not fill its domain a node expands by `most_expansion` at most: what is rarer has come apart, bears
/// no more tension and forgets how far it was torn (README.md).
struct AffineDensity {
  static constexpr double most_expansion = 0.003;
};
/// The same without that bound.
struct UnboundedAffineDensity : AffineDensity {
  static constexpr double most_expansion = std::numeric_limits<double>::infinity();
};

}  // namespace touchstone::mpm
