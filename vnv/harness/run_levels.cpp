#include "vnv/harness/run_levels.hpp"

#include "vnv/harness/run_bytes.hpp"
#include "vnv/run/own_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

Schedule schedule_for(const Case& declared, const std::string& name, double until) {
  Schedule when{{}, declared.monitor, name};
  for (const double time : declared.times)
    if (time <= until * (1 + 1e-9)) when.times.push_back(time);
  if (when.times.empty() || when.times.back() < until * (1 - 1e-9)) when.times.push_back(until);
  return when;
}

/// A level of the suite and what its processes left. It is read when all have ended, since whatever this process holds
/// would count as memory of the next.
struct Attempt {
  Level level;
  Schedule when;
  Ended first;
  double harness = 0;         // s  of the first run, in this process
  std::vector<Cost> again{};  // the cost of each repeat
};

/// The run, with its harness charged for everything but the solver's set-up and steps once the caller adds the time
/// that it waited.
Run run_and_charge(const Method& method, const Level& level, const Schedule& when) {
  const StopWatch solving;
  Run run = method.run(level, when);
  run.summary.cost.harness -= solving.seconds();
  return run;
}

Attempt first_attempt(const Method& method, const Level& level, Schedule when) {
  const StopWatch waiting;
  Ended ended = in_own_process([&] { return to_bytes(run_and_charge(method, level, when)); });
  return {level, std::move(when), std::move(ended), waiting.seconds()};
}

void repeat(const Method& method, Attempt& attempt) {
  const StopWatch waiting;
  const Ended ended = in_own_process([&] {
    const Cost cost = run_and_charge(method, attempt.level, attempt.when).summary.cost;
    return std::string(reinterpret_cast<const char*>(&cost), sizeof cost);
  });
  if (!ended.crash.empty())
    throw std::runtime_error(fmt::format("{}: crashed when repeated: {}", attempt.when.name, ended.crash));
  Cost cost;
  std::memcpy(&cost, ended.result().data(), sizeof cost);
  cost.harness += waiting.seconds();
  cost.peak_memory = ended.peak_memory;
  attempt.again.push_back(cost);
}

/// Round after round through the runs that are short enough for what is left of the budget.
void repeat_in_turn(const Method& method, const Repeats& repeats, std::vector<Attempt>& attempts) {
  double left = repeats.budget;
  for (long round = 1; round < repeats.most; ++round)
    for (Attempt& attempt : attempts)
      if (attempt.first.crash.empty() && attempt.first.user_time <= std::min(left, repeats.longest)) {
        left -= attempt.first.user_time;
        repeat(method, attempt);
      }
}

Run run_of(const Attempt& attempt) {
  Run run;
  const StopWatch reading;
  if (attempt.first.crash.empty())
    run = run_from(attempt.first.result());
  else
    run.summary.outcome = attempt.first.crash;
  Cost& cost = run.summary.cost;
  cost.harness += attempt.harness + reading.seconds();
  cost.peak_memory = attempt.first.peak_memory;
  std::vector<Cost> all = attempt.again;
  all.insert(all.begin(), cost);
  cost = cost_of_repeats(all);
  run.summary.level = attempt.level.name;
  run.summary.spacing = attempt.level.spacing;
  for (Value& found : run.found) found.level = attempt.level.name, found.spacing = attempt.level.spacing;
  return run;
}

/// Whether the solver of a method, if its runs are of one, can be made.
bool is_accepted(const Method& method, const Level& level) try {
  if (method.solver && method.time_step) method.solver(level, level.step_or(method.time_step(level)));
  return true;
} catch (const std::invalid_argument&) {
  return false;
}

/// Particles times steps, relative to other levels of its method that name their step.
double work_of(const Level& level) {
  const double period = std::isnan(level.period) ? 1 : level.period;
  return level.work * period / (level.spacing * level.spacing * level.time_step);
}

/// A run of the suite of error against run time.
struct Tried {
  const Level* level;
  double error, cpu;
};

/// Whether refining a combination may gain something: unless another one of that sound speed had two thirds of the
/// error of its next coarser run at no more cost.
bool is_promising(const Level& level, const std::vector<Tried>& tried) {
  const auto same = [&](const Tried& one) { return one.level->combination == level.combination; };
  const auto coarser = std::find_if(tried.rbegin(), tried.rend(), same);
  if (coarser == tried.rend()) return true;
  return std::ranges::none_of(tried, [&](const Tried& other) {
    const bool differ = other.level->sound_speed < level.sound_speed || other.level->sound_speed > level.sound_speed;
    return !differ && other.cpu <= coarser->cpu && other.error < coarser->error / 1.5;
  });
}

/// Those of a suite; in that of error against run time, which ends when its budget is spent, the cheapest first.
std::vector<Level> levels_of(const Method& method, Suite suite) {
  std::vector<Level> levels;
  std::ranges::copy_if(method.levels, std::back_inserter(levels), [&](const Level& l) { return l.until(suite) > 0; });
  if (suite == Suite::work) std::ranges::stable_sort(levels, {}, work_of);
  return levels;
}

}  // namespace

std::vector<Run> run_levels(const std::string& case_name, const Case& declared, const Method& method, Suite suite) {
  const std::vector<Level> levels = levels_of(method, suite);
  std::vector<Attempt> attempts;
  std::vector<Tried> tried;
  double left = suite == Suite::work ? declared.work_budget : std::numeric_limits<double>::infinity();  // s
  double rate = 0;  // s  user time of a unit of work; that of the smallest runs is mostly their process
  for (const Level& level : levels) {
    if (rate * work_of(level) > left) break;
    if (suite == Suite::work && !(is_promising(level, tried) && is_accepted(method, level))) continue;
    const std::string name = fmt::format("{}.{} {}", case_name, method.name, level.name);
    attempts.push_back(first_attempt(method, level, schedule_for(declared, name, level.until(suite))));
    if (suite != Suite::work) continue;
    const double user_time = attempts.back().first.user_time;
    left -= user_time;
    rate = std::max(user_time / work_of(level), rate / 2);
    if (!declared.error_of_work) continue;
    const Run run = run_of(attempts.back());  // whose own time is exact; that of a short process is counted in ticks
    tried.push_back({&level, declared.error_of_work(level, run), run.summary.cost.cpu});
  }
  if (suite != Suite::acceptance) repeat_in_turn(method, declared.repeats, attempts);
  std::vector<Run> runs;
  for (const Attempt& attempt : attempts) runs.push_back(run_of(attempt));
  return runs;
}

Level level_at(const Method& method, double spacing) {
  Level level{.name = "custom", .spacing = spacing};
  const auto nearest = std::ranges::min_element(
      method.levels, {}, [&](const Level& known) { return std::abs(std::log(known.spacing / spacing)); });
  if (nearest == method.levels.end()) return level;
  const double cell = level.cell = spacing * (nearest->cell / nearest->spacing);
  for (double larger = 1; !is_accepted(method, level) && larger < 1.5; larger += 0.05) level.cell = larger * cell;
  return level;
}

}  // namespace touchstone::vnv
