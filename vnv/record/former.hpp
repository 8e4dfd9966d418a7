#pragma once
/// What former versions wrote, read as if it were of today: names of quantities by data/renames.csv, records by schema.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace touchstone::vnv {

/// The name of today for a former name of a quantity, with its unit or without, also within "order of NAME over
/// LADDER"; any other name comes back as it is. Throws BadData for a list of names
/// that is none; where there is none at all, names are as they are.
std::string current_name(const std::string& name);

/// Gives what is called a rung in former files its name of today, a level, at any depth.
void rename_former_keys(nlohmann::ordered_json& json);

}  // namespace touchstone::vnv
