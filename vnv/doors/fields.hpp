#pragma once
/// Which array of a file is which field of a flow, and in which unit.

#include "solvers/samples.hpp"
#include "solvers/scene.hpp"
#include "vnv/doors/read/dataset.hpp"
#include "vnv/flows/flow.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::doors {

/// What a user says of files. What is empty is found by its common names and units, where that is unique.
struct Mapping {
  std::map<std::string, std::string> arrays{};  // field -> name of an array, "velocity" -> "U", or of columns, "a,b"
  std::map<std::string, std::string> units{};   // kind -> unit: "length" -> "mm", "velocity", "pressure", "time"
  std::string axes{};                           // of the plane, "xy", "-zx", ...; empty: that in which the places lie
  Vec2 origin = Vec2::Zero();                   // m  the flow's origin, in the coordinates of the files
  std::string only{};                           // "NAME=VALUE", "NAME>VALUE", "NAME<VALUE": rows that are fluid
  bool inside = false;                          // leave out rows outside the domain
  bool probes = false;                          // rows are places at which the flow was probed, not all of the fluid
  std::string at{};                             // "x=0.25": the coordinate [m] of a line of which a table has the other
  std::vector<std::string> symmetric{};         // "y=0.5": a line of the flow [m] beyond which all is mirrored
  std::optional<double> time{};                 // s  of a file that has none
  std::optional<double> time_step{};            // s  of files with an index and no time
};

/// The axes of a plane in each order: "xz"; with a sign before those that run against the flow's: "-zx".
std::vector<std::string> names_of_planes();

/// Throws std::invalid_argument for axes, a field or a kind of unit that there is not, saying where and naming all of
/// them.
void require_known_names(const Mapping& mapping, const std::string& where);

/// Rows that evenly fill more than one and a half periods along an axis, which is no motion beyond them: the period is
/// another one.
struct LongerThanPeriod : Unreadable {
  LongerThanPeriod(const std::string& line, int of_axis, double filled)
      : Unreadable(line), axis(of_axis), length(filled) {}
  int axis;
  double length;  // m  that they fill
};

/// Adds to a table with one coordinate alone, as of a profile, the other one, where the user says it or by `place` [m],
/// of which a component may be no number. What is called a distance is the coordinate that the other one is not.
/// Whether it has.
bool complete_coordinates(Dataset& data, const Mapping& mapping, const Vec2& place);

/// Where the fluid of a flow is.
struct Extent {
  std::optional<Box> about{};  // m  its edges; none: these are not known
  double area;                 // m²
};
using ExtentAt = std::function<Extent(double t, double rows)>;

/// Whether a name is among those of fields, norms or quantities.
inline bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Rows of a plane flow that was computed in three dimensions, by slices of the slab that they fill, one spacing deep.
struct Slab {
  double layers = 1;         // its depth over the spacing
  std::vector<int> slice{};  // of each row, from 0 on; empty: all lie in a plane
  Scalars v{};               // m/s  across the plane; empty: there is none

  int slices() const { return slice.empty() ? 1 : 1 + std::ranges::max(slice); }
  /// Those of the rows' places that are in a slice: all of rows in a plane, else `kept`.
  const Vectors& in(int which, const Vectors& x, Vectors& kept) const;
  /// Those of the slice that holds most.
  const Vectors& in_the_fullest(const Vectors& x, Vectors& kept) const;
};

/// The particles of a file at a time, and what was read as what, line by line.
struct Reading {
  Samples samples{};
  Slab slab{};
  std::vector<std::string> fields{};  // "velocity", "pressure", ...: what was found; "particles": not cells of a mesh
  std::string file{};                 // in words
  std::vector<std::string> words{};
  bool has_volumes = true;     // else densities are the fluid's and masses equal
  std::string fits_with{};     // "; they fit with ...": what puts rows that are elsewhere where the fluid is
  Vec2 beside = Vec2::Zero();  // m  by which rows that span a periodic box lie beside it
  std::string put_right{};     // " --origin ...", so that they lie in it
};

/// `density` [kg/m³] is that of the fluid at rest. Where the user names a field "fraction", volumes are multiplied by
/// it: in a cell at a surface, that of its fluid counts. A cloud that is not flat is a slab, by its spacing [m] if that
/// is said. Throws Unreadable: no places, two candidates for one field, a slab of which two planes, or none, may be
/// that of the flow, rows outside the domain or that fill several periods, what is not a finite number, no time, a
/// fraction that is not above zero or is of no volume, a velocity without its component along the flow's x. One without
/// the other has that alone. `fluid_at` says where all of it is at a time, of rows that are so many; where it is empty,
/// it fills the domain.
Reading reading_of(const Dataset& data, const Mapping& mapping, const Domain& domain, double density,
                   const ExtentAt& fluid_at = {}, std::optional<double> spacing = std::nullopt);

}  // namespace touchstone::vnv::doors
