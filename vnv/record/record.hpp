#pragma once
/// Record: all that a report may know about one method of one case, as plain data.
/// Numbers are SI unless a name says otherwise; only a report rescales. Not a number is a value like another: it is
/// written and read back.

#include "vnv/record/quantity.hpp"

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchstone::vnv {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What one run cost. Times are medians over the repeats.
struct Cost {
  long particles = 0;           // fluid particles
  long boundary_particles = 0;  // ghosts, repulsive particles; none in a grid method
  long steps = 0;
  long repeats = 1;        // how often the run was made
  double cpu = 0;          // s  user time of the steps and the sampling
  double cpu_lowest = 0;   // s  of the repeats
  double cpu_highest = 0;  // s
  double wall = 0;         // s
  double stepping = 0;     // s  the part of `wall` that was spent in the solver's steps
  double harness = 0;      // s  wall time of all else: checks, sampling, measuring, a process of its own
  double peak_memory = 0;  // bytes  largest resident set of the run's process

  double per_step() const { return cpu / static_cast<double>(steps); }                      // s
  double per_particle_step() const { return per_step() / static_cast<double>(particles); }  // s
  double particle_steps_per_second() const { return 1 / per_particle_step(); }              // 1/s
  /// Not a number for a run that timed itself.
  double harness_share() const { return stepping > 0 ? harness / (stepping + harness) : not_a_number; }

  bool operator==(const Cost&) const = default;
};

/// One run of one method at one resolution.
struct RunSummary {
  std::string level{};   // "M2"
  double spacing = 0;    // m
  double time_step = 0;  // s
  double end_time = 0;   // s
  bool finished = false;
  std::string outcome{};  // "finished", or the diagnosis of a diverged run
  Cost cost{};

  bool operator==(const RunSummary&) const = default;
};

/// One number that was measured of one run.
struct Value {
  std::string level;
  double spacing = 0;  // m
  double time = 0;     // s
  Quantity quantity;
  double value = not_a_number;  // in the unit of the quantity

  bool operator==(const Value&) const = default;
};

/// What a ladder of errors says of a method; `observe_order` tells them apart.
enum class Trend { converging, stalled, diverging, inconclusive };
constexpr auto words(Trend) {  // in the order of the enumerators, as the two below
  return std::to_array<std::string_view>({"converging", "stalled", "diverging", "inconclusive"});
}
std::string_view name_of(Trend trend);

/// An observed order of convergence with its 95 % interval, and the floor that the errors fall to, if one was found.
struct ObservedOrder {
  std::string ladder;    // "grid, 4 points per cell"
  std::string quantity;  // heading of what was measured, "L2 v_x, row means [%]"
  double time = 0;       // s
  double order = not_a_number;
  double half_width = not_a_number;  // of the 95 % interval
  Trend trend = Trend::inconclusive;
  bool asymptotic = false;                                       // the finest pairs have the order of all
  double floor = not_a_number, floor_half_width = not_a_number;  // in the unit of the errors; of the 95 % interval
  double order_to_floor = not_a_number, order_to_floor_half_width = not_a_number;
  std::vector<std::string> levels;  // coarse to fine, as the three below
  std::vector<double> spacings;     // m
  std::vector<double> errors;
  std::vector<double> pairwise;  // one fewer than levels

  bool operator==(const ObservedOrder&) const = default;
};

enum class Outcome { holds, fails, inconclusive };
constexpr auto words(Outcome) { return std::to_array<std::string_view>({"holds", "fails", "inconclusive"}); }

/// A claim, judged.
struct Verdict {
  std::string case_name, method, level;
  double spacing = not_a_number;  // m
  double time = not_a_number;     // s
  std::string quantity;           // "L2 v_x, row means", "order of L2 over grid"
  std::string unit;               // "%", "m"; empty for a pure number
  Kind kind = Kind::value;
  Better better = Better::undeclared;
  double value = not_a_number;         // in `unit`
  std::optional<double> lower, upper;  // in `unit`; the limits that are claimed
  std::string author;                  // "theory: ...", "literature: ...", "baseline: ..."
  Outcome outcome = Outcome::inconclusive;
  double margin = not_a_number;  // fraction of the limit left, negative if it fails
  std::string sentence;          // all of it, for a person

  bool operator==(const Verdict&) const = default;
};

/// A figure's frame. Curves and clouds of all methods of a case that name its id are drawn into it.
struct Axis {
  std::string label;  // "y [mm]"
  double scale = 1;   // from SI to the unit in the label
  bool logarithmic = false;
  std::optional<double> low = std::nullopt, high = std::nullopt;  // in the unit of the label; else from the data

  bool operator==(const Axis&) const = default;
};
struct Figure {
  std::string id;       // "profile"; also the stem of its files
  std::string title;    // "Velocity profiles"
  std::string caption;  // one or more sentences; which figure of which paper it re-draws
  Axis x, y;
  Axis colour{};  // for clouds
  bool equal_axes = false;

  bool operator==(const Figure&) const = default;
};

/// Who speaks: decides how a curve is drawn.
enum class Role { ours, exact, experiment, published, guide, best };
constexpr auto words(Role) {
  return std::to_array<std::string_view>({"ours", "exact", "experiment", "published", "guide", "best"});
}

struct Curve {
  std::string figure;  // id of its figure
  std::string label;   // in the key; curves of equal figure and label are one curve, drawn once
  Role role = Role::ours;
  std::vector<double> x, y;  // SI
  bool points = false;       // draw points, not a line

  bool operator==(const Curve&) const = default;
};

/// Particles coloured by a field; one panel of a figure.
struct Cloud {
  std::string figure;
  std::string column, row;  // "MPM", "t = 0.32 s": where the panel stands in the figure
  std::vector<double> x, y, colour;

  bool operator==(const Cloud&) const = default;
};

/// A table of a page. Rows of all methods of a case that name its id are joined; equal rows appear once.
using Cell = std::variant<std::string, double>;
struct Table {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<std::string> columns;  // with units
  std::vector<std::vector<Cell>> rows;

  bool operator==(const Table&) const = default;
};

/// What a run monitored over time, as a CSV file beside the record: time and each quantity by its heading.
struct HistoryFile {
  std::string level;
  std::string file;    // "histories/dam_break.mpm.M2.csv", within the folder of the record
  std::string text{};  // of the file, to be written with the record; empty in a record that was read

  bool operator==(const HistoryFile&) const = default;
};

/// A diagram of error over CPU time, with the errors whose cost is reported.
struct WorkDiagram {
  std::string id;                   // "work"; also the stem of its files
  std::string title;                // "Error against run time"
  std::string caption;              // which error, at which time
  Quantity quantity;                // the error; its heading labels the axis
  std::vector<double> targets;      // in its unit, falling
  double ranked_by = not_a_number;  // the target that ranks the methods

  bool operator==(const WorkDiagram&) const = default;
};

/// One run as a point of such a diagram.
struct WorkPoint {
  std::string diagram{};   // id
  std::string series{};    // "mpm", "Sun et al. MPM"
  std::string family{};    // "MPM" or "SPH"
  std::string run{};       // "M2"
  bool elsewhere = false;  // measured by others or on another machine
  double particles = 0;
  double per_step = not_a_number;                                // s  CPU time of a step
  double error = not_a_number;                                   // in the unit of the diagram
  double cpu = not_a_number;                                     // s  median of the repeats
  double cpu_lowest = not_a_number, cpu_highest = not_a_number;  // s

  bool operator==(const WorkPoint&) const = default;
};

/// The quantity of the one verdict on a method that could not be assessed: 0 instead of 1.
inline constexpr std::string_view could_be_assessed = "assessed";
/// The quantity of the one verdict on the values of a method that were never accepted: how many.
inline constexpr std::string_view never_accepted = "values without an accepted baseline";

struct Record {
  int schema = 4;
  std::string case_name;    // "poiseuille"
  std::string title;        // "Start-up of plane Poiseuille flow"
  std::string description;  // what is solved, with which oracle, for the page; plain text, blank lines part paragraphs
  std::string method;       // "mpm"
  std::string method_description;
  std::string suite;  // "acceptance", "report" or "nightly"
  std::string revision, compiler, flags, machine, finished_at;
  std::vector<RunSummary> runs;
  std::vector<Value> values;
  std::vector<ObservedOrder> orders;
  std::vector<Verdict> verdicts;
  std::vector<Figure> figures;
  std::vector<Curve> curves;
  std::vector<Cloud> clouds;
  std::vector<Table> tables;
  std::vector<WorkDiagram> diagrams;
  std::vector<WorkPoint> work;
  std::vector<HistoryFile> histories;

  bool operator==(const Record&) const = default;
};

/// Writes the record whole or not at all, after the histories that it lists.
/// Throws std::runtime_error naming the file and the cause.
void write(const Record& record, const std::filesystem::path& file);

/// Throws std::runtime_error naming the file and what is wrong with it.
Record read_record(const std::filesystem::path& file);

}  // namespace touchstone::vnv
