/// Extreme free-surface scenes, each with its outcome declared in advance.

#include "solvers/walls/free_slip.hpp"
#include "vnv/methods/free_surface_methods.hpp"
#include "vnv/stability/extreme.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/studies/starts.hpp"

#include <algorithm>
#include <cmath>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

using Water = Scene<Newtonian, Uniform>;

constexpr double spacing = 0.02, cell = 2 * spacing, g = 9.81, c = 40;  // m, m, m/s², m/s
constexpr double output_interval = 0.01;                                // s  of which every step divides all times
constexpr Newtonian water{{.density = 1000, .bulk_modulus = 1000 * c * c / 7}, 1e-3};

/// A scene, and what is exact of it: declared accurate if something is, otherwise stable.
struct Setting {
  std::string name;
  Water scene;
  double end;                                     // s
  std::function<double(const Samples&)> error{};  // %
  double accurate_within = 0;                     // %
  double cell_size = cell;                        // m
};

Box box(double width, double height) { return {.high = {width, height}}; }
Box around(const Vec2& centre, double far) { return {.low = centre.array() - far, .high = centre.array() + far}; }

/// Water far from all walls, under a body force along y [m/s²].
Water falling(const Box& domain, const Box& filled, const Start& start, double force = -g) {
  return {.domain = {.box = domain}, .fluid = water, .filled = filled, .body_force = {{0, force}}, .start = start};
}
Water in_tank(const Box& tank, const Box& filled, const Start& start = {}) {
  Water scene = falling(tank, filled, start);
  scene.walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank.high.x(), free_slip())};
  return scene;
}
/// On a floor without end.
Water on_floor(const Box& period, const Box& filled, const Start& start = {}, double force = -g) {
  Water scene = falling(period, filled, start, force);
  scene.domain.periodic_x = true;
  scene.walls = {floor_at(0, free_slip())};
  return scene;
}

/// Stretched, so that the outermost stand on the edges of a square and two in corners.
Vectors to_the_edges(const Vectors& lattice) {
  constexpr double side = 0.4;
  return ((lattice.array() - side / 2) * (side / (side - spacing)) + side / 2).min(side).max(0);
}
/// A perfect lattice stays one until rounding has grown, and how it ends then would be a matter of the build.
Vectors uneven(const Vectors& lattice) {
  Vectors places = lattice;
  for (Eigen::Index p = 0; p < places.cols(); ++p)
    places.col(p) += spacing / 100 * Vec2(noise(p, 0, 0), noise(p, 0, 1));
  return places;
}
Vectors every_third(const Vectors& lattice) { return lattice(Eigen::all, Eigen::seq(0, lattice.cols() - 1, 3)); }

Vec2 fallen(double time) { return {0, -g / 2 * time * time}; }

/// How far the middle of all particles is from where it should have moved to [%].
double off(const Samples& s, const Vec2& start, const Vec2& way) {
  return 100 * (s.x.rowwise().mean() - start - way).norm() / way.norm();
}
/// The width of a drop is constant, to a tenth.
double off_width(const Samples& s, double width) {
  return 100 * (std::abs((s.x.row(0).maxCoeff() - s.x.row(0).minCoeff()) / width - 1) - 0.1);
}

std::vector<Setting> settings() {
  const Vec2 one(0.5 + spacing / 2, 1.5 + spacing / 2), high(0.25, 12), far(1.7, 1.7), v(1, 0.5), centre(0.5, 0.5);
  const auto parting = [=](const Vec2& x) -> Vec2 { return 20 * (x - centre); };
  const auto approaching = [](const Vec2& x) { return Vec2(x.x() < 0.5 ? 2 : -2, 0); };
  return {{"one particle", falling(box(1, 2), box(1, 2), {.places = within(0.01, {one})}), 0.4,
           [=](const Samples& s) { return off(s, one, fallen(0.4)); }, 1},
          {"one cell", in_tank(box(2 * cell, 2 * cell), box(2 * cell, 2 * cell)), 0.5, {}, 0, 2 * cell},
          {"a single row", on_floor(box(0.4, 0.2), box(0.4, spacing)), 0.5},
          {"particles on edges and in corners", in_tank(box(0.4, 0.6), box(0.4, 0.4), {.places = to_the_edges}), 0.3},
          // Sound is a quarter as fast as ten times sqrt(g H), and the floor compresses water by a fifth.
          {"gravity x 100", on_floor(box(0.3, 0.6), box(0.3, 0.3), {.places = uneven}, -100 * g), 0.2},
          // A drop of a thousandth of the domain.
          {"a thousand times as much nothing",
           falling(box(3.4, 3.4), around(far, 0.1),
                   {.velocity = [=](const Vec2&) { return v; }, .places = within(0.06, {far})}, 0),
           1, [=](const Samples& s) { return off(s, far, v); }, 0.1},
          {"a drop in free fall", falling(box(0.5, 12.5), around(high, 0.12), {.places = within(0.1, {high})}), 1.5,
           [=](const Samples& s) { return std::max(off(s, high, fallen(1.5)), off_width(s, 0.2)); }, 1},
          {"a jet of single particles",
           in_tank(box(1, 6), {.low = {0, 0.4}, .high = {0.8, 0.42}},  // printed MPM throws some up by 2.6 m
                   {.velocity = [](const Vec2&) { return Vec2(5, 1); }, .places = every_third}),
           0.4},
          {"colliding drops",
           falling(box(1, 1), {.low = {0.2, 0.3}, .high = {0.8, 0.7}},
                   {.velocity = approaching, .places = within(0.1, {{0.35, 0.5}, {0.65, 0.52}})}, 0),
           0.1},
          {"a drop torn apart",
           falling(box(1, 1), around(centre, 0.2), {.velocity = parting, .places = within(0.15, {centre})}, 0), 0.05}};
}

template <class Make>
Method method_meeting_extremes(Make make) {
  std::vector<Extreme> extremes;
  for (const Setting& setting : settings()) {
    const Method here = make(setting.scene);
    const Level level{.spacing = spacing, .cell = setting.cell_size};
    extremes.push_back({.name = setting.name,
                        .make = [=] { return here.solver(level, here.time_step(level)); },
                        .end = setting.end,
                        .error = setting.error,
                        .accurate_within = setting.accurate_within,
                        .declared = setting.error ? Ending::accurate : Ending::stable});
    // Walls of SPH are made of particles, and do not take fluid that stands on them.
    if (here.family == Family::sph && setting.name == "particles on edges and in corners")
      extremes.back().declared = Ending::refused;
  }
  return meeting(make(settings().front().scene), extremes);
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Extreme free-surface scenes",
      .description =
          "Very little water, or very strong gravity: one particle, one cell, a single row; particles on the "
          "edges and in the corners of the domain; a hundredfold gravity; a drop in a domain a thousand times its size, one that "
          "falls 11 m, two that collide at 4 m/s, one that is torn apart; a jet whose particles do not touch. The "
          "particle spacing is 0.02 m, with four particles per cell; the speed of sound is 40 m/s. The outcome of each "
          "is declared in advance.",
      .times = {1},
      .measurements = {},
      .methods = {method_meeting_extremes([](const Water& s) { return mpm_as_printed(s, output_interval, 0.4); }),
                  method_meeting_extremes([](const Water& s) { return mpm_affine(s, output_interval, 0.4); }),
                  method_meeting_extremes([](const Water& s) { return mpm_apic(s, output_interval); }),
                  method_meeting_extremes([](const Water& s) { return mpm_xpic(s, output_interval); }),
                  method_meeting_extremes([](const Water& s) { return sph_as_printed(s, output_interval, 0.2); }),
                  method_meeting_extremes([](const Water& s) { return sph_delta(s, output_interval); }),
                  method_meeting_extremes([](const Water& s) { return sph_corrected(s, output_interval); })},
      .plots = {endings({"colliding drops", "a drop torn apart", "a jet of single particles", "gravity x 100"})},
      .label = "stability",
  };
}
