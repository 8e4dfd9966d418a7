#include "vnv/judge/distribution.hpp"

#include "vnv/record/quantity.hpp"

#include <fmt/format.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

namespace touchstone::vnv {
namespace {

/// All values in order, and of which of two samples each is.
struct Pooled {
  std::vector<double> values{};
  std::vector<char> of_first{};
  double first = 0, second = 0;  // how many
};

Pooled pooled(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<std::pair<double, char>> all;
  for (const double value : a) all.emplace_back(value, true);
  for (const double value : b) all.emplace_back(value, false);
  std::ranges::sort(all);
  Pooled both{.first = static_cast<double>(a.size()), .second = static_cast<double>(b.size())};
  for (const auto& [value, of_first] : all) {
    both.values.push_back(value);
    both.of_first.push_back(of_first);
  }
  return both;
}

/// The area between the two distribution functions.
double distance_of(const Pooled& both) {
  double first = 0, second = 0, area = 0;  // members so far
  for (std::size_t k = 0; k + 1 < both.values.size(); ++k) {
    (both.of_first[k] ? first : second) += 1;
    area += std::abs(first / both.first - second / both.second) * (both.values[k + 1] - both.values[k]);
  }
  return area;
}

/// Of Anderson & Darling, but for a factor; between equal values nothing is counted.
double unlikeness_of(const Pooled& both) {
  const double all = both.first + both.second;
  double of_first = 0, since_last = 0, sum = 0;
  for (std::size_t k = 0; k + 1 < both.values.size(); ++k) {
    of_first += both.of_first[k];
    ++since_last;
    if (both.values[k] == both.values[k + 1]) continue;
    const double below = static_cast<double>(k + 1), excess = all * of_first - both.first * below;
    sum += since_last * excess * excess / (below * (all - below));
    since_last = 0;
  }
  return sum;
}

bool is_finite(const std::vector<double>& sample) {
  return !sample.empty() && std::ranges::all_of(sample, [](double value) { return std::isfinite(value); });
}

}  // namespace

double quantile(std::vector<double> sample, double fraction) {
  if (sample.empty() || !(fraction >= 0 && fraction <= 1))
    throw std::invalid_argument(
        fmt::format("quantile: {} values, fraction {}, expected at least one and 0 to 1", sample.size(), fraction));
  std::ranges::sort(sample);
  const double place = fraction * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == sample.size()) return sample.back();
  return std::lerp(sample[below], sample[below + 1], place - static_cast<double>(below));
}

double wasserstein_distance(const std::vector<double>& a, const std::vector<double>& b) {
  return is_finite(a) && is_finite(b) ? distance_of(pooled(a, b)) : not_a_number;
}

bool MedianComparison::shows_model_error() const { return !(std::abs(error) <= 2 * uncertainty); }

MedianComparison compare_median(const std::vector<double>& members, double median, double deviation, double repeats) {
  const auto error_of_median = [](double its_deviation, double count) {
    return std::sqrt(std::numbers::pi / 2) * its_deviation / std::sqrt(count);
  };
  const auto count = static_cast<double>(members.size());
  const double mean = std::accumulate(members.begin(), members.end(), 0.0) / count;
  double squares = 0;
  for (const double one : members) squares += (one - mean) * (one - mean);
  const double of_members = count > 1 ? std::sqrt(squares / (count - 1)) : HUGE_VAL;
  return {quantile(members, 0.5) - median,
          std::hypot(error_of_median(deviation, repeats), error_of_median(of_members, count))};
}

AgainstQuantiles against_quantiles(const std::vector<double>& sample, const std::vector<double>& quantiles,
                                   const std::vector<double>& of) {
  const auto rise = [](const std::vector<double>& all) {
    return std::ranges::is_sorted(all) && std::ranges::adjacent_find(all) == all.end();
  };
  if (quantiles.empty() || quantiles.size() != of.size() || !rise(quantiles) || !rise(of) ||
      !(of.front() > 0 && of.back() < 1))
    throw std::invalid_argument(
        fmt::format("quantiles: {} values at {} fractions, expected equally many, both strictly increasing, fractions "
                    "between 0 and 1",
                    quantiles.size(), of.size()));
  if (!is_finite(sample)) return {not_a_number, not_a_number};
  std::vector<double> between;  // the probability of each range
  for (std::size_t k = 0; k <= of.size(); ++k) between.push_back((k < of.size() ? of[k] : 1) - (k > 0 ? of[k - 1] : 0));
  const double n = static_cast<double>(sample.size());
  double found = 0;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const auto below = std::ranges::count_if(sample, [&](double x) { return x <= quantiles[k]; });
    found = std::max(found, std::abs(static_cast<double>(below) / n - of[k]));
  }
  // Every way to share out the members over the ranges.
  double p = 0;
  std::vector<unsigned> counts(between.size(), 0);
  const auto share_out = [&](const auto& self, std::size_t range, unsigned left, double distance) -> void {
    counts[range] = left;
    if (range + 1 == counts.size()) {
      if (distance >= found - 1e-12) p += gsl_ran_multinomial_pdf(counts.size(), between.data(), counts.data());
      return;
    }
    for (unsigned here = 0; here <= left; ++here) {
      counts[range] = here;
      const double below = (n - left + here) / n;
      self(self, range + 1, left - here, std::max(distance, std::abs(below - of[range])));
    }
  };
  share_out(share_out, 0, static_cast<unsigned>(sample.size()), 0);
  return {found, std::min(p, 1.0)};
}

bool median_is_inside(const std::vector<double>& members, double low, double high) {
  if (!is_finite(members)) return false;
  const double median = quantile(members, 0.5);
  return median >= low && median <= high;
}

double p_value(const std::vector<double>& a, const std::vector<double>& b, long deals) {
  if (!is_finite(a) || !is_finite(b)) return 0;
  Pooled both = pooled(a, b);
  const double found = unlikeness_of(both) * (1 - 1e-12);  // a deal that is this one is as unlike, however sums round
  std::mt19937_64 random(20);                           // std::shuffle differs between standard libraries
  constexpr long enough = 2000;                         // the p-value is known to 2 % then
  long as_unlike = 0;
  for (long deal = 1; deal <= deals; ++deal) {
    for (std::size_t k = both.of_first.size() - 1; k > 0; --k)
      std::swap(both.of_first[k], both.of_first[random() % (k + 1)]);
    as_unlike += unlikeness_of(both) >= found;
    if (as_unlike == enough) return static_cast<double>(as_unlike) / static_cast<double>(deal);
  }
  return static_cast<double>(as_unlike + 1) / static_cast<double>(deals + 1);
}

}  // namespace touchstone::vnv
