/// Where each method is stable and where it is accurate: over the acoustic and the viscous Courant number, and over
/// stiffness and Reynolds number with the step that it chooses.

#include "solvers/stepping/diverged.hpp"
#include "vnv/record/record.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/methods_on_lattice.hpp"
#include "vnv/stability/spectrum.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <optional>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

const std::string over_courant_numbers = "Courant numbers", over_arrangements = "arrangements", over_fluids = "fluids";
const Quantity fraction_stable{"stable fraction of the map", "%", Kind::stability_limit},
    stable_as_theory{"fraction of the map where linear theory and simulation agree on stability", "%",
                     Kind::stability_limit},
    fraction_right{"stable and accurate fraction of the map", "%", Kind::stability_limit},
    stable_where_made_for{"stable fraction of the map up to Ma = 0.32 and Re = 100", "%", Kind::stability_limit};

constexpr double c = RestingLattice::sound_speed;
constexpr double U = 0.01 * c;         // m/s  of the wave over Courant numbers
constexpr double inaccurate_from = 5;  // %  of the velocity at the end of a trial

enum class Ending { right, unstable, inaccurate };
constexpr std::array names{"stable", "unstable", "stable, but off by more than 5 %"};

/// A wave of velocity along x, one up the lattice, with noise in it.
struct Wave {
  double speed = U;     // m/s
  double noise = 1e-6;  // of the speed
  long least = 400;     // steps of a trial
};

Start wave_on(const RestingLattice& lattice, const Wave& wave) {
  Start start = noisy(lattice, wave.noise * wave.speed / c);
  start.velocity = [wave, side = lattice.side(), stir = start.velocity](const Vec2& x) -> Vec2 {
    return stir(x) + Vec2(wave.speed * wave_at(x.y(), side), 0);
  };
  return start;
}

/// The wave decays as the steps go, until it has lost half of its height, but no longer than `most` steps: stable if
/// nothing moves as it never does, right if its height is as it should be at the end. Counts its steps.
Ending tried(Simulation simulation, const RestingLattice& lattice, const Wave& wave, long& steps) {
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
      if (!(s.v.allFinite() && s.v.colwise().norm().maxCoeff() < 3 * wave.speed)) return Ending::unstable;
      if (k == judged_at) error = 100 * std::abs(amplitude_of_wave(s, side) / wave.speed - std::exp(-decay * s.time));
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
  double fraction(Ending ending) const {  // %
    std::size_t all = 0;
    for (const Curve& curve : curves_) all += curve.x.size();
    return 100 * static_cast<double>(curves_[static_cast<std::size_t>(ending)].x.size()) / static_cast<double>(all);
  }
  /// Verdicts that no point has, too: a verdict has the same mark in all maps.
  void give_to(Run& run) const { run.curves.insert(run.curves.end(), curves_.begin(), curves_.end()); }

 private:
  std::vector<Curve> curves_;
};

std::string figure_of(const std::string& map, const LatticeMethod& method) {
  return (map == over_fluids ? "fluids_" : map == over_arrangements ? "arrangements_" : "numbers_") + method.name();
}

std::vector<double> rising(double from, double to, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(from * std::pow(to / from, k / (count - 1.0)));
  return all;
}

/// The lattice on which sound travels `acoustic` unit cells in a step while momentum diffuses over sqrt(`viscous`) of
/// them.
RestingLattice lattice_at(const LatticeMethod& method, double acoustic, double viscous) {
  RestingLattice lattice = method.usual_lattice();
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
class CourantMap {
 public:
  using LatticeAt = std::function<RestingLattice(double acoustic)>;

  CourantMap(const LatticeMethod& method, const std::string& figure, std::vector<double> acoustic, const Wave& wave)
      : method_(method), acoustic_(std::move(acoustic)), wave_(wave), map_(figure) {
    theory_.figure = figure;
  }

  /// Whether linear theory says that noise grows; on so many unit cells that no kernel meets itself.
  bool grows(RestingLattice lattice, double acoustic) const {
    if (!method_.has_grid()) lattice.cells = lattice.smoothing > 0 ? 14 : 10;
    return spectrum(method_.for_theory(), lattice, acoustic, method_.every).radius > growing;
  }

  /// Tries all Courant numbers on the lattices of a row, and asks theory for the limit.
  void add_row(double at, const LatticeAt& lattice_at) {
    const std::optional<double> limit =
        boundary(acoustic_.front(), acoustic_.back(), [&](double a) { return grows(lattice_at(a), a); });
    if (limit) add_to_boundary(*limit, at);
    const double stable_to = limit.value_or(grows(lattice_at(acoustic_.front()), acoustic_.front()) ? 0 : INFINITY);
    for (const double a : acoustic_) {
      const RestingLattice lattice = lattice_at(a);
      const Ending ending = tried(simulate(method_.on, lattice, wave_on(lattice, wave_), a), lattice, wave_, steps_);
      map_.add(a, at, ending);
      ++trials_;
      agree_ += (ending == Ending::unstable) == (a > stable_to);
    }
  }
  void add_to_boundary(double acoustic, double at) {
    theory_.x.push_back(acoustic);
    theory_.y.push_back(at);
  }
  const Curve& theory() const { return theory_; }

  Run run(const CostMeter& meter) const {
    Run run = run_of_trials(meter, method_.usual_lattice().particles(), 0, steps_);
    map_.give_to(run);
    run.curves.push_back(theory_);
    run.add(fraction_stable, 100 - map_.fraction(Ending::unstable));
    run.add(stable_as_theory, 100.0 * agree_ / trials_);
    return run;
  }

 private:
  LatticeMethod method_;
  std::vector<double> acoustic_;
  Wave wave_;
  Map map_;
  Curve theory_{"", "linear stability limit", Role::exact, {}, {}, false};
  int trials_ = 0, agree_ = 0;
  long steps_ = 0;
};

Run map_of_courant_numbers(const LatticeMethod& method) {
  const CostMeter meter;
  const std::vector<double> acoustic = rising(0.1, 6, 14), viscous = rising(0.003, 3, 11);
  CourantMap map(method, figure_of(over_courant_numbers, method), acoustic, {});
  for (const double v : viscous) map.add_row(v, [&](double a) { return lattice_at(method, a, v); });
  // The other side of the boundary, where it is viscosity that ends it.
  const Curve rising_side = map.theory();
  for (auto a = acoustic.rbegin(); a != acoustic.rend() && !rising_side.y.empty(); ++a)
    if (*a < rising_side.x.back())
      if (const auto limit = boundary(rising_side.y.back(), viscous.back(),
                                      [&](double v) { return map.grows(lattice_at(method, *a, v), *a); }))
        map.add_to_boundary(*a, *limit);
  return map.run(meter);
}

/// Over the smoothing length in SPH, over the particles in a cell in MPM; momentum diffuses over a tenth of a length in
/// a step. The wave is so slow that particles stay in their places: what crossing cells adds is seen in the other map.
Run map_of_arrangements(const LatticeMethod& method) {
  const CostMeter meter;
  CourantMap map(method, figure_of(over_arrangements, method), rising(0.3, 5, 9),
                 {.speed = 1e-4 * c, .noise = 0.03, .least = 1000});
  if (!method.has_grid())
    for (const double h : {1.2, 1.3, 1.45, 1.6, 1.8, 2.0})
      map.add_row(h, [&](double a) {
        RestingLattice lattice = lattice_at(method, a, 0.01);
        lattice.smoothing = h;
        return lattice;
      });
  else
    for (const int points : {1, 2, 3})
      map.add_row(points * points, [&](double a) {
        return RestingLattice{.cells = points < 3 ? 8 : 6, .points = points, .reynolds = a / 0.01 / points};
      });
  return map.run(meter);
}

/// Reynolds number of the wave, by its amplitude and length, and bulk modulus over that of a Mach number of 0.1; the
/// step is the method's own choice.
Run map_of_fluids(const LatticeMethod& method) {
  const CostMeter meter;
  Map map(figure_of(over_fluids, method));
  int made_for = 0, stable_there = 0;
  long steps = 0;
  for (const double stiffness : rising(1e-2, 1e6, 9))
    for (const double reynolds : rising(1e-3, 1e5, 9)) {
      // The lattice has a speed of sound of its own: it is the wave that is slower in a stiffer fluid.
      const Wave wave{.speed = 0.1 * c / std::sqrt(stiffness)};
      RestingLattice lattice = method.usual_lattice();
      lattice.reynolds = reynolds * (c / wave.speed) * (RestingLattice::spacing / lattice.side());
      const Method here = method.on(lattice, wave_on(lattice, wave));
      const Ending ending = tried(here.solver(lattice.level(), here.time_step(lattice.level())), lattice, wave, steps);
      map.add(reynolds, stiffness, ending);
      if (stiffness < 0.099 || reynolds > 101) continue;
      ++made_for;
      stable_there += ending != Ending::unstable;
    }
  Run run = run_of_trials(meter, method.usual_lattice().particles(), 0, steps);
  map.give_to(run);
  run.add(fraction_stable, 100 - map.fraction(Ending::unstable));
  run.add(stable_where_made_for, 100.0 * stable_there / made_for);
  run.add(fraction_right, map.fraction(Ending::right));
  return run;
}

/// Least squares want four particles in a cell or more, the regularised methods h = 1 spacing.
bool can_be_arranged(const LatticeMethod& method) { return !method.fits && !method.one_kernel; }

Method maps_of(const LatticeMethod& on_lattice) {
  Method method = on_lattice.on({}, {});
  method.claims = {
      at_least(stable_as_theory, 95, theory("except on the boundary, simulation and linear theory agree")),
      at_least(stable_where_made_for, 100, theory("the time step that a method chooses is stable")).on(over_fluids)};
  std::vector<NamedRun> runs;
  const auto add = [&](const std::string& name, Run (*map)(const LatticeMethod&)) {
    runs.push_back(
        {on_lattice.usual_lattice().level(name), [=](const Level&, const Schedule&) { return map(on_lattice); }});
  };
  add(over_courant_numbers, map_of_courant_numbers);
  if (can_be_arranged(on_lattice)) add(over_arrangements, map_of_arrangements);
  add(over_fluids, map_of_fluids);
  return with_runs(std::move(method), std::move(runs));
}

void declare_figures(const Results& results, Record& record) {
  const LatticeMethod method = method_on_lattice(results.method.name);
  const std::string length = method.has_grid() ? "cell" : "spacing";
  record.figures.push_back(
      {figure_of(over_courant_numbers, method),
       method.name() + ": stability over acoustic and viscous Courant number",
       "A shear wave of a hundredth of the speed of sound decays on a periodic lattice. Each point is a simulation of "
       "400 to 1500 steps, until the amplitude has halved.",
       {.label = "c dt / " + length, .logarithmic = true},
       {.label = "nu dt / " + length + "^2", .logarithmic = true}});
  if (can_be_arranged(method))
    record.figures.push_back(
        {figure_of(over_arrangements, method),
         method.name() + ": stability over resolution of the kernel or cell",
         "A shear wave of a ten-thousandth of the speed of sound, over the smoothing length or the number of particles "
         "in a cell, with nu dt = 0.01 " +
             length + "^2.",
         {.label = "c dt / " + length, .logarithmic = true},
         {.label = method.has_grid() ? "particles in a cell" : "h / spacing", .low = 0}});
  record.figures.push_back(
      {figure_of(over_fluids, method),
       method.name() + ": stability over stiffness and Reynolds number",
       "A decaying shear wave with the step that the method chooses, over the wave's Reynolds number and the bulk "
       "modulus, relative to that at which the Mach number is 0.1.",
       {.label = "Reynolds number", .logarithmic = true},
       {.label = "K / K at Mach 0.1", .logarithmic = true}});
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Stability maps",
      .description =
          "A shear wave on a doubly periodic lattice, 16 particles across. Maps over the acoustic and the viscous "
          "Courant number, and over the number of particles in a cell or the smoothing length, also show the stability "
          "boundary of linear theory, from the largest eigenvalue of the method's own linearised step. Over eight "
          "decades each of stiffness and Reynolds number, each method uses the time step that it chooses.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_on_lattice(), maps_of),
      .plots = {declare_figures},
      .label = "stability",
  };
}
