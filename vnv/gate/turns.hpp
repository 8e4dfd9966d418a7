#pragma once
/// Two builds' programs, run in turn.

#include "vnv/gate/cost.hpp"
#include "vnv/gate/source.hpp"

namespace touchstone::gate {

/// One method of one case, by the programs of both builds.
struct Contest {
  std::string method;
  Program before, after;
};

/// What two builds found, run after run: the records of all methods that wrote one.
struct Turns {
  std::vector<Records> before, after;  // equally many
};

/// Runs every method `pairs` times by both programs, in turn: before-after, after-before, and so on, and through all
/// methods before the next pair of any. A program that judges time is run once. Says what it does.
Turns take_turns(const std::vector<Contest>& contests, long pairs, const std::string& suite, std::ostream& log);

/// The user CPU time of a method in each of its pairs: that of all levels that ended in both.
Timing timing_of(const Contest& contest, const Turns& turns);

}  // namespace touchstone::gate
