#pragma once
/// What a dashboard keeps of a test: numbers that ctest takes out of its output.

#include "vnv/record/record.hpp"

#include <string>

namespace touchstone::vnv {

/// Lines <CTestMeasurement type="numeric/double" name="..."> for orders, judged values closest to their limits, and the
/// dearest run's cost: no more than 40, the names as XML has them. What is not finite is left out, since a dashboard
/// draws numbers.
std::string measurement_lines(const Record& record);

/// Whether ctest runs this process for a dashboard (ctest -S, ctest -D): only then does it read such lines.
bool is_run_for_dashboard();

}  // namespace touchstone::vnv
