#pragma once
/// Gate: whether what comes after is worse than what was before.

#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::gate {

/// What the caller asked for cannot be compared; one line says why.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Which methods of which cases to compare.
struct Choice {
  std::string suite = "acceptance";  // that builds run; records say their own
  std::vector<std::string> cases{};  // names; empty: all
  std::string only{};                // regular expression found in "case.method"; empty: all

  bool includes_case(const std::string& name) const;
  bool includes(const std::string& case_name, const std::string& method) const;
};

struct GateRequest : Choice {
  std::string before{}, after{};     // each a record, a folder of records, a build folder or a git revision
  long repeats = 6;                  // pairs of runs in turn, of builds; 0: values are compared and cost is not
  bool all = false;                  // run programs that are the same, too
  std::filesystem::path markdown{};  // files to write; empty: none
  std::filesystem::path json{};
  std::filesystem::path figure{};  // a record that reports can draw
};

/// What the gate came to, as the exit status of a program.
enum Status { same_or_better = 0, worse = 1, inconclusive = 2, bad_input = 3 };

/// Compares, and writes the findings to `output` and what is being done to `progress`. Builds are run in turn, those
/// methods again whose cost the first runs leave in doubt. Throws BadInput, with one line that says why, for what
/// cannot be compared: the status `bad_input`.
Status gate(const GateRequest& request, std::ostream& output, std::ostream& progress);

/// The same of one method that the caller knows how to run.
struct Contest;
Status gate(const GateRequest& request, const Contest& contest, std::ostream& output, std::ostream& progress);

}  // namespace touchstone::gate
