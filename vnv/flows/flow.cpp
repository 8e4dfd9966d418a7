#include "vnv/flows/flow.hpp"

#include "vnv/record/same_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

const Exact& exact_named(const Flow& flow, std::string_view field) {
  const auto found = std::ranges::find(flow.exact, field, &Exact::field);
  if (found == flow.exact.end()) throw std::logic_error(fmt::format("{}: no exact {} is known", flow.name, field));
  return *found;
}

}  // namespace

double Settings::operator()(const std::string& name, double published, const std::string& unit,
                            const std::string& words) {
  const auto set = set_.find(name);
  const double value = set == set_.end() ? published : set->second;
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("{} = {}, expected a finite number", name, value));
  asked_.push_back({name, unit, words, value, value == published});
  return value;
}

double Settings::positive(const std::string& name, double published, const std::string& unit,
                          const std::string& words) {
  const double value = (*this)(name, published, unit, words);
  if (!(value > 0)) throw std::invalid_argument(fmt::format("{} = {} {}, expected more than 0", name, value, unit));
  return value;
}

const std::vector<Parameter>& Settings::all_of(std::string_view flow) const {
  std::vector<std::string> known;
  for (const Parameter& parameter : asked_) known.push_back(parameter.name);
  for (const auto& [name, value] : set_)
    if (std::ranges::find(known, name) == known.end())
      throw std::invalid_argument(
          fmt::format("{}: no parameter '{}', expected one of: {}", flow, name, fmt::join(known, ", ")));
  return asked_;
}

std::string Flow::case_name() const {
  const auto without_point = [](double value) {  // 0.015 -> "15e-3": a point would part the case from its method
    std::string digits = fmt::format("{}", value);
    const std::size_t e = digits.find('e'), point = digits.find('.');
    if (point == digits.npos) return digits;
    const int exponent = (e == digits.npos ? 0 : std::stoi(digits.substr(e + 1))) -
                         static_cast<int>(std::min(e, digits.size()) - point - 1);
    digits = digits.substr(0, std::min(e, digits.size())).erase(point, 1);
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    return fmt::format("{}e{}", digits, exponent);
  };
  std::string all = name;
  for (const Parameter& p : parameters)
    if (!p.is_published) all += fmt::format("_{}={}", p.name, without_point(p.value));
  return all;
}

std::string Flow::title() const {
  std::string all = judged.title;
  for (const Parameter& p : parameters)
    if (!p.is_published) all += fmt::format(", {} = {:g}{}", p.name, p.value, p.unit == "-" ? "" : " " + p.unit);
  return all;
}

double Flow::operator[](std::string_view parameter) const {
  const auto found = std::ranges::find(parameters, parameter, &Parameter::name);
  if (found == parameters.end()) throw std::out_of_range(fmt::format("{}: no parameter '{}'", name, parameter));
  return found->value;
}

VelocityTruth Flow::velocity() const { return exact_named(*this, "velocity").with({}); }

PressureTruth Flow::pressure() const {
  return [truth = exact_named(*this, "pressure").with({})](const Vec2& x, double t) { return truth(x, t).x(); };
}

Truth Flow::along_x() const {
  return [truth = velocity()](double y, double t) { return truth({0, y}, t).x(); };
}

std::optional<Region> Flow::region_at(double t) const {
  if (region) return region(t);
  if (!has_free_surface()) return Region{domain};
  return t == 0 && shape.empty() ? std::optional(Region{.domain = domain, .box = filled}) : std::nullopt;
}

Newtonian fluid_of(double rho, double c, double nu) {
  return {{.density = rho, .bulk_modulus = rho * c * c / Tait::gamma}, rho * nu};
}

Newtonian fluid_of(Settings& set, double rho, double c, const std::string& state) {
  const double density = set.positive("rho", rho, "kg/m³", "density " + state);
  return fluid_of(density, set.positive("c", c, "m/s", "speed of sound " + state));
}

Measurement of_each_sample(const Quantity& quantity, std::function<double(const Samples&)> found) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> values;
    for (const Samples& s : run.samples) values.push_back({level.name, level.spacing, s.time, quantity, found(s)});
    return values;
  };
}

Measurement of_run(const Quantity& quantity, std::function<double(const Run&)> found) {
  return [=](const Level& level, const Run& run) -> std::vector<Value> {
    return {{level.name, level.spacing, run.summary.end_time, quantity, found(run)}};
  };
}

Measurement of_finished_run(const Quantity& quantity, std::function<double(const Run&)> found) {
  return [of_any = of_run(quantity, std::move(found))](const Level& level, const Run& run) {
    return run.summary.finished ? of_any(level, run) : std::vector<Value>{};
  };
}

Claim is_consistent(const Quantity& quantity) {
  return order_at_least(ladder_of_files, quantity, 0.9, 0.5, theory("a consistent method is of first order at least"))
      .with_at_least_levels(3);
}

Claim has_its_pressure() {
  return between(part_of_pressure, 0.5, 1.5, theory("a flow has its pressure, and of the right sign"));
}

std::vector<std::string> flow_names() {
  std::vector<std::string> names;
  for (const NamedFlow& one : all_flows()) names.push_back(one.name);
  return names;
}

Flow flow_named(const std::string& name, Settings settings) {
  const auto found = std::ranges::find(all_flows(), name, &NamedFlow::name);
  if (found == all_flows().end())
    throw std::invalid_argument(fmt::format("no flow '{}', expected one of: {}", name, fmt::join(flow_names(), ", ")));
  return finished(found->at(settings), name, settings);
}

Flow finished(Flow flow, const std::string& name, const Settings& settings) {
  flow.name = name;
  flow.parameters = settings.all_of(name);
  std::ranges::transform(flow.judged.times, flow.judged.times.begin(), as_meant);
  flow.judged.monitor.interval = as_meant(flow.judged.monitor.interval);
  return flow;
}

}  // namespace touchstone::vnv
