#include "vnv/harness/measurements.hpp"

#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

namespace touchstone::vnv {
namespace {

constexpr std::size_t most = 40;  // lines of one test

std::string escaped(const std::string& text) {
  static const std::map<char, std::string> entities{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string xml;
  for (const char letter : text) xml += entities.contains(letter) ? entities.at(letter) : std::string(1, letter);
  return xml;
}

/// Lines of different names, as many as fit; a dashboard keeps one number of a name.
class Lines {
 public:
  void add(const std::string& name, double value) {
    if (names_.size() == most || !std::isfinite(value) || !names_.insert(name).second) return;
    text_ += fmt::format("<CTestMeasurement type=\"numeric/double\" name=\"{}\">{:.9g}</CTestMeasurement>\n",
                         escaped(name), value);
  }
  const std::string& text() const { return text_; }

 private:
  std::set<std::string> names_;
  std::string text_;
};

std::string at(double time) { return std::isnan(time) ? "" : fmt::format(", {:.4g} s", time); }

void add_orders(const Record& record, Lines& lines) {
  for (const ObservedOrder& order : record.orders)
    if (order.errors.size() > 2)
      lines.add(fmt::format("order of {} over {}{}", with_heading(order.quantity).name, order.ladder, at(order.time)),
                order.order);
}

void add_cost(const Record& record, Lines& lines) {
  const auto dearest = std::ranges::max_element(record.runs, {}, [](const RunSummary& run) { return run.cost.cpu; });
  if (dearest == record.runs.end()) return;
  lines.add("CPU [s], " + dearest->level, dearest->cost.cpu);
  lines.add("particle-steps per second, " + dearest->level, dearest->cost.particle_steps_per_second());
  lines.add("peak memory [MB], " + dearest->level, dearest->cost.peak_memory / 1e6);
}

/// Those that fail first, then those with the smallest fraction of their limit left; what counts has none.
void add_judged(const Record& record, Lines& lines) {
  std::vector<Verdict> judged = record.verdicts;
  std::erase_if(judged, [](const Verdict& v) { return v.margin == 0 && v.outcome == Outcome::holds; });
  std::ranges::stable_sort(judged, {}, [](const Verdict& v) { return std::isnan(v.margin) ? -INFINITY : v.margin; });
  for (const Verdict& v : judged) {
    const std::string unit = v.unit.empty() ? "" : fmt::format(" [{}]", v.unit),
                      level = v.level.empty() ? "" : ", " + v.level;
    lines.add(v.quantity + unit + level + at(v.time), v.value);
  }
}

}  // namespace

std::string measurement_lines(const Record& record) {
  Lines lines;
  add_cost(record, lines);
  add_orders(record, lines);
  add_judged(record, lines);
  return lines.text();
}

bool is_run_for_dashboard() { return std::getenv("DASHBOARD_TEST_FROM_CTEST") != nullptr; }

}  // namespace touchstone::vnv
