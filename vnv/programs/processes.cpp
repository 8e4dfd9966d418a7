#include "vnv/programs/processes.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>

namespace touchstone::programs {
namespace {

namespace fs = std::filesystem;

struct Process {
  pid_t parent;
  double memory;  // bytes, resident
};

/// All processes of the machine. One that ends meanwhile is left out.
std::map<pid_t, Process> processes() {
  static const double page = static_cast<double>(sysconf(_SC_PAGESIZE));
  std::map<pid_t, Process> all;
  for (const fs::directory_entry& entry :
       fs::directory_iterator("/proc", fs::directory_options::skip_permission_denied)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != name.npos) continue;
    std::ifstream file(entry.path() / "stat");
    const std::string stat = said_by_process(file);
    const std::size_t close = stat.rfind(')');  // the name between the brackets may hold anything
    if (close == stat.npos) continue;
    std::ifstream pages(entry.path() / "statm");
    double size = 0, resident = 0;
    pages >> size >> resident;
    pid_t parent = 0;
    char state = 0;
    if (std::sscanf(stat.c_str() + close + 1, " %c %d", &state, &parent) == 2)
      all[std::stoi(name)] = {parent, page * resident};
  }
  return all;
}

}  // namespace

std::string said_by_process(std::ifstream& file) {
  std::string said;
  std::getline(file, said, '\0');  // an iterator over the buffer would throw
  return said;
}

Descendants descendants_of(pid_t ancestor) {
  const std::map<pid_t, Process> known = processes();
  Descendants found{{ancestor}};
  for (std::size_t k = 0; k < found.all.size(); ++k)
    for (const auto& [id, process] : known)
      if (process.parent == found.all[k]) {
        found.all.push_back(id);
        found.memory += process.memory;
      }
  found.all.erase(found.all.begin());
  return found;
}

void leave_nothing() {
  while (true) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) continue;
    const std::vector<pid_t> left = descendants_of(getpid()).all;
    if (left.empty()) return;
    for (const pid_t id : left) kill(id, SIGKILL);
    waitpid(-1, nullptr, 0);
  }
}

}  // namespace touchstone::programs
