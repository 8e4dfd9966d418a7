#include "vnv/stability/extreme.hpp"

#include "vnv/record/record.hpp"
#include "vnv/stability/named_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

const Quantity ending_met{"outcome: 0 refused, 1 diverged, 2 stable, 3 accurate", ""},
    ending_declared{"declared outcome", ""}, error_at_end{"error at the end time", "%", Kind::error};

Run meet(const Extreme& extreme, const Schedule& when) {
  Run run;
  Ending ending = Ending::diverged;
  double error = not_a_number;
  try {
    run = simulate(extreme.make, {.times = {extreme.end}, .monitor = {}, .name = when.name}, extreme.stepping);
    if (run.summary.finished) {
      if (extreme.error) error = extreme.error(run.samples.back());
      ending = error <= extreme.accurate_within ? Ending::accurate : Ending::stable;
    }
  } catch (const std::invalid_argument& refusal) {
    ending = Ending::refused;
    run.summary.outcome = refusal.what();
    run.summary.cost.steps = 1;  // none, but nothing divides by it
  }
  const bool is_met = extreme.declared < Ending::stable ? ending == extreme.declared : ending >= extreme.declared;
  run.summary.finished = is_met;  // it ended as it was meant to; the outcome says how
  run.add(ends_as_declared, is_met ? 1 : 0);
  run.add(ending_met, static_cast<double>(ending));
  run.add(ending_declared, static_cast<double>(extreme.declared));
  if (std::isfinite(error)) run.add(error_at_end, error);
  return run;
}

std::string words_of(double ending) { return std::string(name_of(static_cast<Ending>(static_cast<int>(ending)))); }

}  // namespace

std::string_view name_of(Ending ending) {
  constexpr std::array names{"refused", "diverged", "stable", "accurate"};
  return names[static_cast<std::size_t>(ending)];
}

Method meeting(Method method, const std::vector<Extreme>& extremes) {
  method.claims = {at_least(ends_as_declared, 1, theory("the outcome follows from what a method is designed for"))};
  // Of an error that is rounding, another order of sums leaves as much as each of some 500 steps rounds: 500 eps, in %.
  method.tolerance = {1.0, "the error of a run that need not be accurate", 1e-11};
  std::vector<NamedRun> runs;
  for (const Extreme& extreme : extremes)
    runs.push_back({{.name = extreme.name,
                     .spacing = 1,
                     .acceptance = extreme.in_acceptance ? extreme.end : 0,
                     .nightly = extreme.end,
                     .may_diverge = true},
                    [=](const Level&, const Schedule& when) { return meet(extreme, when); }});
  return with_runs(std::move(method), std::move(runs));
}

Plot endings(std::vector<std::string> drawn) {
  return [=](const Results& results, Record& record) {
    Table table{"endings",
                "Outcome of each scene",
                "Declared in advance and observed; the error where an exact value is known.",
                {"scene", "method", "expected", "observed", "error [%]", "details"},
                {}};
    for (const Run& run : results.runs) {
      const double error = run.value_of(error_at_end);
      table.rows.push_back({run.summary.level, results.method.name, words_of(run.value_of(ending_declared)),
                            words_of(run.value_of(ending_met)), std::isfinite(error) ? Cell(error) : Cell("–"),
                            run.summary.outcome});
    }
    record.tables.push_back(std::move(table));
    for (const std::string& scene : drawn) {
      const Run* run = results.run(scene);
      if (!run || run->samples.empty()) continue;
      std::string id = "picture_" + scene;
      std::ranges::replace(id, ' ', '_');
      Figure figure{id, scene, "Particles at the end time, coloured by speed.", {"x [m]"}, {"y [m]"}, {"speed [m/s]"}};
      figure.equal_axes = true;
      record.figures.push_back(figure);
      const Samples& s = run->samples.back();
      Cloud cloud{id, results.method.name, fmt::format("t = {:.2g} s", s.time), {}, {}, {}};
      for (Eigen::Index p = 0; p < s.size(); ++p) {
        cloud.x.push_back(s.x(0, p));
        cloud.y.push_back(s.x(1, p));
        cloud.colour.push_back(s.v.col(p).norm());
      }
      record.clouds.push_back(std::move(cloud));
    }
  };
}

}  // namespace touchstone::vnv
