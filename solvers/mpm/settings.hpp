#pragma once

namespace touchstone::mpm {

/// How the method resolves a scene. The cell and the spacing are adjusted to fit the domain and the filled box, see
/// `Grid` and `lattice`.
struct Settings {
  double cell;       // m  side of a cell of the background grid
  double spacing;    // m  between particles at the start
  double time_step;  // s
  int threads = 1;   // the results are the same bits for any number
};

}  // namespace touchstone::mpm
