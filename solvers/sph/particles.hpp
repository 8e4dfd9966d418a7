#pragma once
/// All particles that a sum may meet, in one numbering: fluid, then boundary, then their images beyond the periodic
/// seam, then a few so far away that no kernel reaches them, which fill the vector lanes that have no particle.

#include "solvers/diverged.hpp"
#include "solvers/scene.hpp"
#include "solvers/sph/lanes.hpp"

#include <vector>

namespace touchstone::sph {

using Index = Eigen::Index;

/// A field per particle; x and y stand apart because loops over pairs run along them with vector instructions.
struct Particles {
  Index fluid = 0, boundary = 0, images = 0;
  double mass = 0;               // kg/m  of every particle
  Scalars x, y;                  // m
  Scalars vx, vy;                // m/s
  Scalars rho, p;                // kg/m³, Pa
  std::vector<Scalars> carried;  // further fields of a method that go with its particles; of its own units
  std::vector<int> number;       // of each fluid particle at the start, before it was sorted into cells

  Index nowhere() const { return fluid + boundary + images; }
  /// Calls change(field) for each field.
  template <class Change>
  void each_field(Change change) {
    for (Scalars* field : {&x, &y, &vx, &vy, &rho, &p}) change(*field);
    for (Scalars& field : carried) change(field);
  }
  /// Makes room for the images and for those that are nowhere.
  void resize() {
    each_field([&](Scalars& field) {
      field.conservativeResize(nowhere() + lanes);
      field.tail(lanes) = 0;
    });
    x.tail(lanes) = y.tail(lanes) = 1e30;  // m  its square is still finite
    rho.tail(lanes) = 1;                   // kg/m³  divides nothing by zero
  }
};

/// Copies of particles near the periodic seam, one domain length further.
class Images {
 public:
  struct Image {
    Index source;
    double shift;  // m
  };

  /// Chooses the particles within `reach` of the seam, fluid first.
  void choose(Particles& all, const Domain& domain, double reach) {
    images_.clear();
    of_fluid_ = 0;
    if (domain.periodic_x) {
      add(all, 0, all.fluid, domain.box, reach);
      of_fluid_ = images_.size();
      add(all, all.fluid, all.fluid + all.boundary, domain.box, reach);
    }
    all.images = static_cast<Index>(images_.size());
    all.resize();
    refresh_fluid(all);
    refresh_boundary(all);
  }
  void refresh_fluid(Particles& all) const { refresh(all, 0, of_fluid_); }
  void refresh_boundary(Particles& all) const { refresh(all, of_fluid_, images_.size()); }

  Index source(Index image) const { return images_[static_cast<std::size_t>(image)].source; }
  /// The number of the first image.
  Index first(const Particles& all) const { return all.fluid + all.boundary; }

 private:
  void add(const Particles& all, Index begin, Index end, const Box& box, double reach) {
    const double length = box.size().x();
    for (Index i = begin; i < end; ++i) {
      if (all.x[i] < box.low.x() + reach) images_.push_back({i, length});
      if (all.x[i] > box.high.x() - reach) images_.push_back({i, -length});
    }
  }
  void refresh(Particles& all, std::size_t begin, std::size_t end) const {
    for (std::size_t k = begin; k < end; ++k) {
      const auto [source, shift] = images_[k];
      const Index copy = first(all) + static_cast<Index>(k);
      all.each_field([source = source, copy](Scalars& field) { field[copy] = field[source]; });
      all.x[copy] += shift;
    }
  }

  std::vector<Image> images_;
  std::size_t of_fluid_ = 0;
};

}  // namespace touchstone::sph
