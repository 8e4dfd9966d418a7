#pragma once
/// The material point method by least squares, for fluid that fills its domain: what the nodes know of the fluid is
/// fitted to the particles (Sulsky & Gong 2016; Wobbes, Tielen, Möller & Vuik, Comput. Part. Mech. 8 (2021), 153-174,
/// fit likewise), the equations of motion are solved by central differences on the nodes, and particles move and
/// change by what they read there.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/mpm/least_squares/fitted_nodes.hpp"
#include "solvers/mpm/simulation.hpp"

namespace touchstone::mpm {

/// Of second order: sums over particles as in the printed method are quadratures, and wrong where particles stand
/// unevenly, however fine the grid; a fit is exact for polynomials of second degree wherever they stand. What sums
/// conserve, mass on the grid and momentum, is conserved to the order of the method only.
///
/// Before the flow has strained the particles' lattice so far that fits would suffer they are put back onto it, with
/// velocities and densities from the fits (remeshing; Cottet & Koumoutsakos, Vortex Methods (2000), chapter 7). They
/// stand for equal parts of the volume that they fill, so the mean of their densities is kept, and with it the mass.
template <class Integrator, class FluidLaw, class Force>
class LeastSquares : public Simulation<FluidLaw, Force> {
  using Base = Simulation<FluidLaw, Force>;
  using Base::grid_, Base::scene_, Base::threads_;

 public:
  using Base::steps, Base::time_step;

  /// Throws std::invalid_argument as its base does, for a spacing of more than half a cell, water that does not fill
  /// the domain, or a wall off the grid.
  LeastSquares(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings),
        lattice_(lattice(scene.filled, settings.spacing, scene.domain.box)),
        seats_(lattice_.places()),
        nodes_(grid_),
        rates_(nodes_.count()),
        divergence_(nodes_.count()) {
    require_filled("mpm", scene.filled, scene.domain.box);
    if ((2 * lattice_.step.array() > grid_.cell.array() * (1 + 1e-9)).any())
      throw std::invalid_argument(fmt::format("mpm: spacing = {:g} m in cells of {:g} m, expected at most half a cell",
                                              lattice_.step.maxCoeff(), grid_.cell.minCoeff()));
    for (const Wall& wall : scene.walls) {
      const int line = grid_.line_of(wall);
      for (int k = 0; k < (wall.axis == 0 ? nodes_.rows : nodes_.columns); ++k)
        at_walls_.push_back(
            {wall.axis == 0 ? nodes_.node_at(line, k) : nodes_.node_at(k, line), &wall - &scene.walls[0]});
    }
    begin();
  }

  /// One step of the integrator, from particles that stand evenly enough. Throws Diverged.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    refuse_strays();
    if (strained_ > most_strain) remesh();
    lap(SubStep::sorting);
    integrator_.step(*this, this->time(), time_step(), lap);
    strained_ += time_step() * strain_rate_;
    all_.rho += mean_density_ - all_.rho.mean();
    lap(SubStep::motion);
    this->tick();
  }

  Index particles() const { return all_.fluid; }
  /// The particles in the order in which they were seeded. Throws Diverged.
  Samples samples() const {
    refuse_strays();
    Samples s{this->time(),
              Vectors(2, all_.fluid),
              Vectors(2, all_.fluid),
              Scalars::Constant(all_.fluid, scene_.fluid.density * lattice_.volume()),
              all_.rho,
              Scalars(all_.fluid)};
    for (Index i = 0; i < all_.fluid; ++i) {
      s.x.col(i) = Vec2(scene_.domain.wrapped(0, all_.x[i]), scene_.domain.wrapped(1, all_.y[i]));
      s.v.col(i) = Vec2(all_.vx[i], all_.vy[i]);
      s.pressure[i] = scene_.fluid.pressure(all_.rho[i]);
    }
    return s;
  }
  Extremes extremes() const { return touchstone::extremes_of(all_); }

 private:
  friend Integrator;
  friend PredictorCorrector;  // starts others

  static constexpr double most_strain = 0.25;    // of the particles' lattice
  static constexpr double damping_of_rho = 0.5;  // of what the fits leave, while sound travels a cell
  static constexpr double damping_of_v =
      4;  // likewise, while the fluid is strained by as much as it is long; no faster

  struct AtWall {
    int node;
    std::ptrdiff_t wall;
  };

  FluidState& state() { return all_; }
  int threads() const { return threads_; }

  /// Sets the particles going as the scene says; those near a wall that jumps into motion feel the jump.
  void begin() {
    all_.fluid = seats_.cols();
    for (Scalars* field : {&all_.x, &all_.y, &all_.vx, &all_.vy, &all_.rho, &all_.ax, &all_.ay, &all_.drho})
      field->setZero(all_.fluid);
    all_.past.assign(Integrator::past_fields, Scalars::Zero(all_.fluid));
    const Vectors places = places_in(scene_.domain.box, scene_.start, lattice_);
    if (places.cols() != all_.fluid)
      throw std::invalid_argument(
          fmt::format("mpm: {} particles to start with, expected the {} of the lattice", places.cols(), all_.fluid));
    for (Index i = 0; i < all_.fluid; ++i) {
      const Vec2 x = places.col(i), v = scene_.start.velocity_at(x);
      all_.x[i] = x.x();
      all_.y[i] = x.y();
      all_.vx[i] = v.x();
      all_.vy[i] = v.y();
      all_.rho[i] = scene_.fluid.density_at(scene_.start.pressure_at(x));
    }
    mean_density_ = all_.rho.mean();
    nodes_.fit(all_, scene_.fluid.density, threads_);
    std::vector<std::array<double, 2>> jump(nodes_.count());
    for (const auto& [node, wall] : at_walls_) {
      const Vec2 v = nodes_.velocity(node), held = scene_.walls[wall].at_wall(v, 0);
      jump[node][0] += held.x() - v.x();
      jump[node][1] += held.y() - v.y();
      nodes_.set_velocity(node, held);
    }
    for (Index i = 0; i < all_.fluid; ++i) {
      const auto felt = nodes_.through_nodes(nodes_.near(all_.x[i], all_.y[i]), [&](int node) { return jump[node]; });
      all_.vx[i] += felt[0];
      all_.vy[i] += felt[1];
    }
  }

  void take_seats() {
    all_.x = seats_.row(0);
    all_.y = seats_.row(1);
    strained_ = 0;
  }

  void fit_and_hold(double time) {
    nodes_.fit(all_, scene_.fluid.density, threads_);
    for (const auto& [node, wall] : at_walls_)
      nodes_.set_velocity(node, scene_.walls[wall].at_wall(nodes_.velocity(node), time));
  }

  void remesh() {
    fit_and_hold(this->time());
    take_seats();
    share_out_fields(threads_, all_.fluid, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i) {
        const auto fitted = nodes_.joined(nodes_.near(all_.x[i], all_.y[i]));
        all_.vx[i] = fitted[FittedNodes::v_x];
        all_.vy[i] = fitted[FittedNodes::v_y];
        all_.rho[i] = scene_.fluid.density + fitted[FittedNodes::excess];
      }
    });
    integrator_ = Integrator{};  // past rates were of other places
  }

  template <class Laps>
  void find_rates(double time, const Laps& lap) {
    fit_and_hold(time);
    lap(SubStep::scatter);
    find_rates_of_nodes(time);
    lap(SubStep::grid);
    read_rates();
    lap(SubStep::gather);
  }

  /// A field of the nodes along an axis from one of them, and on which sides of it there are nodes.
  template <class Value>
  struct Along {
    const FittedNodes& nodes;
    const Value& value;
    int column, row, axis;
    bool before = axis == 0 ? nodes.has_column(column - 1) : nodes.has_row(row - 1),
         beyond = axis == 0 ? nodes.has_column(column + 1) : nodes.has_row(row + 1);

    double operator()(int step) const {
      return value(axis == 0 ? nodes.node_at(column + step, row) : nodes.node_at(column, row + step));
    }
  };
  /// Differences along an axis [per cell], central inside, to one side at a wall.
  template <class Value>
  double slope(const Value& value, int column, int row, int axis) const {
    const Along<Value> at{nodes_, value, column, row, axis};
    if (at.before && at.beyond) return (at(1) - at(-1)) / 2;
    const int in = at.before ? -1 : 1;
    return in * (4 * at(in) - at(2 * in) - 3 * at(0)) / 2;
  }
  /// Second differences along an axis [per cell²]; a field is mirrored at a wall: nothing drags along it.
  template <class Value>
  double curvature(const Value& value, int column, int row, int axis) const {
    const Along<Value> at{nodes_, value, column, row, axis};
    return at(at.beyond ? 1 : -1) + at(at.before ? -1 : 1) - 2 * at(0);
  }

  template <class Work>
  void for_nodes(const Work& work) const {
    share_out(threads_, nodes_.rows, [&](Index begin, Index end) {
      for (int row = static_cast<int>(begin); row < end; ++row)
        for (int column = 0; column < nodes_.columns; ++column) work(column, row);
    });
  }

  /// Acceleration and divergence of the velocity on the nodes.
  void find_rates_of_nodes(double time) {
    const Vec2 per_cell = grid_.cell.cwiseInverse();
    const auto value = [&](FittedNodes::Field field) {
      return [this, field](int node) { return nodes_.fit(node)[field][0]; };
    };
    const auto pressure = [&](int node) {
      return scene_.fluid.pressure(scene_.fluid.density + nodes_.fit(node)[FittedNodes::excess][0]);
    };
    for_nodes([&](int column, int row) {
      divergence_[nodes_.node_at(column, row)] = per_cell.x() * slope(value(FittedNodes::v_x), column, row, 0) +
                                                 per_cell.y() * slope(value(FittedNodes::v_y), column, row, 1);
    });
    for_nodes([&](int column, int row) {
      const int node = nodes_.node_at(column, row);
      const double rho = scene_.fluid.density + nodes_.fit(node)[FittedNodes::excess][0];
      std::array<double, 3> rate{0, 0, divergence_[node]};
      for (const int axis : {0, 1}) {
        rate[axis] = -per_cell[axis] * slope(pressure, column, row, axis) / rho;
        if constexpr (Viscous<FluidLaw>) {
          const auto v = value(axis == 0 ? FittedNodes::v_x : FittedNodes::v_y);
          rate[axis] += scene_.fluid.viscosity / rho *
                        (per_cell.x() * per_cell.x() * curvature(v, column, row, 0) +
                         per_cell.y() * per_cell.y() * curvature(v, column, row, 1) +
                         per_cell[axis] / 3 * slope([&](int at) { return divergence_[at]; }, column, row, axis));
        }
      }
      if constexpr (is_present<Force>) {
        const Vec2 force = scene_.body_force(grid_.box.low + grid_.cell.cwiseProduct(Vec2(column, row)), time);
        rate[0] += force.x();
        rate[1] += force.y();
      }
      rates_[node] = rate;
    });
    const double dt = time_step();
    for (const auto& [node, wall] : at_walls_) {  // moves as the wall lets it
      const Vec2 v = nodes_.velocity(node), a(rates_[node][0], rates_[node][1]);
      const Vec2 held = (scene_.walls[wall].at_wall(v + dt * a, time + dt) - scene_.walls[wall].at_wall(v, time)) / dt;
      rates_[node][0] = held.x();
      rates_[node][1] = held.y();
    }
    note_strain();
  }

  /// The fastest strain of any node.
  void note_strain() {
    double fastest = 0;
    for (int node = 0; node < nodes_.count(); ++node)
      for (const FittedNodes::Field field : {FittedNodes::v_x, FittedNodes::v_y})
        for (const int axis : {0, 1})
          fastest = std::max(fastest, std::abs(nodes_.fit(node)[field][1 + axis]) / grid_.cell[axis]);
    strain_rate_ = fastest;
  }

  void read_rates() {
    const double of_rho = damping_of_rho * scene_.fluid.sound_speed() / grid_.cell.minCoeff(),
                 of_v = std::min(damping_of_v * strain_rate_, of_rho);
    share_out_fields(threads_, all_.fluid, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i) {
        const NearNode at = nodes_.near(all_.x[i], all_.y[i]);
        const auto rates = nodes_.through_nodes(at, [&](int node) { return rates_[node]; });
        const auto fitted = nodes_.joined(at);
        all_.ax[i] = rates[0] - of_v * (all_.vx[i] - fitted[FittedNodes::v_x]);
        all_.ay[i] = rates[1] - of_v * (all_.vy[i] - fitted[FittedNodes::v_y]);
        all_.drho[i] =
            -all_.rho[i] * rates[2] - of_rho * (all_.rho[i] - scene_.fluid.density - fitted[FittedNodes::excess]);
      }
    });
  }

  /// Throws Diverged if a particle is half a cell outside, or nowhere.
  void refuse_strays() const {
    for (Index i = 0; i < all_.fluid; ++i) {
      const Vec2 x(all_.x[i], all_.y[i]);
      for (const int axis : {0, 1}) {
        const double slack = grid_.cell[axis] / 2;
        const bool inside = scene_.domain.periodic(axis)
                                ? std::isfinite(x[axis])
                                : x[axis] > grid_.box.low[axis] - slack && x[axis] < grid_.box.high[axis] + slack;
        if (!inside)
          throw Diverged({steps(), this->time(), i, x, axis == 0 ? "x [m]" : "y [m]", x[axis], "inside the domain"});
      }
    }
  }

  Lattice lattice_;
  Vectors seats_;  // m  of the particles on their lattice
  FittedNodes nodes_;
  std::vector<std::array<double, 3>> rates_;  // m/s², m/s², 1/s  acceleration, divergence
  std::vector<double> divergence_;            // 1/s
  std::vector<AtWall> at_walls_;
  FluidState all_;
  Integrator integrator_;
  double mean_density_ = 0;                // kg/m³
  double strain_rate_ = 0, strained_ = 0;  // 1/s, -  of the lattice since it was laid out
};

/// A simulation of a scene: `mpm::least_squares(channel, {.cell = ..., .spacing = half a cell, ...})`.
template <class Integrator = AdamsBashforth, class FluidLaw, class Force>
auto least_squares(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return LeastSquares<Integrator, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
