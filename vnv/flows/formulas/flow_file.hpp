#pragma once
/// A flow of one's own, in a TOML file: its exact fields as formulas. All its keys are in vnv/doors/README.md.

#include "vnv/flows/flow.hpp"

#include <filesystem>
#include <string>

namespace touchstone::vnv {

/// The flow that a file describes, at its settings. Throws std::invalid_argument: file, line, column of a formula, what
/// stands there and what was expected; also where the formulas do not solve the equation that the file names.
Flow read_flow(const std::filesystem::path& file, Settings settings = Settings());

/// The names of all flows that are known: those that are built in, and those that data/flows/ holds as files.
std::vector<std::string> known_flows();

/// A flow by one of these names, or by its file where that is what is said: "mine.toml", relative to a folder. Throws
/// std::invalid_argument for another name.
Flow flow_of(const std::string& name_or_file, Settings settings = Settings(), const std::filesystem::path& folder = {});

}  // namespace touchstone::vnv
