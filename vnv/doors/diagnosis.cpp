#include "vnv/doors/diagnosis.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace touchstone::vnv::doors {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double sufficient = 0.8;  // share of the squared error

/// How a cause is said: with its value, whose sign chooses the words.
struct Phrases {
  std::string_view name, unit, where_positive, where_negative;
};
constexpr Phrases phrases_of(Cause cause, bool is_pressure) {
  switch (cause) {
    case Cause::viscosity:
      return {"viscosity", "%", "the flow is that of a fluid {} too viscous",
              "the flow is that of a fluid {} less viscous than it should be"};
    case Cause::force:
      return {"force", "%", "the flow is that of a body force {} too strong",
              "the flow is that of a body force {} too weak"};
    case Cause::gravity:
      return {"gravity", "%", "gravity is {} too strong", "gravity is {} too weak"};
    case Cause::sound_speed:
      return {"sound speed", "%", "the speed of sound is {} too high", "the speed of sound is {} too low"};
    case Cause::floor:
      return {"lower wall", "spacings", "the lower wall stands {} too far out", "the lower wall stands {} too far in"};
    case Cause::ceiling:
      return {"upper wall", "spacings", "the upper wall stands {} too far out", "the upper wall stands {} too far in"};
    case Cause::walls:
      return {"both walls", "spacings", "both walls stand {} too far out", "both walls stand {} too far in"};
    case Cause::slip:
      return {"slip length", "spacings", "the fluid slips along its walls with a slip length of {}", ""};
    case Cause::lead:
      return {"time", "s", "the flow is {} ahead", "the flow is {} late"};
    case Cause::amplitude:
      return is_pressure ? Phrases{"amplitude", "%", "the pressure is {} too large", "the pressure is {} too small"}
                         : Phrases{"amplitude", "%", "the velocity is {} too large", "the velocity is {} too small"};
    case Cause::mean_x:
      return is_pressure
                 ? Phrases{"mean", "%", "a pressure of {} of its root mean square is added everywhere",
                           "a pressure of {} of its root mean square is missing everywhere"}
                 : Phrases{"mean along x", "%", "a mean velocity of {} of the root mean square is added along x",
                           "a mean velocity of {} of the root mean square is added against x"};
    case Cause::mean_y:
      return {"mean along y", "%", "a mean velocity of {} of the root mean square is added along y",
              "a mean velocity of {} of the root mean square is added against y"};
  }
  return {};
}

/// Fluid does not slip by a negative length.
bool is_possible(Cause cause, double value) { return cause != Cause::slip || value > 0; }

std::vector<Cause> causes_of(const Exact& exact) {
  std::vector<Cause> causes = exact.causes;
  causes.push_back(Cause::amplitude);
  if (exact.field != "pressure" || !exact.less_mean) causes.push_back(Cause::lead);
  if (!exact.less_mean) causes.push_back(Cause::mean_x);
  if (exact.components == 2) causes.push_back(Cause::mean_y);
  return causes;
}

/// Harmonics along one axis of a box, by their number: cosines between walls, and sines too where it is periodic.
struct Axis {
  double low, length;
  bool periodic;
  int count;

  int number(int i) const { return periodic ? (i + 1) / 2 : i; }
  double wave(int i, double x) const {
    const double phase = number(i) * (periodic ? 2 : 1) * std::numbers::pi * (x - low) / length;
    return i == 0 ? 1 : std::numbers::sqrt2 * (periodic && i % 2 == 0 ? std::sin(phase) : std::cos(phase));
  }
};

struct Harmonic {
  int along_x, along_y;  // indices on the axes
};

/// Those of both axes, the longest first; at most a quarter as many as there are samples.
struct Harmonics {
  std::array<Axis, 2> axes;
  std::vector<Harmonic> all{};

  Harmonics(const Domain& domain, Index samples) {
    for (const int i : {0, 1}) {
      const std::size_t k = static_cast<std::size_t>(i);
      axes[k] = {domain.box.low[i], domain.box.size()[i], domain.periodic(i), domain.periodic(i) ? 7 : 16};
    }
    while (axes[0].count * axes[1].count > std::max<Index>(1, samples / 4))
      (axes[0].count > axes[1].count ? axes[0] : axes[1]).count -= 1;
    for (int i = 0; i < axes[0].count; ++i)
      for (int j = 0; j < axes[1].count; ++j) all.push_back({i, j});
    std::ranges::stable_sort(all, {},
                             [&](const Harmonic& w) { return axes[0].number(w.along_x) + axes[1].number(w.along_y); });
  }
  double at(const Harmonic& wave, const Vec2& x) const {
    return axes[0].wave(wave.along_x, x.x()) * axes[1].wave(wave.along_y, x.y());
  }
};

/// Some of the samples at a time, with weights whose squares sum to 1 over the square of the exact field's norm.
struct Moment {
  double time;
  Vectors x{}, v{};  // of the second, pressures are along x
  VectorXd weight{};
  MatrixXd waves{};  // orthonormal columns
};

/// So many different numbers below n, spread evenly over them in any part of the order: multiples of its golden
/// section.
std::vector<Index> spread(Index n, Index most) {
  std::vector<Index> chosen(static_cast<std::size_t>(std::min(n, most)));
  Index step = n <= most ? 1 : std::lround(static_cast<double>(n) / std::numbers::phi);
  while (n > 0 && std::gcd(step, n) != 1) ++step;
  for (std::size_t k = 1; k < chosen.size(); ++k) chosen[k] = (chosen[k - 1] + step) % n;
  return chosen;
}

/// The samples of a field, as one vector of weighted numbers: for each time and each component all its samples.
class Seen {
 public:
  Seen(const Exact& exact, const std::vector<const Samples*>& samples, const Domain& domain)
      : exact_(exact), waves_(domain, samples.empty() ? 0 : std::min<Index>(samples[0]->size(), most_samples)) {
    const auto count = static_cast<Index>(samples.size());
    for (const Index k : spread(count, most_times)) add(*samples[static_cast<std::size_t>(count - 1 - k)]);
    for (const Moment& moment : moments_) size_ += components() * moment.x.cols();
    error_ = VectorXd::Zero(size_);
    VectorXd numbers(size_);
    each([&](const Moment& m, int component, Index first) {
      numbers.segment(first, m.x.cols()) = m.v.row(component).transpose().cwiseProduct(m.weight);
    });
    seen_ = numbers;
    take_off_means(seen_);
    error_ = seen_ - of({});
  }

  bool empty() const { return moments_.empty(); }
  double times() const { return static_cast<double>(moments_.size()); }
  int components() const { return exact_.components; }
  const std::vector<Moment>& moments() const { return moments_; }
  const Harmonics& waves() const { return waves_; }
  const VectorXd& error() const { return error_; }
  VectorXd error(const Changes& by) const { return seen_ - of(by); }
  double longest() const { return moments_.empty() ? 0 : std::ranges::max(moments_, {}, &Moment::time).time; }

  /// The slope of the flow with a cause, where something is wrong already, by a small step of it.
  VectorXd slope(const Changes& by, Cause cause, double step, const VectorXd& error_there) const {
    Changes more = by;
    more(cause) += step;
    return (error_there - error(more)) / step;
  }

  /// work(moment, component, the first of its numbers)
  void each(const auto& work) const {
    Index first = 0;
    for (const Moment& m : moments_)
      for (int component = 0; component < components(); ++component, first += m.x.cols()) work(m, component, first);
  }

 private:
  static constexpr Index most_samples = 1500, most_times = 6;

  /// A time at which the exact field is nothing has no relative error and is left out.
  void add(const Samples& all) {
    Moment m{.time = all.time};
    const std::vector<Index> chosen = spread(all.size(), most_samples);
    m.x = all.x(Eigen::all, chosen);
    if (exact_.field == "pressure") {
      m.v = Vectors::Zero(2, m.x.cols());
      m.v.row(0) = all.pressure(chosen).matrix().transpose();
    } else {
      m.v = all.v(Eigen::all, chosen);
    }
    const VectorXd volumes = all.volumes()(chosen);
    m.weight = (volumes / volumes.sum()).cwiseSqrt();
    const FieldTruth truth = exact_.with({});
    Vectors right(2, m.x.cols());
    for (Index p = 0; p < m.x.cols(); ++p) right.col(p) = truth(m.x.col(p), m.time);
    if (exact_.less_mean) right.colwise() -= (right * m.weight.cwiseAbs2()).eval();
    const double norm = (right * m.weight.asDiagonal()).norm();
    if (!(norm > 0)) return;
    MatrixXd waves(m.x.cols(), waves_.all.size());
    for (Index p = 0; p < waves.rows(); ++p)
      for (Index w = 0; w < waves.cols(); ++w)
        waves(p, w) = m.weight[p] * waves_.at(waves_.all[static_cast<std::size_t>(w)], m.x.col(p));
    const Eigen::HouseholderQR<MatrixXd> orthonormal(waves);
    m.waves = orthonormal.householderQ() * MatrixXd::Identity(waves.rows(), waves.cols());
    m.weight /= norm;
    moments_.push_back(std::move(m));
  }

  VectorXd of(const Changes& by) const {
    VectorXd numbers(size_);
    const FieldTruth truth = exact_.with(by);
    const double larger = 1 + by(Cause::amplitude);
    Index first = 0;
    for (const Moment& m : moments_) {
      const double time = std::max(0.0, m.time + by(Cause::lead)), norm = 1 / std::sqrt(m.weight.squaredNorm());
      const Vec2 mean = norm * Vec2(by(Cause::mean_x), by(Cause::mean_y));
      const Index n = m.x.cols();
      for (Index p = 0; p < n; ++p) {
        const Vec2 v = larger * truth(m.x.col(p), time) + mean;
        for (int component = 0; component < components(); ++component)
          numbers[first + component * n + p] = m.weight[p] * v[component];
      }
      first += components() * n;
    }
    take_off_means(numbers);
    return numbers;
  }

  void take_off_means(VectorXd& numbers) const {
    if (!exact_.less_mean) return;
    each([&](const Moment& m, int, Index first) {
      auto part = numbers.segment(first, m.x.cols());
      part -= m.weight * (m.weight.dot(part) / m.weight.squaredNorm());
    });
  }

  const Exact& exact_;
  Harmonics waves_;
  std::vector<Moment> moments_{};
  Index size_ = 0;
  VectorXd seen_{}, error_{};
};

/// The rest of an error as a field that is random: how strong its waves are, and how alike it is at two times.
class Rest {
 public:
  /// `fitted` are the columns that were fitted: they took their part of it away.
  Rest(const Seen& seen, const VectorXd& rest, const MatrixXd& fitted) : seen_(seen) {
    const auto times = static_cast<Index>(seen.moments().size());
    const Index count = static_cast<Index>(seen.waves().all.size());
    const std::vector<MatrixXd> found = amplitudes(rest);
    between_ = MatrixXd::Zero(times, times);
    for (Index a = 0; a < times; ++a)
      for (Index b = 0; b < times; ++b) between_(a, b) = at(found, a).cwiseProduct(at(found, b)).sum();
    short_ = VectorXd::Zero(times);
    double short_energy = 0, short_count = 0;
    for (Index a = 0; a < times; ++a) {
      const auto n = seen.components() * (seen.moments()[static_cast<std::size_t>(a)].x.cols() - count);
      const double left = std::max(0.0, energies_[static_cast<std::size_t>(a)] - between_(a, a));
      short_[a] = n > 0 ? left / static_cast<double>(n) : 0;
      short_energy += left;
      short_count += static_cast<double>(n);
    }
    const double trace = between_.trace(), independent = trace > 0 ? trace * trace / between_.squaredNorm() : 1;
    MatrixXd energy = MatrixXd::Zero(count, seen.components());
    for (const MatrixXd& one : found) energy += one.cwiseAbs2();
    energy = energy.cwiseQuotient(
        ((MatrixXd::Ones(count, seen.components()) - taken(fitted) / independent).cwiseMax(0.3)).eval());
    between_ *= trace > 0 ? energy.sum() / trace : 1;
    spectrum_ = smooth(energy);
    const double all = trace + short_energy;
    const double waves =
        all * all /
        (trace * trace * spectrum_.squaredNorm() + short_energy * short_energy / std::max(1.0, short_count));
    freedom_ = std::max(1.0, independent * waves - static_cast<double>(fitted.cols()));
    noise_ = short_energy / std::max(1.0, short_count);
  }

  /// Of the product of the rest with a vector.
  double variance(const VectorXd& vector) const {
    double sum = 0;
    const std::vector<MatrixXd> parts = amplitudes(vector);
    for (Index a = 0; a < between_.rows(); ++a) {
      for (Index b = 0; b < between_.rows(); ++b)
        sum += between_(a, b) * spectrum_.cwiseProduct(at(parts, a)).cwiseProduct(at(parts, b)).sum();
      sum += short_[a] * std::max(0.0, energies_[static_cast<std::size_t>(a)] - at(parts, a).squaredNorm());
    }
    return std::max(0.0, sum);
  }
  /// Student's t that is exceeded with this probability, to both sides together.
  double quantile(double probability) const { return gsl_cdf_tdist_Qinv(probability / 2, freedom_); }
  /// That of a 95 % interval. Half of the waves count, since the strength of one is found from its neighbours alone,
  /// and it is widened so that intervals of plants that were drawn before this was fixed (seed 6) held 95 % of them.
  double interval() const { return 1.2 * gsl_cdf_tdist_Qinv(0.025, std::max(1.0, freedom_ / 2)); }
  /// The mean square of a number that would be its share of an error without any waves: noise.
  double noise() const { return noise_; }

 private:
  static const MatrixXd& at(const std::vector<MatrixXd>& all, Index i) { return all[static_cast<std::size_t>(i)]; }

  /// Of each time: a row a wave, a column a component.
  std::vector<MatrixXd> amplitudes(const VectorXd& numbers) const {
    std::vector<MatrixXd> all;
    energies_.clear();
    seen_.each([&](const Moment& m, int component, Index first) {
      if (component == 0) all.emplace_back(m.waves.cols(), seen_.components()), energies_.push_back(0);
      all.back().col(component) = m.waves.transpose() * numbers.segment(first, m.x.cols());
      energies_.back() += numbers.segment(first, m.x.cols()).squaredNorm();
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
      for (const MatrixXd& one : amplitudes(orthonormal.col(k))) sum += one.cwiseAbs2();
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
      const Axis& axis = waves.axes[k];
      VectorXd strength = VectorXd::Zero(axis.count), waves_of = strength;
      for (int i = 0; i < axis.count; ++i) ++waves_of[axis.number(i)];
      for (Index w = 0; w < energy.rows(); ++w) {
        const Harmonic& wave = waves.all[static_cast<std::size_t>(w)];
        strength[axis.number(k == 0 ? wave.along_x : wave.along_y)] += energy.row(w).sum();
      }
      along[k].resize(axis.count);
      for (int i = 0; i < axis.count; ++i) {
        const int n = axis.number(i);
        double sum = 0, weights = 0;
        for (int other = std::max(n - 1, axis.periodic ? 1 : 0); other <= n + 1 && other < axis.count; ++other) {
          if (axis.periodic && n == 0) other = 0;
          const double weight = waves_of[other] * (other == n ? 2 : 1);
          if (waves_of[other] > 0) sum += weight * strength[other] / waves_of[other], weights += weight;
          if (axis.periodic && n == 0) break;
        }
        along[k][i] = std::max(strength[n] / waves_of[n], weights > 0 ? sum / weights : 0);
      }
    }
    MatrixXd product(energy.rows(), energy.cols());
    const Eigen::RowVectorXd of_components = energy.colwise().sum() / all;
    for (Index w = 0; w < energy.rows(); ++w) {
      const Harmonic& wave = waves.all[static_cast<std::size_t>(w)];
      product.row(w) = along[0][wave.along_x] * along[1][wave.along_y] * of_components;
    }
    return product / product.sum();
  }

  const Seen& seen_;
  mutable std::vector<double> energies_{};
  MatrixXd between_{}, spectrum_{};
  VectorXd short_{};
  double freedom_ = 1, noise_ = 0;
};

/// Causes that were fitted at once.
struct Fit {
  std::vector<Cause> causes;
  Changes by{};
  VectorXd value{}, deviation{};  // standard deviation
  VectorXd rest{};
  MatrixXd columns{};
  double share = 0;
  double interval = 0, level = 0;  // quantiles of Student's t
  bool possible = true;

  /// Whether each value differs from zero by so many deviations.
  bool differs_by(double quantile) const {
    return possible && (value.cwiseAbs().array() > quantile * deviation.array()).all();
  }
  bool suffices() const { return share >= sufficient && differs_by(level); }
};

class Diagnostician {
 public:
  Diagnostician(const Exact& exact, const Seen& seen, double spacing)
      : exact_(exact), seen_(seen), spacing_(spacing), causes_(causes_of(exact)) {}

  Diagnosis diagnosis() const {
    Diagnosis all{.field = exact_.field};
    const double squared = seen_.error().squaredNorm();
    all.error = 100 * std::sqrt(squared / seen_.times());
    if (!(all.error > as_exact)) {
      all.sentence = fmt::format("the {} has no error to speak of", exact_.field);
      return all;
    }
    std::vector<Fit> fits;
    for (const Cause cause : causes_) fits.push_back(fitted({cause}, 1));
    std::vector<bool> named = name(fits);
    const Explanation noise = as_noise();
    const double by_one = best_share(fits, named);
    const bool is_noise = by_one == 0 && noise.share >= sufficient;
    if (by_one < one_is_enough && !is_noise) {
      std::vector<Fit> pairs = likely_pairs(fits);
      std::vector<bool> of_pairs = name(pairs);
      if (const double by_two = best_share(pairs, of_pairs); 1 - by_two < (1 - by_one) / 10 || by_one == 0)
        named.assign(fits.size(), false);
      else
        of_pairs.assign(pairs.size(), false);
      fits.insert(fits.end(), pairs.begin(), pairs.end());
      named.insert(named.end(), of_pairs.begin(), of_pairs.end());
    }
    for (std::size_t k = 0; k < fits.size(); ++k) all.explanations.push_back(explanation(fits[k], named[k]));
    all.explanations.push_back(noise);
    all.explanations.back().named = is_noise;
    std::ranges::stable_sort(all.explanations, std::greater{},
                             [](const Explanation& e) { return std::pair(e.named, e.share); });
    all.sentence = in_words(all);
    return all;
  }

 private:
  static constexpr double as_exact = 1e-4;       // %
  static constexpr double one_is_enough = 0.98;  // share of the squared error; else two, if they leave a tenth

  static double best_share(const std::vector<Fit>& fits, const std::vector<bool>& named) {
    double best = 0;
    for (std::size_t k = 0; k < fits.size(); ++k)
      if (named[k]) best = std::max(best, fits[k].share);
    return best;
  }

  /// A natural step: a whole of a fraction, a spacing, the time of the run.
  double unit(Cause cause) const {
    switch (cause) {
      case Cause::floor:
      case Cause::ceiling:
      case Cause::walls:
      case Cause::slip:
        return spacing_;
      case Cause::lead:
        return seen_.longest();
      default:
        return 1;
    }
  }

  /// A step that is not too long for a slope, and leaves a tenth of what is changed by a fraction.
  double allowed(Cause cause, double value, double step) const {
    const double most = unit(cause) * (unit(cause) == spacing_ ? 2 : 0.5);
    const bool is_fraction = cause <= Cause::sound_speed;
    return std::max(std::clamp(step, -most, most), is_fraction ? -0.9 - value : -HUGE_VAL);
  }

  /// Gauss and Newton's steps, halved where they do not lessen the error.
  Fit fitted(const std::vector<Cause>& causes, double tried) const {
    Fit fit{.causes = causes};
    const auto count = static_cast<Index>(causes.size());
    fit.value = fit.deviation = VectorXd::Zero(count);
    fit.rest = seen_.error();
    const auto changes = [&](const VectorXd& value) {
      Changes by;
      for (Index k = 0; k < count; ++k) by(causes[static_cast<std::size_t>(k)]) = value[k];
      return by;
    };
    const auto take_slopes = [&] {
      fit.columns.resize(fit.rest.size(), count);
      for (Index k = 0; k < count; ++k) {
        const Cause cause = causes[static_cast<std::size_t>(k)];
        fit.columns.col(k) = seen_.slope(fit.by, cause, 1e-4 * unit(cause), fit.rest);
      }
    };
    take_slopes();
    constexpr int most_steps = 8;
    for (int step = 0; step < most_steps; ++step) {
      VectorXd by = pseudo_inverse(fit.columns) * fit.rest;
      for (Index k = 0; k < count; ++k) by[k] = allowed(causes[static_cast<std::size_t>(k)], fit.value[k], by[k]);
      const double before = fit.rest.squaredNorm();
      int halved = 0;
      VectorXd rest = seen_.error(changes(fit.value + by));
      for (; halved < 4 && !(rest.squaredNorm() < before); ++halved)
        by /= 2, rest = seen_.error(changes(fit.value + by));
      if (halved == 4) break;
      fit.value += by;
      fit.by = changes(fit.value);
      fit.rest = rest;
      take_slopes();
      if (rest.squaredNorm() > (1 - 1e-4) * before) break;
    }
    fit.share = 1 - fit.rest.squaredNorm() / seen_.error().squaredNorm();
    for (Index k = 0; k < count; ++k) fit.possible &= is_possible(causes[static_cast<std::size_t>(k)], fit.value[k]);
    estimate_spread(fit, tried);
    return fit;
  }

  /// Of one or two columns: the matrix that makes the least squares' values of a vector.
  static MatrixXd pseudo_inverse(const MatrixXd& columns) {
    return (columns.transpose() * columns).ldlt().solve(columns.transpose());
  }

  void estimate_spread(Fit& fit, double tried) const {
    const Rest rest(seen_, fit.rest, fit.columns);
    const MatrixXd inverse = pseudo_inverse(fit.columns);
    for (Index k = 0; k < inverse.rows(); ++k) fit.deviation[k] = std::sqrt(rest.variance(inverse.row(k).transpose()));
    fit.interval = rest.interval();
    fit.level = rest.quantile(0.05 / tried);
  }

  /// Whether a cause adds to a fit what is no accident.
  bool adds(const Fit& fit, Cause cause) const {
    constexpr double all_of_it = 1 - 1e-9;  // rounding is left
    if (fit.share > all_of_it) return false;
    VectorXd column = seen_.slope(fit.by, cause, 1e-4 * unit(cause), fit.rest);
    const double before = column.norm();
    column -= fit.columns * (pseudo_inverse(fit.columns) * column).eval();
    if (column.norm() < 1e-3 * before) return false;  // the same column
    const double value = column.dot(fit.rest) / column.squaredNorm();
    MatrixXd both(fit.columns.rows(), fit.columns.cols() + 1);
    both << fit.columns, column;
    const Rest rest(seen_, fit.rest - value * column, both);
    return std::abs(value) > rest.quantile(0.01) * std::sqrt(rest.variance(column / column.squaredNorm()));
  }

  /// The best that suffices and those to which it adds nothing.
  std::vector<bool> name(const std::vector<Fit>& fits) const {
    std::vector<bool> named(fits.size(), false);
    const Fit* best = nullptr;
    for (const Fit& fit : fits)
      if (fit.suffices() && (!best || fit.share > best->share)) best = &fit;
    if (!best) return named;
    for (std::size_t k = 0; k < fits.size(); ++k) {
      const auto adds_to_it = [&](Cause cause) {
        return std::ranges::find(fits[k].causes, cause) == fits[k].causes.end() && adds(fits[k], cause);
      };
      named[k] = &fits[k] == best || (fits[k].suffices() && fits[k].differs_by(fits[k].interval) &&
                                      std::ranges::none_of(best->causes, adds_to_it));
    }
    return named;
  }

  /// Two causes at once, of those pairs that explain most by the slopes at the fits of one.
  std::vector<Fit> likely_pairs(const std::vector<Fit>& single) const {
    struct Pair {
      std::size_t a, b;
      double left;
    };
    std::vector<Pair> all;
    MatrixXd slopes(seen_.error().size(), static_cast<Index>(single.size()));
    for (std::size_t k = 0; k < single.size(); ++k)
      slopes.col(static_cast<Index>(k)) =
          seen_.slope({}, causes_[k], 1e-4 * unit(causes_[k]), seen_.error()).normalized();
    for (std::size_t a = 0; a < single.size(); ++a)
      for (std::size_t b = a + 1; b < single.size(); ++b) {
        const VectorXd& error = seen_.error();
        const auto first = slopes.col(static_cast<Index>(a)), second = slopes.col(static_cast<Index>(b));
        const double alike = first.dot(second), p = first.dot(error), q = second.dot(error);
        if (std::abs(alike) > 0.995) continue;
        all.push_back({a, b, error.squaredNorm() - (p * p + q * q - 2 * alike * p * q) / (1 - alike * alike)});
      }
    std::ranges::sort(all, {}, &Pair::left);
    std::vector<Fit> fits;
    constexpr std::size_t most_pairs = 6;
    for (std::size_t k = 0; k < std::min(all.size(), most_pairs); ++k)
      fits.push_back(fitted({causes_[all[k].a], causes_[all[k].b]}, static_cast<double>(all.size())));
    return fits;
  }

  /// What has no waves longer than some samples; its share is 1 where all waves are equally strong.
  Explanation as_noise() const {
    const VectorXd& error = seen_.error();
    const double numbers = static_cast<double>(error.size());
    const double mean_square = Rest(seen_, error, MatrixXd(error.size(), 0)).noise();
    const double size = 100 * std::sqrt(mean_square * numbers / seen_.times());
    Explanation noise{.causes = {{"noise", "%", size, 1.96 * size / std::sqrt(2 * numbers)}},
                      .share = std::min(1.0, mean_square * numbers / error.squaredNorm())};
    noise.sentence =
        fmt::format("the error is noise from sample to sample, {} of the root mean square", quantity(noise.causes[0]));
    return noise;
  }

  /// Its sign is in the words.
  static std::string quantity(const FittedCause& c) {
    return fmt::format("{} {}", in_digits_of_interval(std::abs(c.value), c.half_width), c.unit);
  }

  Explanation explanation(const Fit& fit, bool is_named) const {
    Explanation made{.share = fit.share, .named = is_named};
    for (std::size_t k = 0; k < fit.causes.size(); ++k) {
      const Phrases words = phrases_of(fit.causes[k], exact_.field == "pressure");
      const double scale = words.unit == "%" ? 100 : words.unit == "s" ? 1 : 1 / spacing_;
      const auto i = static_cast<Index>(k);
      const FittedCause& one =
          made.causes.emplace_back(FittedCause{std::string(words.name), std::string(words.unit), scale * fit.value[i],
                                               scale * fit.interval * fit.deviation[i]});
      const std::string_view phrase =
          one.value >= 0 || words.where_negative.empty() ? words.where_positive : words.where_negative;
      made.sentence += (k > 0 ? " and " : "") + fmt::format(fmt::runtime(phrase), quantity(one));
    }
    return made;
  }

  std::string in_words(const Diagnosis& all) const {
    std::vector<const Explanation*> named;
    for (const Explanation& one : all.explanations)
      if (one.named) named.push_back(&one);
    const Explanation& best = all.explanations.front();
    if (named.empty())
      return fmt::format(
          "none of the known causes explains the error of the {}: the best, {}, explains {:.0f} % of its square",
          exact_.field, best.sentence, 100 * best.share);
    std::string sentence =
        fmt::format("{}, which explains {:.1f} % of the squared error", best.sentence, 100 * best.share);
    for (std::size_t k = 1; k < named.size(); ++k)
      sentence += (k == 1 ? "; or, indistinguishable by these data: " : "; or ") + named[k]->sentence;
    return sentence;
  }

  const Exact& exact_;
  const Seen& seen_;
  double spacing_;
  std::vector<Cause> causes_;
};

}  // namespace

Diagnosis diagnose(const Exact& exact, const std::vector<const Samples*>& samples, const Domain& domain,
                   double spacing) {
  const Seen seen(exact, samples, domain);
  if (seen.empty())
    return {.field = exact.field, .sentence = fmt::format("the {} is zero at all these times", exact.field)};
  constexpr Index least = 40;  // so that ten waves are found beside what is left
  if (const Index numbers = seen.error().size(); numbers < least)
    return {.field = exact.field,
            .sentence = fmt::format("{} numbers of the {} are too few for a diagnosis", numbers, exact.field)};
  return Diagnostician(exact, seen, spacing).diagnosis();
}

}  // namespace touchstone::vnv::doors
