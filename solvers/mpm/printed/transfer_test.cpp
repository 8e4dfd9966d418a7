/// The fast transfer against a plain loop over particles and their four nodes, step by step as the paper prints it.
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace touchstone::mpm {
namespace {

Mat2 stress_of(const Tait& fluid, const Mat2&, double rho) { return -fluid.pressure(rho) * Mat2::Identity(); }
Mat2 stress_of(const Newtonian& fluid, const Mat2& rate, double rho) {
  const Mat2 deviatoric = rate - rate.trace() / 3 * Mat2::Identity();
  return 2 * fluid.viscosity * deviatoric - fluid.pressure(rho) * Mat2::Identity();
}

/// A force that stirs, so that no term of the step is idle.
struct Stirring {
  Vec2 size;        // m     of its vortices
  double strength;  // m/s²

  Vec2 operator()(const Vec2& x, double) const {
    const Eigen::Array2d angle = 2 * 3.14159 * x.array() / size.array();
    return strength * Vec2(std::sin(angle.x()) * std::cos(angle.y()) + 0.3, -std::cos(angle.x()) * std::sin(angle.y()));
  }
};

/// The textbook loop.
template <class FluidLaw, class Force>
struct Plain {
  struct Particle {
    Vec2 x, v;
    double mass, rho;
    Mat2 stress;
  };
  struct Node {
    double mass = 0;
    Vec2 momentum = Vec2::Zero(), force = Vec2::Zero(), v = Vec2::Zero(), a = Vec2::Zero(), remapped = Vec2::Zero();
  };
  using Held = std::function<void(int column, int row, Vec2& v)>;  // sets to zero what a wall at rest stops

  Scene<FluidLaw, Force> scene;
  int columns, rows;
  double dt;
  Held held;
  std::vector<Particle> particles;
  std::vector<Node> nodes;
  int steps = 0;

  Vec2 cell() const { return scene.domain.box.size().cwiseQuotient(Vec2(columns, rows)); }

  /// Calls f(node, N_i, grad N_i) for the four nodes of a place.
  template <class F>
  void for_nodes(const Vec2& x, const F& f) {
    const Vec2 places = x.cwiseQuotient(cell());
    const int column = static_cast<int>(places.x()), row = static_cast<int>(places.y());
    const double X = places.x() - column, Y = places.y() - row;
    for (int j : {0, 1})
      for (int i : {0, 1}) {
        const int at = scene.domain.periodic_x ? (column + i) % columns : column + i;
        const double Ni = LinearHat::weight(i, X), Nj = LinearHat::weight(j, Y);
        f(nodes[(row + j) * (columns + 1) + at], Ni * Nj,
          Vec2(LinearHat::slope(i, X) * Nj, Ni * LinearHat::slope(j, Y)).cwiseQuotient(cell()).eval());
      }
  }
  void hold(Vec2 Node::*field) {
    for (int row = 0; row <= rows; ++row)
      for (int column = 0; column <= columns; ++column) held(column, row, nodes[row * (columns + 1) + column].*field);
  }

  void step() {
    nodes.assign((columns + 1) * (rows + 1), Node{});
    for (const Particle& p : particles)
      for_nodes(p.x, [&](Node& node, double N, const Vec2& G) {
        node.mass += p.mass * N;
        node.momentum += p.mass * N * p.v;
        node.force += p.mass * N * scene.body_force(p.x, steps * dt) - p.mass / p.rho * p.stress * G;
      });
    for (Node& node : nodes)
      if (node.mass > 0) {
        node.a = node.force / node.mass;
        node.v = node.momentum / node.mass + dt * node.a;
      }
    hold(&Node::v);
    hold(&Node::a);
    std::vector<Vec2> places;
    for (Particle& p : particles) {
      places.push_back(p.x);
      for_nodes(places.back(), [&](Node& node, double N, const Vec2&) {
        p.x += dt * N * node.v;
        p.v += dt * N * node.a;
      });
    }
    for (std::size_t p = 0; p < particles.size(); ++p)
      for_nodes(places[p], [&](Node& node, double N, const Vec2&) {
        node.remapped += particles[p].mass * N / node.mass * particles[p].v;
      });
    hold(&Node::remapped);
    for (std::size_t q = 0; q < particles.size(); ++q) {
      Particle& p = particles[q];
      Mat2 gradient = Mat2::Zero();
      for_nodes(places[q], [&](Node& node, double, const Vec2& G) { gradient += node.remapped * G.transpose(); });
      const Mat2 rate = (gradient + gradient.transpose()) / 2;
      p.rho /= 1 + dt * rate.trace();
      p.stress = stress_of(scene.fluid, rate, p.rho);
      const double L = scene.domain.box.high.x();
      if (scene.domain.periodic_x) p.x.x() -= L * std::floor(p.x.x() / L);
    }
    ++steps;
  }
};

template <class FluidLaw, class Force>
void expect_equal_runs(const Scene<FluidLaw, Force>& scene, const Settings& settings, int steps,
                       typename Plain<FluidLaw, Force>::Held held) {
  auto fast = solver<PrescribedMotion>(scene, settings);
  const Vec2 cells = scene.domain.box.size().cwiseQuotient(fast.cell_size());
  Plain<FluidLaw, Force> plain{scene,
                               static_cast<int>(std::lround(cells.x())),
                               static_cast<int>(std::lround(cells.y())),
                               settings.time_step,
                               held,
                               {},
                               {}};
  const Samples start = fast.samples();
  for (int p = 0; p < start.size(); ++p)
    plain.particles.push_back({start.x.col(p), Vec2::Zero(), start.mass[p], start.density[p], Mat2::Zero()});
  for (int step = 0; step < steps; ++step) {
    fast.step();
    plain.step();
  }

  const Samples end = fast.samples();
  const double fastest = end.v.colwise().norm().maxCoeff();
  ASSERT_GT(fastest * settings.time_step * steps, fast.cell_size().x());  // cells have been crossed
  for (int p = 0; p < end.size(); ++p) {
    EXPECT_LT((end.x.col(p) - plain.particles[p].x).norm(), 1e-9 * fast.cell_size().x()) << p;
    EXPECT_LT((end.v.col(p) - plain.particles[p].v).norm(), 1e-9 * fastest) << p;
    EXPECT_NEAR(end.density[p], plain.particles[p].rho, 1e-9 * scene.fluid.density) << p;
  }
}

TEST(Transfer, EqualsThePlainLoopForAViscousFluidAcrossTheSeam) {
  for (double length : {0.6, 0.8}) {  // with cells left over beside whole blocks, and without
    const Scene<Newtonian, Stirring> channel{
        .domain = {.box = {.high = {length, 0.5}}, .periodic_x = true},
        .fluid = {{.density = 1000, .bulk_modulus = 143}, 20},
        .filled = {.high = {length, 0.5}},
        .walls = {floor_at(0, no_slip()), ceiling_at(0.5, no_slip())},
        .body_force = {{length, 0.5}, 2},
    };
    for (double spacing : {0.1, 0.05, 0.1 / 3, 0.025, 0.1 / 7})
      expect_equal_runs(channel, {.cell = 0.1, .spacing = spacing, .time_step = 5e-3}, 100, [](int, int row, Vec2& v) {
        if (row == 0 || row == 5) v.setZero();
      });
  }
}

TEST(Transfer, EqualsThePlainLoopForAnInviscidFluidInACorner) {
  const Scene<Tait, Stirring> heap{
      .domain = {.box = {.high = {1.2, 0.9}}},
      .fluid = {.density = 1000, .bulk_modulus = 2000},
      .filled = {.high = {0.45, 0.6}},
      .walls = {left_at(0, free_slip()), floor_at(0, free_slip())},
      .body_force = {{0.8, 0.7}, 3},
  };
  expect_equal_runs(heap, {.cell = 0.1, .spacing = 0.03, .time_step = 2e-3}, 150, [](int column, int row, Vec2& v) {
    if (column == 0) v.x() = 0;
    if (row == 0) v.y() = 0;
  });
}

template <class Number>
LanesOf<Number> counted_from(Number first) {
  LanesOf<Number> numbers;
  for (int lane = 0; lane < lanes_of<Number>; ++lane) numbers[lane] = first + static_cast<Number>(lane);
  return numbers;
}

TEST(Lanes, NoticeOneNumberThatIsNotOne) {
  for (int lane = 0; lane < lanes; ++lane) {
    Lanes a = fill<Lanes>(0.5);
    EXPECT_TRUE(all<Lanes>(between(0, a, 1)));
    a[lane] = std::nan("");
    EXPECT_FALSE(all<Lanes>(between(0, a, 1)));
    a[lane] = 1.001;
    EXPECT_FALSE(all<Lanes>(between(0, a, 1)));
  }
}

TEST(Lanes, HandTheLastOnTheLeftToTheFirst) {
  const Lanes numbers = shifted(counted_from(1.0), counted_from(1.0 + lanes));
  for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(numbers[lane], lanes + lane);
}

TEST(Lanes, AreTheSameNumbersWidenedAndJoined) {
  const auto numbers = counted_from(1.0F);
  const Lanes first = widened<0>(numbers), second = widened<1>(numbers);
  const auto again = joined<LanesOf<float>>([&](int lane) { return lane == 0 ? first : second; });
  for (int lane = 0; lane < lanes; ++lane) {
    EXPECT_EQ(first[lane], 1 + lane);
    EXPECT_EQ(second[lane], 1 + lanes + lane);
  }
  for (int lane = 0; lane < lanes_of<float>; ++lane) EXPECT_EQ(again[lane], numbers[lane]);
}

}  // namespace
}  // namespace touchstone::mpm
