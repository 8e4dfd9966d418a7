#pragma once
/// What came of a method: by its record, and by how its program ended.

#include "vnv/command/engines.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv::command {

struct MethodOutcome {
  long held = 0, judged = 0;            // claims
  double spent = 0;                     // s  of all its runs
  Resource resource = Resource::cpu;    // of which
  std::vector<std::string> failures{};  // sentences, also of what is inconclusive
  bool is_inconclusive = false;         // nothing failed, and something cannot be told
  bool is_of_method = true;  // not of a crash or of what kept it from being assessed, which may be the machine's
};

MethodOutcome outcome_in(const Record& record);

/// Of a program that has just ended, and the record it was to write. A program that did not end by itself, that wrote
/// no record, or that failed although no claim did, is a failure of its own; `log` is where it said why, and is quoted.
MethodOutcome outcome_of(const std::string& name, const JobResult& result, const std::filesystem::path& record,
                         const std::filesystem::path& log);

/// Whether another run would give the same: then the method need not run again.
bool is_conclusive(const MethodOutcome& outcome, const JobResult& result);

}  // namespace touchstone::vnv::command
