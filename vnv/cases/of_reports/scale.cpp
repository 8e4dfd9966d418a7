/// Cost per particle from a thousand to ten million particles: time of a step, and memory.

#include "vnv/bench/machine.hpp"
#include "vnv/bench/race.hpp"
#include "vnv/bench/scenes.hpp"
#include "vnv/flows/channels/channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::bench;

namespace {

const Quantity dearer{"time per particle-step over that with 10^4 particles", "", Kind::cost};
const Quantity memory{"peak memory", "GB", Kind::cost}, memory_each{"peak memory per particle", "bytes", Kind::cost};
// The time of a particle-step beyond that among 10^4 particles, in what the machine moves through memory meanwhile.
const Quantity moved_meanwhile{"memory traffic in the extra time per particle-step over 10^4 particles", "bytes",
                               Kind::cost};
const Quantity passes{
    "memory traffic in the extra time per particle-step over 10^4 particles, over the memory of a particle", "",
    Kind::cost};
const Author goal = baseline("performance goal");
const Author two_reads_and_a_write = theory("a step reads the particles twice and writes them once");

constexpr double spacing = channel_cell / 2;

/// So many particles, but for rounding to whole cells, in a channel twice as high as it is long.
Scene<Newtonian, Uniform> channel_of(double particles) {
  const double cells = std::round(std::sqrt(particles / 2) * spacing / channel_cell);
  return bench::channel(cells * channel_cell, 2 * cells * channel_cell);
}

auto mpm_of(double particles) {
  return mpm_solver<>(channel_of(particles), {.name = "", .spacing = spacing, .cell = channel_cell}, channel_step);
}
auto sph_of(double particles) {
  return sph_printed_solver<>(channel_of(particles), {.name = "", .spacing = spacing}, channel_step);
}

/// Bytes a second that this machine moves through as much memory as so many particles take, or a little less: the peak
/// of memory shall be that of the run.
double bandwidth_among(double particles) {
  constexpr double each = 120;  // bytes
  return triad_bandwidth({.name = "the particles", .bytes = 2 * each * particles});
}

/// Timed in turn with ten thousand particles, so that both meet the same machine. Where a state outgrows the caches,
/// its bytes have to be moved: what that costs is a matter of the machine, not of the solver, so the machine is asked.
template <class Make>
auto scale(Make make) {
  return [make](const Level& level, const Schedule&) {
    const double expected = std::stod(level.name),
                 bandwidth = expected > 1e5 ? bandwidth_among(expected) : not_a_number;
    auto few = make(1e4), many = make(expected);
    const int rounds = many.particles() > 2'000'000 ? 5 : 15;
    const Times times = time_in_turn({[&] { many.step(); }, [&] { few.step(); }}, {.rounds = rounds});
    Run run = run_of(many, times.of(0));
    const double each = times.of(0) / static_cast<double>(many.particles()),
                 among_few = times.of(1) / static_cast<double>(few.particles());
    run.add(dearer, times.ratio(0, 1) * static_cast<double>(few.particles()) / static_cast<double>(many.particles()));
    if (!std::isnan(bandwidth)) run.add(moved_meanwhile, (each - among_few) * bandwidth);
    run.add(spread, 100 * times.spread(0, 1));
    return run;
  };
}

double time_of_particle_step(const Run& run) { return run.summary.cost.per_particle_step(); }  // s
/// Bytes; each run had a process of its own.
double memory_of_particle(const Run& run) {
  return run.summary.cost.peak_memory / static_cast<double>(run.summary.cost.particles);
}

std::vector<Value> find_memory(const Results& results, const Record&) {
  std::vector<Value> all;
  for (const Run& run : results.runs) {
    const auto found = [&](const Quantity& quantity, double value) {
      all.push_back({run.summary.level, run.summary.spacing, not_a_number, quantity, value});
    };
    found(memory, 1e-9 * run.summary.cost.peak_memory);
    found(memory_each, memory_of_particle(run));
    if (const double bytes = run.value_of(moved_meanwhile); !std::isnan(bytes))
      found(passes, bytes / memory_of_particle(run));
  }
  return all;
}

/// 10^3 to 10^7, of which report leaves out the last, as one ladder.
Method scaling(Method method) {
  Ladder ladder{"particles at equal spacing", {"1e3", "1e4", "1e5", "1e6", "1e7"}};
  for (const std::string& name : ladder.levels)
    method.levels.push_back(
        {.name = name, .spacing = spacing, .cell = channel_cell, .report = name == "1e7" ? 0.0 : 1.0, .nightly = 1});
  method.ladders = {std::move(ladder)};
  return method;
}

Plot over_particles(std::string id, std::string title, std::string caption, Axis axis,
                    double (*number_of)(const Run&)) {
  return along_ladders({std::move(id),
                        std::move(title),
                        std::move(caption),
                        {.label = "particle number", .logarithmic = true},
                        std::move(axis)},
                       {}, particle_number(), {{"", [=](const Record&, const Run& run) { return number_of(run); }}});
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Scaling to ten million particles",
      .description =
          "A channel with four particles per cell, whose size grows with the number of particles. A few steps are run, "
          "each size in a process of its own, timed alternately with ten thousand particles. Where the state outgrows "
          "a cache, the time per particle-step rises; the extra time is expressed as the number of times that the "
          "machine could move a particle's memory in it, at the bandwidth measured by McCalpin's STREAM triad.",
      .times = {1},
      .measurements = {},
      .findings = {find_memory},
      .methods = {scaling({.name = "mpm",
                           .description = channel::mpm_words + channel::moving_words,
                           .run = scale(mpm_of),
                           // Moving bytes is all that many particles may cost more: a ratio of times would rise where
                           // arithmetic is fast and memory slow, from 2.4 to 4 between two machines.
                           .claims = {at_most(passes, 3, two_reads_and_a_write).on("1e6"),
                                      at_most(passes, 3, two_reads_and_a_write).on("1e7"),
                                      at_most(memory, 3, goal).on("1e7")}}),
                  scaling({.name = "sph",
                           .description = channel::sph_printed_words + channel::conservative_words,
                           .run = scale(sph_of),
                           .claims = {at_most(dearer, 2.5, goal).on("1e6"), at_most(dearer, 2.5, goal).on("1e7"),
                                      at_most(memory, 6, goal).on("1e7")}})},
      .plots = {over_particles(
                    "cost_per_particle", "CPU time per particle-step", "One core. The channel grows at equal spacing.",
                    {.label = "time per particle-step [ns]", .scale = 1e9, .logarithmic = true}, time_of_particle_step),
                over_particles("memory_per_particle", "Memory per particle",
                               "Peak memory of the process over the number of particles; below 10^5 particles it is "
                               "mostly that of the program.",
                               {.label = "memory per particle [bytes]", .logarithmic = true}, memory_of_particle)},
      .timed = true,
  };
}
