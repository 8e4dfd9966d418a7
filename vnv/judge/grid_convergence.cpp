#include "vnv/judge/grid_convergence.hpp"

#include "vnv/judge/spacings.hpp"

#include <fmt/format.h>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Least squares of values ~ v0 + sum of a_k h^powers[k].
struct Fit {
  double at_zero, error;  // v0; of the finest value, estimated
  double miss;            // of the finest value, seen
  double scatter;         // standard deviation
  double order;
};

/// `freedom` is that of the scatter; the weights add up to the number of values.
Fit fit_powers(const ArrayXd& h, const ArrayXd& values, const ArrayXd& weights, const std::vector<double>& powers,
               Index freedom) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Ones(h.size(), static_cast<Index>(powers.size()) + 1);
  for (std::size_t k = 0; k < powers.size(); ++k) terms.col(static_cast<Index>(k) + 1) = h.pow(powers[k]);
  const Eigen::VectorXd root = weights.sqrt();
  const Eigen::VectorXd found =
      (root.asDiagonal() * terms).colPivHouseholderQr().solve(root.cwiseProduct(values.matrix()));
  const ArrayXd miss = values - (terms * found).array();
  return {.at_zero = found[0],
          .error = std::abs(terms.row(h.size() - 1).dot(found) - found[0]),
          .miss = std::abs(miss[h.size() - 1]),
          .scatter = std::sqrt((weights * miss.square()).sum() / static_cast<double>(freedom)),
          .order = powers.front()};
}

/// The order of least scatter: a scan, then the golden section about its best.
Fit fit_any_order(const ArrayXd& h, const ArrayXd& values, const ArrayXd& weights) {
  const auto fit = [&](double order) { return fit_powers(h, values, weights, {order}, h.size() - 3); };
  const auto scatter = [&](double order) { return fit(order).scatter; };
  constexpr double step = 0.05, lowest = 0.05, highest = 10;
  double best = lowest;
  for (double order = lowest; order <= highest; order += step)
    if (scatter(order) < scatter(best)) best = order;
  constexpr double golden = 0.6180339887498949;
  double low = std::max(best - step, lowest), high = best + step;
  while (high - low > 1e-9) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (scatter(left) < scatter(right) ? high : low) = scatter(left) < scatter(right) ? right : left;
  }
  return fit((low + high) / 2);
}

/// The fit whose terms can be believed, for one choice of weights.
Fit best_fit(const ArrayXd& h, const ArrayXd& values, const ArrayXd& weights) {
  const Fit any = fit_any_order(h, values, weights);
  if (any.order >= 0.5 && any.order <= 2) return any;
  std::vector<Fit> fixed = {fit_powers(h, values, weights, {1}, h.size() - 2),
                            fit_powers(h, values, weights, {2}, h.size() - 2)};
  if (any.order < 0.5) fixed.push_back(fit_powers(h, values, weights, {1, 2}, h.size() - 3));
  Fit best = *std::ranges::min_element(fixed, {}, &Fit::scatter);
  best.order = any.order;
  return best;
}

}  // namespace

GridConvergence grid_convergence(const std::array<double, 3>& spacings, const std::array<double, 3>& values) {
  require_falling("grid_convergence", spacings);
  const double coarse_ratio = spacings[0] / spacings[1], fine_ratio = spacings[1] / spacings[2];
  const double coarse_step = values[0] - values[1], fine_step = values[1] - values[2];
  const double steps = coarse_step / fine_step;
  if (!std::isfinite(steps) || steps == 0) return {};
  GridConvergence found{.oscillates = steps < 0};
  const double sign = steps < 0 ? -1 : 1;
  double order = 0, correction = 0;
  for (int turn = 0; turn < 100; ++turn) {
    const double before = order;
    order = std::abs(std::log(std::abs(steps)) + correction) / std::log(fine_ratio);
    correction = std::log((std::pow(fine_ratio, order) - sign) / (std::pow(coarse_ratio, order) - sign));
    if (!std::isfinite(correction)) correction = 0;  // order 0, from where no correction is known
    if (std::abs(order - before) < 1e-12) break;
  }
  const double gain = std::pow(fine_ratio, order) - 1;
  found.order = order;
  found.extrapolated = values[2] - fine_step / gain;
  found.index = 1.25 * std::abs(fine_step / values[2]) / gain;
  return found;
}

NumericalUncertainty numerical_uncertainty(const std::vector<double>& spacings, const std::vector<double>& values) {
  if (spacings.size() != values.size() || spacings.size() < 4)
    throw std::invalid_argument(
        fmt::format("numerical_uncertainty: {} spacings and {} values, expected equally many and at least 4",
                    spacings.size(), values.size()));
  require_falling("numerical_uncertainty", spacings);
  const ArrayXd h = Eigen::Map<const ArrayXd>(spacings.data(), std::ssize(spacings)) / spacings.back();
  const ArrayXd v = Eigen::Map<const ArrayXd>(values.data(), std::ssize(values));
  if (!v.allFinite()) return {};
  if (v.maxCoeff() == v.minCoeff()) return {.extrapolated = v[0], .uncertainty = 0, .scatter = 0};
  const double count = static_cast<double>(values.size());
  const Fit even = best_fit(h, v, ArrayXd::Ones(h.size())),
            fine = best_fit(h, v, h.inverse() * (count / h.inverse().sum()));
  const Fit& fit = even.scatter < fine.scatter ? even : fine;

  const double range = (v.maxCoeff() - v.minCoeff()) / (count - 1);
  const bool is_smooth = fit.scatter < range, is_good = is_smooth && fit.order >= 0.5 && fit.order < 2.1;
  NumericalUncertainty found{.extrapolated = fit.at_zero, .order = fit.order, .scatter = fit.scatter};
  found.safety = is_good ? 1.25 : 3;
  found.uncertainty = is_smooth ? found.safety * fit.error + fit.scatter + fit.miss
                                : 3 * fit.scatter / range * (fit.error + fit.scatter + fit.miss);
  return found;
}

}  // namespace touchstone::vnv
