#pragma once
/// Where the time of a step goes, for a caller who wants to know.

#include <array>
#include <functional>
#include <string_view>

namespace touchstone {

/// Parts of a step that are timed separately.
enum class SubStep {
  scatter,     // particles to nodes
  grid,        // on the nodes
  remap,       // particles to nodes once more
  gather,      // nodes to particles
  pairs,       // sums over pairs of particles
  rates,       // particle by particle: pressure, force
  boundaries,  // ghosts, images, walls
  motion,      // particle by particle: forward in time
  sorting,     // particles into cells, lists of neighbours
};
inline constexpr std::array<std::string_view, 9> names_of_sub_steps{
    "scatter", "grid", "remap", "gather", "pairs", "rates", "boundaries", "motion", "sorting"};

/// A solver's step(lap) calls lap(part) at the end of each part: what came since the last call was that part.
using Laps = std::function<void(SubStep)>;
inline const Laps no_laps = [](SubStep) {};

}  // namespace touchstone
