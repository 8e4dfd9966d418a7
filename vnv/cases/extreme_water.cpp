/// Extreme free-surface scenes, each with its outcome declared in advance.

#include "solvers/walls/free_slip.hpp"
#include "vnv/methods/free_surface_methods.hpp"
#include "vnv/stability/extreme.hpp"
#include "vnv/stability/lattice_starts.hpp"

#include <algorithm>
#include <cmath>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

using Water = Scene<Newtonian, Uniform>;

constexpr double spacing = 0.02, cell = 2 * spacing, g = 9.81, c = 40;  // m, m, m/s², m/s
constexpr double output_interval = 0.01;                                // s  of which every step divides all times
constexpr Newtonian water{{.density = 1000, .bulk_modulus = 1000 * c * c / 7}, 1e-3};

Box box(double width, double height) { return {.high = {width, height}}; }
Box around(const Vec2& centre, double x, double y) { return {.low = centre - Vec2(x, y), .high = centre + Vec2(x, y)}; }

/// Water far from all walls, under a body force along y [m/s²].
Water falling(const Box& domain, const Box& filled, const Start& start, double force = -g) {
  return {.domain = {.box = domain}, .fluid = water, .filled = filled, .body_force = {{0, force}}, .start = start};
}
/// Water in a tank.
Water in_tank(const Box& tank, const Box& filled, const Start& start = {}) {
  Water scene = falling(tank, filled, start);
  scene.walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank.high.x(), free_slip())};
  return scene;
}
/// Water on a floor without end.
Water on_floor(const Box& period, const Box& filled, const Start& start = {}, double force = -g) {
  Water scene = falling(period, filled, start, force);
  scene.domain.periodic_x = true;
  scene.walls = {floor_at(0, free_slip())};
  return scene;
}

/// The middle of all particles [m].
Vec2 middle(const Samples& s) { return s.x.rowwise().mean(); }

/// Those places within a radius [m] of any of the centres [m].
std::function<Vectors(const Vectors&)> within(double radius, std::vector<Vec2> centres) {
  return [=](const Vectors& lattice) -> Vectors {
    std::vector<Eigen::Index> inside;
    for (Eigen::Index p = 0; p < lattice.cols(); ++p)
      if (std::ranges::any_of(centres, [&](const Vec2& at) { return (lattice.col(p) - at).norm() < radius; }))
        inside.push_back(p);
    return lattice(Eigen::all, inside);
  };
}

/// A scene, and what is exact of it.
struct Setting {
  std::string name;
  Water scene;
  double end;  // s
  Ending declared;
  std::function<double(const Samples&)> error{};  // %
  double accurate_within = 0;                     // %
  double cell_size = cell;                        // m
  bool in_acceptance = true;
};

Setting one_particle() {
  const Vec2 start(0.5 + spacing / 2, 1.5 + spacing / 2);
  constexpr double end = 0.4, fall = g / 2 * end * end;
  return {.name = "one particle",
          .scene = falling(box(1, 2), box(1, 2), {.places = within(0.01, {start})}),
          .end = end,
          .declared = Ending::accurate,
          .error = [=](const Samples& s) { return 100 * (middle(s) - start + Vec2(0, fall)).norm() / fall; },
          .accurate_within = 1};
}

Setting one_cell() {
  const Box cell_of_water = box(4 * spacing, 4 * spacing);
  return {.name = "one cell",
          .scene = in_tank(cell_of_water, cell_of_water),
          .end = 0.5,
          .declared = Ending::stable,
          .cell_size = 4 * spacing};
}

Setting single_row() {
  return {.name = "a single row",
          .scene = on_floor(box(0.4, 0.2), box(0.4, spacing)),
          .end = 0.5,
          .declared = Ending::stable};
}

Setting on_edges() {
  constexpr double side = 0.4;
  // Stretched, so that the outermost stand on the edges and two in corners.
  const auto to_the_edges = [side](const Vectors& lattice) -> Vectors {
    return ((lattice.array() - side / 2) * (side / (side - spacing)) + side / 2).min(side).max(0);
  };
  return {.name = "particles on edges and in corners",
          .scene = in_tank(box(side, 0.6), box(side, side), {.places = to_the_edges}),
          .end = 0.3,
          .declared = Ending::stable};
}

/// Sound is a quarter as fast as ten times sqrt(g H), and the floor compresses water by a fifth. Its start is uneven: a
/// perfect lattice stays one until rounding has grown, and how it ends then would be a matter of the build.
Setting heavy() {
  const auto uneven = [](const Vectors& lattice) {
    Vectors places = lattice;
    for (Eigen::Index p = 0; p < places.cols(); ++p)
      places.col(p) += spacing / 100 * Vec2(noise(p, 0, 0), noise(p, 0, 1));
    return places;
  };
  return {.name = "gravity x 100",
          .scene = on_floor(box(0.3, 0.6), box(0.3, 0.3), {.places = uneven}, -100 * g),
          .end = 0.2,
          .declared = Ending::stable};
}

Setting empty_background() {
  constexpr double radius = 0.06, side = 3.4;  // of a drop of a thousandth of the domain
  const Vec2 start(side / 2, side / 2), v(1, 0.5);
  return {.name = "a thousand times as much nothing",
          .scene = falling(box(side, side), around(start, 0.1, 0.1),
                           {.velocity = [=](const Vec2&) { return v; }, .places = within(radius, {start})}, 0),
          .end = 1,
          .declared = Ending::accurate,
          .error = [=](const Samples& s) { return 100 * (middle(s) - start - v).norm() / v.norm(); },
          .accurate_within = 0.1};
}

Setting falling_drop() {
  constexpr double radius = 0.1, end = 1.5, fall = g / 2 * end * end;
  const Vec2 start(0.25, 12);
  // Its centre of mass is in free fall, and its width is constant.
  const auto error = [=](const Samples& s) {
    const double width = s.x.row(0).maxCoeff() - s.x.row(0).minCoeff();
    return 100 * std::max((middle(s) - start + Vec2(0, fall)).norm() / fall, std::abs(width / (2 * radius) - 1) - 0.1);
  };
  return {.name = "a drop in free fall",
          .scene = falling(box(0.5, 12.5), around(start, 0.12, 0.12), {.places = within(radius, {start})}),
          .end = end,
          .declared = Ending::accurate,
          .error = error,
          .accurate_within = 1};
}

Setting jet() {
  const auto every_third = [](const Vectors& lattice) -> Vectors {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index p = 0; p < lattice.cols(); p += 3) kept.push_back(p);
    return lattice(Eigen::all, kept);
  };
  return {.name = "a jet of single particles",
          .scene = in_tank(box(1, 6), {.low = {0, 0.4}, .high = {0.8, 0.42}},  // printed MPM throws some up by 2.6 m
                           {.velocity = [](const Vec2&) { return Vec2(5, 1); }, .places = every_third}),
          .end = 0.4,
          .declared = Ending::stable};
}

Setting colliding_drops() {
  const Start approaching{.velocity = [](const Vec2& x) { return Vec2(x.x() < 0.5 ? 2 : -2, 0); },
                          .places = within(0.1, {{0.35, 0.5}, {0.65, 0.52}})};
  return {.name = "colliding drops",
          .scene = falling(box(1, 1), {.low = {0.2, 0.3}, .high = {0.8, 0.7}}, approaching, 0),
          .end = 0.1,
          .declared = Ending::stable};
}

Setting tension() {
  const Vec2 centre(0.5, 0.5);
  const Start parting{.velocity = [=](const Vec2& x) { return Vec2(20 * (x - centre)); },
                      .places = within(0.15, {centre})};
  return {.name = "a drop torn apart",
          .scene = falling(box(1, 1), {.low = {0.3, 0.3}, .high = {0.7, 0.7}}, parting, 0),
          .end = 0.05,
          .declared = Ending::stable};
}

std::vector<Setting> settings() {
  return {one_particle(),     one_cell(),     single_row(), on_edges(),        heavy(),
          empty_background(), falling_drop(), jet(),        colliding_drops(), tension()};
}

/// Exceptions by method, and why.
Ending declared_of(const Setting& setting, const Method& of_method) {
  // Walls of SPH are made of particles, and do not take fluid that stands on them.
  if (of_method.family == Family::sph && setting.name == "particles on edges and in corners") return Ending::refused;
  return setting.declared;
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
                        .declared = declared_of(setting, here),
                        .in_acceptance = setting.in_acceptance});
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
