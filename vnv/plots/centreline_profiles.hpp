#pragma once
#include "vnv/measures/centrelines.hpp"
#include "vnv/record/record.hpp"

#include <string>

namespace touchstone::vnv {

/// Velocity along a centreline at the end of a level, averaged as for its norms, as a line through the published
/// points. It ends a spacing and a half from the walls, nearer to which a fit of second degree has too few rows of
/// particles.
Plot centreline_profile(Figure frame, Cavity cavity, Centreline published, std::string level);

}  // namespace touchstone::vnv
