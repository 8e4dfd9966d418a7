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

/// The first seconds of one level.
struct Excerpt {
  double spacing, until;  // m, s
};
/// Runs such an excerpt.
using RunExcerpt = std::function<RunOnce(const Excerpt& excerpt)>;

/// One method of one case, by both programs.
struct Contest {
  std::string case_name, method;
  bool is_timed = false;  // what it judges is time
  RunOnce before, after;
  RunExcerpt excerpt_before{}, excerpt_after{};  // where there are any
  std::optional<Excerpt> excerpt{};              // that is timed in place of the whole, where it is known
};

/// By the program of a build; an excerpt leaves no record where the program is of a revision that writes none of it.
RunOnce run_of(const Program& program, const std::string& method, const std::string& suite,
               const std::optional<Excerpt>& excerpt = {});

/// What two programs found, run after run: the records of all methods that wrote one.
struct Turns {
  std::vector<Records> before{}, after{};                    // equally many
  std::vector<Records> excerpts_before{}, excerpts_after{};  // equally many
};

/// Runs every method `pairs` times by both programs, in turn: before-after, after-before, and so on, and through all
/// methods before the next pair of any. A program that judges time is run once. Where a method took longer than an
/// excerpt of it, it is run as a whole twice, which shows whether it is steady, and then so many times as an excerpt of
/// its dearest level, which becomes that of its contest: the rest of the time would say no more of what a step costs.
/// Says what it does.
Turns take_turns(std::vector<Contest>& contests, long pairs, std::ostream& log);

/// What a method took in each of its pairs: of excerpts, if there are any, else all levels that ended in both, in user
/// CPU time or in the resource that they occupied.
Timing timing_of(const Contest& contest, const Turns& turns);

}  // namespace touchstone::gate
