#pragma once
/// Columns of water that are released at once, beside the experiments of Martin & Moyce (1952), Koshizuka & Oka (1995),
/// Zhou, De Kat & Buchner (1999) and Buchner (2002); and what any dam break is read and compared by.

#include "solvers/fluids/tait.hpp"
#include "solvers/forces/skin_friction.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "vnv/flows/dam_front.hpp"
#include "vnv/judge/series.hpp"

#include <array>

namespace touchstone::vnv {

/// One column of what a run monitored, over time [s], in its unit.
Series followed(const Run& run, std::size_t column);

/// Times over `time`, values less `offset` over `value`.
Series scaled(Series series, double time, double offset, double value);

/// The differences of two series at the times of the measured one, from one time to another.
std::vector<double> differences(const Series& ours, const Series& measured, double from, double to);
/// Not a number of none.
double root_mean_square(const std::vector<double>& differences);

/// The particles within a strip of x, which is all that a gauge or a sensor sees.
Samples within(const Samples& samples, double low, double high);

/// Kinetic and potential energy of water and what compression holds [J/m]. Water that has come apart bears no tension,
/// and its density says nothing.
std::array<double, 3> energies(const Samples& samples, const Tait& water, double gravity);

inline const Quantity energy_made{"largest rise of the total energy over the fall", "", Kind::invariant,
                                  Better::smaller};
/// Over `fall` [J/m], of the sum of three columns that were monitored, of which `kinetic` is the first.
double largest_rise_of_energy(const Run& run, std::size_t kinetic, double fall);

/// What a plane flow leaves out of the walls of a tank.
struct Friction {
  double coefficient;         // -  c_f
  double layer;               // m  above the floor, as thin as the front's tip
  double breadth = INFINITY;  // m  between the side walls
};
/// The same column, which slides with skin friction.
Scene<Tait, SkinFriction> with_friction(const Scene<Tait, Uniform>& scene, const Friction& friction);

namespace open_dam {

/// How much later our clock is to be set, for an event of a computation to come when it came in the experiment, whose
/// origin of time is in doubt by `most`.
struct ClockShift {
  double needed;   // of what puts both events at one time; not a number without both
  double applied;  // that, but at most the doubt to either side: the rest stays a difference
};
ClockShift clock_shift(double measured, double ours, double most);

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

/// Water under its own weight that nothing holds from t = 0 on.
Scene<Tait, Uniform> collapse(const DamFront& dam);

inline constexpr double output_interval = 1e-3;  // s  holds whole numbers of steps
inline constexpr double end = 2;                 // s

/// A case, short of its methods, of a column whose front and residual height are compared with each experiment that
/// had one of its aspect, T up to `until`, and which has to live through the impact on the far wall, to 2 s. The tank
/// has to be so long that no front that is 0.3 of T early meets its wall while the data last.
Case beside_fronts(std::string title, std::string description, const DamFront& dam, double until);

/// The column and tank of Zhou, De Kat & Buchner (1999) and Buchner (2002).
inline const DamFront buchner = column(1.2, 0.6, 3.22);
/// A case, short of its methods, of that column: levels at two gauges and the pressure in the far wall.
Case beside_buchner(std::string title, std::string description);
/// Levels h/H at both gauges, from when they are wet until the wave returns, by the clock of h2.
inline const Quantity levels_rms{"RMS error of levels h/H, T_H to 5.5, clock of h2", "", Kind::error},
    travel{"time from gauge h2 to the sensor, over the measured"},
    plateau{"plateau, 1 to 2 of T_H after the rise, over the measured"};

}  // namespace open_dam
}  // namespace touchstone::vnv
