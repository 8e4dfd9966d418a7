#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/prescribed_velocity.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

namespace touchstone::mpm {
namespace {

const Vec2 before(3, 5), after(4, 7), wall_velocity(10, 0);  // m/s

NodeAtWall node(bool first_step) {
  return {.before = before, .after = after, .start = 2, .end = 2.5, .first_step = first_step, .of_scene = before};
}

template <class Treatment>
Vec2 change_at(const Wall& wall, bool first_step) {
  NodeAtWall held = node(first_step);
  Treatment::hold(wall, held);
  EXPECT_EQ(held.after, wall.at_wall(after, 2.5));
  return held.after - held.before;
}

TEST(VelocityReset, TellsTheParticlesAllThatTheWallDoes) {
  for (bool first : {true, false}) {
    EXPECT_EQ(change_at<VelocityReset>(ceiling_at(1, no_slip(wall_velocity)), first), wall_velocity - before);
    EXPECT_EQ(change_at<VelocityReset>(floor_at(0, free_slip()), first), Vec2(1, -5));
  }
}

TEST(PrescribedMotion, TellsTheParticlesOfTheStartOnly) {
  const Wall sliding = ceiling_at(1, no_slip(wall_velocity));
  EXPECT_EQ(change_at<PrescribedMotion>(sliding, true), wall_velocity - before);
  EXPECT_EQ(change_at<PrescribedMotion>(sliding, false), Vec2(0, 0));
}

TEST(PrescribedMotion, IsNoJumpForFluidThatStartsAsTheWallMoves) {
  NodeAtWall held = node(true);
  held.of_scene = wall_velocity;  // whatever the mean over the particles near it
  PrescribedMotion::hold(ceiling_at(1, no_slip(wall_velocity)), held);
  EXPECT_EQ(held.after - held.before, Vec2(0, 0));
  held = node(true);
  held.of_scene = {3, 0};
  PrescribedMotion::hold(floor_at(0, free_slip()), held);
  EXPECT_EQ(held.after - held.before, Vec2(1, 0));
}

TEST(PrescribedVelocity, NeverTellsTheParticlesOfTheStart) {
  for (bool first : {true, false})
    EXPECT_EQ(change_at<PrescribedVelocity>(ceiling_at(1, no_slip(wall_velocity)), first), Vec2(0, 0));
}

TEST(PrescribedMotion, LeavesTheAccelerationAlongAFreeSlipWall) {
  EXPECT_EQ(change_at<PrescribedMotion>(floor_at(0, free_slip()), false), Vec2(1, 0));
  EXPECT_EQ(change_at<PrescribedVelocity>(floor_at(0, free_slip()), false), Vec2(1, 0));
}

TEST(PrescribedMotion, FollowsAWallThatAccelerates) {
  const Wall shaken = floor_at(0, [](const NearWall& fluid) -> Vec2 { return {8 * fluid.time, 0}; });
  EXPECT_EQ(change_at<PrescribedMotion>(shaken, false), Vec2(4, 0));
}

TEST(PrescribedMotion, AppliesBothWallsOfACornerInTurn) {
  NodeAtWall corner = node(false);
  PrescribedMotion::hold(floor_at(0, free_slip()), corner);
  PrescribedMotion::hold(left_at(0, free_slip()), corner);
  EXPECT_EQ(corner.before, Vec2(0, 0));
  EXPECT_EQ(corner.after, Vec2(0, 0));
  for (const bool lid_is_last : {true, false}) {  // which drags the fluid in a corner only where it is the last
    std::vector<Wall> walls{ceiling_at(1, no_slip(wall_velocity)), left_at(0, no_slip())};
    if (lid_is_last) std::swap(walls[0], walls[1]);
    NodeAtWall under_lid = node(false);
    for (const Wall& wall : walls) PrescribedMotion::hold(wall, under_lid);
    EXPECT_EQ(under_lid.after, lid_is_last ? wall_velocity : Vec2(0, 0));
    EXPECT_EQ(under_lid.before, under_lid.after);
  }
}

}  // namespace
}  // namespace touchstone::mpm
