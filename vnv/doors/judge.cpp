#include "vnv/doors/judge.hpp"

#include "solvers/lattice.hpp"
#include "vnv/doors/diagnosis.hpp"
#include "vnv/doors/filling.hpp"
#include "vnv/doors/read/columns.hpp"
#include "vnv/harness/assess.hpp"
#include "vnv/judge/baselines.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/programs/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

GivenLevel& level_of(std::vector<GivenLevel>& levels, double spacing) {
  const auto is_equal = [&](const GivenLevel& level) { return std::abs(level.spacing / spacing - 1) < 0.01; };
  const auto found = std::ranges::find_if(levels, is_equal);
  return found == levels.end() ? levels.emplace_back(GivenLevel{spacing}) : *found;
}

bool has(const std::vector<std::string>& fields, const std::string& name) {
  return std::ranges::find(fields, name) != fields.end();
}

/// Of a mesh its cells: what stands at its corners is interpolated from them.
std::vector<Dataset> rows_to_judge(std::vector<Dataset> all) {
  const auto is_of_cells = [](const Dataset& data) { return data.rows_are == Rows::cells; };
  if (std::ranges::any_of(all, is_of_cells)) std::erase_if(all, std::not_fn(is_of_cells));
  return all;
}

Vec2 middle_of(const Vectors& places) { return (places.rowwise().maxCoeff() + places.rowwise().minCoeff()) / 2; }
Vec2 spread_of(const Vectors& places) { return places.rowwise().maxCoeff() - places.rowwise().minCoeff(); }

/// Where the fluid is at a time, with half a spacing around rows that are so many.
Extent extent_of(const Flow& flow, double t, double rows) {
  Extent fluid{.area = flow.filled_area()};
  if (!flow.has_free_surface()) {
    fluid.about = flow.domain.box;
  } else if (const double spacing = std::sqrt(fluid.area / rows);
             t == 0 && (spacing <= flow.filled.size().array()).all()) {
    const Vectors start = places_in(flow.domain.box, flow.start, lattice(flow.filled, spacing));
    fluid.about = Box{.low = start.rowwise().minCoeff().array() - spacing / 2,
                      .high = start.rowwise().maxCoeff().array() + spacing / 2};
  } else if (const auto region = flow.region_at(t); region && !region->depth) {
    fluid.about = region->box;
  } else if (region) {  // what the box about it is, where it is all of the fluid: not below the troughs of a wave alone
    constexpr long many = 300;
    const Lattice all{region->box.low, region->box.size() / many, many, many};
    Box about{.low = Vec2::Constant(INFINITY), .high = Vec2::Constant(-INFINITY)};
    double area = 0;
    const Vectors places = all.places();
    for (const auto& x : places.colwise())
      if (region->depth(x) >= 0)
        about.low = about.low.cwiseMin(x), about.high = about.high.cwiseMax(x), area += all.volume();
    if (std::abs(area / fluid.area - 1) < 0.02) fluid.about = about;
  }
  return fluid;
}

/// Rows reach over most of the fluid, at the start over all of it; those in another unit or of a flow of another size
/// do not, nor does a single line. Where they lack a part of it along one axis, claims on its filling fail.
void require_filled(const Flow& flow, const std::string& source, const Samples& samples, double spacing,
                    const std::string& fits_with) {
  const Vec2 spread = spread_of(samples.x);
  const auto refuse = [&](const std::string& expected) {
    throw Unreadable(fmt::format("{}: rows spread over {:.4g} m by {:.4g} m, expected {}{}", source, spread.x(),
                                 spread.y(), expected, fits_with.empty() ? ": --set its size" : fits_with));
  };
  if (samples.size() < 4) return;
  const Extent fluid = extent_of(flow, samples.time, static_cast<double>(samples.size()));
  if (flow.has_free_surface() && samples.time == 0) {
    const Vectors start = places_in(flow.domain.box, flow.start, lattice(flow.filled, spacing));
    const Vec2 exact = spread_of(start), off = middle_of(samples.x) - middle_of(start);
    const Eigen::Array2d most_off = 2 * spacing + 0.05 * exact.array();
    if (((spread - exact).array().abs() > most_off).any())
      refuse(fmt::format("about {:.4g} m by {:.4g} m at the start", exact.x(), exact.y()));
    for (const int axis : {0, 1})
      if (!flow.domain.periodic(axis) && std::abs(off[axis]) > most_off[axis])
        throw Unreadable(fmt::format(
            "{}: the middle of the rows at the start is {:.4g} m off along {}, expected it where the fluid of the flow "
            "is{}",
            source, off[axis], "xy"[axis], fits_with.empty() ? ": --origin" : fits_with));
  } else if (!fluid.about) {
    if (spread.prod() < fluid.area / 2) refuse(fmt::format("room for the {:.4g} m² of fluid", fluid.area));
  } else if (const Vec2 size = fluid.about->size();
             !fits_with.empty() || !(spread.prod() > 0) || (spread.array() < size.array() / 2).all()) {
    refuse(fmt::format("most of the {:.4g} m by {:.4g} m of the fluid", size.x(), size.y()));
  }
}

/// By how much a velocity is off the exact one at places less a shift [m] and so many times their time, squared, by
/// about a thousand rows; not a number where it is not known.
double squared_off(const Flow& flow, const Samples& s, const Vec2& shift, double times) try {
  const auto exact = std::ranges::find(flow.exact, "velocity", &Exact::field);
  if (exact == flow.exact.end()) return not_a_number;
  const FieldTruth truth = exact->with({});
  double squared = 0;
  for (Eigen::Index p = 0; p < s.size(); p += 1 + s.size() / 1000)
    squared += (s.v.col(p) - truth(s.x.col(p) - shift, times * s.time)).head(exact->components).squaredNorm();
  return squared;
} catch (const std::exception&) {  // so long after its start
  return not_a_number;
}

/// Says in which unit the times of files may be written: the one in which their velocities are much nearer to the exact
/// ones, and than these at the start, which do not change.
void tell_unit_of_times(Given& given, const Flow& flow) {
  const auto off = [&](double seconds) {
    double squared = 0;
    for (const GivenLevel& level : given.levels)
      for (const auto& [time, samples] : level.at) squared += squared_off(flow, samples, Vec2::Zero(), seconds);
    return squared;
  };
  const double most = std::min(off(1), off(0)) / 16;
  for (const auto& [unit, seconds] : units_of_time)
    if (unit != "s" && off(seconds) < most)
      given.say(fmt::format("times in {0}? Velocities fit with --unit time={0}", unit));
}

/// Says of rows that span a periodic box and lie beside it which origin puts them into it, where their velocity is then
/// much nearer to the exact one: wrapped they may be right as they are.
void tell_where_periods_begin(Given& given, const Flow& flow, const std::string& source, const Reading& reading) {
  if (reading.beside.isZero(0)) return;
  if (squared_off(flow, reading.samples, reading.beside, 1) < squared_off(flow, reading.samples, Vec2::Zero(), 1) / 4)
    given.say(fmt::format("{}: the rows span the periodic box and lie beside it: they fit with{}", source,
                          reading.put_right));
}

/// Where nothing is judged of a velocity along x alone, both components of it are there or none.
void require_components(const Flow& flow, const std::string& source, const std::vector<std::string>& fields) {
  const auto needs_one = [](const Measured& one) { return has(one.fields, velocity_along_x); };
  if (has(fields, velocity_along_x) && !has(fields, "velocity") && std::ranges::none_of(flow.measured, needs_one))
    throw Unreadable(fmt::format("{}: velocity along x alone, expected its component along y too", source));
}

/// Volumes of a plane flow: equal ones of rows that have none, and about those of the fluid where its surface is free.
void require_volumes(const Flow& flow, const std::string& source, Reading& reading) {
  Samples& samples = reading.samples;
  const double area = flow.filled_area();
  if (!reading.has_volumes) {
    samples.mass = samples.density * (area / static_cast<double>(samples.size()));
  } else if (const double found = samples.volumes().sum();
             flow.has_free_surface() && std::abs(found / area - 1) > 0.2) {
    throw Unreadable(fmt::format(
        "{}: volumes of {:.4g} m² in all, per metre of depth, expected {:.4g} m²: --set the size of the flow", source,
        found, area));
  }
}

double size_of(const std::filesystem::path& file) {
  std::error_code unknown;  // it is told when the file is read
  const auto bytes = std::filesystem::file_size(file, unknown);
  return unknown ? 0 : static_cast<double>(bytes);
}

/// How far [m] rows are from the nearest other one, by about a hundred of them: all but this part of them at least.
double apart(const Vectors& x, double part) {
  std::vector<double> nearest;
  for (Eigen::Index p = 0; p < x.cols(); p += 1 + x.cols() / 100) {
    double least = INFINITY;
    for (Eigen::Index q = 0; q < x.cols(); ++q)
      if (q != p) least = std::min(least, (x.col(q) - x.col(p)).squaredNorm());
    nearest.push_back(std::sqrt(least));
  }
  std::ranges::sort(nearest);
  return nearest[static_cast<std::size_t>(part * static_cast<double>(nearest.size()))];
}

/// Whether fewer rows are those of a coarser resolution, which stand farther apart almost everywhere, by as much as
/// their number says; where rows were lost many of the others stay as near to each other as they were. Of a cloud in
/// which distances scatter widely nobody can tell, and rows are lost.
bool is_coarser(const Vectors& x, const Vectors& before) {
  const double farther = std::sqrt(static_cast<double>(before.cols()) / static_cast<double>(x.cols())),
               nearest = apart(x, 0.1);
  return nearest > (1 + 0.6 * (farther - 1)) * apart(before, 0.1) && nearest > 0.9 * apart(before, 0.5);
}

/// The level that a file's rows are of: one of its spacing, or one before of which rows are missing; each that has none
/// of its time yet. A code that loses rows has no coarser resolution.
GivenLevel& level_for(std::vector<GivenLevel>& levels, const GivenLevel& one) {
  const double time = one.at.begin()->first;
  const auto has_its_time = [&](const GivenLevel& level) {
    return std::ranges::any_of(level.at,
                               [&](const auto& at) { return std::abs(at.first - time) <= time_tolerance * time; });
  };
  const auto is_equal = [&](const GivenLevel& level) { return std::abs(level.spacing / one.spacing - 1) < 0.01; };
  const auto takes_it = [&](const GivenLevel& level) { return is_equal(level) && !has_its_time(level); };
  if (const auto equal = std::ranges::find_if(levels, takes_it); equal != levels.end()) return *equal;
  GivenLevel* before = nullptr;
  for (GivenLevel& level : levels) {
    if (one.spacing_is_said || has_its_time(level) || level.at.begin()->first > time) continue;
    const Vectors& first = level.at.begin()->second.x;
    if (const Vectors& x = one.at.begin()->second.x;
        x.cols() < first.cols() && (!before || level.spacing > before->spacing) && !is_coarser(x, first))
      before = &level;
  }
  if (before) return *before;
  if (const auto twice = std::ranges::find_if(levels, is_equal); twice != levels.end()) return *twice;
  return levels.emplace_back(GivenLevel{.spacing = one.spacing, .spacing_is_said = one.spacing_is_said});
}

/// A run of what was given, whose samples it takes, as if it had been computed here.
Run run_of(GivenLevel& given, const std::string& level, const Monitor& monitor) {
  Run run{.summary = {.level = level,
                      .spacing = given.spacing,
                      .finished = given.outcome == "finished",
                      .outcome = given.outcome,
                      .cost = given.cost}};
  for (auto& [time, samples] : given.at) {
    run.samples.push_back(std::move(samples));
    if (!monitor.evaluate) continue;
    run.history.time.push_back(time);
    run.history.values.push_back(monitor.evaluate(run.samples.back()));
  }
  if (run.samples.empty()) return run;
  run.summary.end_time = run.samples.back().time;
  run.summary.cost.particles = run.samples.back().size();
  return run;
}

/// The time that was asked for, of a sample that is the nearest to it and within 1 %; of any other sample its own.
double asked(double time, const std::vector<double>& times, const std::vector<Samples>& all) {
  const auto to = [](double one) { return [one](double other) { return std::abs(one - other); }; };
  const auto one = std::ranges::min_element(times, {}, to(time));
  if (one == times.end() || to(*one)(time) > time_tolerance * *one) return time;
  const bool another_is_nearer = std::ranges::any_of(
      all, [&](double other) { return to(*one)(other) < to(*one)(time); }, &Samples::time);
  return another_is_nearer ? time : *one;
}

/// Whether fields hold nothing that is not a finite number.
bool are_numbers(const std::vector<std::string>& fields, const std::vector<Samples>& all) {
  return std::ranges::all_of(all, [&](const Samples& s) {
    return (!has(fields, velocity_along_x) || s.v.row(0).allFinite()) &&
           (!has(fields, "velocity") || s.v.allFinite()) && (!has(fields, "pressure") || s.pressure.allFinite());
  });
}

/// A span, of a steady flow as long before a later end [s].
Span span_of(Span span, double end) {
  const double later = span.is_steady ? std::max(0.0, end - span.last) : 0;
  return {span.first + later, span.last + later, span.least};
}

/// Those times at which a measurement can be made: at others, as at rest, there is nothing to compare with.
Measurement where_defined(const Measured& measured, const std::vector<double>& times,
                          std::vector<std::string>& not_judged) {
  const auto add = [=, &times, &not_judged](std::vector<Value>& all, const Level& level, const Run& run,
                                            const std::vector<Samples>& given) {
    try {
      for (Value value : measured.measurement(level, run)) {
        value.time = asked(value.time, times, given);
        if (std::isnan(value.value) && are_numbers(measured.fields, run.samples))  // as where no row is
          not_judged.push_back(fmt::format("{}, {:g} s: {}: cannot be measured of these rows", level.name, value.time,
                                           value.quantity.name));
        else
          all.push_back(std::move(value));
      }
    } catch (const std::logic_error& error) {
      not_judged.push_back(fmt::format("{}, {:g} s: {}", level.name, run.samples.back().time, error.what()));
    }
  };
  return [=, &not_judged](const Level& level, const Run& run) {
    std::vector<Value> all;
    if (run.samples.empty()) return all;  // it did not answer, as its verdict says
    if (!measured.over && run.samples.size() > 1) {
      for (const Samples& samples : run.samples)
        add(all, level, {.summary = run.summary, .samples = {samples}}, run.samples);
    } else if (!measured.over) {
      add(all, level, run, run.samples);  // without a copy
    } else if (const Span at = span_of(*measured.over, run.samples.back().time);
               run.samples.size() < at.least || run.samples.front().time > at.first * (1 + time_tolerance) ||
               run.samples.back().time < at.last * (1 - time_tolerance)) {
      const std::string first = std::isfinite(at.first) ? fmt::format(", the first at {:g} s or before", at.first) : "",
                        last = at.last > 0 ? fmt::format(", the last at {:g} s or after", at.last) : "";
      not_judged.push_back(fmt::format("{}: {} over time: {} {} from {:g} to {:g} s, expected {} or more{}{}",
                                       level.name, measured.name, run.samples.size(),
                                       run.samples.size() == 1 ? "time" : "times", run.samples.front().time,
                                       run.samples.back().time, at.least, first, last));
    } else {
      add(all, level, run, run.samples);
    }
    return all;
  };
}

/// The flow's case with what is measured of the fields that there are.
Case case_of(const Flow& flow, const Given& given, const std::vector<double>& times,
             std::vector<std::string>& not_judged) {
  Case judged = flow.judged;
  std::ranges::copy(flow.aside, std::back_inserter(judged.claims));
  judged.title = flow.title();
  for (const Measured& one : flow.measured) {
    const auto missing = std::ranges::find_if(
        one.fields, [&](const std::string& name) { return given.fields && !has(*given.fields, name); });
    if (missing == one.fields.end())
      judged.measurements.push_back(where_defined(one, times, not_judged));
    else if (const std::string line = fmt::format(
                 "no {} in the files: what is measured of it is not judged",
                 *missing == "velocity" && has(*given.fields, velocity_along_x) ? "velocity along y" : *missing);
             !has(not_judged, line))
      not_judged.push_back(line);
  }
  return judged;
}

/// A user's own limits of orders, of the norms of which the flow claims one.
std::vector<Claim> own_claims(const Flow& flow, const Judged& what) {
  std::vector<Claim> claims;
  for (const Claim& claim : flow.judged.claims)
    if (what.order_at_least && !claim.ladder.empty())
      claims.push_back(order_at_least(ladder_of_files, claim.quantity, *what.order_at_least, *what.order_at_least - 0.5,
                                      baseline("order that the user expects"))
                           .with_at_least_levels(3));
  return claims;
}

/// A user's limit [%] of each error at the finest resolution: its size, of one with a sign too, and a hundredth of it
/// of one that is a pure number. Fails where there is none.
void limit_errors(double percent, const std::string& finest, Record& record) {
  const auto is_error = [](const Quantity& q) {
    return (q.kind == Kind::norm || q.kind == Kind::error || q.kind == Kind::deviation) &&
           (q.unit == "%" || q.unit.empty());
  };
  const Author user = baseline("limit of the user");
  bool is_any = false;
  for (const Value& v : record.values) {
    if (v.level != finest || !is_error(v.quantity)) continue;
    const double limit = v.quantity.unit.empty() ? percent / 100 : percent;
    record.verdicts.push_back(judge(v.quantity.kind == Kind::deviation ? between(v.quantity, -limit, limit, user)
                                                                       : at_most(v.quantity, limit, user),
                                    {record.case_name, record.method, v.level, v.spacing, v.time}, v.value));
    is_any = true;
  }
  if (is_any) return;
  Verdict none =
      judge(at_least({std::string(anything_limited)}, 1, user), {record.case_name, record.method, finest}, 0);
  none.sentence = fmt::format("{}.{} {}: the limit of {:g} % applies to nothing: no error was measured: FAILS",
                              record.case_name, record.method, finest, percent);
  record.verdicts.push_back(std::move(none));
}

/// What is measured of fields that are there is a number, whether or not it is limited.
void refuse_what_is_no_number(Record& record) {
  for (const Value& v : record.values) {
    const auto fails = [&](const Verdict& other) {
      return other.level == v.level && other.quantity == v.quantity.name && std::isnan(other.value);
    };
    if (!std::isnan(v.value) || std::ranges::any_of(record.verdicts, fails)) continue;
    const Place place{record.case_name, record.method, v.level, v.spacing, v.time};
    Verdict is_none = judge(at_least(v.quantity, 0, theory("what is measured is a number")), place, v.value);
    is_none.sentence = fmt::format("{}.{} {}: {} = nan at {:.4g} s, expected a number: FAILS", record.case_name,
                                   record.method, v.level, v.quantity.name, v.time);
    record.verdicts.push_back(std::move(is_none));
  }
}

/// A velocity that is farther off than none, or at one row than twice the largest, as a reversed one is, is none of the
/// flow: also where it falls with the spacing, as that of one wild row does.
void refuse_what_is_worse_than_nothing(const Flow& flow, Record& record) {
  for (const Exact& exact : flow.exact)
    for (const Value& v : record.values) {
      const double most = v.quantity.name.starts_with("Linf") ? 200 : 100;
      if (exact.field != "velocity" || !has(exact.norms, v.quantity.name) || !(v.value > most)) continue;
      record.verdicts.push_back(
          judge(at_most(v.quantity, most, theory("a fluid at rest is 100 % off, a reversed one 200 %")),
                {record.case_name, record.method, v.level, v.spacing, v.time}, v.value));
    }
}

/// Errors that are rounding, of numbers in single precision or with eight digits, have no order, and need none.
void take_rounding_for_converged(const std::vector<Claim>& claims, Record& record) {
  constexpr double rounding = 1e-4;  // %  of files with six digits
  const auto is_rounding = [](const ObservedOrder& order) {
    return order.quantity.ends_with("[%]") && std::abs(order.errors.back()) <= rounding;
  };
  for (const Claim& claim : claims)
    for (const ObservedOrder& order : record.orders) {
      if (claim.ladder.empty() || order.quantity != claim.quantity.heading() || !is_rounding(order)) continue;
      for (Verdict& v : record.verdicts)
        if (v.quantity == judged_quantity(claim).name && v.time == order.time)
          v = judge(at_most(claim.quantity, rounding, theory("an error at rounding is converged")),
                    {record.case_name, record.method, order.levels.back(), order.spacings.back(), order.time},
                    order.errors.back());
    }
  std::erase_if(record.orders, is_rounding);
}

/// For want of a field, or of times of one level, as has been said.
void leave_out_what_is_not_measured(const std::vector<Claim>& claims, Record& record) {
  for (const Claim& claim : claims) {
    const auto is_claimed = [&](const Value& value) { return value.quantity.name == claim.quantity.name; };
    if (std::ranges::any_of(record.values, is_claimed)) continue;
    std::erase_if(record.verdicts, [&](const Verdict& v) { return v.quantity == judged_quantity(claim).name; });
  }
  std::erase_if(record.verdicts, [&](const Verdict& v) {
    const auto is_it = [&](const Value& value) { return value.level == v.level && value.quantity.name == v.quantity; };
    return std::isnan(v.value) && !v.level.empty() && std::ranges::none_of(record.values, is_it);
  });
}

/// An order is that of one time, which three resolutions have to have.
void leave_out_orders_of_no_time(const std::vector<Claim>& claims, Record& record,
                                 std::vector<std::string>& not_judged) {
  for (const Claim& claim : claims) {
    std::map<double, int> levels;  // by time
    for (const Value& value : record.values)
      if (!claim.ladder.empty() && value.quantity.name == claim.quantity.name) ++levels[value.time];
    if (levels.empty() || std::ranges::any_of(levels, [](const auto& at) { return at.second >= 3; })) continue;
    if (std::erase_if(record.verdicts, [&](const Verdict& v) { return v.quantity == judged_quantity(claim).name; }))
      not_judged.push_back(
          fmt::format("order of {}: no time at which there are three resolutions", claim.quantity.name));
  }
}

/// Says with each verdict on a filling that fails where it does.
void say_where(const std::string& level, const Filling& filling, Record& record) {
  for (Verdict& v : record.verdicts)
    for (const auto& [quantity, where] : filling.where)
      if (v.level == level && v.quantity == quantity && v.outcome != Outcome::holds && !where.empty())
        v.sentence += "; " + where;
}

/// Where all claims on a filling hold, one of them speaks for the others: that of the hole, or else the first.
void say_briefly(const std::string& level, const Filling& filling, Record& record) {
  const auto is_of_it = [&](const Verdict& v) { return v.level == level && is_of_filling(v.quantity); };
  const auto fails = [&](const Verdict& v) { return is_of_it(v) && v.outcome != Outcome::holds; };
  auto spokesman = std::ranges::find_if(
      record.verdicts, [&](const Verdict& v) { return is_of_it(v) && v.quantity == largest_hole.name; });
  if (spokesman == record.verdicts.end()) spokesman = std::ranges::find_if(record.verdicts, is_of_it);
  if (spokesman == record.verdicts.end() || std::ranges::any_of(record.verdicts, fails)) return;
  std::string others;
  for (const Verdict& v : record.verdicts)
    if (is_of_it(v) && v.quantity != spokesman->quantity)
      others += fmt::format("{}{} = {:.4g}{}", others.empty() ? "" : ", ", v.quantity, v.value,
                            v.unit.empty() ? "" : " " + v.unit);
  if (!others.empty())
    spokesman->sentence += fmt::format(
        "; {}, as {} hold, too", filling.is_counted ? "all the fluid is there" : "it has no hole", others);
  const std::string kept = spokesman->quantity;
  std::erase_if(record.verdicts, [&](const Verdict& v) { return is_of_it(v) && v.quantity != kept; });
}

/// That its runs end, that all the fluid is there and what it does not do says nothing of how it flows: who claims no
/// more does not pass.
void refuse_to_claim_nothing(const Flow& flow, Record& record) {
  const auto is_of_flow = [&](const Verdict& v) {
    const auto is_it = [&](const Claim& claim) { return claim.quantity.name == v.quantity; };
    return v.quantity != end_time_reached && !is_of_filling(v.quantity) && std::ranges::none_of(flow.aside, is_it);
  };
  if (std::ranges::any_of(record.verdicts, is_of_flow)) return;
  Verdict v = judge(at_least({std::string(anything_claimed)}, 1, theory("a verdict needs a claim")),
                    Place{.case_name = record.case_name, .method = record.method, .level = ""}, 0);
  v.sentence = fmt::format(
      "{}.{}: nothing was claimed of its errors: three resolutions show the order, --at-most PERCENT or at_most in "
      "[claims] sets a limit: FAILS",
      record.case_name, record.method);
  record.verdicts.push_back(std::move(v));
}

/// Whether a verdict is of a norm of the field, or of the order of one.
bool is_of(const Exact& exact, const Verdict& verdict, const std::vector<Claim>& claims) {
  return has(exact.norms, verdict.quantity) || std::ranges::any_of(claims, [&](const Claim& claim) {
           return has(exact.norms, claim.quantity.name) && judged_quantity(claim).name == verdict.quantity;
         });
}

/// What diagnose() finds of each level; of all of them that it cannot be made, should it throw: a judgement does not
/// end by it.
std::vector<Diagnosis> diagnosed(const Flow& flow, const Exact& exact, const Results& results, const Record& record) {
  std::vector<Diagnosed> levels;
  std::vector<const Exact*> others;
  for (const Exact& other : flow.exact)
    if (&other != &exact &&
        std::ranges::any_of(record.values, [&](const Value& v) { return has(other.norms, v.quantity.name); }))
      others.push_back(&other);
  for (std::size_t k = 0; k < results.runs.size(); ++k) {
    levels.push_back({.samples = {}, .spacing = results.method.levels[k].spacing});
    for (const Samples& at : results.runs[k].samples) levels.back().samples.push_back(&at);
  }
  try {
    return diagnose(exact, levels, flow.domain, 0.3, others);
  } catch (const std::exception& error) {
    return std::vector<Diagnosis>(levels.size(), {.field = exact.field,
                                                  .sentence = fmt::format("no diagnosis of the {} could be made: {}",
                                                                          exact.field, error.what())});
  }
}

/// Diagnoses each field and level of which a verdict does not hold, an order as its finest level, and adds what is
/// found to the sentences of these verdicts. If asked, all others too.
void diagnose_failures(const Flow& flow, const Results& results, const std::vector<Claim>& claims, bool diagnose_all,
                       Record& record) {
  const std::vector<Level>& levels = results.method.levels;
  for (const Exact& exact : flow.exact) {
    std::vector<Diagnosis> of_levels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const auto has_value = [&](const Value& v) {
        return v.level == levels[k].name && has(exact.norms, v.quantity.name);
      };
      if (std::ranges::none_of(record.values, has_value)) continue;
      std::vector<Verdict*> of_it;
      for (Verdict& v : record.verdicts)
        if (is_of(exact, v, claims) && (v.level == levels[k].name || (v.level.empty() && k + 1 == levels.size())))
          of_it.push_back(&v);
      const auto fails = [](const Verdict* v) { return v->outcome != Outcome::holds; };
      if (std::ranges::none_of(of_it, fails) && !diagnose_all) continue;
      if (of_levels.empty()) of_levels = diagnosed(flow, exact, results, record);
      Diagnosis& found = of_levels[k];
      found.level = levels[k].name;
      for (Verdict* v : of_it) {
        if (!has(found.quantities, v->quantity)) found.quantities.push_back(v->quantity);
        if (fails(v)) v->sentence += "; " + found.sentence;
      }
      record.diagnoses.push_back(std::move(found));
    }
  }
}

}  // namespace

std::string level_name(const Flow& flow, double spacing) { return fmt::format("{:.4g} across", flow.across / spacing); }

bool is_limited(const Value& value, const Record& record) {
  if (is_of_filling(value.quantity.name)) return true;  // its verdict may speak for several
  return std::ranges::any_of(record.verdicts, [&](const Verdict& v) {
    return (v.quantity == value.quantity.name && v.level == value.level) ||
           v.quantity.starts_with("order of " + value.quantity.name + " over ");
  });
}

void Given::say(const std::string& line) {
  if (std::ranges::find(words, line) == words.end()) words.push_back(line);
}

void read_into(Given& given, const Flow& flow, const Mapping& mapping, Dataset data, std::optional<double> said) {
  Reading reading = reading_of(data, mapping, flow.domain, flow.fluid.density,
                               [&](double t, double rows) { return extent_of(flow, t, rows); });
  data.arrays.clear();  // what stood in them is in the samples
  given.files.push_back(reading.file);
  for (const std::string& line : reading.words) given.say(line);
  if (given.fields)
    std::erase_if(*given.fields, [&](const std::string& name) { return !has(reading.fields, name); });
  else
    given.fields = reading.fields;
  const double spacing = said ? *said
                         : given.levels.empty()
                             ? std::sqrt(flow.filled_area() / static_cast<double>(reading.samples.size()))
                             : given.levels.front().spacing;
  require_filled(flow, data.source, reading.samples, spacing, reading.fits_with);
  tell_where_periods_begin(given, flow, data.source, reading);
  require_volumes(flow, data.source, reading);
  require_components(flow, data.source, reading.fields);
  given.say(fmt::format("spacing: {:.4g} m, {}", spacing,
                        said ? "as said" : "the root of the filled area over the number of rows at the first time"));
  GivenLevel& level = level_of(given.levels, spacing);
  level.spacing_is_said = said.has_value();
  level.has_volumes &= reading.has_volumes;
  level.has_particles &= has(reading.fields, "particles");
  const double time = reading.samples.time;
  if (!level.at.emplace(time, std::move(reading.samples)).second)
    throw std::invalid_argument(fmt::format("{}: duplicate spacing {:.4g} m and time {:g} s, expected each pair once",
                                            data.source, spacing, time));
}

void read_into(Given& given, const Flow& flow, const Mapping& mapping, const std::filesystem::path& file,
               std::optional<double> said) {
  for (Dataset& data : rows_to_judge(read_datasets(file))) read_into(given, flow, mapping, std::move(data), said);
}

Given together(std::vector<Given> each) {
  Given all;
  for (const Given& one : each) {
    all.files.insert(all.files.end(), one.files.begin(), one.files.end());
    for (const std::string& line : one.words) all.say(line);
    if (!all.fields) all.fields = one.fields;
    if (one.fields) std::erase_if(*all.fields, [&](const std::string& name) { return !has(*one.fields, name); });
  }
  std::ranges::stable_sort(each, {}, [](const Given& one) { return one.levels.front().at.begin()->first; });
  for (Given& one : each)
    for (GivenLevel& from : one.levels) {
      GivenLevel& level = level_for(all.levels, from);
      level.has_volumes &= from.has_volumes;
      level.has_particles &= from.has_particles;
      for (auto& [time, samples] : from.at)
        if (!level.at.emplace(time, std::move(samples)).second)
          throw std::invalid_argument(
              fmt::format("duplicate spacing {:.4g} m and time {:g} s, expected each pair once", from.spacing, time));
    }
  return all;
}

Judgement judge_given(const Flow& flow, Given given, const Judged& what) {
  Judgement judgement{.files = given.files, .words = given.words};
  std::ranges::sort(given.levels, std::greater{}, &GivenLevel::spacing);
  const std::vector<double>& times = what.times.empty() ? flow.judged.times : what.times;
  Case judged = case_of(flow, given, times, judgement.not_judged);
  Method method{.name = what.name, .description = what.description, .ladders = {{ladder_of_files, {}}}};
  std::vector<Run> runs;
  std::vector<std::pair<std::string, Filling>> fillings;
  for (GivenLevel& level : given.levels) {
    const std::string name = level_name(flow, level.spacing);
    fillings.emplace_back(name, filling_of(flow, name, level, given.fields.value_or(std::vector<std::string>{})));
    runs.push_back(run_of(level, name, flow.judged.monitor));
    if (flow.across / level.spacing > flow.resolved * (1 - 1e-6))
      for (const Claim& claim : flow.of_resolved) judged.claims.push_back(claim.on(name));
    else if (flow.of_coarse)
      for (const Claim& claim : flow.of_coarse(flow.across / level.spacing)) judged.claims.push_back(claim.on(name));
    const double end = level.at.empty() ? times.back() : asked(level.at.rbegin()->first, times, runs.back().samples);
    method.levels.push_back({.name = name, .spacing = level.spacing, .acceptance = end, .report = end, .nightly = end});
    method.ladders[0].levels.push_back(name);
  }
  for (const auto& [name, filling] : fillings) {
    std::ranges::copy(filling.claims, std::back_inserter(judged.claims));
    for (const std::string& line : filling.told) judgement.words.push_back(line);
  }
  judged.measurements.push_back([&](const Level& level, const Run& run) {
    std::vector<Value> values =
        std::ranges::find(fillings, level.name, &std::pair<std::string, Filling>::first)->second.values;
    for (Value& value : values) value.time = asked(value.time, times, run.samples);
    return values;
  });
  method.claims = own_claims(flow, what);
  const Results results{method, what.suite, std::move(runs)};
  judgement.record =
      assess(flow.case_name(), judged, results, what.baselines ? std::optional(*what.baselines) : std::nullopt);
  judgement.record.another_code = true;
  for (const auto& [name, filling] : fillings) {
    say_where(name, filling, judgement.record);
    say_briefly(name, filling, judgement.record);
  }
  std::vector<Claim> claims = judged.claims;
  std::ranges::copy(method.claims, std::back_inserter(claims));
  const bool all_finished =
      std::ranges::all_of(given.levels, [](const GivenLevel& level) { return level.outcome == "finished"; });
  take_rounding_for_converged(claims, judgement.record);
  if (const GivenLevel& finest = given.levels.back(); what.at_most && finest.outcome == "finished")
    limit_errors(*what.at_most, method.levels.back().name, judgement.record);
  refuse_what_is_no_number(judgement.record);
  refuse_what_is_worse_than_nothing(flow, judgement.record);
  for (const std::string field : {"velocity", "pressure"})
    if (given.fields && has(*given.fields, field) &&
        std::ranges::none_of(flow.measured, [&](const Measured& one) { return has(one.fields, field); }))
      judgement.not_judged.push_back(fmt::format("{}: nothing of it is measured in this flow", field));
  if (!std::ranges::all_of(fillings, [](const auto& of_level) { return of_level.second.is_counted; }))
    judgement.not_judged.emplace_back(
        "how many rows there should be: --spacing, volumes, or masses and densities say it; without them a fluid that is "
        "thinned out evenly is not seen");
  if (!what.at_most && given.levels.size() < 3)
    judgement.not_judged.emplace_back(
        "how small the errors are, and how they fall: --at-most PERCENT or at_most in [claims] limits them, three "
        "resolutions show the order");
  diagnose_failures(flow, results, claims, what.diagnose, judgement.record);
  if (all_finished) {
    leave_out_what_is_not_measured(judged.claims, judgement.record);
    leave_out_orders_of_no_time(judged.claims, judgement.record, judgement.not_judged);
    refuse_to_claim_nothing(flow, judgement.record);
  }
  return judgement;
}

Judgement judge_files(const Flow& flow, const std::vector<std::filesystem::path>& files, const Mapping& mapping,
                      std::optional<double> spacing, const Judged& what) {
  const auto judge_in = [&](const Flow& read_by, const std::string& words) {
    programs::Work work(0);  // by the sizes of files
    programs::Progress line("vnv judge");
    for (const std::filesystem::path& file : files) work.expect(file, size_of(file));
    std::vector<Given> each;
    for (const std::filesystem::path& file : files) {
      work.begin(file);
      line.show([&] { return work.sentence(); });
      read_into(each.emplace_back(), read_by, mapping, file, spacing);
      work.end(file);
    }
    line.clear();
    Given given = together(std::move(each));
    if (!mapping.time && !mapping.time_step && !mapping.units.contains("time")) tell_unit_of_times(given, read_by);
    if (!words.empty()) given.say(words);
    Judgement judgement = judge_given(read_by, std::move(given), what);
    std::erase_if(judgement.record.verdicts, [](const Verdict& v) { return v.quantity == end_time_reached; });
    return judgement;
  };
  try {
    return judge_in(flow, "");
  } catch (const LongerThanPeriod& longer) {
    if (!flow.is_uniform_along_x || longer.axis != 0) throw;
    Flow lengthened = flow;  // which changes nothing in its field
    lengthened.domain.box.high.x() = lengthened.filled.high.x() = flow.domain.box.low.x() + longer.length;
    return judge_in(lengthened, fmt::format("{} Judged so.", longer.what()));
  }
}

}  // namespace touchstone::vnv::doors
