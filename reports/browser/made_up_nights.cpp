/// made_up_nights RECORDS HISTORY NIGHTS CASES: records of a last night with so many made-up cases, 200 baselines each,
/// the nights before it, and RECORDS/faults.csv, what tests noticed of a hundred made-up faults; to see pages, and
/// to measure how large they are and how soon they open.

#include "reports/read/night.hpp"
#include "reports/testing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <random>

namespace {

using namespace touchstone;
using namespace touchstone::reports;

constexpr long levels = 8, methods = 5;
/// The browser would miss a picture, or say that a script fails, if a page took this for more than text.
constexpr std::string_view hostile =
    R"("'> <img src=none.png> <script>throw Error("text")</script> `x` </title> &amp;)";
const std::vector<vnv::Quantity> norms{{"L2 v_x, row means", "%", vnv::Kind::norm},
                                       {"Linf v_x, row means", "%", vnv::Kind::norm},
                                       {"L2 v_x, per particle", "%", vnv::Kind::norm},
                                       {"Linf v_x, per particle", "%", vnv::Kind::norm},
                                       {"kinetic energy off", "%", vnv::Kind::deviation}};

/// Errors of second order; a method of the third case gets worse in the night before last, one of the second fails
/// last.
double error_of(long c, long m, long level, std::size_t norm, long nights_left) {
  const double worse = c == 2 && m == 1 && nights_left < 2 ? 1.08 : c == 1 && m == 0 && nights_left < 1 ? 3 : 1;
  return worse * static_cast<double>(1 + c + m) * static_cast<double>(1 + norm) / std::pow(4, level);
}

vnv::Verdict verdict(const vnv::Record& record, const vnv::Value& e, double lower, double upper,
                     const std::string& author) {
  const bool holds = e.value <= upper;
  vnv::Verdict v = sample_verdict(holds ? vnv::Outcome::holds : vnv::Outcome::fails, (upper - e.value) / upper);
  v.case_name = record.case_name;
  v.method = record.method;
  v.level = e.level;
  v.spacing = e.spacing;
  v.time = e.time;
  v.quantity = e.quantity.name;
  v.unit = e.quantity.unit;
  v.value = e.value;
  v.lower = lower;
  v.upper = upper;
  v.author = author;
  v.sentence = fmt::format("{}.{} {}: {} = {:.4g} %, limit {:.4g} %: {}", v.case_name, v.method, v.level, v.quantity,
                           v.value, upper, holds ? "HOLDS" : "FAILS");
  return v;
}

void add_level(vnv::Record& record, long c, long m, long level, long nights_left, std::mt19937& noise) {
  const std::string name = fmt::format("M{}", level + 1);
  const double spacing = 1e-4 / std::pow(2, level);
  for (std::size_t norm = 0; norm < norms.size(); ++norm) {
    const double usual = error_of(c, m, level, norm, 99);
    const vnv::Value e{name, spacing, 1, norms[norm], error_of(c, m, level, norm, nights_left)};
    record.values.push_back(e);
    record.verdicts.push_back(verdict(record, e, 0.97 * usual, 1.03 * usual, "baseline: made up"));
    if (norm == 0)
      record.verdicts.push_back(verdict(record, e, 0, 1.5 * usual, fmt::format("literature: made up {}", hostile)));
  }
  const double cpu = 0.01 * std::pow(4, level) * std::normal_distribution(nights_left < 5 ? 0.8 : 1.0, 0.017)(noise);
  vnv::RunSummary run = sample_run(name, cpu);
  run.spacing = spacing;
  run.time_step = 1e-6;
  run.cost.particles = 100L << (2 * level);
  run.cost.steps = 10000;
  run.cost.wall = cpu;
  run.cost.peak_memory = 1e7 * std::pow(2, level);
  record.runs.push_back(run);
}

vnv::Record record_of(long c, long m, long nights_left, std::mt19937& noise) {
  vnv::Record record = sample_record(fmt::format("method_{}", m + 1));
  record.case_name = fmt::format("case_{}", c + 1);
  record.title = fmt::format("Made-up flow number {} {}", c + 1, c == 2 ? hostile : "");
  record.description = fmt::format("A flow that nobody has run. {}", hostile);
  record.method_description = hostile;
  record.suite = "nightly";
  record.revision = fmt::format("{:07x}", 0xbbb2d82 - 4099 * nights_left);
  record.compiler = "GNU 12.2";
  record.flags = "-O3";
  record.machine = fmt::format("a machine, 2 processors {}", hostile);
  record.finished_at = fmt::format("2026-{:02}-{:02}T04:00:00Z", nights_left < 22 ? 11 : 10,
                                   nights_left < 22 ? 22 - nights_left : 53 - nights_left);
  record.verdicts.clear();
  for (long level = 0; level < levels; ++level) add_level(record, c, m, level, nights_left, noise);
  for (const auto& norm : {norms[0], norms[1]}) record.orders.push_back(sample_order(norm.heading(), 1, levels));
  return record;
}

std::vector<CaseRecords> night(long cases, long nights_left, std::mt19937& noise) {
  std::vector<CaseRecords> all;
  for (long c = 0; c < cases; ++c) {
    all.push_back({fmt::format("case_{}", c + 1), {}});
    for (long m = 0; m < methods; ++m) all.back().records.push_back(record_of(c, m, nights_left, noise));
  }
  return all;
}

/// A fault that survives, and others that one test after the other notices, each by less than the one before.
std::string made_up_faults() {
  std::string csv =
      "# machine: a machine, 2 processors\n# tests: all\n# untried: 2\n"
      "fault,title,files,conclusion,why,test,noticed,margin [-],sentence,revision,tried at,digest\n";
  for (int k = 0; k < 100; ++k)
    for (int test = k / 3; test < k / 3 + 8; ++test)
      csv += fmt::format(
          "fault_{0},\"Something, number {0}, is wrong in a solver or its exact solution\",solver.hpp,{1},,"
          "case_{2}.method_{3},{4},{5},made up,{6:07x},2026-11-{7:02}T04:00:00Z,00ff\n",
          k, k == 0 ? "survived" : "noticed", test / 5 + 1, test % 5 + 1, k > test / 2 ? "yes" : "no",
          k > test / 2 ? -std::exp(4 - test / 5.0) : 0.5, 0xabc0000 + k / 10, k / 10 + 1);
  return csv;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 5) throw std::runtime_error("usage: made_up_nights RECORDS HISTORY NIGHTS CASES");
  const std::filesystem::path records = arguments[1], history = arguments[2];
  const long nights = std::stol(arguments[3]), cases = std::stol(arguments[4]);
  if (nights < 1 || nights > 50) throw std::runtime_error("NIGHTS: expected 1 to 50");
  std::filesystem::create_directories(records);
  std::mt19937 noise;
  for (long left = nights; left-- > 1;) write_night(night_of(night(cases, left, noise)), history);
  for (const CaseRecords& all : night(cases, 0, noise))
    for (const vnv::Record& record : all.records)
      write(record, records / fmt::format("{}.{}.json", record.case_name, record.method));
  std::ofstream(records / "faults.csv") << made_up_faults();
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  fmt::print(stderr, "made_up_nights: {}\n", error.what());
  return EXIT_FAILURE;
}
