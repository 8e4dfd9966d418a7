#pragma once
/// Codes of others among what a command is asked for: a word that ends in .toml is the file of a solver.

#include "vnv/command/commands.hpp"
#include "vnv/command/tasks.hpp"
#include "vnv/doors/solver.hpp"

namespace touchstone::vnv::command {

/// Takes the solvers' files out of the patterns.
std::vector<doors::Solver> take_solvers(Patterns& patterns);

/// The flows that patterns choose, as `matches` of patterns.hpp does, in an installed copy, which has no cases. Throws
/// std::invalid_argument for a pattern that chooses none.
std::vector<std::string> chosen_flows(const Patterns& patterns);

/// "poiseuille.pysph", as a case and its method.
void print_solvers(const std::vector<doors::Solver>& solvers);

/// Runs a solver in RECORDS/runs/CASE.METHOD and writes its record, RECORDS/CASE.METHOD.json. What it takes is expected
/// by its last record, in that folder or in another.
doors::Judgement run_and_record(const doors::Solver& solver, const std::string& suite,
                                const std::filesystem::path& records, const std::filesystem::path& last_records = {});

/// What `vnv run` would do with a solver: its resolutions, and what they cost by its record in a folder.
std::vector<Task> tasks_of(const doors::Solver& solver, const std::filesystem::path& records);

Suite suite_named(const std::string& name);

}  // namespace touchstone::vnv::command
