#pragma once
#include "vnv/run/run.hpp"

#include <string>

namespace touchstone::vnv {

/// A run as bytes, to pass it from the process that made it to the one that judges it: all of it, bit by bit.
std::string to_bytes(const Run& run);

/// The run again. Throws std::runtime_error for bytes that end early or go on.
Run run_from(const std::string& bytes);

}  // namespace touchstone::vnv
