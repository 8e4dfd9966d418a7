/// A round drop that a strain stretches [Monaghan 1994]: a free surface all around, and nothing that holds it together.

#include "reference/elliptic_drop.hpp"
#include "vnv/free_surface_methods.hpp"
#include "vnv/measures/field_errors.hpp"
#include "vnv/measures/half_axes.hpp"
#include "vnv/plots/along_ladders.hpp"
#include "vnv/plots/over_time.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double R = 1, s0 = 1, rho0 = 1000, c = 60;  // m, 1/s, kg/m³, m/s
constexpr double end = 0.8;                           // s  the drop is twice as long, and four times as long as wide
constexpr double whole = 0.1;                         // s  of which every step divides the times
const reference::EllipticDrop exact{.R = R, .s0 = s0, .rho = rho0};

/// The drop, stretched along a direction that is turned by an angle [radian].
struct Drop {
  double angle;

  Mat2 turned() const { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }
  Vec2 velocity(const Vec2& x, double t) const {
    const auto state = exact.at(t);
    return turned() * Vec2(state.s, -state.s).cwiseProduct(turned().transpose() * x);
  }
  double pressure(const Vec2& x, double t) const {
    const Vec2 along = turned().transpose() * x;
    return std::max(0.0, exact.at(t).p(along.x(), along.y()));
  }
  Scene<Tait> scene() const {
    return {.domain = {.box = {.low = {-2.6, -2.6}, .high = {2.6, 2.6}}},
            .fluid = {.density = rho0, .bulk_modulus = rho0 * c * c / 7},
            .filled = {.low = {-R, -R}, .high = {R, R}},
            .start = {.velocity = [drop = *this](const Vec2& x) { return drop.velocity(x, 0); },
                      .pressure = [drop = *this](const Vec2& x) { return drop.pressure(x, 0); },
                      .places = within}};
  }

  static Vectors within(const Vectors& lattice) {
    std::vector<Eigen::Index> inside;
    for (Eigen::Index p = 0; p < lattice.cols(); ++p)
      if (lattice.col(p).norm() < R) inside.push_back(p);
    return lattice(Eigen::all, inside);
  }
};

const std::string turned = ", turned by 30 degrees";
Drop drop_of(const Rung& rung) { return {rung.name.ends_with(turned) ? std::numbers::pi / 6 : 0}; }

const std::string axes_error = "Linf of both half-axes until stretched twofold [%]";
const std::string pressure_error = "pressure in the middle, less the exact, over that at the start [%]";

/// The half-axes, relative to those of the particles at the start, against the exact ones, at all times until the end.
std::vector<Error> error_of_axes(const Rung& rung, const Run& run) {
  double largest = 0;
  for (std::size_t k = 0; k < run.history.time.size(); ++k) {
    const auto state = exact.at(run.history.time[k]);
    largest = norms::larger_magnitude(largest, run.history.seen[k][0] / run.history.seen[0][0] * R / state.a - 1);
    largest = norms::larger_magnitude(largest, run.history.seen[k][1] / run.history.seen[0][1] * R / state.b - 1);
  }
  if (!run.summary.finished) return {};
  return {{rung.name, rung.spacing, end, axes_error, 100 * std::abs(largest)}};
}

/// Mean over the particles within a fifth of the drop's half-axes.
std::vector<Error> error_of_pressure(const Rung& rung, const Run& run) {
  std::vector<Error> errors;
  for (const Samples& s : run.samples) {
    const auto state = exact.at(s.time);
    const Mat2 turned_back = drop_of(rung).turned().transpose();
    double sum = 0, count = 0;
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      const Vec2 x = turned_back * s.x.col(p);
      if (Vec2(x.x() / state.a, x.y() / state.b).norm() > 0.2) continue;
      sum += s.pressure[p] - state.p(x.x(), x.y());
      ++count;
    }
    errors.push_back({rung.name, rung.spacing, s.time, pressure_error, 100 * sum / count / exact.at(0).p_centre});
  }
  return errors;
}

std::vector<Error> velocity_error(const Rung& rung, const Run& run) {
  return velocity_errors([drop = drop_of(rung)](const Vec2& x, double t) { return drop.velocity(x, t); })(rung, run);
}

std::vector<Rung> levels() {
  std::vector<Rung> all =
      rungs_across(2 * R, {{40, end, 0, end}, {60, end, 0, end}, {80, 0, 0, end}, {120, 0, 0, end}});
  Rung skew = all[0];
  skew.name += turned;
  all.push_back(skew);
  return all;
}

/// A method, which `make` makes for a scene, on its ladder and once turned.
template <class Make>
Method stretched_along(const Make& make, std::vector<Claim> claims = {}) {
  Method climbing = up(levels(), make(Drop{0}.scene()), std::move(claims));
  climbing.ladders[0].rungs.pop_back();
  climbing.run = [=](const Rung& rung, const Schedule& when) { return make(drop_of(rung).scene()).run(rung, when); };
  return climbing;
}

Claim holds_its_shape() {
  return at_most(axes_error, 0.5, baseline("half-axes within half a per cent are what is wanted until 2:1"));
}
std::vector<Claim> claims() { return {holds_its_shape()}; }

}  // namespace

Case vnv::the_case() {
  const auto length = [](double t) { return exact.at(t).a; };
  return {
      .title = "Stretching elliptic drop",
      .description =
          "A round drop of 1 m of an inviscid fluid is stretched at 1/s along x and flattened along y; nothing else acts on "
          "it. It stays an ellipse, whose half-axes and whose pressure follow from an ordinary differential equation "
          "(Monaghan 1994). After 0.8 s it is twice as long as at the start. Mach number 1/60. One run is turned by 30 "
          "degrees against the particles' lattice and the grid.",
      .times = {0.2, 0.4, 0.6, end},
      .watch = {.every = 0.02,
                .see =
                    [](const Samples& s) {
                      const auto axes = half_axes(s);
                      return std::vector{axes[0], axes[1]};
                    }},
      .measurements = {error_of_axes, velocity_error, error_of_pressure},
      .methods =
          {stretched_along([](const auto& scene) { return mpm_as_printed(scene, whole, 0.4); }),
           stretched_along(
               [](const auto& scene) { return mpm_affine(scene, whole, 0.4); },
               {holds_its_shape(),
                order_at_least(ladder_across, axes_error, 1, 0.75, theory("the surface is known to a cell")).over(4)}),
           stretched_along([](const auto& scene) { return mpm_apic(scene, whole); }, claims()),
           stretched_along([](const auto& scene) { return mpm_xpic(scene, whole); }),
           stretched_along([](const auto& scene) { return sph_as_printed(scene, whole, 0.2); }),
           stretched_along([](const auto& scene) { return sph_corrected(scene, whole, {.alpha = 0.005}); }, claims())},
      .plots = {over_time({"length",
                           "Longer half-axis over time",
                           "From the second moments of the particles.",
                           {"t [s]"},
                           {"half-axis [m]"}},
                          0, {"60 across"}),
                exact_over_time("length", length, end),
                along_ladders({"order",
                               "Error over spacing",
                               fmt::format("L2 error of the velocity, particle by particle, at t = {:g} s.", end),
                               {.label = "particle spacing [mm]", .scale = 1e3, .logarithmic = true},
                               {.label = "L2 v [%]", .logarithmic = true}},
                              {}, spacing(), {{"", error_of(l2_velocity, end)}})}};
}
