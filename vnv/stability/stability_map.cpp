#include "vnv/stability/stability_map.hpp"

#include "solvers/stepping/diverged.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/spectrum.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace touchstone::vnv {
namespace {

constexpr double c = RestingLattice::sound_speed;
constexpr double inaccurate_from = 5;  // %  of the velocity at the end of a trial

/// A wave of velocity along x, one up the lattice, with noise in it.
struct Wave {
  double speed = 0.01 * c;  // m/s
  double noise = 1e-6;      // of the speed
  long least = 400;         // steps of a trial

  Start on(const RestingLattice& lattice) const {
    return noisy(lattice, noise * speed / c,
                 [v = speed, side = lattice.side()](const Vec2& x) { return Vec2(v * wave_at(x.y(), side), 0); });
  }
};

enum class Decay { right, unstable, inaccurate };
constexpr std::array names_of_decays{"stable", "unstable", "stable, but off by more than 5 %"};

/// The wave decays as the steps go, until it has lost half of its height, but no longer than `most` steps: stable if
/// nothing moves as it never does, right if its height is as it should be at the end. Counts its steps.
Decay decay_of(Simulation simulation, const RestingLattice& lattice, const Wave& wave, long& steps) {
  constexpr long most = 1500;
  const double side = lattice.side(), decay = decay_of_wave(lattice.kinematic_viscosity(), side),
               dt = simulation.time_step();  // m, 1/s, s
  const long judged_at = std::clamp(std::lround(std::numbers::ln2 / (decay * dt)), 1l, most);
  double error = 0;
  try {
    for (long k = 1; k <= std::max(judged_at, wave.least); ++k) {
      simulation.step();
      ++steps;
      if (k % 25 != 0 && k != judged_at) continue;
      const Samples s = simulation.samples();
      if (!(s.v.allFinite() && s.v.colwise().norm().maxCoeff() < 3 * wave.speed)) return Decay::unstable;
      if (k == judged_at) error = 100 * std::abs(amplitude_of_wave(s, side) / wave.speed - std::exp(-decay * s.time));
    }
  } catch (const Diverged&) {
    return Decay::unstable;
  }
  return error > inaccurate_from ? Decay::inaccurate : Decay::right;
}

void add_point(Curve& curve, double x, double y) {
  curve.x.push_back(x);
  curve.y.push_back(y);
}

/// Points of a map, by how the wave decays there. Ways that no point has are drawn, too: each has the same mark in all
/// maps.
class Map {
 public:
  Map(const LatticeMethod& method, const std::string& figure) : particles_(method.usual_lattice().particles()) {
    for (const char* name : names_of_decays) curves_.push_back({figure, name, Role::ours, {}, {}, true});
  }
  Decay add(double x, double y, Simulation simulation, const RestingLattice& lattice, const Wave& wave) {
    const Decay decay = decay_of(std::move(simulation), lattice, wave, steps_);
    add_point(curves_[static_cast<std::size_t>(decay)], x, y);
    ++points_;
    return decay;
  }
  double percent(long points) const { return 100.0 * static_cast<double>(points) / static_cast<double>(points_); }
  double fraction(Decay decay) const { return percent(std::ssize(curves_[static_cast<std::size_t>(decay)].x)); }  // %
  Run run() const {
    Run run = run_of_trials(meter_, particles_, 0, steps_);
    run.curves = curves_;
    run.add(fraction_stable, 100 - fraction(Decay::unstable));
    return run;
  }

 private:
  CostMeter meter_;
  long particles_, steps_ = 0, points_ = 0;
  std::vector<Curve> curves_;
};

std::vector<double> rising(double from, double to, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(from * std::pow(to / from, k / (count - 1.0)));
  return all;
}

/// The lattice on which sound travels `acoustic` unit cells in a step while momentum diffuses over sqrt(`viscous`) of
/// them.
RestingLattice with_viscosity(RestingLattice lattice, double acoustic, double viscous) {
  lattice.reynolds = acoustic / viscous / lattice.points;
  return lattice;
}

/// Where, between two numbers, something becomes true, to a fiftieth; nothing if it is at the lower or is not at the
/// upper.
template <class Predicate>
std::optional<double> boundary(double low, double high, Predicate is_beyond) {
  if (is_beyond(low) || !is_beyond(high)) return std::nullopt;
  while (high > 1.02 * low) (is_beyond(std::sqrt(low * high)) ? high : low) = std::sqrt(low * high);
  return std::sqrt(low * high);
}

/// A map over the acoustic Courant number and something else, with the boundary of linear theory.
struct CourantMap {
  LatticeMethod method;
  std::string figure;
  std::vector<double> acoustic;
  Wave wave{};
  Map map{method, figure};
  Curve theory{figure, "linear stability limit", Role::exact, {}, {}, false};
  long agree = 0;  // points

  /// Whether linear theory says that noise grows; on so many unit cells that no kernel meets itself.
  bool grows(RestingLattice lattice, double a, double viscous) const {
    if (!method.has_grid()) lattice.cells = lattice.smoothing > 0 ? 14 : 10;
    return spectrum(method.for_theory(), with_viscosity(lattice, a, viscous), a, method.every).radius > growing;
  }
  /// Tries all Courant numbers on a lattice, and asks theory for the limit.
  void add_row(double at, const RestingLattice& lattice, double viscous) {
    const auto grows_at = [&](double a) { return grows(lattice, a, viscous); };
    const std::optional<double> limit = boundary(acoustic.front(), acoustic.back(), grows_at);
    if (limit) add_point(theory, *limit, at);
    const double stable_to = limit.value_or(grows_at(acoustic.front()) ? 0 : INFINITY);
    for (const double a : acoustic) {
      const RestingLattice here = with_viscosity(lattice, a, viscous);
      const Decay decay = map.add(a, at, simulate(method.on, here, wave.on(here), a), here, wave);
      agree += (decay == Decay::unstable) == (a > stable_to);
    }
  }
  Run run() const {
    Run run = map.run();
    run.curves.push_back(theory);
    run.add(stable_as_theory, map.percent(agree));
    return run;
  }
};

}  // namespace

Run map_of_courant_numbers(const LatticeMethod& method, const std::string& figure) {
  const std::vector<double> viscous = rising(0.003, 3, 11);
  const RestingLattice lattice = method.usual_lattice();
  CourantMap map{method, figure, rising(0.1, 6, 14)};
  for (const double v : viscous) map.add_row(v, lattice, v);
  // The other side of the boundary, where it is viscosity that ends it.
  const Curve rising_side = map.theory;
  for (auto a = map.acoustic.rbegin(); a != map.acoustic.rend() && !rising_side.y.empty(); ++a)
    if (*a < rising_side.x.back())
      if (const auto limit =
              boundary(rising_side.y.back(), viscous.back(), [&](double v) { return map.grows(lattice, *a, v); }))
        add_point(map.theory, *a, *limit);
  return map.run();
}

Run map_of_arrangements(const LatticeMethod& method, const std::string& figure) {
  CourantMap map{method, figure, rising(0.3, 5, 9), {.speed = 1e-4 * c, .noise = 0.03, .least = 1000}};
  if (method.has_grid())
    for (const int points : {1, 2, 3})
      map.add_row(points * points, {.cells = points < 3 ? 8 : 6, .points = points}, 0.01);
  else
    for (const double h : {1.2, 1.3, 1.45, 1.6, 1.8, 2.0}) map.add_row(h, {.cells = 16, .smoothing = h}, 0.01);
  return map.run();
}

Run map_of_fluids(const LatticeMethod& method, const std::string& figure) {
  Map map(method, figure);
  int made_for = 0, stable_there = 0;
  for (const double stiffness : rising(1e-2, 1e6, 9))
    for (const double reynolds : rising(1e-3, 1e5, 9)) {
      // The lattice has a speed of sound of its own: it is the wave that is slower in a stiffer fluid.
      const Wave wave{.speed = 0.1 * c / std::sqrt(stiffness)};
      RestingLattice lattice = method.usual_lattice();
      lattice.reynolds = reynolds * (c / wave.speed) * (RestingLattice::spacing / lattice.side());
      const Method here = method.on(lattice, wave.on(lattice));
      const Decay decay =
          map.add(reynolds, stiffness, here.solver(lattice.level(), here.time_step(lattice.level())), lattice, wave);
      if (stiffness < 0.099 || reynolds > 101) continue;
      ++made_for;
      stable_there += decay != Decay::unstable;
    }
  Run run = map.run();
  run.add(stable_where_made_for, 100.0 * stable_there / made_for);
  run.add(fraction_right, map.fraction(Decay::right));
  return run;
}

}  // namespace touchstone::vnv
