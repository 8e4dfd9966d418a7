/// Stiff and extreme periodic flows, each with its outcome declared in advance.

#include "vnv/stability/extreme.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/methods_on_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double c = RestingLattice::sound_speed;
constexpr double base_reynolds = 100;  // of a shear wave, by its amplitude and wavelength
constexpr double base_mach = 0.1;

/// A wave of velocity along x, one up the lattice, of an inviscid or viscous fluid.
struct Wave {
  double mach, reynolds;

  RestingLattice on(RestingLattice lattice) const {
    lattice.reynolds = reynolds / mach * RestingLattice::spacing / lattice.side();
    return lattice;
  }
  Start start(const RestingLattice& lattice) const {
    return {
        .velocity = [u = mach * c, side = lattice.side()](const Vec2& x) { return Vec2(u * wave_at(x.y(), side), 0); }};
  }
};

/// How far its height is from what viscosity leaves of it, over that at the start [%].
std::function<double(const Samples&)> error_of(const Wave& wave, const RestingLattice& lattice) {
  const double side = lattice.side(), decay = decay_of_wave(lattice.kinematic_viscosity(), side);
  return [=](const Samples& s) {
    return 100 * std::abs(amplitude_of_wave(s, side) / (wave.mach * c) - std::exp(-decay * s.time));
  };
}

/// Methods whose particles take their velocities from the grid lose some in every step, whatever the viscosity: in
/// fluids that are too thin or too stiff for that to be little they stay stable but not accurate. So does least squares
/// in eight cells, each time it puts particles back on their lattice.
Ending as_damped(const LatticeMethod& method, Ending usual) {
  return method.has_grid() && method.name() != "mpm" && method.name() != "mpm_float" ? Ending::stable : usual;
}

/// A lattice from a start, for so many steps of the method's own choice.
Extreme many_steps(const std::string& name, const LatticeMethod& method, const RestingLattice& lattice,
                   const Start& start, double steps, Ending declared) {
  const Method here = method.on(lattice, start);
  const double dt = here.time_step(lattice.level());
  return {
      .name = name, .make = [=] { return here.solver(lattice.level(), dt); }, .end = steps * dt, .declared = declared};
}

/// The wave until it has lost half of its height, for at least 100 and at most 1000 steps.
Extreme shear(const std::string& name, const LatticeMethod& method, const Wave& wave, Ending declared) {
  const RestingLattice lattice = wave.on(method.usual_lattice());
  Extreme decay = many_steps(name, method, lattice, wave.start(lattice), 1, declared);
  const double dt = decay.end,
               half_time = std::numbers::ln2 / decay_of_wave(lattice.kinematic_viscosity(), lattice.side());
  decay.end = std::clamp(half_time, 100 * dt, 1000 * dt);
  decay.error = error_of(wave, lattice);
  decay.accurate_within = 5;
  return decay;
}

/// Carried along so fast, and with such a step, that sound and flow together cross 0.99 lengths in it.
Extreme across_the_periodic_boundaries(const LatticeMethod& method) {
  const RestingLattice lattice = method.usual_lattice();
  const Vec2 flow = c * Vec2(0.8, 0.6);
  const double dt = 0.495 * lattice.unit() / c;
  const Method here = method.on(lattice, {.velocity = [=](const Vec2&) { return flow; }});
  return {.name = "through both seams at (c + v) dt = 0.99",
          .make = [=] { return here.solver(lattice.level(), dt); },
          .end = 500 * dt,
          .error = [=](const Samples& s) { return 100 * (s.v.colwise() - flow).colwise().norm().maxCoeff() / c; },
          .accurate_within = 0.1,
          .declared = Ending::accurate,
          .stepping = Stepping::as_given};
}

/// Particles that start on top of each other stay there if only differences of pressure push: their densities run
/// away. The spreading of the regularised method, made for small disorder, throws them apart faster than sound.
Ending borne_by(const std::string& method) {
  return method == "sph_difference" || method.starts_with("sph_regularised") || method == "sph_one_evaluation"
             ? Ending::diverged
             : Ending::stable;
}

/// Particles anywhere, as many as there would be, with the density of rest.
Extreme at_random(const LatticeMethod& method) {
  const RestingLattice lattice = method.usual_lattice();
  Start start = noisy(lattice, 1e-3);
  start.places = [side = lattice.side()](const Vectors& places) {
    Vectors random = places;
    for (Eigen::Index p = 0; p < places.cols(); ++p)
      random.col(p) = side / 2 * Vec2(1 + noise(p, 1, 2), 1 + noise(p, 3, 4));
    return random;
  };
  return many_steps("particles at random", method, lattice, start, 500, borne_by(method.name()));
}

/// Noise of 1e-6 times the speed of sound must not grow tenfold in about a million steps.
Extreme at_rest_for_long(const LatticeMethod& method) {
  RestingLattice lattice = method.usual_lattice();
  lattice.cells /= 2;
  // The methods that are made of parts take half a microsecond or more for a particle's step.
  const std::array slow = {"mpm_apic", "mpm_xpic", "sph_corrected", "sph_shifted"};
  const bool is_slow = std::ranges::find(slow, method.name()) != slow.end();
  Extreme rest = many_steps(is_slow ? "a hundred thousand steps at rest" : "a million steps at rest", method, lattice,
                            noisy(lattice, 1e-6), is_slow ? 1e5 : 1e6, Ending::accurate);
  rest.error = [](const Samples& s) { return 100 * s.v.colwise().norm().maxCoeff() / c; };
  rest.accurate_within = 1e-3;
  rest.in_acceptance = false;
  return rest;
}

Method method_meeting_extremes(const LatticeMethod& method) {
  return meeting(
      method.on({}, {}),
      {shear("viscosity x 1e4", method, {base_mach, 1e-4 * base_reynolds}, Ending::accurate),
       shear("viscosity x 1e-4", method, {base_mach, 1e4 * base_reynolds}, as_damped(method, Ending::accurate)),
       shear("K x 1e4, Mach 1e-5", method, {1e-4 * base_mach, base_reynolds}, as_damped(method, Ending::accurate)),
       shear("K so soft that Mach is 0.7", method, {0.7, base_reynolds}, Ending::stable),
       across_the_periodic_boundaries(method), at_random(method), at_rest_for_long(method)});
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Stiff and extreme periodic flows",
      .description =
          "A doubly periodic square of 16 by 16 particles, with the time step that each method chooses. "
          "A shear wave decays in fluids ten thousand times more viscous, less viscous and stiffer than usual, and in one so "
          "compressible that the Mach number is 0.7; fluid is advected across both periodic boundaries; particles start at random; "
          "and fluid stays at rest for a million steps, a tenth as many with the most expensive methods. The outcome of each is declared in advance.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_of_any_precision(), method_meeting_extremes),
      .plots = {endings({"particles at random"})},
      .label = "stability",
  };
}
