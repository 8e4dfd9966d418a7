#pragma once
/// Record: all that a report may know about one method of one case, as plain data.
/// Numbers are SI unless a name says otherwise; only a report rescales. Not a number is a value like another: it is
/// written and read back.

#include "vnv/record/diagnosis.hpp"
#include "vnv/record/figure.hpp"
#include "vnv/record/observed_order.hpp"
#include "vnv/record/run_summary.hpp"
#include "vnv/record/value.hpp"
#include "vnv/record/verdict.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// What a run monitored over time, as a CSV file beside the record: time and each quantity by its heading.
struct HistoryFile {
  std::string level;
  std::string file;    // "histories/dam_break.mpm.M2.csv", within the folder of the record
  std::string text{};  // of the file, to be written with the record; empty in a record that was read

  bool operator==(const HistoryFile&) const = default;
};

/// A diagram of error over CPU time, with the errors whose cost is reported. Its points are those in `work`; of a
/// record that brings none, another code's too, its runs, by what was measured of this very quantity.
struct WorkDiagram {
  std::string id;                   // "work"; also the stem of its files
  std::string title;                // "Error against run time"
  std::string caption;              // which error, at which time; empty: the report says it
  Quantity quantity;                // the error; its heading labels the axis
  std::vector<double> targets;      // in its unit, falling; none: those between which the methods differ
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
  int schema = 5;
  std::string case_name;    // "poiseuille"
  std::string title;        // "Start-up of plane Poiseuille flow"
  std::string description;  // what is solved, with which oracle, for the page; plain text, blank lines part paragraphs
  std::string method;       // "mpm"
  std::string method_description;
  bool another_code = false;  // by a code from elsewhere, of which nothing was accepted here
  bool as_printed = false;    // one of the two methods of Sun et al.
  std::string suite;          // "acceptance", "report", "nightly", "work" or "validation"
  std::string revision, compiler, flags, machine, finished_at;
  std::string host{};  // that `machine` is one of, by its name; empty where nobody noted it
  std::vector<RunSummary> runs;
  std::vector<Value> values;
  std::vector<ObservedOrder> orders;
  std::vector<Verdict> verdicts;
  std::vector<Diagnosis> diagnoses;  // of another code, whose flow has an exact field
  std::vector<Figure> figures;
  std::vector<Curve> curves;
  std::vector<Cloud> clouds;
  std::vector<Table> tables;
  std::vector<WorkDiagram> diagrams;
  std::vector<WorkPoint> work;
  std::vector<HistoryFile> histories;

  bool operator==(const Record&) const = default;
};

/// Which one machine it was: "n1, AMD EPYC, 2 processors". Costs of several are not compared.
std::string one_machine(const Record& record);

/// What contradicts a verdict in its own record: its numbers come to another outcome, its level was not run, or what
/// was measured there is another number. Empty if nothing does.
std::string contradiction(const Verdict& verdict, const Record& record);

/// What explains the error that a verdict is of, at its level, of an order at the finest; null where nobody asked.
const Diagnosis* diagnosis_of(const Verdict& verdict, const Record& record);

/// The record as JSON.
std::string as_json(const Record& record);

/// Writes the record whole or not at all, after the histories that it lists.
/// Throws std::runtime_error naming the file and the cause.
void write(const Record& record, const std::filesystem::path& file);

/// A record is not believed but judged again: a verdict fails, and says "inconsistent record", where its outcome is not
/// that of its value and limits, its value not the one that was measured, or its level one that was not run.
/// Throws std::runtime_error naming the file and what is wrong with it.
Record read_record(const std::filesystem::path& file);
/// The same of a text at hand; `source` is its name in messages.
Record record_in(const std::string& text, const std::string& source);

}  // namespace touchstone::vnv
