#pragma once
/// The particles of a run with their lists of neighbours, kept up to date while they move.

#include "solvers/lattice.hpp"
#include "solvers/samples.hpp"
#include "solvers/sph/neighbours.hpp"
#include "solvers/sph/walls/contact.hpp"
#include "solvers/sph/walls/ghosts.hpp"

#include <atomic>

namespace touchstone::sph {

/// How far the lists reach [m]: the kernel, the push of a wall (0 where there is none), and a skin beyond both, which
/// is chosen anew with the lists.
struct ListReach {
  double kernel, wall, skin;
  double least_skin = skin, greatest_skin = skin;
};

/// Refuses a wall across a periodic axis, whose ghosts would have no images: std::invalid_argument with one line.
inline void require_no_wall_across_a_period(const Domain& domain, const std::vector<Wall>& walls) {
  for (const Wall& wall : walls)
    if (domain.periodic(wall.axis))
      throw std::invalid_argument(fmt::format("sph: a wall at {} = {} m, expected none across a periodic axis",
                                              wall.axis == 0 ? "x" : "y", wall.position));
}

/// Refuses fluid on a wall, where it would meet the particles that the wall is made of: std::invalid_argument with one
/// line.
inline void require_off_walls(const Vectors& places, const std::vector<Wall>& walls, double spacing) {
  const double least = contact_distance * spacing;
  for (const Wall& wall : walls)
    for (Index p = 0; p < places.cols(); ++p)
      if (wall.distance(places.col(p)) < least && wall.is_beside(places.col(p), 0))
        throw std::invalid_argument(
            fmt::format("sph: particle {} starts at ({:g}, {:g}) m, {:g} m from a wall, expected at least {:g} m", p,
                        places(0, p), places(1, p), wall.distance(places.col(p)), least));
}

template <class Packed_>
class Neighbourhood {
 public:
  using Packed = Packed_;
  static constexpr int width = lanes_of<typename Packed::Number>;
  using Lists = NeighbourLists<width>;

  Particles all;
  std::vector<Packed> seen;  // of all, what sums over pairs read
  BoundaryLayout boundary;
  Images images;
  Lists fluid_near_fluid;                // of each fluid particle: fluid and ghosts
  Lists fluid_near_ghost;                // of each ghost that has any: fluid
  std::array<Lists, 2> wall_near_fluid;  // of fluid that has any: particles on walls of constant x, of constant y

  /// Fluid on a lattice, set going as the scene says. Throws std::invalid_argument for a kernel that reaches once
  /// around the domain, and for fluid on a wall.
  template <class SceneOfRun>
  Neighbourhood(const SceneOfRun& scene, double spacing, const ListReach& reach, BoundaryLayout layout, int threads = 1)
      : boundary(std::move(layout)),
        domain_(scene.domain),
        density_(scene.fluid.density),
        walls_(scene.walls),
        reach_(reach),
        threads_(threads) {
    std::ranges::copy_if(walls_, std::back_inserter(gates_), &Wall::is_partial);
    const Vec2 period = domain_.box.size();
    for (const int axis : {0, 1})
      if (const double farthest = reach.kernel + reach.greatest_skin; domain_.periodic(axis) && farthest > period[axis])
        throw std::invalid_argument(fmt::format(
            "sph: neighbours are listed up to {} m, expected at most the period {} m", farthest, period[axis]));
    const Lattice cells = lattice(scene.filled, spacing, domain_.box);
    const Vectors places = places_in(domain_.box, scene.start, cells);
    require_no_wall_across_a_period(domain_, scene.walls);
    require_off_walls(places, scene.walls, spacing);
    place(places);
    all.mass = density_ * cells.volume();
    if (!scene.start.at_rest()) set_going(scene.start, scene.fluid);
    list_anew(0);
  }

  Index ghosts() const { return static_cast<Index>(boundary.ghosts.size()); }
  int threads() const { return threads_; }

  /// Gives the fluid fields of zeros that go with it: of a method, and of an integrator.
  void carry(std::size_t of_method, std::size_t of_integrator) {
    all.carried.assign(of_method, Scalars::Zero(all.fluid));
    all.past.assign(of_integrator, Scalars::Zero(all.fluid));
  }

  /// To be called before a step of `dt` [s]: lists anew, with the fluid in cell order, if by its end a particle may
  /// have come from outside the lists into the kernel's reach. Throws Diverged when a particle is outside the domain or
  /// nowhere.
  void follow(long step, double time, double dt) {
    if (lists_hold(dt)) return;
    refuse_strays(step, time);
    choose_skin(dt);
    list_anew(time);
  }

  /// Throws Diverged when a particle is outside the domain or nowhere.
  void refuse_strays(long step, double time) const {
    const Vec2 period = domain_.box.size();  // a particle may be up to one of them beyond a periodic boundary
    const auto is_inside = [&](int axis, double x) {
      const double beyond = domain_.periodic(axis) ? period[axis] : 0;
      return x >= domain_.box.low[axis] - beyond && x <= domain_.box.high[axis] + beyond;
    };
    for (Index i = 0; i < all.fluid; ++i) {
      const Vec2 x(all.x[i], all.y[i]);
      const bool inside_x = is_inside(0, x.x()), inside_y = is_inside(1, x.y());
      if (inside_x && inside_y) continue;
      throw Diverged(
          {step, time, all.number[i], x, inside_x ? "y [m]" : "x [m]", inside_x ? x.y() : x.x(), "inside the domain"});
    }
  }

  /// Packs the fluid and its images, with the pressure of its density (33).
  template <class FluidLaw>
  void see_fluid(const FluidLaw& fluid) {
    share_out_fields(threads_, all.fluid, [&, law = fluid](Index begin, Index end) {
      const double *const x = all.x.data(), *const y = all.y.data(), *const vx = all.vx.data(),
                          *const vy = all.vy.data(), *const rho = all.rho.data();
      Packed* const packed = seen.data();
      for (Index i = begin; i < end; ++i) {
        packed[i].stand_at(x[i], y[i]);
        packed[i].move(vx[i], vy[i]);
        packed[i].set_state(rho[i], law.pressure(rho[i]));
      }
    });
    images.refresh_fluid(all, seen);
  }

  /// Ghosts of gates stand where a gate is at a time [s], and nowhere where it is not.
  void move_gates(double time) {
    for (Index g = ghosts() - of_gates(); g < ghosts(); ++g) {
      const Vec2& x = boundary.ghosts[g].x;
      const bool is_there = gate_of(g).is_beside(x, time);
      seen[all.fluid + g].stand_at(is_there ? x.x() : all.x[all.nowhere()], is_there ? x.y() : all.y[all.nowhere()]);
    }
  }

  /// The fluid in the order of its numbers, with the pressure of its density.
  template <class FluidLaw>
  Samples samples(double time, const FluidLaw& fluid) const {
    Samples s = Samples::of_equal(time, all.fluid, all.mass);
    for (Index i = 0; i < all.fluid; ++i) {
      const int n = all.number[i];
      s.x.col(n) = Vec2(domain_.wrapped(0, all.x[i]), domain_.wrapped(1, all.y[i]));
      s.v.col(n) = Vec2(all.vx[i], all.vy[i]);
      s.density[n] = all.rho[i];
      s.pressure[n] = fluid.pressure(all.rho[i]);
    }
    return s;
  }

 private:
  void place(const Vectors& places) {
    all.fluid = places.cols();
    all.boundary = static_cast<Index>(boundary.ghosts.size() + boundary.on_walls.size());
    all.x.resize(all.nowhere() + 1);
    all.y.resize(all.nowhere() + 1);
    all.x.head(all.fluid) = places.row(0);
    all.y.head(all.fluid) = places.row(1);
    for (Index k = 0; k < all.boundary; ++k) {
      const Vec2& x = k < ghosts() ? boundary.ghosts[k].x : boundary.on_walls[k - ghosts()];
      all.x[all.fluid + k] = x.x();
      all.y[all.fluid + k] = x.y();
    }
    all.each_field([&](Scalars& field) { field.setZero(all.fluid); });
    all.rho = density_;
    all.number.resize(all.fluid);
    for (Index i = 0; i < all.fluid; ++i) all.number[i] = static_cast<int>(i);
  }

  template <class FluidLaw>
  void set_going(const Start& start, const FluidLaw& fluid) {
    for (Index i = 0; i < all.fluid; ++i) {
      const Vec2 x(all.x[i], all.y[i]), v = start.velocity_at(x);
      all.vx[i] = v.x();
      all.vy[i] = v.y();
      all.rho[i] = fluid.density_at(start.pressure_at(x));
    }
  }

  bool lists_hold(double dt) const {
    constexpr double margin = 0.9;  // for what the velocity changes within the step
    const double farthest = margin * margin * reach_.skin * reach_.skin / 4;
    std::atomic<bool> hold = true;
    share_out_fields(threads_, all.fluid, [&](Index begin, Index end) {
      const double *const x = all.x.data(), *const y = all.y.data(), *const vx = all.vx.data(),
                          *const vy = all.vy.data(), *const from_x = listed_x_.data(), *const from_y = listed_y_.data();
      long beyond = 0;
      for (Index i = begin; i < end; ++i) {
        const double way_x = std::abs(x[i] - from_x[i]) + dt * std::abs(vx[i]),
                     way_y = std::abs(y[i] - from_y[i]) + dt * std::abs(vy[i]);
        beyond |= way_x * way_x + way_y * way_y <= farthest ? 0 : 1;  // 1 for what is not a number
      }
      if (beyond) hold = false;
    });
    return hold;
  }

  /// A wide skin makes lists long, a narrow one makes them short-lived. Their cost is least where skin² is the reach
  /// times the way of a step times what listing costs in passes over the pairs, about 5.
  void choose_skin(double dt) {
    const double fastest = std::sqrt((all.vx.square() + all.vy.square()).maxCoeff());
    reach_.skin = std::clamp(std::sqrt(5 * reach_.kernel * fastest * dt), reach_.least_skin, reach_.greatest_skin);
  }

  void list_anew(double time) {
    const double listed = reach_.kernel + reach_.skin;
    for (Index i = 0; i < all.fluid; ++i) {
      all.x[i] = domain_.wrapped(0, all.x[i]);
      all.y[i] = domain_.wrapped(1, all.y[i]);
    }
    sort_fluid(Cells(all.x, all.y, all.fluid, listed, [](Index) { return true; }).sorted());
    images.choose(all, domain_, listed);
    list_fluid_and_ghosts(listed, time);
    if (reach_.wall > 0) list_walls(reach_.wall + reach_.skin);
    see_boundary_at_rest();
    listed_x_ = all.x.head(all.fluid);
    listed_y_ = all.y.head(all.fluid);
  }

  void list_fluid_and_ghosts(double listed, double time) {
    const auto left = [&](int i, std::vector<int>& found, std::size_t count) -> std::size_t {
      if (of_gates() == 0 || !is_near_gate(i, listed)) return count;
      const auto begin = found.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
      return std::remove_if(begin, end, [&](int j) { return is_hidden_by_gate(i, j, time); }) - begin;
    };
    const Cells cells(all.x, all.y, all.nowhere(), listed, [&](Index j) { return !is_on_wall(source(j)); });
    fill(fluid_near_fluid, all, cells, 0, all.fluid, listed, true, threads_, left);
    const Cells of_fluid(all.x, all.y, all.nowhere(), cells, [&](Index j) { return source(j) < all.fluid; });
    fill(fluid_near_ghost, all, of_fluid, all.fluid, all.fluid + ghosts(), listed, false, threads_, left);
  }

  /// Whether a ghost of a gate, which stands behind it within the kernel's reach, may be listed with a particle.
  bool is_near_gate(int i, double listed) const {
    return std::ranges::any_of(gates_, [&](const Wall& gate) {
      return std::abs(gate.distance({all.x[i], all.y[i]})) < 2 * listed;
    });
  }
  /// A ghost of a gate and fluid behind it do not see each other, nor does fluid on both sides. What stands otherwise
  /// before the lists are made anew, after a small part of a spacing, is not noticed.
  bool is_hidden_by_gate(int i, int j, double time) const {
    const auto place = [&](int p) -> Vec2 { return {all.x[p], all.y[p]}; };
    if (const int ghost = std::max(i, j); ghost >= all.fluid) {
      const Index g = ghost - all.fluid;
      return g >= ghosts() - of_gates() && gate_of(g).distance(place(std::min(i, j))) < 0;
    }
    const Vec2 from = place(i), to = place(j);
    return std::ranges::any_of(gates_, [&](const Wall& gate) {
      const double before = gate.distance(from), behind = gate.distance(to);
      return (before < 0) != (behind < 0) && gate.is_beside(from + before / (before - behind) * (to - from), time);
    });
  }
  Index of_gates() const { return static_cast<Index>(boundary.of_gates); }
  const Wall& gate_of(Index ghost) const { return walls_[boundary.ghosts[ghost].behind.front()]; }

  void list_walls(double listed) {
    const Index on_upright = all.fluid + ghosts() + static_cast<Index>(boundary.on_upright);
    for (const int axis : {0, 1}) {
      const Cells cells(all.x, all.y, all.nowhere(), listed,
                        [&](Index j) { return is_on_wall(source(j)) && (source(j) < on_upright) == (axis == 0); });
      if (cells.sorted().empty()) continue;
      fill(wall_near_fluid[axis], all, cells, 0, all.fluid, listed, false, threads_);
    }
  }

  /// Boundary particles stand where they stand, at rest and without pressure until fluid near them moves them.
  void see_boundary_at_rest() {
    const Vec2 far = domain_.box.high + domain_.box.size() + Vec2::Constant(10 * (reach_.kernel + reach_.skin));
    all.x[all.nowhere()] = far.x();
    all.y[all.nowhere()] = far.y();
    seen.resize(all.nowhere() + 1);
    for (Index k = all.fluid; k <= all.nowhere(); ++k) {
      seen[k] = Packed{};
      seen[k].stand_at(all.x[k], all.y[k]);
      seen[k].set_state(density_, 0);
    }
  }

  Index source(Index j) const { return j < images.first(all) ? j : images.source(j - images.first(all)); }
  bool is_on_wall(Index source) const { return source >= all.fluid + ghosts(); }

  void sort_fluid(const std::vector<int>& order) {
    const Eigen::Map<const Eigen::ArrayXi> rows(order.data(), all.fluid);
    const auto sort = [&](auto&& field) { field.head(all.fluid) = field(rows).eval(); };
    sort(all.x);
    sort(all.y);
    all.each_field(sort);
    std::vector<int> numbers(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) numbers[k] = all.number[order[k]];
    all.number = std::move(numbers);
  }

  Domain domain_;
  double density_;                   // kg/m³  at rest
  std::vector<Wall> walls_, gates_;  // gates are those with an extent
  ListReach reach_;
  int threads_;
  Scalars listed_x_, listed_y_;  // m   where the fluid was when the lists were made
};

}  // namespace touchstone::sph
