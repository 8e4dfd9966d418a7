#include "vnv/doors/read/parts/vtk_grid.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors::vtk {
namespace {

using Corners = std::span<const std::int64_t>;
using Point = Eigen::Vector3d;

struct Shape {
  int dimension;
  std::size_t corners;  // 0: as many as there are, `fewest` or more
  std::size_t fewest;
};

std::optional<Shape> shape_of(std::uint8_t kind) {
  constexpr std::array<Shape, 15> shapes{{
      {0, 0, 0},  // nothing
      {0, 1, 1},  // vertex
      {0, 0, 1},  // vertices
      {1, 2, 2},  // line
      {1, 0, 2},  // lines
      {2, 3, 3},  // triangle
      {2, 0, 3},  // strip of triangles
      {2, 0, 3},  // polygon
      {2, 4, 4},  // pixel
      {2, 4, 4},  // quadrilateral
      {3, 4, 4},  // tetrahedron
      {3, 8, 8},  // voxel
      {3, 8, 8},  // hexahedron
      {3, 6, 6},  // wedge
      {3, 5, 5},  // pyramid
  }};
  if (kind == polyhedron) return Shape{3, 0, 4};
  return kind < shapes.size() ? std::optional(shapes[kind]) : std::nullopt;
}

using Faces = std::vector<std::vector<int>>;

const Faces& faces_of(std::uint8_t kind) {
  static const Faces tetrahedron = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}},
                     voxel = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}},
                     hexahedron = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
                     wedge = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}},
                     pyramid = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return kind == 10 ? tetrahedron : kind == 11 ? voxel : kind == 12 ? hexahedron : kind == 13 ? wedge : pyramid;
}

/// Of a polygon, in a plane or nearly so: triangles about the mean of its corners.
struct Facet {
  Point centre, area;
};

Facet facet_of(std::span<const Point> corners) {
  Point mean = Point::Zero(), area = Point::Zero(), moment = Point::Zero();
  for (const Point& corner : corners) mean += corner;
  mean /= static_cast<double>(corners.size());
  const auto triangle = [&](std::size_t i) -> Point {
    return 0.5 * (corners[i] - mean).cross(corners[(i + 1) % corners.size()] - mean);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) area += triangle(i);
  const double size = area.norm();
  if (!(size > 0)) return {mean, area};
  for (std::size_t i = 0; i < corners.size(); ++i)
    moment += triangle(i).dot(area) / size * (corners[i] + corners[(i + 1) % corners.size()] - 2 * mean) / 3;
  return {mean + moment / size, area};
}

struct Measured {
  Point centre = Point::Zero();
  double volume = 0;
};

/// Parts weighted by their sizes; their plain mean where those are nought.
Measured together(std::span<const Measured> parts) {
  Point mean = Point::Zero(), moment = Point::Zero();
  double volume = 0;
  for (const Measured& part : parts) mean += part.centre / static_cast<double>(parts.size());
  for (const Measured& part : parts) volume += part.volume;
  for (const Measured& part : parts) moment += part.volume * (part.centre - mean);
  return {volume > 0 ? Point(mean + moment / volume) : mean, volume};
}

/// Pyramids from the faces to the mean of their centres, which lies inside of what is convex.
Measured body_of(std::span<const Facet> facets) {
  Point inside = Point::Zero();
  for (const Facet& facet : facets) inside += facet.centre / static_cast<double>(facets.size());
  std::vector<Measured> pyramids;
  for (const Facet& facet : facets)
    pyramids.push_back({inside + 0.75 * (facet.centre - inside), std::abs(facet.area.dot(facet.centre - inside)) / 3});
  return together(pyramids);
}

/// Measures the cells of one piece.
class Measuring {
 public:
  Measuring(std::span<const double> points, const std::string& where) : points_(points), where_(where) {}

  Measured measure(std::uint8_t kind, Corners corners) {
    if (kind == triangle_strip) {
      std::vector<Measured> triangles;
      for (std::size_t i = 0; i + 2 < corners.size(); ++i) triangles.push_back(flat(places(corners.subspan(i, 3))));
      return together(triangles);
    }
    if (kind == 8) return flat(places(std::array{corners[0], corners[1], corners[3], corners[2]}));
    const int dimension = shape_of(kind)->dimension;
    if (dimension == 2) return flat(places(corners));
    if (dimension < 2) return mean(places(corners));
    std::vector<Facet> facets;
    for (const std::vector<int>& face : faces_of(kind)) {
      std::vector<std::int64_t> of_face;
      for (const int i : face) of_face.push_back(corners[i]);
      facets.push_back(facet_of(places(of_face)));
    }
    return body_of(facets);
  }

  /// Of a polyhedron: how many faces, and of each how many corners and which.
  Measured measure_polyhedron(Corners stream) {
    const auto next = [&](std::int64_t most) {
      if (stream.empty()) refuse(where_, "a polyhedron ends within its faces, expected the corners of each");
      const std::int64_t number = stream.front();
      if (number < 0 || number > most)
        refuse(where_,
               fmt::format("a polyhedron of '{}' faces or corners of one, expected no more than {}", number, most));
      stream = stream.subspan(1);
      return static_cast<std::size_t>(number);
    };
    std::vector<Facet> facets;
    for (std::size_t faces = next(std::ssize(stream)); faces > 0; --faces) {
      const std::size_t corners = next(std::ssize(stream) - 1);
      if (corners < 3) refuse(where_, fmt::format("a face of '{}' corners, expected 3 or more", corners));
      facets.push_back(facet_of(places(stream.first(corners))));
      stream = stream.subspan(corners);
    }
    if (facets.empty() || !stream.empty())
      refuse(where_, "a polyhedron of other faces than it says, expected their corners and no more");
    return body_of(facets);
  }

 private:
  static Measured flat(std::span<const Point> corners) {
    const Facet facet = facet_of(corners);
    return {facet.centre, facet.area.norm()};
  }
  static Measured mean(std::span<const Point> corners) {
    Measured measured;
    for (const Point& corner : corners) measured.centre += corner;
    if (corners.size() > 1) measured.centre /= static_cast<double>(corners.size());
    return measured;
  }
  std::span<const Point> places(Corners corners) {
    places_.clear();
    for (const std::int64_t corner : corners) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= points_.size() / 3)
        refuse(where_, fmt::format("corner '{}', expected a point from 0 to {}", corner, std::ssize(points_) / 3 - 1));
      places_.emplace_back(points_.data() + 3 * corner);
    }
    return places_;
  }

  std::span<const double> points_;
  const std::string& where_;
  std::vector<Point> places_{};
};

/// [from, to) of a list whose parts end there.
Corners part_of(const std::vector<std::int64_t>& list, std::int64_t from, std::int64_t to, const std::string& where) {
  if (from < 0 || to < from || to > std::ssize(list))
    refuse(where, fmt::format("offset '{}', expected one from {} to {}", to, from, list.size()));
  return Corners(list).subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from));
}

/// Leaves out ghosts, and of cells those of fewer dimensions.
Dataset dataset_of(std::vector<Array> arrays, const std::string& source, std::vector<bool> kept) {
  require_equal_rows(arrays, source);
  kept.resize(arrays.front().rows(), true);
  const auto ghosts = std::find_if(arrays.begin(), arrays.end(),
                                   [](const Array& a) { return a.name == "vtkGhostType" && a.components == 1; });
  if (ghosts != arrays.end()) {
    for (std::size_t row = 0; row < kept.size(); ++row) kept[row] = kept[row] && ghosts->values[row] == 0;
    arrays.erase(ghosts);
  }
  if (std::find(kept.begin(), kept.end(), false) != kept.end())
    for (Array& array : arrays) keep_rows(array, kept);
  return {.source = source, .arrays = std::move(arrays)};
}

/// The depth of a mesh along each axis at whose two ends all its points stand, so that it is one layer; else 0.
std::array<double, 3> layer_of(const std::vector<double>& points) {
  std::array<double, 3> layer{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY, off = 0;
    for (std::size_t i = axis; i < points.size(); i += 3) {
      low = std::min(low, points[i]);
      high = std::max(high, points[i]);
    }
    for (std::size_t i = axis; i < points.size(); i += 3)
      off = std::max(off, std::min(points[i] - low, high - points[i]));
    constexpr double rounding = 1e-4;  // of places in single precision, of the depth
    if (off <= rounding * (high - low)) layer[axis] = high - low;
  }
  return layer;
}

std::vector<Array> joined(std::vector<Array> first, std::vector<Array> second) {
  std::move(second.begin(), second.end(), std::back_inserter(first));
  return first;
}

std::vector<Array> before(std::vector<Array> others, Array first) {
  others.insert(others.begin(), std::move(first));
  return others;
}

}  // namespace

bool is_mesh(const std::vector<std::uint8_t>& kinds) {
  return std::any_of(kinds.begin(), kinds.end(), [](std::uint8_t kind) { return kind > poly_line; });
}

void VtkGrid::add_cells(const Cells& cells, std::size_t first_point, const std::string& where) {
  if (cells.ends.size() != cells.kinds.size())
    refuse(where, fmt::format("'{}' offsets, expected {}, one a cell", cells.ends.size(), cells.kinds.size()));
  Measuring measuring(std::span<const double>(points.values).subspan(3 * first_point), where);
  std::int64_t first = 0, first_face = 0;
  reserve_more(dimensions, cells.kinds.size());
  reserve_more(centres.values, 3 * cells.kinds.size());
  reserve_more(volumes.values, cells.kinds.size());
  for (std::size_t i = 0; i < cells.kinds.size(); ++i) {
    const std::uint8_t kind = cells.kinds[i];
    const std::optional<Shape> shape = shape_of(kind);
    if (!shape) refuse(where, fmt::format("cell type '{}', expected VTK's 0 to 14 or 42", kind));
    const Corners corners = part_of(cells.corners, first, cells.ends[i], where);
    if (shape->corners ? corners.size() != shape->corners : corners.size() < shape->fewest)
      refuse(where,
             fmt::format("cell {} of type {} with '{}' corners, expected {}", i, kind, corners.size(), shape->fewest));
    first = cells.ends[i];
    Measured measured;
    if (kind == polyhedron && i < cells.face_ends.size()) {
      measured = measuring.measure_polyhedron(part_of(cells.faces, first_face, cells.face_ends[i], where));
      first_face = cells.face_ends[i];
    } else if (kind == polyhedron) {
      measured = measuring.measure_polyhedron(corners);
    } else {
      measured = measuring.measure(kind, corners);
    }
    dimensions.push_back(shape->dimension);
    centres.values.insert(centres.values.end(), measured.centre.begin(), measured.centre.end());
    volumes.values.push_back(measured.volume);
  }
}

std::vector<Dataset> datasets_of(VtkGrid grid, const std::string& source, const std::string& format) {
  const int most = grid.dimensions.empty() ? 0 : *std::max_element(grid.dimensions.begin(), grid.dimensions.end());
  const std::array<double, 3> layer = most == 3 ? layer_of(grid.points.values) : std::array<double, 3>{};
  std::vector<Dataset> datasets;
  const bool points_are_cells = most == 0 && grid.centres.values == grid.points.values;
  if (points_are_cells) grid.of_points = joined(std::move(grid.of_points), std::exchange(grid.of_cells, {}));
  if (most < 2 || !grid.of_points.empty())
    datasets.push_back(dataset_of(before(std::move(grid.of_points), std::move(grid.points)), source, {}));
  if (most >= 2) {
    std::vector<bool> kept;
    for (const int dimension : grid.dimensions) kept.push_back(dimension == most);
    datasets.push_back(dataset_of(
        before(before(std::move(grid.of_cells), std::move(grid.volumes)), std::move(grid.centres)), source, kept));
    datasets.back().rows_are = Rows::cells;
    datasets.back().cell_dimensions = most;
    datasets.back().layer = layer;
  } else if (most == 0 && !grid.of_cells.empty()) {
    grid.centres.name = points_array;
    datasets.push_back(dataset_of(before(std::move(grid.of_cells), std::move(grid.centres)), source, {}));
  }
  for (Dataset& dataset : datasets) {
    dataset.format = format;
    dataset.time = grid.time;
  }
  return datasets;
}

}  // namespace touchstone::vnv::doors::vtk
