#pragma once
#include "solvers/lattice.hpp"

namespace touchstone::sph {

/// What a method adds to a scene.
struct Settings {
  double spacing;           // m
  double smoothing_length;  // m   h
  double time_step;         // s
  int threads = 1;
};

/// The settings, or std::invalid_argument with one line.
inline const Settings& checked(const Settings& s) {
  require_positive("sph", "spacing [m]", s.spacing);
  require_positive("sph", "smoothing length [m]", s.smoothing_length);
  require_positive("sph", "threads", s.threads);
  return s;
}

/// Layers of ghosts, the first half a spacing behind the wall, that the kernel of fluid at a wall can reach.
template <class Kernel>
int ghost_layers(const Settings& s) {
  return static_cast<int>(Kernel::support * checked(s).smoothing_length / s.spacing + 0.5);
}

}  // namespace touchstone::sph
