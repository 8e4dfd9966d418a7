#pragma once
#include <string>
#include <utility>

namespace touchstone::vnv {

/// "L2 v_x [%]" -> "L2 v_x", "%"; a pure number "[-]" has no unit.
inline std::pair<std::string, std::string> name_and_unit(const std::string& quantity) {
  const std::size_t open = quantity.rfind(" [");
  if (open == std::string::npos || !quantity.ends_with(']')) return {quantity, ""};
  const std::string unit = quantity.substr(open + 2, quantity.size() - open - 3);
  return {quantity.substr(0, open), unit == "-" ? "" : unit};
}

}  // namespace touchstone::vnv
