#pragma once
/// What the figures and tables of a page are made of, in SI units unless a name says otherwise.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchstone::vnv {

/// A figure's frame. Curves and clouds of all methods of a case that name its id are drawn into it.
struct Axis {
  std::string label;  // "y [mm]"
  double scale = 1;   // from SI to the unit in the label
  bool logarithmic = false;
  std::optional<double> low = std::nullopt, high = std::nullopt;  // in the unit of the label; else from the data

  bool operator==(const Axis&) const = default;
};
struct Figure {
  std::string id;       // "profile"; also the stem of its files
  std::string title;    // "Velocity profiles"
  std::string caption;  // one or more sentences; which figure of which paper it re-draws
  Axis x, y;
  Axis colour{};  // for clouds
  bool equal_axes = false;
  double isolines = 0;  // from one line of equal colour to the next, in the unit of its label; 0: no lines

  bool operator==(const Figure&) const = default;
};

/// Who speaks: decides how a curve is drawn.
enum class Role { ours, exact, experiment, published, guide, best };
constexpr auto words(Role) {
  return std::to_array<std::string_view>({"ours", "exact", "experiment", "published", "guide", "best"});
}

struct Curve {
  std::string figure;  // id of its figure
  std::string label;   // in the key; curves of equal figure and label are one curve, drawn once
  Role role = Role::ours;
  std::vector<double> x, y;  // SI
  bool points = false;       // draw points, not a line

  bool operator==(const Curve&) const = default;
};

/// Particles coloured by a field; one panel of a figure.
struct Cloud {
  std::string figure;
  std::string column, row;  // "MPM", "t = 0.32 s": where the panel stands in the figure
  std::vector<double> x, y, colour;

  bool operator==(const Cloud&) const = default;
};

/// A table of a page. Rows of all methods of a case that name its id are joined; equal rows appear once.
using Cell = std::variant<std::string, double>;
struct Table {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<std::string> columns;  // with units
  std::vector<std::vector<Cell>> rows;

  bool operator==(const Table&) const = default;
};

}  // namespace touchstone::vnv
