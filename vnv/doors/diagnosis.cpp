#include "vnv/doors/diagnosis.hpp"

#include "vnv/doors/mistakes.hpp"
#include "vnv/doors/where.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

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

/// At most so many of the indices below n, each once, of which any first few are spread evenly over all: multiples of
/// the golden section of n.
std::vector<Index> spread(Index n, Index most) {
  std::vector<Index> chosen(static_cast<std::size_t>(std::min(n, most)));
  Index step = n <= most ? 1 : std::lround(static_cast<double>(n) / std::numbers::phi);
  while (n > 0 && std::gcd(step, n) != 1) ++step;
  for (std::size_t k = 1; k < chosen.size(); ++k) chosen[k] = (chosen[k - 1] + step) % n;
  return chosen;
}

/// Rows that hold no number, or whose error stands apart from that of all others: left out of what is fitted.
struct LeftOut {
  double rows = 0, no_numbers = 0;  // at the times that were used
  double apart = 0;                 // at one of them, at most
  double squared = 0;               // error of those apart
  Vec2 x = Vec2::Zero();            // of the worst
  double time = 0, worst = 0;
};

/// The samples of a field, as one vector of weighted numbers: for each time and each component all its samples.
class FieldVector {
 public:
  FieldVector(const Exact& exact, const std::vector<const Samples*>& samples, const Domain& domain)
      : exact_(exact), waves_(domain, samples.empty() ? 0 : std::min<Index>(samples[0]->size(), most_samples)) {
    const auto count = static_cast<Index>(samples.size());
    for (const Index k : spread(count, most_times)) add(*samples[static_cast<std::size_t>(count - 1 - k)]);
    for (const Moment& moment : moments_) size_ += components() * moment.x.cols();
    VectorXd numbers(size_);
    each([&](const Moment& m, int component, Index first) {
      numbers.segment(first, m.x.cols()) = m.v.row(component).transpose().cwiseProduct(m.weight);
    });
    seen_ = numbers;
    take_off_means(seen_);
    error_ = error({});
  }
  /// As if what was seen were right but for a mistake.
  FieldVector(const FieldVector& other, const Mistake& mistake) : FieldVector(other) {
    if (mistake.seen) mistake_ = mistake.seen;
    seen_ /= mistake.scale;
    error_ = error({});
    left_out_ = {};
  }

  /// At one of its times alone.
  FieldVector(const FieldVector& other, std::size_t moment) : FieldVector(other) {
    Index first = 0;
    for (std::size_t k = 0; k < moment; ++k) first += components() * moments_[k].x.cols();
    moments_ = {other.moments_[moment]};
    size_ = components() * moments_[0].x.cols();
    seen_ = other.seen_.segment(first, size_).eval();
    error_ = other.error_.segment(first, size_).eval();
    left_out_ = {};
  }

  bool empty() const { return moments_.empty(); }
  double times() const { return static_cast<double>(moments_.size()); }
  int components() const { return exact_.components; }
  const std::vector<Moment>& moments() const { return moments_; }
  const Harmonics& waves() const { return waves_; }
  const LeftOut& left_out() const { return left_out_; }
  const VectorXd& numbers() const { return seen_; }
  const VectorXd& error() const { return error_; }
  VectorXd error(const Changes& by) const { return seen_ - of(by, Vec2::Zero(), mistake_); }
  VectorXd exact() const { return seen_ - error_; }
  bool knows(Cause cause) const { return cause == Cause::lead || std::ranges::count(exact_.causes, cause) > 0; }
  /// Whether its error could be this one.
  bool allows(const VectorXd& error) const {
    return !(error.squaredNorm() > 4 * error_.squaredNorm() + 1e-8 * exact().squaredNorm());
  }
  /// Of a flow along x alone what is seen along y, where it should be nothing.
  VectorXd across() const {
    VectorXd all = VectorXd::Zero(size_);
    if (exact_.field == "velocity" && components() == 1)
      each([&](const Moment& m, int, Index first) {
        all.segment(first, m.x.cols()) = m.v.row(1).transpose().cwiseProduct(m.weight);
      });
    return all;
  }
  /// The root mean square of the exact field at the first of its times.
  double norm() const { return 1 / std::sqrt(moments_[0].weight.squaredNorm()); }
  double longest() const { return moments_.empty() ? 0 : std::ranges::max(moments_, {}, &Moment::time).time; }

  /// The slope of the flow with a cause, where something is wrong already, by a small step of it.
  VectorXd slope(const Changes& by, Cause cause, double step, const VectorXd& error_there) const {
    Changes more = by;
    more(cause) += step;
    return (error_there - error(more)) / step;
  }

  /// The exact field as a mistake would show it, but for its scale.
  VectorXd exact_with(const Mistake& mistake) const { return of({}, Vec2::Zero(), mistake.seen); }

  /// The slope's Laplacian [its unit / m²], by second differences over this length [m]; of the exact field's own where
  /// the step is 0.
  VectorXd laplacian_of_slope(Cause cause, double step, double length) const {
    Changes more;
    more(cause) = step;
    const auto at = [&](const Vec2& moved) -> VectorXd {
      const VectorXd right = of({}, moved, mistake_);
      return step > 0 ? ((of(more, moved, mistake_) - right) / step).eval() : right;
    };
    return (at({length, 0}) + at({-length, 0}) + at({0, length}) + at({0, -length}) - 4 * at(Vec2::Zero())) /
           (length * length);
  }

  /// work(moment, component, the first of its numbers)
  void each(const auto& work) const {
    Index first = 0;
    for (const Moment& m : moments_)
      for (int component = 0; component < components(); ++component, first += m.x.cols()) work(m, component, first);
  }

 private:
  static constexpr Index most_samples = 1500, most_times = 6;
  static constexpr double largest = 1e100;  // of what can be squared and summed

  /// Between plates the component along them is enough.
  static bool lacks_v_y(const Samples& all) { return all.v.row(1).array().isNaN().all(); }

  /// Some of the rows that hold numbers, and with them those whose numbers are largest.
  std::vector<Index> chosen_of(const Samples& all) {
    const bool is_pressure = exact_.field == "pressure";
    const Index given = lacks_v_y(all) ? 1 : 2;
    const auto size = [&](Index p) {
      return is_pressure ? std::abs(all.pressure[p]) : all.v.col(p).head(given).cwiseAbs().sum();
    };
    const auto is_usable = [&](Index p) {
      const double volume = all.mass[p] / all.density[p];
      return size(p) < largest && volume > 0 && volume < largest && all.x.col(p).allFinite();
    };
    std::vector<Index> chosen, of_the_largest;
    constexpr std::size_t most_of_the_largest = 8;
    left_out_.rows += static_cast<double>(all.size());
    for (Index p = 0; p < all.size(); ++p) {
      if (!is_usable(p)) {
        ++left_out_.no_numbers;
      } else if (all.size() > most_samples &&
                 (of_the_largest.size() < most_of_the_largest || size(p) > size(of_the_largest.back()))) {
        if (of_the_largest.size() == most_of_the_largest) of_the_largest.pop_back();
        of_the_largest.insert(std::ranges::upper_bound(of_the_largest, size(p), std::greater{}, size), p);
      }
    }
    for (const Index p : spread(all.size(), most_samples))
      if (is_usable(p)) chosen.push_back(p);
    for (const Index p : of_the_largest)
      if (std::ranges::find(chosen, p) == chosen.end()) chosen.push_back(p);
    return chosen;
  }

  /// Which of these errors stand apart: at most one in 200 of them, each 5 times as large as all others.
  static std::vector<bool> apart(const VectorXd& error) {
    std::vector<Index> order(static_cast<std::size_t>(error.size()));
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, std::greater{}, [&](Index p) { return error[p]; });
    std::vector<bool> is_apart(order.size(), false);
    constexpr double larger = 5;
    for (std::size_t most = std::max<std::size_t>(1, order.size() / 200); most > 0; --most)
      if (most < order.size() && error[order[most - 1]] > larger * error[order[most]] + 1e-9) {
        for (std::size_t k = 0; k < most; ++k) is_apart[static_cast<std::size_t>(order[k])] = true;
        break;
      }
    return is_apart;
  }

  /// A time at which the exact field is nothing has no relative error and is left out.
  void add(const Samples& all) {
    Moment m{.time = all.time};
    std::vector<Index> chosen = chosen_of(all);
    if (chosen.empty()) return;
    const FieldTruth truth = exact_.with({});
    const auto take = [&] {
      m.x = all.x(Eigen::all, chosen);
      if (exact_.field == "pressure") {
        m.v = Vectors::Zero(2, m.x.cols());
        m.v.row(0) = all.pressure(chosen).matrix().transpose();
      } else {
        m.v = all.v(Eigen::all, chosen);
      }
      const VectorXd volumes = all.volumes()(chosen);
      m.weight = (volumes / volumes.sum()).cwiseSqrt();
      Vectors right(2, m.x.cols());
      for (Index p = 0; p < m.x.cols(); ++p) right.col(p) = truth(m.x.col(p), m.time);
      if (exact_.field == "velocity" && lacks_v_y(all)) m.v.row(1) = right.row(1);  // what is not given is not wrong
      if (exact_.less_mean) right.colwise() -= (right * m.weight.cwiseAbs2()).eval();
      return right;
    };
    Vectors right = take();
    double norm = (right * m.weight.asDiagonal()).norm();
    if (!(norm > 0)) return;
    MatrixXd wrong = (m.v - right).topRows(components());
    if (exact_.less_mean) wrong.colwise() -= middle_of(wrong);
    const VectorXd error = wrong.colwise().norm().transpose() / norm;
    if (const std::vector<bool> out = apart(error); std::ranges::find(out, true) != out.end()) {
      std::vector<Index> kept;
      for (std::size_t k = 0; k < chosen.size(); ++k) {
        const auto p = static_cast<Index>(k);
        if (!out[k]) {
          kept.push_back(chosen[k]);
          continue;
        }
        left_out_.squared += std::pow(m.weight[p] * error[p], 2);
        if (error[p] > left_out_.worst) left_out_.worst = error[p], left_out_.x = m.x.col(p), left_out_.time = m.time;
      }
      left_out_.apart = std::max(left_out_.apart, static_cast<double>(chosen.size() - kept.size()));
      chosen = kept;
      right = take();
      norm = (right * m.weight.asDiagonal()).norm();
      if (!(norm > 0)) return;
    }
    MatrixXd waves(m.x.cols(), waves_.all.size());
    for (Index p = 0; p < waves.rows(); ++p)
      for (Index w = 0; w < waves.cols(); ++w)
        waves(p, w) = m.weight[p] * waves_.at(waves_.all[static_cast<std::size_t>(w)], m.x.col(p));
    const Eigen::HouseholderQR<MatrixXd> orthonormal(waves);
    m.waves = orthonormal.householderQ() * MatrixXd::Identity(waves.rows(), waves.cols());
    m.weight /= norm;
    moments_.push_back(std::move(m));
  }

  /// The median of each component.
  static VectorXd middle_of(const MatrixXd& v) {
    VectorXd middle(v.rows());
    for (Index i = 0; i < v.rows(); ++i) {
      std::vector<double> sorted(v.row(i).begin(), v.row(i).end());
      const auto half = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
      std::nth_element(sorted.begin(), half, sorted.end());
      middle[i] = *half;
    }
    return middle;
  }

  /// The field of a flow in which something is wrong, at places that are moved. What its oracle is not defined for is
  /// infinitely far from what is seen, so that no fit goes there.
  VectorXd of(const Changes& by, const Vec2& moved, const Shown& mistake) const try {
    VectorXd numbers(size_);
    const FieldTruth truth = exact_.with(by);
    const double larger = 1 + by(Cause::amplitude);
    Index first = 0;
    for (const Moment& m : moments_) {
      const double least = exact_.period > 0 ? -HUGE_VAL : 0.0, norm = 1 / std::sqrt(m.weight.squaredNorm());
      const double time = std::max(least, m.time + by(Cause::lead));
      const Vec2 mean = norm * Vec2(by(Cause::mean_x), by(Cause::mean_y));
      const Index n = m.x.cols();
      for (Index p = 0; p < n; ++p) {
        const Vec2 x = m.x.col(p) + moved;
        const Vec2 v = larger * (mistake ? mistake(truth, x, time) : truth(x, time)) + mean;
        for (int component = 0; component < components(); ++component)
          numbers[first + component * n + p] = m.weight[p] * v[component];
      }
      first += components() * n;
    }
    take_off_means(numbers);
    return numbers;
  } catch (const std::exception&) {
    return VectorXd::Constant(size_, INFINITY);
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
  LeftOut left_out_{};
  Index size_ = 0;
  VectorXd seen_{}, error_{};
  Shown mistake_{};
};

/// The rest of an error as a field that is random: how strong its waves are, and how alike it is at two times.
class Rest {
 public:
  /// `fitted` are the columns that were fitted: they took their part of it away.
  Rest(const FieldVector& seen, const VectorXd& rest, const MatrixXd& fitted) : seen_(seen) {
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

  const FieldVector& seen_;
  mutable std::vector<double> energies_{};
  MatrixXd between_{}, spectrum_{};
  VectorXd short_{};
  double freedom_ = 1, noise_ = 0;
};

/// A value as the spacing goes to 0, and the half-width of its 95 % interval.
struct Extrapolated {
  double value, half_width;
};

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

/// A mistake that may have been made, and the squared error that it leaves.
struct Made {
  Mistake mistake;
  double left;
};

class Diagnostician {
 public:
  /// `discretisation` as of diagnose().
  Diagnostician(const Exact& exact, FieldVector seen, const Domain& domain, double spacing, double discretisation,
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

  /// Fits all causes; what they are called is said later, when other resolutions have been heard.
  void fit() {
    if (!has_error() || !is_enough()) return;
    for (const Cause cause : causes_) single_.push_back(fitted({cause}, 1));
    if (best_share(single_) < one_is_enough && !is_noise(as_noise())) pairs_ = likely_pairs(single_);
  }
  std::vector<Fit>& singles() { return single_; }
  const std::vector<Fit>& singles() const { return single_; }

  /// The causes that are named by themselves.
  std::vector<Cause> named() const {
    std::vector<Cause> causes;
    if (const std::vector<bool> named = names();
        std::ranges::find(named, true) - named.begin() < static_cast<std::ptrdiff_t>(single_.size()))
      for (std::size_t k = 0; k < single_.size(); ++k)
        if (named[k]) causes.push_back(single_[k].causes[0]);
    return causes;
  }
  /// Those that a finer resolution names are named here too, where they are more than their interval.
  void hear(std::vector<Cause> of_finer) { told_ = std::move(of_finer); }
  double spacing() const { return spacing_; }

  Diagnosis diagnosis(std::vector<double> times) const {
    Diagnosis all{.field = exact_.field};
    const LeftOut& out = seen_.left_out();
    std::string before;
    if (out.no_numbers > 0)
      before = fmt::format("{:.0f} of {:.0f} rows hold no number; of the rest, ", out.no_numbers, out.rows);
    if (seen_.empty()) {
      all.sentence = out.no_numbers > 0 && out.no_numbers == out.rows
                         ? fmt::format("no row of the {} holds a number", exact_.field)
                         : fmt::format("the {} is zero at all these times", exact_.field);
      return all;
    }
    const double whole = squared() + out.squared;
    all.error = 100 * std::sqrt(whole / seen_.times());
    if (constexpr double worth_a_word = 0.2;
        out.apart > 0 && out.squared >= worth_a_word * whole && all.error > as_exact) {
      Explanation alone{.causes = {{"particles apart", "", out.apart, 0}}, .share = out.squared / whole, .named = true};
      alone.sentence =
          out.apart > 1
              ? fmt::format(
                    "{:.0f} particles apart, the worst at ({:.4g}, {:.4g}) m and {:g} s, make {:.4g} % of the squared error",
                    out.apart, out.x.x(), out.x.y(), out.time, 100 * alone.share)
              : fmt::format("one particle, at ({:.4g}, {:.4g}) m and {:g} s, makes {:.4g} % of the squared error",
                            out.x.x(), out.x.y(), out.time, 100 * alone.share);
      all.explanations.push_back(alone);
      before += alone.sentence;
      if (!has_error()) {
        all.sentence = before;
        return all;
      }
      before += "; of the rest, ";
    }
    all.sentence = before;
    if (!has_error())
      all.sentence += fmt::format("the {} has no error to speak of", exact_.field);
    else if (const std::vector<Made> made = mistakes_made(std::move(times)); !made.empty())
      say_mistakes(made, all);
    else if (is_enough())
      say_causes(all);
    else
      all.sentence +=
          fmt::format("{} numbers of the {} are too few for a diagnosis", seen_.error().size(), exact_.field);
    std::ranges::stable_sort(all.explanations, std::greater{}, &Explanation::named);
    return all;
  }

 private:
  static constexpr double as_exact = 1e-4;       // %
  static constexpr double one_is_enough = 0.995;  // share of the squared error; else two, if they leave a tenth

  double squared() const { return seen_.error().squaredNorm(); }
  bool has_error() const { return !seen_.empty() && 100 * std::sqrt(squared() / seen_.times()) > as_exact; }
  bool is_enough() const {
    constexpr Index least = 40;  // so that ten waves are found beside what is left
    return seen_.error().size() >= least;
  }

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
    for (std::size_t k = 0; k < all.size(); ++k) modes_.col(static_cast<Index>(k)) = all[k];
  }

  VectorXd slope(const Changes& by, Cause cause, const VectorXd& error_there) const {
    const double larger = cause <= Cause::sound_speed ? std::max(1.0, 1 + by(cause)) : 1;
    return seen_.slope(by, cause, 1e-4 * larger * unit(cause), error_there);
  }

  // Mistakes

  /// Those that explain the error and cannot be told from the best, the plainest first.
  std::vector<Made> mistakes_made(std::vector<double> times) const {
    constexpr double least_left = 0.2, least_left_of_nothing = 0.02, gross = 0.04;
    const VectorXd &found = seen_.numbers(), right = seen_.exact();
    const bool is_gross = squared() > gross * right.squaredNorm();
    std::vector<Made> all, twofold;
    const auto consider = [&](const Mistake& mistake, const VectorXd& shown, std::vector<Made>& among,
                              double stricter) {
      const double left = (found - mistake.scale * shown).squaredNorm();
      const double of = mistake.scale == 0 ? least_left_of_nothing * right.squaredNorm()
                                           : least_left * stricter * (mistake.scale * shown).squaredNorm();
      if (left <= least_left * squared() && left <= of) among.push_back({mistake, left});
    };
    const auto factor = [&](const VectorXd& shown) { return found.dot(shown) / shown.squaredNorm(); };
    if (const VectorXd across = seen_.across(); is_gross && across.norm() > 0) {
      const double left = (across - right).squaredNorm() + found.squaredNorm();
      if (left < least_left_of_nothing * right.squaredNorm())
        return {{{.cause = "components swapped", .sentence = "v_x and v_y are swapped", .scale = 0}, left}};
    }
    if (is_gross)
      for (const Mistake& mistake : mistakes_of_scale(exact_, factor(right))) consider(mistake, right, all, 1);
    std::ranges::sort(times);
    for (const Mistake& mistake : mistakes_of_place_and_time(exact_, domain_, times)) {
      if (!is_gross && !mistake.of_time) continue;
      if (!others_allow(mistake)) continue;
      const VectorXd shown = seen_.exact_with(mistake);
      if (!shown.allFinite() || !(shown.squaredNorm() > 1e-12 * right.squaredNorm())) continue;
      consider(mistake, shown, all, 1);
      if (!is_gross) continue;
      for (Mistake both : mistakes_of_scale(exact_, factor(shown)))
        if (both.scale != 0) {
          both.cause += " and " + mistake.cause, both.sentence += " and " + mistake.sentence, both.seen = mistake.seen;
          consider(both, shown, twofold, 0.1);
        }
    }
    const bool are_two = all.empty();
    if (are_two) all = std::move(twofold);
    if (all.empty()) return all;
    const double best = std::ranges::min(all, {}, &Made::left).left;
    const auto is_better = [&](const Fit& fit) {
      return fit.suffices() && fit.stands() && (are_two || is_small(fit)) && fit.rest.squaredNorm() < best / 10;
    };
    const bool is_exact = best < 1e-12 * right.squaredNorm();
    if (!is_exact && (std::ranges::any_of(single_, is_better) || std::ranges::any_of(pairs_, is_better))) return {};
    constexpr double alike = 1.02;
    std::erase_if(all, [&](const Made& one) { return one.left > alike * best + 1e-12 * right.squaredNorm(); });
    return all;
  }

  /// Whether a fit is no other name of a mistake: a factor that is 90 % off is one.
  static bool is_small(const Fit& fit) {
    for (std::size_t k = 0; k < fit.causes.size(); ++k) {
      const Cause cause = fit.causes[k];
      const bool is_factor = (cause >= Cause::force && cause <= Cause::sound_speed) || cause >= Cause::amplitude;
      if (is_factor && !(std::abs(fit.value[static_cast<Index>(k)]) < (fit.causes.size() > 1 ? 2 : 0.9))) return false;
    }
    return true;
  }

  void say_mistakes(const std::vector<Made>& made, Diagnosis& all) const {
    constexpr std::size_t most_said = 4;
    std::vector<std::string> sentences;
    const Made& best = made.front();
    for (const Made& one : std::span(made).first(std::min(made.size(), most_said))) {
      const Mistake& m = one.mistake;
      all.explanations.push_back({.causes = {{m.cause, m.unit, m.value, 0}},
                                  .share = 1 - one.left / squared(),
                                  .named = true,
                                  .sentence = m.sentence});
      sentences.push_back(m.sentence);
    }
    for (const Fit& fit : single_) {
      const bool is_alike = best.mistake.scale == 1 && fit.suffices() && fit.stands() && is_small(fit) &&
                            fit.rest.squaredNorm() <= 1.1 * best.left + 1e-10 * squared();
      all.explanations.push_back(explanation(fit, is_alike));
      if (is_alike) sentences.push_back(all.explanations.back().sentence);
    }
    all.sentence += fmt::format("{}, which explains {:.4g} % of the squared error", sentences[0],
                                100 * (1 - best.left / squared()));
    for (std::size_t k = 1; k < sentences.size(); ++k)
      all.sentence += (k == 1 ? "; or, indistinguishable by these data: " : "; or ") + sentences[k];
    if (best.mistake.scale == 0 || !is_enough()) return;
    Diagnostician of_rest(exact_, FieldVector(seen_, best.mistake), domain_, spacing_, discretisation_);
    of_rest.fit();
    const Diagnosis rest = of_rest.diagnosis_of_causes();
    constexpr double worth_a_word = 0.5;  // %
    if (rest.error > worth_a_word && !rest.explanations.empty() && rest.explanations.front().named)
      all.sentence += fmt::format("; of the {:.3g} % that are left, {}", rest.error, rest.sentence);
  }

  Diagnosis diagnosis_of_causes() const {
    Diagnosis all{.field = exact_.field, .error = 100 * std::sqrt(squared() / seen_.times())};
    if (has_error()) say_causes(all);
    return all;
  }

  // Causes

  void say_causes(Diagnosis& all) const {
    std::vector<Fit> fits = single_;
    const std::vector<bool> named = names();
    const Explanation noise = as_noise();
    fits.insert(fits.end(), pairs_.begin(), pairs_.end());
    std::vector<Explanation> explanations;
    const Fit* best = nullptr;
    for (std::size_t k = 0; k < fits.size(); ++k)
      if (named[k] && (!best || fits[k].share > best->share)) best = &fits[k];
    for (std::size_t k = 0; k < fits.size(); ++k)
      explanations.push_back(explanation(fits[k], named[k], &fits[k] == best));
    const bool noise_is_named = std::ranges::find(named, true) == named.end() && is_noise(noise);
    explanations.push_back(noise);
    explanations.back().named = noise_is_named;
    std::ranges::stable_sort(explanations, std::greater{},
                             [](const Explanation& e) { return std::pair(e.named, e.share); });
    if (explanations.front().named)
      all.sentence += in_words(explanations);
    else if (say_time_alone(all))
      return;
    else if (std::ranges::any_of(fits, [&](const Fit& fit) { return is_discretisation(fit); }))
      all.sentence +=
          fmt::format("the error of the {} is no more than discretisation may make at this resolution: finer ones tell",
                      exact_.field);
    else
      all.sentence += nothing_explains(fits);
    std::ranges::move(explanations, std::back_inserter(all.explanations));
  }

  /// Where all of the error is that of one time and something is known of it there.
  bool say_time_alone(Diagnosis& all) const {
    constexpr double nearly_all = 0.95;
    if (seen_.moments().size() < 2) return false;
    for (std::size_t k = 0; k < seen_.moments().size(); ++k) {
      FieldVector alone(seen_, k);
      if (alone.error().squaredNorm() < nearly_all * squared()) continue;
      Diagnostician at_it(exact_, std::move(alone), domain_, spacing_, discretisation_);
      at_it.fit();
      const Diagnosis found = at_it.diagnosis_of_causes();
      if (found.explanations.empty() || !found.explanations.front().named) return false;
      all.sentence += fmt::format("only at {:g} s is there an error: {}", seen_.moments()[k].time, found.sentence);
      all.explanations.insert(all.explanations.end(), found.explanations.begin(), found.explanations.end());
      return true;
    }
    return false;
  }

  /// Of the causes by themselves, and of two at once behind them.
  std::vector<bool> names() const {
    std::vector<bool> named(single_.size(), false);
    for (std::size_t k = 0; k < single_.size(); ++k)
      named[k] = single_[k].stands() && std::ranges::find(told_, single_[k].causes[0]) != told_.end();
    std::vector<bool> of_pairs(pairs_.size(), false);
    if (std::ranges::find(named, true) == named.end()) {
      named = name(single_);
      const double by_one = best_share(single_), by_two = best_share(pairs_);
      if (by_two > 0 && (by_one == 0 || 1 - by_two < (1 - by_one) / 10)) {
        of_pairs = name(pairs_);
        if (std::ranges::find(of_pairs, true) != of_pairs.end()) named.assign(single_.size(), false);
      }
    }
    named.insert(named.end(), of_pairs.begin(), of_pairs.end());
    return named;
  }

  bool is_noise(const Explanation& noise) const { return best_share(single_) == 0 && noise.share >= sufficient; }

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

  std::string nothing_explains(const std::vector<Fit>& fits) const {
    std::string sentence = fmt::format("none of the known causes explains the error of the {}", exact_.field);
    const Fit* best = nullptr;
    constexpr double worth_a_word = 0.3;
    for (const Fit& fit : fits)
      if (fit.stands() && fit.share > worth_a_word && (!best || fit.share > best->share)) best = &fit;
    if (best)
      sentence += fmt::format(": the best, {}, explains {:.0f} % of its square", explanation(*best, false).sentence,
                              100 * best->share);
    std::vector<Located> all;
    seen_.each([&](const Moment& m, int, Index first) {
      for (Index p = 0; p < m.x.cols(); ++p)
        all.push_back({m.x.col(p), m.weight[p] * m.weight[p], std::pow(seen_.error()[first + p], 2)});
    });
    return sentence + "; " + where_it_lies(all, domain_, spacing_);
  }

  static double best_share(const std::vector<Fit>& fits) {
    double best = 0;
    for (const Fit& fit : fits)
      if (fit.suffices()) best = std::max(best, std::min(1.0, fit.net()));
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
        return exact_.period > 0 ? exact_.period / 4 : seen_.longest();
      default:
        return 1;
    }
  }

  /// A step that is not too long for a slope. Viscosity and the speed of sound are multiplied, so that a thousandth and
  /// a thousand times the right one are as near. To what a field is proportional, or is added to it, any step leads if
  /// nothing else is fitted.
  double allowed(Cause cause, double value, double step, bool alone) const {
    if (cause == Cause::viscosity || cause == Cause::sound_speed)
      return (1 + value) * std::expm1(std::clamp(step / (1 + value), -1.0, 1.0));
    const bool is_linear = cause <= Cause::gravity || cause >= Cause::amplitude;
    const double most = is_linear && alone ? HUGE_VAL : unit(cause) * (unit(cause) == spacing_ ? 2 : 0.5);
    return std::max(std::clamp(step, -most, most), cause <= Cause::gravity ? -0.999 - value : -HUGE_VAL);
  }

  /// Gauss and Newton's steps, halved where they do not lessen the error.
  Fit fitted(const std::vector<Cause>& causes, double tried) const {
    Fit fit{.causes = causes};
    const auto count = static_cast<Index>(causes.size());
    fit.value = fit.deviation = fit.discretised = fit.half_width = VectorXd::Zero(count);
    fit.rest = seen_.error();
    const auto changes = [&](const VectorXd& value) {
      Changes by;
      for (Index k = 0; k < count; ++k) by(causes[static_cast<std::size_t>(k)]) = value[k];
      return by;
    };
    const auto take_slopes = [&] {
      fit.columns.resize(fit.rest.size(), count);
      for (Index k = 0; k < count; ++k)
        fit.columns.col(k) = slope(fit.by, causes[static_cast<std::size_t>(k)], fit.rest);
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
      for (Index k = 0; k < count; ++k)
        by[k] = allowed(causes[static_cast<std::size_t>(k)], fit.value[k], by[k], count == 1);
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
    const double slower = std::min(1.0, seen_.numbers().norm() / seen_.exact().norm());  // and its errors with it
    if (modes_.cols() > 0) fit.discretised = slower * (inverse * modes_).rowwise().norm();
    fit.half_width = ((rest.interval() * fit.deviation).cwiseAbs2() + fit.discretised.cwiseAbs2()).cwiseSqrt();
    fit.level = rest.quantile(0.05 / tried);
    fit.noise = std::min(1.0, rest.noise() * static_cast<double>(fit.rest.size()) / squared());
    fit.possible &= fit.value.allFinite() && fit.half_width.allFinite() && std::isfinite(fit.share);
    fit.possible = fit.possible && others_allow(fit);
  }

  /// Whether the other fields of the flow do not speak against what is wrong with it: with the least of it that its
  /// interval holds they would be twice as wrong, or more, as they are.
  bool others_allow(const Fit& fit) const {
    return std::ranges::all_of(others_, [&](const FieldVector& other) {
      Changes by;
      for (std::size_t k = 0; k < fit.causes.size(); ++k) {
        const double value = fit.value[static_cast<Index>(k)], wide = fit.half_width[static_cast<Index>(k)];
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

  /// The best that suffices and those to which it adds nothing; none where the best is less than its interval.
  std::vector<bool> name(const std::vector<Fit>& fits) const {
    std::vector<bool> named(fits.size(), false);
    const Fit* best = nullptr;
    for (const Fit& fit : fits)
      if (fit.suffices() && (!best || fit.share > best->share)) best = &fit;
    if (!best || !best->stands()) return named;
    // What leaves a ten thousandth of the error at most is told from all that leave ten times as much: no
    // discretisation blurs these data.
    const double all = std::min(squared(), seen_.numbers().squaredNorm());
    const double most = best->rest.squaredNorm() <= 1e-8 * all ? 1e-6 * all : HUGE_VAL;
    for (std::size_t k = 0; k < fits.size(); ++k) {
      if (fits[k].rest.squaredNorm() > most) continue;
      const auto adds_to_it = [&](Cause cause) {
        return std::ranges::find(fits[k].causes, cause) == fits[k].causes.end() && adds(fits[k], cause);
      };
      named[k] = &fits[k] == best ||
                 (fits[k].suffices() && fits[k].stands() && std::ranges::none_of(best->causes, adds_to_it));
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
      slopes.col(static_cast<Index>(k)) = slope({}, causes_[k], seen_.error()).normalized();
    for (std::size_t a = 0; a < single.size(); ++a)
      for (std::size_t b = a + 1; b < single.size(); ++b) {
        const VectorXd& error = seen_.error();
        const auto first = slopes.col(static_cast<Index>(a)), second = slopes.col(static_cast<Index>(b));
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

  /// What has no waves longer than some samples; its share is 1 where all waves are equally strong.
  Explanation as_noise() const {
    const VectorXd& error = seen_.error();
    Explanation noise =
        noise_of(Rest(seen_, error, MatrixXd(error.size(), 0)).noise() * static_cast<double>(error.size()));
    noise.sentence =
        fmt::format("the error is noise from sample to sample, {} of the root mean square", quantity(noise.causes[0]));
    return noise;
  }
  Explanation noise_of(double noise_squared) const {
    const auto numbers = static_cast<double>(seen_.error().size());
    const double size = 100 * std::sqrt(noise_squared / seen_.times());
    return {.causes = {{"noise", "%", size, 1.96 * size / std::sqrt(2 * numbers)}},
            .share = std::min(1.0, noise_squared / squared())};
  }

  /// Its sign is in the words.
  static std::string quantity(const FittedCause& c) {
    return fmt::format("{} {}", in_digits_of_interval(std::abs(c.value), c.half_width), c.unit);
  }
  /// What is five times as large or small, as a ratio: "20.00 ± 0.03 times".
  static std::string quantity(const FittedCause& c, Cause cause) {
    constexpr double many = 5;
    const double ratio = 1 + c.value / 100, wide = c.half_width / 100;
    const bool is_many = ratio >= many || (ratio > 0 && ratio <= 1 / many);
    if (c.unit != "%" || cause >= Cause::mean_x || !is_many || wide > ratio / 2) return quantity(c);
    return ratio > 1 ? fmt::format("{} times", in_digits_of_interval(ratio, wide))
                     : fmt::format("{} times", in_digits_of_interval(1 / ratio, wide / (ratio * ratio)));
  }

  /// What is there besides it as noise is said with what is named, in words with the best.
  Explanation explanation(const Fit& fit, bool is_named, bool is_best = false) const {
    Explanation made{.share = fit.share, .named = is_named};
    for (std::size_t k = 0; k < fit.causes.size(); ++k) {
      const Phrases words = phrases_of(fit.causes[k], exact_.field == "pressure");
      const double scale = words.unit == "%" ? 100 : words.unit == "s" ? 1 : 1 / spacing_;
      const auto i = static_cast<Index>(k);
      const FittedCause& one = made.causes.emplace_back(FittedCause{std::string(words.name), std::string(words.unit),
                                                                    scale * fit.value[i], scale * fit.half_width[i]});
      const std::string_view phrase =
          one.value >= 0 || words.where_negative.empty() ? words.where_positive : words.where_negative;
      made.sentence += (k > 0 ? " and " : "") + fmt::format(fmt::runtime(phrase), quantity(one, fit.causes[k]));
      if (exact_.field == "pressure" && fit.causes[k] == Cause::mean_x) made.sentence += as_atmosphere(fit.value[i]);
      if (words.unit == "%") made.sentence += in_times(fit.value[i], fit.half_width[i]);
      if (is_named && k < fit.vanishing.size()) {
        const bool is_wall = words.unit == "spacings";
        const double in = fit.in_metres ? 1 : scale;
        const FittedCause at_zero{one.cause, std::string(fit.in_metres ? "m" : words.unit), in * fit.vanishing[k].value,
                                  in * fit.vanishing[k].half_width};
        made.sentence +=
            fmt::format(" ({} {}{})", is_wall ? "at all resolutions" : "at vanishing spacing",
                        at_zero.value * fit.value[i] < 0 ? "-" : "", quantity(at_zero, fit.causes[k]));
      }
    }
    constexpr double worth_a_word = 0.03;
    if (is_named && fit.noise >= worth_a_word) {
      const Explanation noise = noise_of(fit.noise * squared());
      made.causes.push_back(noise.causes[0]);
      made.share = std::min(1.0, made.share + noise.share);
      if (is_best)
        made.sentence +=
            fmt::format(", with noise of {} of the root mean square from sample to sample", quantity(noise.causes[0]));
    }
    return made;
  }

  /// " (of the air, 101325 Pa?)" where a pressure that is added everywhere is that.
  std::string as_atmosphere(double mean) const {
    constexpr double of_air = 101325;  // Pa
    return std::abs(mean * seen_.norm() / of_air - 1) < 0.01 ? " (that of the air, 101325 Pa?)" : "";
  }

  /// " (doubled)" or " (halved)" where a fraction is that but for its interval.
  static std::string in_times(double value, double half_width) {
    const auto is = [&](double what) { return std::abs(value - what) <= std::max(half_width, 0.01); };
    if (half_width > 0.1) return "";
    return is(1) ? " (doubled)" : is(-0.5) ? " (halved)" : "";
  }

  static std::string in_words(const std::vector<Explanation>& explanations) {
    const Explanation& best = explanations.front();
    std::string sentence = fmt::format("{}, which {} {:.1f} % of the squared error", best.sentence,
                                       best.causes.size() > 1 ? "explain" : "explains", 100 * best.share);
    for (std::size_t k = 1; k < explanations.size() && explanations[k].named; ++k)
      sentence += (k == 1 ? "; or, indistinguishable by these data: " : "; or ") + explanations[k].sentence;
    return sentence;
  }

  const Exact& exact_;
  FieldVector seen_;
  std::vector<FieldVector> others_;
  const Domain& domain_;
  double spacing_, discretisation_;
  std::vector<Cause> causes_;
  MatrixXd modes_{};
  std::vector<Fit> single_{}, pairs_{};
  std::vector<Cause> told_{};
};

/// As the spacing goes to 0: values v = v0 + a d + e of least squares, with d what discretisation may make at each
/// resolution. `a` is of the order of 1, 3 at most by a standard deviation, and e what is no square of the spacing, a
/// tenth of d. Where the values scatter more than that their own scatter counts (Birge, Phys. Rev. 40 (1932), 207-227).
struct Line {
  Extrapolated at_zero;
  double scatter;  // chi squared per degree of freedom
};
Line line_of(const VectorXd& value, const VectorXd& deviation, const VectorXd& made) {
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

/// Of each cause by itself what all resolutions say together: its interval at one of them reaches over that of its
/// value at vanishing spacing. A wall may be off by a length or by a part of a spacing.
void hear_all_resolutions(std::vector<Diagnostician>& levels) {
  std::vector<Diagnostician*> heard;
  for (Diagnostician& level : levels)
    if (!level.singles().empty()) heard.push_back(&level);
  if (heard.size() < 2) return;
  for (std::size_t k = 0; k < heard[0]->singles().size(); ++k) {
    const auto count = static_cast<Index>(heard.size());
    VectorXd value(count), deviation(count), made(count), spacing(count);
    bool possible = true;
    for (Index l = 0; l < count; ++l) {
      const Fit& fit = heard[static_cast<std::size_t>(l)]->singles()[k];
      possible &= fit.possible && fit.deviation.allFinite() && fit.discretised[0] > 0;
      value[l] = fit.value[0], deviation[l] = fit.deviation[0], made[l] = fit.discretised[0];
      spacing[l] = heard[static_cast<std::size_t>(l)]->spacing();
    }
    if (!possible) continue;
    Line line = line_of(value, deviation, made);
    VectorXd unit = VectorXd::Ones(count);
    const Cause cause = heard[0]->singles()[k].causes[0];
    bool in_metres = cause == Cause::floor || cause == Cause::ceiling || cause == Cause::walls || cause == Cause::slip;
    if (in_metres) {
      const Line in_spacings =
          line_of(value.cwiseQuotient(spacing), deviation.cwiseQuotient(spacing), made.cwiseQuotient(spacing));
      if (in_spacings.scatter < line.scatter) line = in_spacings, unit = spacing, in_metres = false;
    }
    if (!std::isfinite(line.at_zero.value) || !std::isfinite(line.at_zero.half_width)) continue;
    for (Index l = 0; l < count; ++l) {
      Fit& fit = heard[static_cast<std::size_t>(l)]->singles()[k];
      const Extrapolated here{unit[l] * line.at_zero.value, unit[l] * line.at_zero.half_width};
      fit.vanishing = {here};
      fit.in_metres = in_metres;
      fit.half_width[0] = std::abs(fit.value[0] - here.value) + here.half_width;
    }
  }
}

}  // namespace

std::vector<Diagnosis> diagnose(const Exact& exact, const std::vector<Diagnosed>& levels, const Domain& domain,
                                double discretisation, const std::vector<const Exact*>& others) {
  std::vector<Diagnostician> all;
  for (const Diagnosed& level : levels) {
    std::vector<FieldVector> seen;
    for (const Exact* other : others)
      if (FieldVector one(*other, level.samples, domain); !one.empty()) seen.push_back(std::move(one));
    all.emplace_back(exact, FieldVector(exact, level.samples, domain), domain, level.spacing, discretisation,
                     std::move(seen));
    all.back().fit();
  }
  hear_all_resolutions(all);
  if (all.size() > 1) {
    const Diagnostician& finest = *std::ranges::min_element(all, {}, &Diagnostician::spacing);
    const std::vector<Cause> named = finest.named();
    for (Diagnostician& level : all)
      if (&level != &finest) level.hear(named);
  }
  std::vector<Diagnosis> found;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    std::vector<double> times;
    for (const Samples* samples : levels[k].samples) times.push_back(samples->time);
    found.push_back(all[k].diagnosis(std::move(times)));
  }
  return found;
}

}  // namespace touchstone::vnv::doors
