#pragma once
/// Verdicts as JUnit XML, as services of continuous integration read it.

#include "vnv/record/record.hpp"

#include <string>

namespace touchstone::vnv::command {

/// A test suite of the method; each claim is a test case, which fails unless the claim holds.
std::string junit_of(const Record& record);

}  // namespace touchstone::vnv::command
