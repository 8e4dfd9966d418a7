#pragma once
/// What a process started, and what that did, as the system lists it in /proc.

#include <sys/types.h>

#include <fstream>
#include <string>
#include <vector>

namespace touchstone::programs {

/// What a file of /proc says of a process; nothing where that has ended since the file was opened.
std::string said_by_process(std::ifstream& file);

struct Descendants {
  std::vector<pid_t> all{};
  double memory = 0;  // bytes  resident, of all together
};
/// Of a process, which is none of them.
Descendants descendants_of(pid_t process);

/// Kills what this process started and what is left of that; it has to be the parent of all whose own has ended,
/// PR_SET_CHILD_SUBREAPER.
void leave_nothing();

}  // namespace touchstone::programs
