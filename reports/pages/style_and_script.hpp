#pragma once
/// What all pages share: style.css and site.js, which stand beside this and are compiled in.

#include <string_view>

namespace touchstone::reports {

extern const std::string_view style_sheet, script;

}  // namespace touchstone::reports
