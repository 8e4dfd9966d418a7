/// Where each method is stable, and where it is right: over the acoustic and the viscous Courant number, and over
/// stiffness and Reynolds number with the step that it chooses.

#include "solvers/diverged.hpp"
#include "vnv/stability/lattice_noise.hpp"
#include "vnv/stability/methods_on_lattice.hpp"
#include "vnv/stability/spectrum.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <optional>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

const std::string over_courant_numbers = "Courant numbers", over_fluids = "fluids";
const std::string share_stable = "share of the map that is stable [%]",
                  stable_as_theory = "share of the map where theory and trial agree on stability [%]",
                  share_right = "share of the map that is stable and right [%]",
                  stable_where_made_for = "share of the map up to Mach 0.32 and Reynolds 100 that is stable [%]";

constexpr double c = RestingLattice::sound_speed;
constexpr double U = 0.01 * c;         // m/s  of the wave
constexpr double inaccurate_from = 5;  // %  of the velocity at the end of a trial

enum class Ending { right, unstable, inaccurate };
constexpr std::array names{"stable", "unstable", "stable, but off by more than 5 %"};

RestingLattice lattice_for(const LatticeMethod& method, double reynolds) {
  if (method.family == Family::sph) return {.cells = 16, .reynolds = reynolds};
  return {.cells = 8, .points = 2, .reynolds = reynolds};
}

/// A wave of velocity along x, one up the lattice, and a millionth of it noise.
Start wave_on(const RestingLattice& lattice) {
  Start start = noisy(lattice, 1e-6 * U / c);
  start.velocity = [side = lattice.side(), stir = start.velocity](const Vec2& x) -> Vec2 {
    return stir(x) + Vec2(U * std::sin(2 * std::numbers::pi * x.y() / side), 0);
  };
  return start;
}

/// How large the wave is: its part of the particles' velocities [m/s].
double amplitude(const Samples& s, double side) {
  const Scalars wave = (2 * std::numbers::pi / side * s.x.row(1).transpose().array()).sin();
  return (s.v.row(0).transpose().array() * wave).sum() / wave.square().sum();
}

/// A wave that decays as the steps go, until it has lost half of its height, but no longer than `most` steps and no
/// shorter than 400: stable if nothing moves as it never does, right if its height is as it should be at the end.
Ending tried(Simulation simulation, double side, double nu, double speed = U) {
  constexpr long least = 400, most = 1500;
  const double decay = nu * std::pow(2 * std::numbers::pi / side, 2), dt = simulation.time_step();  // 1/s, s
  const long judged_at = std::clamp(std::lround(std::numbers::ln2 / (decay * dt)), 1l, most);
  double error = 0;
  try {
    for (long k = 1; k <= std::max(judged_at, least); ++k) {
      simulation.step();
      if (k % 25 != 0 && k != judged_at) continue;
      const Samples s = simulation.samples();
      if (!(s.v.allFinite() && s.v.colwise().norm().maxCoeff() < 3 * speed)) return Ending::unstable;
      if (k == judged_at) error = 100 * std::abs(amplitude(s, side) / speed - std::exp(-decay * s.time));
    }
  } catch (const Diverged&) {
    return Ending::unstable;
  }
  return error > inaccurate_from ? Ending::inaccurate : Ending::right;
}

/// Points of a map, by verdict.
class Map {
 public:
  explicit Map(const std::string& figure) {
    for (const char* name : names) curves_.push_back({figure, name, Role::ours, {}, {}, true});
  }
  void add(double x, double y, Ending ending) {
    Curve& curve = curves_[static_cast<std::size_t>(ending)];
    curve.x.push_back(x);
    curve.y.push_back(y);
  }
  double share(Ending ending) const {  // %
    std::size_t all = 0;
    for (const Curve& curve : curves_) all += curve.x.size();
    return 100 * static_cast<double>(curves_[static_cast<std::size_t>(ending)].x.size()) / static_cast<double>(all);
  }
  void give_to(Run& run) const {
    for (const Curve& curve : curves_)
      if (!curve.x.empty()) run.curves.push_back(curve);
  }

 private:
  std::vector<Curve> curves_;
};

std::string figure_of(const std::string& map, const LatticeMethod& method) {
  return (map == over_fluids ? "fluids_" : "numbers_") + method.name();
}

std::vector<double> rising(double from, double to, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(from * std::pow(to / from, k / (count - 1.0)));
  return all;
}

Run finished(const CostMeter& meter) {
  Run run;
  run.summary.finished = true;
  run.summary.outcome = "finished";
  run.summary.cost = meter.read();
  run.summary.cost.stepping = run.summary.cost.wall;
  run.summary.cost.particles = 256;
  run.summary.cost.steps = 1;
  return run;
}

/// The lattice on which sound travels `acoustic` unit cells in a step while momentum diffuses over sqrt(`viscous`) of
/// them.
RestingLattice lattice_at(const LatticeMethod& method, double acoustic, double viscous) {
  return lattice_for(method, acoustic / viscous / lattice_for(method, 1).points);
}

/// Whether linear theory says that noise grows; on few cells, so that no kernel meets itself.
bool grows(const LatticeMethod& method, double acoustic, double viscous) {
  RestingLattice few = lattice_at(method, acoustic, viscous);
  few.cells = method.family == Family::sph ? 10 : 8;
  return spectrum(method.for_theory(), few, acoustic, method.every).radius > growing;
}

/// Where, between two numbers, something becomes true, to a fiftieth; nothing if it is at the lower or is not at the
/// upper.
template <class Predicate>
std::optional<double> boundary(double low, double high, Predicate is_beyond) {
  if (is_beyond(low) || !is_beyond(high)) return std::nullopt;
  while (high > 1.02 * low) (is_beyond(std::sqrt(low * high)) ? high : low) = std::sqrt(low * high);
  return std::sqrt(low * high);
}

Run map_of_courant_numbers(const LatticeMethod& method) {
  const CostMeter meter;
  const std::string figure = figure_of(over_courant_numbers, method);
  Map map(figure);
  Curve theory{figure, "limit by linear theory", Role::exact, {}, {}, false};
  const std::vector<double> acoustic = rising(0.1, 6, 14), viscous = rising(0.003, 3, 11);
  double agree = 0;
  for (const double v : viscous) {
    const std::optional<double> limit =
        boundary(acoustic.front(), acoustic.back(), [&](double a) { return grows(method, a, v); });
    if (limit) {
      theory.x.push_back(*limit);
      theory.y.push_back(v);
    }
    const double stable_to = limit.value_or(grows(method, acoustic.front(), v) ? 0 : INFINITY);
    for (const double a : acoustic) {
      const RestingLattice lattice = lattice_at(method, a, v);
      const double nu = c * RestingLattice::spacing / lattice.reynolds;
      const Ending ending = tried(simulate(method.on, lattice, wave_on(lattice), a), lattice.side(), nu);
      map.add(a, v, ending);
      agree += (ending == Ending::unstable) == (a > stable_to);
    }
  }
  // The other side of the boundary, where it is viscosity that ends it.
  for (auto a = acoustic.rbegin(); a != acoustic.rend() && !theory.y.empty(); ++a)
    if (*a < theory.x.back())
      if (const auto limit =
              boundary(theory.y.back(), viscous.back(), [&](double v) { return grows(method, *a, v); })) {
        theory.x.push_back(*a);
        theory.y.push_back(*limit);
      }
  Run run = finished(meter);
  map.give_to(run);
  run.curves.push_back(theory);
  const double all = static_cast<double>(acoustic.size() * viscous.size());
  run.found = {{"", 0, not_a_number, share_stable, 100 - map.share(Ending::unstable)},
               {"", 0, not_a_number, stable_as_theory, 100 * agree / all}};
  return run;
}

/// Reynolds number of the wave, by its amplitude and length, and bulk modulus over that of a Mach number of 0.1; the
/// step is the method's own choice.
Run map_of_fluids(const LatticeMethod& method) {
  const CostMeter meter;
  Map map(figure_of(over_fluids, method));
  int made_for = 0, stable_there = 0;
  for (const double stiffness : rising(1e-2, 1e6, 9))
    for (const double reynolds : rising(1e-3, 1e5, 9)) {
      // The lattice has a speed of sound of its own: it is the wave that is slower in a stiffer fluid.
      const double speed = 0.1 * c / std::sqrt(stiffness);
      RestingLattice lattice = lattice_for(method, 1);
      lattice.reynolds = reynolds * (c / speed) * (RestingLattice::spacing / lattice.side());
      Start start = noisy(lattice, 1e-6 * speed / c);
      start.velocity = [=, side = lattice.side(), stir = start.velocity](const Vec2& x) -> Vec2 {
        return stir(x) + Vec2(speed * std::sin(2 * std::numbers::pi * x.y() / side), 0);
      };
      const Method here = method.on(lattice, start);
      const double nu = c * RestingLattice::spacing / lattice.reynolds;
      const Ending ending =
          tried(here.solver(lattice.rung(), here.time_step(lattice.rung())), lattice.side(), nu, speed);
      map.add(reynolds, stiffness, ending);
      if (stiffness < 0.099 || reynolds > 101) continue;
      ++made_for;
      stable_there += ending != Ending::unstable;
    }
  Run run = finished(meter);
  map.give_to(run);
  run.found = {{"", 0, not_a_number, share_stable, 100 - map.share(Ending::unstable)},
               {"", 0, not_a_number, stable_where_made_for, 100.0 * stable_there / made_for},
               {"", 0, not_a_number, share_right, map.share(Ending::right)}};
  return run;
}

Method maps_of(const LatticeMethod& on_lattice) {
  Method method = on_lattice.on({}, {});
  Rung rung = lattice_for(on_lattice, 1).rung();
  rung.nightly = 1;
  for (const std::string& name : {over_courant_numbers, over_fluids}) {
    rung.name = name;
    method.rungs.push_back(rung);
  }
  method.run = [on_lattice](const Rung& which, const Schedule&) {
    return which.name == over_fluids ? map_of_fluids(on_lattice) : map_of_courant_numbers(on_lattice);
  };
  method.claims = {
      at_least(stable_as_theory, 95, theory("but for points on the boundary trial and linear theory agree")),
      at_least(stable_where_made_for, 100, theory("the step that a method chooses is a stable one")).on(over_fluids)};
  return method;
}

std::vector<Method> all_methods() {
  std::vector<Method> methods;
  for (const LatticeMethod& method : methods_on_lattice()) methods.push_back(maps_of(method));
  return methods;
}

void declare_figures(const Results& results, Record& record) {
  const LatticeMethod method = method_on_lattice(results.method.name);
  const std::string length = method.family == Family::mpm ? "cell" : "spacing";
  record.figures.push_back(
      {figure_of(over_courant_numbers, method),
       method.name() + ": stable steps",
       "A wave of velocity of a hundredth of the speed of sound decays on a lattice without walls. Each point is a trial of "
       "400 to 1500 steps, until half of the wave is left.",
       {.label = "c dt / " + length, .logarithmic = true},
       {.label = "nu dt / " + length + "^2", .logarithmic = true}});
  record.figures.push_back(
      {figure_of(over_fluids, method),
       method.name() + ": stiff and viscous fluids",
       "The same with the step that the method chooses, over the wave's Reynolds number and the bulk "
       "modulus over that at which its Mach number is 0.1.",
       {.label = "Reynolds number", .logarithmic = true},
       {.label = "K / K at Mach 0.1", .logarithmic = true}});
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Maps of stability",
      .description =
          "A wave of shear on a lattice that repeats along both axes, 16 particles across. Over the distance that sound "
          "travels in a step and that over which momentum diffuses, the boundary of linear theory is drawn: the largest "
          "eigenvalue of the method's own linearised step. Over stiffness and Reynolds number, eight decades of each, the "
          "method chooses its step itself.",
      .times = {1},
      .measurements = {},
      .methods = all_methods(),
      .plots = {declare_figures},
      .label = "stability",
  };
}
