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

/// The particles of a file at a time, and what was read as what, line by line.
struct Reading {
  Samples samples{};
  std::vector<std::string> fields{};  // "velocity", "pressure", ...: what was found; "particles": not cells of a mesh
  std::string file{};                 // in words
  std::vector<std::string> words{};
  bool has_volumes = true;     // else densities are the fluid's and masses equal
  std::string fits_with{};     // "; they fit with ...": what puts rows that are elsewhere where the fluid is
  Vec2 beside = Vec2::Zero();  // m  by which rows that span a periodic box lie beside it
  std::string put_right{};     // " --origin ...", so that they lie in it
};

/// `density` [kg/m³] is that of the fluid at rest. Where the user names a field "fraction", volumes are multiplied by
/// it: in a cell at a surface, that of its fluid counts. Throws Unreadable: no places, two candidates for one field, a
/// cloud that is not flat, rows outside the domain or that fill several periods, what is not a finite number, no time,
/// a fraction that is not above zero or is of no volume, a velocity without its component along the flow's x. One
/// without the other has that alone.
/// `fluid_at` says where all of it is at a time, of rows that are so many; where it is empty, it fills the domain.
Reading reading_of(const Dataset& data, const Mapping& mapping, const Domain& domain, double density,
                   const ExtentAt& fluid_at = {});

}  // namespace touchstone::vnv::doors
