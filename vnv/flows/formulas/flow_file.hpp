#pragma once
/// A flow of one's own, in a TOML file: its exact fields as formulas. All its keys are in vnv/doors/README.md.

#include "vnv/flows/flow.hpp"

#include <filesystem>
#include <string>

namespace touchstone::vnv {

/// The flow that a file describes, at its settings. Throws std::invalid_argument: file, line, column of a formula, what
/// stands there and what was expected; also where the formulas do not solve the equation that the file names.
Flow read_flow(const std::filesystem::path& file, Settings settings = Settings());

/// A flow by its name, or by its file where that is what is said: "lamb_oseen.toml", relative to a folder.
Flow flow_of(const std::string& name_or_file, Settings settings = Settings(), const std::filesystem::path& folder = {});

}  // namespace touchstone::vnv
