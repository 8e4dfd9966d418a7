#include "vnv/doors/fields.hpp"

#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/measures/coverage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <tuple>

namespace touchstone::vnv::doors {
namespace {

/// Common names of fields, without case, units and what joins words.
const std::map<std::string, std::vector<std::string>> common_names{
    {"position", {"points", "position", "positions", "pos", "coordinates", "cellcentres", "r", "x"}},
    {"velocity", {"velocity", "velocities", "vel", "v", "u", "uvel"}},
    {"pressure", {"pressure", "press", "p"}},
    {"density", {"density", "rho", "rhop", "dens"}},
    {"mass", {"mass", "masses", "m"}},
    {"volume", {"volume", "volumes", "vol", "cellvolumes"}},
    {"fraction", {}},  // of a volume that is the fluid: only as the user says
};

constexpr double kinematic =
    0;  // in the place of a factor: the density at rest, as a code without any density needs it

/// Units by what is measured, each with its factor to that of the SI.
const std::map<std::string, std::vector<std::pair<std::string, double>>> units{
    {"length", {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"km", 1e3}}},
    {"velocity", {{"m/s", 1}, {"cm/s", 1e-2}, {"mm/s", 1e-3}}},
    {"pressure",
     {{"Pa", 1}, {"hPa", 1e2}, {"kPa", 1e3}, {"MPa", 1e6}, {"bar", 1e5}, {"m2/s2", kinematic}, {"m²/s²", kinematic}}},
    {"density", {{"kg/m3", 1}, {"kg/m^3", 1}, {"kg/m³", 1}, {"g/cm3", 1e3}}},
    {"time", units_of_time},
    {"mass", {{"kg", 1}, {"kg/m", 1}, {"g", 1e-3}}},
    {"volume", {{"m2", 1}, {"m²", 1}, {"m3", 1}, {"m³", 1}, {"m^3", 1}}},
    {"fraction", {{"-", 1}}},
};

/// `density` [kg/m³] is that of the flow, by which a kinematic pressure is multiplied.
double si(const std::string& kind, const std::string& name, double density) {
  std::vector<std::string> known;
  for (const auto& [unit, factor] : units.at(kind)) {
    if (name == unit) return factor == kinematic ? density : factor;
    known.push_back(unit);
  }
  throw Unreadable(fmt::format("unit of {} '{}', expected one of: {}", kind, name, fmt::join(known, ", ")));
}

/// A name without its unit, "Vel.x [m/s]" -> "velx".
std::string plain(const std::string& name) {
  std::string found;
  for (const char c : name.substr(0, name.find_first_of("[(")))
    if (std::isalnum(static_cast<unsigned char>(c))) found += static_cast<char>(std::tolower(c));
  return found;
}

/// One field: an array of so many components, or several columns.
struct Found {
  std::vector<const Array*> columns{};
  std::string words{};

  bool there() const { return !columns.empty(); }
  std::size_t components() const {
    return columns.size() > 1 ? columns.size() : static_cast<std::size_t>(columns[0]->components);
  }
  double operator()(std::size_t row, std::size_t component) const {
    return columns.size() > 1 ? columns[component]->values[row] : columns[0]->at(row, component);
  }
};

/// Columns of the components of a vector by its base name: "vx" and "vy", "v_0" and "v_1"; those of a velocity may be
/// "u" and "v", those of a place "x" and "y".
std::vector<const Array*> components_of(const Dataset& data, const std::string& field, const std::string& base) {
  const auto column = [&](const std::string& name) -> const Array* {
    const Array* found = nullptr;
    for (const Array& array : data.arrays) {
      if (array.components != 1 || plain(array.name) != name) continue;
      if (!found || array.name == name) found = &array;  // "v", where there is "V" too
    }
    return found;
  };
  std::vector<std::array<std::string, 3>> patterns{{base + "x", base + "y", base + "z"},
                                                   {base + "0", base + "1", base + "2"}};
  if (field == "velocity" && base == "u") patterns.push_back({"u", "v", "w"});
  if (field == "position" && base == "x") patterns = {{"x", "y", "z"}};
  for (const auto& [x, y, z] : patterns) {
    std::vector<const Array*> columns;
    for (const Array* one : {column(x), column(y), column(z)})
      if (one) columns.push_back(one);
    if (columns.size() > 1) return columns;
  }
  return {};
}

Found found_as(const Dataset& data, const std::string& field, const std::string& base) {
  const bool is_vector = field == "position" || field == "velocity";
  if (const Array* exact = data.array(base); exact && (exact->components > 1) == is_vector) return {{exact}, base};
  for (const Array& array : data.arrays)
    if (plain(array.name) == base && (array.components > 1) == is_vector) return {{&array}, array.name};
  if (!is_vector) return {};
  Found found{components_of(data, field, base)};
  std::vector<std::string> names;
  for (const Array* column : found.columns) names.push_back(column->name);
  found.words = fmt::format("{}", fmt::join(names, ", "));
  return found;
}

/// A component of a velocity by its common names: "v_x" along x.
Found component_along(const Dataset& data, char axis) {
  for (const std::string& base : common_names.at("velocity"))
    for (const Array& array : data.arrays)
      if (array.components == 1 && plain(array.name) == base + axis) return {{&array}, array.name};
  return {};
}

Found find(const Dataset& data, const std::string& field, const Mapping& mapping) {
  if (const auto said = mapping.arrays.find(field); said != mapping.arrays.end()) {
    if (const Array* array = data.array(said->second)) return {{array}, array->name};
    if (const Found columns = found_as(data, field, plain(said->second)); columns.there()) return columns;
    Found list{.words = said->second};
    for (std::string_view rest = said->second; !rest.empty();) {
      const std::string_view name = rest.substr(0, rest.find(','));
      if (const Array* column = data.array(std::string(name)); column && column->components == 1)
        list.columns.push_back(column);
      rest.remove_prefix(std::min(name.size() + 1, rest.size()));
    }
    if (std::ssize(list.columns) == 1 + std::ranges::count(said->second, ',')) return list;
    std::vector<std::string> names;
    for (const Array& array : data.arrays) names.push_back(array.name);
    throw Unreadable(fmt::format("{}: no array '{}' for {}, expected one of: {}", data.source, said->second, field,
                                 fmt::join(names, ", ")));
  }
  std::vector<Found> all;
  for (const std::string& base : common_names.at(field)) {
    const Found one = found_as(data, field, base);
    const auto is_known = [&](const Found& other) { return other.columns == one.columns; };
    if (one.there() && std::ranges::none_of(all, is_known)) all.push_back(one);
  }
  if (all.size() > 1)
    throw Unreadable(fmt::format("{}: {} may be '{}' or '{}': say which, --field {}=NAME", data.source, field,
                                 all[0].words, all[1].words, field));
  return all.empty() ? Found{} : all[0];
}

/// To SI, by what the user says of the kind or else by the unit in the name.
double factor(const Found& found, const std::string& kind, const Mapping& mapping, double density, std::string& words) {
  const auto said = mapping.units.find(kind);
  const std::string of_first = unit_in(found.columns[0]->name),
                    unit = said != mapping.units.end() ? said->second : of_first;
  for (const Array* column : found.columns)
    if (unit_in(column->name) != of_first)
      throw Unreadable(fmt::format("{}: two units, expected the same of all columns", found.words));
  if (unit.empty()) return 1;
  words += fmt::format(" in {}", unit);
  return si(kind, unit, density);
}

/// Two axes of the coordinates of a file, and the way that those of the flow run along them.
struct Plane {
  std::array<std::size_t, 2> axes;
  Vec2 way{1, 1};

  std::size_t operator[](std::size_t k) const { return axes[k]; }
  std::string name(std::size_t k) const {
    return fmt::format("{}{}", way[static_cast<Eigen::Index>(k)] < 0 ? "-" : "", "xyz"[axes[k]]);
  }
};

/// "-zx"
Plane plane_named(const std::string& name) {
  Plane plane{};
  std::size_t k = 0;
  for (const char c : name)
    if (c == '-')
      plane.way[static_cast<Eigen::Index>(k)] = -1;
    else
      plane.axes[k++] = static_cast<std::size_t>(c - 'x');
  return plane;
}

/// The lowest and the highest coordinate of the chosen rows along each axis of a file, in its unit.
using Reach = std::array<std::pair<double, double>, 3>;
Reach reach_of(const Found& places, const std::vector<bool>& chosen) {
  Reach reach;
  reach.fill({0, 0});
  for (std::size_t c = 0; c < std::min<std::size_t>(places.components(), 3); ++c) {
    auto& [low, high] = reach[c] = {INFINITY, -INFINITY};
    for (std::size_t row = 0; row < chosen.size(); ++row)
      if (chosen[row]) low = std::min(low, places(row, c)), high = std::max(high, places(row, c));
  }
  return reach;
}

/// How rows lie in a plane: not where the fluid may be, within the domain, or where all of the fluid is.
enum class Lie { elsewhere, within, everywhere };

/// The plane of the flow: that in which places lie, or, of those that fill a slab, the only one in which they are where
/// the fluid is, or else that of x and y. Throws where there is none or two.
Plane plane_of(const Dataset& data, const Reach& reach, const Mapping& mapping,
               const std::function<Lie(const Plane&)>& lie_in) {
  if (!mapping.axes.empty()) return plane_named(mapping.axes);
  const auto spread = [&](std::size_t c) { return reach[c].second - reach[c].first; };
  const double flat = 1e-6 * std::max({spread(0), spread(1), spread(2)});
  if (spread(1) <= flat && spread(2) > flat) return {{0, 2}};
  if (data.rows_are != Rows::particles || spread(2) <= flat) return {{0, 1}};
  std::vector<Plane> all;
  std::vector<std::string> names;
  for (const Plane& one : {Plane{{0, 1}}, Plane{{0, 2}}, Plane{{1, 2}}})
    if (lie_in(one) == Lie::everywhere) all.push_back(one), names.push_back(one.name(0) + one.name(1));
  if (all.size() == 1) return all[0];
  if (all.empty() && lie_in({{0, 1}}) == Lie::within) return {{0, 1}};
  throw Unreadable(fmt::format(
      "{}: places spread over {:.4g} along x and {:.4g} along y and {:.4g} along z, expected a cloud in a plane, or a "
      "slab in whose plane the fluid is{}; say which with --axes",
      data.source, spread(0), spread(1), spread(2),
      all.empty() ? "" : fmt::format(", which may be {}", fmt::join(names, " or "))));
}

/// Slices of the rows, by their places [m] across the plane, of a fluid of this area [m²]. How deep they are follows
/// from the variance of their places: that of n layers is (n² - 1) / 12 spacings², and disorder adds little to it. A
/// spacing that nobody says is that at which as many rows fill this depth.
Slab slab_of(const Scalars& z, double area, std::optional<double> spacing) {
  const double count = static_cast<double>(z.size()), middle = z.mean(), spread = 12 * (z - middle).square().mean();
  const auto depth = [&](double s) { return std::sqrt(spread + s * s); };
  double s = spacing.value_or(std::sqrt(area / count));
  for (int k = 0; k < 60 && !spacing; ++k) s = std::cbrt(area * depth(s) / count);
  Slab slab{.layers = depth(s) / s};
  const double slices = std::clamp(std::round(slab.layers), 1.0, count);
  for (const double at : z)
    slab.slice.push_back(
        static_cast<int>(std::clamp(std::floor(((at - middle) / depth(s) + 0.5) * slices), 0.0, slices - 1)));
  return slab;
}

/// "array=fluid" where an array of words, such as PySPH's names of particle arrays, has one of fluid among others.
std::string fluid_by_name(const Dataset& data) {
  for (const Array& array : data.arrays)
    for (const char* fluid : {"fluid", "water"})
      if (array.labels.size() > 1 && std::ranges::find(array.labels, fluid) != array.labels.end())
        return array.name + "=" + fluid;
  return "";
}

/// Which rows are fluid, by `only`: "NAME=VALUE", "NAME>VALUE" or "NAME<VALUE" of an array or, "z<0.01", a coordinate;
/// or all of them.
std::vector<bool> chosen_rows(const Dataset& data, const std::string& only, const Mapping& mapping) {
  std::vector<bool> chosen(data.rows(), true);
  if (only.empty()) return chosen;
  const std::size_t sign = only.find_first_of("=<>");
  const char relation = sign == only.npos ? ' ' : only[sign];
  const std::string name = only.substr(0, sign), word = sign == only.npos ? "" : only.substr(sign + 1);
  const std::size_t axis = name.size() == 1 ? std::string_view("xyz").find(name) : name.npos;
  const Array* array = data.array(name);
  Found by{{array}};
  if (!array) by = axis == name.npos ? Found{} : find(data, "position", mapping);
  const std::size_t component = array ? 0 : axis;
  const bool is_word = array && !array->labels.empty();
  std::optional<double> value = number_in(word);
  if (is_word && relation == '=') {
    const auto label = std::ranges::find(array->labels, word);
    if (label == array->labels.end())
      throw Unreadable(fmt::format("{}: no rows with {} '{}', expected one of: {}", data.source, name, word,
                                   fmt::join(array->labels, ", ")));
    value = static_cast<double>(label - array->labels.begin());
  } else if (!by.there() || !value || is_word || (array ? array->components != 1 : component >= by.components())) {
    throw Unreadable(
        fmt::format("{}: --only '{}', expected NAME=VALUE, NAME>VALUE or NAME<VALUE of an array of one component or of "
                    "x, y or z",
                    data.source, only));
  }
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    const double found = by(row, component);
    chosen[row] = relation == '>' ? found > *value : relation == '<' ? found < *value : found == *value;
  }
  return chosen;
}

double time_of(const Dataset& data, const Mapping& mapping, std::string& words) {
  if (data.time) {
    const auto said = mapping.units.find("time");
    const std::string unit = said == mapping.units.end() ? data.time_unit : said->second;
    words = unit.empty() ? "as it says" : fmt::format("as it says in {}", unit);
    return *data.time * (unit.empty() ? 1 : si("time", unit, 1));
  }
  if (mapping.time_step && data.index) {
    words = fmt::format("by its index {} times the step", *data.index);
    return static_cast<double>(*data.index) * *mapping.time_step;
  }
  if (mapping.time) {
    words = "as the user says";
    return *mapping.time;
  }
  throw Unreadable(fmt::format("{}: no time in it, expected one: --time or --time-step", data.source));
}

/// Words by which rows can be chosen, such as PySPH's particle arrays.
std::string labels_of(const Dataset& data) {
  std::string words;
  for (const Array& array : data.arrays)
    if (!array.labels.empty()) words += fmt::format(" ({} is {})", array.name, fmt::join(array.labels, ", "));
  return words;
}

/// The number with the fewest digits within `room` of a value: as a person would say it.
double rounded(double value, double room) {
  for (double unit = std::pow(10, std::ceil(std::log10(std::abs(value) + room))); unit > room; unit /= 10)
    if (const double said = std::round(value / unit) * unit; std::abs(said - value) <= room) return said;
  return value;
}

/// How far [m] rows are off, as that is said: in four digits where these are exact, else but for what the first and
/// the last of them stand off the edges of the fluid.
double said_shift(double off, double spacing) {
  const double digits = std::stod(fmt::format("{:.4g}", off));
  return std::abs(digits - off) <= 1e-5 * spacing ? rounded(digits, 1e-5 * spacing) : rounded(off, spacing / 4);
}

/// Whether rows from a box to its other corner are where the fluid is: in the domain, and up to the edges of the fluid
/// or, where these are not known, with room for it.
bool is_where_fluid_is(const Box& rows, const Domain& domain, const Extent& fluid, double spacing) {
  const Vec2 size = domain.box.size(), spread = rows.size();
  for (const int axis : {0, 1}) {
    if (domain.periodic(axis)) {
      const bool is_one_column = spread[axis] <= 1e-9 * size[axis] && !domain.periodic(1 - axis);
      if (spread[axis] > 1.5 * size[axis] || (spread[axis] < size[axis] / 2 && !is_one_column)) return false;
      continue;
    }
    const double rounding = 1e-9 * size[axis];
    if (rows.low[axis] < domain.box.low[axis] - rounding || rows.high[axis] > domain.box.high[axis] + rounding)
      return false;
    if (!fluid.about) continue;
    const double off = 1.5 * spacing + 0.02 * fluid.about->size()[axis];
    if (std::abs(rows.low[axis] - fluid.about->low[axis]) > off ||
        std::abs(rows.high[axis] - fluid.about->high[axis]) > off)
      return false;
  }
  return fluid.about || spread.prod() >= fluid.area / 2;
}

Box about(const Vectors& x) { return {.low = x.rowwise().minCoeff(), .high = x.rowwise().maxCoeff()}; }

std::string said_origin(const Vec2& origin) {
  return fmt::format(" --origin {:.6g} {:.6g}", origin.x() + 0.0, origin.y() + 0.0);  // no "-0"
}

/// What the user might say so that all places, as a file has them along the axes of a plane, are where the fluid is:
/// another unit, the axes the other way round, another origin, or several of these; as few as will do. Rows at the
/// other end of a tank are mirrored, not moved out of it; along y its end is no wall. Rows in the domain are not moved,
/// unless those of a free surface at the start: elsewhere something is wrong with them or missing.
std::string guess_of_convention(const Vectors& places, double to_si, const Plane& plane, const Mapping& mapping,
                                const Domain& domain, const Extent& fluid, bool is_start) {
  enum class Placed { as_they_are, mirrored, moved };
  const double spacing = std::sqrt(fluid.area / static_cast<double>(places.cols()));
  std::string guess;
  std::size_t fewest = 4;
  for (const bool swapped : {false, true})
    for (const auto& [unit, si] : units.at("length"))
      for (const Placed placed : {Placed::as_they_are, Placed::mirrored, Placed::moved}) {
        const std::size_t count = swapped + (si != to_si) + (placed != Placed::as_they_are);
        const bool needs_edges = swapped || placed != Placed::as_they_are;
        if (count == 0 || count >= fewest || (needs_edges && !fluid.about)) continue;
        Plane said = plane;
        Box rows = about(places * si);
        if (swapped) {
          std::swap(said.axes[0], said.axes[1]);
          for (Vec2* of : {&said.way, &rows.low, &rows.high}) of->reverseInPlace();
        }
        Vec2 origin = mapping.origin;
        if (placed == Placed::mirrored) {
          if (domain.periodic(0)) continue;
          origin.x() += said.way.x() * (domain.box.low.x() + domain.box.high.x());
          said.way.x() *= -1;
          std::tie(rows.low.x(), rows.high.x()) = std::pair(-rows.high.x(), -rows.low.x());
        } else if (placed == Placed::moved) {
          const Vec2 off = (rows.low + rows.high - fluid.about->low - fluid.about->high) / 2;
          for (const int axis : {0, 1}) {
            const double from = said.way[axis] * origin[axis];
            const bool is_within =
                rows.low[axis] - from >= domain.box.low[axis] && rows.high[axis] - from <= domain.box.high[axis];
            const bool may_be_elsewhere = is_start && fluid.about->size()[axis] < domain.box.size()[axis];
            if (!domain.periodic(axis) && (!is_within || may_be_elsewhere))
              origin[axis] = said.way[axis] * said_shift(off[axis], spacing);
          }
          if (origin == mapping.origin) continue;
        }
        rows.low -= said.way.cwiseProduct(origin);
        rows.high -= said.way.cwiseProduct(origin);
        if (!is_where_fluid_is(rows, domain, fluid, spacing)) continue;
        fewest = count;
        guess = "; they fit with";
        if (si != to_si) guess += fmt::format(" --unit length={}", unit);
        if (swapped || placed == Placed::mirrored)
          guess += fmt::format(" --axes{}{}{}", said.way.x() < 0 ? "=" : " ", said.name(0), said.name(1));
        if (origin != mapping.origin) guess += said_origin(origin);
      }
  return guess;
}

/// The length [m] that rows of an upright grid without an empty place take along an axis, half a cell beyond the first
/// and the last of them; of others half a spacing [m]. Zero where there is one line alone.
double length_of(const Vectors& x, int axis, double spacing, bool is_grid) {
  const Box rows = about(x);
  const double same = 1e-6 * rows.size().norm();
  const auto lines = static_cast<double>(((x.row(1 - axis).array() - x(1 - axis, 0)).abs() <= same).count());
  if (!is_grid) return rows.size()[axis] + spacing;
  return lines > 1 ? rows.size()[axis] * lines / (lines - 1) : 0;
}

/// Refuses places that evenly fill more than a period. Where particles only move on beyond one, as they are written
/// unwrapped, the corners of the box about them stay empty: of a cloud this is seen from one and a half periods on, of
/// an upright grid at once. A mesh does not move on, nor have rows at the start: these fit into one period. Says where
/// a grid evenly fills less than a period.
std::string require_periods(const std::string& source, const Vectors& x, const Domain& domain, bool has_not_moved,
                            const std::function<std::string()>& guess) {
  std::string shorter;
  for (const int axis : {0, 1}) {
    if (!domain.periodic(axis)) continue;
    const double period = domain.box.size()[axis];
    Box around = about(x);
    const bool is_longer = around.size()[axis] > period * (1 + 1e-6);
    if (!is_longer && around.size()[axis] > 0.95 * period) continue;
    double spacing = std::sqrt(around.size().prod() / static_cast<double>(x.cols()));
    for (int k = 0; k < 10; ++k)  // with half a spacing around them
      spacing = std::sqrt((around.size().array() + spacing).prod() / static_cast<double>(x.cols()));
    around.low.array() -= spacing / 2;
    around.high.array() += spacing / 2;
    const Coverage found = spacing > 0 ? coverage_of(x, spacing, {.domain = {.box = around}}) : Coverage{};  // a line
    const bool is_grid = found.grid_places > 0 && found.empty_places == 0;
    const double length = length_of(x, axis, spacing, is_grid);
    const std::string line =
        fmt::format("{}: the rows span {:.4g} m along {}, L is {:.4g} m", source, length, "xy"[axis], period);
    if (!is_longer) {
      if (is_grid && length > 0 && length < period * (1 - 1e-6))
        shorter = fmt::format("{}: --set L={:.4g}?", line, length);
      continue;
    }
    const bool is_filled = found.empty_places == 0 && found.hole <= largest_sound_hole(static_cast<double>(x.cols()));
    if (!has_not_moved && !is_grid && !(length > 1.5 * period && is_filled)) continue;
    if (const std::string all_fits = guess(); !all_fits.empty()) throw Unreadable(line + all_fits);
    throw LongerThanPeriod(fmt::format("{}: --set L={:.4g}?", line, length), axis, length);
  }
  return shorter;
}

/// By how much [m] rows that span a periodic box lie beside it.
Vec2 beside(const Vectors& x, const Domain& domain) {
  const Box rows = about(x);
  const double spacing = std::sqrt(domain.box.size().prod() / static_cast<double>(x.cols()));
  Vec2 shift = Vec2::Zero();
  for (const int axis : {0, 1}) {
    const double short_of = domain.box.size()[axis] - rows.size()[axis],
                 off = (rows.low + rows.high - domain.box.low - domain.box.high)[axis] / 2;
    if (domain.periodic(axis) && short_of < 1.5 * spacing && short_of > -spacing / 2 && std::abs(off) > spacing)
      shift[axis] = said_shift(off, spacing);
  }
  return shift;
}

/// A line, "y=0.5": its axis and place [m]. Throws std::invalid_argument for another text.
std::pair<int, double> line_named(const std::string& name) {
  const std::size_t axis = std::string_view("xy").find(name.substr(0, name.find('=')));
  const std::optional<double> place = name.size() > 2 && name[1] == '=' ? number_in(name.substr(2)) : std::nullopt;
  if (axis > 1 || !place)
    throw std::invalid_argument(fmt::format("'{}', expected x= or y= and a place in m, as in y=0.5", name));
  return {static_cast<int>(axis), *place};
}

/// Adds to the rows on one side of a line of symmetry those that mirror them.
void mirror(int axis, double place, const Domain& domain, Reading& reading) {
  Samples& s = reading.samples;
  std::vector<Eigen::Index> mirrored;
  for (Eigen::Index p = 0; p < s.size(); ++p)
    if (std::abs(s.x(axis, p) - place) > 1e-9 * domain.box.size()[axis]) mirrored.push_back(p);
  const Eigen::Index given = s.size(), all = given + std::ssize(mirrored);
  const auto doubled = [&](auto& field) {
    auto images = field(mirrored).eval();
    field.conservativeResize(all);
    field.tail(all - given) = images;
  };
  for (Vectors* of : {&s.x, &s.v}) {
    Vectors images = (*of)(Eigen::all, mirrored);
    images.row(axis) *= -1;
    if (of == &s.x) images.row(axis).array() += 2 * place;
    of->conservativeResize(Eigen::NoChange, all);
    of->rightCols(all - given) = images;
  }
  for (Scalars* of : {&s.pressure, &s.density, &s.mass}) doubled(*of);
  if (reading.slab.v.size() > 0) doubled(reading.slab.v);
  if (!reading.slab.slice.empty())
    for (const Eigen::Index p : mirrored) reading.slab.slice.push_back(reading.slab.slice[static_cast<std::size_t>(p)]);
  reading.words.push_back(
      fmt::format("symmetric: about {} = {:g} m; {} rows mirrored", "xy"[axis], place, mirrored.size()));
}

}  // namespace

std::vector<std::string> names_of_planes() {
  std::vector<std::string> names;
  for (const std::string first : {"x", "y", "z", "-x", "-y", "-z"})
    for (const std::string second : {"x", "y", "z", "-x", "-y", "-z"})
      if (first.back() != second.back()) names.push_back(first + second);
  return names;
}

void require_known_names(const Mapping& mapping, const std::string& where) {
  if (const auto planes = names_of_planes();
      !mapping.axes.empty() && std::ranges::find(planes, mapping.axes) == planes.end())
    throw std::invalid_argument(
        fmt::format("{}: axes '{}', expected one of: {}", where, mapping.axes, fmt::join(planes, ", ")));
  std::vector<std::string> lines = mapping.symmetric;
  if (!mapping.at.empty()) lines.push_back(mapping.at);
  for (const std::string& line : lines) try {
      line_named(line);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", where, error.what()));
    }
  const auto require = [&](const auto& said, const char* what, const auto& known) {
    for (const auto& [name, value] : said) {
      if (known.contains(name)) continue;
      std::vector<std::string> names;
      for (const auto& [one, of_it] : known) names.push_back(one);
      throw std::invalid_argument(
          fmt::format("{}: {} '{}' = '{}', expected one of: {}", where, what, name, value, fmt::join(names, ", ")));
    }
  };
  require(mapping.arrays, "field", common_names);
  require(mapping.units, "unit of", units);
}

bool complete_coordinates(Dataset& data, const Mapping& mapping, const Vec2& place) {
  if (mapping.arrays.contains("position") || find(data, "position", mapping).there()) return false;
  std::array<const Array*, 2> columns{};
  for (const Array& array : data.arrays)
    if (const std::size_t axis = std::string_view("xy").find(plain(array.name)); axis < 2 && array.components == 1)
      columns[axis] = &array;
  Vec2 at = place;
  if (!mapping.at.empty()) {
    const auto [axis, said] = line_named(mapping.at);
    at = Vec2::Constant(not_a_number), at[axis] = said;
  }
  if (!columns[0] && !columns[1])
    for (Array& array : data.arrays)
      if (const std::string name = plain(array.name);
          array.components == 1 && (name == "distance" || name == "arclength")) {
        const int along = std::isnan(at.y()) && !std::isnan(at.x()) ? 1 : 0;
        array.name.replace(0, array.name.find_first_of(" [("), 1, "xy"[along]);
        columns[static_cast<std::size_t>(along)] = &array;
        break;
      }
  if (!columns[0] == !columns[1]) return false;
  const int missing = columns[0] ? 1 : 0;
  const Array& known = *columns[static_cast<std::size_t>(1 - missing)];
  if (std::isnan(at[missing]))
    throw Unreadable(fmt::format("{0}: '{1}' is the only coordinate, expected {2} too, or --at {2}=PLACE [m]",
                                 data.source, known.name, "xy"[missing]));
  std::string unsaid;
  const double to_si = factor(Found{{&known}, known.name}, "length", mapping, 1, unsaid);
  Array other{.name = "xy"[missing] + known.name.substr(1)};  // in the same unit
  other.values.assign(known.rows(), (at[missing] + mapping.origin[missing]) / to_si);
  data.arrays.push_back(std::move(other));
  return true;
}

const Vectors& Slab::in(int which, const Vectors& x, Vectors& kept) const {
  if (slice.empty()) return x;
  std::vector<Eigen::Index> chosen;
  for (std::size_t p = 0; p < slice.size(); ++p)
    if (slice[p] == which) chosen.push_back(static_cast<Eigen::Index>(p));
  return kept = x(Eigen::all, chosen);
}

const Vectors& Slab::in_the_fullest(const Vectors& x, Vectors& kept) const {
  std::vector<long> counts(static_cast<std::size_t>(slices()), 0);
  for (const int k : slice) ++counts[static_cast<std::size_t>(k)];
  return in(static_cast<int>(std::ranges::max_element(counts) - counts.begin()), x, kept);
}

Reading reading_of(const Dataset& data, const Mapping& mapping, const Domain& domain, double density,
                   const ExtentAt& fluid_at, std::optional<double> spacing) {
  Reading reading;
  Samples& s = reading.samples;
  const std::string only = mapping.only.empty() ? fluid_by_name(data) : mapping.only;
  std::vector<bool> chosen = chosen_rows(data, only, mapping);
  Eigen::Index count = std::ranges::count(chosen, true);
  if (count == 0) throw Unreadable(fmt::format("{}: no row that is fluid, expected at least one", data.source));
  const auto each_row = [&](const auto& work) {  // (row of the file, number of those chosen)
    Eigen::Index p = 0;
    for (std::size_t row = 0; row < chosen.size(); ++row)
      if (chosen[row]) work(row, p++);
  };
  const auto say = [&](const std::string& field, const std::string& as) {
    reading.words.push_back(fmt::format("{}: {}", field, as));
  };
  std::string words;
  s.time = time_of(data, mapping, words);
  const bool is_mesh = data.rows_are == Rows::cells;
  if (!is_mesh && !mapping.probes) reading.fields.emplace_back("particles");
  reading.file = fmt::format("file: {}, {}, {} {} at {:g} s, {}", data.source, data.format, count,
                             is_mesh          ? "cells"
                             : mapping.probes ? "places"
                                              : "particles",
                             s.time, words);

  if (!only.empty())
    say("rows", fmt::format("{}{}; {} of {} left out", only, mapping.only.empty() ? ", by its name" : ", as said",
                            static_cast<Eigen::Index>(chosen.size()) - count, chosen.size()));

  const Found places = find(data, "position", mapping);
  if (!places.there()) throw Unreadable(fmt::format("{}: no places, expected --field position=NAME", data.source));
  const Extent at_first =
      fluid_at ? fluid_at(s.time, static_cast<double>(count)) : Extent{domain.box, domain.box.size().prod()};
  const Reach reach = reach_of(places, chosen);
  std::string unsaid;
  const double metre = factor(places, "length", mapping, density, unsaid);
  const Plane plane = plane_of(data, reach, mapping, [&](const Plane& one) {
    Box rows{.low = Vec2::Zero(), .high = Vec2::Zero()};
    for (const int k : {0, 1}) {
      const auto& [low, high] = reach[one[static_cast<std::size_t>(k)]];
      rows.low[k] = metre * low - mapping.origin[k], rows.high[k] = metre * high - mapping.origin[k];
    }
    const auto& [front, back] = reach[3 - one[0] - one[1]];
    const double one_layer = std::sqrt(at_first.area / static_cast<double>(count)),
                 apart = std::cbrt(at_first.area * metre * (back - front) / static_cast<double>(count));
    if (apart > domain.box.size().minCoeff()) return Lie::elsewhere;  // too few to fill a slab so deep
    return is_where_fluid_is(rows, domain, at_first, one_layer)               ? Lie::everywhere
           : domain.box.contains(rows.low) && domain.box.contains(rows.high) ? Lie::within
                                                                              : Lie::elsewhere;
  });
  const std::size_t third = 3 - plane[0] - plane[1];
  /// Along the third axis of the file, a number a row.
  const auto along_third = [&](const Found& found, double to_si) {
    Scalars all(count);
    each_row([&](std::size_t row, Eigen::Index p) { all[p] = to_si * found(row, third); });
    return all;
  };
  if (const double deep = metre * (reach[third].second - reach[third].first);
      !is_mesh && !mapping.probes && deep > 1e-6 * domain.box.size().maxCoeff()) {
    const double area = std::ldexp(at_first.area, -static_cast<int>(mapping.symmetric.size()));  // of what is there
    reading.slab = slab_of(along_third(places, metre), area, spacing);
    say("slab", fmt::format("{:.4g} m along {}, {:.3g} layers", deep, "xyz"[third], reading.slab.layers));
  }
  const auto vectors = [&](const Found& found, const std::string& field, const std::string& kind) {
    std::string as = found.words;
    const double to_si = factor(found, kind, mapping, density, as);
    const bool is_along_x = field == velocity_along_x;  // alone
    if (!is_along_x && std::max(plane[0], plane[1]) >= found.components())
      throw Unreadable(fmt::format("{}: {} is '{}' of {} component{}, expected those along {} and {}", data.source,
                                   field, found.words, found.components(), found.components() == 1 ? "" : "s",
                                   "xyz"[plane[0]], "xyz"[plane[1]]));
    Vectors all = Vectors::Constant(2, count, NAN);
    each_row([&](std::size_t row, Eigen::Index p) {
      for (int k = 0; k < (is_along_x ? 1 : 2); ++k) {
        const double value = plane.way[k] * found(row, is_along_x ? 0 : plane[k]);
        if (field == "position" && !std::isfinite(value))  // a velocity is judged
          throw Unreadable(
              fmt::format("{}: row {}: {} = {}, expected a finite number", data.source, row + 1, found.words, value));
        all(k, p) = to_si * value;
      }
    });
    say(field, is_along_x ? as : as + fmt::format(", along {} and {}", plane.name(0), plane.name(1)));
    return all;
  };
  s.x = vectors(places, "position", "length");
  const double rows_of_layer = static_cast<double>(count) / reading.slab.layers;
  const Extent fluid = fluid_at && !reading.slab.slice.empty() ? fluid_at(s.time, rows_of_layer) : at_first;
  const auto guess = [&] {
    Vectors kept;
    return guess_of_convention(reading.slab.in_the_fullest(vectors(places, "position", "length"), kept) / metre, metre,
                               plane, mapping, domain, fluid, s.time == 0);
  };
  s.x.colwise() -= plane.way.cwiseProduct(mapping.origin);
  Vectors kept;
  const Vectors& in_slice = reading.slab.in_the_fullest(s.x, kept);
  const std::string shorter =
      mapping.probes ? "" : require_periods(data.source, in_slice, domain, is_mesh || s.time == 0, guess);
  if (!shorter.empty()) reading.words.push_back(shorter);
  reading.beside = beside(in_slice, domain);
  reading.put_right = said_origin(mapping.origin + plane.way.cwiseProduct(reading.beside));

  // Rows outside the domain, but for rounding, and but for a periodic axis, along which places wrap.
  const double off = 1e-6 * domain.box.size().norm();
  std::vector<bool> within = chosen;
  Eigen::Index outside = 0;
  each_row([&](std::size_t row, Eigen::Index p) {
    for (const int axis : {0, 1}) s.x(axis, p) = domain.wrapped(axis, s.x(axis, p));
    const Vec2 nearest = s.x.col(p).cwiseMax(domain.box.low).cwiseMin(domain.box.high);
    within[row] = (nearest - s.x.col(p)).norm() <= off;
    if (within[row])
      s.x.col(p) = nearest;
    else
      ++outside;
  });
  if (outside > 0) {
    if (!mapping.inside || outside == count)
      throw Unreadable(
          fmt::format("{}: {} of {} rows lie outside the domain, ({:g}, {:g}) to ({:g}, {:g}) m: say which are "
                      "fluid, --only NAME=VALUE{} or --inside, or where the origin is, --origin{}",
                      data.source, outside, count, domain.box.low.x(), domain.box.low.y(), domain.box.high.x(),
                      domain.box.high.y(), labels_of(data), guess()));
    say("left out", fmt::format("{} of {} rows, outside the domain", outside, count));
    count = 0;
    each_row([&](std::size_t row, Eigen::Index p) {
      if (!within[row]) return;
      if (!reading.slab.slice.empty())
        reading.slab.slice[static_cast<std::size_t>(count)] = reading.slab.slice[static_cast<std::size_t>(p)];
      s.x.col(count++) = s.x.col(p).eval();
    });
    if (!reading.slab.slice.empty()) reading.slab.slice.resize(static_cast<std::size_t>(count));
    s.x.conservativeResize(Eigen::NoChange, count);
    chosen = within;
  } else if (!mapping.probes && !is_where_fluid_is(about(s.x), domain, fluid, std::sqrt(fluid.area / rows_of_layer))) {
    reading.fits_with = guess();
  }
  s.v = Vectors::Constant(2, count, NAN);
  Found velocity = find(data, "velocity", mapping);
  if (!velocity.there()) velocity = component_along(data, "xyz"[plane[0]]);
  if (velocity.there() && velocity.components() > 1) {
    s.v = vectors(velocity, "velocity", "velocity");
    if (velocity.components() > 2) {
      const Scalars v = along_third(velocity, factor(velocity, "velocity", mapping, density, unsaid));
      const double rounding = 1e-9 * s.v.cwiseAbs().maxCoeff();
      if (!(v.abs() <= rounding).all()) reading.slab.v = v;
    }
    reading.fields.insert(reading.fields.end(), {"velocity", velocity_along_x});
  } else if (velocity.there()) {
    s.v = vectors(velocity, velocity_along_x, "velocity");
    reading.fields.push_back(velocity_along_x);
  } else if (const Found across = component_along(data, "xyz"[plane[1]]); across.there()) {
    throw Unreadable(fmt::format("{}: velocity is '{}' alone, expected its component along {} too", data.source,
                                 across.words, "xyz"[plane[0]]));
  }
  const auto scalars = [&](const std::string& field) {
    const Found found = find(data, field, mapping);
    if (!found.there()) return Scalars(Scalars::Constant(count, NAN));
    std::string as = found.words;
    const double to_si = factor(found, field, mapping, density, as);
    Scalars all(count);
    each_row([&](std::size_t row, Eigen::Index p) {
      all[p] = to_si * found(row, 0);
      if (field != "pressure" && !std::isfinite(all[p]))  // by which rows are weighed
        throw Unreadable(fmt::format("{}: row {}: {} = {}, expected a finite number", data.source, row + 1, found.words,
                                     found(row, 0)));
    });
    say(field, as);
    reading.fields.push_back(field);
    return all;
  };
  s.pressure = scalars("pressure");
  s.density = scalars("density");
  s.mass = scalars("mass");
  Scalars volume = scalars("volume");
  if (find(data, "volume", mapping).words == cell_volumes_array) {  // measured in the unit of places
    const double depth = metre * data.layer[third];
    volume *= std::pow(metre, data.cell_dimensions) / (depth > 0 ? depth : 1);
    if (data.cell_dimensions == 3)
      reading.words.back() += depth > 0 ? fmt::format(", of a layer {:g} m deep", depth) : ", as of a layer 1 m deep";
  }
  if (mapping.arrays.contains("fraction")) {
    const Scalars fraction = scalars("fraction");
    each_row([&](std::size_t row, Eigen::Index p) {
      if (!(fraction[p] > 0 && volume[p] > 0))
        throw Unreadable(
            fmt::format("{}: row {}: fraction {} of volume {}, expected both above 0: --only '{}>0' leaves rows out",
                        data.source, row + 1, fraction[p], volume[p], mapping.arrays.at("fraction")));
    });
    volume *= fraction;
  }
  const auto known = [](const Scalars& field) { return field.allFinite() && (field > 0).all(); };
  if (!known(s.density)) {
    if (std::erase(reading.fields, "density") > 0) say("density", "that of the flow, as not all of it is positive");
    s.density = Scalars::Constant(count, density);
  }
  if (known(volume)) {  // the weight of a row in a norm is its volume
    s.mass = volume * s.density;
  } else if (!known(s.mass)) {
    s.mass = s.density;
    reading.has_volumes = false;
    say("weights", "equal, since there is neither a volume nor a mass");
  }
  if (!mapping.symmetric.empty()) reading.fits_with.clear();  // half of the fluid lies in half of its place
  for (const std::string& line : mapping.symmetric) {
    const auto [axis, place] = line_named(line);
    mirror(axis, place, domain, reading);
  }
  return reading;
}

}  // namespace touchstone::vnv::doors
