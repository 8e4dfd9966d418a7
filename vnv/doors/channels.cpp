/// Flows between plates.

#include "reference/couette.hpp"
#include "reference/oscillating_poiseuille.hpp"
#include "reference/poiseuille.hpp"
#include "reference/stokes.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"
#include "solvers/walls/oscillating.hpp"
#include "vnv/doors/flows.hpp"
#include "vnv/flows/driven_channel.hpp"
#include "vnv/judge/norms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::vnv::doors {
namespace {

/// The velocity along the plates with the lower one at y = 0, of a channel in which something is wrong.
using Altered = std::function<Truth(const Changes&)>;

/// How far out a plate stands, or seems to: a short slip length is that (Navier 1823).
double out(const Changes& by, Cause plate) { return by(plate) + by(Cause::walls) + by(Cause::slip); }

/// The velocity at places [m] from the lower plate, continued oddly behind the plates at 0 and at the height [m],
/// however far: what is odd about both repeats itself after twice the height, but for what it gains on the way.
double continued(const Truth& truth, double height, double y, double t) {
  if (const double turns = std::floor((y + height) / (3 * height)); turns != 0) {
    const double twice = std::floor(y / (2 * height));
    return 2 * twice * (truth(height, t) - truth(0, t)) + continued(truth, height, y - 2 * height * twice, t);
  }
  if (y < 0) return 2 * truth(0, t) - truth(-y, t);
  if (y > height) return 2 * truth(height, t) - truth(2 * height - y, t);
  return truth(y, t);
}

const Quantity across_plates{"L2 v_y over that of v_x, per particle", "%", Kind::error},
    fastest_across_plates{"Linf v_y over that of v_x, per particle", "%", Kind::error};

/// The component of the velocity that there is none of.
Measurement component_across(const Truth& exact) {
  return [exact](const Level& level, const Run& run) {
    std::vector<Value> found;
    for (const Samples& s : run.samples) {
      const Scalars volumes = s.volumes();
      double along = 0, across = 0, largest_along = 0, largest_across = 0;
      for (Eigen::Index p = 0; p < s.size(); ++p) {
        const double right = exact(s.x(1, p), s.time);
        along += volumes[p] * right * right;
        across += volumes[p] * s.v(1, p) * s.v(1, p);
        largest_along = norms::larger_magnitude(largest_along, right);
        largest_across = norms::larger_magnitude(largest_across, s.v(1, p));
      }
      norms::require_scale("component across the plates", along);
      found.push_back({level.name, level.spacing, s.time, across_plates, 100 * std::sqrt(across / along)});
      found.push_back({level.name, level.spacing, s.time, fastest_across_plates, 100 * largest_across / largest_along});
    }
    return found;
  };
}

/// What all of them ask for: the gap and the fluid in it, those of Sun et al. (table 1) where nothing is set.
struct Channel {
  Box gap;
  Newtonian fluid;

  explicit Channel(Settings& set) {
    gap.high.y() = set.positive("H", channel::H, "m", "distance between the plates");
    gap.high.x() = set.positive("L", H() * (channel::L / channel::H), "m", "length of the periodic box");
    const double rho = set.positive("rho", channel::water.density, "kg/m³", "density at rest");
    const double nu = set.positive("nu", channel::water.kinematic_viscosity(), "m²/s", "kinematic viscosity");
    const double c = set.positive("c", channel::water.sound_speed(), "m/s", "speed of sound at rest");
    fluid = {{.density = rho, .bulk_modulus = rho * c * c / Tait::gamma}, rho * nu};
  }
  double H() const { return gap.high.y(); }
  double nu() const { return fluid.kinematic_viscosity(); }
  /// Plates do not meet, whatever a fit tries.
  double H(const Changes& by) const {
    return std::max(0.1 * H(), H() + out(by, Cause::floor) + out(by, Cause::ceiling));
  }
  double nu(const Changes& by) const { return nu() * by.factor(Cause::viscosity); }

  /// The flow between two plates whose velocity along them is `exact`, from its state at t = 0 on.
  Flow flow(std::string title, std::string description, std::vector<double> times, WallVelocity floor,
            WallVelocity ceiling, const Altered& altered, std::vector<Cause> causes) const {
    const Truth exact = altered({});
    Flow made;
    set_scene(made, channel::between_plates(gap, fluid, std::move(floor), std::move(ceiling), NoForce{},
                                            {.velocity = [exact](const Vec2& x) -> Vec2 {
                                              return {exact(x.y(), 0), 0};
                                            }}));
    made.across = H();
    made.is_uniform_along_x = true;
    made.judged.title = std::move(title);
    made.judged.description = std::move(description);
    made.judged.times = std::move(times);
    made.judged.claims = {is_consistent(channel::l2)};
    made.aside = {at_most(across_plates, 20, theory("nothing drives a flow across the plates"))};
    made.measured = {{{velocity_along_x}, norms_of("v_x, per particle", channel::by_particles, exact)},
                     {{"velocity"}, component_across(exact)}};
    made.exact = {{.field = "velocity",
                   .norms = {channel::l2.name, channel::linf.name, channel::l2_rows.name, channel::linf_rows.name},
                   .causes = std::move(causes),
                   .with = [=, *this](const Changes& by) -> FieldTruth {
                     return [=, truth = altered(by), H = H(by), floor = out(by, Cause::floor)](
                                const Vec2& x, double t) { return Vec2(continued(truth, H, x.y() + floor, t), 0); };
                   }}};
    made.judged.plots = errors_of_velocity("convergence", "L2 v_x [%]", channel::l2, made.judged.times.back());
    return made;
  }
};

const std::vector<Cause> between_two_plates{Cause::viscosity, Cause::floor, Cause::ceiling, Cause::walls, Cause::slip};
const std::vector<Cause> above_one_plate{Cause::viscosity, Cause::floor, Cause::slip};

std::vector<Cause> and_force(std::vector<Cause> causes) {
  causes.push_back(Cause::force);
  return causes;
}

/// Flows of the paper are judged by the means of their rows, too.
Flow with_row_means(Flow flow, const Altered& altered) {
  const auto by_lines = [](const Level& level) { return means_of_lines(velocity_x, level.spacing); };
  flow.measured.push_back({{velocity_along_x}, norms_of("v_x, row means", by_lines, altered({}))});
  return flow;
}

/// What oscillates as cos(omega t), by the period that a user sets; sampled a quarter and three quarters through it.
struct Oscillation {
  double period;  // s

  Oscillation(Settings& set, double published, const std::string& words)
      : period(set.positive("period", published, "s", words)) {}
  double omega() const { return 2 * std::numbers::pi / period; }  // 1/s
  std::vector<double> times() const { return {period / 4, 3 * period / 4}; }
};

/// Times at which a flow is sampled: fractions of the time in which viscosity crosses the gap.
std::vector<double> times_of(const Channel& channel, const std::vector<double>& fractions) {
  std::vector<double> times;
  for (const double fraction : fractions) times.push_back(fraction * channel.H() * channel.H() / channel.nu());
  return times;
}

}  // namespace

Flow poiseuille(Settings& set) {
  const Channel channel(set);
  const double F = set("F", channel::drive, "m/s²", "body force along x, per mass, from t = 0 on");
  const Altered exact = [=](const Changes& by) {
    return reference::Poiseuille{.H = channel.H(by), .F = F * (1 + by(Cause::force)), .nu = channel.nu(by)};
  };
  Flow flow = with_row_means(
      channel.flow(
          "Start-up of plane Poiseuille flow",
          "Fluid at rest between two plates at rest is driven along them by a body force from t = 0. The oracle is the "
          "exact series of Morris, Fox & Zhu (1997).",
          times_of(channel, {0.05, 0.1, 0.2, 1}), no_slip(), no_slip(), exact, and_force(between_two_plates)),
      exact);
  flow.drive = {{F, 0}};
  return flow;
}

Flow couette(Settings& set) {
  const Channel channel(set);
  const double V = set("V", 0.1 * mm, "m/s", "velocity of the upper plate from t = 0 on");
  const double V_lower = set("V_lower", 0, "m/s", "velocity of the lower plate from t = 0 on");
  const Altered exact = [=](const Changes& by) -> Truth {
    const auto moved = [&](double plate) {
      return reference::Couette{.H = channel.H(by), .V = plate, .nu = channel.nu(by)};
    };
    if (V_lower == 0) return moved(V);
    return
        [upper = moved(V), lower = moved(V_lower)](double y, double t) { return upper(y, t) + lower(lower.H - y, t); };
  };
  return with_row_means(
      channel.flow(
          "Start-up of plane Couette flow",
          "Fluid at rest between two plates, of which the upper one slides from t = 0, or both do. The oracle is the exact "
          "series of Morris, Fox & Zhu (1997), one for each plate.",
          times_of(channel, {0.05, 0.1, 0.2, 1}), no_slip({V_lower, 0}), no_slip({V, 0}), exact, between_two_plates),
      exact);
}

Flow oscillating_poiseuille(Settings& set) {
  const Channel channel(set);
  const double F = set("F", 40 * mm, "m/s²", "amplitude of the body force along x, per mass");
  const Oscillation force(set, 0.1, "of the body force");
  Flow flow = channel.flow(
      "Oscillating Poiseuille flow",
      "A body force along a channel oscillates as cos(2 pi t / period). The oracle is the plane form of Womersley's "
      "(1955) solution for a force that has always oscillated; its velocity at t = 0 is the initial state.",
      force.times(), no_slip(), no_slip(),
      [=](const Changes& by) {
        return reference::OscillatingPoiseuille{
            .H = channel.H(by), .F = F * (1 + by(Cause::force)), .omega = force.omega(), .nu = channel.nu(by)};
      },
      and_force(between_two_plates));
  flow.drive = {{F, 0}, force.omega()};
  return flow;
}

Flow stokes_first(Settings& set) {
  const Channel channel(set);
  const double V = set("V", 1 * mm, "m/s", "velocity of the plate from t = 0 on");
  return channel.flow(
      "Stokes' first problem",
      "A plate below fluid at rest slides from t = 0. The oracle is Stokes' (1851), for fluid without an upper bound: the "
      "boundary layer has to stay below the free-slip ceiling.",
      times_of(channel, {2.5e-3, 0.01}), no_slip({V, 0}), free_slip(),
      [=](const Changes& by) { return reference::StokesFirst{.V = V, .nu = channel.nu(by)}; }, above_one_plate);
}

Flow stokes_second(Settings& set) {
  const Channel channel(set);
  const double V = set("V", 1 * mm, "m/s", "amplitude of the plate's velocity");
  const Oscillation plate(set, 0.02, "of the plate");
  Flow flow = channel.flow(
      "Stokes' second problem",
      "A plate below fluid oscillates in its own plane as cos(2 pi t / period). The oracle is Stokes' (1851) for a "
      "plate that has always oscillated; its velocity at t = 0 is the initial state. The free-slip ceiling is far "
      "above the layer.",
      plate.times(), oscillating({V, 0}, plate.omega()), free_slip(),
      [=](const Changes& by) { return reference::StokesSecond{.V = V, .omega = plate.omega(), .nu = channel.nu(by)}; },
      above_one_plate);
  flow.wall_frequency = plate.omega();
  return flow;
}

}  // namespace touchstone::vnv::doors
