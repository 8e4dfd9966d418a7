#include "vnv/harness/run_bytes.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace touchstone::vnv {
namespace run_bytes_test {

using ARun = Run;  // inside a test, Run is GoogleTest's

ARun made_up() {
  ARun run;
  run.summary = {"M2", 0.1, 1e-5, 0.5, true, "finished", {.particles = 3, .steps = 7, .cpu = 0.25, .harness = 0.5}};
  run.samples = {{.time = 0.5,
                  .x = Vectors::Random(2, 3),
                  .v = Vectors::Random(2, 3),
                  .mass = Scalars::Random(3),
                  .density = Scalars::Random(3),
                  .pressure = Scalars::Random(3)}};
  run.history = {{0.1, 0.2}, {{1, 2}, {3}}};
  run.found = {{"M2", 0.1, 0.5, {"L2", "%", Kind::norm}, 0.125}};
  run.curves = {{"map", "stable", Role::ours, {1, 2}, {0.5, 0.25}, true}};
  return run;
}

TEST(ARunAsBytes, ComesBackBitByBit) {
  const ARun before = made_up(), after = run_from(to_bytes(before));
  EXPECT_EQ(after.summary, before.summary);
  ASSERT_EQ(after.samples.size(), 1u);
  EXPECT_EQ(after.samples[0].x, before.samples[0].x);
  EXPECT_EQ(after.samples[0].v, before.samples[0].v);
  EXPECT_TRUE((after.samples[0].mass == before.samples[0].mass).all());
  EXPECT_TRUE((after.samples[0].density == before.samples[0].density).all());
  EXPECT_TRUE((after.samples[0].pressure == before.samples[0].pressure).all());
  EXPECT_EQ(after.history.time, before.history.time);
  EXPECT_EQ(after.history.values, before.history.values);
  EXPECT_EQ(after.found, before.found);
  EXPECT_EQ(after.curves, before.curves);
}

TEST(ARunAsBytes, KeepsWhatIsNotFinite) {
  ARun before;
  const double infinity = std::numeric_limits<double>::infinity();
  before.history.time = {not_a_number, -not_a_number, infinity, -infinity, -0.0};
  const ARun after = run_from(to_bytes(before));
  ASSERT_EQ(after.history.time.size(), before.history.time.size());
  EXPECT_EQ(std::memcmp(after.history.time.data(), before.history.time.data(), 5 * sizeof(double)), 0);
}

TEST(ARunAsBytes, ThatIsTornIsRefused) {
  const std::string whole = to_bytes(made_up());
  for (std::size_t length = 0; length < whole.size(); length += 5)
    EXPECT_THROW(run_from(whole.substr(0, length)), std::runtime_error) << length;
  EXPECT_THROW(run_from(whole + "x"), std::runtime_error);
}

}  // namespace run_bytes_test
}  // namespace touchstone::vnv
