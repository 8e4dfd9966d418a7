#pragma once
/// Patterns choose methods by their names, CASE.METHOD.

#include <string>
#include <vector>

namespace touchstone::vnv::command {

/// The names that a pattern chooses, in their order: a method with this name, else all of the case with this name; else
/// those that fit as a glob (*, ?, [...]) of the whole name or of its case; else those that contain it.
std::vector<std::string> matches(const std::string& pattern, const std::vector<std::string>& names);

/// The names that any of the patterns chooses, each once and in their order; all if there is no pattern. Throws
/// std::invalid_argument naming a pattern that chooses none.
std::vector<std::string> chosen_by(const std::vector<std::string>& patterns, const std::vector<std::string>& names);

/// Whether the name of a case fits what a pattern says of cases, as a glob or by containing it.
bool fits_a_case(const std::string& pattern, const std::vector<std::string>& cases);

/// The cases among which a pattern may choose, when their methods are not known yet.
std::vector<std::string> possible_cases(const std::string& pattern, const std::vector<std::string>& cases);

}  // namespace touchstone::vnv::command
