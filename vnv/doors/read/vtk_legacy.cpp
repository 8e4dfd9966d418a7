/// VTK's older files, "# vtk DataFile Version 1.0" to 5.1, of text or of bytes. Points first, then cells; of structured
/// grids the points.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/numbers.hpp"
#include "vnv/doors/read/parts/vtk_files.hpp"
#include "vnv/doors/read/parts/vtk_grid.hpp"

#include <fmt/format.h>

#include <utility>

namespace touchstone::vnv::doors::vtk {
namespace {

std::optional<Type> legacy_type(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Type>, 16> types = {{{"char", Type::int8},
                                                                        {"signed_char", Type::int8},
                                                                        {"unsigned_char", Type::uint8},
                                                                        {"short", Type::int16},
                                                                        {"unsigned_short", Type::uint16},
                                                                        {"int", Type::int32},
                                                                        {"vtkIdType", Type::int32},
                                                                        {"vtkidtype", Type::int32},
                                                                        {"unsigned_int", Type::uint32},
                                                                        {"long", Type::int64},
                                                                        {"vtktypeint64", Type::int64},
                                                                        {"unsigned_long", Type::uint64},
                                                                        {"vtktypeuint64", Type::uint64},
                                                                        {"float", Type::float32},
                                                                        {"double", Type::float64},
                                                                        {"long_long", Type::int64}}};
  for (const auto& [known, type] : types)
    if (known == name) return type;
  return {};
}

/// "wide%20name" is "wide name".
std::string decoded(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    int code = 0;
    const std::string_view digits = name[i] == '%' ? name.substr(i + 1, 2) : "";
    const bool is_code =
        digits.size() == 2 && std::from_chars(digits.data(), digits.data() + 2, code, 16).ptr == digits.data() + 2;
    text += is_code ? static_cast<char>(code) : name[i];
    if (is_code) i += 2;
  }
  return text;
}

class Legacy {
 public:
  Legacy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits)
      : file_(file.string()), rest_(bytes), budget_(limits) {
    if (bytes.size() > limits.most_bytes)
      refuse(file_, fmt::format("'{}' bytes, expected no more than {}", bytes.size(), limits.most_bytes));
    if (!next_line().starts_with(legacy_begins))
      refuse(file_, fmt::format("expected '{}' in its first line", legacy_begins));
    next_line();  // its title
    const std::string kind = word();
    if (kind != "ASCII" && kind != "BINARY") refuse(file_, fmt::format("'{:.40}', expected ASCII or BINARY", kind));
    is_text_ = kind == "ASCII";
    while (true) {
      const std::string keyword = word();
      if (keyword.empty()) break;
      read(keyword);
    }
    if (dataset_.empty()) refuse(file_, "no DATASET, expected POLYDATA, UNSTRUCTURED_GRID or a structured one");
    place_points();
  }

  std::vector<Dataset> datasets(const std::string& source) && {
    if (cells_.kinds.empty() && !cells_.ends.empty()) refuse(file_, "no CELL_TYPES, expected one of each cell");
    if (!grid_.of_cells.empty() || is_mesh(cells_.kinds)) grid_.add_cells(cells_, 0, file_ + ": cells");
    return datasets_of(std::move(grid_), source, is_text_ ? "legacy VTK, text" : "legacy VTK, binary");
  }

 private:
  enum class Of { fields, points, cells };

  std::string_view next_line() { return doors::next_line(rest_); }
  std::string word() { return std::string(next_word(rest_)); }
  std::size_t count(const std::string& keyword) { return whole_number(next_word(rest_), file_ + ": " + keyword); }
  Type type(const std::string& keyword) {
    const std::string name = word();
    const std::optional<Type> known = legacy_type(name);
    if (!known)
      refuse(file_ + ": " + keyword,
             fmt::format("type '{:.40}', expected char to vtktypeuint64, float or double", name));
    return *known;
  }
  bool next_is(std::string_view expected) const {
    std::string_view after = rest_;
    return next_word(after) == expected;
  }

  /// What follows the line: numbers as text, or as bytes, big end first.
  template <class To>
  void numbers(std::size_t rows, std::size_t components, Type kind, const std::string& keyword, std::vector<To>& to) {
    const std::string where = file_ + ": " + keyword;
    const std::size_t numbers = budget_.take(rows, components, where);
    if (std::is_integral_v<To> && !is_whole(kind)) refuse(where, "numbers with fractions, expected whole numbers");
    if (is_text_) return append_text(rest_, numbers, kind, where, to);
    next_line();
    const std::size_t size = numbers * bytes_of(kind);
    if (size > rest_.size())
      refuse(where,
             fmt::format("'{}' bytes, expected no more than the {} up to the end of the file", size, rest_.size()));
    append_bytes(rest_.substr(0, size), kind, std::endian::big, to);
    rest_.remove_prefix(size);
  }

  void read(const std::string& keyword) {
    if (keyword == "DATASET")
      dataset_ = word();
    else if (keyword == "METADATA")
      skip_metadata();
    else if (keyword == "FIELD")
      read_field();
    else if (keyword == "POINT_DATA")
      begin_data(Of::points);
    else if (keyword == "CELL_DATA")
      begin_data(Of::cells);
    else if (of_ == Of::fields)
      read_geometry(keyword);
    else
      read_attribute(keyword);
  }

  void read_geometry(const std::string& keyword) {
    if (keyword == "POINTS") {
      const std::size_t points = count(keyword);
      numbers(points, 3, type(keyword), keyword, grid_.points.values);
    } else if (keyword == "DIMENSIONS") {
      for (std::size_t& points : dimensions_) points = count(keyword);
    } else if (keyword == "ORIGIN" || keyword == "SPACING" || keyword == "ASPECT_RATIO") {
      std::vector<double> three;
      append_text(rest_, 3, Type::float64, file_ + ": " + keyword, three);
      std::copy(three.begin(), three.end(), (keyword == "ORIGIN" ? origin_ : spacing_).begin());
    } else if (keyword == "X_COORDINATES" || keyword == "Y_COORDINATES" || keyword == "Z_COORDINATES") {
      const std::size_t places = count(keyword);
      numbers(places, 1, type(keyword), keyword, axes_[keyword[0] - 'X']);
    } else if (keyword == "CELL_TYPES") {
      const std::size_t cells = count(keyword);
      std::vector<std::int64_t> kinds;
      numbers(cells, 1, Type::int32, keyword, kinds);
      for (const std::int64_t kind : kinds)
        cells_.kinds.push_back(static_cast<std::uint8_t>(std::clamp<std::int64_t>(kind, 0, 255)));
    } else if (keyword == "CELLS" || keyword == "VERTICES" || keyword == "LINES" || keyword == "POLYGONS" ||
               keyword == "TRIANGLE_STRIPS") {
      read_cells(keyword);
      const std::uint8_t kind = keyword == "VERTICES"   ? poly_vertex
                                : keyword == "LINES"    ? poly_line
                                : keyword == "POLYGONS" ? polygon
                                                        : triangle_strip;
      if (keyword != "CELLS") cells_.kinds.resize(cells_.ends.size(), kind);
    } else {
      refuse(file_, fmt::format("'{:.40}', expected POINTS, CELLS, POINT_DATA or the like", keyword));
    }
  }

  /// Before version 5 each cell begins with how many corners it has; later offsets, one more than cells, stand before.
  void read_cells(const std::string& keyword) {
    std::size_t cells = count(keyword);
    const std::size_t size = count(keyword), before = cells_.corners.size();
    if (next_is("OFFSETS")) {
      word();
      std::vector<std::int64_t> offsets;
      numbers(cells, 1, type("OFFSETS"), keyword + ": OFFSETS", offsets);
      if (next_is("METADATA")) word(), skip_metadata();
      if (word() != "CONNECTIVITY") refuse(file_ + ": " + keyword, "expected CONNECTIVITY");
      numbers(size, 1, type("CONNECTIVITY"), keyword + ": CONNECTIVITY", cells_.corners);
      for (std::size_t i = 1; i < offsets.size(); ++i) {
        if (offsets[i] < 0 || std::cmp_greater(offsets[i], size))
          refuse(file_ + ": " + keyword, fmt::format("offset '{}', expected one from 0 to {}", offsets[i], size));
        cells_.ends.push_back(static_cast<std::int64_t>(before) + offsets[i]);
      }
      return;
    }
    std::vector<std::int64_t> list;
    numbers(size, 1, Type::int32, keyword, list);
    const std::size_t likely = std::min(cells, list.size());  // a claim so far
    reserve_more(cells_.ends, likely);
    reserve_more(cells_.corners, list.size() - likely);
    for (std::size_t at = 0; cells > 0; --cells) {
      if (at == list.size() || list[at] < 0 || std::cmp_greater_equal(list[at], list.size() - at))
        refuse(file_ + ": " + keyword,
               fmt::format("'{}' numbers, expected corners of {} cells more", list.size(), cells));
      const auto corners = list.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      cells_.corners.insert(cells_.corners.end(), corners, corners + list[at]);
      at += 1 + static_cast<std::size_t>(list[at]);
      cells_.ends.push_back(std::ssize(cells_.corners));
    }
  }

  void begin_data(Of of) {
    of_ = of;
    rows_ = count(of == Of::points ? "POINT_DATA" : "CELL_DATA");
  }

  std::vector<double>& add_array(std::string_view name, std::size_t components) {
    std::vector<Array>& arrays = of_ == Of::points ? grid_.of_points : grid_.of_cells;
    arrays.push_back(
        {.name = decoded(name), .components = static_cast<int>(std::min<std::size_t>(components, 1 << 20))});
    return arrays.back().values;
  }

  void read_attribute(const std::string& keyword) {
    const std::string name = word();
    const std::string where = fmt::format("{} '{:.80}'", keyword, name);
    const auto read_array = [&](std::size_t components, Type kind) {
      numbers(rows_, components, kind, where, add_array(name, components));
    };
    const Type colour = is_text_ ? Type::float32 : Type::uint8;
    if (keyword == "SCALARS") {
      const Type kind = type(where);
      const std::string_view line = rest_.substr(0, rest_.find('\n'));
      std::string_view components = line;
      const std::string_view given = next_word(components);
      if (!given.empty()) next_word(rest_);
      if (next_is("LOOKUP_TABLE")) next_line(), next_word(rest_), next_word(rest_);
      read_array(given.empty() ? 1 : whole_number(given, file_ + ": " + where), kind);
    } else if (keyword == "VECTORS" || keyword == "NORMALS") {
      read_array(3, type(where));
    } else if (keyword == "TENSORS" || keyword == "TENSORS6") {
      read_array(keyword == "TENSORS" ? 9 : 6, type(where));
    } else if (keyword == "GLOBAL_IDS" || keyword == "PEDIGREE_IDS" || keyword == "EDGE_FLAGS") {
      read_array(1, type(where));
    } else if (keyword == "TEXTURE_COORDINATES") {
      const std::size_t components = count(where);
      read_array(components, type(where));
    } else if (keyword == "COLOR_SCALARS") {
      read_array(count(where), colour);
    } else if (keyword == "LOOKUP_TABLE") {  // colours, no data
      std::vector<double> colours;
      numbers(count(where), 4, colour, where, colours);
    } else {
      refuse(file_, fmt::format("'{:.40}', expected SCALARS, VECTORS, FIELD or the like", keyword));
    }
  }

  void read_field() {
    next_word(rest_);  // its name
    for (std::size_t arrays = count("FIELD"); arrays > 0; --arrays) {
      if (next_is("METADATA")) word(), skip_metadata();
      const std::string name = word(), where = fmt::format("FIELD '{:.80}'", name);
      if (name.empty()) refuse(file_, fmt::format("ends before its last '{}' arrays of FIELD, expected them", arrays));
      if (name == "NULL_ARRAY") continue;
      const std::size_t components = count(where), rows = count(where);
      const Type kind = type(where);
      if (of_ != Of::fields && rows != rows_)
        refuse(file_ + ": " + where, fmt::format("'{}' rows, expected {}", rows, rows_));
      std::vector<double> of_fields;
      numbers(rows, components, kind, where, of_ == Of::fields ? of_fields : add_array(name, components));
      const std::optional<int> rank = of_fields.size() == 1 ? rank_as_time(name) : std::nullopt;
      if (!rank || (time_rank_ && *time_rank_ <= *rank)) continue;
      grid_.time = time_of(of_fields[0], kind, file_ + ": " + where);
      time_rank_ = rank;
    }
  }

  /// Up to an empty line.
  void skip_metadata() {
    next_line();
    while (!rest_.empty() && !next_line().empty()) continue;
  }

  /// Of images and rectilinear grids, x fastest, once it is known that arrays of as many rows stand in the file.
  void place_points() {
    const bool is_image = dataset_ == "STRUCTURED_POINTS", is_rectilinear = dataset_ == "RECTILINEAR_GRID",
               is_grid = dataset_ == "STRUCTURED_GRID";
    if (!is_image && !is_rectilinear && !is_grid) {
      if (dataset_ != "POLYDATA" && dataset_ != "UNSTRUCTURED_GRID")
        refuse(
            file_ + ": DATASET",
            fmt::format(
                "'{:.40}', expected POLYDATA, UNSTRUCTURED_GRID, STRUCTURED_POINTS, RECTILINEAR_GRID or STRUCTURED_GRID",
                dataset_));
      return;
    }
    if (!grid_.of_cells.empty())
      refuse(file_ + ": CELL_DATA",
             fmt::format("'{}', expected POINT_DATA in a {}", grid_.of_cells.front().name, dataset_));
    if (is_grid) return;
    if (grid_.of_points.empty()) refuse(file_, fmt::format("expected arrays of POINT_DATA in a {}", dataset_));
    const auto& [nx, ny, nz] = dimensions_;
    const std::size_t rows = grid_.of_points.front().rows();
    if (ny > rows || nz > rows || nx > rows || nx * ny > rows || nx * ny * nz != rows)
      refuse(file_ + ": DIMENSIONS",
             fmt::format("'{} {} {}', expected as many points as the {} rows of POINT_DATA", nx, ny, nz, rows));
    for (std::size_t axis = 0; axis < 3 && is_rectilinear; ++axis)
      if (axes_[axis].size() != dimensions_[axis])
        refuse(file_ + ": " + "XYZ"[axis] + "_COORDINATES",
               fmt::format("'{}', expected {}, as DIMENSIONS say", axes_[axis].size(), dimensions_[axis]));
    GridPlaces& grid = grid_.points.grid.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis)
      grid.axes[axis] = {dimensions_[axis], origin_[axis], spacing_[axis],
                         is_rectilinear ? std::move(axes_[axis]) : std::vector<double>()};
  }

  std::string file_;
  std::string_view rest_;
  Budget budget_;
  bool is_text_ = true;
  std::string dataset_{};
  Of of_ = Of::fields;
  std::size_t rows_ = 0;
  std::optional<int> time_rank_{};
  Cells cells_{};
  VtkGrid grid_{};
  std::array<std::size_t, 3> dimensions_{};
  std::array<double, 3> origin_{}, spacing_{1, 1, 1};
  std::array<std::vector<double>, 3> axes_{};
};

}  // namespace

std::vector<Dataset> read_legacy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
  std::vector<Dataset> datasets = Legacy(file, bytes, limits).datasets(file.filename().string());
  for (Dataset& dataset : datasets) dataset.index = number_of(file);
  return datasets;
}

}  // namespace touchstone::vnv::doors::vtk

namespace touchstone::vnv::doors::formats {

Format vtk_legacy() {
  return {
      .words = "legacy VTK", .place = 11, .endings = {".vtk"}, .begins = "# vtk DataFile", .read = vtk::read_legacy};
}

}  // namespace touchstone::vnv::doors::formats
