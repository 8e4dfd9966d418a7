#include "vnv/programs/limited.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

namespace touchstone::programs {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

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
    std::string stat;
    std::getline(file, stat, '\0');             // fails, and does not throw, where the process has just ended
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

/// What this process started, and what that did, and their memory [bytes] together.
struct Descendants {
  std::vector<pid_t> all{};
  double memory = 0;
};
Descendants descendants() {
  const std::map<pid_t, Process> known = processes();
  Descendants found{{getpid()}};
  for (std::size_t k = 0; k < found.all.size(); ++k)
    for (const auto& [id, process] : known)
      if (process.parent == found.all[k]) {
        found.all.push_back(id);
        found.memory += process.memory;
      }
  found.all.erase(found.all.begin());
  return found;
}

/// Kills what a program left behind; this process is the parent of all whose own parent has ended.
void leave_nothing() {
  while (true) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) continue;
    const std::vector<pid_t> left = descendants().all;
    if (left.empty()) return;
    for (const pid_t id : left) kill(id, SIGKILL);
    waitpid(-1, nullptr, 0);
  }
}

double user_time_of_children() {  // s
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

}  // namespace

std::string Ran::sentence() const { return stopped.empty() ? ending.sentence() : "was ended: " + stopped; }

Ran run_limited(const std::string& name, const Words& words, const fs::path& folder, const fs::path& log,
                const Limits& limits) {
  constexpr std::chrono::milliseconds between_looks{50};
  Ran ran;
  const double user_before = user_time_of_children();
  const Clock::time_point start = Clock::now();
  {
    Words in_folder{"env", "-C", folder.string()};
    in_folder.insert(in_folder.end(), words.begin(), words.end());
    Running running(limits.grace);
    running.start(name, in_folder, log);
    while (ran.stopped.empty()) {
      const std::optional<Child> child = running.wait(between_looks);
      ran.wall = std::chrono::duration<double>(Clock::now() - start).count();
      if (child) {
        ran.ending = child->ending;
        break;
      }
      const double memory = descendants().memory;
      ran.peak_memory = std::max(ran.peak_memory, memory);
      std::error_code ignored;
      if (ran.wall > limits.wall) ran.stopped = fmt::format("took longer than {:g} s", limits.wall);
      if (memory > limits.memory) ran.stopped = fmt::format("used more than {:g} MB of memory", 1e-6 * limits.memory);
      if (static_cast<double>(fs::file_size(log, ignored)) > limits.output && !ignored)
        ran.stopped = fmt::format("wrote more than {:g} MB to its output", 1e-6 * limits.output);
    }
  }
  leave_nothing();
  ran.cpu = user_time_of_children() - user_before;
  return ran;
}

}  // namespace touchstone::programs
