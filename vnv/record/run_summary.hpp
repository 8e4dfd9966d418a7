#pragma once
/// What a run cost and how it ended.

#include "vnv/record/quantity.hpp"
#include "vnv/record/word_of.hpp"

#include <array>
#include <string>
#include <string_view>

namespace touchstone::vnv {

/// What a run costs. Costs of different resources are never compared.
enum class Resource { cpu, gpu, core };
constexpr auto words(Resource) { return std::to_array<std::string_view>({"CPU", "GPU", "core"}); }
/// "GPU time [s]"
inline std::string heading_of(Resource resource) {
  return std::string(word_of(resource)) + " time [s]";
}

/// What one run cost. Times are medians over the repeats.
struct Cost {
  long particles = 0;           // fluid particles
  long boundary_particles = 0;  // ghosts, repulsive particles; none in a grid method
  long steps = 0;
  long repeats = 1;        // how often the run was made
  double cpu = 0;          // s  user time of the steps and the sampling
  double cpu_lowest = 0;   // s  of the repeats
  double cpu_highest = 0;  // s
  double wall = 0;         // s
  double stepping = 0;     // s  the part of `wall` that was spent in the solver's steps
  double harness = 0;      // s  wall time of all else: checks, sampling, measuring, a process of its own
  double peak_memory = 0;  // bytes  largest resident set of the run's process
  /// Another resource than CPU time, where a run says that it occupied one: then `cpu` is not a number.
  Resource resource = Resource::cpu;
  double occupied = 0;  // s  wall time times how many of the resource

  double spent() const { return resource == Resource::cpu ? cpu : occupied; }  // s  of the resource
  /// s  Not a number of another code, whose steps nobody counts.
  double per_step() const { return steps > 0 ? cpu / static_cast<double>(steps) : not_a_number; }
  double per_particle_step() const { return per_step() / static_cast<double>(particles); }  // s
  double particle_steps_per_second() const { return 1 / per_particle_step(); }              // 1/s
  /// Not a number for a run that timed itself.
  double harness_share() const { return stepping > 0 ? harness / (stepping + harness) : not_a_number; }

  bool operator==(const Cost&) const = default;
};

/// One run of one method at one resolution.
struct RunSummary {
  std::string level{};   // "M2"
  double spacing = 0;    // m
  double time_step = 0;  // s
  double end_time = 0;   // s
  bool finished = false;
  std::string outcome{};  // "finished", or the diagnosis of a diverged run
  Cost cost{};

  bool operator==(const RunSummary&) const = default;
};

}  // namespace touchstone::vnv
