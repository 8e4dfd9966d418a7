#pragma once
/// The whole material point method in plain loops over particles and nodes, made of parts chosen by type. Read here
/// what a shape, a transfer or a density does; the fast methods are compared with it, in their results and their speed.

#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/parts.hpp"
#include "solvers/mpm/shapes/along_axis.hpp"
#include "solvers/mpm/simulation.hpp"
#include "solvers/mpm/sorting.hpp"
#include "solvers/mpm/walls/contact.hpp"
#include "solvers/mpm/walls/held_nodes.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"

namespace touchstone::mpm {

/// What ties a particle to a node.
struct Tie {
  int node;
  double weight;      // -
  Vec2 slope;         // 1/m  of the weight
  Vec2 affine_slope;  // 1/m  by how much the node tells in the affine velocity
  Vec2 arm;           // m    from the particle to the node
};

/// The nodes of a grid as a shape has them.
template <class Shape>
class PlainNodes {
 public:
  Scalars mass;       // particles
  Vectors force;      // m/s²  per mass of a particle
  Vectors start;      // m/s   velocity that the particles gave
  Vectors velocity;   // m/s   with which the nodes move, or by which the fluid is strained
  Vectors change;     // m/s   of velocity over the step, as particles feel it
  Scalars expansion;  // -     that particles gave, of affine densities

  /// For square particles of a side [m] along each axis.
  PlainNodes(const Grid& grid, const Vec2& side)
      : grid_(grid),
        along_{AlongAxis<Shape>(GridAxis{grid.columns, grid.periodic_x, side.x() / grid.cell.x() / 2}),
               AlongAxis<Shape>(GridAxis{grid.rows, grid.periodic_y, side.y() / grid.cell.y() / 2})} {}

  int columns() const { return along_[0].nodes(); }
  int rows() const { return along_[1].nodes(); }
  int count() const { return columns() * rows(); }
  Vec2 place(int node) const {  // m
    const Vec2 cells(along_[0].place(node % columns()), along_[1].place(node / columns()));
    return grid_.box.low + grid_.cell.cwiseProduct(cells);
  }
  /// A mass below this is the rounding error of a particle on the edge of its cell; such a node is left out.
  static constexpr double least_mass = 1e-12;  // particles
  bool moves(int node) const { return mass[node] > least_mass; }

  /// The nodes that alone carry what is at a wall. Throws std::invalid_argument if there are none, or for a wall off
  /// the grid.
  std::vector<int> on(const Wall& wall) const {
    const int line = node_alone_at(grid_.line_of(wall), along_[wall.axis], wall);
    std::vector<int> found;
    for (int node = 0; node < count(); ++node)
      if ((wall.axis == 0 ? node % columns() : node / columns()) == line) found.push_back(node);
    return found;
  }

  using Ties = std::array<Tie, AlongAxis<Shape>::width * AlongAxis<Shape>::width>;
  /// To every node near a place [m].
  Ties near(const Vec2& at) const {
    const Vec2 along = (at - grid_.box.low).cwiseQuotient(grid_.cell), per_cell = grid_.cell.cwiseInverse();
    const auto x = along_[0].near(along.x()), y = along_[1].near(along.y());
    const auto affine_x = affine_slopes_of(x), affine_y = affine_slopes_of(y);
    Ties ties;
    for (int b = 0; b < y.width; ++b)
      for (int a = 0; a < x.width; ++a)
        ties[b * x.width + a] = {
            .node = wrapped(y.first + b, rows()) * columns() + wrapped(x.first + a, columns()),
            .weight = x.weight[a] * y.weight[b],
            .slope = per_cell.cwiseProduct(Vec2(x.slope[a] * y.weight[b], x.weight[a] * y.slope[b])),
            .affine_slope = per_cell.cwiseProduct(Vec2(affine_x[a] * y.weight[b], x.weight[a] * affine_y[b])),
            .arm = grid_.cell.cwiseProduct(Vec2(x.arm[a], y.arm[b]))};
    return ties;
  }

 private:
  static int wrapped(int k, int count) { return (k % count + count) % count; }

  Grid grid_;
  std::array<AlongAxis<Shape>, 2> along_;
};

/// All particles, in the order of their numbers.
struct PlainParticles {
  double mass;               // kg/m  of each
  Vectors x;                 // m
  Vectors v;                 // m/s
  Scalars expansion;         // -     rho0 / rho - 1
  std::vector<Mat2> slopes;  // 1/s   of the velocity, when last strained
  std::vector<Mat2> affine;  // 1/s   C, of APIC
  Vectors gradient;          // 1/m   of the expansion, of affine densities

  Index count() const { return x.cols(); }
};

/// Pressure [Pa] by Tait's law (33) from the expansion rho0 / rho - 1, with all digits of a small one.
inline double pressure_of_expansion(const Tait& fluid, double expansion) {
  return fluid.bulk_modulus * std::expm1(-Tait::gamma * std::log1p(expansion));
}

/// 2 mu eps - (2/3) mu tr(eps) I - P I over the density [m²/s²], as much of it as the fluid has: (32), (33).
template <class FluidLaw>
Mat2 stress_per_density(const FluidLaw& fluid, double expansion, const Mat2& slopes) {
  Mat2 stress = -pressure_of_expansion(fluid, expansion) * Mat2::Identity();
  if constexpr (Viscous<FluidLaw>)
    stress += fluid.viscosity * (slopes + slopes.transpose() - 2.0 / 3 * slopes.trace() * Mat2::Identity());
  return (1 + expansion) / fluid.density * stress;
}

/// One simulation of a scene. `Shape` ties particles to nodes, `Transfer` says what velocities they give and take, and
/// `Density` how that follows the flow. Walls prescribe the motion of their nodes. Explicit Euler, lumped mass, on one
/// thread.
template <class Shape, class Transfer, class Density, class FluidLaw, class Force>
class Plain : public Simulation<FluidLaw, Force> {
  using Base = Simulation<FluidLaw, Force>;

 public:
  using Base::steps, Base::time, Base::time_step;

  /// Throws std::invalid_argument as its base does, for a spacing larger than the filled box, fluid outside the domain,
  /// or a wall where the shape has no node of its own.
  Plain(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings),
        lattice_(lattice(scene.filled, settings.spacing, scene.domain.box)),
        nodes_(grid_, lattice_.step),
        contact_(scene.walls, grid_) {
    for (std::size_t wall = 0; wall < scene.walls.size(); ++wall)
      for (int node : nodes_.on(scene.walls[wall]))
        held_.push_back({node, wall, scene.start.velocity_at(nodes_.place(node))});
    std::stable_sort(held_.begin(), held_.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
    begin();
  }

  /// One step, in which the stress is found last, by velocities that the particles give to the nodes anew (MUSL;
  /// Sulsky, Zhou & Schreyer 1995): nodes of little mass, at a free surface, strain less. Throws Diverged.
  void step(const Laps& lap = no_laps) {
    scatter();  // m_i, (m v)_i, (12), (13)
    lap(SubStep::scatter);
    accelerate();  // (10), (11), (14), as walls have it
    lap(SubStep::grid);
    move();  // (15), (16)
    lap(SubStep::gather);
    remap();  // (17), as walls have it
    lap(SubStep::remap);
    strain();  // (18), (19)
    lap(SubStep::gather);
    this->tick();
    settle();
    lap(SubStep::sorting);
  }

  Index particles() const { return particles_.count(); }
  /// The particles in the order in which they were seeded.
  Samples samples() const {
    Samples s{time(),
              particles_.x,
              particles_.v,
              Scalars::Constant(particles_.count(), particles_.mass),
              scene_.fluid.density / (1 + particles_.expansion),
              Scalars(particles_.count())};
    for (Index p = 0; p < s.size(); ++p) s.pressure[p] = pressure_of_expansion(scene_.fluid, particles_.expansion[p]);
    return s;
  }
  Extremes extremes() const {
    return {std::sqrt(particles_.v.colwise().squaredNorm().maxCoeff()),
            scene_.fluid.density / (1 + particles_.expansion.minCoeff())};
  }

 protected:
  using Base::grid_, Base::scene_;

  /// Calls work(p, tie) for every particle and every node that it was near when the step began.
  template <class Work>
  void for_ties(const Work& work) const {
    for (Index p = 0; p < particles_.count(); ++p)
      for (const Tie& tie : ties_[p]) work(p, tie);
  }
  /// A field of the nodes at a particle.
  Vec2 at(Index p, const Vectors& field) const {
    Vec2 sum = Vec2::Zero();
    for (const Tie& tie : ties_[p]) sum += tie.weight * field.col(tie.node);
    return sum;
  }

  void scatter() {
    for (Index p = 0; p < particles_.count(); ++p) ties_[p] = nodes_.near(particles_.x.col(p));
    nodes_.mass.setZero(nodes_.count());
    for_ties([&](Index, const Tie& tie) { nodes_.mass[tie.node] += tie.weight; });
    scatter_velocity(given(), nodes_.start);
    scatter_forces();
  }
  /// v_i = sum m_p w_ip v_ip / m_i with `given(p, arm)` [m/s] for v_ip; zero where there is no mass.
  template <class Given>
  void scatter_velocity(const Given& given, Vectors& velocity) const {
    velocity.setZero(2, nodes_.count());
    for_ties([&](Index p, const Tie& tie) {
      if (nodes_.moves(tie.node)) velocity.col(tie.node) += tie.weight / nodes_.mass[tie.node] * given(p, tie.arm);
    });
  }
  auto given() const {
    return [this](Index p, const Vec2& arm) -> Vec2 {
      if constexpr (std::same_as<Transfer, Apic>) return particles_.v.col(p) + particles_.affine[p] * arm;
      return particles_.v.col(p);
    };
  }
  void scatter_forces() {
    nodes_.force.setZero(2, nodes_.count());
    for (Index p = 0; p < particles_.count(); ++p) {
      const Mat2 stress = stress_per_density(scene_.fluid, particles_.expansion[p], particles_.slopes[p]);
      Vec2 of_body = Vec2::Zero();
      if constexpr (is_present<Force>) of_body = scene_.body_force(particles_.x.col(p), time());
      for (const Tie& tie : ties_[p]) nodes_.force.col(tie.node) += tie.weight * of_body - stress * tie.slope;
    }
  }

  void accelerate() {
    nodes_.change.setZero(2, nodes_.count());
    for (int node = 0; node < nodes_.count(); ++node)
      if (nodes_.moves(node)) nodes_.change.col(node) = time_step() / nodes_.mass[node] * nodes_.force.col(node);
    nodes_.velocity = nodes_.start + nodes_.change;
    hold_motion();
  }
  /// Has the motion of each wall node follow its walls, in the order of the scene.
  void hold_motion() {
    const auto motion = [&](const HeldNode& held) -> NodeAtWall {
      return {nodes_.start.col(held.node),
              nodes_.velocity.col(held.node),
              time(),
              time() + time_step(),
              steps() == 0,
              held.of_scene};
    };
    mpm::hold_motion(held_, scene_.walls, &PrescribedMotion::hold, motion, [&](int node, const NodeAtWall& at_wall) {
      if (!nodes_.moves(node)) return;
      nodes_.velocity.col(node) = at_wall.after;
      nodes_.change.col(node) = at_wall.after - at_wall.before;
    });
  }

  void move() {
    take(Transfer{});
    for (Index p = 0; p < particles_.count(); ++p) particles_.x.col(p) += time_step() * at(p, nodes_.velocity);
  }
  void take(Flip) {
    for (Index p = 0; p < particles_.count(); ++p) particles_.v.col(p) += at(p, nodes_.change);
  }
  void take(Apic) {
    take_velocity(nodes_.velocity, particles_.v);
    particles_.affine.assign(particles_.count(), Mat2::Zero());
    for_ties([&](Index p, const Tie& tie) {
      particles_.affine[p] += nodes_.velocity.col(tie.node) * tie.affine_slope.transpose();
    });
  }
  template <int m>
  void take(Xpic<m>) {
    Vectors smoothed = nodes_.velocity - nodes_.change;  // (S⁺ S)^(k - 1) v_i, in the term k
    Vectors velocity = nodes_.velocity + (m - 1) * smoothed, on_particles(2, particles_.count());
    double binomial = m;  // m over k, with the sign of the term
    for (int k = 2; k <= m; ++k) {
      take_velocity(smoothed, on_particles);
      scatter_velocity([&](Index p, const Vec2&) -> Vec2 { return on_particles.col(p); }, smoothed);
      binomial *= -static_cast<double>(m - k + 1) / k;
      velocity += binomial * smoothed;
    }
    take_velocity(velocity, particles_.v);
  }
  void take_velocity(const Vectors& from, Vectors& to) const {
    for (Index p = 0; p < particles_.count(); ++p) to.col(p) = at(p, from);
  }

  void remap() {
    scatter_velocity(given(), nodes_.velocity);
    for (const HeldNode& held : held_)
      if (nodes_.moves(held.node))
        nodes_.velocity.col(held.node) =
            scene_.walls[held.wall].at_wall(nodes_.velocity.col(held.node), time() + time_step());
  }

  void strain() {
    particles_.slopes.assign(particles_.count(), Mat2::Zero());
    for_ties([&](Index p, const Tie& tie) {
      particles_.slopes[p] += nodes_.velocity.col(tie.node) * tie.slope.transpose();
    });
    for (Index p = 0; p < particles_.count(); ++p)
      particles_.expansion[p] += (1 + particles_.expansion[p]) * (time_step() * particles_.slopes[p].trace());
    if constexpr (std::derived_from<Density, AffineDensity>) take_densities_over_nodes();
  }
  void take_densities_over_nodes() {
    nodes_.expansion.setZero(nodes_.count());
    for_ties([&](Index p, const Tie& tie) {
      const double given = particles_.expansion[p] + particles_.gradient.col(p).dot(tie.arm);
      if (nodes_.moves(tie.node)) nodes_.expansion[tie.node] += tie.weight / nodes_.mass[tie.node] * given;
    });
    if (has_room(particles_.mass * static_cast<double>(particles_.count()), scene_))
      nodes_.expansion = nodes_.expansion.min(Density::most_expansion);
    particles_.expansion.setZero();
    particles_.gradient.setZero();
    for_ties([&](Index p, const Tie& tie) {
      particles_.expansion[p] += tie.weight * nodes_.expansion[tie.node];
      particles_.gradient.col(p) += tie.affine_slope * nodes_.expansion[tie.node];
    });
  }

  /// Holds particles at walls and takes them back across periodic boundaries. Throws Diverged for one that has left the
  /// domain or has no plausible density.
  void settle() {
    for (Index p = 0; p < particles_.count(); ++p) {
      contact_.meet(particles_.mass, particles_.x.col(p), [&](const Wall& wall) -> double& {
        particles_.x(wall.axis, p) = wall.position;
        return particles_.v(wall.axis, p);
      });
      const Vec2 place = particles_.x.col(p);
      const auto refuse = [&](std::string quantity, double value, double low, double high) {
        if (low <= value && value <= high) return;
        throw Diverged({steps(), time(), p, place, std::move(quantity), value, fmt::format("{:g} to {:g}", low, high)});
      };
      for (const int axis : {0, 1}) {
        const double low = grid_.box.low[axis], high = grid_.box.high[axis];
        const double slack = scene_.domain.periodic(axis) ? high - low : 0;  // further in a step is no flow
        refuse(axis == 0 ? "x [m]" : "y [m]", place[axis], low - slack, high + slack);
        particles_.x(axis, p) = scene_.domain.wrapped(axis, place[axis]);
      }
      const double at_rest = scene_.fluid.density;
      refuse("density [kg/m³]", at_rest / (1 + particles_.expansion[p]), least_density * at_rest,
             most_density * at_rest);
    }
  }

  void begin() {
    const Vectors x = places_in(scene_.domain.box, scene_.start, lattice_);
    const Index n = x.cols();
    particles_ = {.mass = scene_.fluid.density * lattice_.volume(),
                  .x = x,
                  .v = Vectors::Zero(2, n),
                  .expansion = Scalars::Zero(n),
                  .slopes = {static_cast<std::size_t>(n), Mat2::Zero()},
                  .affine = {static_cast<std::size_t>(n), Mat2::Zero()},
                  .gradient = Vectors::Zero(2, n)};
    ties_.resize(n);
    if (scene_.start.at_rest()) return;
    const auto expansion = [&](const Vec2& at) { return expansion_at(at, scene_.start, scene_.fluid); };
    for (Index p = 0; p < n; ++p) {
      const Beginning there = beginning_at(x.col(p), scene_.start, grid_, scene_.fluid);
      particles_.v.col(p) = there.v;
      particles_.expansion[p] = there.expansion;
      particles_.slopes[p] = particles_.affine[p] = Mat2{{there.of.xx, there.of.xy}, {there.of.yx, there.of.yy}};
      for (const int axis : {0, 1}) particles_.gradient(axis, p) = slope_along(axis, x.col(p), grid_, expansion);
    }
  }

  Lattice lattice_;
  PlainParticles particles_;
  PlainNodes<Shape> nodes_;
  std::vector<typename PlainNodes<Shape>::Ties> ties_;  // of each particle, within a step
  WallContact contact_;
  std::vector<HeldNode> held_;  // by node, then in the order of the scene
};

/// A simulation of a scene: `mpm::plain<mpm::BSpline<2>, mpm::Apic>(tank, {.cell = ...})`.
template <class Shape, class Transfer, class Density = CarriedDensity, class FluidLaw, class Force>
auto plain(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Plain<Shape, Transfer, Density, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
