#pragma once
#include "vnv/record/record.hpp"

namespace touchstone::vnv::command {

/// What was measured, a row a quantity and time, a column a level, of what is followed over many times the extremes;
/// below it the observed orders. A row of which nothing is limited by a claim says so.
void print_values(const Record& record);

}  // namespace touchstone::vnv::command
