/// Speed of the solvers: each timed alternately with a reference loop that does the same work, so that the machine and
/// its other load cancel.

#include "vnv/bench/race.hpp"
#include "vnv/bench/scenes.hpp"

#include <thread>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::bench;

namespace {

const Author goal = baseline("goal set against the plain loop of vnv/bench"), set_goal = baseline("goal set"),
             kept = baseline("nine tenths of the least that was measured on a busy machine");

/// A level of so many particles across a length, which in MPM is a cell; named after a letter and that number.
Level of_sph(const std::string& letter, double length, int across) {
  return {.name = letter + std::to_string(across), .spacing = length / across, .report = 1, .nightly = 1};
}
Level of_mpm(const std::string& letter, double cell, int across) {
  Level level = of_sph(letter, cell, across);
  level.cell = cell;
  return level;
}
const Level M1 = of_mpm("M", channel_cell, 1), M2 = of_mpm("M", channel_cell, 2), M3 = of_mpm("M", channel_cell, 3),
            M4 = of_mpm("M", channel_cell, 4), dam_A2 = of_mpm("A", dam_cell, 2), dam_A4 = of_mpm("A", dam_cell, 4),
            dam_M4 = of_mpm("M", dam_cell, 4), fitted = of_mpm("A", 1.0 / 48, 2);
const Level S1 = of_sph("S", channel_cell, 1), S2 = of_sph("S", channel_cell, 2), S4 = of_sph("S", channel_cell, 4),
            dam_S2 = of_sph("S", dam_cell, 2), dam_S4 = of_sph("S", dam_cell, 4), S64 = of_sph("S", 1, 64);

/// A tank so many times as large as the paper's.
Level tank(const std::string& times) {
  Level level = dam_M4;
  level.name = times;
  return level;
}

Method timed(const std::string& name, std::vector<Level> levels, std::vector<Claim> claims) {
  Method method = race_named(name);
  method.levels = std::move(levels);
  method.claims = std::move(claims);
  return method;
}

/// An accurate method of SPH against the printed one.
Method accurate(const std::string& name, const Level& level, double most) {
  return timed(name, {level},
               {at_most(slower_rates, most,
                        baseline("a tenth above the most that was measured; what bounds it: solvers/sph/README.md"))});
}

std::vector<Method> on_this_machine() {
  std::vector<Method> all = {
      timed("mpm", {M1, M2, M3, M4},
            {at_least(faster, 2, goal).on("M1"), at_least(faster, 2, goal).on("M2"), at_least(faster, 4, goal).on("M4"),
             at_most(lap_cost, 1.05, baseline("timing the sub-steps of one step in 16 must cost nothing; noise is 3 %"))
                 .on("M4")}),
      timed("mpm_watched", {M1, M4}, {at_most(monitor_cost, 1, set_goal)}),
      timed("sph_watched", {S1}, {at_most(monitor_cost, 1, set_goal)}),
      timed("mpm_single", {M4}, {at_least(faster, 4, goal)}),
      timed("mpm_affine", {M2, M4}, {at_least(faster, 2.5, goal).on("M4")}),
      timed("mpm_least_squares", {fitted},
            {at_least(faster, 0.52, baseline("goal set: 60 ns where the plain loop takes 31; 0.65 to 0.70 measured"))}),
      timed("mpm_dam_break", {dam_M4}, {at_least(faster, 2.5, goal)}),
      timed("mpm_apic_dam_break", {dam_A2, dam_A4},
            {at_least(faster, 1.4, kept).on("A2"), at_least(faster, 2.1, kept).on("A4")}),
      timed("mpm_xpic_dam_break", {dam_A2, dam_A4},
            {at_least(faster, 0.75, kept).on("A2"), at_least(faster, 1.7, kept).on("A4")}),
      timed("mpm_empty_background", {tank("1"), tank("10"), tank("100")}, {between(slower, 0.9, 1.1, set_goal)}),
      timed("sph", {S2}, {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 7, goal)}),
      timed("sph_dam_break", {dam_S4}, {at_least(faster_rates, 2.5, goal)}),
      timed("sph_one_evaluation", {S2}, {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 13, goal)}),
      timed("sph_one_evaluation_dam_break", {dam_S4},
            {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 8, goal)}),
      accurate("sph_delta", dam_S2, 6),
      accurate("sph_corrected", dam_S2, 7),
      accurate("sph_shifted", dam_S2, 8.2),
      accurate("sph_second_order", S2, 3.1),
      accurate("sph_second_order_square", S64, 2.85),
      accurate("sph_transport_velocity", S2, 3.4),
      accurate("sph_transport_velocity_square", S64, 3.2)};
  if (std::thread::hardware_concurrency() < 2) return all;
  all.push_back(timed("mpm_threads", {M4},
                      {at_least(used, 0.8,
                                baseline("0.86 where two threads are started in 4.4 us, five times a step: "
                                         "reports/findings.md"))}));
  all.push_back(timed("sph_threads", {S4}, {at_least(used, 0.9, baseline("performance goal: 1.8 of 2"))}));
  return all;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Speed against reference loops",
      .description =
          "Steps of a solver are timed alternately with those of a textbook loop over the same particles, kept in "
          "vnv/bench: medians of CPU time over rounds, one core. Ratios depend less on the machine than times do.",
      .times = {1},
      .measurements = {},
      .methods = on_this_machine(),
      .plots = {tabulate_sub_steps, draw_empty_background},
      .timed = true,
  };
}
