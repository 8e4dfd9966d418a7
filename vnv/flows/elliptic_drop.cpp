/// A circular drop in a straining flow [Monaghan 1994]: a closed free surface and no external force.

#include "vnv/flows/drop.hpp"
#include "vnv/flows/flow.hpp"

namespace touchstone::vnv::flows {
namespace {

/// As drop::error_of_axes_in of rows that start on a lattice. Other rows are not round: each axis is compared with its
/// own start, along x and y.
Measurement error_of_axes_along(const reference::EllipticDrop& flow) {
  return [flow](const Level& level, const Run& run) -> std::vector<Value> {
    if (!run.summary.finished) return {};
    const auto extents = [](const Samples& s) -> Eigen::Array2d {
      const Vec2 centre = s.x * s.mass.matrix() / s.mass.sum();
      return ((s.x.colwise() - centre).array().square().matrix() * s.mass.matrix() / s.mass.sum()).array().sqrt();
    };
    const Eigen::Array2d first = extents(run.samples.front());
    double largest = 0;
    for (const Samples& s : run.samples) {
      const auto state = flow.at(s.time);
      const Eigen::Array2d off = extents(s) / first * flow.R / Eigen::Array2d(state.a, state.b) - 1;
      for (const double one : off) largest = norms::larger_magnitude(largest, one);
    }
    return {{level.name, level.spacing, run.summary.end_time, drop::axes_error, 100 * std::abs(largest)}};
  };
}

}  // namespace

Flow elliptic_drop(Settings& set) {
  using namespace drop;
  const double radius = set.positive("R", R, "m", "radius at the start");
  const double strain = set.positive("s", s0, "1/s", "strain rate at the start, extension along x");
  const double density = set.positive("rho", rho0, "kg/m³", "density at zero pressure");
  const double sound_speed = set.positive("c", c, "m/s", "speed of sound at zero pressure");
  const reference::EllipticDrop drop{.R = radius, .s0 = strain, .rho = density};
  const double until = end / strain;
  Flow flow;
  set_scene(flow, scene_with(drop, sound_speed));
  flow.shape = "those points of a lattice that lie within the radius R of (0, 0),";
  flow.area = std::numbers::pi * radius * radius;
  flow.region = [domain = flow.domain, drop](double t) {
    const auto now = drop.at(t);
    return Region{.domain = domain,
                  .depth =
                      [now](const Vec2& x) {
                        return (1 - std::hypot(x.x() / now.a, x.y() / now.b)) * now.b;  // at most, as b < a
                      },
                  .drawn = {now.a / drop.R, now.b / drop.R}};
  };
  flow.across = 2 * radius;
  flow.judged.title = "Stretching elliptic drop";
  flow.judged.description =
      "A circular drop of an inviscid fluid starts with a uniform strain rate; no force acts on it. It stays an "
      "ellipse, whose half-axes and pressure follow from an ordinary differential equation (Monaghan 1994).";
  flow.judged.times = {until / 4, until / 2, 3 * until / 4, until};
  flow.judged.monitor = monitored_axes();
  flow.judged.monitor.interval /= strain;
  flow.aside = {has_its_pressure()};
  flow.judged.claims = {is_consistent(axes_error),
                        at_most(axes_error, 20,
                                theory("a free surface moves with its fluid; our own methods at 40 across are 0.1 to "
                                       "11 % off")),
                        at_most(l2_velocity, 20,
                                theory("the velocity is that of the strain; our own methods at 40 across "
                                       "are 0.4 to 13 % off"))};
  flow.exact = {{.field = "velocity",
                 .norms = {l2_velocity.name, linf_velocity.name},
                 .components = 2,
                 .causes = {},
                 .with = [drop](const Changes&) -> FieldTruth { return velocity_of(drop); }}};
  flow.measured = {{{"velocity"}, velocity_errors(velocity_of(drop))},
                   {{"pressure"}, error_of_pressure(drop)},
                   {{"pressure"},
                    part_of_exact_pressure(
                        [drop, known = -1.0, now = drop.at(0)](const Vec2& x, double t) mutable {
                          if (t != known) now = drop.at(known = t);
                          return std::max(0.0, now.p(x.x(), x.y()));
                        },
                        false)},
                   {{}, error_of_axes_along(drop), Span{0, until, 2}, "half-axes"}};
  return flow;
}

}  // namespace touchstone::vnv::flows
