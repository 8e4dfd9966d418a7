#include "solvers/mpm/affine/affine.hpp"
#include "solvers/mpm/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::mpm {
namespace {

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
  auto spinning = affine(drop(Blow{[](const Vec2& x) -> Vec2 {
                           return {40 * x.y() * x.y(), 30 * x.x()};
                         }}),
                         {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  spinning.step();
  const auto momentum = [](const Samples& s) -> Vec2 { return s.v * s.mass.matrix(); };
  const Vec2 start = momentum(spinning.samples());
  run(spinning, 100);
  const Samples end = spinning.samples();
  EXPECT_LT((momentum(end) - start).norm(), 1e-12 * start.norm());
  EXPECT_GT(end.pressure.abs().maxCoeff(), 1);  // Pa: forces have been at work
}

TEST(Affine, CarriesAUniformFlowAcrossTheSeam) {
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
  Scene<Tait> pond{.domain = {.box = {.high = {1, 1}}},
                   .fluid = soft_water,
                   .filled = {.high = {1, 0.5}},
                   .walls = {floor_at(0, free_slip()), left_at(0, no_slip()), right_at(1, free_slip())}};
  auto still = affine(pond, {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  const Samples start = still.samples();
  run(still, 10);
  expect_same_bits(still.samples(), start);
}

TEST(Affine, BearsItsWeight) {
  Scene<Tait, Uniform> pond = dam();
  pond.filled = {.high = {1, 0.6}};
  auto water = affine(pond, dam_settings);
  double impulse = 0, time = 0;  // of the pressure at the floor, per area
  while (water.time() < 20) {
    water.step();
    if (water.time() < 10) continue;
    const Samples s = water.samples();
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
  auto first_plates = affine<float>(plates(), between);
  run(first_dam, 80);
  run(first_plates, 30);
  for (int threads : {1, 2, 3}) {
    settings.threads = between.threads = threads;
    auto again = affine(dam(), settings);
    run(again, 80);
    expect_same_bits(again.samples(), first_dam.samples());
    auto again_plates = affine<float>(plates(), between);
    run(again_plates, 30);
    expect_same_bits(again_plates.samples(), first_plates.samples());
  }
}

TEST(Affine, NamesTheParticleThatWasSpoilt) {
  // In one step number 99 spoils two cells on every side.
  expect_stop_of_spoilt(affine(drop(Spoilt{}), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}), 77);
}

TEST(Affine, DiagnosesACollapse) {
  auto squeezed = affine(drop(Blow{[](const Vec2& x) -> Vec2 { return -500 * (x - Vec2(0.5, 0.5)); }}),
                         {.cell = 0.1, .spacing = 0.1, .time_step = 0.05});
  EXPECT_THROW(run(squeezed, 20), Diverged);
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

}  // namespace
}  // namespace touchstone::mpm
