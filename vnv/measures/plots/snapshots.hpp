#pragma once
#include "vnv/case.hpp"
#include "vnv/measures/profile.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// Particles coloured by a field: a column of panels per method (of the first level named that it has), a row per time
/// [s].
Plot snapshots(Figure frame, std::vector<std::string> levels, std::vector<double> times,
               ParticleField colour = pressure);

}  // namespace touchstone::vnv
