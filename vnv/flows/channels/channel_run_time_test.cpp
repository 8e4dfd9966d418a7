#include "vnv/flows/channels/channel_run_time.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::channel {

TEST(ChannelInAStrip, HasTheVelocitiesOfTheWholeChannel) {
  const auto scene = scene_of<Newtonian, Uniform>(flow_named("poiseuille"));
  for (const Method& method : {vnv::mpm_as_printed(scene, 0.05), vnv::mpm_least_squares(scene, 0.05),
                               vnv::sph_second_order(scene, 0.05)}) {
    Level level{.name = "24 across", .spacing = H / 24};
    if (method.family == Family::mpm) level.cell = H / 12;
    const Schedule when{.times = {0.05}};
    const vnv::Run whole = method.run(level, when);
    level.period = L / 2;
    const vnv::Run strip = method.run(level, when);
    ASSERT_TRUE(whole.summary.finished && strip.summary.finished) << method.name;
    EXPECT_EQ(strip.summary.cost.particles, whole.summary.cost.particles / 2) << method.name;
    const auto fastest = [](const vnv::Run& run) { return run.samples.back().v.row(0).maxCoeff(); };
    EXPECT_GT(fastest(whole), 0.2 * mm) << method.name;
    EXPECT_NEAR(fastest(strip), fastest(whole), 1e-9 * mm) << method.name;
  }
}

}  // namespace touchstone::vnv::channel
