/// What a particle costs among a thousand and among ten million: time of a step, and memory.

#include "vnv/bench/flows.hpp"
#include "vnv/bench/race.hpp"
#include "vnv/channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::bench;

namespace {

const std::string dearer = "time per particle-step over that among 10^4 particles [-]";
const std::string memory = "peak memory [GB]", memory_each = "peak memory per particle [bytes]";
const Author goal = baseline("goal set");

constexpr double spacing = channel_cell / 2;
const std::string ladder = "particles at equal spacing";

/// So many particles, but for rounding to whole cells, in a channel twice as high as it is long.
Scene<Newtonian, Uniform> channel_of(double particles) {
  const double cells = std::round(std::sqrt(particles / 2) * spacing / channel_cell);
  return bench::channel(cells * channel_cell, 2 * cells * channel_cell);
}

auto mpm_of(double particles) {
  return mpm::solver<mpm::LinearHat, mpm::PrescribedMotion>(
      channel_of(particles), {.cell = channel_cell, .spacing = spacing, .time_step = channel_step});
}
auto sph_of(double particles) {
  return channel::printed_solver(channel_of(particles), {.name = "", .spacing = spacing}, channel_step);
}

/// Timed in turn with ten thousand particles, so that both meet the same machine.
template <class Make>
auto scale(Make make) {
  return [make](const Rung& rung, const Schedule&) {
    auto few = make(1e4), many = make(std::stod(rung.name));
    const int rounds = many.particles() > 2'000'000 ? 5 : 15;
    const Times times = time_in_turn({[&] { many.step(); }, [&] { few.step(); }}, {.rounds = rounds});
    Run run = run_of(many, times.of(0));
    run.add(dearer, times.ratio(0, 1) * static_cast<double>(few.particles()) / static_cast<double>(many.particles()));
    run.add(spread, 100 * times.spread(0, 1));
    return run;
  };
}

/// Each run had a process of its own.
std::vector<Error> find_memory(const Results& results, const Record&) {
  std::vector<Error> all;
  for (const Run& run : results.runs) {
    const Cost& cost = run.summary.cost;
    const Error of_run{run.summary.rung, run.summary.spacing, not_a_number, memory, 1e-9 * cost.peak_memory};
    all.push_back(of_run);
    all.push_back(of_run);
    all.back().quantity = memory_each;
    all.back().value = cost.peak_memory / static_cast<double>(cost.particles);
  }
  return all;
}

/// 10^3 to 10^7; report stops at 10^6.
std::vector<Rung> rungs() {
  std::vector<Rung> all;
  for (const char* name : {"1e3", "1e4", "1e5", "1e6", "1e7"}) {
    const bool largest = std::string_view(name) == "1e7";
    all.push_back(
        {.name = name, .spacing = spacing, .cell = channel_cell, .report = largest ? 0.0 : 1.0, .nightly = 1});
  }
  return all;
}
const std::vector<Ladder> ladders{{ladder, {"1e3", "1e4", "1e5", "1e6", "1e7"}}};

std::vector<Claim> claims(double gigabytes) {
  return {at_most(dearer, 2.5, goal).on("1e6"), at_most(dearer, 2.5, goal).on("1e7"),
          at_most(memory, gigabytes, goal).on("1e7")};
}

Pick per_particle_step() {
  return [](const Record&, const Run& run) { return run.summary.cost.per_particle_step(); };
}
Pick memory_per_particle() {
  return [](const Record&, const Run& run) {
    return run.summary.cost.peak_memory / static_cast<double>(run.summary.cost.particles);
  };
}

}  // namespace

Case vnv::the_case() {
  const Axis number{.label = "particle number", .logarithmic = true};
  return {
      .title = "Scale",
      .description =
          "A channel with four particles per cell, the larger the more particles it has; a few steps, each run in a "
          "process of its own and timed in turn with ten thousand particles. Where the state outgrows a cache, time bends "
          "upwards.",
      .times = {1},
      .measurements = {},
      .findings = {find_memory},
      .methods = {{.name = "mpm",
                   .description = channel::mpm_words + channel::moving_words,
                   .run = scale(mpm_of),
                   .rungs = rungs(),
                   .ladders = ladders,
                   .claims = claims(3)},
                  {.name = "sph",
                   .description = channel::sph_printed_words + channel::conservative_words,
                   .run = scale(sph_of),
                   .rungs = rungs(),
                   .ladders = ladders,
                   .claims = claims(6)}},
      .plots = {along_ladders({"cost_per_particle",
                               "CPU time of a particle-step",
                               "One core. The channel grows at equal spacing.",
                               number,
                               {.label = "time per particle-step [ns]", .scale = 1e9, .logarithmic = true}},
                              {}, particle_number(), {{"", per_particle_step()}}),
                along_ladders({"memory_per_particle",
                               "Memory of a particle",
                               "Peak memory of the process over the number of particles; below 10^5 particles it is "
                               "that of the program.",
                               number,
                               {.label = "memory per particle [bytes]", .logarithmic = true}},
                              {}, particle_number(), {{"", memory_per_particle()}})},
      .timed = true,
  };
}
