#include "vnv/gate/error_against_time.hpp"

#include "vnv/gate/compare_values.hpp"
#include "vnv/record/median.hpp"
#include "vnv/record/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::gate {
namespace {

using vnv::Value, vnv::Record, vnv::RunSummary, vnv::WorkPoint;

/// The first that is more than rounding.
std::string error_drawn(const Records& records, const std::string& case_name) {
  for (const Record& record : records)
    if (record.case_name == case_name)
      for (const Value& error : record.values)
        if (kind_of(error.quantity.kind) == Kind::error && std::abs(error.value) > rounding_of_zero)
          return error.quantity.heading();
  return "";
}

double last_value(const Record& record, const std::string& level, const std::string& quantity) {
  double value = vnv::not_a_number;
  for (const Value& error : record.values)  // in the order of time
    if (error.level == level && error.quantity.heading() == quantity) value = error.value;
  return value;
}

vnv::Resource resource_of(const Record& record) {
  return record.runs.empty() ? vnv::Resource::cpu : record.runs.front().cost.resource;
}

/// Each resource has a figure of its own.
std::string figure_of(const Record& record) {
  const vnv::Resource of = resource_of(record);
  const std::string heading = vnv::heading_of(of);  // "GPU time [s]"
  return record.case_name + (of == vnv::Resource::cpu ? "" : "_" + heading.substr(0, heading.find(' ')));
}

/// Over all runs of the program [s].
double median_time(const std::vector<Records>& runs, const Record& method, const std::string& level) {
  std::vector<double> times;
  for (const Records& records : runs)
    for (const Record& record : records)
      for (const RunSummary& run : record.runs)
        if (are_of_one_method(record, method) && run.level == level)
          times.push_back(run.cost.spent());
  return vnv::median(times);
}

vnv::Curve curve_of(const Record& record, const std::vector<Records>& runs, const std::string& quantity,
                    std::string_view side) {
  std::vector<WorkPoint> points;
  for (const RunSummary& run : record.runs)
    if (run.finished)
      points.push_back({.run = run.level,
                        .error = last_value(record, run.level, quantity),
                        .cpu = median_time(runs, record, run.level)});
  vnv::Curve curve{figure_of(record), fmt::format("{}, {}", record.method, side), vnv::Role::ours, {}, {}};
  for (const WorkPoint& point : vnv::pareto_front(points)) {
    curve.x.push_back(point.cpu);
    curve.y.push_back(point.error);
  }
  return curve;
}

vnv::Figure frame_of(const Record& record, const std::string& quantity) {
  return {.id = figure_of(record),
          .title = record.case_name,
          .caption = "The runs that no other beats in both error and time; lower left is better.",
          .x = {.label = vnv::heading_of(resource_of(record)), .logarithmic = true},
          .y = {.label = quantity, .logarithmic = true}};
}

}  // namespace

vnv::Record error_against_time(const std::vector<Records>& before, const std::vector<Records>& after) {
  Record front;
  front.case_name = "gate";
  front.title = "Work-precision diagram, before and after";
  front.method = "gate";
  if (!before.empty() && !before.front().empty()) front.suite = before.front().front().suite;
  const auto add = [&](const std::vector<Records>& runs, std::string_view side) {
    for (const Record& record : runs.empty() ? Records{} : runs.front()) {
      const std::string quantity = error_drawn(runs.front(), record.case_name);
      vnv::Curve curve = curve_of(record, runs, quantity, side);
      if (curve.x.empty()) continue;
      if (std::ranges::find(front.figures, curve.figure, &vnv::Figure::id) == front.figures.end())
        front.figures.push_back(frame_of(record, quantity));
      front.curves.push_back(std::move(curve));
    }
  };
  add(before, "before");
  add(after, "after");
  return front;
}

}  // namespace touchstone::gate
