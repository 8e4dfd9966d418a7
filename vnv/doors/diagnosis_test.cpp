/// Errors with a known cause are planted into exact samples beside a rest of the error, and diagnosed. The day's test
/// draws few; TOUCHSTONE_PLANTS=20 draws so many of each kind, by TOUCHSTONE_SEED, and prints the table of README.md.

#include "vnv/doors/diagnosis.hpp"

#include "solvers/lattice.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <random>

namespace touchstone::vnv::doors {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) { return std::uniform_real_distribution(low, high)(random); }

/// What is planted: a cause, noise (no cause), or nothing (times = 0), so many times as large as the rest of the error.
struct Plant {
  std::optional<Cause> cause{};
  double times = 0;
  bool smooth_rest = true;
};

/// The rest of an error [relative], by component: white, or with waves that are longer than a correlation length, and
/// that partly stay the same over the times.
class RestOfError {
 public:
  RestOfError(Random& random, const Domain& domain, bool smooth, double size)
      : random_(random), smooth_(smooth), size_(size) {
    stays_ = uniform(random, 0, 1);
    const double length = uniform(random, 1.0 / 12, 1.0 / 4);  // of the box
    const bool along_y_only = domain.periodic(0) && !domain.periodic(1) && uniform(random, 0, 1) < 0.5;
    std::normal_distribution<double> wave(0, 1 / length / (2 * std::numbers::pi));
    for (Vec2& k : waves_)
      for (const int axis : {0, 1}) {
        const double number = axis == 0 && along_y_only ? 0 : wave(random);
        k[axis] =
            2 * std::numbers::pi / domain.box.size()[axis] * (domain.periodic(axis) ? std::round(number) : number);
      }
    common_ = phases();
  }
  /// At the places of the next time.
  Vectors at(const Vectors& x) {
    Vectors rest = Vectors::Zero(2, x.cols());
    std::normal_distribution<double> normal;
    const Phases own = phases();
    for (Eigen::Index p = 0; p < x.cols(); ++p)
      for (const int component : {0, 1})
        rest(component, p) = smooth_ ? stays_ * sum(common_, component, x.col(p)) +
                                           std::sqrt(1 - stays_ * stays_) * sum(own, component, x.col(p))
                                     : normal(random_);
    return size_ * rest;
  }

 private:
  static constexpr std::size_t count = 80;
  using Phases = std::array<std::array<double, count>, 2>;
  Phases phases() {
    Phases all;
    for (auto& one : all)
      for (double& phase : one) phase = uniform(random_, 0, 2 * std::numbers::pi);
    return all;
  }
  double sum(const Phases& phases, int component, const Vec2& x) const {
    double all = 0;
    for (std::size_t k = 0; k < count; ++k)
      all += std::cos(waves_[k].dot(x) + phases[static_cast<std::size_t>(component)][k]);
    return all * std::sqrt(2.0 / count);
  }

  Random& random_;
  bool smooth_;
  double size_, stays_ = 0;
  std::array<Vec2, count> waves_{};
  Phases common_{};
};

/// The exact field with changes, at the times of the flow.
std::vector<Samples> samples_of(const Flow& flow, const Exact& exact, const Changes& by, double spacing) {
  std::vector<Samples> all;
  const FieldTruth truth = exact.with(by);
  for (const double time : flow.judged.times) {
    Samples s{.time = time, .x = lattice(flow.filled, spacing).places()};
    s.v = Vectors::Zero(2, s.size());
    s.mass = s.density = Scalars::Ones(s.size());
    for (Eigen::Index p = 0; p < s.size(); ++p)
      s.v.col(p) = (1 + by(Cause::amplitude)) * truth(s.x.col(p), std::max(0.0, time + by(Cause::lead)));
    s.pressure = s.v.row(0).transpose().array();
    all.push_back(std::move(s));
  }
  return all;
}

double norm_of(const Exact& exact, const Samples& s) {
  Vectors v = s.v;
  if (exact.less_mean) v.colwise() -= v.rowwise().mean().eval();
  return v.norm() / std::sqrt(static_cast<double>(s.size()));
}

/// Adds to samples a field in units of the norm of the exact one.
void add(Samples& s, double norm, const Vectors& relative, int components) {
  s.v.topRows(components) += norm * relative.topRows(components) / std::sqrt(components);
  s.pressure += norm * relative.row(0).transpose().array();
}

bool is_mean(Cause cause) { return cause == Cause::mean_x || cause == Cause::mean_y; }

double natural(Cause cause, const Flow& flow, double spacing) {
  const bool is_wall =
      cause == Cause::floor || cause == Cause::ceiling || cause == Cause::walls || cause == Cause::slip;
  return is_wall ? spacing : cause == Cause::lead ? flow.judged.times.back() : 1;
}

struct Planted {
  std::vector<Samples> samples;
  double value = 0;  // in the unit of Changes
};

Planted plant(Random& random, const Flow& flow, const Exact& exact, const Plant& plant, double spacing) {
  const std::vector<Samples> right = samples_of(flow, exact, {}, spacing);
  std::vector<double> norms;
  for (const Samples& s : right) norms.push_back(norm_of(exact, s));
  const double size = std::exp(uniform(random, std::log(1e-3), std::log(5e-3)));
  RestOfError rest(random, flow.domain, plant.smooth_rest, size);
  Planted made{.samples = right};
  if (plant.cause) {
    const Cause cause = *plant.cause;
    Changes by;
    by(cause) = 1e-3 * natural(cause, flow, spacing);
    double change = 0;  // relative, of that little
    const std::vector<Samples> little = samples_of(flow, exact, by, spacing);
    for (std::size_t k = 0; k < right.size(); ++k) {
      Samples difference = little[k];
      difference.v -= right[k].v;
      change += std::pow(is_mean(cause) ? 1e-3 : norm_of(exact, difference) / norms[k], 2) /
                static_cast<double>(right.size());
    }
    made.value = by(cause) * plant.times * size / std::sqrt(change);
    if (cause != Cause::slip && uniform(random, 0, 1) < 0.5) made.value *= -1;
    by(cause) = made.value;
    made.samples = samples_of(flow, exact, by, spacing);
  }
  RestOfError noise(random, flow.domain, false, plant.cause ? 0 : plant.times * size);
  for (std::size_t k = 0; k < right.size(); ++k) {
    add(made.samples[k], norms[k], rest.at(right[k].x), exact.components);
    add(made.samples[k], norms[k], noise.at(right[k].x), exact.components);
    if (plant.cause && is_mean(*plant.cause)) {
      Vectors mean = Vectors::Zero(2, right[k].x.cols());
      mean.row(*plant.cause == Cause::mean_x ? 0 : 1).setConstant(made.value * std::sqrt(exact.components));
      add(made.samples[k], norms[k], mean, exact.components);
    }
  }
  return made;
}

struct Rates {
  long planted = 0, right = 0, covered = 0, with_interval = 0, members = 0, none = 0, none_named = 0;

  void operator+=(const Rates& o) {
    planted += o.planted, right += o.right, covered += o.covered, with_interval += o.with_interval,
        members += o.members;
    none += o.none, none_named += o.none_named;
  }
};

/// How a cause is called in a record, and its unit there.
struct Called {
  std::string name;
  double unit;
};
Called called(Cause cause, double spacing, bool is_pressure) {
  switch (cause) {
    case Cause::viscosity:
      return {"viscosity", 0.01};
    case Cause::force:
      return {"force", 0.01};
    case Cause::gravity:
      return {"gravity", 0.01};
    case Cause::sound_speed:
      return {"sound speed", 0.01};
    case Cause::floor:
      return {"lower wall", spacing};
    case Cause::ceiling:
      return {"upper wall", spacing};
    case Cause::walls:
      return {"both walls", spacing};
    case Cause::slip:
      return {"slip length", spacing};
    case Cause::lead:
      return {"time", 1};
    case Cause::amplitude:
      return {"amplitude", 0.01};
    case Cause::mean_x:
      return {is_pressure ? "mean" : "mean along x", 0.01};
    case Cause::mean_y:
      return {"mean along y", 0.01};
  }
  return {};
}

Rates diagnosed(Random& random, const Flow& flow, const Exact& exact, const Plant& what) {
  const double spacing = flow.across / std::round(uniform(random, 16, 32));
  const Planted planted = plant(random, flow, exact, what, spacing);
  std::vector<const Samples*> samples;
  for (const Samples& s : planted.samples) samples.push_back(&s);
  const Diagnosis found = diagnose(exact, samples, flow.domain, spacing);
  Rates rates;
  const Called planted_as =
      what.cause ? called(*what.cause, spacing, exact.field == "pressure") : Called{"noise", 0.01};
  const bool is_planted = what.times > 0;
  rates.planted = is_planted, rates.none = !is_planted, rates.none_named = !is_planted;
  for (const Explanation& one : found.explanations) {
    if (is_planted && one.causes.size() == 1 && one.causes[0].cause == planted_as.name) {
      rates.right += one.named;
      if (what.cause) {
        ++rates.with_interval;
        rates.covered += std::abs(one.causes[0].value - planted.value / planted_as.unit) <= one.causes[0].half_width;
      }
    }
    if (is_planted) rates.members += one.named;
    if (!is_planted && one.named && one.causes[0].cause != "noise") rates.none_named = 0;
  }
  if (std::getenv("TOUCHSTONE_PLANTS_VERBOSE") &&
      (is_planted ? rates.right == 0 || rates.covered < rates.with_interval : rates.none_named == 0))
    fmt::print("{} {} {} x{} {}: planted {:.4g}; {}\n", flow.name, exact.field, planted_as.name, what.times,
               what.smooth_rest ? "smooth" : "noise", planted.value / planted_as.unit, found.sentence);
  return rates;
}

std::vector<Cause> causes_tried(const Exact& exact) {
  std::vector<Cause> causes = exact.causes;
  causes.push_back(Cause::amplitude);
  if (!exact.less_mean && exact.field == "velocity") causes.push_back(Cause::lead);
  if (!exact.less_mean) causes.push_back(Cause::mean_x);
  if (exact.components == 2) causes.push_back(Cause::mean_y);
  return causes;
}

/// Each cause of a field and noise, at 3, 10 and 30 times the rest of the error, and nothing, so often.
std::map<std::string, Rates> rates_of(Random& random, const std::string& flow_name, const std::string& field,
                                      int often) {
  const Flow flow = flow_named(flow_name);
  const Exact& exact = *std::ranges::find(flow.exact, field, &Exact::field);
  std::map<std::string, Rates> rates;
  for (int k = 0; k < often; ++k)
    for (const bool smooth : {true, false}) {
      const std::string kind = smooth ? "smooth" : "noise";
      for (const double times : {3., 10., 30.}) {
        Rates& all = rates[fmt::format("{} {:2}", kind, times)];
        for (const Cause cause : causes_tried(exact)) all += diagnosed(random, flow, exact, {cause, times, smooth});
        if (smooth) all += diagnosed(random, flow, exact, {std::nullopt, times, smooth});
      }
      for (int again = 0; again < 4; ++again)
        rates[kind + " nothing"] += diagnosed(random, flow, exact, {.smooth_rest = smooth});
    }
  return rates;
}

int from_environment(const char* name, int usual) { return std::getenv(name) ? std::atoi(std::getenv(name)) : usual; }

TEST(Diagnosis, NamesWhatWasPlantedWithItsSizeAndNothingWhereNothingWas) {
  const int often = from_environment("TOUCHSTONE_PLANTS", 1);
  Random random(static_cast<unsigned>(from_environment("TOUCHSTONE_SEED", 33)));
  const char* only = std::getenv("TOUCHSTONE_PLANTS_IN");
  Rates all;
  const auto percent = [](long part, long whole) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(std::max(1L, whole));
  };
  for (const auto& [flow, field] :
       std::vector<std::pair<std::string, std::string>>{{"poiseuille", "velocity"},
                                                        {"couette", "velocity"},
                                                        {"oscillating_poiseuille", "velocity"},
                                                        {"stokes_second", "velocity"},
                                                        {"taylor_green", "velocity"},
                                                        {"shear_wave", "velocity"},
                                                        {"manufactured", "pressure"},
                                                        {"hydrostatic", "pressure"}}) {
    if (only && std::string(only).find(flow) == std::string::npos) continue;
    Rates of_flow;
    for (const auto& [kind, rates] : rates_of(random, flow, field, often)) {
      if (often > 1)
        fmt::print(
            "{:24} {:14} {:5} planted: right {:5.1f} %, covered {:5.1f} %, members {:.2f}; {:5} nothing: none named {:5.1f} %\n",
            flow, kind, rates.planted, percent(rates.right, rates.planted), percent(rates.covered, rates.with_interval),
            static_cast<double>(rates.members) / static_cast<double>(std::max(1L, rates.planted)), rates.none,
            percent(rates.none_named, rates.none));
      of_flow += rates;
    }
    fmt::print("{:24} right {:5.1f} % of {}, covered {:5.1f} %, members {:.2f}, none named {:5.1f} % of {}\n", flow,
               percent(of_flow.right, of_flow.planted), of_flow.planted,
               percent(of_flow.covered, of_flow.with_interval),
               static_cast<double>(of_flow.members) / static_cast<double>(of_flow.planted),
               percent(of_flow.none_named, of_flow.none), of_flow.none);
    all += of_flow;
  }
  fmt::print("all: right {:.1f} % of {}, covered {:.1f} %, none named {:.1f} % of {}\n",
             percent(all.right, all.planted), all.planted, percent(all.covered, all.with_interval),
             percent(all.none_named, all.none), all.none);
  EXPECT_GE(percent(all.right, all.planted), 95);
  EXPECT_GE(percent(all.covered, all.with_interval), 90);
  EXPECT_GE(percent(all.none_named, all.none), 95);
}

}  // namespace
}  // namespace touchstone::vnv::doors
