/// Fields of no sense are judged: at rest, reversed, scaled, noise, wild rows, constants, no numbers. None ends a
/// judgement. The day's test draws few; TOUCHSTONE_FIELDS=100000 draws so many, by TOUCHSTONE_SEED.

#include "vnv/doors/judge.hpp"
#include "vnv/doors/right_data.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <random>

namespace touchstone::vnv::doors {
namespace random_fields_test {

using Generator = std::mt19937_64;

double between(Generator& random, double low, double high) { return std::uniform_real_distribution(low, high)(random); }
int one_of(Generator& random, int count) { return std::uniform_int_distribution(0, count - 1)(random); }

enum class Kind_of_field { exact, rest, reversed, scaled, noise, wild_rows, constant, no_numbers, mirrored, frozen };
constexpr int kinds_of_field = 10;

void spoil(Generator& random, Kind_of_field kind, double factor, const Flow& flow, Samples& s) {
  const Eigen::Index n = s.size();
  std::normal_distribution<double> normal;
  const double v = std::max(1e-6, s.v.cwiseAbs().maxCoeff()), p = std::max(1e-6, s.pressure.abs().maxCoeff());
  const auto each = [&](double part, const auto& work) {
    for (Eigen::Index i = 0; i < n; ++i)
      if (between(random, 0, 1) < part) work(i);
  };
  switch (kind) {
    case Kind_of_field::exact:
      break;
    case Kind_of_field::rest:
      s.v.setZero(), s.pressure.setZero();
      break;
    case Kind_of_field::reversed:
      s.v *= -1, s.pressure *= -1;
      break;
    case Kind_of_field::scaled:
      s.v *= factor, s.pressure *= factor;
      break;
    case Kind_of_field::noise:
      each(1, [&](Eigen::Index i) {
        s.v.col(i) += factor * v * Vec2(normal(random), normal(random));
        s.pressure[i] += factor * p * normal(random);
      });
      break;
    case Kind_of_field::wild_rows:
      each(0.01, [&](Eigen::Index i) { s.v.col(i).setConstant(std::pow(10, between(random, -300, 300))); });
      each(0.01, [&](Eigen::Index i) { s.pressure[i] = -std::pow(10, between(random, -300, 300)); });
      break;
    case Kind_of_field::constant:
      s.v.setConstant(factor * v), s.pressure.setConstant(factor * p);
      break;
    case Kind_of_field::no_numbers:
      each(between(random, 0, 1.2), [&](Eigen::Index i) { s.v.col(i).setConstant(NAN); });
      each(between(random, 0, 1.2), [&](Eigen::Index i) { s.pressure[i] = one_of(random, 2) ? INFINITY : NAN; });
      break;
    case Kind_of_field::mirrored:
      s.v = s.v.rowwise().reverse().eval(), s.pressure = s.pressure.reverse().eval();
      break;
    case Kind_of_field::frozen: {
      const Samples start = right_of(flow, flow.across / std::sqrt(flow.filled_area() / static_cast<double>(n)), 0);
      if (start.size() == n) s.v = start.v, s.pressure = start.pressure;
    }
  }
}

/// Whether an error of the velocity has to fail: the flow has an exact one, which at these times is something.
bool is_visible(Kind_of_field kind, double factor, const Flow& flow) {
  if (flow.exact.empty() || flow.exact.front().field != "velocity") return false;
  return kind == Kind_of_field::rest || kind == Kind_of_field::reversed || kind == Kind_of_field::no_numbers ||
         (kind == Kind_of_field::scaled && std::abs(factor - 1) > 0.05) ||
         (kind == Kind_of_field::noise && factor > 0.05);
}

TEST(RandomFields, AreJudgedWithoutEndingTheJudgement) {
  const char* many = std::getenv("TOUCHSTONE_FIELDS");
  const char* seed = std::getenv("TOUCHSTONE_SEED");
  const int count = many ? std::atoi(many) : 420;
  Generator random(seed ? static_cast<unsigned>(std::atoi(seed)) : 7);
  const std::vector<std::string> names = flow_names();
  std::vector<Flow> flows;
  for (const std::string& name : names) flows.push_back(flow_named(name));
  double longest = 0;
  for (int k = 0; k < count; ++k) {
    const Flow& flow = flows[static_cast<std::size_t>(k) % flows.size()];
    const auto kind = static_cast<Kind_of_field>(one_of(random, kinds_of_field));
    const double factor = std::pow(10, between(random, -6, 6));
    const int levels = 1 + one_of(random, many ? 5 : 3), coarsest = 4 + one_of(random, 8);
    Given given{.fields = std::vector<std::string>{"velocity", velocity_along_x, "pressure", "particles"}};
    Eigen::Index rows = 0;
    for (int level = 0; level < levels; ++level) {
      GivenLevel one{.spacing = flow.across / std::round(coarsest * std::pow(1.4, level))};
      for (const double time : flow.judged.times) {
        Samples s = right_of(flow, flow.across / one.spacing, time);
        spoil(random, kind, factor, flow, s);
        rows += s.size();
        one.at.emplace(time, std::move(s));
      }
      given.levels.push_back(std::move(one));
    }
    const std::string what = fmt::format("{}, kind {}, factor {:g}, {} levels from {} across", flow.name,
                                         static_cast<int>(kind), factor, levels, coarsest);
    const std::clock_t begin = std::clock();  // of this process: other load is no judgement's
    try {
      const Judgement judgement =
          judge_given(flow, std::move(given), {.at_most = 1, .diagnose = one_of(random, 2) == 1});
      const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      longest = std::max(longest, taken / std::max(1.0, static_cast<double>(rows) / 1e4));
      EXPECT_FALSE(judgement.record.verdicts.empty()) << what;
      EXPECT_EQ(record_in(as_json(judgement.record), "as written").verdicts.size(), judgement.record.verdicts.size())
          << what;
      if (is_visible(kind, factor, flow)) {
        EXPECT_TRUE(std::ranges::any_of(judgement.record.verdicts, [](const Verdict& v) {
          return v.outcome == Outcome::fails;
        })) << what;
      }
      for (const Exact& exact : flow.exact)
        if (std::ranges::any_of(judgement.record.verdicts, [&](const Verdict& v) {
              return v.outcome == Outcome::fails && std::ranges::find(exact.norms, v.quantity) != exact.norms.end();
            })) {
          EXPECT_NE(std::ranges::find(judgement.record.diagnoses, exact.field, &Diagnosis::field),
                    judgement.record.diagnoses.end())
              << what;
        }
      for (const Diagnosis& one : judgement.record.diagnoses) {
        EXPECT_FALSE(one.sentence.empty()) << what;
        EXPECT_EQ(one.sentence.find("no diagnosis"), one.sentence.npos) << what << ": " << one.sentence;
        for (const Explanation& explanation : one.explanations)
          for (const FittedCause& cause : explanation.causes)
            if (explanation.named) {
              EXPECT_LE(cause.half_width, std::abs(cause.value)) << what << ": " << one.sentence;
            }
      }
    } catch (const std::exception& error) {
      ADD_FAILURE() << what << ": " << error.what();
    }
  }
  constexpr double most = 1;  // s  of the CPU for each 10 000 rows, or fewer
  EXPECT_LT(longest, most);
  if (many) fmt::print("{} fields: at most {:.2f} s for 10000 rows\n", count, longest);
}

}  // namespace random_fields_test
}  // namespace touchstone::vnv::doors
