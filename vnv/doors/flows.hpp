#pragma once
/// The flows by which any code is judged, a function each.

#include "vnv/doors/flow.hpp"

namespace touchstone::vnv::doors {

Flow poiseuille(Settings& set);
Flow couette(Settings& set);
Flow oscillating_poiseuille(Settings& set);
Flow stokes_first(Settings& set);
Flow stokes_second(Settings& set);
Flow taylor_green(Settings& set);
Flow shear_wave(Settings& set);
Flow manufactured(Settings& set);
Flow cavity(Settings& set);
Flow hydrostatic(Settings& set);
Flow standing_wave(Settings& set);
Flow elliptic_drop(Settings& set);
Flow rotating_patch(Settings& set);
Flow dam_break(Settings& set);

}  // namespace touchstone::vnv::doors
