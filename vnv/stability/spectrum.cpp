#include "vnv/stability/spectrum.hpp"

#include <fmt/format.h>
#include "solvers/stepping/diverged.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;

constexpr int fields = 5;              // x, y, v_x, v_y, density: what is disturbed of a particle
constexpr int shown = 3;               // v_x, v_y, density: what is seen of it
constexpr double disturbance = 3e-7;   // of spacing, speed of sound and density
constexpr int starting = 3;            // steps, or sets of steps, left out
constexpr double most_response = 1e4;  // of the disturbance; what does not grow stays far below
constexpr double rounding = 1e-6;      // of the largest singular value, and of a response that neither grows nor decays

/// Of a disturbance that is large before one can say of what wave it is.
const Spectrum blown_up{INFINITY, Vec2::Constant(NAN)};

/// One of the particles of unit cell (0, 0) and one of its fields.
struct Disturbed {
  int column, row, field;
};

/// The lattice with one field of one particle off by `by` of its unit.
Start disturbed(const RestingLattice& lattice, const Disturbed& what, double by) {
  const double spacing = RestingLattice::spacing, c = RestingLattice::sound_speed;
  const Vec2 there = spacing * (Vec2(what.column, what.row) + Vec2(0.5, 0.5) + lattice.shift);
  const auto at_it = [=](const Vec2& x) { return (x - there).norm() < spacing / 4; };
  Start start;
  if (what.field < 2) {
    start.places = [=, across = lattice.across()](const Vectors& places) {
      Vectors moved = places;
      moved(what.field, what.row * across + what.column) += by * spacing;
      return moved;
    };
  } else if (what.field < 4) {
    start.velocity = [=](const Vec2& x) {
      return at_it(x) ? Vec2(by * c * Vec2::Unit(what.field - 2)) : Vec2(Vec2::Zero());
    };
  } else {
    start.pressure = [=](const Vec2& x) { return at_it(x) ? by * RestingLattice::density * c * c : 0; };
  }
  return start;
}

/// Velocity and density of all particles, each in its unit, after each step from `starting` on: a row for each field
/// and particle.
Eigen::MatrixXd seen_of(Simulation simulation, int steps, int every) {
  Eigen::MatrixXd all(shown * simulation.particles(), steps);
  for (int k = 0; k < starting * every; ++k) simulation.step();
  for (int k = 0; k < steps; ++k) {
    for (int of_set = 0; of_set < every; ++of_set) simulation.step();
    const Samples s = simulation.samples();
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      const Vec2 v = s.v.col(p) / RestingLattice::sound_speed;
      all.block<shown, 1>(shown * p, k) << v, s.density[p] / RestingLattice::density;
    }
  }
  return all;
}

/// What a disturbance does to all particles, per unit of it: as `seen_of`.
Eigen::MatrixXd response(const OnLattice& method, const RestingLattice& lattice, double courant, const Disturbed& what,
                         int steps, int every) {
  const auto seen = [&](double by) {
    return seen_of(simulate(method, lattice, disturbed(lattice, what, by), courant), steps, every);
  };
  return (seen(disturbance) - seen(-disturbance)) / (2 * disturbance);
}

/// The response of each field of a unit cell to each, for one wave, after each step.
std::vector<ComplexMatrix> on_wave(const std::vector<Eigen::MatrixXd>& responses, const RestingLattice& lattice,
                                   const Vec2& turns) {
  const int points = lattice.points, of_cell = points * points, across = lattice.across();
  const Eigen::Index steps = responses.front().cols();
  std::vector<ComplexMatrix> sequence(steps, ComplexMatrix::Zero(shown * of_cell, fields * of_cell));
  for (int row = 0; row < across; ++row)
    for (int column = 0; column < across; ++column) {
      const double angle = std::numbers::pi * (turns.x() * (column / points) + turns.y() * (row / points));
      const Complex phase = std::polar(1.0, -angle);
      const int slot = (row % points) * points + column % points, p = row * across + column;
      for (int cause = 0; cause < fields * of_cell; ++cause)
        for (int field = 0; field < shown; ++field)
          for (Eigen::Index k = 0; k < steps; ++k)
            sequence[k](shown * slot + field, cause) += phase * responses[cause](shown * p + field, k);
    }
  return sequence;
}

/// The largest eigenvalue, by size, of the smallest A that has a sequence C A^n B.
double radius_of(const std::vector<ComplexMatrix>& sequence, int blocks) {
  const Eigen::Index rows = sequence.front().rows(), columns = sequence.front().cols();
  ComplexMatrix now(blocks * rows, blocks * columns), next = now;
  for (int i = 0; i < blocks; ++i)
    for (int j = 0; j < blocks; ++j) {
      now.block(i * rows, j * columns, rows, columns) = sequence[i + j];
      next.block(i * rows, j * columns, rows, columns) = sequence[i + j + 1];
    }
  const Eigen::JacobiSVD<ComplexMatrix> svd(now, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < values.size() && values[rank] > rounding * std::max(values[0], 1.0)) ++rank;
  if (rank == 0) return 0;
  const Eigen::VectorXcd scale = values.head(rank).cwiseSqrt().cwiseInverse().cast<Complex>();
  const ComplexMatrix step = scale.asDiagonal() *
                             (svd.matrixU().leftCols(rank).adjoint() * next * svd.matrixV().leftCols(rank)) *
                             scale.asDiagonal();
  return Eigen::ComplexEigenSolver<ComplexMatrix>(step, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

Spectrum spectrum(const OnLattice& method, const RestingLattice& lattice, double courant, int every) try {
  // Enough for methods that remember as much again as one sees, or three times that with one particle in a unit cell.
  const int blocks = lattice.points == 1 ? 4 : 2, steps = 2 * blocks;
  std::vector<Eigen::MatrixXd> responses;
  for (int row = 0; row < lattice.points; ++row)
    for (int column = 0; column < lattice.points; ++column)
      for (int field = 0; field < fields; ++field)
        responses.push_back(response(method, lattice, courant, {column, row, field}, steps, every));
  for (const Eigen::MatrixXd& r : responses)
    if (!(r.cwiseAbs().maxCoeff() < most_response)) return blown_up;
  Spectrum found{0, Vec2::Zero()};
  for (int a = 0; a <= lattice.cells / 2; ++a)  // a wave the other way does the same
    for (int b = 0; b < lattice.cells; ++b) {
      const Vec2 turns = 2.0 / lattice.cells * Vec2(a, b);
      const std::vector<ComplexMatrix> sequence = on_wave(responses, lattice, turns);
      const double radius = std::pow(radius_of(sequence, blocks), 1.0 / every);
      if (radius > found.radius) found = {radius, turns};
    }
  return found;
} catch (const Diverged&) {
  return blown_up;
}

double critical_courant(const OnLattice& method, const RestingLattice& lattice, int every, double low, double high) {
  const auto grows = [&](double courant) { return spectrum(method, lattice, courant, every).radius > growing; };
  if (grows(low))
    throw std::invalid_argument(fmt::format("linear stability: Courant number {:g}, expected a stable lower end", low));
  if (!grows(high))
    throw std::invalid_argument(
        fmt::format("linear stability: Courant number {:g}, expected an unstable upper end", high));
  while (high > 1.002 * low) {
    const double middle = std::sqrt(low * high);
    (grows(middle) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace touchstone::vnv
