#pragma once
/// All particles of a run in one numbering: fluid, then boundary, then their images beyond the periodic boundary, then
/// one so far away that no kernel reaches it, which fills the vector lanes that have no neighbour.

#include "solvers/integrators/fluid_state.hpp"
#include "solvers/scene.hpp"
#include "solvers/sph/packed.hpp"
#include "solvers/stepping/diverged.hpp"

#include <vector>

namespace touchstone::sph {

/// The state, in double precision whatever the sums run in. Places are those of all particles, of an image where it
/// stood when it was chosen.
struct Particles : FluidState {
  Index boundary = 0, images = 0;
  double mass = 0;               // kg/m  of every particle
  std::vector<Scalars> carried;  // further fields of a method that go with its fluid; of its own units
  std::vector<int> number;       // of each fluid particle at the start, before it was sorted into cells

  Index nowhere() const { return fluid + boundary + images; }
  /// Calls change(field) for each field of the fluid but its places.
  template <class Change>
  void each_field(Change change) {
    for (Scalars* field : {&vx, &vy, &rho, &ax, &ay, &drho}) change(*field);
    for (Scalars& field : carried) change(field);
    for (Scalars& field : past) change(field);
  }
};

/// Copies of particles near a periodic boundary, one domain length further.
class Images {
 public:
  struct Image {
    Index source;
    Vec2 shift;  // m
  };

  /// Chooses the particles within `reach` of a periodic boundary, fluid first, and says where they stand.
  void choose(Particles& all, const Domain& domain, double reach) {
    images_.clear();
    add(all, 0, all.fluid, domain, reach);
    of_fluid_ = images_.size();
    add(all, all.fluid, all.fluid + all.boundary, domain, reach);
    all.images = static_cast<Index>(images_.size());
    for (Scalars* field : {&all.x, &all.y}) field->conservativeResize(all.nowhere() + 1);
    for (Index k = 0; k < all.images; ++k) {
      all.x[first(all) + k] = all.x[images_[k].source] + images_[k].shift.x();
      all.y[first(all) + k] = all.y[images_[k].source] + images_[k].shift.y();
    }
  }
  template <class Packed>
  void refresh_fluid(const Particles& all, std::vector<Packed>& seen) const {
    refresh(all, seen, 0, of_fluid_);
  }
  template <class Packed>
  void refresh_boundary(const Particles& all, std::vector<Packed>& seen) const {
    refresh(all, seen, of_fluid_, images_.size());
  }

  Index source(Index image) const { return images_[static_cast<std::size_t>(image)].source; }
  Index of_fluid() const { return static_cast<Index>(of_fluid_); }
  /// The number of the first image.
  Index first(const Particles& all) const { return all.fluid + all.boundary; }

 private:
  /// Where a particle stands again along an axis, itself first.
  struct Shifts {
    std::array<double, 3> by{};  // m
    int count = 1;
  };

  void add(const Particles& all, Index begin, Index end, const Domain& domain, double reach) {
    const Vec2 period = domain.box.size();
    const auto shifts = [&](bool periodic, int axis, double place) {
      Shifts found;
      if (periodic && place < domain.box.low[axis] + reach) found.by[found.count++] = period[axis];
      if (periodic && place > domain.box.high[axis] - reach) found.by[found.count++] = -period[axis];
      return found;
    };
    for (Index i = begin; i < end; ++i) {
      const Shifts along_x = shifts(domain.periodic_x, 0, all.x[i]), along_y = shifts(domain.periodic_y, 1, all.y[i]);
      for (int k = 1; k < along_x.count * along_y.count; ++k)  // the first is the particle itself
        images_.push_back({i, Vec2(along_x.by[k % along_x.count], along_y.by[k / along_x.count])});
    }
  }
  template <class Packed>
  void refresh(const Particles& all, std::vector<Packed>& seen, std::size_t begin, std::size_t end) const {
    for (std::size_t k = begin; k < end; ++k) {
      const auto [source, shift] = images_[k];
      Packed& image = seen[first(all) + static_cast<Index>(k)];
      image = seen[source];
      image.stand_at(all.x[source] + shift.x(), all.y[source] + shift.y());
    }
  }

  std::vector<Image> images_;
  std::size_t of_fluid_ = 0;
};

}  // namespace touchstone::sph
