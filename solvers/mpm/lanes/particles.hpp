#pragma once
#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/particles.hpp"
#include "solvers/mpm/parts.hpp"
#include "solvers/mpm/stress.hpp"

#include <concepts>

namespace touchstone::mpm {

/// One component of the velocity of all particles, and what an affine transfer has them hold besides.
struct AffineVelocity {
  Field<double> v;                 // m/s
  Field<double> along_x, along_y;  // m/s  change over a cell; of `MlsApic` less what the stress gives in a step

  explicit AffineVelocity(int slots) : v(slots), along_x(v), along_y(v) {}
  const Field<double>& of_place() const { return v; }
  auto fields() { return std::array{&v, &along_x, &along_y}; }
};
/// The same where particles move with the nodes, and not with what they hold as their velocity.
struct VelocityAndThatOfPlace {
  Field<double> v;      // m/s
  Field<double> place;  // m/s  of the place; before, what a body force that is not the same everywhere gives in a step

  explicit VelocityAndThatOfPlace(int slots) : v(slots), place(v) {}
  const Field<double>& of_place() const { return place; }
  auto fields() { return std::array{&v, &place}; }
};
template <class Transfer>
using VelocityOf = std::conditional_t<std::same_as<Transfer, Apic> || std::same_as<Transfer, MlsApic>, AffineVelocity,
                                      VelocityAndThatOfPlace>;

/// How the expansion changes over a cell, where a density has particles hold it.
template <class Density>
struct GradientOf {
  explicit GradientOf(int) {}
  auto fields() { return std::array<Field<double>*, 0>{}; }
};
template <std::derived_from<AffineDensity> Density>
struct GradientOf<Density> {
  Field<double> along_x, along_y;  // -

  explicit GradientOf(int slots) : along_x(slots), along_y(slots) {}
  auto fields() { return std::array{&along_x, &along_y}; }
};

/// Of a transfer whose affine velocity holds what the stress gives.
struct NoStress {
  explicit NoStress(int) {}
  template <class F>
  static void for_fields(const F&) {}
};
template <class FluidLaw, class Transfer>
using StressOf = std::conditional_t<std::same_as<Transfer, MlsApic>, NoStress, Stress<FluidLaw, double>>;

/// The state of all particles.
template <class FluidLaw, class Transfer, class Density>
struct LaneParticles : ParticlesInCells<double> {
  VelocityOf<Transfer> x, y;  // components of the velocity
  GradientOf<Density> gradient;
  StressOf<FluidLaw, Transfer> stress;

  LaneParticles(Index n, double mass_of_each, CellOrder<lanes> cells)
      : ParticlesInCells<double>(n, mass_of_each, std::move(cells)),
        x(this->order.slots()),
        y(this->order.slots()),
        gradient(this->order.slots()),
        stress(this->order.slots()) {}

  Vec2 velocity(int slot) const { return {x.v[slot], y.v[slot]}; }  // m/s

  template <class F>
  void for_fields(const F& f) {
    f(this->X);
    f(this->Y);
    f(this->expansion);
    for (auto* field : x.fields()) f(*field);
    for (auto* field : y.fields()) f(*field);
    for (auto* field : gradient.fields()) f(*field);
    stress.for_fields(f);
    f(this->number);
  }
};

/// Sets a particle going, with the affine velocity of its velocity's slopes and the stress of these and its density.
template <class FluidLaw, class Transfer, class Density>
void begin(LaneParticles<FluidLaw, Transfer, Density>& particles, int slot, const Beginning& there,
           const FluidLaw& fluid, const Vec2& cell, double /*dt*/) {
  particles.x.v[slot] = there.v.x();
  particles.y.v[slot] = there.v.y();
  if constexpr (std::same_as<Transfer, Apic>) {
    particles.x.along_x[slot] = cell.x() * there.of.xx;
    particles.x.along_y[slot] = cell.y() * there.of.xy;
    particles.y.along_x[slot] = cell.x() * there.of.yx;
    particles.y.along_y[slot] = cell.y() * there.of.yy;
  }
  particles.expansion[slot] = there.expansion;
  const Slopes<double>& of = there.of;
  particles.stress.template update<Lanes>(
      slot, fluid, fill<Lanes>(there.expansion),
      {fill<Lanes>(of.xx), fill<Lanes>(of.yx), fill<Lanes>(of.xy), fill<Lanes>(of.yy)}, FirstLane{});
}

}  // namespace touchstone::mpm
