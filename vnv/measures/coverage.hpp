#pragma once
/// Whether all the fluid is there: holes, rows that are crowded or in the same place, and places of a grid that are
/// empty. Nothing of it knows a method: rows may be particles, nodes or centres of cells.

#include "solvers/samples.hpp"
#include "solvers/scene.hpp"
#include "vnv/case.hpp"

#include <functional>
#include <string>

namespace touchstone::vnv {

/// Where fluid is.
struct Region {
  Domain domain{};       // periodic where its axes are
  Box box = domain.box;  // m  that the fluid fills, at most all of the domain
  std::function<double(const Vec2& x)>
      depth{};           // m  below its surface, negative outside; empty: the fluid fills the box
  bool is_known = true;  // else holes cannot be told from what is outside the fluid
  Vec2 drawn = Vec2::Ones();  // by how much it has drawn the lines of a lattice apart along each axis
};

/// What is found of rows in a region.
struct Coverage {
  double hole = not_a_number;  // spacings  diameter of the largest circle about a place in the region with no row in it,
                               // less where the rows about it are pressed together
  Vec2 hole_at = Vec2::Zero();  // m  its centre
  long in_one_place = 0;        // rows that stand where another one stands
  Vec2 in_one_place_at = Vec2::Zero();
  double crowded = 0;  // fraction of the rows that are much nearer to another than to most
  Vec2 crowded_at = Vec2::Zero();
  long grid_places = 0;   // of the upright grid on which the rows stand; 0: on none
  long empty_places = 0;  // of these
  Vec2 empty_at = Vec2::Zero();
};

/// Of at least one row. `spacing` [m] is the root of the area that one of them stands for. It takes time in proportion
/// to the number of rows.
///
/// A circle may reach beyond the region by half a spacing, as cells do that leave out nothing. It is found to a
/// hundredth if it is wider than 2.83 spacings, as then a cell of one spacing in it is empty, and to a spacing if it is
/// wider than 16; a narrower one is the largest of some. A flow that strains draws rows apart, however well they follow
/// it, and presses them together across: at a distance s of neighbours the lines of a lattice are 1 / s apart, 4 to 5
/// spacings in the manufactured solution after 0.2 s. Where rows about a circle are as many as they should be, and half
/// of them have another one nearer than 0.75 spacings, on a line and not all around, it is counted in that distance over
/// 0.75.
/// Where no circle is a hole, a strip along an axis from one side of the region to the other, as rows along a wall leave
/// that are missing, counts as the circle of the area by which it is wider than the lines of a lattice are apart.
///
/// Two rows are in one place if they are nearer than 1e-6 spacings, unless that place is on a periodic boundary, where a
/// grid has its nodes twice. A row is crowded if the nearest other one is nearer than a quarter of a spacing and of the
/// distance to the fourth, which those of a graded mesh are not.
///
/// Rows stand on an upright grid if they take at least four fifths of its places. A grid may be stretched and graded:
/// its hole is the widest gap between two lines, or between a line and a wall, by the wider of those beside it, times
/// the square root of 2 for the diagonal.
Coverage coverage_of(const Vectors& x, double spacing, const Region& region);

/// The largest hole [spacings] that a sound cloud of so many rows may have: of N points at random, which have the least
/// order of all, one of twenty sets has a wider one. A circle of the area A spacings² is free of them with probability
/// exp(-A), and N A such circles are independent, so that 0.05 = N A exp(-A). At most 3.9, so that a hole 4 spacings wide
/// is seen in any cloud.
///
/// Measured, the largest of 20 seeds for 25, 225 and 3600 rows and of 3 for 90000: a lattice 1.41; each row moved by up
/// to a quarter of a spacing along both axes 1.79, 1.86, 1.85, 1.84; the same with 3 % of the rows
/// missing 2.38, 2.37, 2.50, 2.74; moved by up to half a spacing 2.17, 2.34, 2.36, 2.30; points at
/// random 2.9, 3.8, 4.1, 4.8, which no fluid are. The limit: 3.26, 3.71, 3.9, 3.9.
double largest_sound_hole(double rows);

/// The largest fraction of crowded rows in a sound cloud: 0.25, and what chance does to few. Points at random have
/// 0.14, up to 0.36 of 25 rows and 0.16 of 3600; moved by up to half a spacing 0.16 and 0.05, by a quarter none;
/// pairs 1.
double most_crowded(double rows);

/// The widest gap of a grid over the wider one beside it: 1.37 between Gauss points, 1 from a node to a wall without
/// nodes; a line that is missing makes it 2, at a wall 1.5.
inline constexpr double widest_sound_gap = 1.45;

// What is claimed of them. Rows are counted: that does not say how right a method is.
inline const Quantity largest_hole{"largest hole", "spacings", Kind::invariant, Better::smaller},
    rows_in_one_place{"rows in the place of another", "", Kind::count, Better::smaller},
    rows_crowded{"rows crowded", "%", Kind::count, Better::smaller},
    empty_places_of_grid{"empty places of the grid", "", Kind::count, Better::smaller};

/// What a coverage says at a time: holes of rows that stand on no grid, or empty places and gaps of the grid.
std::vector<Value> values_of(const Coverage& coverage, const Level& level, double time);

/// That the fluid fills its region, of any method, whose rows are so many.
std::vector<Claim> fills_its_region(const Coverage& coverage, double rows);

/// Where that is which a quantity speaks of: "about (0.25, 0.4) m"; empty for another.
std::string where_is(const Coverage& coverage, const std::string& quantity);

/// Whether the fluid of a run of our own fills its domain, so that its holes are known.
bool fills_its_domain(const Level& level, const Run& run);

/// The worst of all times of a run of our own: holes where the fluid fills its domain, rows that are crowded or in one
/// place wherever it is; at its end. Nothing of a run that is of no simulation, or has not reached its end.
std::vector<Value> coverage_of(const Level& level, const Run& run);

/// Whether a quantity is one of those above, which theory limits and no baseline.
bool is_of_coverage(const std::string& quantity);

/// What is claimed of one of them, of any method with so many rows.
Claim claim_of_coverage(const Quantity& quantity, double rows);

}  // namespace touchstone::vnv
