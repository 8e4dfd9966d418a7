#pragma once
/// What dam breaks have in common: how a run through the impact on the far wall is read, its energy, skin friction.

#include "solvers/fluids/tait.hpp"
#include "solvers/forces/skin_friction.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "vnv/case.hpp"
#include "vnv/judge/series.hpp"

#include <vector>

namespace touchstone::vnv {

inline constexpr double sampled_every = 1e-3;  // s  holds whole numbers of steps
inline constexpr double end_of_impact = 2;     // s

/// One column of what a run monitored, over time [s], in its unit.
Series followed(const Run& run, std::size_t column);

/// The particles within a strip of x, which is all that a gauge or a sensor sees.
Samples within(const Samples& samples, double low, double high);

/// Kinetic and potential energy of water and what compression holds. Water that has come apart bears no tension, and
/// its density says nothing.
std::vector<double> energies(const Samples& samples, const Tait& water, double gravity);
inline const std::vector<Quantity> quantities_of_energies{
    {"kinetic energy", "J/m"}, {"potential energy", "J/m"}, {"elastic energy", "J/m"}};

/// The potential energy that a column loses until it lies flat in its tank, the fall [J/m].
constexpr double fall_of(double density, double gravity, double length, double height, double tank_length) {
  return density * gravity * length * height * height / 2 * (1 - length / tank_length);
}

inline const Quantity energy_made{"largest rise of the total energy over the fall", "", Kind::invariant,
                                  Better::smaller};
inline Claim makes_no_energy(const Quantity& made = energy_made) {
  return at_most(made, 0.01, theory("gravity is the only source of energy"));
}
/// Over `fall` [J/m], of the sum of three columns that were monitored, of which `kinetic` is the first.
double largest_rise_of_energy(const Run& run, std::size_t kinetic, double fall);

/// The same column released at once, for methods that have no walls with an extent.
Scene<Tait, Uniform> without_gates(Scene<Tait, Uniform> scene);

/// The same column, with the skin friction of its tank, to which gravity is added.
Scene<Tait, SkinFriction> with_friction(const Scene<Tait, Uniform>& scene, SkinFriction friction);

}  // namespace touchstone::vnv
