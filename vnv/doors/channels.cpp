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

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::vnv::doors {
namespace {

/// The velocity along the plates with the lower one at y = 0, of a channel in which something is wrong.
using Altered = std::function<Truth(const Changes&)>;

/// How far out a plate stands, or seems to: a short slip length is that (Navier 1823), where its flow is not known.
double out(const Changes& by, Cause plate) { return by(plate) + by(Cause::walls) + by(Cause::slip); }

/// Start-up between two plates, at rest or moved along themselves from t = 0, along which the fluid slips: v = b dv/dn
/// (Navier 1823), by the eigenfunctions sin(k y + atan(b k)) of the lower plate. Analytic in y, behind the plates too.
class Slipping {
 public:
  struct Plate {
    double velocity, b;  // m/s, m
  };
  /// `early`: what it is where the series has too many terms.
  Slipping(double H, double F, double nu, Plate lower, Plate upper, Truth early)
      : H_(H), F_(F), nu_(nu), lower_(lower), early_(std::move(early)) {
    slope_ = (upper.velocity - lower.velocity + F * H / nu * (H / 2 + upper.b)) / (H + lower.b + upper.b);
    for (int n = 1; n <= most; ++n) {
      double low = (n - 1) * std::numbers::pi / H, high = n * std::numbers::pi / H;
      for (int halving = 0; halving < 52; ++halving) {
        const double k = (low + high) / 2;
        (k * H + std::atan(lower.b * k) + std::atan(upper.b * k) < n * std::numbers::pi ? low : high) = k;
      }
      const double k = high, at_lower = std::atan(lower.b * k), at_upper = k * H + at_lower;
      const double steady = (lower.velocity * k * std::cos(at_lower) - upper.velocity * k * std::cos(at_upper) +
                             F / nu * (std::cos(at_lower) - std::cos(at_upper)) / k) /
                            (k * k);
      modes_.push_back(
          {k, at_lower, steady / (H / 2 - (std::sin(2 * at_upper) - std::sin(2 * at_lower)) / (4 * k))});
    }
  }
  double operator()(double y, double t) const {
    constexpr double gone = 30;  // exp(-30) is nothing
    if (std::pow(modes_.back().k, 2) * nu_ * t < gone) return early_(y, t);
    double v = lower_.velocity + slope_ * (lower_.b + y) - F_ / (2 * nu_) * y * y;
    for (const Mode& m : modes_) {
      const double decay = m.k * m.k * nu_ * t;
      if (decay > gone) break;
      v -= m.strength * std::sin(m.k * y + m.phase) * std::exp(-decay);
    }
    return v;
  }

 private:
  struct Mode {
    double k, phase, strength;
  };
  static constexpr int most = 60;
  double H_, F_, nu_, slope_;
  Plate lower_;
  Truth early_;
  std::vector<Mode> modes_{};
};

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

  /// What `walls` says of walls further out, of plates with these velocities; of a fluid that slips the exact flow.
  Altered slipping(const Altered& walls, const std::function<double(const Changes&)>& F, double lower,
                   double upper) const {
    return [=, *this](const Changes& by) -> Truth {
      const double b = by(Cause::slip);
      if (!(b > 0)) return walls(by);
      return Slipping(H(standing(by)), F(by), nu(by), {lower, b}, {upper, b},
                      [truth = walls(by), b](double y, double t) { return truth(y + b, t); });
    };
  }
  /// Where plates stand if the fluid slips along them.
  static Changes standing(Changes by) {
    by(Cause::slip) = std::min(by(Cause::slip), 0.0);
    return by;
  }

  /// The flow between two plates whose velocity along them is `exact`, from its state at t = 0 on.
  Flow flow(std::string title, std::string description, std::vector<double> times, WallVelocity floor,
            WallVelocity ceiling, const Altered& altered, std::vector<Cause> causes, bool slips = false) const {
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
                     const Changes at = slips ? standing(by) : by;
                     return [=, truth = altered(by), H_right = H(), H = H(at), floor = out(at, Cause::floor)](
                                const Vec2& x, double t) {
                       const double y = x.y() + floor;  // behind a plate that stands too far in nothing flows
                       if (x.y() >= 0 && x.y() <= H_right) return Vec2(truth(std::clamp(y, 0.0, H), t), 0);
                       return Vec2(continued(truth, H, y, t), 0);
                     };
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

/// Both of an oracle's, seen from the lower and from the upper plate: both plates move alike.
Truth of_both(const Truth& upper, double H) {
  return [=](double y, double t) { return upper(y, t) + upper(H - y, t); };
}

Instead instead(std::string cause, std::string sentence, const Truth& truth) {
  return {std::move(cause), std::move(sentence), [=](const Vec2& x, double t) { return Vec2(truth(x.y(), t), 0); }};
}
/// A plate along which a fluid slips freely is the middle of a channel twice as high.
Instead slips_along(const std::string& wall, const Truth& truth) {
  return instead("free slip", fmt::format("the fluid slips freely along {}", wall), truth);
}
Instead is_steady(const Truth& truth) {
  return instead("steady", "the velocity is that of the steady flow already, infinitely ahead", truth);
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
  const auto force = [=](const Changes& by) { return F * (1 + by(Cause::force)); };
  const Altered exact = channel.slipping(
      [=](const Changes& by) { return reference::Poiseuille{.H = channel.H(by), .F = force(by), .nu = channel.nu(by)}; },
      force, 0, 0);
  Flow flow = with_row_means(
      channel.flow(
          "Start-up of plane Poiseuille flow",
          "Fluid at rest between two plates at rest is driven along them by a body force from t = 0. The oracle is the "
          "exact series of Morris, Fox & Zhu (1997).",
          times_of(channel, {0.05, 0.1, 0.2, 1}), no_slip(), no_slip(), exact, and_force(between_two_plates), true),
      exact);
  flow.drive = {{F, 0}};
  const double H = channel.H();
  const reference::Poiseuille right{.H = H, .F = F, .nu = channel.nu()}, twice{2 * H, F, channel.nu()};
  flow.exact[0].instead = {
      slips_along("both walls, or has no viscosity", [=](double, double t) { return F * t; }),
      slips_along("the lower wall", [=](double y, double t) { return twice(y + H, t); }),
      slips_along("the upper wall", twice),
      is_steady([=](double y, double) { return right.steady(y); }),
  };
  return flow;
}

Flow couette(Settings& set) {
  const Channel channel(set);
  const double V = set("V", 0.1 * mm, "m/s", "velocity of the upper plate from t = 0 on");
  const double V_lower = set("V_lower", 0, "m/s", "velocity of the lower plate from t = 0 on");
  const Altered walls = [=](const Changes& by) -> Truth {
    const auto moved = [&](double plate) {
      return reference::Couette{.H = channel.H(by), .V = plate, .nu = channel.nu(by)};
    };
    if (V_lower == 0) return moved(V);
    return
        [upper = moved(V), lower = moved(V_lower)](double y, double t) { return upper(y, t) + lower(lower.H - y, t); };
  };
  const Altered exact = channel.slipping(walls, [](const Changes&) { return 0; }, V_lower, V);
  Flow flow = with_row_means(
      channel.flow(
          "Start-up of plane Couette flow",
          "Fluid at rest between two plates, of which the upper one slides from t = 0, or both do. The oracle is the exact "
          "series of Morris, Fox & Zhu (1997), one for each plate.",
          times_of(channel, {0.05, 0.1, 0.2, 1}), no_slip({V_lower, 0}), no_slip({V, 0}), exact, between_two_plates,
          true),
      exact);
  const double H = channel.H();
  const auto of_one = [=](double plate) {
    return of_both(reference::Couette{.H = 2 * H, .V = plate, .nu = channel.nu()}, 2 * H);
  };
  flow.exact[0].instead = {
      slips_along("the lower wall", [=, upper = of_one(V)](double y, double t) { return upper(y + H, t); }),
      is_steady([=](double y, double) { return V_lower + (V - V_lower) * y / H; }),
  };
  if (V_lower != 0) flow.exact[0].instead.push_back(slips_along("the upper wall", of_one(V_lower)));
  return flow;
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
  flow.exact[0].period = force.period;
  return flow;
}

Flow stokes_first(Settings& set) {
  const Channel channel(set);
  const double V = set("V", 1 * mm, "m/s", "velocity of the plate from t = 0 on");
  Flow flow = channel.flow(
      "Stokes' first problem",
      "A plate below fluid at rest slides from t = 0. The oracle is Stokes' (1851), for fluid without an upper bound: the "
      "boundary layer has to stay below the free-slip ceiling.",
      times_of(channel, {2.5e-3, 0.01}), no_slip({V, 0}), free_slip(),
      [=](const Changes& by) { return reference::StokesFirst{.V = V, .nu = channel.nu(by)}; }, above_one_plate);
  const double H = channel.H(), until = 0.0635 * H * H / channel.nu();  // 2 erfc(H / sqrt(4 nu t)) = 1 %
  flow.exact[0].instead = {
      instead("ceiling felt",
              fmt::format("the flow is right below its ceiling, which the layer of the plate has reached: fluid without "
                          "an upper bound moves otherwise, by more than 1 % of the plate's velocity from {:.3g} s on: "
                          "judge it before, or with a higher ceiling",
                          until),
              of_both(reference::Couette{.H = 2 * H, .V = V, .nu = channel.nu()}, 2 * H))};
  return flow;
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
  flow.exact[0].period = plate.period;
  return flow;
}

}  // namespace touchstone::vnv::doors
