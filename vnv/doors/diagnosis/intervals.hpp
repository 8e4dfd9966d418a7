#pragma once
/// How far off a value may be that was fitted: by what is left of the error, and by all resolutions together.

#include "vnv/doors/diagnosis/seen.hpp"

#include <gsl/gsl_cdf.h>

namespace touchstone::vnv::doors::diagnosis {

/// The rest of an error as a field that is random: how strong its waves are, and how alike it is at two times.
class Rest {
 public:
  /// `fitted` are the columns that were fitted: they took their part of it away.
  Rest(const FieldVector& seen, const VectorXd& rest, const MatrixXd& fitted) : seen_(seen) {
    const auto times = static_cast<Index>(seen.moments().size());
    const Index count = static_cast<Index>(seen.waves().all.size());
    const std::vector<Part> found = parts_of(rest);
    between_ = MatrixXd::Zero(times, times);
    for (Index a = 0; a < times; ++a)
      for (Index b = 0; b < times; ++b) between_(a, b) = found[a].waves.cwiseProduct(found[b].waves).sum();
    short_ = VectorXd::Zero(times);
    double short_energy = 0, short_count = 0;
    for (Index a = 0; a < times; ++a) {
      const auto n = seen.components() * (seen.moments()[a].x.cols() - count);
      const double left = std::max(0.0, found[a].energy - between_(a, a));
      short_[a] = n > 0 ? left / static_cast<double>(n) : 0;
      short_energy += left;
      short_count += static_cast<double>(n);
    }
    const double trace = between_.trace(), independent = trace > 0 ? trace * trace / between_.squaredNorm() : 1;
    MatrixXd energy = MatrixXd::Zero(count, seen.components());
    for (const Part& one : found) energy += one.waves.cwiseAbs2();
    noise_ =
        std::min(short_energy / std::max(1.0, short_count), flat(energy / std::max(1.0, static_cast<double>(times))));
    energy = energy.cwiseQuotient(
        ((MatrixXd::Ones(count, seen.components()) - taken(fitted) / independent).cwiseMax(0.3)).eval());
    between_ *= trace > 0 ? energy.sum() / trace : 1;
    spectrum_ = smooth(energy);
    const double all = trace + short_energy;
    const double waves =
        all * all /
        (trace * trace * spectrum_.squaredNorm() + short_energy * short_energy / std::max(1.0, short_count));
    freedom_ = std::max(1.0, independent * waves - static_cast<double>(fitted.cols()));
  }

  /// Of the product of the rest with a vector.
  double variance(const VectorXd& vector) const {
    double sum = 0;
    const std::vector<Part> parts = parts_of(vector);
    for (Index a = 0; a < between_.rows(); ++a) {
      for (Index b = 0; b < between_.rows(); ++b)
        sum += between_(a, b) * spectrum_.cwiseProduct(parts[a].waves).cwiseProduct(parts[b].waves).sum();
      sum += short_[a] * std::max(0.0, parts[a].energy - parts[a].waves.squaredNorm());
    }
    return std::max(0.0, sum);
  }
  /// Student's t that is exceeded with this probability, to both sides together.
  double quantile(double probability) const { return gsl_cdf_tdist_Qinv(probability / 2, freedom_); }
  /// That of a 95 % interval. Half of the waves count, since the strength of one is found from its neighbours alone,
  /// and it is widened so that intervals of plants that were drawn before this was fixed (seed 6) held 95 % of them.
  double interval() const { return 1.2 * gsl_cdf_tdist_Qinv(0.025, std::max(1.0, freedom_ / 2)); }
  /// The mean square of a number that would be its share of an error without any waves: noise, which is as strong in
  /// all waves, in the long ones too; what is sharp along one axis only, as a layer is, is none.
  double noise() const { return noise_; }

 private:
  /// The mean of the energies of waves if they are those of noise, by their median: that of the square of a normal
  /// number is 0.455.
  static double flat(MatrixXd energy) {
    constexpr double mean_over_median = 1 / 0.455;
    const auto half = energy.data() + energy.size() / 2;
    std::nth_element(energy.data(), half, energy.data() + energy.size());
    return mean_over_median * *half;
  }

  /// Of the numbers of one time.
  struct Part {
    MatrixXd waves;  // a row a wave, a column a component
    double energy = 0;
  };
  std::vector<Part> parts_of(const VectorXd& numbers) const {
    std::vector<Part> all;
    seen_.each([&](const Moment& m, int component, Index first) {
      if (component == 0) all.push_back({MatrixXd(m.waves.cols(), seen_.components())});
      all.back().waves.col(component) = m.waves.transpose() * numbers.segment(first, m.x.cols());
      all.back().energy += numbers.segment(first, m.x.cols()).squaredNorm();
    });
    return all;
  }

  /// What of a wave of uniform strength a fit of these columns takes away.
  MatrixXd taken(const MatrixXd& columns) const {
    MatrixXd sum = MatrixXd::Zero(static_cast<Index>(seen_.waves().all.size()), seen_.components());
    if (columns.cols() == 0) return sum;
    const MatrixXd orthonormal =
        Eigen::HouseholderQR<MatrixXd>(columns).householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
    for (Index k = 0; k < columns.cols(); ++k)
      for (const Part& one : parts_of(orthonormal.col(k))) sum += one.waves.cwiseAbs2();
    return sum;
  }

  /// As a product of a spectrum along x and one along y, each a mean over neighbouring numbers of waves, and of the
  /// components: waves of one number are alike, and a fit may have taken any of them. A mean over a periodic axis has
  /// no neighbours: it may be all that there is, or nothing. The sum is 1.
  MatrixXd smooth(const MatrixXd& energy) const {
    const Harmonics& waves = seen_.waves();
    const double all = energy.sum();
    if (!(all > 0)) return MatrixXd::Zero(energy.rows(), energy.cols());
    std::array<VectorXd, 2> along;
    for (std::size_t k : {0u, 1u}) {
      const HarmonicsAlong& axis = waves.axes[k];
      VectorXd strength = VectorXd::Zero(axis.count), waves_of = strength;
      for (int i = 0; i < axis.count; ++i) ++waves_of[axis.number(i)];
      for (Index w = 0; w < energy.rows(); ++w) {
        const Harmonic& wave = waves.all[w];
        strength[axis.number(k == 0 ? wave.along_x : wave.along_y)] += energy.row(w).sum();
      }
      along[k].resize(axis.count);
      for (int i = 0; i < axis.count; ++i) {
        const int n = axis.number(i);
        double sum = 0, weights = 0;
        const bool is_mean = axis.periodic && n == 0;
        const int from = is_mean ? 0 : std::max(n - 1, axis.periodic ? 1 : 0), to = is_mean ? 0 : n + 1;
        for (int other = from; other <= to && other < axis.count; ++other) {
          const double weight = waves_of[other] * (other == n ? 2 : 1);
          if (waves_of[other] > 0) sum += weight * strength[other] / waves_of[other], weights += weight;
        }
        along[k][i] = std::max(strength[n] / waves_of[n], weights > 0 ? sum / weights : 0);
      }
    }
    MatrixXd product(energy.rows(), energy.cols());
    const Eigen::RowVectorXd of_components = energy.colwise().sum() / all;
    for (Index w = 0; w < energy.rows(); ++w) {
      const Harmonic& wave = waves.all[w];
      product.row(w) = along[0][wave.along_x] * along[1][wave.along_y] * of_components;
    }
    return product / product.sum();
  }

  const FieldVector& seen_;
  MatrixXd between_{}, spectrum_{};
  VectorXd short_{};
  double freedom_ = 1, noise_ = 0;
};

/// A value as the spacing goes to 0, and the half-width of its 95 % interval.
struct Extrapolated {
  double value, half_width;
};

/// As the spacing goes to 0: values v = v0 + a d + e of least squares, with d what discretisation may make at each
/// resolution. `a` is of the order of 1, 3 at most by a standard deviation, and e what is no square of the spacing, a
/// tenth of d. Where the values scatter more than that their own scatter counts (Birge, Phys. Rev. 40 (1932), 207-227).
struct Line {
  Extrapolated at_zero;
  double scatter;  // chi squared per degree of freedom
};
inline Line line_of(const VectorXd& value, const VectorXd& deviation, const VectorXd& made) {
  constexpr double most_of_order_two = 3, of_other_orders = 0.1, rounding = 1e-6, two_sided = 1.96;
  const VectorXd d = made / two_sided;
  MatrixXd covariance = std::pow(most_of_order_two, 2) * d * d.transpose();
  covariance.diagonal() += deviation.cwiseAbs2() + std::pow(of_other_orders, 2) * d.cwiseAbs2() +
                           rounding * rounding * value.cwiseAbs2() + VectorXd::Constant(value.size(), 1e-300);
  const Eigen::LDLT<MatrixXd> solver(covariance);
  const VectorXd ones = VectorXd::Ones(value.size()), weights = solver.solve(ones);
  const double precision = ones.dot(weights), v0 = weights.dot(value) / precision;
  const VectorXd off = value - v0 * ones;
  const double freedom = static_cast<double>(value.size() - 1), scatter = off.dot(solver.solve(off)) / freedom;
  const double wider = scatter > 1 ? gsl_cdf_tdist_Qinv(0.025, freedom) * std::sqrt(scatter) : two_sided;
  return {{v0, wider / std::sqrt(precision)}, scatter};
}

}  // namespace touchstone::vnv::doors::diagnosis
