/// Errors with a known cause are planted into exact samples beside a rest of the error, and diagnosed. The day's test
/// draws few; TOUCHSTONE_PLANTS=20 draws so many of each kind, by TOUCHSTONE_SEED, and prints the table of README.md.

#include "vnv/doors/diagnosis/diagnosis.hpp"

#include "solvers/lattice.hpp"
#include "solvers/walls/navier_slip.hpp"
#include "vnv/methods/methods.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <numbers>
#include <random>

namespace touchstone::vnv::doors {
namespace {

using Random = std::mt19937_64;

std::vector<const Samples*> pointers(const std::vector<Samples>& samples) {
  std::vector<const Samples*> all;
  for (const Samples& s : samples) all.push_back(&s);
  return all;
}

/// Of one resolution: of an exact field with something added, unless something else is said.
Diagnosis diagnosed(const Exact& exact, const std::vector<const Samples*>& samples, const Domain& domain,
                    double spacing, double discretisation = 0) {
  return diagnose(exact, {{samples, spacing}}, domain, discretisation).at(0);
}

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
    case Cause::parameter:  // of flows in formulas, which are not planted here
      break;
  }
  return {};
}

Rates rates_of(Random& random, const Flow& flow, const Exact& exact, const Plant& what) {
  const double spacing = flow.across / std::round(uniform(random, 16, 32));
  const Planted planted = plant(random, flow, exact, what, spacing);
  std::vector<const Samples*> samples;
  for (const Samples& s : planted.samples) samples.push_back(&s);
  const Diagnosis found = diagnosed(exact, samples, flow.domain, spacing);
  Rates rates;
  const Called planted_as =
      what.cause ? called(*what.cause, spacing, exact.field == "pressure") : Called{"noise", 0.01};
  const bool is_planted = what.times > 0;
  rates.planted = is_planted, rates.none = !is_planted, rates.none_named = !is_planted;
  for (const Explanation& one : found.explanations) {
    const bool is_single = one.causes.size() == 1 || one.causes[1].cause == "noise";
    if (is_planted && is_single && one.causes[0].cause == planted_as.name) {
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

/// The field into which is planted: of the manufactured flow the pressure, to which the speed of sound belongs.
const Exact& field_of(const Flow& flow) { return flow.name == "manufactured" ? flow.exact.back() : flow.exact.front(); }

struct Drawn {
  std::string flow, kind;
  Plant plant;
};

/// Each cause of a field and noise, at 3, 10 and 30 times the rest of the error, and nothing, so often, in any order.
std::vector<Drawn> drawn(Random& random, int often) {
  std::vector<Drawn> all;
  for (const char* name : {"poiseuille", "couette", "oscillating_poiseuille", "stokes_second", "taylor_green",
                           "shear_wave", "hydrostatic", "manufactured"}) {
    const Flow flow = flow_named(name);
    const std::vector<Cause> causes = causes_tried(field_of(flow));
    for (int k = 0; k < often; ++k)
      for (const bool smooth : {true, false}) {
        const char* kind = smooth ? "smooth" : "noise";
        for (const double times : {3., 10., 30.}) {
          for (const Cause cause : causes)
            all.push_back({name, fmt::format("{} {:2}", kind, times), {cause, times, smooth}});
          if (smooth) all.push_back({name, fmt::format("{} {:2}", kind, times), {std::nullopt, times, smooth}});
        }
        for (int again = 0; again < 4; ++again)
          all.push_back({name, fmt::format("{} nothing", kind), {.smooth_rest = smooth}});
      }
  }
  std::ranges::shuffle(all, random);
  return all;
}

double percent(long part, long whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(std::max(1L, whole));
}

std::string in_words(const Rates& r) {
  std::string words;
  if (r.planted > 0)
    words += fmt::format("of {} planted right {:.1f} %, {:.2f} named; {:.1f} % in the interval  ", r.planted,
                         percent(r.right, r.planted), static_cast<double>(r.members) / static_cast<double>(r.planted),
                         percent(r.covered, r.with_interval));
  if (r.none > 0)
    words += fmt::format("of {} with nothing planted none named {:.1f} %", r.none, percent(r.none_named, r.none));
  return words;
}

int from_environment(const char* name, int usual) { return std::getenv(name) ? std::atoi(std::getenv(name)) : usual; }

TEST(Diagnosis, NamesWhatWasPlantedWithItsSizeAndNothingWhereNothingWas) {
  const int often = from_environment("TOUCHSTONE_PLANTS", 0);
  Random random(static_cast<unsigned>(from_environment("TOUCHSTONE_SEED", 33)));
  std::vector<Drawn> plants = drawn(random, std::max(often, 1));
  constexpr std::size_t of_a_day = 64;
  if (often == 0) plants.resize(of_a_day);
  std::map<std::string, Rates> by_flow, by_kind;
  Rates all;
  for (const Drawn& one : plants) {
    const Flow flow = flow_named(one.flow);
    const Rates rates = rates_of(random, flow, field_of(flow), one.plant);
    by_flow[one.flow] += rates, by_kind[one.kind] += rates, all += rates;
  }
  if (often > 0)
    for (const auto& part : {by_flow, by_kind})
      for (const auto& [name, rates] : part) fmt::print("{:24} {}\n", name, in_words(rates));
  EXPECT_GE(percent(all.right, all.planted), 95) << in_words(all);
  EXPECT_GE(percent(all.covered, all.with_interval), 90) << in_words(all);
  EXPECT_GE(percent(all.none_named, all.none), 95) << in_words(all);
  if (often > 0) {
    EXPECT_LE(percent(all.covered, all.with_interval), 99) << in_words(all);
  }
}

const Explanation& of(const Diagnosis& diagnosis, const std::string& cause) {
  return *std::ranges::find_if(diagnosis.explanations, [&](const Explanation& e) {
    return e.causes[0].cause == cause && (e.causes.size() == 1 || e.causes[1].cause == "noise");
  });
}

TEST(Diagnosis, ListsWhatASteadyParabolaCannotTellApart) {
  const Flow flow = flow_named("poiseuille");
  Changes by;
  by(Cause::viscosity) = 0.05;
  const std::vector<Samples> samples = samples_of(flow, flow.exact[0], by, flow.across / 20);
  const Diagnosis of_end = diagnosed(flow.exact[0], {&samples.back()}, flow.domain, flow.across / 20);
  for (const char* cause : {"viscosity", "force", "amplitude"}) EXPECT_TRUE(of(of_end, cause).named) << of_end.sentence;
  EXPECT_FALSE(of(of_end, "upper wall").named) << of_end.sentence;
  const Diagnosis of_start = diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / 20);
  EXPECT_TRUE(of(of_start, "viscosity").named && !of(of_start, "force").named) << of_start.sentence;
  EXPECT_NEAR(of(of_start, "viscosity").causes[0].value, 5, 1e-3);
}

TEST(Diagnosis, NamesTwoCausesWhereOneDoesNotSuffice) {
  const Flow flow = flow_named("stokes_second");
  Changes by;
  by(Cause::viscosity) = -0.1;
  by(Cause::floor) = 0.5 * flow.across / 40;
  std::vector<Samples> samples = samples_of(flow, flow.exact[0], by, flow.across / 40);
  Random random(1);
  RestOfError rest(random, flow.domain, false, 1e-3);
  for (Samples& s : samples) add(s, norm_of(flow.exact[0], s), rest.at(s.x), 1);
  const Diagnosis found = diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / 40);
  const Explanation& best = found.explanations.front();
  ASSERT_TRUE(best.named && best.causes.size() == 2) << found.sentence;
  EXPECT_NEAR(best.causes[0].value, -10, 3 * best.causes[0].half_width) << found.sentence;
  EXPECT_NEAR(best.causes[1].value, 0.5, 3 * best.causes[1].half_width) << found.sentence;
}

/// Methods of this project, given a flow in which something is wrong, beside the right one: the difference of the two
/// runs, particle by particle, is added to the exact velocities.
struct Ours {
  std::string flow;
  std::map<std::string, double> right, wrong;
  double slip;  // spacings
  std::string cause;
  double value;  // as of the record
};

std::vector<Samples> run_of(const Ours& ours, bool mpm, bool wrong, double spacing, const std::vector<double>& times) {
  const Flow flow = flow_named(ours.flow, Settings(wrong ? ours.wrong : ours.right));
  Scene<Newtonian, Uniform> scene{.domain = flow.domain,
                                  .fluid = flow.fluid,
                                  .filled = flow.filled,
                                  .walls = flow.walls,
                                  .body_force = {flow.drive.amplitude},
                                  .start = flow.start};
  if (wrong && ours.slip > 0)
    for (Wall& wall : scene.walls) wall.velocity = navier_slip(ours.slip * spacing);
  const Method method = mpm ? mpm_affine(scene, times.front()) : sph_transport_velocity(scene, times.front());
  return method.run({.name = "one", .spacing = spacing, .cell = spacing}, {.times = times}).samples;
}

TEST(Diagnosis, NamesWhatIsWrongInRunsOfOurOwn) {
  const std::map<std::string, double> channel{{"H", 1}, {"nu", 0.1}, {"F", 0.1}, {"c", 1}};
  const auto with = [](std::map<std::string, double> set, const std::string& name, double value) {
    set[name] = value;
    return set;
  };
  for (const Ours& ours : {Ours{"shear_wave", {}, {{"Re", 100 / 1.05}}, 0, "viscosity", 5},
                           Ours{"taylor_green", {{"c", 10}}, {{"c", 10}, {"Re", 100 / 1.5}}, 0, "viscosity", 50},
                           Ours{"poiseuille", channel, with(channel, "nu", 0.105), 0, "viscosity", 5},
                           Ours{"poiseuille", channel, with(channel, "F", 0.103), 0, "force", 3},
                           Ours{"poiseuille", channel, channel, 0.3, "slip length", 0.3}})
    for (const bool mpm : {true, false}) {
      if (mpm && ours.slip > 0) continue;  // MPM has no such wall
      const Flow flow = flow_named(ours.flow, Settings(ours.right));
      const std::vector<double> times = ours.flow == "poiseuille" ? std::vector{0.5, 1.0, 2.0} : std::vector{0.05, 0.1};
      const double spacing = flow.across / 20;
      std::vector<Samples> seen = run_of(ours, mpm, false, spacing, times);
      const std::vector<Samples> wrong = run_of(ours, mpm, true, spacing, times);
      const auto by_itself = [&](const std::vector<Samples>& run) {
        return of(diagnosed(flow.exact[0], pointers(run), flow.domain, spacing), ours.cause).causes[0].value;
      };
      const double of_right = by_itself(seen), of_wrong = by_itself(wrong);
      const FieldTruth truth = flow.exact[0].with({});
      for (std::size_t k = 0; k < seen.size(); ++k) {
        seen[k].v = wrong[k].v - seen[k].v;
        for (Eigen::Index p = 0; p < seen[k].size(); ++p) seen[k].v.col(p) += truth(seen[k].x.col(p), seen[k].time);
      }
      const Diagnosis found = diagnosed(flow.exact[0], pointers(seen), flow.domain, spacing);
      const std::string what = fmt::format("{}, {}: {}", ours.flow, mpm ? "MPM" : "SPH", found.sentence);
      if (std::getenv("TOUCHSTONE_PLANTS"))
        fmt::print("{} {} planted: {}; by themselves {:.3g} and without it {:.3g}\n", ours.value, ours.cause, what,
                   of_wrong, of_right);
      EXPECT_TRUE(of(found, ours.cause).named) << what;
      EXPECT_NEAR(of(found, ours.cause).causes[0].value, ours.value, 0.1 * ours.value) << what;
    }
}

/// What is said of the flow's first exact field, changed, on a lattice of so many across; the times are those of the
/// flow.
Diagnosis said_of(const Flow& flow, const std::function<void(Samples&)>& change, int across = 20) {
  std::vector<Samples> samples = samples_of(flow, flow.exact[0], {}, flow.across / across);
  for (Samples& s : samples) change(s), s.pressure = s.v.row(0).transpose().array();
  return diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / across, 0.3);
}
/// What a sentence should hold that does not.
std::string lacks(const Diagnosis& found, const std::vector<std::string>& words) {
  for (const std::string& one : words)
    if (found.sentence.find(one) == found.sentence.npos) return one + " in: " + found.sentence;
  return "";
}
void mirror(Samples& s, const FieldTruth& truth, const Box& box, int axis) {
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    Vec2 x = s.x.col(p);
    x[axis] = box.low[axis] + box.high[axis] - x[axis];
    s.v.col(p) = truth(x, s.time);
    if (axis == 0) s.v(0, p) *= -1;
    if (axis == 1) s.v(1, p) *= -1;
  }
}

TEST(Diagnosis, NamesMistakesOfEachFlow) {
  for (const char* name : {"poiseuille", "couette", "oscillating_poiseuille", "stokes_first", "stokes_second",
                           "taylor_green", "shear_wave", "manufactured", "elliptic_drop", "hydrostatic"}) {
    const Flow flow = flow_named(name);
    const std::string& field = flow.exact[0].field;
    const bool is_pressure = field == "pressure";
    EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v.setZero(); }),
                    {is_pressure ? "there is no pressure" : "the fluid is at rest"}),
              "")
        << name;
    EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v *= -1; }), {"the " + field + " has the wrong sign"}), "")
        << name;
    EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v *= 0.8e-3; }),
                    {fmt::format("the {} is 1000 times too small: {}", field, is_pressure ? "kPa" : "mm/s?"),
                     "of the 20 % that are left"}),
              "")
        << name;
    EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v *= 1e2; }), {"the " + field + " is 100 times too large"}), "")
        << name;
    EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v *= -10; }), {"has the wrong sign and is 10 times too large"}),
              "")
        << name;
    EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v.col(s.size() / 3).array() += 1e3; }), {"one particle, at ("}),
              "")
        << name;
    const Diagnosis in_part = said_of(flow, [](Samples& s) {
      s.v *= -1;
      for (Eigen::Index p = 0; p < s.size(); p += 4) s.v.col(p).setConstant(NAN);
    });
    EXPECT_EQ(lacks(in_part, {"rows hold no number; of the rest, ", "the wrong sign"}), "") << name;
    EXPECT_EQ(said_of(flow, [](Samples& s) { s.v.setConstant(INFINITY); }).sentence,
              "no row of the " + field + " holds a number");
  }
}

TEST(Diagnosis, NamesMistakesOfPlaceAndTime) {
  const Flow couette = flow_named("couette"), patch = flow_named("manufactured"), wave = flow_named("shear_wave"),
             green = flow_named("taylor_green");
  const auto mirrored = [](const Flow& flow, int axis) {
    return [&flow, axis, truth = flow.exact[0].with({})](Samples& s) { mirror(s, truth, flow.domain.box, axis); };
  };
  EXPECT_EQ(lacks(said_of(couette, mirrored(couette, 1)), {"the velocity is mirrored along y"}), "");
  EXPECT_EQ(lacks(said_of(patch, mirrored(patch, 0)), {"the velocity is mirrored along x"}), "");
  const auto shifted = [](const Flow& flow, const Vec2& part) {
    return [&flow, part, truth = flow.exact[0].with({})](Samples& s) {
      for (Eigen::Index p = 0; p < s.size(); ++p)
        s.v.col(p) = truth(s.x.col(p) - part.cwiseProduct(flow.domain.box.size()), s.time);
    };
  };
  EXPECT_EQ(lacks(said_of(patch, shifted(patch, {0.5, 0})), {"shifted by half of the box along x"}), "");
  EXPECT_EQ(lacks(said_of(green, shifted(green, {0.25, 0.25})), {"shifted by a quarter of the box along x and y"}), "");
  EXPECT_EQ(lacks(said_of(wave, shifted(wave, {0, 0.5})),
                  {"the velocity has the wrong sign",
                   "; or, indistinguishable by these data: ", "shifted by half of the box along y"}),
            "");
  EXPECT_EQ(
      lacks(said_of(patch, [](Samples& s) { s.v = s.v.colwise().reverse().eval(); }), {"v_x and v_y are swapped"}), "");
  EXPECT_EQ(lacks(said_of(patch, [](Samples& s) { s.v.row(1) *= -1; }), {"v_y has the wrong sign"}), "");
  const auto at = [](const Flow& flow, const auto& time) {
    return [time, truth = flow.exact[0].with({})](Samples& s) {
      for (Eigen::Index p = 0; p < s.size(); ++p) s.v.col(p) = truth(s.x.col(p), time(s.time));
    };
  };
  const std::vector<double>& times = couette.judged.times;
  EXPECT_EQ(lacks(said_of(couette, at(couette,
                                      [&](double t) {
                                        const auto found = std::ranges::find(times, t);
                                        return found == times.begin() ? 0.0 : *(found - 1);
                                      })),
                  {"the velocity is one output late"}),
            "");
  EXPECT_EQ(lacks(said_of(wave, at(wave, [](double) { return 0.0; })), {"is that of the start: nothing changes"}), "");
}

/// A change that shows another field at the places and times of samples.
std::function<void(Samples&)> shows(const std::function<Vec2(const Vec2& x, double t)>& field) {
  return [=](Samples& s) {
    for (Eigen::Index p = 0; p < s.size(); ++p) s.v.col(p) = field(s.x.col(p), s.time);
  };
}
FieldTruth truth_with(const Flow& flow, Cause cause, double value) {
  Changes by;
  by(cause) = value;
  return flow.exact[0].with(by);
}

TEST(Diagnosis, NamesAnyFactor) {
  const Flow flow = flow_named("poiseuille");
  for (const auto& [factor, words] :
       {std::pair(20., "the velocity is 20.0"), {60., "the velocity is 60.0"}, {8., "the velocity is 8.0"},
        {1 / 7., "times too weak"}, {-3., "the velocity has the wrong sign and is 3 times too large"}})
    EXPECT_EQ(lacks(said_of(flow, [by = factor](Samples& s) { s.v *= by; }), {words}), "");
  for (const double factor : {10., 100., 1000., 0.1}) {
    const Diagnosis found = said_of(flow, shows(truth_with(flow, Cause::viscosity, factor - 1)));
    EXPECT_EQ(lacks(found, {"the flow is that of a fluid ", factor > 1 ? "times too viscous" : "times less viscous"}), "");
    EXPECT_EQ(found.sentence.find("indistinguishable"), std::string::npos) << found.sentence;
  }
  EXPECT_EQ(lacks(said_of(flow, [](Samples& s) { s.v = s.v.colwise().reverse().eval(); }), {"v_x and v_y are swapped"}),
            "");
  EXPECT_EQ(lacks(said_of(flow_named("hydrostatic"), [](Samples& s) { s.v.row(0).array() += 101325; }),
                  {"is added everywhere (that of the air, 101325 Pa?)"}),
            "");
}

TEST(Diagnosis, NamesWhatIsExactBeforeWhatIsNearly) {
  const Flow flow = flow_named("poiseuille");
  EXPECT_EQ(lacks(said_of(flow, shows([truth = flow.exact[0].with({})](const Vec2& x, double t) {
                            return truth(x, 2 * t);
                          })),
                  {"the clock of the velocity runs twice as fast as it should"}),
            "");
  EXPECT_EQ(lacks(said_of(flow, shows([truth = flow.exact[0].with({})](const Vec2& x, double t) {
                            return truth(x, t == 0.1 ? 0.09 : t);
                          })),
                  {"only at 0.1 s is there an error: the flow is 0.010", " s late"}),
            "");
  Changes by;
  by(Cause::viscosity) = 0.06, by(Cause::force) = 0.1;
  EXPECT_EQ(lacks(said_of(flow, shows(flow.exact[0].with(by))), {"6.0", "too viscous and", "10.0", "too strong"}), "");
}

TEST(Diagnosis, KnowsThePhaseOfWhatHasAlwaysOscillated) {
  for (const char* name : {"oscillating_poiseuille", "stokes_second"}) {
    const Flow flow = flow_named(name);
    const double period = flow.exact[0].period;
    EXPECT_EQ(lacks(said_of(flow, shows([=, truth = flow.exact[0].with({})](const Vec2& x, double t) {
                              return truth(x, t - period / 4);
                            })),
                    {fmt::format("the flow is {:.4f}", period / 4), "s late"}),
              "")
        << name;
  }
}

TEST(Diagnosis, NamesFlowsThatWereComputedInstead) {
  for (const char* name : {"poiseuille", "couette", "stokes_first"}) {
    Flow flow = flow_named(name);
    if (flow.name == "stokes_first") flow.judged.times = {0.2};
    ASSERT_FALSE(flow.exact[0].instead.empty());
    for (const Instead& one : flow.exact[0].instead)
      EXPECT_EQ(lacks(said_of(flow, shows(one.truth)), {one.sentence}), "") << name;
  }
}

TEST(Diagnosis, FindsWallsFarInWithFluidAtRestBehindThem) {
  const Flow flow = flow_named("poiseuille");
  for (const double spacings : {0.4, 0.8, 1.6}) {
    const double in = spacings * flow.across / 20, H = flow.across;
    const auto inner = flow_named("poiseuille", Settings({{"H", H - 2 * in}})).exact[0].with({});
    EXPECT_EQ(lacks(said_of(flow, shows([=](const Vec2& x, double t) -> Vec2 {
                              const double y = x.y() - in;
                              return y < 0 || y > H - 2 * in ? Vec2(0, 0) : inner({x.x(), y}, t);
                            })),
                    {fmt::format("both walls stand {:.1f}", spacings), "too far in"}),
              "");
  }
}

/// The velocity near a plate along which the fluid slips is that of the oracle: no slope but b dv/dn is left there.
TEST(Diagnosis, FindsASlipLengthInMetresAtAllResolutions) {
  for (const char* name : {"poiseuille", "couette"}) {
    const Flow flow = flow_named(name);
    const double b = 0.03 * flow.across, t = flow.judged.times[0], d = 1e-5 * flow.across;
    const FieldTruth truth = truth_with(flow, Cause::slip, b);
    const auto v = [&](double y) { return truth({0, y}, t).x(); };
    EXPECT_NEAR(v(0), b * (v(d) - v(0)) / d, 1e-3 * v(0)) << name;
    EXPECT_NEAR(v(flow.across), flow.exact[0].with({})({0, flow.across}, t).x() -
                                    b * (v(flow.across) - v(flow.across - d)) / d,
                1e-3 * v(flow.across))
        << name;
    std::vector<std::vector<Samples>> runs;
    std::vector<Diagnosed> levels;
    for (const int across : {12, 24, 48}) {
      Changes by;
      by(Cause::slip) = b;
      runs.push_back(samples_of(flow, flow.exact[0], by, flow.across / across));
      levels.push_back({pointers(runs.back()), flow.across / across});
    }
    for (const Diagnosis& found : diagnose(flow.exact[0], levels, flow.domain))
      EXPECT_EQ(lacks(found, {"slip length of ", "(at all resolutions 0.000030"}), "") << name;
  }
}

TEST(Diagnosis, HearsTheOtherFieldsOfAFlow) {
  const Flow flow = flow_named("taylor_green");
  std::vector<Samples> samples = samples_of(flow, flow.exact[0], {}, flow.across / 24);
  for (Samples& s : samples)
    for (Eigen::Index p = 0; p < s.size(); ++p)
      s.pressure[p] = 1.1 * flow.exact[1].with({})(s.x.col(p), s.time).x();
  samples.erase(samples.begin());
  const auto of_pressure = [&](const std::vector<const Exact*>& others) {
    return diagnose(flow.exact[1], {{pointers(samples), flow.across / 24}}, flow.domain, 0.3, others).at(0);
  };
  EXPECT_TRUE(of(of_pressure({}), "viscosity").named);
  EXPECT_FALSE(of(of_pressure({&flow.exact[0]}), "viscosity").named);
  EXPECT_TRUE(of(of_pressure({&flow.exact[0]}), "amplitude").named);
}

TEST(Diagnosis, SaysThatAForceIsTwiceOrHalf) {
  const Flow flow = flow_named("poiseuille");
  for (const auto& [by, words] : {std::pair(1.0, "(doubled)"), std::pair(-0.5, "(halved)")}) {
    Changes wrong;
    wrong(Cause::force) = by;
    const std::vector<Samples> samples = samples_of(flow, flow.exact[0], wrong, flow.across / 40);
    const Diagnosis found = diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / 40, 0.3);
    EXPECT_TRUE(of(found, "force").named) << found.sentence;
    EXPECT_EQ(lacks(found, {words}), "");
  }
}

TEST(Diagnosis, NamesNoiseWithTheCauseBesideIt) {
  const Flow flow = flow_named("poiseuille");
  Changes by;
  by(Cause::viscosity) = 0.03;
  std::vector<Samples> samples = samples_of(flow, flow.exact[0], by, flow.across / 40);
  Random random(3);
  RestOfError noise(random, flow.domain, false, 0.01);
  for (Samples& s : samples) add(s, norm_of(flow.exact[0], s), noise.at(s.x), 1);
  const Diagnosis found = diagnosed(flow.exact[0], {&samples.back()}, flow.domain, flow.across / 40, 0.3);
  const Explanation viscosity = of(found, "viscosity");
  ASSERT_TRUE(viscosity.named && viscosity.causes.size() == 2) << found.sentence;
  EXPECT_NEAR(viscosity.causes[0].value, 3, viscosity.causes[0].half_width);
  EXPECT_NEAR(viscosity.causes[1].value, 1, 3 * viscosity.causes[1].half_width);
  EXPECT_EQ(lacks(found, {"too viscous", ", with noise of "}), "");
}

TEST(Diagnosis, SaysWhereAnErrorLiesThatNothingExplains) {
  const Flow channel = flow_named("poiseuille"), square = flow_named("taylor_green");
  const auto where = [](const Flow& flow, const std::function<bool(const Vec2&)>& is_there) {
    return said_of(flow, [&](Samples& s) {
      const double v = s.v.cwiseAbs().maxCoeff();
      for (Eigen::Index p = 0; p < s.size(); ++p)
        if (is_there(s.x.col(p) / flow.across)) s.v(0, p) += (p % 2 == 0 ? 0.3 : -0.2) * v;
    });
  };
  EXPECT_EQ(lacks(where(channel, [](const Vec2& x) { return x.y() < 0.1; }), {"within 2 spacings of the lower wall"}),
            "");
  EXPECT_EQ(lacks(where(channel, [](const Vec2& x) { return x.y() > 0.9; }), {"within 2 spacings of the upper wall"}),
            "");
  EXPECT_EQ(
      lacks(where(channel, [](const Vec2& x) { return x.y() < 0.05 || x.y() > 0.95; }), {"of the lower or upper wall"}),
      "");
  EXPECT_EQ(lacks(where(channel, [](const Vec2& x) { return std::abs(x.y() - 0.5) < 0.2; }), {"in the core"}), "");
  EXPECT_EQ(lacks(where(square, [](const Vec2& x) { return x.x() > 0.95; }), {"the seam of the periodic box along x"}),
            "");
}

TEST(Diagnosis, OffersNothingThatDiscretisationMayMake) {
  const Flow flow = flow_named("shear_wave");
  Changes by;
  by(Cause::viscosity) = -0.0057;  // as central differences on 24 cells
  const std::vector<Samples> samples = samples_of(flow, flow.exact[0], by, flow.across / 24);
  const Diagnosis found = diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / 24, 0.3);
  EXPECT_EQ(found.sentence,
            "the error of the velocity is no more than discretisation may make at this resolution: finer ones tell");
  for (const Explanation& one : found.explanations) EXPECT_FALSE(one.named) << one.sentence;
  // a parabola the other way is not made by it
  const Flow couette = flow_named("couette");
  const Diagnosis other = said_of(couette, [&](Samples& s) {
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      const double y = s.x(1, p) / couette.across;
      s.v(0, p) = -1e-3 * y * (1 - y);
    }
  });
  EXPECT_EQ(lacks(other, {"none of the known causes explains"}), "");
}

TEST(Diagnosis, SaysThatThereIsNoErrorOrNoFlow) {
  const Flow flow = flow_named("poiseuille");
  std::vector<Samples> samples = samples_of(flow, flow.exact[0], {}, flow.across / 20);
  EXPECT_EQ(diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / 20).sentence,
            "the velocity has no error to speak of");
  Changes by;
  by(Cause::viscosity) = 0.1;
  const std::vector<Samples> few = samples_of(flow, flow.exact[0], by, flow.across / 4);
  EXPECT_EQ(diagnosed(flow.exact[0], pointers(few), flow.domain, flow.across / 4).sentence,
            "32 numbers of the velocity are too few for a diagnosis");
  for (Samples& s : samples) s.time = 0;
  EXPECT_EQ(diagnosed(flow.exact[0], pointers(samples), flow.domain, flow.across / 20).sentence,
            "the velocity is zero at all these times");
}

}  // namespace
}  // namespace touchstone::vnv::doors
