#pragma once
/// All methods of the project on a resting lattice.

#include "vnv/methods/methods.hpp"
#include "vnv/stability/named_runs.hpp"
#include "vnv/stability/resting_lattice.hpp"

namespace touchstone::vnv {

/// A method, and which lattices it is asked for: of MPM so many particles across a cell.
struct LatticeMethod {
  OnLattice on;
  bool fits = false;   // needs several particles in a cell
  int every = 1;       // steps  after which it does again what it does in turn, as to reinitialise densities
  OnLattice linear{};  // what linear theory is asked of instead, where the method has no derivative at rest

  bool one_kernel = false;             // has a ratio of h to the spacing that it is not asked to change
  bool keeps_volume = false;           // takes a uniform pressure away, since the fluid fills its domain
  bool claims_to_be_galilean = false;  // that all is the same for one who is carried along
  bool at_night_only = false;          // only in the longest suite, on the plainest lattices

  const OnLattice& for_theory() const { return linear ? linear : on; }

  std::string name() const { return on({}, {}).name; }
  bool has_grid() const { return on({}, {}).family == Family::mpm; }

  /// The lattice that it is run on where nothing else is said: 16 particles across with four in each cell of its grid,
  /// or `particles_across` without a grid.
  RestingLattice usual_lattice(int particles_across = 16) const {
    if (has_grid()) return {.cells = 8, .points = 2};
    return {.cells = particles_across};
  }
};

/// A method by solver(scene, level, time step [s]), in steps in which sound travels a fraction of a cell or, in SPH, of
/// a spacing.
template <class MakeSolver>
OnLattice solved_by(const Method& method, double courant, MakeSolver solver) {
  constexpr double output_interval = 1;  // s
  return [=](const RestingLattice& lattice, const Start& start) {
    const Scene<Newtonian> scene = lattice.scene(start);
    return simulating(
        method, [=](const Level& level, double time_step) { return solver(scene, level, time_step); },
        [=, has_cells = method.family == Family::mpm](const Level& level) {
          return step_for(scene, courant, has_cells ? level.cell : level.spacing, output_interval);
        });
  };
}

std::vector<LatticeMethod> methods_on_lattice();

/// The same, and those whose particles, or sums over pairs, are in single precision. Rounding hides what linear theory
/// asks for: that is asked of the same methods in double precision.
std::vector<LatticeMethod> methods_of_any_precision();

/// What a case makes of each.
std::vector<Method> each_of(const std::vector<LatticeMethod>& all, Method (*make)(const LatticeMethod&));

/// The one of a name, in double precision. Throws std::invalid_argument for a name that none has.
LatticeMethod method_on_lattice(const std::string& name);

}  // namespace touchstone::vnv
