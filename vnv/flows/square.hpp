#pragma once
/// What the flows in a square that repeats along both axes share: the box, and their figures.

#include "vnv/measures/field_errors.hpp"
#include "vnv/methods/methods.hpp"
#include "vnv/plots/along_ladders.hpp"

namespace touchstone::vnv::square {

inline constexpr double side = 1;  // m
inline const Box box{.high = {side, side}};
inline const Domain domain{.box = box, .periodic_x = true, .periodic_y = true};

/// Of which every step divides the times at which flows in a square are looked at [s].
inline constexpr double output_interval = 0.1;

/// Error over spacing and over run time, with lines of first and second order.
inline std::vector<Plot> figures(double time, const Quantity& quantity, double error_of_first_order) {
  const Axis error{.label = "L2 v [%]", .logarithmic = true};
  const auto guide = [&](const std::string& label, double order) {
    const double coarse = side / 24, fine = side / 200;
    return Curve{"order",
                 label,
                 Role::guide,
                 {coarse, fine},
                 {error_of_first_order, error_of_first_order * std::pow(fine / coarse, order)},
                 false};
  };
  return {along_ladders({"order",
                         "Error against spacing",
                         fmt::format("L2 error of the velocity, over particles, at t = {:g} s.", time),
                         {.label = "particle spacing [mm]", .scale = 1e3, .logarithmic = true},
                         error},
                        {}, spacing(), {{"", error_of(quantity, time)}}),
          beside({guide("order 1", 1), guide("order 2", 2)}),
          along_ladders({"cost",
                         "Work-precision diagram",
                         fmt::format("The same against CPU time to t = {:g} s; lower left is better.", time),
                         {.label = "CPU time [s]", .logarithmic = true},
                         error},
                        {}, cpu_time_until(time), {{"", error_of(quantity, time)}})};
}

}  // namespace touchstone::vnv::square
