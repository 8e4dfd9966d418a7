#include "vnv/gate/cost.hpp"

#include "vnv/record/median.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

namespace touchstone::gate {
namespace {

using vnv::median;

/// Why its times are not compared; empty if they are.
std::string why_not(const Timing& timing) {
  if (timing.resource_before != timing.resource_after)
    return fmt::format("{} before and {} after, which are not compared", vnv::heading_of(timing.resource_before),
                       vnv::heading_of(timing.resource_after));
  if (median(timing.before) < shortest_timed && median(timing.after) < shortest_timed)
    return fmt::format("runs take less than {} s, too short to time", shortest_timed);
  return "";
}

/// Which of the p-values rule chance out when all are tested: the smallest has to be below the fraction that is
/// allowed over how many there are, the next below that over one fewer, until one is not.
std::vector<bool> ruled_out_by_holm(const std::vector<double>& p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return p_values[k]; });
  std::vector<bool> is_ruled_out(p_values.size(), false);
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    if (!(p_values[order[rank]] <= false_alarms / static_cast<double>(order.size() - rank))) break;
    is_ruled_out[order[rank]] = true;
  }
  return is_ruled_out;
}

std::string in_words(const Ratio& ratio) {
  return fmt::format("{:.3f} times as long, 95 % interval {:.3f} to {:.3f}, {} pairs of runs", ratio.estimate,
                     ratio.lowest, ratio.highest, ratio.pairs);
}

/// Whether nobody would mind and what must be noticed is ruled out.
bool is_harmless(const Ratio& ratio) {
  return ratio.estimate < 1 + smallest_slowdown && ratio.highest < 1 + noticed_slowdown;
}

void conclude(Difference& cost, const Ratio& ratio, bool is_slower, bool is_faster) {
  cost.why = in_words(ratio);
  if (is_slower && ratio.estimate >= 1 + smallest_slowdown)
    cost.change = Change::worse;
  else if (is_faster && ratio.estimate <= 1 / (1 + smallest_slowdown))
    cost.change = Change::better;
  else
    cost.change = is_harmless(ratio) ? Change::same : Change::inconclusive;
  if (ratio.pairs < least_pairs) cost.why += fmt::format(", expected at least {}", least_pairs);
}

std::vector<double> negated(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

/// Before it is judged.
Difference difference_of(const Timing& timing) {
  return {
      .case_name = timing.case_name,
      .method = timing.method,
      .quantity = (timing.resource_after == vnv::Resource::cpu ? "user " : "") + vnv::heading_of(timing.resource_after),
      .kind = Kind::cost,
      .before = median(timing.before),
      .after = median(timing.after),
      .why = why_not(timing)};
}

}  // namespace

bool is_settled(const Timing& timing) {
  if (!why_not(timing).empty()) return true;
  const Ratio ratio = ratio_of(log_ratios(timing.before, timing.after));
  return is_harmless(ratio) && ratio.estimate > 1 / (1 + smallest_slowdown);
}

std::vector<Difference> judge_costs(const std::vector<Timing>& timings) {
  std::vector<Difference> costs;
  std::vector<Ratio> ratios;
  std::vector<double> slower, faster;
  for (const Timing& timing : timings) {
    const std::vector<double> logarithms = log_ratios(timing.before, timing.after);
    const bool is_judged = costs.emplace_back(difference_of(timing)).why.empty();
    ratios.push_back(ratio_of(logarithms));
    slower.push_back(is_judged ? p_value(logarithms) : 1);
    faster.push_back(is_judged ? p_value(negated(logarithms)) : 1);
  }
  const std::vector<bool> is_slower = ruled_out_by_holm(slower), is_faster = ruled_out_by_holm(faster);
  for (std::size_t k = 0; k < costs.size(); ++k)
    if (costs[k].why.empty()) conclude(costs[k], ratios[k], is_slower[k], is_faster[k]);
  return costs;
}

std::vector<Difference> compare_costs(const std::vector<Timing>& first, const TimeAgain& time_again) {
  std::vector<Timing> settled, doubtful;
  for (const Timing& timing : first) (is_settled(timing) ? settled : doubtful).push_back(timing);
  if (!doubtful.empty()) doubtful = time_again(doubtful);
  std::vector<Difference> found = judge_costs(settled);
  std::ranges::move(judge_costs(doubtful), std::back_inserter(found));
  return found;
}

}  // namespace touchstone::gate
