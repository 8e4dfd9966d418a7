#pragma once
/// Columns of water that are released at once, and their fronts beside those of Martin & Moyce (1952), Koshizuka & Oka
/// (1995) and Lobovský et al. (2014).

#include "vnv/flows/dams/dam.hpp"
#include "vnv/flows/dams/dam_front.hpp"

namespace touchstone::vnv::open_dam {

/// Water in which sound is 29 sqrt(g h0) fast at g = 9.81 m/s², 17 times as fast as the front: 50 m/s at 0.3 m, as in
/// the dam breaks with a gate.
inline Tait water_of(double height) { return {.density = 1000, .bulk_modulus = 1.2e6 * height}; }

/// A column in a tank so high that no splash leaves it; its front is a half-full slab of two spacings.
inline DamFront column(double length, double height, double tank) {
  return {.column_length = length,
          .column_height = height,
          .tank_length = tank,
          .tank_height = 20 * height,
          .density = 1000,
          .gravity = 9.81};
}

/// The square one of Martin & Moyce (1952), 2.25 in, and that of Koshizuka & Oka (1995), twice as high as long.
inline const DamFront martin_moyce_square = column(0.05715, 0.05715, 6 * 0.05715),
                      koshizuka_oka = column(0.146, 0.292, 5 * 0.146);

/// Water under its own weight that nothing holds from t = 0 on.
Scene<Tait, Uniform> collapse(const DamFront& dam);

/// What is monitored of such a column: its front, mass and particles, then its energies.
std::vector<double> monitored(const DamFront& dam, const Samples& samples);
std::vector<Quantity> monitored_quantities();

/// Of a run that lived: errors of mass and of the number of particles, and what energy it made.
std::vector<Value> conservation_errors(const DamFront& dam, const Level& level, const Run& run);

/// A case, short of methods and of what is compared, of a column that has to live through the impact on the far wall,
/// to 2 s.
Case to_the_end(std::string title, std::string description, const DamFront& dam);

/// A case, short of its methods, of a column whose front and residual height are compared with each experiment that
/// had one of its aspect, T up to `until`. The tank has to be so long that no front that is 0.3 of T early meets its
/// wall while the data last.
Case beside_fronts(std::string title, std::string description, const DamFront& dam, double until);

inline const std::string of_slab = DamFront::of_thin_slab, martin_moyce = "Martin & Moyce 1952";

}  // namespace touchstone::vnv::open_dam
