/// VTK's files of XML: particles and meshes (.vtp, .vtu), those in pieces (.pvtp, .pvtu), and trees of them (.vtm).
/// Points first, then cells. Of a tree that has a dataset "internal", as OpenFOAM's foamToVTK writes, that one only:
/// the others bound it.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/vtk_files.hpp"
#include "vnv/doors/read/parts/vtk_grid.hpp"
#include "vnv/doors/read/parts/vtk_xml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace touchstone::vnv::doors::vtk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_arrays = 1000;  // of points or of cells

/// Pieces of one file or several, put together.
class Pieces {
 public:
  explicit Pieces(const Limits& limits) : limits_(limits) {}

  /// Of all files this comes before the first is added, so that each array is as long as it gets from its beginning.
  void expect(const XmlFile& file) {
    bytes_ += file.size();
    for (const pugi::xml_node& piece : file.root().child(std::string(file.type()).c_str()).children("Piece")) {
      points_ += file.count(piece, "NumberOfPoints", true);
      for (const char* of : {"NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfPolys", "NumberOfStrips"})
        cells_ += file.count(piece, of, true);
    }
  }

  void add(XmlFile& file) {
    const std::string type(file.type());
    if (!grid_.time) grid_.time = file.time();
    for (const pugi::xml_node& piece : file.root().child(type.c_str()).children("Piece")) {
      if (encoding_.empty()) encoding_ = file.encoding(piece);
      add_piece(file, piece);
    }
  }

  std::vector<Dataset> datasets(const fs::path& file, const std::string& kind) && {
    return datasets_of(std::move(grid_), file.filename().string(), fmt::format("{}, {}", kind, encoding_));
  }

 private:
  void add_piece(XmlFile& file, const pugi::xml_node& piece) {
    const std::size_t points = file.count(piece, "NumberOfPoints"), first_point = grid_.points.rows();
    if (points == 0) return;
    add_points(file, piece, points);
    add_arrays(file, piece.child("PointData"), points, points_, grid_.of_points);
    const bool has_arrays = piece.child("CellData").child("DataArray");
    Cells cells = file.type() == "PolyData" ? cells_of_poly_data(file, piece, has_arrays)
                                            : cells_of_grid(file, piece, has_arrays);
    add_arrays(file, piece.child("CellData"), cells.kinds.size(), cells_, grid_.of_cells);
    if (has_arrays || is_mesh(cells.kinds)) grid_.add_cells(cells, first_point, file.name() + ": cells");
  }

  void add_points(XmlFile& file, const pugi::xml_node& piece, std::size_t points) {
    pugi::xml_node array = piece.child("Points").child("DataArray");
    if (!array) refuse(file.name(), "no Points in a Piece, expected an array of 3 components");
    if (!array.attribute("NumberOfComponents")) array.append_attribute("NumberOfComponents") = 3;
    if (file.components(array) != 3)
      refuse(file.name() + ": Points", fmt::format("'{}' components, expected 3", file.components(array)));
    if (grid_.points.values.empty()) reserve(points_, 3, grid_.points.values);
    file.append(array, points, grid_.points.values);
  }

  /// Space for all pieces, as they claim, but in all no more than a number for each byte.
  void reserve(std::size_t rows, std::size_t components, std::vector<double>& values) {
    const std::size_t numbers = components == 0 || rows > bytes_ / components ? bytes_ : rows * components;
    reserve_more(values, numbers);
    bytes_ -= numbers;
  }

  /// Of each name one array, whose pieces follow each other.
  void add_arrays(XmlFile& file, const pugi::xml_node& data, std::size_t rows, std::size_t rows_of_all,
                  std::vector<Array>& arrays) {
    for (const pugi::xml_node& array : data.children("DataArray")) {
      const std::string name = array.attribute("Name").value();
      const std::size_t components = file.components(array);
      auto known = std::find_if(arrays.begin(), arrays.end(), [&](const Array& a) { return a.name == name; });
      if (known == arrays.end() && arrays.size() == most_arrays)
        refuse(file.name(), fmt::format("expected no more than {} arrays", most_arrays));
      if (known == arrays.end()) {
        known = arrays.insert(
            known, {.name = name, .components = static_cast<int>(std::min(components, limits_.most_components))});
        reserve(rows_of_all, components, known->values);
      } else if (std::cmp_not_equal(known->components, components)) {
        refuse(file.name(), fmt::format("array '{}' of '{}' components, expected {} as before", name, components,
                                        known->components));
      }
      file.append(array, rows, known->values);
    }
  }

  pugi::xml_node array_named(const XmlFile& file, const pugi::xml_node& cells, const char* name) {
    const pugi::xml_node array = cells.find_child_by_attribute("DataArray", "Name", name);
    if (!array)
      refuse(fmt::format("{}: {}", file.name(), cells.name()[0] ? cells.name() : "Cells"),
             fmt::format("no array '{}', expected one", name));
    if (file.components(array) != 1)
      refuse(file.name(), fmt::format("array '{}' of '{}' components, expected 1", name, file.components(array)));
    return array;
  }

  /// Appends to the cells `count` more.
  void append_cells(XmlFile& file, const pugi::xml_node& element, std::size_t count, Cells& cells) {
    const std::size_t before = cells.corners.size(), known = cells.ends.size();
    file.append(array_named(file, element, "offsets"), count, cells.ends);
    const std::int64_t corners = count ? cells.ends.back() : 0;
    if (corners < 0) refuse(file.name() + ": offsets", fmt::format("'{}', expected a whole number from 0", corners));
    file.append(array_named(file, element, "connectivity"), static_cast<std::size_t>(corners), cells.corners);
    for (std::size_t i = known; i < cells.ends.size(); ++i) {
      if (cells.ends[i] < 0 || cells.ends[i] > corners)
        refuse(file.name() + ": offsets", fmt::format("'{}', expected one from 0 to {}", cells.ends[i], corners));
      cells.ends[i] += static_cast<std::int64_t>(before);
    }
  }

  /// In the order of their arrays. Vertices need not be read where they have none.
  Cells cells_of_poly_data(XmlFile& file, const pugi::xml_node& piece, bool have_arrays) {
    struct Part {
      const char *element, *count;
      std::uint8_t kind;
    };
    constexpr std::array<Part, 4> parts = {{{"Verts", "NumberOfVerts", poly_vertex},
                                            {"Lines", "NumberOfLines", poly_line},
                                            {"Polys", "NumberOfPolys", polygon},
                                            {"Strips", "NumberOfStrips", triangle_strip}}};
    Cells cells;
    if (!have_arrays && file.count(piece, "NumberOfPolys", true) == 0 && file.count(piece, "NumberOfStrips", true) == 0)
      return cells;
    for (const auto& [element, attribute, kind] : parts) {
      const std::size_t count = file.count(piece, attribute, true);
      if (count == 0) continue;
      append_cells(file, piece.child(element), count, cells);
      cells.kinds.resize(cells.ends.size(), kind);
    }
    return cells;
  }

  Cells cells_of_grid(XmlFile& file, const pugi::xml_node& piece, bool have_arrays) {
    const std::size_t count = file.count(piece, "NumberOfCells");
    const pugi::xml_node element = piece.child("Cells");
    Cells cells;
    if (count == 0) return cells;
    file.append(array_named(file, element, "types"), count, cells.kinds);
    if (!have_arrays && !is_mesh(cells.kinds)) return cells;
    append_cells(file, element, count, cells);
    if (std::find(cells.kinds.begin(), cells.kinds.end(), polyhedron) == cells.kinds.end()) return cells;
    file.append(array_named(file, element, "faceoffsets"), count, cells.face_ends);
    const std::int64_t faces = *std::max_element(cells.face_ends.begin(), cells.face_ends.end());
    file.append(array_named(file, element, "faces"), static_cast<std::size_t>(std::max(faces, std::int64_t{0})),
                cells.faces);
    return cells;
  }

  Limits limits_;
  std::size_t points_ = 0, cells_ = 0;  // of all pieces
  std::size_t bytes_ = 0;               // of all files, for which no space is reserved yet
  VtkGrid grid_{};
  std::string encoding_ = {};
};

bool is_dataset(std::string_view type) { return type == "PolyData" || type == "UnstructuredGrid"; }
std::string kind_of(std::string_view type) { return type == "PolyData" ? "VTP" : "VTU"; }

/// Of PPolyData and PUnstructuredGrid.
std::vector<Dataset> read_parallel(const fs::path& path, XmlFile& file, const Limits& limits, FilesBeside& files) {
  const std::string type(file.type());
  Pieces pieces(limits);
  std::deque<FilesBeside::Named> all;
  std::deque<XmlFile> parts;
  for (const pugi::xml_node& piece : file.root().child(type.c_str()).children("Piece")) {
    const FilesBeside::Named& named = all.emplace_back(files.read(path, piece.attribute("Source").value()));
    const XmlFile& part = parts.emplace_back(named.file.string(), named.bytes, limits);
    if (part.type() != type.substr(1))
      refuse(part.name(), fmt::format("type '{:.40}', expected {}", part.type(), type.substr(1)));
    pieces.expect(part);
  }
  for (XmlFile& part : parts) pieces.add(part);
  std::vector<Dataset> datasets = std::move(pieces).datasets(path, "P" + kind_of(type.substr(1)));
  if (const std::optional<double> time = file.time())
    for (Dataset& dataset : datasets) dataset.time = time;
  return datasets;
}

std::vector<Dataset> read_leaf(const fs::path& path, XmlFile& file, const Limits& limits, FilesBeside& files) {
  const std::string type(file.type());
  if (type.starts_with('P') && is_dataset(type.substr(1))) return read_parallel(path, file, limits, files);
  if (!is_dataset(type))
    refuse(file.name(),
           fmt::format("type '{:.40}', expected PolyData, UnstructuredGrid or their parallel forms", type));
  Pieces pieces(limits);
  pieces.expect(file);
  pieces.add(file);
  return std::move(pieces).datasets(path, kind_of(type));
}

std::vector<Dataset> read_tree(const fs::path& path, XmlFile& file, const Limits& limits, FilesBeside& files) {
  struct Leaves : pugi::xml_tree_walker {
    std::vector<pugi::xml_node> found{};
    bool for_each(pugi::xml_node& node) override {
      if (std::string_view(node.name()) == "DataSet" && node.attribute("file")) found.push_back(node);
      return true;
    }
  } leaves;
  file.root().traverse(leaves);
  const auto is_internal = [](const pugi::xml_node& leaf) {
    return std::string_view(leaf.attribute("name").value()) == "internal";
  };
  const auto internal = std::find_if(leaves.found.begin(), leaves.found.end(), is_internal);
  if (internal != leaves.found.end()) leaves.found = std::vector{*internal};
  if (leaves.found.size() > limits.most_datasets)
    refuse(file.name(), fmt::format("'{}' files, expected no more than {}", leaves.found.size(), limits.most_datasets));
  const std::optional<double> time = file.time();
  std::vector<Dataset> datasets;
  for (const pugi::xml_node& leaf : leaves.found) {
    const FilesBeside::Named named = files.read(path, leaf.attribute("file").value());
    XmlFile part(named.file.string(), named.bytes, limits);
    for (Dataset& dataset : read_leaf(named.file, part, limits, files)) {
      dataset.source = fmt::format("{}: {}", path.filename().string(), leaf.attribute("file").value());
      if (time) dataset.time = time;
      datasets.push_back(std::move(dataset));
    }
  }
  return datasets;
}

}  // namespace

std::vector<Dataset> read_xml(const fs::path& file, std::string_view bytes, const Limits& limits, FilesBeside& files) {
  XmlFile xml(file.string(), bytes, limits);
  std::vector<Dataset> datasets =
      xml.type() == "vtkMultiBlockDataSet" ? read_tree(file, xml, limits, files) : read_leaf(file, xml, limits, files);
  for (Dataset& dataset : datasets) dataset.index = number_of(file);
  return datasets;
}

}  // namespace touchstone::vnv::doors::vtk

namespace touchstone::vnv::doors::formats {

Format vtk_xml() {
  return {
      .words = "VTP, VTU",
      .place = 10,
      .endings = {".vtp", ".vtu", ".pvtp", ".pvtu", ".vtm"},
      .is_it = [](const std::filesystem::path&,
                  std::string_view head) { return head.starts_with("<?xml") || head.find("<VTKFile") != head.npos; },
      .read =
          [](const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
            FilesBeside files(file, limits);
            return vtk::read_xml(file, bytes, limits, files);
          }};
}

}  // namespace touchstone::vnv::doors::formats
