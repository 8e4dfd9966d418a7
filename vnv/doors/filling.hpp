#pragma once
/// Whether all the fluid of a flow is in what files hold, at every time: a claim on any code, whatever its errors.

#include "vnv/doors/given.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv::doors {

/// What is found of one level: the worst of its times, by its quantities, with what is claimed of them.
struct Filling {
  std::string level{};
  std::vector<Value> values{};
  std::vector<Claim> claims{};                               // on the level
  std::vector<std::pair<std::string, std::string>> where{};  // a quantity, and where its value is from
  std::vector<std::string> told{};
  bool is_counted = true;  // else nothing says how much fluid there should be: evenly thinned out, it looks the same
};

// Quantities besides those of vnv/measures/coverage.hpp.
inline const Quantity rows_found{"rows", "", Kind::count},
    without_velocity{"rows whose velocity is no number", "", Kind::count},
    mass_found{"mass, less that of the scene", "%", Kind::invariant},
    mass_kept{"mass, less that at the first time", "%", Kind::invariant},
    velocity_across{"L2 velocity across the plane over that in it", "%", Kind::error},
    density_found{"median density, less that of the fluid's law", "%", Kind::invariant};

/// Whether a quantity is one of these.
bool is_of_filling(const std::string& quantity);

/// Of a level by that name; `fields` are those of the files.
///
/// Mass, where rows have volumes or masses, is that of the scene to 3 %, or to a line of particles along the walls,
/// which nodes have more and rows that stand off them have less; masses that differ by more than a factor of 3 are of a
/// layer of another depth than 1 m, and are compared with those at the first time. Without them rows weigh the same,
/// and their number is that of the scene at a resolution that was said, else that at the first time. The former has
/// room for nodes, which are one more along each axis, for rows on walls that were left out, and from 3 % fewer to 20 %
/// more rows, as those of a hexagonal lattice.
///
/// Holes, crowds and gaps are claimed of rows that are no cells of a mesh where the region of the fluid is known
/// exactly: where it fills its domain, at the start, and by `Flow::region`; elsewhere holes are only measured. Of a
/// slab they are those of its slices, and its rows as many as its layers hold. What moves across the plane is an error.
Filling filling_of(const Flow& flow, const std::string& level, const GivenLevel& given,
                   const std::vector<std::string>& fields);

}  // namespace touchstone::vnv::doors
