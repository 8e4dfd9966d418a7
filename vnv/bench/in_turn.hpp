#pragma once
/// Times that can be compared on a machine that does other things too: works are timed in turn, A B C A B C ..., so
/// that what slows the machine for a while slows all of them, and medians are taken over the rounds.

#include <functional>
#include <vector>

namespace touchstone::bench {

/// CPU time of this process so far [s], of all its threads.
double cpu_time();
/// Time of day, for works with threads [s].
double wall_time();

using Work = std::function<void()>;
using Clock = double (*)();

/// How long to time.
struct Effort {
  int rounds = 9;
  double seconds = 0.02;  // of each work in each round, at least one call
  Clock clock = cpu_time;
};

/// Seconds per call of each work in each round.
class Times {
 public:
  explicit Times(std::vector<std::vector<double>> of_works) : of_works_(std::move(of_works)) {}

  /// Median over the rounds [s].
  double of(std::size_t work) const;
  /// Median over the rounds of how many times as long one work takes as another.
  double ratio(std::size_t work, std::size_t to) const;
  /// Half the distance of the quartiles of that ratio, over it: how far it is to be trusted.
  double spread(std::size_t work, std::size_t to) const;

 private:
  std::vector<double> ratios(std::size_t work, std::size_t to) const;

  std::vector<std::vector<double>> of_works_;
};

/// Each work is called once untimed, to warm up, and once to find how many calls fill its time.
Times time_in_turn(const std::vector<Work>& works, const Effort& effort = {});

}  // namespace touchstone::bench
