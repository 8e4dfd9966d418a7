#pragma once
/// Samples of one number, and whether two of them are of one distribution.

#include <vector>

namespace touchstone::vnv {

/// The value that a fraction of a sample does not exceed, linear between its members (Hyndman & Fan 1996, type 7).
/// Throws std::invalid_argument for an empty sample or a fraction outside [0, 1].
double quantile(std::vector<double> sample, double fraction);

/// The Wasserstein distance of first order between two samples, in their unit: what has to be moved, and how far, to
/// make one of the other. Not a number if one of them is empty or holds what is not finite.
double wasserstein_distance(const std::vector<double>& a, const std::vector<double>& b);

/// Whether the median of an ensemble lies within what an experiment shows over its repeats, such as its percentiles
/// 2.5 % and 97.5 %, edges included. Never for an ensemble that is empty or holds what is not finite.
bool median_is_inside(const std::vector<double>& members, double low, double high);

/// The comparison error E of a median and its standard uncertainty u_val (ASME V&V 20, 2009), in their unit: by the
/// standard errors of both medians, sqrt(pi / 2) deviations over the root of how many there are, as of normal
/// distributions.
struct MedianComparison {
  double error, uncertainty;

  /// Beyond 2 u_val the model is off by E ± 2 u_val.
  bool shows_model_error() const;
};

/// An ensemble beside repeats of which median, deviation and number are known. The uncertainty of fewer than two
/// members is infinite.
MedianComparison compare_median(const std::vector<double>& members, double median, double deviation, double repeats);

/// How unlike a sample is to a distribution of which only quantiles are known.
struct AgainstQuantiles {
  double distance;  // -  the largest difference of the distribution functions at the quantiles: of Kolmogorov & Smirnov
                    //    at the least
  double p_value;   // -  how often a sample of this size from that distribution is at least as far, exactly
};

/// `quantiles` are the values that the fractions `of` do not exceed, both rising: percentiles over the repeats of an
/// experiment, taken as exact. Members are independent. Both numbers are none for a sample that is empty or holds what
/// is not finite. Throws std::invalid_argument unless there are as many quantiles as fractions, rising, the latter
/// between 0 and 1.
AgainstQuantiles against_quantiles(const std::vector<double>& sample, const std::vector<double>& quantiles,
                                   const std::vector<double>& of);

/// How often two samples of one distribution are at least as unlike, in place or in spread: by the statistic of
/// Anderson & Darling (Pettitt, Biometrika 63 (1976), 161), the fraction of random ways to deal all values to two
/// samples of these sizes, never 0 (Phipson & Smyth, Stat. Appl. Genet. Mol. Biol. 9 (2010), 39), of no more ways than
/// give 2000 as unlike (Besag & Clifford, Biometrika 78 (1991), 301). The same for the same samples. 0 where a sample
/// is empty or holds what is not finite. Members are to be independent: repeats, not successive times of one series.
double p_value(const std::vector<double>& a, const std::vector<double>& b, long deals = 100'000);

}  // namespace touchstone::vnv
