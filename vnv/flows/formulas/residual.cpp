#include "vnv/flows/formulas/residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace touchstone::vnv::formulas {
namespace {

/// The slope of a function of a number at 0, by a step.
template <class Found>
Found slope(const auto& f, double h) {
  return (45.0 * (f(h) - f(-h)) - 9.0 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

/// Velocity, pressure and force of a flow, and their derivatives by steps [m, s].
class Fields {
 public:
  Fields(const Flow& flow, double h, double dt)
      : velocity_(flow.velocity()), drive_(flow.drive), rho_(flow.fluid.density), h_(h), dt_(dt) {
    if (flow.exact.size() > 1) pressure_ = flow.pressure();
  }

  Vec2 v(const Vec2& x, double t) const { return velocity_(x, t); }
  bool has_pressure() const { return static_cast<bool>(pressure_); }
  Vec2 force(const Vec2& x, double t) const {
    return drive_.at ? drive_.at(x, t) : Vec2(drive_.amplitude * std::cos(drive_.angular_frequency * t));
  }
  double vorticity(const Vec2& x, double t) const { return curl(velocity_, x, t); }
  double curl_of_force(const Vec2& x, double t) const {
    return curl([this](const Vec2& at, double when) { return force(at, when); }, x, t);
  }
  /// Of a number or a vector that is a function of place and time.
  auto along(int axis, const auto& f, const Vec2& x, double t) const {
    using Found = std::decay_t<decltype(f(x, t))>;
    return slope<Found>([&](double s) -> Found { return f(x + s * Vec2::Unit(axis), t); }, h_);
  }
  auto in_time(const auto& f, const Vec2& x, double t) const {
    using Found = std::decay_t<decltype(f(x, t))>;
    return slope<Found>([&](double s) -> Found { return f(x, t + s); }, dt_);
  }
  auto laplacian(const auto& f, const Vec2& x, double t) const {
    using Found = std::decay_t<decltype(f(x, t))>;
    const auto second = [&](int axis) {
      const auto at = [&](double s) -> Found { return f(x + s * h_ * Vec2::Unit(axis), t); };
      return Found((270.0 * (at(1) + at(-1)) - 27.0 * (at(2) + at(-2)) + 2.0 * (at(3) + at(-3)) - 490.0 * at(0)) /
                   (180 * h_ * h_));
    };
    return Found(second(0) + second(1));
  }
  Vec2 pressure_gradient(const Vec2& x, double t) const {
    return Vec2(along(0, pressure_, x, t), along(1, pressure_, x, t)) / rho_;
  }

 private:
  double curl(const auto& of, const Vec2& x, double t) const { return along(0, of, x, t).y() - along(1, of, x, t).x(); }

  VelocityTruth velocity_;
  PressureTruth pressure_{};
  Drive drive_;
  double rho_, h_, dt_;
};

/// The largest residual of an equation and its largest term, over all places and times.
struct Largest {
  std::string equation{};
  double residual = 0, term = 0;
  Vec2 x = Vec2::Zero();
  double t = 0;

  void take(double its_residual, double its_term, const Vec2& at, double when) {
    term = std::max(term, its_term);
    if (!(its_residual > residual)) return;
    residual = its_residual, x = at, t = when;
  }
  double size() const { return term > 0 ? residual / term : 0; }
};

/// Of two equations, by a step of place and time relative to those of the flow.
std::array<Largest, 2> largest_by(const Flow& flow, double step) {
  const double h = step * flow.domain.box.size().minCoeff(), dt = step * flow.judged.times.front(),
               nu = flow.fluid.viscosity / flow.fluid.density;
  const Fields at(flow, h, dt);
  const auto v = [&](const Vec2& x, double t) { return at.v(x, t); };
  const auto vorticity = [&](const Vec2& x, double t) { return at.vorticity(x, t); };
  std::array<Largest, 2> all{{{"continuity"}, {at.has_pressure() ? "momentum" : "vorticity"}}};
  constexpr int count = 7;  // along each axis
  for (const double t : flow.judged.times)
    for (int k = 0; k < count * count; ++k) {
      const Vec2 part(0.1 + 0.8 * (k % count + 0.31) / count,
                      0.1 + 0.8 * (static_cast<double>(k / count) + 0.57) / count);
      const Vec2 x = flow.domain.box.low + flow.domain.box.size().cwiseProduct(part);
      const Vec2 v_x = at.along(0, v, x, t), v_y = at.along(1, v, x, t), here = at.v(x, t);
      if (!v_x.allFinite() || !v_y.allFinite()) continue;
      all[0].take(std::abs(v_x.x() + v_y.y()), v_x.norm() + v_y.norm(), x, t);
      if (at.has_pressure()) {
        const Vec2 unsteady = at.in_time(v, x, t), convected = here.x() * v_x + here.y() * v_y,
                   pushed = at.pressure_gradient(x, t), viscous = nu * at.laplacian(v, x, t), force = at.force(x, t);
        all[1].take((unsteady + convected + pushed - viscous - force).norm(),
                    std::max({unsteady.norm(), convected.norm(), pushed.norm(), viscous.norm(), force.norm()}), x, t);
      } else {
        const double unsteady = at.in_time(vorticity, x, t),
                     convected = here.x() * at.along(0, vorticity, x, t) + here.y() * at.along(1, vorticity, x, t),
                     viscous = nu * at.laplacian(vorticity, x, t), force = at.curl_of_force(x, t);
        all[1].take(std::abs(unsteady + convected - viscous - force),
                    std::max({std::abs(unsteady), std::abs(convected), std::abs(viscous), std::abs(force)}), x, t);
      }
    }
  return all;
}

}  // namespace

Residual residual_of(const Flow& flow) {
  // Fields of unknown scales: the step at which differences leave least says how large a residual is at most.
  std::array<Largest, 2> least{{{.residual = HUGE_VAL, .term = 1}, {.residual = HUGE_VAL, .term = 1}}};
  bool is_any = false;
  for (const double step : {1e-2, 3e-3, 1e-3, 1e-4}) {
    const std::array<Largest, 2> found = largest_by(flow, step);
    for (const std::size_t k : {0u, 1u}) {
      is_any |= found[k].term > 0;
      if (found[k].size() < least[k].size()) least[k] = found[k];
    }
  }
  if (!is_any)
    throw std::invalid_argument("the exact velocity has no slope anywhere, expected one to test the equation with");
  // Where volume is not conserved momentum is not, either.
  const Largest& worst = least[0].size() > largest_residual ? least[0] : *std::ranges::max_element(least, {}, &Largest::size);
  return {worst.size(),
          fmt::format("the residual of the {} equation is {:.2g} of its largest term at ({:.3g}, {:.3g}) m, {:.3g} s",
                      worst.equation, worst.size(), worst.x.x(), worst.x.y(), worst.t)};
}

}  // namespace touchstone::vnv::formulas
