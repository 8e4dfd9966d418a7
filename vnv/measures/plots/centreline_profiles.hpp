#pragma once
#include "vnv/measures/centrelines.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// Velocity along a centreline at the end of the first of these levels that was run to its end, averaged as for its
/// norms, as a line through the published points; no figure where none was. It ends a spacing and a half from the
/// walls, nearer to which a fit of second degree has too few rows of particles.
Plot centreline_profile(Figure frame, Cavity cavity, Centreline published, std::vector<std::string> levels);

}  // namespace touchstone::vnv
