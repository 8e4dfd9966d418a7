#pragma once
/// The particles of a run with their lists of neighbours, kept up to date while they move.

#include "solvers/lattice.hpp"
#include "solvers/samples.hpp"
#include "solvers/sph/walls/ghosts.hpp"

namespace touchstone::sph {

class Neighbourhood {
 public:
  Particles all;
  BoundaryLayout boundary;
  Images images;
  NeighbourLists fluid_near_fluid;                // of each fluid particle: fluid and ghosts
  NeighbourLists fluid_near_ghost;                // of each ghost: fluid
  std::array<NeighbourLists, 2> wall_near_fluid;  // likewise: particles on walls of constant x, of constant y

  /// Fluid at rest on a lattice. `reach` [m] is the radius of the kernel; the lists reach a `skin` [m] further.
  Neighbourhood(const Domain& domain, const Box& filled, double density, double spacing, double reach, double skin,
                BoundaryLayout layout, std::size_t carried_fields = 0)
      : boundary(std::move(layout)), domain_(domain), reach_(reach), skin_(skin) {
    const double period = domain.box.size().x();
    if (domain.periodic_x && reach + skin > period)
      throw std::invalid_argument(
          fmt::format("sph: neighbours are listed up to {} m, wanted at most the period {} m", reach + skin, period));
    const Lattice cells = lattice(filled, spacing, domain.box);
    const Vectors places = cells.places();
    all.fluid = places.cols();
    all.boundary = static_cast<Index>(boundary.ghosts.size() + boundary.on_walls.size());
    all.mass = density * cells.volume();
    all.carried.resize(carried_fields);
    all.resize();
    all.each_field([](Scalars& field) { field = 0; });
    all.x.head(all.fluid) = places.row(0);
    all.y.head(all.fluid) = places.row(1);
    all.rho = density;
    for (Index k = 0; k < all.boundary; ++k) {
      const bool ghost = k < ghosts();
      const Vec2& x = ghost ? boundary.ghosts[k].x : boundary.on_walls[k - ghosts()];
      all.x[all.fluid + k] = x.x();
      all.y[all.fluid + k] = x.y();
    }
    all.number.resize(all.fluid);
    for (Index i = 0; i < all.fluid; ++i) all.number[i] = static_cast<int>(i);
    list_anew();
  }

  Index ghosts() const { return static_cast<Index>(boundary.ghosts.size()); }

  /// To be called before a step of `dt` [s]: lists anew, with the fluid in cell order, if by its end a particle may
  /// have come from outside the lists into the kernel's reach. Throws Diverged when a particle is outside the domain or
  /// nowhere.
  void follow(long step, double time, double dt) {
    constexpr double margin = 0.9;  // for what the velocity changes within the step
    const auto fluid = Eigen::seqN(0, all.fluid);
    way_ = ((all.x(fluid) - listed_x_).abs() + dt * all.vx(fluid).abs()).square() +
           ((all.y(fluid) - listed_y_).abs() + dt * all.vy(fluid).abs()).square();
    if ((way_ <= margin * margin * skin_ * skin_ / 4).all()) return;  // false for what is not a number
    refuse_strays(step, time);
    list_anew();
  }

  /// Throws Diverged when a particle is outside the domain or nowhere.
  void refuse_strays(long step, double time) const {
    const double seam =
        domain_.periodic_x ? domain_.box.size().x() : 0;  // a particle may be up to one length beyond it
    for (Index i = 0; i < all.fluid; ++i) {
      const Vec2 x(all.x[i], all.y[i]);
      const bool inside_x = x.x() >= domain_.box.low.x() - seam && x.x() <= domain_.box.high.x() + seam;
      const bool inside_y = x.y() >= domain_.box.low.y() && x.y() <= domain_.box.high.y();
      if (inside_x && inside_y) continue;
      throw Diverged(
          {step, time, all.number[i], x, inside_x ? "y [m]" : "x [m]", inside_x ? x.y() : x.x(), "inside the domain"});
    }
  }

  /// The fluid in the order of its numbers, with the pressure of its density.
  template <class FluidLaw>
  Samples samples(double time, const FluidLaw& fluid) const {
    Samples s{time,
              Vectors(2, all.fluid),
              Vectors(2, all.fluid),
              Scalars::Constant(all.fluid, all.mass),
              Scalars(all.fluid),
              Scalars(all.fluid)};
    for (Index i = 0; i < all.fluid; ++i) {
      const int n = all.number[i];
      s.x.col(n) = Vec2(wrapped(all.x[i]), all.y[i]);
      s.v.col(n) = Vec2(all.vx[i], all.vy[i]);
      s.density[n] = all.rho[i];
      s.pressure[n] = fluid.pressure(all.rho[i]);
    }
    return s;
  }

 private:
  double wrapped(double x) const {
    if (!domain_.periodic_x) return x;
    const double low = domain_.box.low.x(), length = domain_.box.size().x();
    return x - length * std::floor((x - low) / length);
  }

  void list_anew() {
    const double listed = reach_ + skin_;
    for (Index i = 0; i < all.fluid; ++i) all.x[i] = wrapped(all.x[i]);
    sort_fluid(Cells(all.x.data(), all.y.data(), all.fluid, listed).sorted());
    images.choose(all, domain_, listed);
    const Cells cells(all.x.data(), all.y.data(), all.nowhere(), listed);
    find_kinds();
    fill<3>({&fluid_near_fluid, &wall_near_fluid[0], &wall_near_fluid[1]}, all, cells, 0, all.fluid, listed,
            [&](int j) { return kind_[j] <= is_fluid ? 0 : kind_[j]; });
    fill<1>({&fluid_near_ghost}, all, cells, all.fluid, all.fluid + ghosts(), listed,
            [&](int j) { return kind_[j] == is_fluid ? 0 : -1; });
    listed_x_ = all.x.head(all.fluid);
    listed_y_ = all.y.head(all.fluid);
  }

  /// What each particle and image is.
  void find_kinds() {
    kind_.resize(all.nowhere());
    const Index on_walls = all.fluid + ghosts(), on_level = on_walls + static_cast<Index>(boundary.on_upright);
    for (Index j = 0; j < all.nowhere(); ++j) {
      const Index source = j < images.first(all) ? j : images.source(j - images.first(all));
      kind_[j] = source < all.fluid  ? is_fluid
                 : source < on_walls ? is_ghost
                 : source < on_level ? is_on_wall_of_x
                                     : is_on_wall_of_y;
    }
  }

  void sort_fluid(const std::vector<int>& order) {
    const Eigen::Map<const Eigen::ArrayXi> rows(order.data(), all.fluid);
    all.each_field([&](Scalars& field) { field.head(all.fluid) = field(rows).eval(); });
    std::vector<int> numbers(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) numbers[k] = all.number[order[k]];
    all.number = std::move(numbers);
  }

  Domain domain_;
  enum Kind : signed char { is_ghost = -1, is_fluid = 0, is_on_wall_of_x = 1, is_on_wall_of_y = 2 };
  std::vector<Kind> kind_;
  double reach_, skin_;          // m
  Scalars listed_x_, listed_y_;  // m   where the fluid was when the lists were made
  Scalars way_;                  // m²  how far it will be from there, squared
};

}  // namespace touchstone::sph
