/// A circular drop in a straining flow [Monaghan 1994]: a closed free surface and no external force.

#include "vnv/flows/drop.hpp"
#include "vnv/measures/half_axes.hpp"

namespace touchstone::vnv::flows {
namespace {

/// As drop::error_of_axes of rows that start on a lattice. Other rows are not round: each axis is compared with its
/// own start, along x and y.
double error_of_axes_along(const reference::EllipticDrop& drop, const Run& run) {
  std::vector<double> times;
  std::vector<std::vector<double>> axes;
  for (const Samples& s : run.samples) {
    const Vec2 centre = s.x * s.mass.matrix() / s.mass.sum();
    const Eigen::Array2d extents =
        ((s.x.colwise() - centre).array().square().matrix() * s.mass.matrix() / s.mass.sum()).array().sqrt();
    times.push_back(s.time);
    axes.push_back({extents[0], extents[1]});
  }
  return drop::largest_error(drop, times, axes);
}

/// The drop at a time, found once for all particles.
auto found_once(const reference::EllipticDrop& drop) {
  return [drop, known = -1.0, now = drop.at(0)](double t) mutable {
    if (t != known) now = drop.at(known = t);
    return now;
  };
}

}  // namespace

Flow elliptic_drop(Settings& set) {
  using namespace drop;
  const double R = set.positive("R", drop::R, "m", "radius at the start");
  const double s0 = set.positive("s", 1, "1/s", "strain rate at the start, extension along x");
  Flow flow;
  flow.fluid = fluid_of(set, 1000, 60);
  const reference::EllipticDrop drop{.R = R, .s0 = s0, .rho = flow.fluid.density};
  const double until = end / drop.s0, far = 2.6 * R;
  const VelocityTruth velocity = [at = found_once(drop)](const Vec2& x, double t) mutable -> Vec2 {
    const double s = at(t).s;
    return {s * x.x(), -s * x.y()};
  };
  flow.exact_solution = drop;
  flow.domain = {.box = {.low = {-far, -far}, .high = {far, far}}};
  flow.filled = {.low = {-R, -R}, .high = {R, R}};
  flow.shape = "those points of a lattice that lie within the radius R of (0, 0),";
  flow.area = std::numbers::pi * R * R;
  flow.start = {.velocity = [s = drop.at(0).s](const Vec2& x) { return Vec2(s * x.x(), -s * x.y()); },
                .pressure = [at_start = drop.at(0)](
                                const Vec2& x) { return std::max(0.0, at_start.p(x.x(), x.y())); },
                .places = [R](const Vectors& lattice) -> Vectors {
                  std::vector<Eigen::Index> inside;
                  for (Eigen::Index p = 0; p < lattice.cols(); ++p)
                    if (lattice.col(p).norm() < R) inside.push_back(p);
                  return lattice(Eigen::all, inside);
                }};
  flow.region = [domain = flow.domain, drop](double t) {
    const auto now = drop.at(t);  // b < a, so that the depth is at most
    return Region{.domain = domain,
                  .depth = [now](const Vec2& x) { return (1 - std::hypot(x.x() / now.a, x.y() / now.b)) * now.b; },
                  .drawn = {now.a / drop.R, now.b / drop.R}};
  };
  flow.across = 2 * R;
  flow.judged.title = "Stretching elliptic drop";
  flow.judged.description =
      "A circular drop of an inviscid fluid starts with a uniform strain rate; no force acts on it. It stays an "
      "ellipse, whose half-axes and pressure follow from an ordinary differential equation (Monaghan 1994).";
  flow.judged.times = {until / 4, until / 2, 3 * until / 4, until};
  flow.judged.monitor = {.interval = 0.02 / drop.s0,
                         .evaluate =
                             [](const Samples& s) {
                               const auto axes = half_axes(s);
                               return std::vector{axes.longer, axes.shorter};
                             },
                         .quantities = {{"longer half-axis", "m"}, {"shorter half-axis", "m"}}};
  flow.aside = {has_its_pressure()};
  flow.judged.claims = {is_consistent(axes_error),
                        at_most(axes_error, 20, baseline("our own methods at 40 across are 0.1 to 11 % off")),
                        at_most(l2_velocity, 20, baseline("our own methods at 40 across are 0.4 to 13 % off"))};
  flow.exact = {{.field = "velocity",
                 .norms = {l2_velocity.name, linf_velocity.name},
                 .components = 2,
                 .causes = {},
                 .with = [velocity](const Changes&) -> FieldTruth { return velocity; }}};
  const PressureTruth pressure = [at = found_once(drop)](const Vec2& x, double t) mutable {
    return std::max(0.0, at(t).p(x.x(), x.y()));
  };
  flow.measured = {{{"velocity"}, velocity_errors(velocity)},
                   {{"pressure"}, error_of_pressure(drop)},
                   {{"pressure"}, part_of_exact_pressure(pressure, false)},
                   {{},
                    of_finished_run(axes_error, [drop](const Run& run) { return error_of_axes_along(drop, run); }),
                    Span{0, until, 2},
                    "half-axes"}};
  return flow;
}

}  // namespace touchstone::vnv::flows
