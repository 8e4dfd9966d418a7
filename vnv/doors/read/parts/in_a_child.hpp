#pragma once
/// Libraries that a file may bring down.

#include <functional>
#include <string>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

/// What `read` gives, in a process of its own: where that crashes, writes to the terminal or takes more than so many
/// seconds of the processor or bytes of memory, this one goes on and throws Unreadable, as it does where `read` throws
/// it.
std::vector<Dataset> read_in_a_child(const std::string& where, unsigned seconds, std::size_t bytes,
                                     const std::function<std::vector<Dataset>()>& read);

}  // namespace touchstone::vnv::doors
