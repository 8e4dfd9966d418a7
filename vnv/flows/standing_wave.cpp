/// A standing gravity wave of small amplitude [Lamb 1932].

#include "solvers/walls/free_slip.hpp"
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
  const double L = set.positive("L", published.L, "m", "length of the wave and of the periodic box");
  const double h = set.positive("h", published.h, "m", "depth at rest");
  const double a = set.positive("a", published.a, "m", "amplitude at the start");
  const double g = set.positive("g", published.g, "m/s²", "gravity, down");
  const double rho = set.positive("rho", 1000, "kg/m³", "density at zero pressure");
  const double nu = set.positive("nu", published.nu, "m²/s", "kinematic viscosity");
  const double c = set.positive("c", 40, "m/s", "speed of sound at zero pressure");
  const reference::StandingWave wave{.L = L, .a = a, .h = h, .g = g, .nu = nu};
  const double scale = published.omega() / wave.omega();  // of times
  Flow flow;
  flow.exact_solution = wave;
  flow.domain = {.box = {.high = {L, 1.2 * h}}, .periodic_x = true};
  flow.fluid = fluid_of(rho, c, nu);
  flow.filled = {.high = {L, h}};
  flow.shape = "a lattice with a wave on it,";
  flow.walls = {floor_at(0, free_slip())};
  flow.drive.amplitude = {0, -g};
  flow.start = {.pressure =
                    [=, k = wave.k()](const Vec2& x) {
                      const double raised = a * std::cosh(k * x.y()) / std::cosh(k * h) * std::cos(k * x.x());
                      return std::max(0.0, rho * g * (h - x.y() + raised));
                    },
                .places = [wave](const Vectors& lattice) { return heaped(wave, lattice); }};
  flow.region = [domain = flow.domain, wave](double t) {
    const double lowest = wave.h - wave.a * std::exp(-wave.decay_rate() * t);  // of all phases
    return Region{.domain = domain, .depth = [lowest](const Vec2& x) { return lowest - x.y(); }};
  };
  flow.across = L;
  flow.judged.title = "Standing gravity wave";
  flow.judged.description =
      "Water starts at rest with a cosine-shaped surface and oscillates. The oracle is the linear wave (Lamb 1932): "
      "period from the dispersion relation, decay rate 2 nu k² from the potential flow over a free-slip floor. Both "
      "are compared with those of the damped oscillation fitted to the first moment of the particle heights over time.";
  flow.judged.monitor = {
      .interval = 0.02 * scale,
      .evaluate = [k = wave.k()](const Samples& s) -> std::vector<double> {
        const Scalars heights = s.x.row(1).transpose(), crests = (k * s.x.row(0).transpose().array()).cos();
        return {(s.mass * heights * crests).sum()};
      },
      .quantities = {{"first moment of the particle heights", "kg"}}};
  flow.judged.times = {4 * scale};  // five periods
  flow.of_resolved = {period_agrees, decay_agrees};
  flow.resolved = 100;
  flow.of_coarse = [](double across) -> std::vector<Claim> {
    return {between(period_error, -500 / across, 500 / across,
                    baseline("first order with five times the error that is claimed at 100 across"))};
  };
  flow.aside = {between(part_of_pressure, 0.8, 1.2, theory("the pressure carries the weight of the water")),
                moves_by_its_velocity(),
                between(amplitude, 0.7, 1.3,
                        baseline("of our own methods whose period is that of the wave it is 0.77 to 1.03 at 50 "
                                 "across")),
                between(liveliest, 0.2, 2,
                        theory("potential energy becomes kinetic and none is added; less where it "
                               "decays, or between the times of files"))};
  const Moment standing{
      .of = [k = wave.k()](const Vec2& x) { return x.y() * std::cos(k * x.x()); },
      .slope = [k = wave.k()](const Vec2& x) { return Vec2(-k * x.y() * std::sin(k * x.x()), std::cos(k * x.x())); }};
  const Span oscillation{0, 1.6 * scale, 30};
  flow.measured = {{{}, errors_of_oscillation(wave), oscillation, "the oscillation"},
                   {{"velocity"}, part_of_motion(standing), oscillation, "the motion of the water"},
                   {{},
                    of_run(amplitude,
                           [=](const Run& run) {
                             const double of_wave = run.samples.front().mass.sum() * a / 2;
                             return oscillation_of(run, wave).at_start / of_wave;
                           }),
                    oscillation,
                    "the amplitude"},
                   {{"velocity"},
                    of_run(liveliest,
                           [=](const Run& run) {
                             double largest = 0;
                             for (const Samples& s : run.samples)
                               largest = norms::larger_magnitude(largest, kinetic_energy(s) / s.mass.sum());
                             return largest / (g * a * a / (4 * h));  // Lamb 1932, of a unit of mass
                           }),
                    oscillation,
                    "the kinetic energy"},
                   {{"pressure"},
                    part_of_exact_pressure(
                        [=](const Vec2& x, double) { return rho * g * std::max(0.0, h - x.y()); }, false)}};
  return flow;
}

}  // namespace touchstone::vnv::flows
