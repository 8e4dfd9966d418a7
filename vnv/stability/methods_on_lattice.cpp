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

/// A method of the channels.
template <class MakeSolver>
OnLattice of_channel(const std::string& name, const std::string& words, double courant, MakeSolver solver) {
  return solved_by(
      {.name = name, .family = Family::sph, .description = words, .tolerance = stretched, .relative_cost = 2}, courant,
      solver);
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

/// Printed SPH with one of the pressure terms, as linear theory sees it.
template <class PressureTerm>
OnLattice linear_printed() {
  return of_channel("linear", "", 0.25, [](const Scene<Newtonian>& scene, const Level& level, double time_step) {
    const double h = level.smoothing_or(1.2 * level.spacing);
    return sph::printed<sph::CubicSpline>(
        scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
        sph::momentum(PressureTerm{}, sph::LaminarViscosity{.nu = scene.fluid.kinematic_viscosity(), .eta = 0.1 * h},
                      HalfOfArtificialViscosity{{.alpha = 0.01, .sound_speed = scene.fluid.sound_speed(), .h = h}}));
  });
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
      {of_channel("sph_difference", channel::sph_printed_words + channel::difference_words, 0.25,
                  sph_printed_solver<sph::PressureDifference, PredictorCorrector, Still>),
       false, restores, linear_printed<sph::PressureDifference>()},
      {.on = of_channel("sph_regularised", channel::sph_regularised_words, 0.5,
                        sph_regularised_solver<KickDriftKick, double, Still>),
       .one_kernel = true},
      {.on = of_channel("sph_one_evaluation", channel::sph_regularised_words + channel::one_evaluation_words, 0.5,
                        sph_regularised_solver<AdamsBashforth, double, Still>),
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
  std::vector<LatticeMethod> all = methods_on_lattice();
  all.push_back({.on = solved_by({.name = "mpm_float",
                                  .family = Family::mpm,
                                  .description = channel::mpm_words + channel::float_words,
                                  .tolerance = stretched},
                                 0.5, mpm_solver<mpm::PrescribedMotion, float, Still>),
                 .linear = plain([](const Still& s) { return mpm_as_printed(s, output_interval); }),
                 .at_night_only = true});
  all.push_back({.on = of_channel("sph_regularised_float",
                                  channel::sph_regularised_words + " Sums over pairs in single precision.", 0.5,
                                  sph_regularised_solver<KickDriftKick, float, Still>),
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
