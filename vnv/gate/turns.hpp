#pragma once
/// Two programs, run in turn.

#include "vnv/gate/cost.hpp"
#include "vnv/gate/source.hpp"

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace touchstone::gate {

/// Runs a method once and gives its record; none if nothing was recorded, of which it says why.
using RunOnce = std::function<std::optional<vnv::Record>(std::ostream& log, const programs::Meanwhile& meanwhile)>;

/// One method of one case, by both programs.
struct Contest {
  std::string case_name, method;
  bool is_timed = false;  // what it judges is time
  RunOnce before, after;
};

/// By the program of a build.
RunOnce run_of(const Program& program, const std::string& method, const std::string& suite);

/// What two programs found, run after run: the records of all methods that wrote one.
struct Turns {
  std::vector<Records> before, after;  // equally many
};

/// Runs every method `pairs` times by both programs, in turn: before-after, after-before, and so on, and through all
/// methods before the next pair of any. A program that judges time is run once. Says what it does.
Turns take_turns(const std::vector<Contest>& contests, long pairs, std::ostream& log);

/// What a method took in each of its pairs: all levels that ended in both, in user CPU time or in the resource that
/// they occupied.
Timing timing_of(const Contest& contest, const Turns& turns);

}  // namespace touchstone::gate
