#include "vnv/flows/dams/gated_dam_validation.hpp"

#include "vnv/judge/distribution.hpp"
#include "vnv/judge/grid_convergence.hpp"
#include "vnv/judge/input_uncertainty.hpp"
#include "vnv/record/median.hpp"
#include "vnv/record/record.hpp"
#include "vnv/studies/starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace touchstone::vnv::gated_dam {
namespace {

constexpr double formal_order = 1;                       // of a free surface that is resolved to one cell
constexpr std::array resolutions{20, 40, 80, 160, 320};  // particles across H

using UncertainInputs = std::vector<UncertainInput>;
UncertainInputs uncertain_inputs_of(const Experiment& experiment) {
  return read_inputs(data_folder() / "experiments" / experiment.inputs_file);
}

/// Runs that are alike but for their starts.
struct Group {
  std::string name;
  int across, starts;
  Inputs inputs;
  double friction = 0;  // coefficient
};
const std::string doubled_modulus = "bulk modulus doubled";
const std::vector<std::string> varied_inputs{"gate speed", "gate acceleration", "column height", "density", "gravity"};

double& input_of(Inputs& inputs, std::string_view name) {
  return name == "gate speed"          ? inputs.gate_speed
         : name == "gate acceleration" ? inputs.gate_acceleration
         : name == "column height"     ? inputs.height
         : name == "density"           ? inputs.density
                                       : inputs.gravity;
}

/// Each at two sizes: about what the level in the reservoir resolves, and three times that or more.
std::vector<Group> planted_errors(const Inputs& nominal_inputs, const Starts& starts = {}) {
  std::vector<Group> all;
  const auto plant = [&](const std::string& error, double Inputs::*input, double factor) {
    Inputs inputs = nominal_inputs;
    inputs.*input *= factor;
    all.push_back({"planted: " + error, starts.across_varied, starts.varied, inputs});
  };
  plant("gate half as fast", &Inputs::gate_speed, 0.5);
  plant("gate a quarter as fast", &Inputs::gate_speed, 0.25);
  plant("gravity + 3 %", &Inputs::gravity, 1.03);
  plant("gravity + 9 %", &Inputs::gravity, 1.09);
  plant("column 3 % longer", &Inputs::length, 1.03);
  plant("column 9 % longer", &Inputs::length, 1.09);
  return all;
}

std::string nominal(int across) { return fmt::format("{} across", across); }
std::string rough(double friction) { return fmt::format("skin friction {:g}", friction); }
std::string varied(const std::string& input, int side) {
  return fmt::format("{} {}", input, side < 0 ? "low" : "high");
}
double varied_value(const UncertainInput& input, int side) { return input.value + side * input.half_width; }

std::vector<Group> groups(const Experiment& experiment, const Starts& starts, bool with_friction) {
  const Inputs& filled = experiment.inputs;
  const UncertainInputs uncertain = uncertain_inputs_of(experiment);
  std::vector<Group> all;
  for (const auto& [across, count] : starts.of_across) all.push_back({nominal(across), across, count, filled});
  for (const std::string& name : varied_inputs)
    for (const int side : {-1, 1}) {
      Inputs inputs = filled;
      input_of(inputs, name) = varied_value(input_named(name, uncertain), side);
      all.push_back({varied(name, side), starts.across_varied, starts.varied, inputs});
    }
  Inputs stiff = filled;
  stiff.bulk_modulus *= 2;
  all.push_back({doubled_modulus, starts.across_varied, starts.varied, stiff});
  for (const Group& planted : planted_errors(filled, starts)) all.push_back(planted);
  if (with_friction)
    for (const double coefficient : friction_coefficients)
      all.push_back({rough(coefficient), starts.across_varied, starts.varied, filled, coefficient});
  return all;
}

std::string level_name(const Group& group, int start) { return fmt::format("{}, start {}", group.name, start); }

/// Where water is so deep that the number is the same on all grids: a slab that shrinks with the spacing finds the tip
/// of an ever thinner film, by which u_num would be of the operator.
constexpr ReadOut on_all_grids{.front = column::front_of_film};

ReadOut at_place(std::size_t place) {
  ReadOut read_out = on_all_grids;
  read_out.place = place;
  return read_out;
}

/// The observable in each run of a group, with the clock set later [T_H] or read at another place.
std::vector<double> members(const Results& results, const Inputs& filled, const std::string& group,
                            const Observable& observable, const ReadOut& read_out = on_all_grids, double clock = 0) {
  std::vector<double> found;
  for (const Run& run : results.runs) {
    if (!run.summary.level.starts_with(group + ", start ")) continue;
    if (!run.summary.finished) {
      found.push_back(not_a_number);
      continue;
    }
    Observed observed = observed_in(run, filled, read_out);
    if (clock != 0) {
      observed.front = shifted(observed.front, clock);
      for (Series& level : observed.levels) level = shifted(level, clock);
      for (Series& pressure : observed.pressures) pressure = shifted(pressure, clock);
    }
    found.push_back(observable.of(observed));
  }
  return found;
}

double middle(const std::vector<double>& all) { return all.empty() ? not_a_number : median(all); }

/// Of a median: that of a normal distribution has 1.2533 times the standard error of the mean (Kendall & Stuart).
double of_starts(const std::vector<double>& all) {
  if (all.size() < 2) return 0;
  double mean = 0, squares = 0;
  for (const double x : all) mean += x / static_cast<double>(all.size());
  for (const double x : all) squares += (x - mean) * (x - mean);
  return 1.2533 * std::sqrt(squares / static_cast<double>(all.size() - 1) / static_cast<double>(all.size()));
}

double root_sum_of_squares(const std::vector<double>& parts) {
  double sum = 0;
  for (const double part : parts) sum += part * part;
  return std::sqrt(sum);
}

/// The runs of a group; none if one of them did not finish.
std::vector<const Run*> runs_of(const Results& results, const std::string& group) {
  std::vector<const Run*> all;
  for (const Run& run : results.runs)
    if (run.summary.level.starts_with(group + ", start ")) {
      if (!run.summary.finished) return {};
      all.push_back(&run);
    }
  return all;
}

/// At how many particles across H something was varied; 0: nowhere.
int across_varied(const Results& results, double height) {
  for (const Run& run : results.runs)
    if (run.summary.level.starts_with(doubled_modulus))
      return static_cast<int>(std::lround(height / run.summary.spacing));
  return 0;
}

bool is_pressure(const Observable& observable) { return observable.place == height_of_sensors; }

ValidatedObservable judge(const Results& results, const Experiment& experiment, const UncertainInputs& uncertain,
                          const Observable& observable) {
  const Inputs& filled = experiment.inputs;
  const auto of = [&](const std::string& group, const ReadOut& read_out = on_all_grids, double clock = 0) {
    return middle(members(results, filled, group, observable, read_out, clock));
  };
  ValidatedObservable judged{.observable = observable, .simulated = not_a_number, .validation = {}};

  std::vector<AtSpacing> ladder;  // of the finest three
  int finest = 0;
  for (const int across : resolutions)
    if (const std::vector<double> all = members(results, filled, nominal(across), observable); !all.empty()) {
      judged.simulated = middle(all);
      finest = across;
      ladder.push_back({filled.height / across, judged.simulated});
      if (ladder.size() > 3) ladder.erase(ladder.begin());
      if (all.size() > 1) judged.by_starts = of_starts(all);  // of the finest that has several
    }
  const std::string at = nominal(across_varied(results, filled.height));
  const double here = of(at);
  if (std::ranges::all_of(ladder, [](const AtSpacing& one) { return std::isfinite(one.value); }) && ladder.size() > 1) {
    const NumericalUncertainty grid = numerical_uncertainty(ladder, formal_order);
    judged.by_resolution = grid.standard;
    judged.rule = grid.basis;
  }
  // What compressibility does is proportional to 1 / K where it is small: two "resolutions" of it.
  if (const double stiff = of(doubled_modulus); std::isfinite(stiff) && std::isfinite(here))
    judged.by_modulus = numerical_uncertainty({{2, here}, {1, stiff}}, 1).standard;
  ValidationParts parts{.numerical = root_sum_of_squares({judged.by_resolution, judged.by_modulus, judged.by_starts}),
                        .data = observable.standard};

  std::vector<Sensitivity> sensitivities;
  const auto add = [&](const UncertainInput& input, double low, double high) {
    sensitivities.push_back(sensitivity(input, {varied_value(input, -1), low}, {varied_value(input, 1), high}));
  };
  for (const std::string& name : varied_inputs)
    add(input_named(name, uncertain), of(varied(name, -1)), of(varied(name, 1)));
  if (!observable.clock.empty()) {
    const UncertainInput& clock = input_named(observable.clock, uncertain);
    const double shift = clock.half_width / filled.unit_of_time();
    add(clock, of(at, on_all_grids, -shift), of(at, on_all_grids, shift));
  }
  if (!observable.place.empty())
    add(input_named(observable.place, uncertain), of(at, at_place(1)), of(at, at_place(2)));
  for (const Sensitivity& one : sensitivities) judged.inputs.emplace_back(one.input, one.part);
  parts.input = input_uncertainty(sensitivities);
  judged.validation = validate(judged.simulated, observable.measured, parts, observable.useful);
  for (const Group& planted : planted_errors(filled))
    judged.planted.emplace_back(planted.name, of(planted.name) - here);
  for (const double coefficient : friction_coefficients)
    judged.by_friction.emplace_back(coefficient, of(rough(coefficient)) - here);
  if (is_pressure(observable) && ladder.size() > 1) {
    const double S = judged.simulated, by_mean = of(nominal(finest), {.pressures = column::patch});
    judged.moves = {S / ladder[ladder.size() - 2].value - 1, of(doubled_modulus) / here - 1, by_mean / S - 1};
  }
  return judged;
}

/// E of each observable, and how all together came out.
std::vector<Value> values_of(const Results& results, const Experiment& experiment) {
  if (results.suite != Suite::validation) return {};
  std::vector<Value> found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({"", not_a_number, experiment.end, quantity, value});
  };
  const std::vector<ValidatedObservable> all = judgements(results, experiment);
  double agree = 0, wrong = 0, pressures = 0, converged = 0, worst = 0;
  std::map<std::string, bool> noticed;
  for (const ValidatedObservable& one : all) {
    Quantity error = one.observable.quantity;
    error.name = "E = S - D, " + error.name;
    error.kind = Kind::deviation;
    error.better = Better::nearer_zero;
    add(error, one.validation.error);
    agree += one.validation.outcome == Validation::Outcome::agrees;
    wrong += one.validation.outcome == Validation::Outcome::model_error;
    pressures += is_pressure(one.observable);
    converged += one.moves.converged();
    const ValidationParts& parts = one.validation.parts;
    if (one.observable.clock == clock_of_front && std::isfinite(parts.data))
      worst = std::max(worst, parts.numerical / parts.data);
    for (const auto& [name, change] : one.planted) noticed[name] |= std::abs(change) > one.validation.expanded();
  }
  add(agreeing, agree);
  add(model_errors, wrong);
  add(planted_noticed, static_cast<double>(std::ranges::count_if(noticed, [](const auto& one) { return one.second; })));
  if (pressures > 0) add(converged_pressures, converged);
  add(numbers_over_data, worst);
  return found;
}

/// The words of the standard without the numbers, which have columns of their own.
std::string verdict_of(const Validation& validation) {
  const std::string all = words(validation, "");
  return all.substr(0, std::min({all.find(": "), all.find(" ("), all.find("; ")}));
}

}  // namespace

const Experiment with_300{filled_300, "lobovsky_2014_inputs_300.csv", observables_300, 1.3};
const Experiment with_600{filled_600, "lobovsky_2014_inputs_600.csv", observables_600, 0.4};

Method validated(const Experiment& experiment, const MethodOn& method_on, const Starts& starts) {
  const double height = experiment.inputs.height;
  Method method = method_on.without_friction(collapse(experiment.inputs));
  const auto all = std::make_shared<const std::vector<Group>>(
      groups(experiment, starts, static_cast<bool>(method_on.with_friction)));
  for (const Group& group : *all)
    for (int start = 1; start <= group.starts; ++start)
      method.levels.push_back({.name = level_name(group, start),
                               .spacing = height / group.across,
                               .cell = 2 * height / group.across,
                               .validation = experiment.end,
                               .may_diverge = true});
  method.run = [=](const Level& level, const Schedule& when) {
    for (const Group& group : *all)
      for (int start = 1; start <= group.starts; ++start)
        if (level_name(group, start) == level.name) {
          const auto scene = from_start(static_cast<unsigned>(start), jitter * level.spacing, collapse(group.inputs));
          SkinFriction of_group = friction;
          of_group.coefficient = group.friction;
          return (group.friction > 0 ? method_on.with_friction(with_friction(scene, of_group))
                                     : method_on.without_friction(scene))
              .run(level, when);
        }
    throw std::invalid_argument(fmt::format("validation: level '{}', expected one of its own", level.name));
  };
  return method;
}

std::vector<const Run*> runs_with_friction(const Results& results, double coefficient) {
  return runs_of(results, rough(coefficient));
}

std::vector<const Run*> ensemble_of(const Results& results) {
  std::vector<const Run*> largest;
  for (auto across = resolutions.rbegin(); across != resolutions.rend(); ++across)
    if (const auto members = runs_of(results, nominal(*across));
        members.size() > std::max<std::size_t>(1, largest.size()))
      largest = members;
  return largest;
}

std::vector<ValidatedObservable> judgements(const Results& results, const Experiment& experiment) {
  const UncertainInputs uncertain = uncertain_inputs_of(experiment);
  std::vector<ValidatedObservable> all;
  for (const Observable& observable : experiment.observables())
    all.push_back(judge(results, experiment, uncertain, observable));
  return all;
}

namespace {

/// A table of all observables with the words of the standard, one of what each input contributes, one of what planted
/// errors of the model move beyond the uncertainty, and one of which pressures are converged.
Plot tables_of(const Experiment& experiment) {
  return [experiment](const Results& results, Record& record) {
    if (results.suite != Suite::validation) return;
    Table verdicts{
        "validation",
        "Validation after ASME V&V 20",
        "D: measured; S: simulated, the median over the starts at the finest resolution; E = S - D; u_num, u_input, "
        "u_D: standard uncertainties of the numerics, the inputs and the data; u_val: the root of the sum of their "
        "squares. What is not known is blank and left out of u_val.",
        {"method", "observable", "verdict", "D", "S", "E", "u_val", "u_num", "u_input", "u_D"},
        {}};
    Table inputs{"inputs",
                 "Parts of the validation uncertainty",
                 "Standard uncertainties of the observable: the parts of u_num due to resolution, bulk modulus and "
                 "number of starts, and the two largest parts of u_input.",
                 {"method", "observable", "resolution", "modulus", "starts", "inputs", "rule of u_num", "basis of u_D"},
                 {}};
    Table planted{
        "planted",
        "Planted errors of the model, and skin friction",
        "Change of the median, and whether it is noticed: more than 2 u_val. Skin friction of floor and side walls, by "
        "its coefficient, is left out of the plane model.",
        {"method", "observable", "2 u_val"},
        {}};
    Table moves{
        "moves",
        "Convergence of the impact",
        "Relative change of the median from the second finest grid to the finest, by a doubled bulk modulus, and from "
        "the affine fit at the sensor to the mean over a patch. Converged: each is at most 10 %.",
        {"method", "observable", "grid", "bulk modulus", "sensor operator", "verdict"},
        {}};
    const std::string& name = results.method.name;
    const auto moved = [](double by, const char* remark) {
      return std::isfinite(by) ? Cell(fmt::format("{:+.3g}{}", by, remark)) : Cell("");
    };
    const auto known = [](double x) { return std::isfinite(x) ? Cell(fmt::format("{:.3g}", x)) : Cell(""); };
    for (const ValidatedObservable& one : judgements(results, experiment)) {
      const Validation& v = one.validation;
      verdicts.rows.push_back({name, one.observable.quantity.name, verdict_of(v), known(one.observable.measured),
                               known(one.simulated), known(v.error), known(v.uncertainty), known(v.parts.numerical),
                               known(v.parts.input), known(v.parts.data)});
      auto largest = one.inputs;
      std::ranges::sort(largest, std::greater(), [](const auto& input) { return input.second; });
      std::string most;
      for (std::size_t k = 0; k < std::min<std::size_t>(2, largest.size()); ++k)
        most += fmt::format("{}{} {:.2g}", k ? ", " : "", largest[k].first, largest[k].second);
      inputs.rows.push_back({name, one.observable.quantity.name, known(one.by_resolution), known(one.by_modulus),
                             known(one.by_starts), most, one.rule, one.observable.basis});
      std::vector<Cell> row{name, one.observable.quantity.name, known(v.expanded())};
      for (const auto& [error, change] : one.planted) {
        if (planted.rows.empty()) planted.columns.push_back(error.substr(error.find(' ') + 1));
        row.push_back(moved(change, std::abs(change) > v.expanded() ? ", noticed" : ""));
      }
      for (const auto& [coefficient, change] : one.by_friction) {
        if (planted.rows.empty()) planted.columns.push_back(fmt::format("skin friction {:g}", coefficient));
        row.push_back(moved(change, ""));
      }
      planted.rows.push_back(std::move(row));
      const auto percent = [](double part) {
        return std::isfinite(part) ? Cell(fmt::format("{:+.1f} %", 100 * part)) : Cell("");
      };
      if (is_pressure(one.observable))
        moves.rows.push_back({name, one.observable.quantity.name, percent(one.moves.grid), percent(one.moves.modulus),
                              percent(one.moves.sensor), one.moves.converged() ? "converged" : "not converged"});
    }
    for (Table* table : {&verdicts, &inputs, &planted, &moves})
      if (!table->rows.empty()) record.tables.push_back(std::move(*table));
  };
}

}  // namespace

Case validation_by(const Experiment& experiment, std::string title, std::string description,
                   std::vector<Method> methods, std::vector<Claim> claims) {
  return {.title = std::move(title),
          .description = std::move(description),
          .times = {experiment.end},
          .monitor = monitored,
          .measurements = {},
          .findings = {[experiment](const Results& results, const Record&) { return values_of(results, experiment); }},
          .claims = std::move(claims),
          .methods = std::move(methods),
          .plots = {tables_of(experiment)}};
}

}  // namespace touchstone::vnv::gated_dam
