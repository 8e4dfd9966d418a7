#pragma once
#include <filesystem>

namespace touchstone::vnv {

/// The folder of the project's data, unless another was named.
const std::filesystem::path& data_folder();
void set_data_folder(const std::filesystem::path& folder);

}  // namespace touchstone::vnv
