#pragma once
/// Files that gzip made smaller.

#include <string>
#include <string_view>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

inline constexpr std::string_view gzip_begins = "\x1f\x8b";

/// What one or several members decompress to. Throws Unreadable.
std::string gunzipped(const std::string& file, std::string_view bytes, const Limits& limits);

}  // namespace touchstone::vnv::doors
