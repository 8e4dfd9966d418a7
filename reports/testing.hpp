#pragma once
/// What the tests of this module share: a folder of their own and a small record.

#include "reports/read/cases.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace touchstone::reports {

using files::read_whole;
using programs::ScratchFolder;

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A variable in the environment of the process for as long as this lives.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name), former_(std::getenv(name)) { setenv(name, value, 1); }
  ~Environment() { setenv(name_, former_.c_str(), 1); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string former_;
};

inline vnv::Curve sample_curve(const std::string& label, vnv::Role role = vnv::Role::ours) {
  vnv::Curve curve;
  curve.figure = "profile";
  curve.label = label;
  curve.role = role;
  curve.x = {0, 0.0005, 0.001};
  curve.y = {0, 0.001, 0};
  return curve;
}

inline vnv::Verdict sample_verdict(vnv::Outcome outcome, double margin) {
  vnv::Verdict verdict;
  verdict.case_name = "poiseuille";
  verdict.method = "mpm";
  verdict.level = "M2";
  verdict.quantity = "L2 v_x";
  verdict.unit = "%";
  verdict.value = 1.5;
  if (outcome != vnv::Outcome::inconclusive) verdict.upper = outcome == vnv::Outcome::holds ? 1.59 : 1.15;
  verdict.author = "literature: Sun et al., table 3";
  verdict.outcome = outcome;
  verdict.margin = margin;
  verdict.sentence = "the sentence of this verdict";
  return verdict;
}

/// Errors of second order over spacings that halve from 4 mm, in per cent.
inline vnv::ObservedOrder sample_order(const std::string& quantity = "L2 v_x [%]", double time = 1,
                                       std::size_t spacings = 3) {
  vnv::ObservedOrder order;
  order.ladder = "grid";
  order.quantity = quantity;
  order.time = time;
  order.order = 2;
  order.half_width = spacings > 2 ? 0.1 : std::numeric_limits<double>::infinity();
  order.trend = spacings > 2 ? vnv::Trend::converging : vnv::Trend::inconclusive;
  double spacing = 4e-3, error = 1.6;
  for (std::size_t i = 0; i < spacings; ++i, spacing /= 2, error /= 4) {
    order.levels.push_back(fmt::format("M{}", i + 1));
    order.spacings.push_back(spacing);
    order.errors.push_back(error);
  }
  return order;
}

/// The same, one by one.
inline std::vector<vnv::Value> errors_of(const vnv::ObservedOrder& order) {
  std::vector<vnv::Value> errors;
  for (std::size_t i = 0; i < order.levels.size(); ++i)
    errors.push_back(
        {order.levels[i], order.spacings[i], order.time, vnv::with_heading(order.quantity), order.errors[i]});
  return errors;
}

/// A run that ended, at 1 s.
inline vnv::RunSummary sample_run(const std::string& level, double cpu) {
  vnv::RunSummary run{.level = level, .end_time = 1, .finished = true, .outcome = "finished"};
  run.cost.cpu = run.cost.cpu_lowest = run.cost.cpu_highest = cpu;
  return run;
}

inline std::string sample_fault_keys() {
  return "# machine: a machine\n# tests: the tests that each fault names\n# untried: 0\n";
}

/// The table of trials, with when each of these rows was tried put to its end.
inline std::string fault_table(const std::string& rows) {
  std::string table = "fault,title,files,conclusion,why,test,noticed,margin [-],sentence,revision,tried at,digest\n";
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) table += line + ",abc1234,2026-11-22T04:00:00Z,00ff\n";
  return table;
}

/// One that lives, one that is seen at night, four that are noticed, and two harmless changes, one of them an alarm.
inline std::string sample_fault_rows() {
  return "broken,The spline is wrong,spline.hpp,noticed,,flow.mpm,yes,-inf,flow.mpm: L2 = nan: FAILS\n"
         "far,Too viscous,stress.hpp,noticed,,flow.mpm,yes,-35.831,flow.mpm: L2 = 2: FAILS\n"
         "far,Too viscous,stress.hpp,noticed,,flow.apic,yes,-1,\n"
         "dark,Creeps,stress.hpp,noticed at night,,nightly.flow.mpm,yes,-0.5,\n"
         "formula,A root is missing,fit.cpp norm.cpp,noticed,,unit.solvers.A.B,yes,,\n"
         "formula,A root is missing,fit.cpp norm.cpp,noticed,,unit.solvers.A.C,yes,,\n"
         "lives,A corner is wet,wall.hpp,survived,\"no flow has such a wall, yet\",flow.mpm,no,0.3,\n"
         "lives,A corner is wet,wall.hpp,survived,\"no flow has such a wall, yet\",flow.sph,no,0.8,\n"
         "near,Hardly slower,step.hpp,noticed,,flow.mpm,yes,-0.05,\n"
         "alarm,Sums backwards,norm.cpp,false alarm,,flow.mpm,yes,-0.2,\n"
         "renamed,A name,norm.cpp,stays green,,flow.mpm,no,0.2,\n";
}

inline vnv::Record sample_record(const std::string& method = "mpm") {
  vnv::Record record;
  record.case_name = "poiseuille";
  record.title = "Plane Poiseuille flow";
  record.method = method;
  vnv::Figure figure;
  figure.id = "profile";
  figure.title = "Profiles";
  figure.x.label = "y [mm]";
  figure.x.scale = 1e3;
  figure.y.label = "v_x [mm/s]";
  figure.y.scale = 1e3;
  record.figures = {figure};
  record.curves = {sample_curve(method), sample_curve("exact", vnv::Role::exact)};
  record.verdicts = {sample_verdict(vnv::Outcome::holds, 0.06)};
  return record;
}

}  // namespace touchstone::reports
