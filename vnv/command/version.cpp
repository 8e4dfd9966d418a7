/// Of what this was built: a small file, since each commit compiles it anew.

#include "vnv/command/commands.hpp"
#include "vnv_revision.hpp"

namespace touchstone::vnv::command {

std::string_view project_version() { return TOUCHSTONE_VERSION; }
std::string_view revision() { return TOUCHSTONE_REVISION; }

}  // namespace touchstone::vnv::command
