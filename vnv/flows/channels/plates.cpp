#include "vnv/flows/channels/plates.hpp"

#include "vnv/judge/norms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv::flows {
namespace {

/// How far out a plate stands, or seems to: a short slip length is that (Navier 1823), where its flow is not known.
double out(const Changes& by, Cause plate) { return by(plate) + by(Cause::walls) + by(Cause::slip); }

/// Where plates stand if the fluid slips along them.
Changes standing(Changes by) {
  by(Cause::slip) = std::min(by(Cause::slip), 0.0);
  return by;
}

/// Start-up between two plates, at rest or moved along themselves from t = 0, along which the fluid slips: v = b dv/dn
/// (Navier 1823), by the eigenfunctions sin(k y + atan(b k)) of the lower plate. Analytic in y, behind the plates too.
class Slipping {
 public:
  struct Plate {
    double velocity, b;  // m/s, m
  };
  /// `early`: what it is where the series has too many terms.
  Slipping(double H, double F, double nu, Plate lower, Plate upper, Truth early)
      : F_(F), nu_(nu), lower_(lower), early_(std::move(early)) {
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
  double F_, nu_, slope_;
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

/// Whether all the fluid is at rest at t = 0.
bool is_zero(const Truth& exact, double H) {
  for (int k = 1; k < 40; ++k)
    if (exact(k * H / 40, 0) != 0) return false;
  return true;
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

}  // namespace

Plates::Plates(Settings& set) {
  gap.high.y() = set.positive("H", channel::H, "m", "distance between the plates");
  gap.high.x() = set.positive("L", H() * (channel::L / channel::H), "m", "length of the periodic box");
  const double rho = set.positive("rho", channel::water.density, "kg/m³", "density at rest");
  const double nu = set.positive("nu", channel::water.kinematic_viscosity(), "m²/s", "kinematic viscosity");
  const double c = set.positive("c", channel::water.sound_speed(), "m/s", "speed of sound at rest");
  fluid = fluid_of(rho, c, nu);
}

double Plates::H(const Changes& by) const {
  return std::max(0.1 * H(), H() + out(by, Cause::floor) + out(by, Cause::ceiling));
}

Altered Plates::slipping(const Altered& walls, const std::function<double(const Changes&)>& F, double lower,
                         double upper) const {
  return [=, *this](const Changes& by) -> Truth {
    const double b = by(Cause::slip);
    if (!(b > 0)) return walls(by);
    return Slipping(H(standing(by)), F(by), nu(by), {lower, b}, {upper, b},
                    [truth = walls(by), b](double y, double t) { return truth(y + b, t); });
  };
}

Flow Plates::flow(std::string title, std::string description, std::vector<double> times, WallVelocity floor,
                  WallVelocity ceiling, const Altered& altered, std::vector<Cause> causes, bool slips) const {
  const Truth exact = altered({});
  Flow made;
  made.domain = {.box = gap, .periodic_x = true};
  made.fluid = fluid;
  made.filled = gap;
  made.walls = {floor_at(0, std::move(floor)), ceiling_at(H(), std::move(ceiling))};
  if (!is_zero(exact, H())) made.start.velocity = [exact](const Vec2& x) -> Vec2 { return {exact(x.y(), 0), 0}; };
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

std::vector<double> Plates::times(const std::vector<double>& fractions) const {
  std::vector<double> times;
  for (const double fraction : fractions) times.push_back(fraction * H() * H() / nu());
  return times;
}

Truth of_both(const Truth& upper, double H) {
  return [=](double y, double t) { return upper(y, t) + upper(H - y, t); };
}

Instead instead(std::string cause, std::string sentence, const Truth& truth) {
  return {std::move(cause), std::move(sentence), [=](const Vec2& x, double t) { return Vec2(truth(x.y(), t), 0); }};
}
Instead slips_along(const std::string& wall, const Truth& truth) {
  return instead("free slip", fmt::format("the fluid slips freely along {}", wall), truth);
}
Instead is_steady(const Truth& truth) {
  return instead("steady", "the velocity is that of the steady flow already, infinitely ahead", truth);
}

Flow with_row_means(Flow flow, const Altered& altered) {
  const auto by_lines = [](const Level& level) { return means_of_lines(velocity_x, level.spacing); };
  flow.measured.push_back({{velocity_along_x}, norms_of("v_x, row means", by_lines, altered({}))});
  return flow;
}

}  // namespace touchstone::vnv::flows
