#pragma once
#include "vnv/record/record.hpp"

#include <string_view>

namespace touchstone::vnv {

/// Of what this was built: "0.1.0"; and "5617f2c", with "-dirty" where that was changed, or "unknown".
std::string_view project_version();
std::string_view revision();

/// Fills in where and by what a record was made: revision, compiler, flags, machine, host, time.
void describe_environment(Record& record);

}  // namespace touchstone::vnv
