/// A standing gravity wave of small amplitude: its period and how viscosity makes it die.

#include "reference/standing_wave.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/free_surface_methods.hpp"
#include "vnv/measures/swing.hpp"
#include "vnv/plots/along_ladders.hpp"
#include "vnv/plots/over_time.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double L = 1, depth = 0.5, a = 0.02, g = 9.81, rho = 1000;  // m, m, m, m/s², kg/m³
constexpr double nu = 2e-3;                                           // m²/s  a third is lost in a period
constexpr double c = 40;                                              // m/s
constexpr double end = 4, whole = 0.1;                                // s
const reference::StandingWave exact{.L = L, .a = a, .h = depth, .g = g, .nu = nu};
constexpr Newtonian water{{.density = rho, .bulk_modulus = rho * c * c / 7}, rho* nu};

/// From rest, with particles moved as the wave moves them: up and down by the surface's height, less with the depth.
Vectors heaped(const Vectors& lattice) {
  constexpr double k = 2 * std::numbers::pi / L;
  Vectors places = lattice;
  for (Eigen::Index p = 0; p < lattice.cols(); ++p) {
    const double x = lattice(0, p), y = lattice(1, p), reach = a / std::sinh(k * depth);
    places(0, p) = x - reach * std::cosh(k * y) * std::sin(k * x);
    places(1, p) = y + reach * std::sinh(k * y) * std::cos(k * x);
  }
  return places;
}

double pressure(const Vec2& x) {
  constexpr double k = 2 * std::numbers::pi / L;
  const double wave = a * std::cosh(k * x.y()) / std::cosh(k * depth) * std::cos(k * x.x());
  return std::max(0.0, rho * g * (depth - x.y() + wave));
}

const Scene<Newtonian, Uniform> scene{
    .domain = {.box = {.high = {L, 1.2 * depth}}, .periodic_x = true},
    .fluid = water,
    .filled = {.high = {L, depth}},
    .walls = {floor_at(0, free_slip())},
    .body_force = {{0, -g}},
    .start = {.pressure = pressure, .places = heaped},
};

/// How high the wave stands: the first moment of the particles' heights along it, over that of the exact wave at the
/// start.
std::vector<double> look(const Samples& s) {
  const Scalars heights = s.x.row(1).transpose(),
                wave = (2 * std::numbers::pi / L * s.x.row(0).transpose().array()).cos();
  return {(s.mass * heights * wave).sum()};
}

const std::string period_error = "period, less the exact [%]", decay_error = "rate of decay, less the exact [%]";

std::vector<Error> errors_of_swing(const Rung& rung, const Run& run) {
  if (!run.summary.finished) return {};
  std::vector<double> heights;
  for (const std::vector<double>& seen : run.history.seen) heights.push_back(seen[0]);
  const Swing swing = fit_swing(run.history.time, heights, exact.omega());
  return {{rung.name, rung.spacing, end, period_error, 100 * (exact.omega() / swing.omega - 1)},
          {rung.name, rung.spacing, end, decay_error, 100 * (swing.decay / exact.decay_rate() - 1)}};
}

const std::vector<Rung> levels = rungs_across(L, {{50, end, 0, end}, {100, 0, 0, end}, {150, 0, 0, end}});

/// From so many particles to a wave on.
std::vector<Claim> claims(const std::vector<std::string>& rungs) {
  std::vector<Claim> all;
  for (const std::string& rung : rungs) {
    all.push_back(between(period_error, -1, 1, theory("the wave is linear to k² a² / 8 = 0.2 %")).on(rung));
    all.push_back(
        between(decay_error, -10, 10, theory("decay of a potential flow, to first order in nu k² / omega")).on(rung));
  }
  return all;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Standing gravity wave",
      .description =
          "Water 0.5 m deep, 1 m from crest to crest, starts at rest with its surface heaped up by 2 cm, and swings for five "
          "periods; a tenth of its height is lost in each by a viscosity of 2e-3 m²/s. The oracle is the linear wave (Lamb 1932): "
          "its period by gravity and depth, its decay 2 nu k² by the potential flow. Period and decay are those of the "
          "swing that lies closest to the first moment of the particles' heights.",
      .times = {end},
      .watch = {.every = 0.02, .see = look},
      .measurements = {errors_of_swing},
      .methods = {up(levels, mpm_as_printed(scene, whole, 0.4)),
                  up(levels, mpm_affine(scene, whole), claims({"100 across", "150 across"})),
                  up(levels, mpm_apic(scene, whole)), up(levels, mpm_xpic(scene, whole)),
                  up(levels, sph_as_printed(scene, whole, 0.2)),
                  up(levels, sph_delta(scene, whole), claims({"50 across"}))},
      .plots = {over_time({"swing",
                           "First moment of the heights over time",
                           "Mass times height times the cosine of the wave, summed over all particles.",
                           {"t [s]"},
                           {"moment [kg m / m]"}},
                          0, {"100 across"})}};
}
