#pragma once
/// All nights of a folder.

#include "reports/read/night.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// Nights of one suite, oldest first. A file that is no whole night is left out and named, in one line each: it must
/// cost neither tonight's pages nor the other nights, and must not be passed over in silence.
struct History {
  std::vector<Night> nights;
  std::vector<std::string> refused;
};

/// Reads every *.jsonl of the folder. Throws std::runtime_error if it cannot be listed.
History read_history(const std::filesystem::path& folder, const std::string& suite);

}  // namespace touchstone::reports
