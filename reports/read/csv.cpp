#include "reports/read/csv.hpp"

#include "reports/text/notation.hpp"

namespace touchstone::reports {
namespace {

std::string number(double value) { return plain(value, 6); }
std::string number_or_empty(double value) { return plain_or_empty(value, 6); }

std::string verdict_line(const vnv::Record&, const vnv::Verdict& v) {
  return csv_line({v.case_name, v.method, v.level, number_or_empty(v.spacing), number_or_empty(v.time),
                   with_unit(v.quantity, v.unit), number(v.value), limit(v.lower, v.upper), v.author, word(v.outcome)});
}

std::string value_line(const vnv::Record& record, const vnv::Value& v) {
  return csv_line({record.case_name, record.method, v.level, number(v.spacing), number_or_empty(v.time),
                   v.quantity.heading(), number(v.value)});
}

std::string order_line(const vnv::Record& record, const vnv::ObservedOrder& o) {
  const bool has_levels = !o.spacings.empty() && !o.errors.empty();
  return csv_line({record.case_name, record.method, o.ladder, o.quantity, number(o.time),
                   std::to_string(o.errors.size()), has_levels ? number(o.spacings.back()) : "",
                   has_levels ? number(o.errors.back()) : "", number(o.order), number(o.half_width),
                   word(o.trend), o.asymptotic ? "yes" : "no", number_or_empty(o.floor),
                   number_or_empty(o.floor_half_width), number_or_empty(o.order_to_floor),
                   number_or_empty(o.order_to_floor_half_width)});
}

std::string cost_line(const vnv::Record& record, const vnv::RunSummary& run) {
  const vnv::Cost& c = run.cost;
  return csv_line({record.case_name, record.method, run.level, std::to_string(c.particles), std::to_string(c.steps),
                   number(c.cpu), number(c.cpu_lowest), number(c.cpu_highest), std::to_string(c.repeats),
                   number(c.wall), number_or_empty(100 * c.harness_share()), number(c.peak_memory / 1e6),
                   number_or_empty(c.per_particle_step() * 1e9), word(c.resource), number(c.spent()),
                   vnv::one_machine(record)});
}

/// A heading, and a line of each item of all records.
std::string table(const std::vector<CaseRecords>& cases, auto items, const auto& line, std::string heading) {
  for_each(cases, items, [&](const auto& record, const auto& item) { heading += line(record, item); });
  return heading;
}

}  // namespace

std::string verdicts_csv(const std::vector<CaseRecords>& cases) {
  return table(cases, &vnv::Record::verdicts, verdict_line,
               "case,method,level,spacing [m],time [s],quantity,value,limit,author,verdict\n");
}

std::string values_csv(const std::vector<CaseRecords>& cases) {
  return table(cases, &vnv::Record::values, value_line, "case,method,level,spacing [m],time [s],quantity,value\n");
}

std::string orders_csv(const std::vector<CaseRecords>& cases) {
  return table(
      cases, &vnv::Record::orders, order_line,
      "case,method,ladder,quantity,time [s],spacings,finest spacing [m],finest error,order,half-width,trend,asymptotic,floor,half-width of floor,order to floor,half-width of order to floor\n");
}

std::string cost_csv(const std::vector<CaseRecords>& cases) {
  return table(
      cases, &vnv::Record::runs, cost_line,
      "case,method,level,particles,steps,cpu [s],lowest cpu [s],highest cpu [s],runs,wall [s],harness [%],peak memory [MB],ns per particle-step,resource,time of resource [s],machine\n");
}

}  // namespace touchstone::reports
