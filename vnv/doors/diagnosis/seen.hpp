#pragma once
/// What is seen of a field, and its error, as vectors of weighted numbers.

#include "vnv/doors/diagnosis/mistakes.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace touchstone::vnv::doors::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Harmonics along one axis of a box, by their number: cosines between walls, and sines too where it is periodic.
struct HarmonicsAlong {
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
  std::array<HarmonicsAlong, 2> axes;
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
inline std::vector<Index> spread(Index n, Index most) {
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
    for (const Samples* one : samples) given_times_.push_back(one->time);
    std::ranges::sort(given_times_);
    const auto count = static_cast<Index>(samples.size());
    for (const Index k : spread(count, most_times)) add(*samples[count - 1 - k]);
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
  const std::vector<double>& given_times() const { return given_times_; }
  int components() const { return exact_.components; }
  const std::string& field() const { return exact_.field; }
  /// The name of the parameter that a cause is.
  std::string_view parameter(Cause cause) const {
    return exact_.parameters.at(static_cast<std::size_t>(cause) - static_cast<std::size_t>(Cause::parameter));
  }
  double squared_error() const { return error_.squaredNorm(); }
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
        for (std::size_t k = 0; k < most; ++k) is_apart[order[k]] = true;
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
      for (Index w = 0; w < waves.cols(); ++w) waves(p, w) = m.weight[p] * waves_.at(waves_.all[w], m.x.col(p));
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
  std::vector<double> given_times_{};  // rising, also those that are not used
  std::vector<Moment> moments_{};
  LeftOut left_out_{};
  Index size_ = 0;
  VectorXd seen_{}, error_{};
  Shown mistake_{};
};

}  // namespace touchstone::vnv::doors::diagnosis
