#pragma once
/// The dam break of Zhou, De Kat & Buchner (1999) and Buchner (2002), released at once: levels at two gauges and the
/// pressure in the far wall.

#include "vnv/flows/dams/open_dam.hpp"

namespace touchstone::vnv::open_dam {

/// How much later our clock is to be set, for an event of a computation to come when it came in the experiment, whose
/// origin of time is in doubt by `most`.
struct ClockShift {
  double needed;   // of what puts both events at one time; not a number without both
  double applied;  // that, but at most the doubt to either side: the rest stays a difference
};
ClockShift clock_shift(double measured, double ours, double most);

/// The column and tank of Zhou, De Kat & Buchner (1999) and Buchner (2002).
inline const DamFront buchner = column(1.2, 0.6, 3.22);
/// A case, short of its methods, of that column: levels at two gauges and the pressure in the far wall.
Case beside_buchner(std::string title, std::string description);
/// Levels h/H at both gauges, from when they are wet until the wave returns, by the clock of h2.
inline const Quantity levels_rms{"RMS error of levels h/H, T_H to 5.5, clock of h2", "", Kind::error},
    travel{"time from gauge h2 to the sensor, over the measured"},
    plateau{"plateau, 1 to 2 of T_H after the rise, over the measured"};

}  // namespace touchstone::vnv::open_dam
