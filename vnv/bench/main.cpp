/// touchstone_bench: the machine's own limits, whole steps of the solvers with the time of their sub-steps, and the
/// plain loops they are measured against, as programs of Google Benchmark. Ratios that are judged are found by the case
/// `speed`, which times in turn; this is for looking closely.

#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "vnv/bench/scenes.hpp"
#include "vnv/bench/in_turn.hpp"
#include "vnv/bench/machine.hpp"
#include "vnv/bench/mls_mpm.hpp"
#include "vnv/bench/plain_musl.hpp"
#include "vnv/bench/plain_sph.hpp"
#include "vnv/run/lap_clock.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

namespace touchstone::bench {
namespace {

/// Operations and bytes of a formulation for one particle and step, counted by hand.
struct Formulation {
  double flops;
  double bytes;
  double state;  // bytes of a particle, which say where it lives
};

/// MPM with linear hats. To the nodes: eight moments of mass 14, four of velocity 14, three stresses times the volume
/// and their three moments 18. From the nodes: two bilinear fields of two components 24, their additions 4, the
/// velocity gradient 8, volume 4, pressure 7, stress 8. One division. Eight numbers (place, velocity, volume, stress)
/// are read to the nodes; five of them are read and all eight written on the way back.
constexpr Formulation mpm_work{.flops = 46 + 55, .bytes = 8.0 * (8 + 5 + 8), .state = 8.0 * 8};

/// SPH as printed, two right-hand sides a step, 20 pairs a particle: differences of place and velocity 4, r² 3, kernel
/// slope 11, v · r and continuity 6, pressure 6, laminar viscosity 9, and one more to add up; one root, two
/// divisions. Seven numbers of each neighbour and its index are read.
constexpr Formulation sph_work{.flops = 2 * 20 * 40, .bytes = 2 * 20 * (8.0 * 7 + 4), .state = 8.0 * 7 + 20 * 4};

const std::vector<MemoryLevel>& levels() {
  static const std::vector<MemoryLevel> found = memory_levels();
  return found;
}

double peak() {
  static const double found = multiply_add_peak<double>();
  return found;
}

double bandwidth(const MemoryLevel& level) {
  static std::map<std::string, double> found;
  const auto [at, is_new] = found.try_emplace(level.name, 0);
  if (is_new) at->second = triad_bandwidth(level);
  return at->second;
}

/// CPU time of a particle-step [s], of all the steps that Google Benchmark asks for.
template <class Step>
double time_steps(benchmark::State& state, double particles, Step step) {
  const double start = cpu_time();
  for ([[maybe_unused]] auto asked : state) step();
  const double each = (cpu_time() - start) / static_cast<double>(state.iterations()) / particles;
  state.counters["ns"] = 1e9 * each;
  state.counters["particle-steps/s"] = 1 / each;
  return each;
}

/// Nanoseconds per particle-step, in all and by sub-step, and how near that comes to the machine's limits.
template <class Solver>
void time_solver(benchmark::State& state, Solver solver, const Formulation& work) {
  const auto particles = static_cast<double>(solver.particles());
  for (int k = 0; k < 20; ++k) solver.step();
  vnv::LapClock laps(16);
  const double each = time_steps(state, particles, [&] { laps.step(solver); });
  const MemoryLevel& level = level_that_holds(particles * work.state, levels());
  state.counters["of peak"] = work.flops / each / peak();
  state.counters["of " + level.name] = work.bytes / each / bandwidth(level);
  for (std::size_t k = 0; k < names_of_sub_steps.size(); ++k)
    if (const double fraction = laps.per_step(SubStep(k)) / laps.per_step(); fraction > 0)
      state.counters[std::string(names_of_sub_steps[k])] = 1e9 * fraction * each;
}

template <class Loop>
void time_loop(benchmark::State& state, Loop loop) {
  for (int k = 0; k < 20; ++k) loop.step();
  time_steps(state, static_cast<double>(loop.particles().size()), [&] { loop.step(); });
}

void measure_machine() {
  const auto report = [](const std::string& name, const std::string& unit, const std::function<double()>& measure) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      double found = 0;
      for ([[maybe_unused]] auto once : state) found = measure();
      state.counters[unit] = found;
    })->Iterations(1);
  };
  report("machine/multiply_add/double", "flops/s", multiply_add_peak<double>);
  report("machine/multiply_add/float", "flops/s", multiply_add_peak<float>);
  for (const MemoryLevel& level : levels())
    report("machine/triad/" + level.name, "bytes/s", [level] { return bandwidth(level); });
}

/// `make` is called when the benchmark runs.
template <class Make>
void add_solver(const std::string& name, const Formulation& work, Make make) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { time_solver(state, make(), work); });
}
template <class Make>
void add_loop(const std::string& name, Make make) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { time_loop(state, make()); });
}

template <class AnyScene>
void add_mpm(const std::string& model, const AnyScene& scene, double cell, double spacing, double time_step) {
  add_solver("mpm/" + model, mpm_work, [=] {
    return mpm::printed<mpm::PrescribedMotion>(scene, {.cell = cell, .spacing = spacing, .time_step = time_step});
  });
  add_loop("plain_musl/" + model, [=] { return PlainMusl(plain(scene), cell, spacing, time_step); });
}

/// With pressure, `term` and artificial viscosity.
template <class AnyScene, class... Terms>
void add_sph(const std::string& model, const AnyScene& scene, double spacing, double time_step, const Terms&... term) {
  add_solver("sph/" + model, sph_work, [=] {
    const double h = 1.2 * spacing;
    return sph::printed<sph::CubicSpline>(
        scene, {.spacing = spacing, .smoothing_length = h, .time_step = time_step},
        sph::momentum(sph::Pressure{}, term...,
                      sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = scene.fluid.sound_speed(), .h = h}));
  });
  add_loop("plain_sph/" + model, [=] { return PlainSph(plain(scene), spacing, time_step); });
}

/// M1 to M4 and S1 to S4 of table 2, and the dam break with 16 particles per cell.
void add_flows() {
  const auto water = channel();
  for (const int k : {1, 2, 3, 4}) {
    const double spacing = channel_cell / k;
    add_mpm(fmt::format("channel/M{}", k), water, channel_cell, spacing, channel_step);
    add_loop(fmt::format("mls_mpm/channel/M{}", k),
             [=] { return MlsMpm(plain(water), channel_cell, spacing, channel_step); });
    add_sph(fmt::format("channel/S{}", k), water, spacing, channel_step,
            sph::LaminarViscosity{.nu = water.fluid.kinematic_viscosity(), .eta = 0.12 * spacing});
  }
  add_mpm("dam/M4", dam(), dam_cell, dam_cell / 4, dam_mpm_step);
  add_sph("dam/S4", dam(), dam_cell / 4, dam_sph_step);
}

}  // namespace
}  // namespace touchstone::bench

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  touchstone::bench::measure_machine();
  touchstone::bench::add_flows();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
