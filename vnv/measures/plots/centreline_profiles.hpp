#pragma once
#include "vnv/measures/centrelines.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// Velocity along a centreline at the end of the first of these levels that was run to its end, averaged as for its
/// norms, beside that of the steady flow of a Reynolds number and the points that Ghia, Ghia & Shin (1982) have of it;
/// no figure where none was. It ends a spacing and a half from the walls, nearer to which a fit of second degree has
/// too few rows of particles.
Plot centreline_profile(Figure frame, Cavity cavity, int Re, Centreline::Direction direction,
                        std::vector<std::string> levels);

}  // namespace touchstone::vnv
