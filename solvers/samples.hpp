#pragma once
/// What leaves a solver, and what another code's output becomes: plain particle data at one time.

#include "solvers/fields.hpp"

namespace touchstone {

/// One column or number per particle, in the order of the particles' numbers, which is the same at all times.
struct Samples {
  double time = 0;     // s
  Vectors x{};         // m
  Vectors v{};         // m/s
  Scalars mass{};      // kg per metre of depth
  Scalars density{};   // kg/m³
  Scalars pressure{};  // Pa

  /// Of so many particles of the same mass, the rest to be written.
  static Samples of_equal(double time, Index n, double mass) {
    return {time, Vectors(2, n), Vectors(2, n), Scalars::Constant(n, mass), Scalars(n), Scalars(n)};
  }

  Eigen::Index size() const { return x.cols(); }
  Scalars volumes() const { return mass / density; }  // m² per particle
};

}  // namespace touchstone
