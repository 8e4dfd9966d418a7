#pragma once
/// What a VTK file holds, as datasets: its points, and its cells with centres and volumes.

#include <cstdint>
#include <string>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors::vtk {

/// Cells of one piece: corners of cell i are numbers of points of the piece, at [ends[i - 1], ends[i]).
struct Cells {
  std::vector<std::uint8_t> kinds{};  // VTK's numbers of them
  std::vector<std::int64_t> corners{}, ends{};
  std::vector<std::int64_t> faces{}, face_ends{};  // of polyhedra of XML files: how many faces, corners of each
};

inline constexpr std::uint8_t poly_vertex = 2, poly_line = 4, triangle_strip = 6, polygon = 7, polyhedron = 42;

/// Are there cells of an area or a volume?
bool is_mesh(const std::vector<std::uint8_t>& kinds);

/// Pieces put together, points and cells in their order.
struct VtkGrid {
  Array points{points_array, 3};
  std::vector<Array> of_points{}, of_cells{};
  std::vector<int> dimensions{};                                         // of each cell
  Array centres{cell_centres_array, 3}, volumes{cell_volumes_array, 1};  // of each cell
  std::optional<double> time{};

  /// Those of a piece whose points were added last, the first of them `first_point`. Throws Unreadable.
  void add_cells(const Cells& cells, std::size_t first_point, const std::string& where);
};

/// Particles, where the points have arrays or there is no mesh, then the mesh: its cells of most dimensions. Rows that
/// are marked as ghosts, which another piece owns, are left out. Throws Unreadable.
std::vector<Dataset> datasets_of(VtkGrid grid, const std::string& source, const std::string& format);

}  // namespace touchstone::vnv::doors::vtk
