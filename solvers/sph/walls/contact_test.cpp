#include "solvers/sph/walls/contact.hpp"

#include "solvers/walls/free_slip.hpp"

#include <gtest/gtest.h>

#include <random>

namespace touchstone::sph {
namespace contact_test {

constexpr double least = 0.01, dt = 0.1;
const std::vector<Wall> box = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(1, free_slip()),
                               ceiling_at(1, free_slip())};

/// Particles in a square of a metre, most of which leave it within `dt`.
Particles scattered() {
  Particles all;
  all.fluid = 500;
  all.mass = 2;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> within(least, 1 - least), speed(-30, 30);
  const auto draw = [&](auto& from) -> Scalars {
    return Scalars::NullaryExpr(all.fluid, [&] { return from(random); });
  };
  all.x = draw(within), all.y = draw(within), all.vx = draw(speed), all.vy = draw(speed);
  return all;
}
Contacts meet(Particles& all, const std::vector<Wall>& walls, double time = 0) {
  Contacts contacts;
  keep_off_walls(all, all.vx, all.vy, walls, least, time, dt,
                 [&](Index, const Vec2& n, double before, double after) { contacts.add(all.mass, n, before, after); });
  return contacts;
}
Particles one(const Vec2& x, const Vec2& v) {
  Particles all;
  all.fluid = 1;
  all.mass = 2;
  all.x = Scalars::Constant(1, x.x()), all.y = Scalars::Constant(1, x.y());
  all.vx = Scalars::Constant(1, v.x()), all.vy = Scalars::Constant(1, v.y());
  return all;
}

TEST(Contact, LetsNothingThrough) {
  Particles all = scattered();
  EXPECT_GT(meet(all, box).particles, 250);
  const Scalars x = all.x + dt * all.vx, y = all.y + dt * all.vy;
  for (const Scalars& place : {x, y}) {
    EXPECT_GT(place.minCoeff(), least - 1e-15);
    EXPECT_LT(place.maxCoeff(), 1 - least + 1e-15);
  }
}

TEST(Contact, LeavesAloneWhatStaysOff) {
  const Particles start = scattered();
  Particles all = start;
  all.vx *= 1e-4, all.vy *= 1e-4;
  meet(all, box);
  for (Index i = 0; i < all.fluid; ++i) {
    const double x = start.x[i] + dt * 1e-4 * start.vx[i], y = start.y[i] + dt * 1e-4 * start.vy[i];
    if (std::min(x, y) > least && std::max(x, y) < 1 - least) {
      EXPECT_EQ(all.vx[i], 1e-4 * start.vx[i]);
      EXPECT_EQ(all.vy[i], 1e-4 * start.vy[i]);
    }
  }
}

TEST(Contact, AddsUpTheImpulseAndTheEnergyThatItTakes) {
  const Particles start = scattered();
  Particles all = start;
  const Contacts contacts = meet(all, box);
  const Vec2 impulse = all.mass * Vec2((all.vx - start.vx).sum(), (all.vy - start.vy).sum());
  const auto energy = [](const Particles& p) { return p.mass / 2 * (p.vx.square() + p.vy.square()).sum(); };
  EXPECT_LT((contacts.impulse - impulse).norm(), 1e-10 * energy(start));
  EXPECT_NEAR(contacts.energy / (energy(start) - energy(all)), 1, 1e-12);
  EXPECT_GT(contacts.energy, 0);
}

TEST(Contact, NeitherPushesOutNorHoldsBackWhatIsNearer) {
  Particles sinking = one({0.5, 0.004}, {3, -2}), rising = one({0.5, 0.004}, {3, 0.5});
  EXPECT_EQ(meet(sinking, box).particles, 1);
  EXPECT_EQ(sinking.vx[0], 3);
  EXPECT_EQ(sinking.vy[0], 0);
  EXPECT_EQ(meet(rising, box).particles, 0);
  EXPECT_EQ(rising.vy[0], 0.5);
}

TEST(Contact, WithAGateIsOnItsFaceAndWhereItIs) {
  Wall gate = right_at(0.5, free_slip());
  gate.extent = [](double time) -> Range { return {0.1 * time, 1e9}; };
  const auto held = [&](const Vec2& x, double v, double time) {
    Particles all = one(x, {v, 0});
    return meet(all, {gate}, time).particles;
  };
  EXPECT_EQ(held({0.45, 0.3}, 5, 2), 1);
  EXPECT_EQ(held({0.45, 0.3}, 5, 4), 0);  // above
  EXPECT_EQ(held({0.55, 0.3}, 5, 2), 0);  // behind
  gate.extent = [](double time) -> Range { return {0.1 * time, 0.1 * time + 0.2}; };
  EXPECT_EQ(held({0.45, 0.39}, 5, 2), 1);
  EXPECT_EQ(held({0.45, 0.41}, 5, 2), 0) << "over its upper end";
  EXPECT_EQ(held({0.45, 0.41}, 5, 3), 1) << "which rises, too";
}

}  // namespace contact_test
}  // namespace touchstone::sph
