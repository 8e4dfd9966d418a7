#pragma once
/// Where in a record a value stands, and how far it may move there.

#include "vnv/record/record.hpp"
#include "vnv/record/same_time.hpp"

#include <optional>
#include <string>

namespace touchstone::gate {

/// Whether two values are of one quantity, level and time.
bool is_same_value(const vnv::Value& a, const vnv::Value& b);

/// How far an error may move [its own unit]: half the width between the limits of its baseline, the narrowest of them;
/// nothing where it has none.
std::optional<double> tolerance_of(const vnv::Value& error, const vnv::Record& record);

}  // namespace touchstone::gate
