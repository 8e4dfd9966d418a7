#pragma once
/// Description: what a case says of itself before anything runs, as plain data and as JSON. Numbers are SI; what is
/// absent there is none of.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

struct LevelDescription {
  std::string name{};                        // "M2"
  double spacing = 0;                        // m
  std::optional<double> cell{};              // m
  std::optional<double> smoothing_length{};  // m  unless that of the method
  std::optional<double> time_step{};         // s  its own or that of the method; absent where a run finds its steps
  std::map<std::string, double> until{};     // s  by suite: "nightly"; suites that do not run it are absent

  bool operator==(const LevelDescription&) const = default;
};

struct LadderDescription {
  std::string name;
  std::vector<std::string> levels;  // names, coarse to fine

  bool operator==(const LadderDescription&) const = default;
};

struct ClaimDescription {
  std::string quantity;                // with its unit
  std::optional<double> lower, upper;  // in that unit
  std::string author;                  // "theory: ...", "literature: ...", "baseline: ..."
  std::string level;                   // where it holds; empty: on every level
  std::optional<double> time;          // s  absent: at every time
  std::string ladder;                  // for an observed order: over which levels
  std::optional<double> surely_above;  // for an observed order
  long least_levels = 0;               // for an observed order: suites that run fewer are not asked

  bool operator==(const ClaimDescription&) const = default;
};

struct ToleranceDescription {
  double relative = 0;
  double absolute = 0;  // in any unit
  std::string basis;

  bool operator==(const ToleranceDescription&) const = default;
};

struct MethodDescription {
  std::string name;  // "mpm"
  std::string description;
  std::vector<LevelDescription> levels;
  std::vector<LadderDescription> ladders;
  std::vector<ClaimDescription> claims;
  ToleranceDescription tolerance;  // of new baselines
  double relative_cost = 0;
  long baselines = 0;  // values that were accepted

  bool operator==(const MethodDescription&) const = default;

  bool is_run_in(std::string_view suite) const;
};

/// Who last accepted values, when and why; all empty if nobody has.
struct AcceptanceDescription {
  std::string revision, date, reason;

  bool operator==(const AcceptanceDescription&) const = default;
};

struct Description {
  int schema = 1;
  std::string name;  // "poiseuille"
  std::string title, description;
  std::vector<std::string> suites;  // that run any of it
  std::vector<double> times;        // s
  bool timed = false;               // what it judges is time: nothing else should run beside it
  std::string label;
  std::string priced_as;                 // the case whose prices choose its default method
  std::vector<ClaimDescription> claims;  // of any method
  std::vector<MethodDescription> methods;
  std::string data_folder;
  std::vector<std::string> tables;  // files that its declaration reads
  std::string baseline_file;        // there may be none yet
  AcceptanceDescription acceptance;

  bool operator==(const Description&) const = default;
};

std::string json_of(const Description& description);

/// Throws std::runtime_error naming the source of the text and what is wrong with it.
Description description_in(const std::string& text, const std::string& source);

}  // namespace touchstone::vnv
