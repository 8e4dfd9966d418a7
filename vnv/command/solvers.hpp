#pragma once
/// Codes of others among what a command is asked for: a word that ends in .toml is the file of a solver.

#include "vnv/command/commands.hpp"
#include "vnv/doors/solver.hpp"

namespace touchstone::vnv::command {

/// Takes the solvers' files out of the patterns.
std::vector<doors::Solver> take_solvers(Patterns& patterns);

/// "poiseuille.pysph", as a case and its method.
void print_solvers(const std::vector<doors::Solver>& solvers);

/// Runs a solver in RECORDS/runs/CASE.METHOD and writes its record, RECORDS/CASE.METHOD.json. What it takes is expected
/// by its last record, in that folder or in another.
doors::Judgement run_and_record(const doors::Solver& solver, const std::string& suite,
                                const std::filesystem::path& records, const std::filesystem::path& last_records = {});

Suite suite_named(const std::string& name);

}  // namespace touchstone::vnv::command
