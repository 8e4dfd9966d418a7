#include "solvers/mpm/lanes/grid_to_particles_of_mls.hpp"

#include "solvers/mpm/lanes/in_lanes.hpp"

#include "solvers/mpm/start_tests.hpp"
#include "solvers/mpm/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <limits>

namespace touchstone::mpm {
namespace {

auto affine(const auto& scene, const Settings& settings) {
  return in_lanes<QuadraticBSpline, MlsApic>(scene, settings);
}

struct AffineMethod {
  static double left_by_damping(double k_cell, int steps) { return std::exp(-std::pow(k_cell, 4) / 40 * steps); }
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) { return affine(scene, settings); }
};
INSTANTIATE_TYPED_TEST_SUITE_P(Affine, MpmStart, AffineMethod);

constexpr Settings dam_settings{.cell = 0.1, .spacing = 0.04, .time_step = 4e-3};

Scene<Newtonian> plates() {
  return {.domain = {.box = {.high = {0.7, 1}}, .periodic_x = true},
          .fluid = {soft_water, 20},
          .filled = {.high = {0.7, 1}},
          .walls = {floor_at(0, no_slip()), ceiling_at(1, no_slip({0.1, 0}))}};
}
constexpr Settings plates_settings{.cell = 0.1, .spacing = 0.05, .time_step = 0.05};

template <class Solver>
void run(Solver& simulation, int steps) {
  for (int step = 0; step < steps; ++step) simulation.step();
}

void expect_same_bits(const Samples& a, const Samples& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}

TEST(Affine, KeepsItsMomentumWithoutWalls) {
  auto spinning = affine(drop(blow([](const Vec2& x) -> Vec2 {
                           return {40 * x.y() * x.y(), 30 * x.x()};
                         })),
                         {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  spinning.step();
  const auto momentum = [](const Samples& s) -> Vec2 { return s.v * s.mass.matrix(); };
  const Vec2 start = momentum(spinning.samples());
  run(spinning, 100);
  const Samples end = spinning.samples();
  EXPECT_LT((momentum(end) - start).norm(), 1e-12 * start.norm());
  EXPECT_GT(end.pressure.abs().maxCoeff(), 1);  // Pa: forces have been at work
}

TEST(Affine, CarriesAUniformFlowAcrossThePeriodicBoundary) {
  Scene<Tait, Uniform> stream{.domain = {.box = {.high = {0.7, 0.5}}, .periodic_x = true},
                              .fluid = soft_water,
                              .filled = {.high = {0.7, 0.5}},
                              .walls = {floor_at(0, free_slip()), ceiling_at(0.5, free_slip())},
                              .body_force = {{1, 0}}};
  auto accelerated = affine(stream, {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  const Samples start = accelerated.samples();
  run(accelerated, 100);
  const Samples end = accelerated.samples();
  const double moved = 0.505;  // m  v = t, explicit Euler
  for (int p = 0; p < end.size(); ++p) {
    EXPECT_NEAR(end.v(0, p), 1, 1e-12);
    EXPECT_NEAR(end.v(1, p), 0, 1e-12);
    EXPECT_NEAR(std::remainder(end.x(0, p) - start.x(0, p) - moved, 0.7), 0, 1e-12);
    EXPECT_NEAR(end.density[p], 1000, 1e-9);
  }
}

TEST(Affine, LeavesStillWaterStill) {
  Scene<Tait, Uniform> pond{.domain = {.box = {.high = {1, 1}}},
                            .fluid = soft_water,
                            .filled = {.high = {1, 0.5}},
                            .walls = {floor_at(0, free_slip()), left_at(0, no_slip()), right_at(1, free_slip())},
                            .body_force = {{0, 0}}};
  auto still = affine(pond, {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  const Samples start = still.samples();
  run(still, 10);
  expect_same_bits(still.samples(), start);
}

TEST(Affine, BearsItsWeight) {
  Scene<Tait, Uniform> pond = dam();
  pond.filled = {.high = {1, 0.6}};
  auto resting = affine(pond, dam_settings);
  double impulse = 0, time = 0;  // of the pressure at the floor, per area
  while (resting.time() < 20) {
    resting.step();
    if (resting.time() < 10) continue;
    const Samples s = resting.samples();
    const auto lowest = (s.x.row(1).array() < 0.04).cast<double>().transpose();
    impulse += (s.pressure * lowest).sum() / lowest.sum();
    time += 1;
  }
  const double depth = 0.58;  // m  of the lowest particles below the surface
  EXPECT_NEAR(impulse / time, 1000 * 1 * depth, 0.02 * 1000 * depth);
}

TEST(Affine, SettlesIntoTheStraightProfileBetweenMovingPlates) {
  auto dragged = affine(plates(), plates_settings);
  run(dragged, 8000);  // t = 8 diffusion times
  const Samples s = dragged.samples();
  for (int p = 0; p < s.size(); ++p) EXPECT_NEAR(s.v(0, p), 0.1 * s.x(1, p), 1e-6) << s.x(1, p);
}

TEST(Affine, HoldsADamBreakBetweenItsWalls) {
  auto breaking = affine(dam(), dam_settings);
  run(breaking, 1000);
  const Samples s = breaking.samples();
  EXPECT_GT(s.x.row(0).maxCoeff(), 0.95);  // it has reached the far wall
  EXPECT_LT(s.x.row(1).minCoeff(), 0.05);
  EXPECT_GE(s.x.minCoeff(), 0);
  EXPECT_LE(s.x.row(0).maxCoeff(), 1);
}

TEST(Affine, RerunsBitByBitOnAnyNumberOfThreads) {
  auto settings = dam_settings;
  auto between = plates_settings;
  auto first_dam = affine(dam(), settings);
  auto first_plates = affine(plates(), between);
  run(first_dam, 80);
  run(first_plates, 30);
  for (int threads : {1, 2, 3}) {
    settings.threads = between.threads = threads;
    auto again = affine(dam(), settings);
    run(again, 80);
    expect_same_bits(again.samples(), first_dam.samples());
    auto again_plates = affine(plates(), between);
    run(again_plates, 30);
    expect_same_bits(again_plates.samples(), first_plates.samples());
  }
}

TEST(Affine, NamesTheParticleThatWasSpoilt) {
  // In one step number 99 spoils two cells on every side.
  expect_stop_of_spoilt(affine(drop(spoilt()), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}), 77);
}

TEST(Affine, DiagnosesACollapse) {
  auto squeezed = affine(drop(blow([](const Vec2& x) -> Vec2 { return -500 * (x - Vec2(0.5, 0.5)); })),
                         {.cell = 0.1, .spacing = 0.1, .time_step = 0.05});
  EXPECT_THROW(run(squeezed, 20), Diverged);
}

/// A particle alone in the middle of a cell, at rest, around which the flow spreads so much in a step.
auto spreading(double in_a_step) {
  const Scene<Tait> scene{
      .domain = {.box = {.high = {1, 1}}},
      .fluid = soft_water,
      .filled = {.low = {0.4, 0.4}, .high = {0.5, 0.5}},
      .start = {.velocity = [=](const Vec2& x) -> Vec2 { return 50 * in_a_step * (x - Vec2(0.45, 0.45)); }}};
  return affine(scene, {.cell = 0.1, .spacing = 0.1, .time_step = 0.01});
}

TEST(Affine, DiagnosesADensityThatIsNotPlausibleInAParticleThatStaysInItsCell) {
  for (const double spread : {5.0, -0.85}) {  // a sixth of the density at rest, and seven times that
    auto alone = spreading(spread);
    EXPECT_THROW(alone.step(), Diverged) << spread;
  }
  for (const double spread : {3.5, -0.7}) {
    auto alone = spreading(spread);
    alone.step();
    EXPECT_NEAR(alone.samples().density[0], 1000 / (1 + spread), 1e-9);
  }
}

TEST(Affine, AStripMovesAlikeAtAPeriodicBoundaryAndAwayFromIt) {
  const auto strip_at = [](double low) {
    const Scene<Newtonian> scene{.domain = {.box = {.high = {0.7, 0.8}}, .periodic_x = true, .periodic_y = true},
                                 .fluid = {soft_water, 20},
                                 .filled = {.low = {0, low}, .high = {0.7, low + 0.2}},
                                 .start = {.velocity = [=](const Vec2& x) -> Vec2 {
                                   return {x.y() - low, std::sin(9 * x.x()) - 0.5};
                                 }}};
    auto strip = affine(scene, plates_settings);
    run(strip, 3);
    return strip.samples();
  };
  const Samples away = strip_at(0.3), at_boundary = strip_at(0);
  for (int p = 0; p < away.size(); ++p) {
    EXPECT_NEAR(at_boundary.v(0, p), away.v(0, p), 1e-12);
    EXPECT_NEAR(at_boundary.v(1, p), away.v(1, p), 1e-12);
    EXPECT_NEAR(std::remainder(at_boundary.x(1, p) - away.x(1, p) + 0.3, 0.8), 0, 1e-12);
  }
}

TEST(Affine, RefusesAWallOffTheGridAndSettingsThatAreNotPositive) {
  auto off = plates();
  off.walls[1].position = 0.97;
  EXPECT_THROW(affine(off, plates_settings), std::invalid_argument);
  for (double Settings::*setting : {&Settings::cell, &Settings::spacing, &Settings::time_step}) {
    Settings wrong = plates_settings;
    wrong.*setting = 0;
    EXPECT_THROW(affine(plates(), wrong), std::invalid_argument);
  }
  Settings threadless = plates_settings;
  threadless.threads = 0;
  EXPECT_THROW(affine(plates(), threadless), std::invalid_argument);
}

// The fast transfer against a plain loop over particles and their nine nodes.

Mat2 stress_of(const Tait& fluid, const Mat2&, double rho) { return -fluid.pressure(rho) * Mat2::Identity(); }
Mat2 stress_of(const Newtonian& fluid, const Mat2& gradient, double rho) {
  const Mat2 rate = (gradient + gradient.transpose()) / 2;
  const Mat2 deviatoric = rate - rate.trace() / 3 * Mat2::Identity();
  return 2 * fluid.viscosity * deviatoric - fluid.pressure(rho) * Mat2::Identity();
}

/// What the image of a particle behind a wall does with a velocity: `keeps` of it and `adds` to it.
struct PlainMirror {
  int axis, ghosts, inner;
  Vec2 keeps, adds;

  Vec2 image(const Vec2& v) const { return keeps.cwiseProduct(v) + adds; }
};

/// The textbook loop, on as many nodes as there are cells and a ring of ghosts.
template <class FluidLaw>
struct Plain {
  struct Particle {
    Vec2 x, v;
    Mat2 C, stress;
    double mass, rho;
  };
  struct Node {
    double mass = 0;
    Vec2 momentum = Vec2::Zero(), v = Vec2::Zero();
  };

  Scene<FluidLaw, ForceField> scene;
  int columns, rows;
  double dt;
  std::vector<PlainMirror> mirrors;
  std::vector<Particle> particles{};
  std::vector<Node> nodes{};
  int steps = 0;

  Vec2 cell() const { return scene.domain.box.size().cwiseQuotient(Vec2(columns, rows)); }
  Node& node(int column, int row) { return nodes[row * (columns + 2) + column]; }

  /// Calls f(node, w_ip, x_i - x_p) for the nine nodes of a place.
  template <class F>
  void for_nodes(const Vec2& x, const F& f) {
    const Vec2 places = x.cwiseQuotient(cell());
    const int column = static_cast<int>(places.x()), row = static_cast<int>(places.y());
    for (int j : {0, 1, 2})
      for (int i : {0, 1, 2}) {
        const Vec2 arm(column + i - 0.5 - places.x(), row + j - 0.5 - places.y());
        f(node(column + i, row + j),
          QuadraticBSpline::weight(i, places.x() - column) * QuadraticBSpline::weight(j, places.y() - row),
          arm.cwiseProduct(cell()).eval());
      }
  }

  /// Calls f(ghost, inner node, mirror) for the ghosts behind a wall.
  template <class F>
  void for_ghosts(const PlainMirror& mirror, const F& f) {
    for (int k = 0; k < (mirror.axis == 0 ? rows : columns) + 2; ++k)
      mirror.axis == 0 ? f(node(mirror.ghosts, k), node(mirror.inner, k))
                       : f(node(k, mirror.ghosts), node(k, mirror.inner));
  }

  void step() {
    nodes.assign((columns + 2) * (rows + 2), Node{});
    const Vec2 spread = cell().cwiseProduct(cell()) / 4;
    for (const Particle& p : particles)
      for_nodes(p.x, [&](Node& to, double w, const Vec2& arm) {
        const Vec2 force = -p.mass / p.rho * p.stress * arm.cwiseQuotient(spread);
        to.mass += p.mass * w;
        to.momentum += w * (p.mass * (p.v + p.C * arm + dt * scene.body_force(p.x, steps * dt)) + dt * force);
      });
    for (const PlainMirror& mirror : mirrors)
      for_ghosts(mirror, [&](Node& ghost, Node& inner) {
        if (ghost.mass == 0) return;
        inner.mass += ghost.mass;
        inner.momentum += ghost.mass * mirror.image(ghost.momentum / ghost.mass);
      });
    for (Node& each : nodes)
      if (each.mass > 0) each.v = each.momentum / each.mass;
    for (auto mirror = mirrors.rbegin(); mirror != mirrors.rend(); ++mirror)
      for_ghosts(*mirror, [&](Node& ghost, Node& inner) { ghost.v = mirror->image(inner.v); });
    for (Particle& p : particles) {
      p.v.setZero();
      p.C.setZero();
      for_nodes(p.x, [&](Node& from, double w, const Vec2& arm) {
        p.v += w * from.v;
        p.C += w * from.v * arm.cwiseQuotient(spread).transpose();
      });
      p.x += dt * p.v;
      p.rho /= 1 + dt * p.C.trace();
      p.stress = stress_of(scene.fluid, p.C, p.rho);
      const double L = scene.domain.box.high.x();
      if (scene.domain.periodic_x) p.x.x() -= L * std::floor(p.x.x() / L);
    }
    ++steps;
  }
};

template <class FluidLaw>
void expect_equal_runs(const Scene<FluidLaw, ForceField>& scene, const Settings& settings, int steps,
                       const std::vector<PlainMirror>& mirrors, double tolerance) {
  auto fast = affine(scene, settings);
  const Vec2 cells = scene.domain.box.size().cwiseQuotient(fast.cell_size());
  Plain<FluidLaw> plain{scene, static_cast<int>(std::lround(cells.x())), static_cast<int>(std::lround(cells.y())),
                        settings.time_step, mirrors};
  const Samples start = fast.samples();
  for (int p = 0; p < start.size(); ++p)
    plain.particles.push_back(
        {start.x.col(p), Vec2::Zero(), Mat2::Zero(), Mat2::Zero(), start.mass[p], start.density[p]});
  for (int step = 0; step < steps; ++step) {
    fast.step();
    plain.step();
  }

  const Samples end = fast.samples();
  const double fastest = end.v.colwise().norm().maxCoeff();
  ASSERT_GT(fastest * settings.time_step * steps, fast.cell_size().x());  // cells have been crossed
  for (int p = 0; p < end.size(); ++p) {
    EXPECT_LT((end.x.col(p) - plain.particles[p].x).norm(), tolerance * fast.cell_size().x()) << p;
    EXPECT_LT((end.v.col(p) - plain.particles[p].v).norm(), tolerance * fastest) << p;
    EXPECT_NEAR(end.density[p], plain.particles[p].rho, tolerance * scene.fluid.density) << p;
  }
}

const Vec2 none = Vec2::Zero();

const Vec2 gap(0.63, 0.46);  // m  in 6 by 5 cells that are not square
const Scene<Newtonian, ForceField> channel{
    .domain = {.box = {.high = gap}, .periodic_x = true},
    .fluid = {{.density = 1000, .bulk_modulus = 143}, 20},
    .filled = {.high = gap},
    .walls = {floor_at(0, no_slip()), ceiling_at(gap.y(), no_slip({0.5, 0}))},
    .body_force = stirring(gap, 2),
};
const std::vector<PlainMirror> channel_mirrors{
    {0, 0, 6, {1, 1}, none}, {0, 7, 1, {1, 1}, none}, {1, 0, 1, {-1, -1}, none}, {1, 6, 5, {-1, -1}, {1, 0}}};

TEST(AffineTransfer, EqualsThePlainLoopForAViscousFluidAcrossThePeriodicBoundary) {
  for (double spacing : {0.1, 0.05, 0.1 / 3, 0.025})
    expect_equal_runs(channel, {.cell = 0.1, .spacing = spacing, .time_step = 5e-3}, 100, channel_mirrors, 1e-9);
}

TEST(AffineTransfer, EqualsThePlainLoopForAnInviscidFluidInACorner) {
  expect_equal_runs(heap(), {.cell = 0.1, .spacing = 0.03, .time_step = 2e-3}, 150,
                    {{0, 0, 1, {-1, 1}, none}, {1, 0, 1, {1, -1}, none}}, 1e-9);
}

/// Particles of mass 1 in a box of cells that are not square, on their own: nothing but the transfer acts on them.
struct Alone {
  static constexpr double time_step = 1e-3;  // s
  const Scene<Tait> scene{.domain = {.box = {.high = {1.24, 0.46}}},
                          .fluid = {.density = 1000, .bulk_modulus = 1e-200},
                          .filled = {{0.2, 0.1}, {1, 0.4}}};
  using Shape = ShapeInLanes<QuadraticBSpline>;
  using Particles = LaneParticles<Tait, MlsApic, CarriedDensity>;
  const Grid grid{scene.domain, 0.1};
  const Shape shape{grid, Vec2(0.03, 0.03)};
  Particles particles = at_rest<Particles>(scene, 0.03, grid);
  LaneNodes<Shape> nodes{grid, lanes};
  TransferInLanes<MlsApic, Shape> transfer{nodes};
  std::vector<LaneBits> calm{};

  Alone() {
    nodes.make_room(transfer.given);
    nodes.list_near(particles.order);
  }

  /// Gives each particle a velocity, and how it changes over a cell along x and along y.
  template <class V>
  void set(const V& velocity) {
    particles.order.for_each([&](int cell, int slot) {
      const Vec2 x = grid.place(cell, particles.X[slot], particles.Y[slot]);
      const auto [v, C] = velocity(x);
      particles.x.v[slot] = v.x();
      particles.y.v[slot] = v.y();
      const Mat2 per_cell = C * grid.cell.asDiagonal();
      particles.x.along_x[slot] = per_cell(0, 0);
      particles.x.along_y[slot] = per_cell(0, 1);
      particles.y.along_x[slot] = per_cell(1, 0);
      particles.y.along_y[slot] = per_cell(1, 1);
    });
  }

  void to_nodes() {
    give_by_rows<3>(particles.order, 1, nodes, [&](int index, const auto& block, auto& to) {
      transfer.give<false>(particles, index, block, shape, Vec2::Zero(), to);
    });
    nodes.find_mass(1);
    nodes.find_mean(momentum_given, nodes.velocity, 1);
  }
  void to_particles() {
    const StepOf<Shape, Tait> step{grid, shape, scene.fluid, time_step, 1, true};
    GatherInLanes<MlsApic, CarriedDensity>::update(transfer, nodes, step, particles, calm);
  }
  double mass(int node) const { return nodes.moves(node) ? 1 / nodes.per_mass[node] : 0; }

  /// Momentum and angular momentum: x, y, around the origin.
  Eigen::Vector3d momenta_of_particles() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    particles.order.for_each([&](int cell, int slot) {
      const Vec2 x = grid.place(cell, particles.X[slot], particles.Y[slot]);
      const double vx = particles.x.v[slot], vy = particles.y.v[slot];
      const double spin = (grid.cell.x() * particles.y.along_x[slot] - grid.cell.y() * particles.x.along_y[slot]) / 4;
      sum += Eigen::Vector3d(vx, vy, x.x() * vy - x.y() * vx + spin);
    });
    return sum;
  }
  Eigen::Vector3d momenta_of_nodes() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int first : nodes.near())
      for (int node = first; node < first + lanes; ++node) {
        const Vec2 x = (Vec2(node % nodes.stride, node / nodes.stride).array() - 0.5).matrix().cwiseProduct(grid.cell);
        const Vec2 p = mass(node) * nodes.velocity[node];
        sum += Eigen::Vector3d(p.x(), p.y(), x.x() * p.y() - x.y() * p.x());
      }
    return sum;
  }
};

TEST(AffineTransfer, HasRowsOfNodesNoLongerThanBlocksOfCellsNeed) {
  const Grid wide(Domain{.box = {.high = {1000, 2}}}, 1);
  EXPECT_LE((LaneNodes<ShapeInLanes<QuadraticBSpline>>{wide, lanes}.stride), 1000 + 2 * lanes);
}

TEST(AffineTransfer, KeepsMassMomentumAndAngularMomentum) {
  Alone drop;
  drop.set([](const Vec2& x) {
    return std::pair{Vec2(std::sin(9 * x.y()), x.x() * x.x()), Mat2{{0.3, -2 * x.y()}, {x.x(), 0.7}}};
  });
  const Eigen::Vector3d start = drop.momenta_of_particles();
  drop.to_nodes();
  double mass = 0;
  for (int first : drop.nodes.near())
    for (int node = first; node < first + lanes; ++node) mass += drop.mass(node);
  EXPECT_NEAR(mass, static_cast<double>(drop.particles.count), 1e-11 * mass);
  EXPECT_LT((drop.momenta_of_nodes() - start).norm(), 1e-12 * start.norm());
  drop.to_particles();
  EXPECT_LT((drop.momenta_of_particles() - start).norm(), 1e-12 * start.norm());
  EXPECT_GT(std::abs(start.z()), 1);
}

TEST(AffineTransfer, LeavesAnAffineFlowAsItIs) {
  Alone drop;
  const Mat2 C{{0.4, -3}, {2, -0.9}};
  const auto flow = [&](const Vec2& x) { return std::pair{Vec2(Vec2(0.5, -2) + C * x), C}; };
  drop.set(flow);
  const Alone::Particles start = drop.particles;
  drop.to_nodes();
  drop.to_particles();
  start.order.for_each([&](int cell, int slot) {
    const Vec2 v = flow(drop.grid.place(cell, start.X[slot], start.Y[slot])).first;
    EXPECT_NEAR(drop.particles.x.v[slot], v.x(), 1e-11);
    EXPECT_NEAR(drop.particles.y.v[slot], v.y(), 1e-11);
    for (const auto along : {&VelocityOf<Apic>::along_x, &VelocityOf<Apic>::along_y}) {
      EXPECT_NEAR((drop.particles.x.*along)[slot], (start.x.*along)[slot], 1e-11);
      EXPECT_NEAR((drop.particles.y.*along)[slot], (start.y.*along)[slot], 1e-11);
    }
    EXPECT_NEAR(drop.particles.expansion[slot], Alone::time_step * C.trace(), 1e-11);
  });
}

}  // namespace
}  // namespace touchstone::mpm
