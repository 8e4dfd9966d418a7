#pragma once
#include "solvers/sph/neighbours.hpp"

namespace touchstone::sph {

/// Density restored from the mass around, with the kernel normalised over the particles that are there (29), (30):
/// rho_i = sum_j m_j W_ij / sum_j (m_j / rho_j) W_ij, the particle itself included.
template <class Kernel>
void restore_density(Particles& all, const NeighbourLists& near, double h, std::array<Scalars, 2>& sums) {
  sum_over_neighbours<2>(near, {sums[0].data(), sums[1].data()}, [&](Block i, Row j) -> std::array<Lanes, 2> {
    const Lanes w = Kernel::w(distance(all, i, j) / h);
    return {w, w / j(all.rho)};
  });
  const auto rho = all.rho.head(all.fluid);
  all.rho.head(all.fluid) = (sums[0] + Kernel::w(0.0)) / (sums[1] + Kernel::w(0.0) / rho);
}

}  // namespace touchstone::sph
