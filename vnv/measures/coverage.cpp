#include "vnv/measures/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchstone::vnv {
namespace {

constexpr double same = 1e-6;     // spacings  within which two rows are in one place
constexpr double as_sound = 0.75;  // spacings  apart are half of the rows of a lattice shaken by a quarter, at least

/// Rows by the cell that they are in, which is about a spacing long and high where there are not far more cells than
/// rows. Across a periodic boundary the neighbours of a place are those at the other end.
class RowsByCell {
 public:
  RowsByCell(const Vectors& x, double spacing, const Domain& domain) : domain_(domain) {
    const Vec2 size = domain.box.size();
    const double most = 16.0 * static_cast<double>(x.cols()) + 1024,
                 side = std::max(spacing, std::sqrt(size.prod() / most));
    for (const int axis : {0, 1}) {
      count_[axis] = std::max(1L, static_cast<long>(size[axis] / side));
      side_[axis] = size[axis] / static_cast<double>(count_[axis]);
    }
    start_.assign(static_cast<std::size_t>(count_[0] * count_[1]) + 1, 0);
    std::vector<int> cells(static_cast<std::size_t>(x.cols()));
    for (Eigen::Index p = 0; p < x.cols(); ++p) {
      const std::size_t cell = cell_of(x.col(p));
      cells[static_cast<std::size_t>(p)] = static_cast<int>(cell);
      ++start_[cell + 1];
    }
    for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
    places_.resize(2, x.cols());                  // cell by cell: what is looked at together lies together
    for (std::size_t p = cells.size(); p-- > 0;)  // the ends of all cells move back to their starts
      places_.col(--start_[static_cast<std::size_t>(cells[p]) + 1]) = x.col(static_cast<Eigen::Index>(p));
    start_.erase(start_.begin());
    start_.push_back(static_cast<int>(cells.size()));
  }

  const Vectors& places() const { return places_; }  // m
  long columns() const { return count_[0]; }
  long lines() const { return count_[1]; }
  double side() const { return side_.maxCoeff(); }  // m
  bool is_empty(long i, long j) const { return first(i, j) == first(i + 1, j); }
  Vec2 centre(long i, long j) const {
    return domain_.box.low + side_.cwiseProduct(Vec2(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5));
  }

  /// Calls visit(squared distance [m²], number in `places`) for all rows, and images, within `reach` [m] of a place.
  template <class Visit>
  void each_within(const Vec2& place, double reach, const Visit& visit) const {
    const auto [left, right] = range(place, reach, 0);
    const auto [bottom, top] = range(place, reach, 1);
    const double most = reach * reach;
    for (long j = bottom; j <= top; ++j) {
      const auto [line, up] = image(j, 1);
      for (long i = left; i <= right; ++i) {
        const auto [column, along] = image(i, 0);
        for (int k = first(column, line); k < first(column + 1, line); ++k) {
          const double dx = places_(0, k) + along - place.x(), dy = places_(1, k) + up - place.y(),
                       square = dx * dx + dy * dy;
          if (square <= most) visit(square, k);
        }
      }
    }
  }

  /// The distance [m] to the nearest row; there is one.
  double distance_to(const Vec2& place) const {
    for (double reach = side();; reach *= 2) {
      double least = INFINITY;
      each_within(place, reach, [&](double square, int) { least = std::min(least, square); });
      if (std::isfinite(least) || reach > 2 * domain_.box.size().norm()) return std::sqrt(least);
    }
  }

  /// That to the fourth other row from a place with a row; infinite where there are fewer.
  double distance_to_fourth(const Vec2& place) const {
    for (double reach = side();; reach *= 2) {
      std::array<double, 5> least;  // rising
      least.fill(INFINITY);
      each_within(place, reach, [&](double square, int) {
        for (double& one : least)
          if (square < one) std::swap(one, square);
      });
      if (std::isfinite(least.back()) || reach > 2 * domain_.box.size().norm()) return std::sqrt(least.back());
    }
  }

 private:
  std::array<long, 2> range(const Vec2& place, double reach, int axis) const {
    const double at = place[axis] - domain_.box.low[axis];
    const auto cell = [&](double from) { return static_cast<long>(std::floor(from / side_[axis])); };
    const long most = domain_.periodic(axis) ? count_[axis] : 0;  // one image to each side
    return {std::clamp(cell(at - reach), -most, count_[axis] - 1 + most),
            std::clamp(cell(at + reach), -most, count_[axis] - 1 + most)};
  }
  struct Image {
    long cell;     // whose image it is
    double shift;  // m  by which its rows are moved
  };
  Image image(long i, int axis) const {
    if (i >= 0 && i < count_[axis]) return {i, 0};
    const double period = domain_.box.high[axis] - domain_.box.low[axis];
    return i < 0 ? Image{i + count_[axis], -period} : Image{i - count_[axis], period};
  }
  std::size_t cell_of(const Vec2& place) const {
    const auto along = [&](int axis) {
      return std::clamp(static_cast<long>((place[axis] - domain_.box.low[axis]) / side_[axis]), 0L, count_[axis] - 1);
    };
    return static_cast<std::size_t>(along(0) + count_[0] * along(1));
  }
  int first(long i, long j) const { return start_[static_cast<std::size_t>(i + count_[0] * j)]; }

  const Domain& domain_;
  std::array<long, 2> count_{};
  Vec2 side_ = Vec2::Zero();
  std::vector<int> start_{};
  Vectors places_{};  // m
};

/// How deep in the region a place is [m], negative outside: as far as that bounds a circle about it.
double depth_in(const Region& region, const Vec2& place) {
  double least = region.depth ? region.depth(place) : INFINITY;
  for (const int axis : {0, 1})
    if (!region.domain.periodic(axis))
      least = std::min({least, place[axis] - region.box.low[axis], region.box.high[axis] - place[axis]});
  return least;
}

/// The radius [m] of the circle about a place that no row is in; it may reach beyond the region by half a spacing.
double free_radius(const RowsByCell& rows, const Region& region, double spacing, const Vec2& place) {
  const double depth = depth_in(region, place);
  return depth < 0 ? -1 : std::min(rows.distance_to(place), depth + spacing / 2);
}

struct Circle {
  double radius;  // m
  Vec2 centre;    // m
};

/// The wider circle to which one in the region can be moved uphill.
Circle widest_near(const RowsByCell& rows, const Region& region, double spacing, Circle circle) {
  constexpr double slope = std::numbers::sqrt2 / 2;
  const std::array<Vec2, 8> ways{Vec2(1, 0),         Vec2(-1, 0),         Vec2(0, 1),          Vec2(0, -1),
                                 Vec2(slope, slope), Vec2(-slope, slope), Vec2(slope, -slope), Vec2(-slope, -slope)};
  for (double step = rows.side() / 2; step > rows.side() / 500;) {
    bool is_better = false;
    for (const Vec2& way : ways) {
      Vec2 other = circle.centre + step * way;
      for (const int axis : {0, 1}) other[axis] = region.domain.wrapped(axis, other[axis]);
      if (const double there = free_radius(rows, region, spacing, other); there > circle.radius) {
        circle = {there, other}, is_better = true;
        break;
      }
    }
    if (!is_better) step /= 2;
  }
  return circle;
}

/// How many cells it is from each cell, along an axis or a diagonal, to one with a row.
std::vector<unsigned short> cells_to_a_row(const RowsByCell& rows, const Domain& domain) {
  constexpr unsigned short far = 60'000;
  const long columns = rows.columns(), lines = rows.lines();
  std::vector<unsigned short> found(static_cast<std::size_t>(columns * lines), far);
  const auto at = [&](long i, long j) -> unsigned short& { return found[static_cast<std::size_t>(i + columns * j)]; };
  for (long j = 0; j < lines; ++j)
    for (long i = 0; i < columns; ++i)
      if (!rows.is_empty(i, j)) at(i, j) = 0;
  const auto nearer = [&](long i, long j, long before) {  // by the four neighbours that have been passed
    for (const auto& [di, dj] : {std::pair(-1L, 0L), std::pair(-1L, -1L), std::pair(0L, -1L), std::pair(1L, -1L)}) {
      long other_i = i + before * di, other_j = j + before * dj;
      if (domain.periodic_x) other_i = (other_i + columns) % columns;
      if (domain.periodic_y) other_j = (other_j + lines) % lines;
      if (other_i < 0 || other_i >= columns || other_j < 0 || other_j >= lines) continue;
      at(i, j) = std::min<unsigned short>(at(i, j), static_cast<unsigned short>(at(other_i, other_j) + 1));
    }
  };
  const int passes = domain.periodic_x || domain.periodic_y ? 2 : 1;  // from the one end of a period on to the other
  for (int pass = 0; pass < passes; ++pass) {
    for (long j = 0; j < lines; ++j)
      for (long i = 0; i < columns; ++i)
        if (at(i, j) > 0) nearer(i, j, 1);
    for (long j = lines - 1; j >= 0; --j)
      for (long i = columns - 1; i >= 0; --i)
        if (at(i, j) > 0) nearer(i, j, -1);
  }
  return found;
}

/// How far apart [spacings] rows about a circle are that a strain has pressed together: half of them have another one
/// within that, on a line and not all around. `as_sound` where they are farther, or so many are missing that no strain
/// has drawn them apart.
double apart_about(const RowsByCell& rows, double spacing, const Vec2& centre, double radius) {
  constexpr double all_there = 0.82, beyond = 2, widest = 8;  // spacings; lattices in vortices are drawn to 5
  constexpr double near = 2.2;  // times the distance to the nearest are four others on a line, or 12
  constexpr long on_a_line = 6;
  std::vector<int> about;
  rows.each_within(centre, radius + beyond * spacing, [&](double, int row) { about.push_back(row); });
  const double across = radius / spacing + beyond;
  if (2 * radius > widest * spacing ||
      static_cast<double>(about.size()) < all_there * std::numbers::pi * across * across)
    return as_sound;
  std::vector<double> nearest;
  for (const int row : about) {
    double least = as_sound * spacing * as_sound * spacing;
    rows.each_within(rows.places().col(row), as_sound * spacing, [&](double square, int other) {
      if (other != row) least = std::min(least, square);
    });
    long others = -1;
    rows.each_within(rows.places().col(row), near * std::sqrt(least), [&](double, int) { ++others; });
    nearest.push_back(others > on_a_line ? as_sound : std::sqrt(least) / spacing);
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

/// Where cells are empty, from the middle of the widest parts on; of others a few, so that there is a value.
void find_hole(const RowsByCell& rows, const Region& region, double spacing, Coverage& found) {
  constexpr long near = 2, wide = 8;  // cells
  constexpr std::size_t most_refined = 64, most_wide = 4;
  const std::vector<unsigned short> cells = cells_to_a_row(rows, region.domain);
  std::vector<Circle> circles;
  const long all = rows.columns() * rows.lines(), every = std::max(1L, all / 256);
  for (long k = 0; k < all; ++k) {
    const long apart = cells[static_cast<std::size_t>(k)];
    if (apart == 0 && k % every != 0) continue;
    const Vec2 centre = rows.centre(k % rows.columns(), k / rows.columns());
    const double radius = apart <= near ? free_radius(rows, region, spacing, centre)
                                        : std::min((static_cast<double>(apart) - 0.5) * rows.side(),
                                                   depth_in(region, centre) + spacing / 2);
    if (radius >= 0) circles.push_back({radius, centre});
  }
  const auto end = circles.begin() + static_cast<std::ptrdiff_t>(std::min(most_refined, circles.size()));
  const auto wider = [](const Circle& a, const Circle& b) { return a.radius > b.radius; };
  std::partial_sort(circles.begin(), end, circles.end(), wider);
  std::size_t count_of_wide = 0;
  for (auto one = circles.begin(); one != end; ++one) {
    if (one->radius > wide * rows.side() && ++count_of_wide > most_wide) continue;
    Circle circle{free_radius(rows, region, spacing, one->centre), one->centre};
    if (circle.radius <= wide * rows.side()) circle = widest_near(rows, region, spacing, circle);
    double hole = 2 * circle.radius / spacing;
    if (hole <= found.hole) continue;
    hole *= apart_about(rows, spacing, circle.centre, circle.radius) / as_sound;
    if (!(hole <= found.hole)) found.hole = hole, found.hole_at = circle.centre;
  }
}

/// The gaps [m] between the coordinates of rows along an axis, and between the last of them and a wall, that are wider
/// than `least`.
std::vector<Range> gaps_along(const Vectors& x, const Region& region, int axis, double least) {
  const bool is_periodic = region.domain.periodic(axis);
  const Box& box = is_periodic ? region.domain.box : region.box;
  const double low = box.low[axis], high = box.high[axis];
  const auto parts = std::clamp(static_cast<long>((high - low) / least), 1L, 4L * static_cast<long>(x.cols()) + 64);
  std::vector<Range> ends(static_cast<std::size_t>(parts), {INFINITY, -INFINITY});  // of rows in a part
  for (const double at : x.row(axis)) {
    const double part = (at - low) / (high - low) * static_cast<double>(parts);
    auto& [first, last] = ends[static_cast<std::size_t>(std::clamp(static_cast<long>(part), 0L, parts - 1))];
    first = std::min(first, at), last = std::max(last, at);
  }
  std::erase_if(ends, [](const Range& part) { return part.low > part.high; });
  std::vector<Range> gaps;
  double before = is_periodic ? ends.back().high - (high - low) : low;
  for (const auto& [first, last] : ends) {
    if (first - before > least) gaps.push_back({before, first});
    before = last;
  }
  if (!is_periodic && high - before > least) gaps.push_back({before, high});
  return gaps;
}

/// A strip without rows from one side of the region to the other: as the circle of that part of its area by which it is
/// wider than lines of a lattice are apart.
void find_strip(const Vectors& x, const Region& region, double spacing, Coverage& found) {
  constexpr long per_spacing = 4;  // places, along each axis
  const auto steps = [&](double length) { return static_cast<long>(std::ceil(per_spacing * length / spacing)); };
  for (const int axis : {0, 1}) {
    const int across = 1 - axis;
    const double line = spacing * region.drawn[axis], length = region.box.size()[across];
    for (const auto& [begin, end] : gaps_along(x, region, axis, line)) {
      const long wide = steps(end - begin), many = steps(length);
      double area = 0;
      Vec2 sum = Vec2::Zero();
      for (long j = 0; j < many; ++j) {
        long inside = 0;
        Vec2 of_inside = Vec2::Zero();
        for (long i = 0; i < wide; ++i) {
          Vec2 place;
          place[axis] = begin + (end - begin) * (static_cast<double>(i) + 0.5) / static_cast<double>(wide);
          place[across] = region.box.low[across] + length * (static_cast<double>(j) + 0.5) / static_cast<double>(many);
          if (!region.depth || region.depth(place) >= 0) ++inside, of_inside += place;
        }
        const double wider = (end - begin) * static_cast<double>(inside) / static_cast<double>(wide) - line;
        if (!(wider > 0)) continue;
        area += wider * length / static_cast<double>(many);
        sum += wider * length / static_cast<double>(many) * of_inside / static_cast<double>(inside);
      }
      const double hole = 2 * std::sqrt(area / std::numbers::pi) / spacing;
      if (!(hole > found.hole)) continue;
      found.hole = hole, found.hole_at = sum / area;
      found.hole_at[axis] = region.domain.wrapped(axis, found.hole_at[axis]);
    }
  }
}

bool is_on_periodic_boundary(const Domain& domain, const Vec2& place, double off) {
  for (const int axis : {0, 1})
    if (domain.periodic(axis) &&
        std::min(place[axis] - domain.box.low[axis], domain.box.high[axis] - place[axis]) <= off)
      return true;
  return false;
}

void find_crowds(const RowsByCell& rows, const Domain& domain, double spacing, Coverage& found) {
  const double near = spacing / 4;
  const Vectors& x = rows.places();
  long crowded = 0;
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    const Vec2 place = x.col(p);
    double least = INFINITY;
    bool is_second = false;
    rows.each_within(place, near, [&](double square, int row) {
      if (row == p) return;
      least = std::min(least, square);
      is_second |= square <= same * spacing * same * spacing && row < p;
    });
    if (!std::isfinite(least) || is_on_periodic_boundary(domain, place, same * spacing)) continue;
    if (is_second && found.in_one_place++ == 0) found.in_one_place_at = place;
    if (std::sqrt(least) < rows.distance_to_fourth(place) / 4 && crowded++ == 0) found.crowded_at = place;
  }
  found.crowded = static_cast<double>(crowded) / static_cast<double>(x.cols());
}

/// The different coordinates of rows along an axis, rising; none where they are too many to be those of a grid.
std::vector<double> lines_along(const Vectors& x, int axis, const Box& box) {
  constexpr long parts = 10'000'000, together = 20;  // that many parts of a length are rounding
  const double low = box.low[axis], part = box.size().maxCoeff() / parts;
  std::vector<bool> is_taken(parts + 1, false);
  std::vector<long> rising;
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    const long key = std::clamp(std::lround((x(axis, p) - low) / part), 0L, parts);
    if (is_taken[static_cast<std::size_t>(key)]) continue;
    is_taken[static_cast<std::size_t>(key)] = true;
    rising.push_back(key);
    if (rising.size() > 8192 + static_cast<std::size_t>(p) / 2) return {};
  }
  std::ranges::sort(rising);
  std::vector<double> lines;
  for (std::size_t k = 0; k < rising.size(); ++k)
    if (k == 0 || rising[k] - rising[k - 1] > together) lines.push_back(low + static_cast<double>(rising[k]) * part);
  return lines;
}

/// A gap between lines.
struct Gap {
  double ratio = 0;  // of its width to that of the wider one beside it
  double at = 0;     // m  its middle
};

/// The widest one between lines, or between the last of them and a wall.
Gap widest_gap(const std::vector<double>& lines, const Domain& domain, const Box& box, int axis) {
  Gap widest;
  const auto take = [&](double gap, double beside, double at) {
    if (beside > 0 && gap / beside > widest.ratio) widest = {gap / beside, at};
  };
  const std::size_t n = lines.size();
  if (n < 2) return widest;
  std::vector<double> gaps;
  for (std::size_t k = 1; k < n; ++k) gaps.push_back(lines[k] - lines[k - 1]);
  if (domain.periodic(axis)) {
    const double period = domain.box.high[axis] - domain.box.low[axis];
    if (const double last = lines[0] + period - lines[n - 1]; last > 1e-5 * period) gaps.push_back(last);
    const std::size_t m = gaps.size();
    for (std::size_t k = 0; k < m && m > 1; ++k)
      take(gaps[k], std::max(gaps[(k + 1) % m], gaps[(k + m - 1) % m]), lines[k] + gaps[k] / 2);
    return widest;
  }
  for (std::size_t k = 0; k < gaps.size() && gaps.size() > 1; ++k)
    take(gaps[k], std::max(k > 0 ? gaps[k - 1] : 0, k + 1 < gaps.size() ? gaps[k + 1] : 0), lines[k] + gaps[k] / 2);
  take(lines[0] - box.low[axis], gaps.front(), (lines[0] + box.low[axis]) / 2);
  take(box.high[axis] - lines[n - 1], gaps.back(), (lines[n - 1] + box.high[axis]) / 2);
  return widest;
}

/// The line nearest to a value, from that of the row before on: rows of a grid mostly follow it.
std::size_t nearest_line(const std::vector<double>& lines, double value, std::size_t from) {
  for (const std::size_t k : {from, from + 1, std::size_t{0}})
    if (k < lines.size() && (k == 0 || value - lines[k - 1] > lines[k] - value) &&
        (k + 1 == lines.size() || lines[k + 1] - value >= value - lines[k]))
      return k;
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(lines, value) - lines.begin());
  if (after == 0) return 0;
  return after == lines.size() || value - lines[after - 1] < lines[after] - value ? after - 1 : after;
}

void find_grid(const Vectors& x, const Region& region, double spacing, Coverage& found) {
  if (region.depth || !region.is_known) return;
  const std::array<std::vector<double>, 2> lines{lines_along(x, 0, region.domain.box),
                                                 lines_along(x, 1, region.domain.box)};
  const std::size_t columns = lines[0].size(), places = columns * lines[1].size();
  if (columns < 2 || lines[1].size() < 2 || static_cast<double>(places) > 1.25 * static_cast<double>(x.cols())) return;
  std::vector<bool> taken(places, false);
  std::size_t column = 0, line = 0;
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    column = nearest_line(lines[0], x(0, p), column);
    line = nearest_line(lines[1], x(1, p), line);
    if (taken[column + columns * line] && !is_on_periodic_boundary(region.domain, x.col(p), same * spacing) &&
        found.in_one_place++ == 0)
      found.in_one_place_at = x.col(p);
    taken[column + columns * line] = true;
  }
  found.grid_places = static_cast<long>(places);
  found.empty_places = std::ranges::count(taken, false);
  if (found.empty_places > 0) {
    const auto first = static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin());
    found.empty_at = {lines[0][first % columns], lines[1][first / columns]};
  }
  found.hole = std::numbers::sqrt2;
  for (const int axis : {0, 1})
    if (const auto [ratio, at] = widest_gap(lines[static_cast<std::size_t>(axis)], region.domain, region.box, axis);
        std::numbers::sqrt2 * ratio > found.hole) {
      found.hole = std::numbers::sqrt2 * ratio;
      found.hole_at = (region.box.low + region.box.high) / 2;
      found.hole_at[axis] = at;
    }
}

}  // namespace

Coverage coverage_of(const Vectors& x, double spacing, const Region& region) {
  Coverage found;
  find_grid(x, region, spacing, found);
  if (found.grid_places > 0) return found;  // whose lines have been compared with one another
  const RowsByCell rows(x, spacing, region.domain);
  find_crowds(rows, region.domain, spacing, found);
  if (!region.is_known) return found;
  find_hole(rows, region, spacing, found);
  if (found.hole <= largest_sound_hole(static_cast<double>(x.cols()))) find_strip(x, region, spacing, found);
  return found;
}

double largest_sound_hole(double rows) {
  const double n = std::max(rows, 3.0);
  double area = std::log(n / 0.05);
  for (int k = 0; k < 20; ++k) area = std::log(n * area / 0.05);
  return std::min(2 * std::sqrt(area / std::numbers::pi), 3.9);
}

double most_crowded(double rows) { return std::min(0.9, 0.25 + 1 / std::sqrt(rows)); }

std::vector<Value> values_of(const Coverage& coverage, const Level& level, double time) {
  std::vector<Value> found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({level.name, level.spacing, time, quantity, value});
  };
  add(largest_hole, coverage.hole);
  add(rows_in_one_place, static_cast<double>(coverage.in_one_place));
  if (coverage.grid_places > 0)
    add(empty_places_of_grid, static_cast<double>(coverage.empty_places));
  else
    add(rows_crowded, 100 * coverage.crowded);
  return found;
}

bool is_of_coverage(const std::string& quantity) {
  return quantity == largest_hole.name || quantity == rows_in_one_place.name || quantity == rows_crowded.name ||
         quantity == empty_places_of_grid.name;
}

Claim claim_of_coverage(const Quantity& quantity, double rows) {
  if (quantity == rows_in_one_place) return at_most(quantity, 0, theory("no two parts of a fluid are in one place"));
  const double most = quantity == largest_hole   ? largest_sound_hole(rows)
                      : quantity == rows_crowded ? 100 * most_crowded(rows)
                                                 : 0;
  return at_most(quantity, most, theory("an incompressible fluid fills its domain"));
}

std::vector<Claim> fills_its_region(const Coverage& coverage, double rows) {
  const bool is_grid = coverage.grid_places > 0;  // which may be stretched and graded
  std::vector<Claim> claims;
  for (const Quantity& one : {largest_hole, rows_in_one_place, is_grid ? empty_places_of_grid : rows_crowded})
    claims.push_back(claim_of_coverage(one, rows));
  if (is_grid) claims.front().upper = std::numbers::sqrt2 * widest_sound_gap;
  return claims;
}

std::string where_is(const Coverage& coverage, const std::string& quantity) {
  for (const auto& [name, at] :
       {std::pair(largest_hole.name, coverage.hole_at), std::pair(rows_in_one_place.name, coverage.in_one_place_at),
        std::pair(rows_crowded.name, coverage.crowded_at), std::pair(empty_places_of_grid.name, coverage.empty_at)})
    if (name == quantity) return fmt::format("at ({:.4g}, {:.4g}) m", at.x(), at.y());
  return "";
}

bool fills_its_domain(const Level& level, const Run& run) {
  if (!run.room || !run.room->is_full()) return false;
  const double places = run.room->domain.box.size().prod() / (level.spacing * level.spacing);
  return static_cast<double>(run.summary.cost.particles) > 0.9 * places;  // else of a shape, as a drop
}

std::vector<Value> coverage_of(const Level& level, const Run& run) {
  if (!run.room || !run.summary.finished || run.samples.empty()) return {};
  const bool is_full = fills_its_domain(level, run);
  double hole = 0, in_one_place = 0, crowded = 0;
  for (const Samples& samples : run.samples) {
    const Coverage found = coverage_of(samples.x, level.spacing, {.domain = run.room->domain, .is_known = is_full});
    hole = std::max(hole, found.hole);
    in_one_place = std::max(in_one_place, static_cast<double>(found.in_one_place));
    crowded = std::max(crowded, 100 * found.crowded);
  }
  std::vector<Value> values;
  const auto add = [&](const Quantity& quantity, double value) {
    values.push_back({level.name, level.spacing, run.summary.end_time, quantity, value});
  };
  if (is_full) add(largest_hole, hole);
  add(rows_in_one_place, in_one_place);
  add(rows_crowded, crowded);
  return values;
}

}  // namespace touchstone::vnv
