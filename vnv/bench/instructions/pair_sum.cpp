/// The sum over pairs of a fluid with pressure and nothing else, so many times:
///     pair_sum listed|by_hand|with_viscosity TIMES
/// as the solver makes it from a list of terms, or written by hand. Valgrind counts the instructions of each: a term
/// that is not listed must cost none. Printed is a sum of the result, so that nothing is optimised away.

#include "solvers/fluids/tait.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/momentum.hpp"
#include "solvers/sph/neighbourhood.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace touchstone;
using namespace touchstone::sph;

namespace {

constexpr double spacing = 0.025, h = 1.2 * spacing;  // m
constexpr int width = lanes_of<double>;
using Fluid = Neighbourhood<Packed<double>>;
using Sums = std::vector<std::array<double, 2>>;

/// A square of fluid, compressed.
Fluid square() {
  const Box box{.high = {1, 1}};
  const Scene<Tait> scene{.domain = {.box = box}, .fluid = {.density = 1000, .bulk_modulus = 143}, .filled = box};
  Fluid fluid(scene, spacing, {.kernel = 2 * h, .wall = 0, .skin = 0.3 * spacing},
              lay_out_ghosts(scene.domain, {}, spacing, 0));
  fluid.all.rho.head(fluid.all.fluid) = 1001;
  fluid.see_fluid(scene.fluid);
  return fluid;
}

template <class Terms>
[[gnu::noinline]] void sum(const Fluid& fluid, const Terms& list, Sums& accelerations) {
  sum_over_neighbours<2>(
      fluid.fluid_near_fluid, fluid.seen,
      [terms = list, mass = fluid.all.mass, slope = Slope<CubicSpline>(h)](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, mass);
        const auto acceleration = terms.on(ij, slope);
        return std::array{acceleration.x, acceleration.y};
      },
      [&](Index i, const std::array<double, 2>& sums) { accelerations[i] = sums; });
}

/// The same without pairs, terms and kernels.
[[gnu::noinline]] void sum_by_hand(const Fluid& fluid, Sums& accelerations) {
  using Numbers = LanesOf<double>;
  const Packed<double>* all = fluid.seen.data();
  const double mass = fluid.all.mass;
  const auto& part = fluid.fluid_near_fluid.parts[0];
  for (const auto& block : part.blocks) {
    const int* self = part.rows.data() + block.first_row * width;
    const auto x_i = gather_two<width>([&](int lane) { return &all[self[lane]].x; });
    const auto p_over_rho2_i = gather_two<width>([&](int lane) { return &all[self[lane]].rho; })[1];
    Numbers ax{}, ay{};
    for (int row = 1; row < block.rows; ++row) {
      const int* other = self + row * width;
      const auto x_j = gather_two<width>([&](int lane) { return &all[other[lane]].x; });
      const auto p_over_rho2_j = gather_two<width>([&](int lane) { return &all[other[lane]].rho; })[1];
      const Numbers x = x_i[0] - x_j[0], y = x_i[1] - x_j[1];
      Numbers r;
      const Numbers r2 = x * x + y * y;
      for (int lane = 0; lane < width; ++lane) r[lane] = std::sqrt(r2[lane]);
      const Numbers q = r * (1 / h), two = 2 - q, one = 1 - q;
      const Numbers a = two > 0 ? two : Numbers{}, b = one > 0 ? one : Numbers{};
      const Numbers slope = CubicSpline::sigma * (-0.75 * a * a + 3 * b * b) * (1 / (h * h * h)) * (1 / r);
      const Numbers c = -(mass * slope) * (p_over_rho2_i + p_over_rho2_j);
      ax += c * x;
      ay += c * y;
    }
    for (int lane = 0; lane < block.particles; ++lane) accelerations[self[lane]] = {ax[lane], ay[lane]};
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::string how = count == 3 ? arguments[1] : "";
  const Fluid fluid = square();
  Sums accelerations(fluid.all.fluid);
  for (long left = count == 3 ? std::atol(arguments[2]) : 0; left > 0; --left)
    if (how == "listed")
      sum(fluid, momentum(Pressure{}), accelerations);
    else if (how == "by_hand")
      sum_by_hand(fluid, accelerations);
    else
      sum(fluid, momentum(Pressure{}, LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h}), accelerations);
  double all = 0;
  for (const auto& a : accelerations) all += std::abs(a[0]) + std::abs(a[1]);
  std::printf("%.17g\n", all);
}
