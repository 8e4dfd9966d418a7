#include "reference/poiseuille.hpp"
#include "vnv/bench/scenes.hpp"
#include "vnv/bench/mls_mpm.hpp"
#include "vnv/bench/plain_musl.hpp"
#include "vnv/bench/plain_sph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace touchstone::bench {
namespace {

constexpr double time_step = 5 * us;

const PlainFlow wide = plain(channel(0.5 * mm)), narrow = plain(channel(0.05 * mm)), column = plain(dam({1.6, 1.2}));

/// Relative L2 norm (34) of the velocities along a channel, after a twentieth of its viscous time.
template <class Loop>
double error_in_channel(Loop loop) {
  const double end = 0.05;
  for (long k = 0; k < std::lround(end / time_step); ++k) loop.step();
  const reference::Poiseuille exact{.H = channel_height, .F = channel_drive, .nu = 1e-6};
  double miss = 0, all = 0;
  for (const auto& p : loop.particles()) {
    const double v = exact(p.y, end);
    miss += (p.vx - v) * (p.vx - v);
    all += v * v;
  }
  return std::sqrt(miss / all);
}

TEST(PlainMusl, FindsPoiseuilleFlow) {
  const double cell = 0.05 * mm;
  EXPECT_LT(error_in_channel(PlainMusl(wide, cell, cell / 2, time_step)), 0.005);
}

TEST(PlainMusl, LetsTheDamBreakRunAheadOnTheFloorAndKeepsItInTheTank) {
  PlainMusl dam(column, 0.04, 0.02, 100 * us);
  for (int k = 0; k < 3000; ++k) dam.step();  // 0.3 s, T = 1.21
  double front = 0;
  for (const PlainMusl::Particle& p : dam.particles()) {
    ASSERT_TRUE(p.x > 0 && p.y > 0 && p.y < column.size.y());
    front = std::max(front, p.x);
  }
  EXPECT_NEAR(front / column.filled.x(), 2.15, 0.3);  // Lobovský et al. (2014): 2.15
}

/// Each transfer damps what is not affine about a particle, as a diffusion of fourth order that acts once a step: at
/// the plates it makes a layer of the thickness cell² / sqrt(nu dt), so finer cells help and shorter steps do not.
TEST(MlsMpm, FindsPoiseuilleFlowOnFineCells) {
  const auto error = [](double cell) { return error_in_channel(MlsMpm(narrow, cell, cell / 2, time_step)); };
  const double coarse = error(0.025 * mm), fine = error(0.0125 * mm);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(coarse / fine, 4);
}

TEST(PlainSph, FindsPoiseuilleFlow) { EXPECT_LT(error_in_channel(PlainSph(wide, 0.05 * mm, time_step)), 0.02); }

TEST(PlainSph, ListsTheTwentyNeighboursOfItsKernel) {
  const PlainSph loop(column, 0.02, 50 * us);
  EXPECT_GT(loop.neighbours(), 18);  // 20 in the bulk, fewer at the edges
  EXPECT_LT(loop.neighbours(), 20);
}

}  // namespace
}  // namespace touchstone::bench
