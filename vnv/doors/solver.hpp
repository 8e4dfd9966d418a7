#pragma once
/// Another code as a method of a flow: a TOML file says how to run it and what it writes; it is run in a process of its
/// own, within limits, measured and judged.

#include "vnv/doors/judge.hpp"
#include "vnv/programs/limited.hpp"

namespace touchstone::vnv::doors {

/// What a TOML file says of a code; all its keys are in vnv/doors/README.md.
struct Solver {
  std::filesystem::path file{};
  std::string name{}, description{};
  Flow flow{};
  std::vector<double> spacings{};              // m  falling
  std::vector<double> times{};                 // s  rising
  std::map<std::string, std::string> needs{};  // a program or a file -> how to get it
  programs::Words command{};                   // with replacement fields, or one line for a shell
  bool is_for_shell = false;
  std::vector<std::string> output{};  // patterns of files, in the folder of a run
  Mapping mapping{};
  programs::ProgramLimits limits{};
  Resource resource = Resource::cpu;  // that a run occupies as long as it takes
  double resources = 0;               // how many of it
  std::optional<double> at_most{}, order_at_least{};
  std::filesystem::path baselines{};  // folder; empty: none are kept
  double tolerance = 1e-6;            // of a new baseline, relative

  std::filesystem::path baseline_file() const { return baselines / (flow.case_name() + ".csv"); }
  std::string case_and_method() const { return flow.case_name() + "." + name; }
};

/// What the solver needs and this machine has not, with how to get it; empty where it can run.
std::string missing_here(const Solver& solver);

/// Throws std::invalid_argument: file, line, key, what it holds and what was expected.
Solver read_solver(const std::filesystem::path& file);

/// Makes a folder for each resolution, with scene.json, particles.csv and run.sh, which runs the code. What was in them
/// is gone.
void prepare(const Solver& solver, const std::filesystem::path& folder);

/// Runs each resolution that was prepared, the coarsest first, and judges what it wrote. One that ends badly, at a
/// limit or without all it was asked for has no answer: its record says why, with the last lines that it said. How far
/// it is stands on stderr, by what resolutions took last [s], of those that have run, by the names of their levels.
Judgement run_solver(const Solver& solver, const std::filesystem::path& folder, Suite suite,
                     const std::map<std::string, double>& expected = {});

/// Judges what was written in prepared folders by runs that somebody else made. Of their cost only the wall time is
/// known, with that what they occupied, where run.sh ran them to its end.
Judgement collect(const Solver& solver, const std::filesystem::path& folder, Suite suite);

/// Writes the values of a record, which was judged without baselines, as those of this solver. Throws
/// std::invalid_argument while a claim does not hold, and where the solver's file names no folder for baselines.
void accept(const Solver& solver, const Record& record, const std::string& reason);

}  // namespace touchstone::vnv::doors
