#include "vnv/flows/channel_run_time.hpp"

#include "vnv/record/record.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::vnv::channel {
namespace {

/// A level in the suites that can afford it, its step shortened so that a whole number of steps ends at 1 s.
Level affordable(Level level, double particles, double longest, const Effort& effort) {
  const double weight = level.time_step < longest ? 10 : 1;
  level.time_step = 1 / std::ceil(1 / level.time_step - 1e-9);
  const double work = weight * particles / level.time_step;  // particle-steps in 1 s of flow
  level.name += fmt::format(", {:.3g} us", level.time_step / us);
  level.report = work <= effort.report ? 1 : 0;
  level.nightly = work <= effort.nightly ? 1 : 0;
  return level;
}

/// A thousand steps of the paper's models with 800 and 3200 particles, to compare the cost of a step.
Level thousand_steps(std::string name, double spacing, double cell = not_a_number) {
  const double end = 1000 * dt;
  return {.name = std::move(name) + ", 1000 steps",
          .spacing = spacing,
          .cell = cell,
          .time_step = dt,
          .report = end,
          .nightly = end};
}

/// The longest step, half of it, and that of the paper where it is shorter.
std::vector<double> steps_below(double longest) {
  std::vector<double> steps = {longest, longest / 2};
  if (longest > 2.4 * dt) steps.push_back(dt);
  return steps;
}

double longest_step(double length, const StepLimits& limits) {
  return limits.fraction * std::min(limits.acoustic * length / water.sound_speed(),
                                    limits.viscous * length * length / water.kinematic_viscosity());
}

WorkPoint elsewhere(std::string series, std::string family, std::string run, double particles, double error,
                    double cpu) {
  return {.series = std::move(series),
          .family = std::move(family),
          .run = std::move(run),
          .elsewhere = true,
          .particles = particles,
          .error = error,
          .cpu = cpu,
          .cpu_lowest = cpu,
          .cpu_highest = cpu};
}

}  // namespace

std::vector<Level> mpm_run_time_levels(const std::vector<int>& cells, const std::array<double, 2>& acoustic,
                                       Effort effort) {
  std::vector<Level> levels;
  for (const int n : cells)
    for (const int points_across : {1, 2}) {
      const double cell = H / n;
      const double longest = longest_step(cell, {.acoustic = acoustic[points_across - 1], .fraction = 0.9});
      for (const double step : steps_below(longest))
        levels.push_back(affordable({.name = fmt::format("{} cells, {} per cell", n, points_across * points_across),
                                     .spacing = cell / points_across,
                                     .cell = cell,
                                     .time_step = step},
                                    L * H / (cell * cell) * points_across * points_across, longest, effort));
    }
  levels.push_back(thousand_steps("M1", H / 40, H / 40));
  levels.push_back(thousand_steps("M2", H / 80, H / 40));
  return levels;
}

std::vector<Level> sph_run_time_levels(const std::vector<int>& particles, double smoothing, StepLimits limits,
                                       Effort effort) {
  std::vector<Level> levels;
  for (const int n : particles) {
    const double longest = longest_step(smoothing * H / n, limits);
    for (const double step : steps_below(longest))
      levels.push_back(affordable({.name = fmt::format("{} across", n), .spacing = H / n, .time_step = step},
                                  L / H * n * n, longest, effort));
  }
  levels.push_back(thousand_steps("S1", H / 40));
  levels.push_back(thousand_steps("S2", H / 80));
  return levels;
}

WorkDiagram work_diagram() {
  return {.id = "work",
          .title = "Work-precision diagram",
          .caption =
              "L2 error of the particles' velocities at t = 1 s against CPU time, each "
              "method over resolutions and time steps; lower left is better.",
          .quantity = l2,
          .targets = {3, 1, 0.3, 0.1},
          .ranked_by = 1};
}

std::vector<WorkPoint> published_work(const std::string& flow) {
  std::vector<WorkPoint> points;
  for (const char* family : {"MPM", "SPH"}) {
    const DataTable paper = published(flow, family);
    const ValuesWithUnits& geometry = paper.provenance().geometry;
    const double steps = geometry.at("end_time").value / geometry.at("time_step").value;
    for (std::size_t k = 0; k < paper.rows(); ++k) {
      const double per_step = 1e-3 * paper.numbers("T_p [ms]")[k];
      points.push_back(elsewhere(fmt::format("Sun et al., {}", family), family, paper.words("model")[k],
                                 paper.numbers("particles [-]")[k], paper.numbers("L2 [%]")[k], steps * per_step));
      points.back().per_step = per_step;
    }
  }
  return points;
}

std::vector<WorkPoint> peers_in_poiseuille_flow() {
  const DataTable peers =
      read_table(data_folder() / "peers" / "poiseuille_run_time.csv", {"code", "particles [-]", "L2 [%]", "CPU [s]"});
  require_geometry(peers, "gap", H, 1e-9);
  require_geometry(peers, "end_time", 1, 1e-9);
  std::vector<WorkPoint> points;
  for (std::size_t k = 0; k < peers.rows(); ++k)
    points.push_back(elsewhere(peers.words("code")[k], "SPH", "", peers.numbers("particles [-]")[k],
                               peers.numbers("L2 [%]")[k], peers.numbers("CPU [s]")[k]));
  return points;
}

}  // namespace touchstone::vnv::channel
