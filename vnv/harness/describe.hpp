#pragma once
#include "vnv/case.hpp"
#include "vnv/record/description.hpp"

#include <filesystem>

namespace touchstone::vnv {

/// What a case says of itself, with what was last accepted of it in the folder of data, and with the tables that were
/// read so far: those of its declaration. Throws BadData for baselines that cannot be read.
Description describe(const std::string& case_name, const Case& declared, const std::filesystem::path& data);

}  // namespace touchstone::vnv
