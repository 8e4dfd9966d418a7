#include "vnv/stability/methods_on_lattice.hpp"

#include "solvers/forces/uniform.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "vnv/flows/channels/channel.hpp"
#include "vnv/methods/free_surface_methods.hpp"

#include <stdexcept>

namespace touchstone::vnv {
namespace {

constexpr double output_interval = 1;  // s
constexpr int restores = 30;           // steps  between two restorations of density in printed SPH

/// A method of methods.hpp or free_surface_methods.hpp; the latter are compiled for scenes with a force.
template <class Make>
OnLattice plain(Make make) {
  return [=](const RestingLattice& lattice, const Start& start) { return make(lattice.scene(start)); };
}
template <class Make>
OnLattice forced(Make make) {
  return [=](const RestingLattice& lattice, const Start& start) {
    return make(lattice.scene(start, Uniform{Vec2::Zero()}));
  };
}

/// A method of the channels, in steps in which sound travels a fraction of a spacing.
template <class MakeSolver>
OnLattice of_channel(const std::string& name, const std::string& words, double courant, MakeSolver solver) {
  return [=](const RestingLattice& lattice, const Start& start) {
    const Scene<Newtonian> scene = lattice.scene(start);
    return simulating(
        {.name = name, .family = Family::sph, .description = words, .tolerance = stretched, .relative_cost = 2},
        [=](const Level& level, double time_step) { return solver(scene, level, time_step); },
        by_spacings(scene, courant, output_interval));
  };
}

/// Artificial viscosity acts between particles that close in and not between those that part: at rest it has no
/// derivative. In a wave each pair does both, half of the time, so linear theory has half of it at all times.
struct HalfOfArtificialViscosity : sph::ArtificialViscosity {
  template <class Real>
  sph::Acceleration<Real> acceleration(const sph::Pair<Real>& ij, const Real& per_divisor) const {
    const Real c = ij.mass * ij.slope * NumberIn<Real>(alpha * sound_speed * h) * ij.v_dot_r() * per_divisor;
    return {c * ij.x, c * ij.y};
  }
  template <class Real>
  sph::Acceleration<Real> operator()(const sph::Pair<Real>& ij) const {
    return acceleration(ij, Real(1 / divisor(ij)));
  }
};

/// The same, whole.
struct WholeArtificialViscosity : sph::ArtificialViscosity {};

/// Printed SPH with one of the pressure terms and one of the artificial viscosities.
template <class PressureTerm, class Artificial>
OnLattice printed_with(const std::string& name, const std::string& words) {
  return of_channel(name, words, 0.25, [](const Scene<Newtonian>& scene, const Level& level, double time_step) {
    const double h = level.smoothing_or(1.2 * level.spacing);
    return sph::printed<sph::CubicSpline>(
        scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
        sph::momentum(PressureTerm{}, sph::LaminarViscosity{.nu = scene.fluid.kinematic_viscosity(), .eta = 0.1 * h},
                      Artificial{{.alpha = 0.01, .sound_speed = scene.fluid.sound_speed(), .h = h}}));
  });
}
template <class PressureTerm>
OnLattice linear_printed() {
  return printed_with<PressureTerm, HalfOfArtificialViscosity>("linear", "");
}

}  // namespace

std::vector<LatticeMethod> methods_on_lattice() {
  using Still = Scene<Newtonian>;
  using Forced = Scene<Newtonian, Uniform>;
  std::vector<LatticeMethod> all = {
      {plain([](const Still& s) { return mpm_as_printed(s, output_interval); })},
      {plain([](const Still& s) { return mpm_affine(s, output_interval); })},
      {forced([](const Forced& s) { return mpm_apic(s, output_interval); })},
      {forced([](const Forced& s) { return mpm_xpic(s, output_interval); })},
      {plain([](const Still& s) { return mpm_least_squares(s, output_interval); }), true},
      {plain([](const Still& s) { return sph_as_printed(s, output_interval); }), false, restores,
       linear_printed<sph::Pressure>()},
      {printed_with<sph::PressureDifference, WholeArtificialViscosity>(
           "sph_difference", channel::sph_printed_words + channel::difference_words),
       false, restores, linear_printed<sph::PressureDifference>()},
      {.on = of_channel("sph_regularised", channel::sph_regularised_words, 0.5,
                        [](const Still& s, const Level& level, double time_step) {
                          return sph_regularised_solver<>(s, level, time_step);
                        }),
       .one_kernel = true},
      {.on = of_channel("sph_one_evaluation", channel::sph_regularised_words + channel::one_evaluation_words, 0.5,
                        [](const Still& s, const Level& level, double time_step) {
                          return sph_regularised_solver<AdamsBashforth>(s, level, time_step);
                        }),
       .one_kernel = true},
      {plain([](const Still& s) { return sph_transport_velocity(s, output_interval); })},
      {plain([](const Still& s) { return sph_second_order(s, output_interval); })},
      {forced([](const Forced& s) { return sph_delta(s, output_interval); })},
      {forced([](const Forced& s) { return sph_corrected(s, output_interval); })},
      {plain([](const Still& s) { return sph_shifted(s, output_interval); })},
  };
  // A grid is at rest, and so is what the drift of the transport velocity carries.
  for (LatticeMethod& method : all) {
    const std::string name = method.name();
    method.keeps_volume = method.one_kernel || name == "sph_transport_velocity";
    method.claims_to_be_galilean =
        name == "mpm_least_squares" || (!method.has_grid() && name != "sph_transport_velocity");
  }
  return all;
}

std::vector<LatticeMethod> methods_of_any_precision() {
  using Still = Scene<Newtonian>;
  const OnLattice mpm = [](const RestingLattice& lattice, const Start& start) {
    const Still scene = lattice.scene(start);
    return simulating(
        {.name = "mpm_float",
         .family = Family::mpm,
         .description = channel::mpm_words + channel::float_words,
         .tolerance = stretched},
        [=](const Level& level, double time_step) {
          return mpm_solver<mpm::PrescribedMotion, float>(scene, level, time_step);
        },
        by_cells(scene, 0.5, output_interval));
  };
  std::vector<LatticeMethod> all = methods_on_lattice();
  all.push_back({.on = mpm,
                 .linear = plain([](const Still& s) { return mpm_as_printed(s, output_interval); }),
                 .at_night_only = true});
  all.push_back({.on = of_channel("sph_regularised_float",
                                  channel::sph_regularised_words + " Sums over pairs in single precision.", 0.5,
                                  [](const Still& s, const Level& level, double time_step) {
                                    return sph_regularised_solver<KickDriftKick, float>(s, level, time_step);
                                  }),
                 .linear = method_on_lattice("sph_regularised").on,
                 .one_kernel = true,
                 .at_night_only = true});
  return all;
}

std::vector<Method> each_of(const std::vector<LatticeMethod>& all, Method (*make)(const LatticeMethod&)) {
  std::vector<Method> methods;
  for (const LatticeMethod& method : all) methods.push_back(make(method));
  return methods;
}

LatticeMethod method_on_lattice(const std::string& name) {
  for (LatticeMethod& method : methods_on_lattice())
    if (method.name() == name) return method;
  throw std::invalid_argument(fmt::format("stability: no method '{}' on a lattice", name));
}

}  // namespace touchstone::vnv
