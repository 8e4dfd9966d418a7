#pragma once
/// Fits of causes to an error, one by one or two at once.

#include "vnv/doors/diagnosis/intervals.hpp"

namespace touchstone::vnv::doors::diagnosis {

constexpr double sufficient = 0.8;  // share of the squared error

constexpr bool is_of_wall(Cause cause) { return cause >= Cause::floor && cause <= Cause::slip; }

/// Causes that were fitted at once.
struct Fit {
  std::vector<Cause> causes;
  Changes by{};
  VectorXd value{}, deviation{};          // standard deviation
  VectorXd discretised{};                 // half-width of what discretisation may make of it
  VectorXd half_width{};                  // 95 %, both together
  std::vector<Extrapolated> vanishing{};  // as the spacing goes to 0, where several resolutions tell
  bool in_metres = false;                 // of a wall: it is off by that length, not by a part of the spacing
  VectorXd rest{};
  MatrixXd columns{};
  double share = 0;
  double noise = 0;  // share of what would be left if it explained all but noise
  double level = 0;  // quantile of Student's t
  bool possible = true;

  /// Whether each value differs from zero by so many deviations.
  bool differs_by(double quantile) const {
    return possible && (value.cwiseAbs().array() > quantile * deviation.array()).all();
  }
  /// The share of that of the squared error which is no noise.
  double net() const { return share / std::max(1 - noise, 0.05); }
  bool suffices() const {
    constexpr double least = 0.1;  // beside noise
    return net() >= sufficient && share >= least && differs_by(level);
  }
  /// Whether it is more than its interval, so that it may be offered.
  bool stands() const {
    return possible && (value.cwiseAbs().array() > half_width.array()).all() &&
           std::ranges::all_of(vanishing, [](const Extrapolated& e) { return std::abs(e.value) > e.half_width; });
  }
};

inline std::vector<Cause> causes_of(const Exact& exact) {
  std::vector<Cause> causes = exact.causes;
  causes.push_back(Cause::amplitude);
  if (exact.field != "pressure" || !exact.less_mean) causes.push_back(Cause::lead);
  if (!exact.less_mean) causes.push_back(Cause::mean_x);
  if (exact.components == 2) causes.push_back(Cause::mean_y);
  return causes;
}

/// Fits causes to what is seen at one resolution.
class Fitter {
 public:
  /// `discretisation` as of diagnose().
  Fitter(const Exact& exact, FieldVector seen, const Domain& domain, double spacing, double discretisation,
         std::vector<FieldVector> others = {})
      : exact_(exact),
        seen_(std::move(seen)),
        others_(std::move(others)),
        domain_(domain),
        spacing_(spacing),
        discretisation_(discretisation),
        causes_(causes_of(exact)) {
    if (is_enough() && has_error()) take_modes();
  }

  double spacing() const { return spacing_; }

 protected:
  static constexpr double as_exact = 1e-4;  // %

  double squared() const { return seen_.squared_error(); }
  bool has_error() const { return !seen_.empty() && 100 * std::sqrt(squared() / seen_.times()) > as_exact; }
  bool is_enough() const {
    constexpr Index least = 40;  // so that ten waves are found beside what is left
    return seen_.error().size() >= least;
  }

  /// Gauss and Newton's steps, halved where they do not lessen the error.
  Fit fitted(const std::vector<Cause>& causes, double tried) const {
    Fit fit{.causes = causes};
    const auto count = static_cast<Index>(causes.size());
    fit.value = fit.deviation = fit.discretised = fit.half_width = VectorXd::Zero(count);
    fit.rest = seen_.error();
    const auto changes = [&](const VectorXd& value) {
      Changes by;
      for (Index k = 0; k < count; ++k) by(causes[k]) = value[k];
      return by;
    };
    const auto take_slopes = [&] {
      fit.columns.resize(fit.rest.size(), count);
      for (Index k = 0; k < count; ++k) fit.columns.col(k) = slope(fit.by, causes[k], fit.rest);
      fit.possible = fit.columns.allFinite() && (fit.columns.colwise().squaredNorm().array() > 0).all();
      return fit.possible;
    };
    if (exact_.period > 0 && causes == std::vector{Cause::lead})  // from the nearest quarter on: a slope may be zero
      for (const double quarters : {-1, 1, 2}) {
        const VectorXd there = VectorXd::Constant(1, quarters * exact_.period / 4), rest = seen_.error(changes(there));
        if (rest.squaredNorm() < fit.rest.squaredNorm()) fit.value = there, fit.by = changes(there), fit.rest = rest;
      }
    if (!take_slopes()) return fit;
    constexpr int most_steps = 16;
    for (int step = 0; step < most_steps; ++step) {
      VectorXd by = pseudo_inverse(fit.columns) * fit.rest;
      for (Index k = 0; k < count; ++k) by[k] = allowed(causes[k], fit.value[k], by[k], count == 1);
      const double before = fit.rest.squaredNorm();
      int halved = 0;
      VectorXd rest = seen_.error(changes(fit.value + by));
      for (; halved < 4 && !(rest.squaredNorm() < before); ++halved)
        by /= 2, rest = seen_.error(changes(fit.value + by));
      if (halved == 4) break;
      fit.value += by;
      fit.by = changes(fit.value);
      fit.rest = rest;
      if (!take_slopes()) return fit;
      if (rest.squaredNorm() > (1 - 1e-4) * before) break;
    }
    fit.share = 1 - fit.rest.squaredNorm() / squared();
    for (Index k = 0; k < count; ++k)  // fluid does not slip by a negative length
      fit.possible &= causes[k] != Cause::slip || fit.value[k] > 0;
    estimate_spread(fit, tried);
    return fit;
  }

  /// Two causes at once, of those pairs that explain most by the slopes at the fits of one.
  std::vector<Fit> likely_pairs() const {
    struct Pair {
      std::size_t a, b;
      double left;
    };
    std::vector<Pair> all;
    const VectorXd& error = seen_.error();
    std::vector<VectorXd> slopes;
    for (const Cause cause : causes_) slopes.push_back(slope({}, cause, error).normalized());
    for (std::size_t a = 0; a < slopes.size(); ++a)
      for (std::size_t b = a + 1; b < slopes.size(); ++b) {
        const VectorXd &first = slopes[a], &second = slopes[b];
        const double alike = first.dot(second), p = first.dot(error), q = second.dot(error);
        if (!(std::abs(alike) <= 0.995) || !(first.squaredNorm() > 0 && second.squaredNorm() > 0)) continue;
        all.push_back({a, b, error.squaredNorm() - (p * p + q * q - 2 * alike * p * q) / (1 - alike * alike)});
      }
    std::ranges::sort(all, {}, &Pair::left);
    std::vector<Fit> fits;
    constexpr std::size_t most_pairs = 6;
    for (std::size_t k = 0; k < std::min(all.size(), most_pairs); ++k)
      fits.push_back(fitted({causes_[all[k].a], causes_[all[k].b]}, static_cast<double>(all.size())));
    return fits;
  }

  /// Whether a cause adds to a fit what is no accident, nor what discretisation may make.
  bool adds(const Fit& fit, Cause cause) const {
    constexpr double all_of_it = 1 - 1e-9;  // rounding is left
    if (fit.share > all_of_it) return false;
    VectorXd column = slope(fit.by, cause, fit.rest);
    const double before = column.norm();
    column -= fit.columns * (pseudo_inverse(fit.columns) * column).eval();
    if (!(column.norm() > 1e-3 * before)) return false;  // the same column
    const double value = column.dot(fit.rest) / column.squaredNorm();
    MatrixXd both(fit.columns.rows(), fit.columns.cols() + 1);
    both << fit.columns, column;
    const Rest rest(seen_, fit.rest - value * column, both);
    double made = 0;
    if (modes_.cols() > 0) made = (column.transpose() * modes_).norm() / column.squaredNorm();
    return std::abs(value) >
           std::hypot(rest.quantile(0.01) * std::sqrt(rest.variance(column / column.squaredNorm())), made);
  }

  /// Whether the other fields of the flow do not speak against what is wrong with it: with the least of it that its
  /// interval holds they would be twice as wrong, or more, as they are.
  bool others_allow(const Fit& fit) const {
    return std::ranges::all_of(others_, [&](const FieldVector& other) {
      Changes by;
      for (std::size_t k = 0; k < fit.causes.size(); ++k) {
        const double value = fit.value[k], wide = fit.half_width[k];
        if (other.knows(fit.causes[k])) by(fit.causes[k]) = std::copysign(std::max(0.0, std::abs(value) - wide), value);
      }
      return other.allows(other.error(by));
    });
  }
  bool others_allow(const Mistake& mistake) const {
    if (!mistake.of_time && mistake.cause != "shifted") return true;  // of a field by itself
    return std::ranges::all_of(
        others_, [&](const FieldVector& other) { return other.allows(other.numbers() - other.exact_with(mistake)); });
  }

  /// Whether a fit is of what goes with the spacing: the whole error is of the size that discretisation may make, or
  /// the value is known to be less at vanishing spacing.
  bool is_discretisation(const Fit& fit) const {
    if (!fit.suffices() || fit.stands()) return false;
    constexpr double of_that_size = 4;  // of squares
    return squared() <= of_that_size * modes_.squaredNorm() ||
           std::ranges::any_of(fit.vanishing, [&](const Extrapolated& e) {
             return std::abs(e.value) + e.half_width < std::abs(fit.value[0]);
           });
  }

  const Exact& exact_;
  FieldVector seen_;
  std::vector<FieldVector> others_;
  const Domain& domain_;
  double spacing_, discretisation_;
  std::vector<Cause> causes_;

 private:
  /// What the discretisation of a method of second order makes of the flow. It adds h² times fourth derivatives to an
  /// equation (its modified one: Warming & Hyett, J. Comput. Phys. 14 (1974), 159-179), where another viscosity adds
  /// second ones; since such operators commute, the error is h² times the Laplacian of the slope with viscosity. A
  /// shear wave's is another viscosity itself, that of a steady parabola a velocity added everywhere, as mirrored cells
  /// at plates make it.
  void take_modes() {
    if (!(discretisation_ > 0)) return;
    std::vector<VectorXd> all;
    const auto add = [&](Cause cause, double step, double norm) {
      const double h2 = spacing_ * spacing_;
      VectorXd mode = discretisation_ * h2 * seen_.laplacian_of_slope(cause, step, spacing_ / 2);
      if (const double most = discretisation_ * norm; mode.norm() > most) mode *= most / mode.norm();
      if (mode.allFinite()) all.push_back(std::move(mode));
    };
    for (const Cause cause : exact_.causes)
      if (cause == Cause::viscosity || cause == Cause::gravity || cause == Cause::sound_speed)
        add(cause, 1e-4, slope({}, cause, seen_.error()).norm());
    if (all.empty()) add(Cause::amplitude, 0, seen_.exact().norm());
    modes_.resize(seen_.error().size(), static_cast<Index>(all.size()));
    for (std::size_t k = 0; k < all.size(); ++k) modes_.col(k) = all[k];
  }

  VectorXd slope(const Changes& by, Cause cause, const VectorXd& error_there) const {
    const double larger = cause <= Cause::sound_speed ? std::max(1.0, 1 + by(cause)) : 1;
    return seen_.slope(by, cause, 1e-4 * larger * unit(cause), error_there);
  }

  /// A natural step: a whole of a fraction, a spacing, the time of the run.
  double unit(Cause cause) const {
    if (is_of_wall(cause)) return spacing_;
    if (cause == Cause::lead) return exact_.period > 0 ? exact_.period / 4 : seen_.longest();
    return 1;
  }

  /// A step that is not too long for a slope. Viscosity, the speed of sound and parameters of formulas are multiplied,
  /// so that a thousandth and a thousand times the right one are as near. To what a field is proportional, or is added
  /// to it, any step leads if nothing else is fitted.
  double allowed(Cause cause, double value, double step, bool alone) const {
    if (cause == Cause::viscosity || cause == Cause::sound_speed || cause >= Cause::parameter)
      return (1 + value) * std::expm1(std::clamp(step / (1 + value), -1.0, 1.0));
    const bool is_linear = cause <= Cause::gravity || cause >= Cause::amplitude;
    const double most = is_linear && alone ? HUGE_VAL : unit(cause) * (unit(cause) == spacing_ ? 2 : 0.5);
    return std::max(std::clamp(step, -most, most), cause <= Cause::gravity ? -0.999 - value : -HUGE_VAL);
  }

  /// Of one or two columns: the matrix that makes the least squares' values of a vector.
  static MatrixXd pseudo_inverse(const MatrixXd& columns) {
    return (columns.transpose() * columns).ldlt().solve(columns.transpose());
  }

  void estimate_spread(Fit& fit, double tried) const {
    const Rest rest(seen_, fit.rest, fit.columns);
    const MatrixXd inverse = pseudo_inverse(fit.columns);
    for (Index k = 0; k < inverse.rows(); ++k) fit.deviation[k] = std::sqrt(rest.variance(inverse.row(k).transpose()));
    const double slower = std::min(1.0, seen_.numbers().norm() / seen_.exact().norm());  // and its errors with it
    if (modes_.cols() > 0) fit.discretised = slower * (inverse * modes_).rowwise().norm();
    fit.half_width = ((rest.interval() * fit.deviation).cwiseAbs2() + fit.discretised.cwiseAbs2()).cwiseSqrt();
    fit.level = rest.quantile(0.05 / tried);
    fit.noise = std::min(1.0, rest.noise() * static_cast<double>(fit.rest.size()) / squared());
    fit.possible &= fit.value.allFinite() && fit.half_width.allFinite() && std::isfinite(fit.share);
    fit.possible = fit.possible && others_allow(fit);
  }

  MatrixXd modes_{};
};

}  // namespace touchstone::vnv::doors::diagnosis
