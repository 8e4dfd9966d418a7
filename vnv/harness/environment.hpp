#pragma once
#include "vnv/record/record.hpp"

namespace touchstone::vnv {

/// Fills in where and by what a record was made: revision, compiler, flags, machine, host, time.
void describe_environment(Record& record);

}  // namespace touchstone::vnv
