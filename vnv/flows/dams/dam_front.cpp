#include "vnv/flows/dams/dam_front.hpp"

#include "reference/dam_front.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {
namespace {

constexpr Window judged_times{1, 1.5};  // of T: after the gate has risen, before the wall is met
constexpr Window slope_times{1, 1.58};  // of T: until the measured front meets the wall
constexpr Window shifts{-0.3, 0.3};     // of T: the largest doubt about the origin of time of such an experiment

const std::string front_by = "front L, ";

/// What an experiment measured of columns of one aspect: L, or the residual height, over T.
struct Experiment {
  std::string name;
  bool is_front;
  FrontHistory measured;
  Window shifts;  // of T: as its file bounds them
};

/// Those of the best read-out of each, whose column is as many times as high as it is long: all tables of
/// data/experiments/ that name their experiment and have a front or a height over T, the one of most points first.
std::vector<Experiment> experiments_of(double aspect) {
  std::vector<Experiment> all;
  for (DataTable& table : read_experiments(data_folder() / "experiments")) {
    const Provenance& from = table.provenance();
    const auto its = from.geometry.find("column_aspect");
    if (its == from.geometry.end() || std::abs(its->second.value / aspect - 1) > 1e-3) continue;
    const std::string name = from.experiment;
    const auto origin = from.uncertainty.find("T.origin");
    const double most = origin == from.uncertainty.end() ? shifts.high : origin->second.value;
    if (!from.read_out.empty()) table = table.only("series", from.read_out);
    const bool is_front = table.has("L [-]");
    all.push_back({name,
                   is_front,
                   {table.numbers("T [-]"), table.numbers(is_front ? "L [-]" : "eta [-]")},
                   {-most, most}});
  }
  std::ranges::stable_sort(all, std::greater{}, [](const Experiment& one) { return one.measured.T.size(); });
  return all;
}

double residual_height(const DamFront& dam, const Samples& samples) {
  const double strip = dam.column_length / 10;
  return volume_behind(samples, strip) / strip / dam.column_height;
}

/// T until which a measured front is judged: after that it may have met the far wall.
double near_wall(const FrontHistory& front, double tank) {
  double last = front.T.front();
  for (std::size_t k = 0; k < front.T.size() && front.L[k] < 0.96 * tank; ++k) last = front.T[k];
  return last;
}

enum Column { half_full, percentile, farthest, mass, inside };

/// A slab is blind to a sheet of one particle, a percentile of few particles to the last of them.
double front_of_either(const Samples& samples, double slab_side) {
  return std::max(half_full_slab(samples, slab_side), percentile_front(samples));
}

DataTable measured_by_lobovsky(const DamFront& dam) {
  const DataTable table = read_table(data_folder() / "experiments" / "lobovsky_2014_front_600.csv");
  require_geometry(table, "column_length", dam.column_length, 1e-3);
  require_geometry(table, "column_height", dam.column_height, 1e-3);
  require_geometry(table, "tank_length", dam.tank_length, 1e-3);
  return table;
}

FrontHistory history_of(const DamFront& dam, const Run& run, Column column) {
  FrontHistory front;
  for (std::size_t k = 0; k < run.history.time.size(); ++k) {
    front.T.push_back(dam.scaled_time(run.history.time[k]));
    front.L.push_back(run.history.values[k][column]);
  }
  return front;
}

/// T when a front comes within a slab of the far wall, between two samples, or infinity.
double arrival(const DamFront& dam, const FrontHistory& front) {
  const double there = (dam.tank_length - dam.slab) / dam.column_length;
  for (std::size_t k = 1; k < front.T.size(); ++k)
    if (front.L[k] > there)
      return std::lerp(front.T[k - 1], front.T[k], (there - front.L[k - 1]) / (front.L[k] - front.L[k - 1]));
  return std::numeric_limits<double>::infinity();
}

/// The worst number over the history.
double largest_departure(const Run& run, Column column) {
  double worst = 0;
  for (const std::vector<double>& row : run.history.values) {
    const double departure = row[column] - run.history.values.front()[column];
    if (!std::isnan(worst) && !(std::abs(departure) <= std::abs(worst))) worst = departure;
  }
  return worst;
}

}  // namespace

std::vector<double> DamFront::monitored(const Samples& samples) const {
  const Scalars x = samples.x.row(0), y = samples.x.row(1);
  const auto in_tank = (x >= 0 && x <= tank_length && y >= 0 && y <= tank_height).count();
  const double side = std::isnan(slab) ? 2 * std::sqrt(samples.mass.maxCoeff() / density) : slab;
  return {half_full_slab(samples, side) / column_length, percentile_front(samples) / column_length,
          farthest_particle(samples) / column_length, samples.mass.sum(), static_cast<double>(in_tank)};
}

std::vector<Value> DamFront::positions(const Level& level, const Samples& samples) const {
  const double dx = level.spacing, l0 = column_length;
  const auto value = [&](const std::string& name, double found) {
    return Value{level.name, dx, samples.time, {name}, found};
  };
  return {value(front_by + "half-full slab of l0 / 30", half_full_slab(samples, l0 / 30) / l0),
          value(front_by + of_thin_slab, half_full_slab(samples, 2 * dx) / l0),
          value(front_by + "99.5th percentile", percentile_front(samples) / l0),
          value(front_by + "farthest particle of the main body", farthest_of_body(samples, 2 * dx) / l0),
          value(front_by + "farthest particle", farthest_particle(samples) / l0),
          value(of_residual_height, residual_height(*this, samples))};
}

Quantity DamFront::speed_of(const std::string& front) { return {"front speed dL/dT, " + front}; }
Quantity DamFront::speed_error_of(const std::string& front, const std::string& experiment) {
  return {fmt::format("relative error of the front speed against {}, {}", experiment, front), "%", Kind::deviation};
}
Quantity DamFront::rms_of(const std::string& front, const std::string& experiment) {
  return {fmt::format("RMS error against {}, {}", experiment, front), "", Kind::error};
}
Quantity DamFront::rms_at_best_shift_of(const std::string& front, const std::string& experiment) {
  return {fmt::format("RMS error against {}, with the best time shift, {}", experiment, front), "", Kind::error};
}

std::vector<Value> DamFront::against_experiments(const Level& level, const Run& run) const {
  std::vector<Quantity> measured;
  std::vector<FrontHistory> ours;
  for (const Samples& samples : run.samples) {
    const std::vector<Value> now = positions(level, samples);
    ours.resize(now.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (measured.size() < now.size()) measured.push_back(now[k].quantity);
      ours[k].T.push_back(scaled_time(samples.time));
      ours[k].L.push_back(now[k].value);
    }
  }
  std::vector<Value> found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({level.name, level.spacing, run.summary.end_time, quantity, value});
  };
  for (const Experiment& experiment : experiments_of(column_height / column_length)) {
    const FrontHistory& theirs = experiment.measured;
    Window window = experiment.is_front ? Window{judged_times.low, near_wall(theirs, tank_length / column_length)}
                                        : Window{std::max(0.4, theirs.T.front()), theirs.T.back()};
    window.high = std::min(window.high, ours[0].T.back() - experiment.shifts.high);
    for (std::size_t k = 0; k < ours.size(); ++k) {
      const std::string name = measured[k].name;
      if (name.starts_with(front_by) != experiment.is_front) continue;
      const std::string front = experiment.is_front ? name.substr(front_by.size()) : name;
      const FrontComparison judged = compare_fronts(ours[k], theirs, window, window, experiment.shifts);
      add(rms_of(front, experiment.name), judged.rms);
      add(rms_at_best_shift_of(front, experiment.name), judged.rms_at_best_shift);
      add({fmt::format("best time shift in T against {}, {}", experiment.name, front)}, judged.best_shift);
      if (experiment.is_front)
        add(speed_error_of(front, experiment.name), 100 * (judged.slope / judged.measured_slope - 1));
      if (experiment.is_front && std::ranges::find(found, speed_of(front), &Value::quantity) == found.end())
        add(speed_of(front), judged.slope);
    }
  }
  return found;
}

std::vector<Value> DamFront::lead(const Level& level, const Run& run) const {
  std::vector<FrontHistory> theirs;
  for (Experiment& experiment : experiments_of(column_height / column_length))
    if (experiment.is_front) theirs.push_back(std::move(experiment.measured));
  std::vector<Value> least;
  for (const Samples& samples : run.samples) {
    const double T = scaled_time(samples.time), late = T - shifts.high;
    double slowest = std::numeric_limits<double>::infinity();
    for (const FrontHistory& front : theirs)
      if (T >= judged_times.low && late >= front.T.front() && late <= front.T.back())
        slowest = std::min(slowest, front_at(front, late));
    const double slab_side = 2 * level.spacing;
    if (!(slowest * column_length < tank_length - 2 * slab_side)) continue;  // nearer to it the slab is in a splash
    const double lead = front_of_either(samples, slab_side) / column_length - slowest;
    if (least.empty() || !(lead >= least[0].value))  // no front is the worst
      least = {{level.name, level.spacing, samples.time, least_lead, lead}};
  }
  return least;
}

std::vector<Value> DamFront::off(const Level& level, const Run& run) const {
  std::vector<Value> largest;
  for (const Experiment& one : experiments_of(column_height / column_length)) {
    if (!one.is_front || one.name.starts_with("Martin")) continue;
    const double last = std::min(judged_times.high, near_wall(one.measured, tank_length / column_length));
    for (const Samples& samples : run.samples) {
      const double T = scaled_time(samples.time);
      if (T < std::max(judged_times.low, one.measured.T.front()) || T > last) continue;
      const double front = front_of_either(samples, 2 * level.spacing) / column_length,
                   error = std::abs(front - front_at(one.measured, T));
      if (largest.empty() || !(error <= largest[0].value))
        largest = {{level.name, level.spacing, samples.time, largest_error, error}};
    }
  }
  return largest;
}

std::vector<Value> DamFront::kept(const Level& level, const Run& run) const {
  if (!run.summary.finished) return {};
  const double end = run.summary.end_time,
               change = run.history.values.back()[mass] / (density * column_length * column_height) - 1;
  return {{level.name, level.spacing, end, mass_change, change},
          {level.name, level.spacing, end, lost, 0 - largest_departure(run, inside)}};
}

std::vector<Value> DamFront::compare(const Level& level, const Run& run) const {
  std::vector<Value> found = kept(level, run);
  std::ranges::copy(against_lobovsky(level, run), std::back_inserter(found));
  return found;
}

std::vector<Value> DamFront::against_lobovsky(const Level& level, const Run& run) const {
  std::vector<Value> found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({level.name, level.spacing, run.summary.end_time, quantity, value});
  };
  if (!run.summary.finished) return found;

  constexpr double end_of_data = 1.59;  // T when the measured front meets the wall
  if (scaled_time(run.summary.end_time) < end_of_data) return found;
  const DataTable table = measured_by_lobovsky(*this);
  const FrontHistory measured{table.numbers("T [-]"), table.numbers("L [-]")};
  const FrontHistory ours = history_of(*this, run, half_full);
  const double end_of_slope = std::min(slope_times.high, arrival(*this, ours));
  const FrontComparison judged = compare_fronts(ours, measured, judged_times, {slope_times.low, end_of_slope}, shifts);
  const double measured_slope = slope_of("the measured", measured, slope_times);  // 1.34, as its authors give it
  add(rms, judged.rms);
  add({"best-fit time shift in T"}, judged.best_shift);
  add({"RMS error of L for T in [1, 1.5], with the best time shift", "", Kind::error}, judged.rms_at_best_shift);
  add({"front speed dL/dT from T = 1 to 1.58 or impact"}, judged.slope);
  add(slope_error, 100 * (judged.slope / measured_slope - 1));
  add({"relative error of the front speed dL/dT over the same range of T", "%", Kind::deviation},
      100 * (judged.slope / judged.measured_slope - 1));
  add({"impact time at the downstream wall, T"}, arrival(*this, ours));
  add(rms_of_percentile,
      compare_fronts(history_of(*this, run, percentile), measured, judged_times, judged_times, shifts).rms);
  add({"RMS error of L, without time shift, front as farthest particle", "", Kind::error},
      compare_fronts(history_of(*this, run, farthest), measured, judged_times, judged_times, shifts).rms);
  return found;
}

const Run* finest(const Results& results) {
  const auto found = std::ranges::min_element(results.runs, {}, [](const Run& run) { return run.summary.spacing; });
  return found == results.runs.end() || found->history.values.empty() ? nullptr : &*found;
}

Plot DamFront::history(Figure frame, std::vector<std::string> levels) const {
  return [dam = *this, frame, levels, all = experiments_of(column_height / column_length)](const Results& results,
                                                                                           Record& record) {
    record.figures.push_back(frame);
    std::vector<const Run*> runs{finest(results)};
    if (!levels.empty()) runs.clear();
    for (const std::string& level : levels) runs.push_back(results.run(level));
    for (const Run* run : runs)
      if (run) {
        const FrontHistory ours = history_of(dam, *run, half_full);
        record.curves.push_back(
            {frame.id, results.method.name + " " + run->summary.level, Role::ours, ours.T, ours.L, false});
      }
    for (const Experiment& one : all)
      if (one.is_front)
        record.curves.push_back({frame.id, one.name, Role::experiment, one.measured.T, one.measured.L, true});
    const reference::RitterFront ritter{.g = dam.gravity, .h0 = dam.column_height, .l0 = dam.column_length};
    Curve bound{frame.id, "Ritter 1892", Role::guide, {}, {}, false};
    for (const double T : {0.0, (frame.y.high.value() - 1) / 2}) {
      bound.x.push_back(T);
      bound.y.push_back(ritter(T / dam.scaled_time(1)) / dam.column_length);
    }
    record.curves.push_back(std::move(bound));
  };
}

Plot DamFront::residual_heights(Figure frame) const {
  return [dam = *this, frame, all = experiments_of(column_height / column_length)](const Results& results,
                                                                                   Record& record) {
    record.figures.push_back(frame);
    if (const Run* run = finest(results)) {
      Curve ours{frame.id, results.method.name + " " + run->summary.level, Role::ours, {}, {}, false};
      for (const Samples& samples : run->samples) {
        ours.x.push_back(dam.scaled_time(samples.time));
        ours.y.push_back(residual_height(dam, samples));
      }
      record.curves.push_back(std::move(ours));
    }
    for (const Experiment& one : all)
      if (!one.is_front)
        record.curves.push_back({frame.id, one.name, Role::experiment, one.measured.T, one.measured.L, true});
  };
}

Plot DamFront::models() const {
  const DataTable published = read_table(data_folder() / "papers" / "sun_table_5.csv",
                                         {"cell [m]", "particles per cell [-]", "boundary particles [-]"});
  return [published](const Results& results, Record& record) {
    Table table{
        "models",
        "Table 5 of Sun et al., with the values used here",
        "Our walls are as high as the domain and their corners are filled, so there are more boundary particles. The "
        "paper says that a step of SPH costs 2.6 to 4.6 times one of MPM.",
        {"method", "model", "particles paper", "particles ours", "ratio", "boundary particles paper",
         "boundary particles ours", "ratio", "T_p ours [ms]", "memory ours [MB]"},
        {}};
    const std::string method = results.method.family == Family::mpm ? "MPM" : "SPH";
    const DataTable paper = published.only("method", method);
    for (std::size_t k = 0; k < paper.rows(); ++k) {
      const Run* run = results.run(paper.words("model")[k]);
      if (!run) continue;
      const Cost& cost = run->summary.cost;
      std::vector<Cell> row = {results.method.name, paper.words("model")[k]};
      const auto compare = [&](double printed, double ours) {
        if (std::isnan(printed))
          row.insert(row.end(), {"none", ours, "none"});
        else
          row.insert(row.end(), {printed, ours, ours / printed});
      };
      compare(paper.numbers("particles [-]")[k], static_cast<double>(cost.particles));
      compare(paper.numbers("boundary particles [-]")[k], static_cast<double>(cost.boundary_particles));
      row.insert(row.end(), {1e3 * cost.per_step(), 1e-6 * cost.peak_memory});
      table.rows.push_back(std::move(row));
    }
    record.tables.push_back(std::move(table));
  };
}

}  // namespace touchstone::vnv
