/// Stability of a particle lattice under uniform pressure: tensile and pairing instability, and their growth rates.

#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/record/record.hpp"
#include "vnv/stability/critical_step.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/methods_on_lattice.hpp"
#include "vnv/stability/spectrum.hpp"

#include <fmt/format.h>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

const Quantity rate_by_theory{"growth rate over c / spacing, linear theory", "", Kind::value, Better::smaller},
    rate_seen{"growth rate over c / spacing, measured", "", Kind::value, Better::smaller},
    theory_holds{"linear theory and simulation agree on stability", "", Kind::value, Better::larger};

constexpr std::array pressures = {-0.05, -0.02, -0.005, 0.005, 0.02, 0.05, 0.2};  // of rho0 c²
constexpr std::array in_acceptance = {-0.02, 0.05};

std::string name_of_pressure(double p) { return fmt::format("p = {:g} rho c²", p); }

RestingLattice lattice_for(const LatticeMethod& method, double pressure) {
  RestingLattice lattice = method.usual_lattice(12);
  lattice.pressure = pressure;
  return lattice;
}

constexpr long steps = 4000;

/// With half of the step that the method chooses, so that it is the pressure that makes noise grow.
Run under(const LatticeMethod& method, double pressure) {
  const CostMeter meter;
  const RestingLattice lattice = lattice_for(method, pressure);
  const double c = RestingLattice::sound_speed,
               courant = method.on(lattice, {}).time_step(lattice.level()) / 2 * c / lattice.unit(),
               lengths = courant * lattice.points;  // spacings that sound travels in a step
  const double radius = spectrum(method.for_theory(), lattice, courant, method.every).radius;
  const double growth = growth_per_step(simulate(method.on, lattice, noisy(lattice, 1e-8), courant),
                                        {.low = 0, .high = 0, .steps = steps, .speed_limit = 1e-4 * c});
  const double by_theory = std::abs(radius - 1) < 1e-6 ? 0 : std::log(radius) / lengths;  // less is rounding
  const double seen = std::isnan(growth) ? 0 : std::log(growth) / lengths;
  Run run = run_of_trials(meter, lattice.particles(), 0, steps);
  run.add(rate_by_theory, by_theory);
  run.add(rate_seen, seen);
  run.add(theory_holds, (radius > growing) == !std::isnan(growth) ? 1 : 0);
  return run;
}

Method under_pressures(const LatticeMethod& on_lattice) {
  Method method = on_lattice.on({}, {});
  method.tolerance = {0.1, "the growth rate is fitted to noise"};
  method.claims = {at_least(theory_holds, 1, theory("the spectral radius of its own linearised step"))};
  std::vector<NamedRun> runs;
  for (const double p : pressures)
    runs.push_back({lattice_for(on_lattice, p)
                        .level(name_of_pressure(p), std::ranges::find(in_acceptance, p) != in_acceptance.end()),
                    [=](const Level&, const Schedule&) { return under(on_lattice, p); }});
  return with_runs(std::move(method), std::move(runs));
}

std::vector<LatticeMethod> methods_that_feel_it() {
  std::vector<LatticeMethod> methods = methods_on_lattice();
  std::erase_if(methods, &LatticeMethod::keeps_volume);
  return methods;
}

void draw_growth(const Results& results, Record& record) {
  record.figures.push_back(
      {"growth",
       "Growth rate of noise against background pressure",
       "Lines: linear theory; points: simulations of 4000 steps, with half of the time step that a method "
       "chooses. Negative pressures are tension.",
       {"pressure / (rho c^2)"},
       {"growth rate, spacing / c"}});
  Curve theory{"growth", results.method.name, Role::ours, {}, {}, false},
      seen{"growth", results.method.name + ", measured", Role::ours, {}, {}, true};
  for (const double p : pressures)
    if (const Run* run = results.run(name_of_pressure(p))) {
      theory.x.push_back(p);
      theory.y.push_back(run->value_of(rate_by_theory));
      seen.x.push_back(p);
      seen.y.push_back(run->value_of(rate_seen));
    }
  record.curves = {theory, seen};
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Particle lattice under pressure and tension",
      .description =
          "Fluid at rest on a doubly periodic lattice, under a uniform pressure: from a tension of a twentieth of "
          "rho c² to a pressure of a fifth. A continuum does not feel it. A lattice of particles does: kernels whose slope decreases "
          "between neighbours pull pairs together under tension (tensile instability, Swegle, Hicks & Attaway 1995), or "
          "under pressure (pairing). Whether noise of 1e-8 times the speed of sound grows is compared with "
          "the largest eigenvalue of the method's own linearised step. Methods that constrain the particle volumes to that of "
          "the domain remove any uniform pressure and are left out.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_that_feel_it(), under_pressures),
      .plots = {draw_growth},
      .label = "stability",
  };
}
