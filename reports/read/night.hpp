#pragma once
/// The summary of one night: every number and every verdict of its records, without figures and tables. It is a
/// file of JSON lines, whose form data/README.md describes.

#include "reports/read/cases.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace touchstone::reports {

/// One run of a method.
struct NightRun {
  std::string case_name, method, level;
  double spacing = 0;    // m
  double time_step = 0;  // s
  bool finished = false;
  std::string outcome;                   // "finished", or the diagnosis of a diverged run
  double cpu = 0;                        // s  user time of the steps and the sampling
  double wall = 0;                       // s
  double peak_memory = 0;                // bytes
  long particles = 0, steps = 0;         // fluid particles
  double particle_steps_per_second = 0;  // 1/s
  std::string machine{};                 // that of the night where nights did not note it yet

  bool operator==(const NightRun&) const = default;
};

/// An error norm, a stability limit, or whatever else a run has measured.
struct NightValue {
  std::string case_name, method, level;
  double spacing = 0;    // m
  double time = 0;       // s
  std::string quantity;  // with its unit, "L2 v_x [%]"
  double value = vnv::not_a_number;

  bool operator==(const NightValue&) const = default;
};

/// An observed order; above a floor where the errors fall to one.
struct NightOrder {
  std::string case_name, method, ladder, quantity;
  double time = 0;  // s
  long levels = 0;
  double order = vnv::not_a_number, half_width = vnv::not_a_number;  // of the 95 % interval

  bool operator==(const NightOrder&) const = default;
};

/// A claim, judged.
struct NightVerdict {
  std::string case_name, method, level;
  double spacing = vnv::not_a_number;  // m
  double time = vnv::not_a_number;     // s
  std::string quantity;                // with its unit
  std::string author;
  double value = vnv::not_a_number;
  std::optional<double> lower, upper;
  double margin = vnv::not_a_number;  // fraction of the limit left
  vnv::Outcome outcome = vnv::Outcome::inconclusive;

  bool operator==(const NightVerdict&) const = default;
};

struct Night {
  std::string suite, revision, compiler, flags, machine, finished_at;
  std::vector<NightRun> runs;
  std::vector<NightValue> errors, limits;  // norms and the like; largest stable steps
  std::vector<NightOrder> orders;
  std::vector<NightVerdict> verdicts;

  bool operator==(const Night&) const = default;
};

/// The night is that of the record which finished last. Throws std::runtime_error if none says when it finished.
Night night_of(const std::vector<CaseRecords>& cases);

/// "2026-11-22T172534Z_bbb2d82.jsonl": the same night has the same name.
std::string file_name(const Night& night);

/// Writes the night into a folder, which is made if need be: whole or not at all, beside earlier ones. Equal nights
/// give equal bytes. Throws std::runtime_error naming the file and the cause.
void write_night(const Night& night, const std::filesystem::path& folder);

/// Throws std::runtime_error naming file, line and what is wrong with it: a line that is missing or torn, another
/// schema.
Night read_night(const std::filesystem::path& file);

/// Nights of one suite, oldest first. A file that is no whole night is left out and named, in one line each: it must
/// cost neither tonight's pages nor the other nights, and must not be passed over in silence.
struct History {
  std::vector<Night> nights;
  std::vector<std::string> refused;
};

/// Reads every *.jsonl of the folder. Throws std::runtime_error if it cannot be listed.
History read_history(const std::filesystem::path& folder, const std::string& suite);

}  // namespace touchstone::reports
