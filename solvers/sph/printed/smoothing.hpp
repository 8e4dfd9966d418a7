#pragma once
#include "solvers/sph/neighbourhood.hpp"

namespace touchstone::sph {

/// Density reinitialised from the mass around, with the kernel normalised over the particles that are there (29), (30):
/// rho_i = sum_j m_j W_ij / sum_j (m_j / rho_j) W_ij, the particle itself included.
template <class Kernel, class Packed>
void reinitialise_density(Neighbourhood<Packed>& near, double h) {
  Scalars& rho = near.all.rho;
  sum_over_neighbours<2>(
      near.fluid_near_fluid, near.seen,
      [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& i, const auto& j) {
        const auto r = distance(i, j);
        using Real = std::remove_cvref_t<decltype(r)>;
        const Real w = Kernel::w(Real(r * per_h));
        return std::array<Real, 2>{w, w * j.two(&Packed::specific_volume)[0]};
      },
      [&](Index i, const std::array<double, 2>& sums) {
        rho[i] = (sums[0] + Kernel::w(0.0)) / (sums[1] + Kernel::w(0.0) / rho[i]);
      });
}

}  // namespace touchstone::sph
