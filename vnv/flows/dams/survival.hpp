#pragma once
/// Whether a method runs dam breaks to 2 s from many starts, and how much energy it makes: of runs that monitor their
/// three energies over the fall, at levels called "COLUMN, 20 across, start 1".

#include "vnv/flows/dams/dam.hpp"

namespace touchstone::vnv {

inline const Quantity ended_early{"runs that ended before 2 s", "", Kind::count, Better::smaller},
    first_end{"earliest end of a run", "s", Kind::value, Better::larger},
    most_energy_made{energy_made.name + ", of all runs", "", Kind::invariant, Better::smaller};

/// These of all runs.
std::vector<Value> survival(const Results& results, const Record& record);

/// Each column and resolution in a row.
void survival_table(const Results& results, Record& record);

}  // namespace touchstone::vnv
