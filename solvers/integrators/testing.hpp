#pragma once
/// What the tests of all integrators move.

#include "solvers/integrators/fluid_state.hpp"
#include "solvers/stepping/laps.hpp"

#include <cmath>

namespace touchstone {

/// A standing sound wave in one particle, density [kg/m³] and velocity along x [m/s], on a mean density; and a spring
/// that holds the particle along y [m]. Both go through one radian a second.
class Oscillators {
 public:
  explicit Oscillators(double mean_density = 0, double stretched = 0) : mean_(mean_density) {
    all_.fluid = 1;
    for (Scalars* field : {&all_.x, &all_.y, &all_.vx, &all_.vy, &all_.rho, &all_.ax, &all_.ay, &all_.drho})
      field->setZero(1);
    all_.past.assign(6, Scalars::Zero(1));
    all_.rho = mean_ + 1;
    all_.y = stretched;
  }
  FluidState& state() { return all_; }
  int threads() const { return 1; }
  void find_density_rate(double, NoLaps) {
    change_density();
    ++evaluations_;
  }
  void find_accelerations(double, NoLaps) {
    accelerate();
    ++evaluations_;
  }
  void find_rates(double, NoLaps) {
    change_density();
    accelerate();
    ++evaluations_;
  }
  int evaluations() const { return evaluations_; }
  double energy_of_sound() const { return std::pow(all_.rho[0] - mean_, 2) + all_.vx[0] * all_.vx[0]; }
  double energy_of_spring() const { return all_.y[0] * all_.y[0] + all_.vy[0] * all_.vy[0]; }

 private:
  void change_density() { all_.drho = -all_.vx; }
  void accelerate() {
    all_.ax = all_.rho - mean_;
    all_.ay = -all_.y;
  }

  double mean_;
  FluidState all_;
  int evaluations_ = 0;
};

template <class Integrator>
Oscillators moved(Oscillators oscillators, double dt, int steps) {
  Integrator integrator;
  for (int k = 0; k < steps; ++k) integrator.step(oscillators, k * dt, dt, NoLaps{});
  return oscillators;
}

}  // namespace touchstone
