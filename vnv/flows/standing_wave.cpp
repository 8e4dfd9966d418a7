/// A standing gravity wave of small amplitude [Lamb 1932].

#include "vnv/flows/flow.hpp"
#include "vnv/flows/gravity_wave.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/motion.hpp"

namespace touchstone::vnv::flows {
namespace {

const Quantity amplitude{"amplitude over that of the wave at the start, by its oscillation"},
    liveliest{"largest kinetic energy over that of the linear wave"};

}  // namespace

Flow standing_wave(Settings& set) {
  using namespace gravity_wave;
  Wave wave;
  wave.L = set.positive("L", wave.L, "m", "length of the wave and of the periodic box");
  wave.depth = set.positive("h", wave.depth, "m", "depth at rest");
  wave.a = set.positive("a", wave.a, "m", "amplitude at the start");
  wave.g = set.positive("g", wave.g, "m/s²", "gravity, down");
  wave.rho = set.positive("rho", wave.rho, "kg/m³", "density at zero pressure");
  wave.nu = set.positive("nu", wave.nu, "m²/s", "kinematic viscosity");
  wave.c = set.positive("c", wave.c, "m/s", "speed of sound at zero pressure");
  const double scale = exact.omega() / wave.exact().omega();  // of times
  Flow flow;
  set_scene(flow, scene_with(wave));
  flow.shape = "a lattice with a wave on it,";
  flow.region = [domain = flow.domain, wave](double t) {
    const double lowest = wave.depth - wave.a * std::exp(-wave.exact().decay_rate() * t);  // of all phases
    return Region{.domain = domain, .depth = [lowest](const Vec2& x) { return lowest - x.y(); }};
  };
  flow.across = wave.L;
  flow.judged.title = "Standing gravity wave";
  flow.judged.description =
      "Water starts at rest with a cosine-shaped surface and oscillates. The oracle is the linear wave (Lamb 1932): "
      "period from the dispersion relation, decay rate 2 nu k² from the potential flow over a free-slip floor. Both "
      "are compared with those of the damped oscillation fitted to the first moment of the particle heights over time.";
  flow.judged.monitor = monitored(wave.L);
  flow.judged.monitor.interval *= scale;
  flow.judged.times = {4 * scale};  // five periods
  flow.of_resolved = {period_agrees, decay_agrees};
  flow.resolved = 100;
  flow.of_coarse = [](double across) -> std::vector<Claim> {
    return {between(period_error, -500 / across, 500 / across,
                    theory("first order with five times the error that is claimed at 100 across"))};
  };
  flow.aside = {between(part_of_pressure, 0.8, 1.2, theory("the pressure carries the weight of the water")),
                moves_by_its_velocity(),
                between(amplitude, 0.7, 1.3,
                        theory("it starts as this wave; of our own methods whose period is that of the wave it is 0.77 "
                               "to 1.03 at 50 across")),
                between(liveliest, 0.2, 2, theory("potential energy becomes kinetic and none is added; less where it "
                                                  "decays, or between the times of files"))};
  const Moment standing{
      .of = [k = wave.k()](const Vec2& x) { return x.y() * std::cos(k * x.x()); },
      .slope = [k = wave.k()](const Vec2& x) { return Vec2(-k * x.y() * std::sin(k * x.x()), std::cos(k * x.x())); }};
  flow.measured = {{{}, errors_of_oscillation(wave.exact()), Span{0, 1.6 * scale, 30}, "the oscillation"},
                   {{"velocity"}, part_of_motion(standing), Span{0, 1.6 * scale, 30}, "the motion of the water"},
                   {{},
                    [=](const Level& level, const Run& run) -> std::vector<Value> {
                      std::vector<double> heights;  // first moments
                      for (const std::vector<double>& row : run.history.values) heights.push_back(row[0]);
                      const double found =
                          fit_damped_oscillation(run.history.time, heights, wave.exact().omega()).at_start;
                      const double of_wave = run.samples.front().mass.sum() * wave.a / 2;
                      return {{level.name, level.spacing, run.summary.end_time, amplitude, found / of_wave}};
                    },
                    Span{0, 1.6 * scale, 30},
                    "the amplitude"},
                   {{"velocity"},
                    [=](const Level& level, const Run& run) -> std::vector<Value> {
                      double largest = 0;
                      for (const Samples& s : run.samples)
                        largest = norms::larger_magnitude(largest, kinetic_energy(s) / s.mass.sum());
                      const double linear = wave.g * wave.a * wave.a / (4 * wave.depth);  // Lamb 1932, of a unit of mass
                      return {{level.name, level.spacing, run.summary.end_time, liveliest, largest / linear}};
                    },
                    Span{0, 1.6 * scale, 30},
                    "the kinetic energy"},
                   {{"pressure"},
                    part_of_exact_pressure([unit = wave.rho * wave.g, h = wave.depth](
                                               const Vec2& x, double) { return unit * std::max(0.0, h - x.y()); },
                                           false)}};
  return flow;
}

}  // namespace touchstone::vnv::flows
