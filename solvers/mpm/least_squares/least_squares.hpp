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
        cells_(grid_.around_nodes()),
        nodes_(cells_, settings.threads),
        pressure_(nodes_.places()),
        divergence_(nodes_.places()),
        acceleration_(nodes_.places()) {
    require_filled("mpm", scene.filled, scene.domain.box);
    if ((2 * lattice_.step.array() > grid_.cell.array() * (1 + 1e-9)).any())
      throw std::invalid_argument(fmt::format("mpm: spacing = {:g} m in cells of {:g} m, expected at most half a cell",
                                              lattice_.step.maxCoeff(), grid_.cell.minCoeff()));
    for (const Wall& wall : scene.walls) {
      const int line = grid_.line_of(wall);
      for (int k = 0; k < (wall.axis == 0 ? cells_.rows : cells_.columns); ++k)
        at_walls_.push_back(
            {wall.axis == 0 ? nodes_.node_at(line % cells_.columns, k) : nodes_.node_at(k, line % cells_.rows),
             &wall - &scene.walls[0]});
    }
    begin();
  }

  /// One step of the integrator, from particles that stand evenly enough. Throws Diverged.
  void step(const Laps& lap = no_laps) {
    if (strained_ > most_strain) remesh();
    lap(SubStep::sorting);
    integrator_.step(*this, this->time(), time_step(), lap);
    strained_ += time_step() * strain_rate_;
    keep_mean_density();
    lap(SubStep::motion);
    this->tick();
  }

  Index particles() const { return seats_.cols(); }
  /// The particles in the order in which they were seeded. Throws Diverged.
  Samples samples() const {
    Samples s = Samples::of_equal(this->time(), particles(), scene_.fluid.density * lattice_.volume());
    all_.order.for_each([&](int, int slot) {
      for (const int axis : {0, 1})
        if (!is_inside(slot, axis)) refuse(slot, axis);
      const int p = all_.number[slot];
      s.x.col(p) = Vec2(scene_.domain.wrapped(0, all_.x[slot]), scene_.domain.wrapped(1, all_.y[slot]));
      s.v.col(p) = Vec2(all_.vx[slot], all_.vy[slot]);
      s.density[p] = all_.rho[slot];
      s.pressure[p] = scene_.fluid.pressure(s.density[p]);
    });
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
    all_.past.assign(Integrator::past_fields, {});
    const Vectors places = places_in(scene_.domain.box, scene_.start, lattice_);
    if (places.cols() != particles())
      throw std::invalid_argument(
          fmt::format("mpm: {} particles to start with, expected the {} of the lattice", places.cols(), particles()));
    all_.lay_out(places, cells_);
    all_.order.for_each([&](int, int slot) {
      const Vec2 x(all_.x[slot], all_.y[slot]), v = scene_.start.velocity_at(x);
      all_.vx[slot] = v.x();
      all_.vy[slot] = v.y();
      all_.rho[slot] = scene_.fluid.density_at(scene_.start.pressure_at(x));
    });
    mean_density_ = all_.rho.sum() / static_cast<double>(particles());
    keep_order();
    nodes_.fit_to(all_, scene_.fluid.density);
    NodeVectors& jump = acceleration_;
    for (const auto& [node, wall] : at_walls_) {
      const Vec2 v = nodes_.velocity(node), held = scene_.walls[wall].at_wall(v, 0);
      jump.set(node, jump[node] + held - v);
      nodes_.set_velocity(node, held);
    }
    for (auto [field, change] : {std::pair(&all_.vx, &jump.x), std::pair(&all_.vy, &jump.y)}) {
      nodes_.extend(*change, parabola);
      for_blocks(all_, nodes_, threads_, [&, v = field, of_nodes = change](Index, const auto& block, int node) {
        const PowersOfBoth felt = nodes_.parabolas(*of_nodes, node);
        for_particles_of(block, [&](int slot, const auto& write) {
          write(load<Lanes>(&(*v)[slot]) + value_at(felt, all_.place(0, slot), all_.place(1, slot)), &(*v)[slot]);
        });
      });
    }
  }

  /// Finds the places within cells, and carries the particles that have left theirs. Throws Diverged.
  void keep_order() {
    const Vec2 per_cell = grid_.cell.cwiseInverse(), low = grid_.box.low;
    for_blocks(all_, nodes_, threads_, calm_, [&](const auto& block, int) {
      Lanes column;
      for (int lane = 0; lane < lanes; ++lane) column[lane] = block.column + lane;
      auto is_calm = calm_so_far;
      for_particles_of(block, [&](int slot, const auto& write) {
        const Lanes X = write((load<Lanes>(&all_.x[slot]) - low.x()) * per_cell.x() - column, &all_.X[slot]),
                    Y = write((load<Lanes>(&all_.y[slot]) - low.y()) * per_cell.y() - block.row, &all_.Y[slot]);
        is_calm &= between(-0.5, X, 0.5) & between(-0.5, Y, 0.5);
      });
      return is_calm;
    });
    mpm::keep_order(all_, calm_, [&](int slot, int cell) { return settle(slot, cell); });
    all_.fluid = all_.order.slots();
  }

  /// The cell that a particle is in now. Throws Diverged.
  int settle(int slot, int cell) {
    const auto along = [&](int axis, int at, int cells, bool periodic, Scalars& x, Scalars& start, double& X) {
      double within = X + 0.5;
      const int to = cell_along(within, at, cells, periodic);
      if (to < 0) refuse(slot, axis);
      const double across = std::round(within - 0.5 - X + (to - at)) * grid_.cell[axis];  // a periodic boundary
      x[slot] += across;
      start[slot] += across;
      X = within - 0.5;
      return to;
    };
    const int column = along(0, cell % cells_.columns, cells_.columns, cells_.periodic_x, all_.x, all_.start.x,
                             all_.X[slot]),
              row = along(1, cell / cells_.columns, cells_.rows, cells_.periodic_y, all_.y, all_.start.y, all_.Y[slot]);
    return cells_.cell_at(column, row);
  }

  void fit_and_hold(double time) {
    nodes_.fit_to(all_, scene_.fluid.density);
    for (const auto& [node, wall] : at_walls_)
      nodes_.set_velocity(node, scene_.walls[wall].at_wall(nodes_.velocity(node), time));
    for (auto& polynomial : nodes_.fit)
      for (auto& factor : polynomial) nodes_.extend(factor, mirrored);
  }

  void remesh() {
    keep_order();
    fit_and_hold(this->time());
    all_.lay_out(seats_, cells_);
    keep_order();
    for_fitted([&](int) {
      return [&](int slot, const auto& write, const Monomials&, const Monomials&, const auto& fitted) {
        write(fitted[FittedNodes::v_x], &all_.vx[slot]);
        write(fitted[FittedNodes::v_y], &all_.vy[slot]);
        write(scene_.fluid.density + fitted[FittedNodes::excess], &all_.rho[slot]);
      };
    });
    strained_ = 0;
    integrator_ = Integrator{};  // past rates were of other places
  }

  void find_rates(double time, const Laps& lap) {
    keep_order();
    lap(SubStep::sorting);
    fit_and_hold(time);
    lap(SubStep::scatter);
    find_rates_of_nodes(time);
    lap(SubStep::grid);
    read_rates();
    lap(SubStep::gather);
  }

  // Ghosts past an edge that is not periodic.
  static double parabola(double first, double second, double third) { return 3 * (first - second) + third; }
  static double mirrored(double, double second, double) { return second; }

  /// Differences along an axis [per cell], central; to one side at a wall, by the parabola's ghosts.
  Lanes slope(const Field<double>& field, int node, int axis) const {
    const int next = axis == 0 ? 1 : nodes_.stride;
    return (load<Lanes>(&field[node + next]) - load<Lanes>(&field[node - next])) / 2.0;
  }
  /// Second differences along an axis [per cell²]; a field is mirrored at a wall: nothing drags along it.
  Lanes curvature(const Field<double>& field, int node, int axis) const {
    const int next = axis == 0 ? 1 : nodes_.stride;
    return load<Lanes>(&field[node + next]) + load<Lanes>(&field[node - next]) - 2.0 * load<Lanes>(&field[node]);
  }

  /// Acceleration and divergence of the velocity on the nodes.
  void find_rates_of_nodes(double time) {
    const Vec2 per_cell = grid_.cell.cwiseInverse();
    Field<double>&vx = nodes_.fit[FittedNodes::v_x][0], &vy = nodes_.fit[FittedNodes::v_y][0];
    const auto rho_at = [&](int node) -> Lanes {
      return scene_.fluid.density + load<Lanes>(&nodes_.fit[FittedNodes::excess][0][node]);
    };
    for (Field<double>* v : {&vx, &vy}) nodes_.extend(*v, parabola);
    nodes_.for_nodes([&](int node, int, int) {
      store(scene_.fluid.pressure(rho_at(node)), &pressure_[node]);
      store(per_cell.x() * slope(vx, node, 0) + per_cell.y() * slope(vy, node, 1), &divergence_[node]);
    });
    for (Field<double>* field : {&pressure_, &divergence_}) nodes_.extend(*field, parabola);
    for (Field<double>* v : {&vx, &vy}) nodes_.extend(*v, mirrored);
    nodes_.for_nodes([&](int node, int column, int row) {
      const Lanes per_rho = 1 / rho_at(node);
      for (const int axis : {0, 1}) {
        Lanes rate = -per_cell[axis] * slope(pressure_, node, axis) * per_rho;
        if constexpr (Viscous<FluidLaw>) {
          const Field<double>& v = axis == 0 ? vx : vy;
          rate += scene_.fluid.viscosity * per_rho *
                  (per_cell.x() * per_cell.x() * curvature(v, node, 0) +
                   per_cell.y() * per_cell.y() * curvature(v, node, 1) +
                   per_cell[axis] / 3 * slope(divergence_, node, axis));
        }
        store(rate, &(axis == 0 ? acceleration_.x : acceleration_.y)[node]);
      }
      if constexpr (is_present<Force>)
        for (int lane = 0; lane < lanes && column + lane < cells_.columns; ++lane) {
          const Vec2 x = grid_.box.low + grid_.cell.cwiseProduct(Vec2(column + lane, row));
          acceleration_.set(node + lane, acceleration_[node + lane] + scene_.body_force(x, time));
        }
    });
    const double dt = time_step();
    for (const auto& [node, wall] : at_walls_) {  // moves as the wall lets it
      const Vec2 v = nodes_.velocity(node), a = acceleration_[node];
      acceleration_.set(node,
                        (scene_.walls[wall].at_wall(v + dt * a, time + dt) - scene_.walls[wall].at_wall(v, time)) / dt);
    }
    for (Field<double>* field : {&acceleration_.x, &acceleration_.y}) nodes_.extend(*field, parabola);
    note_strain();
  }

  /// The fastest strain of any node.
  void note_strain() {
    double fastest = 0;
    for (const FittedNodes::FittedField field : {FittedNodes::v_x, FittedNodes::v_y})
      for (const int axis : {0, 1})
        for (int row = 0; row < cells_.rows; ++row)
          fastest = std::max(
              fastest, Eigen::Map<const Scalars>(&nodes_.fit[field][1 + axis][nodes_.node_at(0, row)], cells_.columns)
                               .abs()
                               .maxCoeff() /
                           grid_.cell[axis]);
    strain_rate_ = fastest;
  }

  void read_rates() {
    const double of_rho = damping_of_rho * scene_.fluid.sound_speed() / grid_.cell.minCoeff(),
                 of_v = std::min(damping_of_v * strain_rate_, of_rho), rho0 = scene_.fluid.density;
    for_fitted([&](int node) {
      return [&, ax = nodes_.parabolas(acceleration_.x, node), ay = nodes_.parabolas(acceleration_.y, node),
              divergence = nodes_.parabolas(divergence_, node)](int slot, const auto& write, const Monomials& X,
                                                                const Monomials& Y, const auto& fitted) {
        const Lanes rho = load<Lanes>(&all_.rho[slot]);
        write(value_at(ax, X, Y) - of_v * (load<Lanes>(&all_.vx[slot]) - fitted[FittedNodes::v_x]), &all_.ax[slot]);
        write(value_at(ay, X, Y) - of_v * (load<Lanes>(&all_.vy[slot]) - fitted[FittedNodes::v_y]), &all_.ay[slot]);
        write(-rho * value_at(divergence, X, Y) - of_rho * (rho - rho0 - fitted[FittedNodes::excess]),
              &all_.drho[slot]);
      };
    });
  }

  /// Calls what of_block(first node) returns, (slot, write, X, Y, fitted), for all particles of a block.
  template <class OfBlock>
  void for_fitted(const OfBlock& of_block) const {
    for_blocks(
        all_, nodes_, threads_, [&](Index, const auto& block, int node) __attribute__((flatten)) {
          const FittedNodes::Around fits = nodes_.around(node);
          const auto work = of_block(node);
          for_particles_of(block, [&](int slot, const auto& write) {
            const Monomials X = all_.place(0, slot), Y = all_.place(1, slot);
            const HatsAlong x = nodes_.hats_at(0, block.column, X.X), y = nodes_.hats_at(1, block.row, Y.X);
            work(slot, write, X, Y, std::array{joined(fits[0], x, y), joined(fits[1], x, y), joined(fits[2], x, y)});
          });
        });
  }

  void keep_mean_density() {
    const double gap = mean_density_ - all_.rho.sum() / static_cast<double>(particles());
    for (Index slot = 0; slot + lanes <= all_.fluid; slot += lanes) {
      const Lanes rho = load<Lanes>(&all_.rho[slot]);
      store(rho > Lanes{} ? rho + gap : rho, &all_.rho[slot]);
    }
  }

  bool is_inside(int slot, int axis) const {
    const double x = axis == 0 ? all_.x[slot] : all_.y[slot];
    if (scene_.domain.periodic(axis)) return std::isfinite(x);
    return x > cells_.box.low[axis] && x < cells_.box.high[axis];  // or half a cell outside
  }
  [[noreturn]] void refuse(int slot, int axis) const {
    const Vec2 x(all_.x[slot], all_.y[slot]);
    throw Diverged(
        {steps(), this->time(), all_.number[slot], x, axis == 0 ? "x [m]" : "y [m]", x[axis], "inside the domain"});
  }

  Lattice lattice_;
  Vectors seats_;  // m  of the particles on their lattice
  Grid cells_;     // of the particles, a node in the middle of each
  FittedNodes nodes_;
  Field<double> pressure_, divergence_;  // Pa, 1/s
  NodeVectors acceleration_;             // m/s²
  std::vector<AtWall> at_walls_;
  FittedParticles all_;
  std::vector<LaneBits> calm_;
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
