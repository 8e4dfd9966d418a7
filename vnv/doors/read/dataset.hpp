#pragma once
/// What a file of another code holds: named arrays of equally many rows, one row a particle or a cell, at one time.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::vnv::doors {

/// Places on a structured grid, x fastest. They are computed where they are asked for: a file of one number for each of
/// them would need many times its size.
struct GridPlaces {
  struct Axis {
    std::size_t count;
    double first = 0, step = 1;
    std::vector<double> listed{};  // instead, of a rectilinear grid
  };
  std::array<Axis, 3> axes;
  std::optional<std::vector<std::size_t>> kept{};  // the only ones that there are

  std::size_t rows() const { return kept ? kept->size() : axes[0].count * axes[1].count * axes[2].count; }
  double at(std::size_t row, std::size_t component) const {
    std::size_t i = kept ? (*kept)[row] : row;
    for (std::size_t k = 0; k < component; ++k) i /= axes[k].count;
    const Axis& axis = axes[component];
    i %= axis.count;
    return axis.listed.empty() ? axis.first + static_cast<double>(i) * axis.step : axis.listed[i];
  }
};

/// One named array: `components` numbers a row, row after row, in the unit of its writer.
struct Array {
  std::string name;
  int components = 1;
  std::vector<double> values{};
  std::vector<std::string> labels{};  // where they stand for words: value k for labels[k]
  std::optional<GridPlaces> grid{};   // instead of values

  std::size_t rows() const { return grid ? grid->rows() : values.size() / static_cast<std::size_t>(components); }
  double at(std::size_t row, std::size_t component) const {
    return grid ? grid->at(row, component) : values[row * static_cast<std::size_t>(components) + component];
  }
};

/// Probes: places at which a flow was sampled, not all of its fluid.
enum class Rows { particles, cells, probes };

/// Names of arrays that readers of meshes add.
inline const std::string points_array = "Points", cell_centres_array = "cell centres",
                         cell_volumes_array = "cell volumes";

/// Rows at one time. Points of a VTK file are an array named "Points" of three components. Of a mesh, rows are its
/// cells: "cell centres" of three components, and "cell volumes", areas of cells of two dimensions, which are their
/// weights.
struct Dataset {
  std::string source{};          // the file, and what within it: "run.pvd: out_12.vtp"
  std::string format{};          // "VTP, appended raw, zlib"
  std::optional<double> time{};  // as the file says, in the unit of its writer
  std::string time_unit{};       // as the file says; empty where it does not
  std::optional<long> index{};   // of the output, by the number that ends its name or by its place within the file
  Rows rows_are = Rows::particles;
  int cell_dimensions = 0;
  std::array<double, 3> layer{};  // depth along each axis that bodies of a mesh span from end to end, else 0
  std::vector<Array> arrays{};

  std::size_t rows() const { return arrays.empty() ? 0 : arrays.front().rows(); }
  const Array* array(const std::string& name) const {
    for (const Array& a : arrays)
      if (a.name == name) return &a;
    return nullptr;
  }
};

/// A file that cannot be read: where, what, the value and what was expected, in one line.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How much a reader may take, whatever a file claims.
struct Limits {
  std::size_t most_bytes = std::size_t{1} << 34;  // of all arrays of one dataset, and of a file once decompressed
  std::size_t most_components = 1000;             // of one row of one array
  std::size_t most_datasets = 100000;             // of a series
};

/// All datasets of a file, in the order of their times; the format is told from what the file holds, not from its name
/// alone. Throws Unreadable.
std::vector<Dataset> read_datasets(const std::filesystem::path& file, const Limits& limits = {});

}  // namespace touchstone::vnv::doors
