#pragma once
/// Smoothed particle hydrodynamics by plain loops over all pairs of particles: what the methods over listed neighbours
/// in lanes do, equal but for rounding, to compare them with. No lists, no order of cells, no lanes, no passes that do
/// several things at once; kernels, terms, parts and integrators are the same.

#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/common_steps.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/stepping/clock.hpp"

#include <optional>
#include <utility>

namespace touchstone::sph {

template <class Value>
Value nothing() {
  if constexpr (std::is_arithmetic_v<Value>)
    return 0;
  else
    return Value::Zero();
}

/// What plain methods share. Behind the fluid stand the ghosts, and behind both their copies, one period further.
template <class Method, class Kernel, class Integrator, class Packed, class FluidLaw, class Force>
class PlainSimulation : public Clock {
 public:
  PlainSimulation(const Scene<FluidLaw, Force>& scene, const Settings& settings, std::size_t carried)
      : Clock("sph", settings.time_step),
        scene_(scene),
        h_(settings.smoothing_length),
        spacing_(settings.spacing),
        ghosts_(lay_out_ghosts(scene.domain, scene.walls, spacing_, ghost_layers<Kernel>(settings)).ghosts) {
    const Lattice cells = lattice(scene.filled, spacing_, scene.domain.box);
    const Vectors places = places_in(scene.domain.box, scene.start, cells);
    const Index n = all_.fluid = places.cols();
    all_.mass = scene.fluid.density * cells.volume();
    all_.x = places.row(0);
    all_.y = places.row(1);
    all_.each_field([&](Scalars& field) { field.setZero(n); });
    for (Index i = 0; i < n; ++i) {
      const Vec2 v = scene.start.velocity_at(places.col(i));
      all_.vx[i] = v.x(), all_.vy[i] = v.y();
      all_.rho[i] = scene.fluid.density_at(scene.start.pressure_at(places.col(i)));
    }
    all_.carried.assign(carried, Scalars::Zero(n));
    all_.past.assign(Integrator::past_fields, Scalars::Zero(n));
    const Vec2 period = scene.domain.box.size();
    const auto steps = [](bool periodic) { return periodic ? std::vector{0, 1, -1} : std::vector{0}; };
    for (const int k : steps(scene.domain.periodic_x))
      for (const int l : steps(scene.domain.periodic_y)) shifts_.emplace_back(k * period.x(), l * period.y());
    seen_.resize(shifts_.size() * originals());
  }

  void step() {
    method().spread_particles();
    integrator_.step(*this, time(), time_step(), no_laps);
    tick();
    method().correct_density();
  }
  Samples samples() const {
    Samples s = Samples::of_equal(time(), all_.fluid, all_.mass);
    s.density = all_.rho;
    for (Index i = 0; i < s.size(); ++i) {
      s.x.col(i) = Vec2(scene_.domain.wrapped(0, all_.x[i]), scene_.domain.wrapped(1, all_.y[i]));
      s.v.col(i) = Vec2(all_.vx[i], all_.vy[i]);
      s.pressure[i] = scene_.fluid.pressure(all_.rho[i]);
    }
    return s;
  }

  // For the integrator.
  Particles& state() { return all_; }
  static int threads() { return 1; }
  void find_rates(double time, const Laps&) { method().template find<true, true>(time); }
  void find_density_rate(double time, const Laps&) { method().template find<true, false>(time); }
  void find_accelerations(double time, const Laps&) { method().template find<false, true>(time); }
  void before_drift(double time, double dt) { method().meet_walls(time, dt); }

 protected:
  static void spread_particles() {}
  static void correct_density() {}
  static void meet_walls(double /*time*/, double /*dt*/) {}

  Index originals() const { return all_.fluid + static_cast<Index>(ghosts_.size()); }
  bool is_fluid(Index j) const { return j % originals() < all_.fluid; }
  One<Packed> one(Index j) const { return {seen_.data(), j}; }
  /// A pair with the slope of its kernel.
  Pair<double> pair(Index i, Index j) const { return pair_of(one(i), one(j), all_.mass, Slope<Kernel>(h_)); }

  /// Sums what terms(j) says of each particle j within the reach of the kernel of i but itself; `which(j)` are asked.
  template <class Which, class Terms>
  auto sum(Index i, const Which& which, const Terms& terms) const {
    auto total = nothing<decltype(terms(i))>();
    for (Index j = 0; j < static_cast<Index>(seen_.size()); ++j)
      if (j != i && which(j) && distance(one(i), one(j)) < Kernel::support * h_) total += terms(j);
    return total;
  }
  template <class Terms>
  auto sum(Index i, const Terms& terms) const {
    return sum(
        i, [](Index) { return true; }, terms);
  }
  template <class Work>
  void for_fluid(const Work& work) const {
    for (Index i = 0; i < all_.fluid; ++i) work(i);
  }

  void copy_over_periods() {
    for (std::size_t k = 1; k < shifts_.size(); ++k)
      for (Index j = 0; j < originals(); ++j) {
        Packed& copy = seen_[k * originals() + j];
        copy = seen_[j];
        const Vec2 x = place(j) + shifts_[k];
        copy.stand_at(x.x(), x.y());
      }
  }
  Vec2 place(Index j) const {
    return j < all_.fluid ? Vec2(all_.x[j], all_.y[j]) : ghosts_[static_cast<std::size_t>(j - all_.fluid)].x;
  }
  void see_fluid() {
    for_fluid([&](Index i) {
      seen_[i].stand_at(all_.x[i], all_.y[i]);
      seen_[i].move(all_.vx[i], all_.vy[i]);
      seen_[i].set_state(all_.rho[i], scene_.fluid.pressure(all_.rho[i]));
    });
    copy_over_periods();
  }

  /// A mean over the fluid near a ghost, weighted by `weight(j)` times the kernel; nothing where there is no fluid.
  template <class Weight, class Value>
  auto mean_at(Index ghost, const Weight& weight, const Value& value) const -> std::optional<decltype(value(ghost))> {
    const auto fluid = [&](Index j) { return is_fluid(j); };
    const auto kernel = [&](Index j) { return weight(j) * Kernel::w(distance(one(ghost), one(j)) / h_); };
    const double weights = sum(ghost, fluid, kernel);
    if (!(weights > 0)) return std::nullopt;
    return decltype(value(ghost))(sum(ghost, fluid, [&](Index j) { return decltype(value(j))(kernel(j) * value(j)); }) /
                                  weights);
  }
  /// Ghosts whose velocity at_wall(ghost, wall, v) makes of the mean of the fluid near them, at each wall that they are
  /// behind, with what state(ghost, its place) says of density and pressure; at rest without pressure where there is no
  /// fluid.
  template <class Weight, class AtWall, class State>
  void see_ghosts(const Weight& weight, const AtWall& at_wall, const State& state) {
    for (Index g = all_.fluid; g < originals(); ++g) {
      const auto& [x, behind] = ghosts_[static_cast<std::size_t>(g - all_.fluid)];
      seen_[g].stand_at(x.x(), x.y());
      seen_[g].move(0, 0);
      seen_[g].set_state(scene_.fluid.density, 0);
      auto v = mean_at(g, weight, [&](Index j) { return Vec2(seen_[j].vx, seen_[j].vy); });
      if (!v) continue;
      for (const int w : behind) *v = at_wall(g, scene_.walls[w], *v);
      seen_[g].move(v->x(), v->y());
      const auto [rho, p] = state(g, x);
      seen_[g].set_state(rho, p);
    }
    copy_over_periods();
  }
  auto mirrored(double time) const {
    return [this, time](Index g, const Wall& wall, const Vec2& v) -> Vec2 {
      return 2 * wall.at_wall(v, time, -wall.distance(place(g))) - v;
    };
  }
  /// With the mean density and pressure.
  void see_mirrored_ghosts(double time) {
    const auto volume = [&](Index j) { return seen_[j].specific_volume; };
    see_ghosts(volume, mirrored(time), [&](Index g, const Vec2&) {
      return std::pair(*mean_at(g, volume, [&](Index j) { return seen_[j].rho; }),
                       *mean_at(g, volume, [&](Index j) { return seen_[j].p; }));
    });
  }

  template <class Terms>
  Vec2 acceleration(const Terms& terms, Index i) const {
    return sum(i, [&](Index j) {
      const Pair<double> ij = pair(i, j);
      Vec2 total = Vec2::Zero();
      const auto add = [&](const Acceleration<double>& a) { total += Vec2(a.x, a.y); };
      std::apply([&](const auto&... term) { (add(term(ij)), ...); }, terms.terms);
      return Vec2(total);
    });
  }
  Vec2 body_force(Index i, double time) const {
    if constexpr (is_present<Force>) return scene_.body_force(place(i), time);
    return Vec2::Zero();
  }

  Scene<FluidLaw, Force> scene_;
  double h_, spacing_;  // m
  std::vector<BoundaryLayout::Ghost> ghosts_;
  std::vector<Vec2> shifts_;  // m  of the particles themselves, and of their copies
  Particles all_;
  std::vector<Packed> seen_;

 private:
  Method& method() { return static_cast<Method&>(*this); }

  Integrator integrator_;
};

/// As `Printed`, with nothing on walls, and as `TransportVelocity`: pairs whose density follows continuity, what
/// `Left` leaves out.
template <class Kernel, class Integrator, class Left, class FluidLaw, class Force, class Terms>
class PlainConfined : public PlainSimulation<PlainConfined<Kernel, Integrator, Left, FluidLaw, Force, Terms>, Kernel,
                                             Integrator, Packed<double>, FluidLaw, Force> {
  using Base = PlainSimulation<PlainConfined, Kernel, Integrator, Packed<double>, FluidLaw, Force>;
  using Base::all_, Base::seen_, Base::scene_, Base::h_;
  static constexpr bool drifts = Left::template keeps<BackgroundPressure>;

 public:
  PlainConfined(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : Base(scene, settings, 2), terms_(terms) {}

 private:
  friend Base;

  Vec2 drift(Index j) const {  // m/s
    const Index i = j % this->originals();
    return i < all_.fluid ? Vec2(all_.carried[0][i], all_.carried[1][i]) : Vec2(0, 0);
  }

  void spread_particles() {
    all_.x += this->time_step() * all_.carried[0];
    all_.y += this->time_step() * all_.carried[1];
  }
  void correct_density() {
    if (this->steps() % 30 != 0) return;
    Scalars& rho = all_.rho;
    if constexpr (Left::template keeps<VolumeConstraint>)
      rho *= scene_.fluid.density / static_cast<double>(all_.fluid) * rho.inverse().sum();
    if constexpr (Left::template keeps<DensityReinitialisation>) {
      this->see_fluid();
      const auto w = [&](Index i, Index j) { return Kernel::w(distance(this->one(i), this->one(j)) / h_); };
      this->for_fluid([&](Index i) {
        const double weights = this->sum(i, [&](Index j) { return w(i, j); }),
                     volumes = this->sum(i, [&](Index j) { return w(i, j) * seen_[j].specific_volume; });
        rho[i] = (weights + Kernel::w(0.0)) / (volumes + Kernel::w(0.0) / rho[i]);
      });
    }
  }

  template <bool of_density, bool of_velocity>
  void find(double time) {
    this->see_fluid();
    this->see_mirrored_ghosts(time);
    Scalars drift_x = all_.carried[0], drift_y = all_.carried[1];
    this->for_fluid([&](Index i) {
      if constexpr (of_density) all_.drho[i] = this->sum(i, [&](Index j) { return this->pair(i, j).continuity(); });
      if constexpr (!of_velocity) return;
      Vec2 a = this->acceleration(terms_, i);
      if constexpr (drifts) {
        const double c = scene_.fluid.sound_speed(), background = 0.1 * scene_.fluid.density * c * c;
        const auto along = [&](Index j) -> Vec2 {  // V² grad W
          const Pair<double> ij = this->pair(i, j);
          return ij.mass * ij.slope * (std::pow(ij.specific_volume_i, 2) + std::pow(ij.specific_volume_j, 2)) *
                 Vec2(ij.x, ij.y);
        };
        const auto carries = [&](Index j) -> Mat2 {  // rho v (transport velocity - v)
          return seen_[j].rho * Vec2(seen_[j].vx, seen_[j].vy) * drift(j).transpose();
        };
        const Vec2 spread = this->sum(i, [&](Index j) { return Vec2(along(j)); });
        drift_x[i] = -background * this->time_step() / 2 * spread.x();
        drift_y[i] = -background * this->time_step() / 2 * spread.y();
        if constexpr (Left::template keeps<DriftMomentum>)
          a += this->sum(i, [&](Index j) { return Vec2((carries(i) + carries(j)) / 2 * along(j)); });
      }
      a += this->body_force(i, time);
      all_.ax[i] = a.x(), all_.ay[i] = a.y();
    });
    all_.carried[0] = drift_x, all_.carried[1] = drift_y;
  }

  Terms terms_;
};

/// As `FreeSurface`, without gates.
template <class Kernel, class Integrator, class FluidLaw, class Force, class Terms, class PartsOfMethod>
class PlainFreeSurface
    : public PlainSimulation<PlainFreeSurface<Kernel, Integrator, FluidLaw, Force, Terms, PartsOfMethod>, Kernel,
                             Integrator, PackedOfSurface<double, PartsOfMethod>, FluidLaw, Force> {
  using Seen = PackedOfSurface<double, PartsOfMethod>;
  using Base = PlainSimulation<PlainFreeSurface, Kernel, Integrator, Seen, FluidLaw, Force>;
  using Base::all_, Base::seen_, Base::scene_, Base::h_;
  using Found = Finds<PartsOfMethod>;

 public:
  PlainFreeSurface(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms,
                   const PartsOfMethod& parts)
      : Base(scene, settings, Found::carried), terms_(terms), parts_(parts) {}

 private:
  friend Base;

  double least_distance() const { return contact_distance * this->spacing_; }
  void meet_walls(double time, double dt) {
    keep_off_walls(
        all_, all_.vx, all_.vy, scene_.walls, least_distance(), time, dt,
        [&](Index i, const Vec2&, double, double) { all_.rho[i] = std::max(all_.rho[i], scene_.fluid.density); });
  }
  void spread_particles() {
    if constexpr (Found::shifting) {
      const double times = std::sqrt((all_.vx.square() + all_.vy.square()).maxCoeff()) * this->time_step();
      auto &x = all_.carried[Found::shift_x], &y = all_.carried[Found::shift_y];
      keep_off_walls(all_, x, y, scene_.walls, least_distance(), this->time(), times,
                     [](Index, const Vec2&, double, double) {});
      all_.x += times * x;
      all_.y += times * y;
    }
  }

  /// V_j grad W at i.
  Vec2 gradient(Index i, Index j) const {
    const Pair<double> ij = this->pair(i, j);
    return ij.mass * ij.specific_volume_j * ij.slope * Vec2(ij.x, ij.y);
  }
  /// The sum of V_j (q_j - q_i) grad W, times L_i.
  template <class Quantity>
  Vec2 corrected_gradient(Index i, const Quantity& q) const {
    const Vec2 sum = this->sum(i, [&](Index j) { return Vec2((q(j) - q(i)) * gradient(i, j)); });
    return seen_[i].corrected(sum.x(), sum.y());
  }

  template <bool of_density, bool of_velocity>
  void find(double time) {
    if constexpr (!of_density && (Found::correction || Found::shifting)) relieve_drops();
    see(time);
    if constexpr (of_density) {
      if constexpr (Found::density_gradient) see_density_gradient();
      if constexpr (Found::surroundings) find_surroundings();
      this->for_fluid([&](Index i) {
        all_.drho[i] = -all_.rho[i] * divergence(i);
        if constexpr (Found::diffusion)
          all_.drho[i] += this->sum(
              i, [&](Index j) { return parts_.diffusion.rate(this->pair(i, j), this->one(i), this->one(j)); });
        if constexpr (Found::shifting) shift_to(i, displacement(i));
        const Vec2 a = this->acceleration(terms_, i);
        all_.ax[i] = a.x(), all_.ay[i] = a.y();
      });
    }
    if constexpr (of_velocity)
      this->for_fluid([&](Index i) {
        const Vec2 a = pull(i) + this->body_force(i, time);
        all_.ax[i] += a.x(), all_.ay[i] += a.y();
        if constexpr (Found::density_gradient) {
          const Vec2 along = corrected_gradient(i, [&](Index j) { return seen_[j].rho; });
          all_.carried[Found::first_of_density_gradient][i] = along.x();
          all_.carried[Found::first_of_density_gradient + 1][i] = along.y();
        }
        if constexpr (Found::shifting) shift_to(i, along_surface(i));
      });
  }

  void relieve_drops() {
    this->for_fluid([&](Index i) {
      if (seen_[i].least_eigenvalue < 0.4) all_.rho[i] = std::max(all_.rho[i], scene_.fluid.density);
    });
  }
  /// Fluid, and ghosts whose pressure holds it against its weight.
  void see(double time) {
    this->see_fluid();
    const auto equal = [](Index) { return 1.0; };
    this->see_ghosts(equal, this->mirrored(time), [&](Index g, const Vec2& x) {
      double p = *this->mean_at(g, equal, [&](Index j) { return seen_[j].p; });
      if constexpr (is_present<Force>)
        p += scene_.body_force(x, time).dot(
            *this->mean_at(g, equal, [&](Index j) { return Vec2(seen_[j].rho * (x - Vec2(seen_[j].x, seen_[j].y))); }));
      return std::pair(scene_.fluid.density_at(p), p);
    });
  }
  /// That of the last pass, for ghosts its mean.
  void see_density_gradient() {
    const auto& of = all_.carried;
    constexpr std::size_t first = Found::first_of_density_gradient;
    this->for_fluid([&](Index i) { seen_[i].set_density_gradient(of[first][i], of[first + 1][i]); });
    this->copy_over_periods();
    for (Index g = all_.fluid; g < this->originals(); ++g) {
      const auto mean = this->mean_at(
          g, [](Index) { return 1.0; }, [&](Index j) { return Vec2(seen_[j].rho_along_x, seen_[j].rho_along_y); });
      seen_[g].set_density_gradient(mean ? mean->x() : 0, mean ? mean->y() : 0);
    }
    this->copy_over_periods();
  }
  void find_surroundings() {
    this->for_fluid([&](Index i) {
      const Mat2 moments = this->sum(i, [&](Index j) {
        const Pair<double> ij = this->pair(i, j);
        return Mat2(-gradient(i, j) * Vec2(ij.x, ij.y).transpose());
      });
      if constexpr (Found::correction) {
        const auto weight = [&](double slope, double volume) { return -all_.mass * volume * slope; };
        const Slope<Kernel> slope(h_);
        constexpr double close = 1e-3;
        const double own = weight(slope(close * h_, 1 / (close * h_)), 1 / all_.rho[i]),
                     weights = own + this->sum(i, [&](Index j) {
                       const Pair<double> ij = this->pair(i, j);
                       return weight(ij.slope, ij.specific_volume_j);
                     });
        seen_[i].set_surroundings(moments(0, 0), moments(0, 1), moments(1, 1),
                                  extent<Kernel>(moments.trace(), weights, h_));
      } else {
        seen_[i].set_surroundings(moments(0, 0), moments(0, 1), moments(1, 1));
      }
    });
    this->copy_over_periods();
  }

  /// Towards ghosts, where pressure pulls by corrected gradients, the mean of the corrected gradient and the plain one.
  double divergence(Index i) const {
    const auto v = [&](Index j) { return Vec2(seen_[j].vx, seen_[j].vy); };
    return this->sum(i, [&](Index j) -> double {
      const Vec2 along = gradient(i, j), relative = v(j) - v(i);
      if constexpr (Found::correction) {
        const Vec2 corrected =
            ReadsSurroundings<decltype(PartsOfMethod::gradient)> ? seen_[i].corrected(along.x(), along.y()) : along;
        return relative.dot(this->is_fluid(j) ? corrected : (corrected + along) / 2);
      }
      return relative.dot(along);
    });
  }
  Vec2 pull(Index i) const {
    return this->sum(i, [&](Index j) {
      const Pair<double> ij = this->pair(i, j);
      Acceleration<double> a;
      if constexpr (ReadsSurroundings<decltype(PartsOfMethod::pressure)>)
        a = parts_.pressure(ij, this->one(i), this->one(j));
      else
        a = parts_.gradient(this->one(i), this->one(j), parts_.pressure(ij));
      return Vec2(a.x, a.y);
    });
  }

  Vec2 displacement(Index i) const {
    return parts_.shifting.displacement(
        this->sum(i,
                  [&](Index j) {
                    const double q = distance(this->one(i), this->one(j)) / h_;
                    return Vec2(parts_.shifting.template concentration_weight<Kernel>(q, 1 / h_) * gradient(i, j));
                  }),
        h_);
  }
  Vec2 along_surface(Index i) const {
    const auto eigenvalue = [&](Index j) { return seen_[j].least_eigenvalue; };
    const Vec2 sum = this->sum(i, [&](Index j) { return Vec2((eigenvalue(j) - eigenvalue(i)) * gradient(i, j)); });
    const double of_surface =
        this->sum(i, [&](Index j) { return eigenvalue(j) < parts_.shifting.surface ? 1.0 : 0.0; });
    return parts_.shifting.along_surface({all_.carried[Found::shift_x][i], all_.carried[Found::shift_y][i]}, seen_[i],
                                         sum, of_surface > 0);
  }
  void shift_to(Index i, const Vec2& displacement) {
    all_.carried[Found::shift_x][i] = displacement.x();
    all_.carried[Found::shift_y][i] = displacement.y();
  }

  Terms terms_;
  PartsOfMethod parts_;
};

/// As `SecondOrder`: each fit by a factorisation of its own.
template <class Kernel, class Integrator, class FluidLaw, class Force>
class PlainSecondOrder : public PlainSimulation<PlainSecondOrder<Kernel, Integrator, FluidLaw, Force>, Kernel,
                                                Integrator, Packed<double>, FluidLaw, Force> {
  using Base = PlainSimulation<PlainSecondOrder, Kernel, Integrator, Packed<double>, FluidLaw, Force>;
  using Base::all_, Base::seen_, Base::scene_, Base::h_, Base::spacing_;

 public:
  PlainSecondOrder(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings, drift_fields), mean_density_(all_.rho.mean()) {}

 private:
  friend Base;

  void spread_particles() {
    this->for_fluid([&](Index i) {
      move(i, this->time_step() * Vec2(all_.carried[drift_x][i], all_.carried[drift_y][i]));
      for (const Wall& wall : scene_.walls)
        if (const double missing = 0.25 * spacing_ - wall.distance(this->place(i)); missing > 0)
          move(i, missing * wall.normal());
    });
  }
  /// Takes a particle somewhere else in the flow around it [m].
  void move(Index i, const Vec2& way) {
    const auto change = [&](DriftField along_x, DriftField along_y) {
      return way.dot(Vec2(all_.carried[along_x][i], all_.carried[along_y][i]));
    };
    all_.x[i] += way.x(), all_.y[i] += way.y();
    all_.vx[i] += change(vx_along_x, vx_along_y), all_.vy[i] += change(vy_along_x, vy_along_y);
    all_.rho[i] += change(rho_along_x, rho_along_y);
  }
  void correct_density() { all_.rho += mean_density_ - all_.rho.mean(); }

  /// Ghosts on the straight line from the fluid's mean through the velocity at the wall, with what the body force adds
  /// to its pressure on the way.
  void see_extrapolated_ghosts(double time) {
    const auto equal = [](Index) { return 1.0; };
    const auto from = [&](Index g) {
      return *this->mean_at(g, equal, [&](Index j) { return Vec2(seen_[j].x, seen_[j].y); });
    };
    const auto extrapolated = [&](Index g, const Wall& wall, const Vec2& v) -> Vec2 {
      const double away = std::max(wall.distance(from(g)), 0.4 * spacing_);
      const Vec2 at_wall = wall.at_wall(v, time, away);
      return at_wall + wall.distance(this->place(g)) / away * (v - at_wall);
    };
    this->see_ghosts(equal, extrapolated, [&](Index g, const Vec2& x) {
      double p = *this->mean_at(g, equal, [&](Index j) { return seen_[j].p; });
      if constexpr (is_present<Force>) p -= scene_.fluid.density * scene_.body_force(from(g), time).dot(from(g) - x);
      return std::pair(scene_.fluid.density_at(p), p);
    });
  }

  template <bool of_density, bool of_velocity>
  void find(double time) {
    this->see_fluid();
    see_extrapolated_ghosts(time);
    const double c = scene_.fluid.sound_speed(), of_rho = 0.5 * c / spacing_, of_v = std::min(8 * strain_rate_, of_rho);
    this->for_fluid([&](Index i) {
      const auto [v_x, v_y, p, centre] = fits_around(i);
      const double rho = all_.rho[i], per_c2 = 1 / scene_.fluid.pressure_slope(rho);
      const auto slope = [&](const Fit& q) { return Vec2(q[1] / h_, q[2] / h_); };
      const auto second = [&](const Fit& q) -> Mat2 { return Mat2{{2 * q[3], q[4]}, {q[4], 2 * q[5]}} / (h_ * h_); };
      all_.drho[i] = of_rho * per_c2 * p[0] - rho * (slope(v_x).x() + slope(v_y).y());
      Vec2 a = of_v * Vec2(v_x[0], v_y[0]) - slope(p) / rho;
      if constexpr (Viscous<FluidLaw>) {
        const Mat2 of_x = second(v_x), of_y = second(v_y);
        a += scene_.fluid.viscosity / rho *
             (Vec2(of_x.trace(), of_y.trace()) + Vec2(of_x(0, 0) + of_y(0, 1), of_x(0, 1) + of_y(1, 1)) / 3);
      }
      a += this->body_force(i, time);
      all_.ax[i] = a.x(), all_.ay[i] = a.y();
      const auto keep = [&](DriftField along_x, DriftField along_y, const Vec2& what) {
        all_.carried[along_x][i] = what.x(), all_.carried[along_y][i] = what.y();
      };
      keep(drift_x, drift_y, -c * centre / h_);
      keep(vx_along_x, vx_along_y, slope(v_x));
      keep(vy_along_x, vy_along_y, slope(v_y));
      keep(rho_along_x, rho_along_y, per_c2 * slope(p));
    });
    strain_rate_ = 0;
    for (const DriftField slope : {vx_along_x, vx_along_y, vy_along_x, vy_along_y})
      strain_rate_ = std::max(strain_rate_, all_.carried[slope].abs().maxCoeff());
  }

  /// What a fit leaves, then its factors of x, y, x², xy, y² [h].
  using Fit = std::array<double, 6>;
  struct Fits {
    Fit v_x, v_y, p;
    Vec2 centre;  // m  of the neighbours
  };
  /// Best polynomials through what a particle has, weighted by the kernel.
  Fits fits_around(Index i) const {
    std::vector<std::array<double, 9>> rows;  // weight, x, y, x², xy, y², then differences of v_x, v_y, p
    this->sum(i, [&](Index j) {
      const Packed<double>&self = seen_[i], &other = seen_[j];
      const double x = (other.x - self.x) / h_, y = (other.y - self.y) / h_;
      rows.push_back({Kernel::w(std::hypot(x, y)), x, y, x * x, x * y, y * y, other.vx - self.vx, other.vy - self.vy,
                      other.p - self.p});
      return 0;
    });
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 9, Eigen::RowMajor>> all(
        rows.data()->data(), static_cast<Index>(rows.size()), 9);
    const Eigen::ArrayXd weights = all.col(0), roots = weights.sqrt();
    const Eigen::MatrixXd monomials = all.middleCols<5>(1), values = all.rightCols<3>(),
                          factors = (monomials.array().colwise() * roots)
                                        .matrix()
                                        .colPivHouseholderQr()
                                        .solve((values.array().colwise() * roots).matrix());
    const Eigen::Vector3d rest =
        (weights.matrix().transpose() * (values - monomials * factors)).transpose() / weights.sum();
    const auto fit = [&](int k) {
      return Fit{rest[k], factors(0, k), factors(1, k), factors(2, k), factors(3, k), factors(4, k)};
    };
    return {fit(0), fit(1), fit(2),
            h_ * (weights.matrix().transpose() * monomials.leftCols<2>()).transpose() / weights.sum()};
  }

  double mean_density_;     // kg/m³
  double strain_rate_ = 0;  // 1/s  the largest slope of a velocity
};

}  // namespace touchstone::sph
