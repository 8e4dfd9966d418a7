#include "vnv/gate/paired_times.hpp"

#include "vnv/record/median.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::gate {
namespace {

/// Means of all pairs of values, each with itself too, sorted. As many are positive as Wilcoxon's sum of ranks says.
std::vector<double> walsh_averages(const std::vector<double>& values) {
  std::vector<double> means;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k) means.push_back((values[i] + values[k]) / 2);
  std::ranges::sort(means);
  return means;
}

/// How likely each sum of the ranks 1 to n is when each rank counts or not by the toss of a coin.
std::vector<double> rank_sum_probabilities(std::size_t n) {
  std::vector<double> probability = {1};
  for (std::size_t rank = 1; rank <= n; ++rank) {
    std::vector<double> next(probability.size() + rank, 0.0);
    for (std::size_t sum = 0; sum < probability.size(); ++sum) {
      next[sum] += probability[sum] / 2;
      next[sum + rank] += probability[sum] / 2;
    }
    probability = std::move(next);
  }
  return probability;
}

/// The probability that the sum of ranks is at most this, summed from the small end so that little is lost.
double probability_up_to(double sum, std::size_t n) {
  const std::vector<double> probability = rank_sum_probabilities(n);
  double total = 0;
  for (std::size_t s = 0; s < probability.size() && static_cast<double>(s) <= sum; ++s) total += probability[s];
  return total;
}

/// How many averages to leave out at each end, so that between the next ones lie 95 %; -1 if there are too few.
long left_out_at_each_end(std::size_t n) {
  const std::vector<double> probability = rank_sum_probabilities(n);
  double below = 0;
  long left_out = -1;
  for (const double p : probability) {
    below += p;
    if (below > 0.025) return left_out;
    ++left_out;
  }
  return left_out;
}

}  // namespace

std::vector<double> log_ratios(const std::vector<double>& before, const std::vector<double>& after) {
  std::vector<double> found;
  const auto is_time = [](double value) { return value > 0 && std::isfinite(value); };
  for (std::size_t k = 0; k < std::min(before.size(), after.size()); ++k)
    if (is_time(before[k]) && is_time(after[k])) found.push_back(std::log(after[k] / before[k]));
  return found;
}

Ratio ratio_of(const std::vector<double>& log_ratios) {
  Ratio ratio{.pairs = std::ssize(log_ratios)};
  if (log_ratios.empty()) return ratio;
  const std::vector<double> means = walsh_averages(log_ratios);
  ratio.estimate = std::exp(vnv::median(means));
  const long left_out = left_out_at_each_end(log_ratios.size());
  if (left_out < 0) return ratio;
  ratio.lowest = std::exp(means[static_cast<std::size_t>(left_out)]);
  ratio.highest = std::exp(means[means.size() - 1 - static_cast<std::size_t>(left_out)]);
  return ratio;
}

double p_value(const std::vector<double>& log_ratios) {
  if (log_ratios.empty()) return 1;
  double not_positive = 0;  // the sum of ranks of what is negative; zeros count half
  for (const double mean : walsh_averages(log_ratios)) not_positive += mean < 0 ? 1 : mean == 0 ? 0.5 : 0;
  return probability_up_to(not_positive, log_ratios.size());
}

}  // namespace touchstone::gate
