#pragma once
/// What the flows in a square that repeats along both axes share: methods and figures.

#include "vnv/measures/field_errors.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/methods/methods.hpp"

namespace touchstone::vnv::square {

inline constexpr double side = 1;  // m

/// Every step divides it, and it the times at which flows in a square are sampled [s].
inline constexpr double output_interval = 0.1;

/// The methods for a fluid that fills the square.
template <class Force>
std::vector<Method> methods_on(const Scene<Newtonian, Force>& scene) {
  return {mpm_as_printed(scene, output_interval),         mpm_affine(scene, output_interval),
          mpm_least_squares(scene, output_interval),      sph_as_printed(scene, output_interval),
          sph_transport_velocity(scene, output_interval), sph_second_order(scene, output_interval)};
}

/// Error over spacing and over run time, with lines of first and second order.
inline std::vector<Plot> figures(double time, const Quantity& quantity, double error_of_first_order) {
  const auto guide = [&](const std::string& label, double order) {
    const double coarse = side / 24, fine = side / 200;
    return Curve{"order",
                 label,
                 Role::guide,
                 {coarse, fine},
                 {error_of_first_order, error_of_first_order * std::pow(fine / coarse, order)},
                 false};
  };
  std::vector<Plot> all = errors_of_velocity("order", "L2 v [%]", quantity, time);
  all.push_back(beside({guide("order 1", 1), guide("order 2", 2)}));
  return all;
}

}  // namespace touchstone::vnv::square
