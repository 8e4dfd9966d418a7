#include "vnv/doors/judge.hpp"
#include "vnv/doors/right_data.hpp"
#include "vnv/flows/drop.hpp"

#include <gtest/gtest.h>

#include <set>

namespace touchstone::vnv::doors {
namespace free_surfaces_test {

using Change = std::function<void(Samples&)>;

/// Right data at some times [s] as they would be with a change, of particles that have masses.
Record judged(const Flow& flow, const std::vector<double>& times, const Change& change) {
  constexpr double across = 30;
  Given given;
  given.fields = {"particles", "velocity", velocity_along_x, "pressure"};
  GivenLevel level{.spacing = flow.across / across, .spacing_is_said = true, .has_volumes = true};
  for (const double time : times) {
    Samples samples = right_of(flow, across, time);
    change(samples);
    level.at.emplace(time, std::move(samples));
  }
  given.levels.push_back(std::move(level));
  return judge_given(flow, std::move(given), {}).record;
}

/// The quantities whose claims do not hold.
std::set<std::string> failing(const Record& record) {
  std::set<std::string> found;
  for (const Verdict& v : record.verdicts)
    if (v.outcome == Outcome::fails) found.insert(v.quantity);
  return found;
}

std::vector<double> times_until(double end, int count) {
  std::vector<double> all;
  for (int k = 0; k <= count; ++k) all.push_back(end * k / count);
  return all;
}

const Change faster = [](Samples& s) { s.v *= 2; };

TEST(AWave, HasItsAmplitudeItsEnergyAndItsPressure) {
  const Flow flow = flow_named("standing_wave");
  const std::vector<double> times = times_until(4, 96);
  const auto with = [&](const Change& change) { return failing(judged(flow, times, change)); };
  EXPECT_EQ(with([](Samples&) {}), std::set<std::string>{});
  EXPECT_EQ(with(faster), (std::set<std::string>{"part of the motion that the velocity makes",
                                                 "largest kinetic energy over that of the linear wave"}));
  const std::string amplitude = "amplitude over that of the wave at the start, by its oscillation";
  for (const double part : {0.25, 0.5}) {
    const std::set<std::string> found = with([&](Samples& s) {
      for (double& x : s.x.row(0).reshaped()) x = flow.domain.wrapped(0, x + part * flow.across);
    });
    EXPECT_TRUE(found.contains(amplitude)) << part;
  }
  EXPECT_EQ(with([](Samples& s) { s.pressure /= 2; }), std::set<std::string>{part_of_pressure.name});
}

TEST(ADam, IsDrivenByItsWeightAloneAndKeepsItsMass) {
  const Flow flow = flow_named("dam_break");
  const std::vector<double> times = times_until(0.5, 20);
  const auto with = [&](const Change& change) { return failing(judged(flow, times, change)); };
  EXPECT_EQ(with([](Samples&) {}), std::set<std::string>{});
  EXPECT_TRUE(with(faster).contains("kinetic and potential energy over that at the start"));
  EXPECT_EQ(with([](Samples& s) { s.mass *= s.time > 0.45 ? 0.98 : 1; }),
            std::set<std::string>{"relative change of the mass since the first time"});
}

TEST(ADrop, IsDrawnOutAsItsStrainDrawsIt) {
  const Flow flow = flow_named("elliptic_drop");
  const std::vector<double> times = times_until(flow.judged.times.back(), 8);
  const auto with = [&](const Change& change) { return failing(judged(flow, times, change)); };
  EXPECT_EQ(with([](Samples&) {}), std::set<std::string>{});
  const Samples start = right_of(flow, 30, 0);
  EXPECT_TRUE(with([&](Samples& s) { s.x = start.x; }).contains(drop::axes_error.name));
  EXPECT_TRUE(with([&](Samples& s) {
                const double drawn = 1 + 0.25 * s.time / times.back();
                s.x.row(0) *= drawn, s.x.row(1) /= drawn;
              }).contains(drop::axes_error.name));
}

}  // namespace free_surfaces_test
}  // namespace touchstone::vnv::doors
