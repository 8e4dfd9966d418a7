/// The manufactured solution, refined in one direction at a time: cells of the grid, points in a cell and the time step
/// of the material point method; kernel, spacing within it and the time step of smoothed particle hydrodynamics.

#include "vnv/flows/manufactured.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;
using namespace touchstone::vnv::manufactured;

namespace {

/// One point of the surface of errors.
struct Point {
  int across;      // cells, or lengths of 1.3 spacings that h is long
  double finer;    // points along a cell, or h over the spacing
  double courant;  // acoustic Courant number, by the cell or the spacing
  bool quick;      // in the suite acceptance too
};

/// A direction of refinement: the points of `levels` along which all else is equal.
std::string cells_at(double points) { return fmt::format("cells of {0:g} x {0:g} points", points); }
const std::string points_in_cells = "points in 32 cells across";
std::string kernels_at(double ratio) { return fmt::format("h at h / spacing = {:g}", ratio); }
const std::string spacing_in_kernels = "spacing at h = 1.3 / 32 m";

Level with_suites(Level level, bool quick) {
  level.acceptance = quick ? end : 0;
  level.nightly = end;
  return level;
}

Level mpm_level(const Point& p) {
  const double cell = side / p.across;
  return with_suites(
      {.name = fmt::format("{0} cells, {1:g} x {1:g} points, c dt = {2:g} cells", p.across, p.finer, p.courant),
       .spacing = cell / p.finer,
       .cell = cell,
       .time_step = step_for(scene(), p.courant, cell, output_interval)},
      p.quick);
}
Level sph_level(const Point& p) {
  const double h = 1.3 * side / p.across, spacing = side / std::round(side * p.finer / h);
  return with_suites(
      {.name = fmt::format("h = 1.3 / {} m, {:g} spacings, c dt = {:g} spacings", p.across, p.finer, p.courant),
       .spacing = spacing,
       .smoothing_length = h,
       .time_step = step_for(scene(), p.courant, spacing, output_interval)},
      p.quick);
}

constexpr std::array cells = {16, 24, 32, 48};
constexpr std::array points = {2.0, 3.0, 4.0};
constexpr std::array ratios = {1.3, 1.6, 2.0};
constexpr std::array courants = {0.15, 0.075};
constexpr double courant_of_all = 0.3;

std::vector<Point> surface(const auto& finer) {
  std::vector<Point> all;
  for (const double f : finer)
    for (const int n : cells) all.push_back({n, f, courant_of_all, n <= 24 && f == finer[0]});
  for (const double courant : courants) all.push_back({32, finer[0], courant, false});
  return all;
}

/// A method over the whole surface, with a ladder along each of its lines.
Method over_surface(Method method, const std::vector<Point>& all, Level (*level_of)(const Point&),
                    std::string (*along)(double), const std::string& within) {
  for (const Point& p : all) method.levels.push_back(level_of(p));
  const auto ladder = [&](const std::string& name, auto&& on) {
    Ladder line{name, {}};
    for (const Point& p : all)
      if (p.courant == courant_of_all && on(p)) line.levels.push_back(level_of(p).name);
    method.ladders.push_back(std::move(line));
  };
  for (const Point& p : all)
    if (p.across == cells[0]) ladder(along(p.finer), [&](const Point& other) { return other.finer == p.finer; });
  ladder(within, [](const Point& p) { return p.across == 32; });
  return method;
}

/// Error over the time step, the rest being equal.
void over_time_steps(const Results& results, Record& record) {
  record.figures.push_back(
      {"time_step",
       "Error against time step",
       fmt::format("L2 error of the velocity, particle by particle, at t = {:g} s; 32 cells across with "
                   "2 x 2 points each, or h = 1.3 / 32 m with 1.3 spacings in it.",
                   end),
       {.label = "time step [ms]", .scale = 1e3, .logarithmic = true},
       {.label = "L2 v [%]", .logarithmic = true}});
  const Ladder& coarsest = results.method.ladders.front();
  Curve curve{"time_step", results.method.name, Role::ours, {}, {}, false};
  for (const Level& level : results.method.levels) {
    const Level& first = *std::ranges::find(results.method.levels, coarsest.levels[2], &Level::name);
    const Run* run = results.run(level.name);
    if (!run || level.spacing != first.spacing) continue;
    if (const auto error = error_of(l2_velocity, end)(record, *run)) {
      curve.x.push_back(run->summary.time_step);
      curve.y.push_back(*error);
    }
  }
  if (!curve.x.empty()) record.curves.push_back(std::move(curve));
}

}  // namespace

Case vnv::the_case() {
  const Method mpm = mpm_least_squares(scene(), output_interval), sph = sph_second_order(scene(), output_interval);
  const Flow flow = flow_named("manufactured");
  return {
      .title = "Refinement of cells, particles and time step separately",
      .description =
          "The manufactured solution. A material point method is refined by finer cells, by more points in each, or "
          "by shorter steps; smoothed particle hydrodynamics by a shorter smoothing length h, by more particles within "
          "it, or by shorter steps. Only refining cells or kernels reduces the second-order error; the other ladders show "
          "the remaining error.",
      .times = {end},
      .measurements = {velocity_errors(flow.velocity()), pressure_errors(flow.pressure())},
      .methods = {over_surface(mpm, surface(points), mpm_level, cells_at, points_in_cells),
                  over_surface(sph, surface(ratios), sph_level, kernels_at, spacing_in_kernels)},
      .plots = {error_against_spacing("surface", "Error against spacing, each parameter refined separately",
                                      "L2 error of the velocity at the end; each line refines one parameter.",
                                      "L2 v [%]", l2_velocity, end),
                over_time_steps}};
}
