#include "vnv/programs/limited.hpp"

#include "vnv/programs/processes.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

namespace touchstone::programs {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Whether a program has filled the disk of its folder but for 100 MB, or 2 % of a small one.
bool is_nearly_full(const fs::path& folder) {
  std::error_code unknown;
  const fs::space_info disk = fs::space(folder, unknown);
  return !unknown && static_cast<double>(disk.available) < std::min(100e6, 0.02 * static_cast<double>(disk.capacity));
}

double user_time_of_children() {  // s
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

}  // namespace

std::string ProcessResult::sentence() const { return stopped.empty() ? ending.sentence() : "was ended: " + stopped; }

ProcessResult run_limited(const std::string& name, const Words& words, const fs::path& folder, const fs::path& log,
                          const ProgramLimits& limits, const Meanwhile& meanwhile) {
  constexpr std::chrono::milliseconds between_looks{50};
  ProcessResult result;
  const double user_before = user_time_of_children();
  const Clock::time_point start = Clock::now();
  {
    Words in_folder{"env", "-C", folder.string()};
    in_folder.insert(in_folder.end(), words.begin(), words.end());
    Running running(limits.grace);
    const pid_t keeper = running.start(name, in_folder, log);
    while (result.stopped.empty()) {
      if (meanwhile) meanwhile();
      const std::optional<Child> child = running.wait(between_looks);
      result.wall = std::chrono::duration<double>(Clock::now() - start).count();
      if (child) {
        result.ending = child->ending;
        break;
      }
      const double memory = descendants_of(keeper).memory;
      result.peak_memory = std::max(result.peak_memory, memory);
      std::error_code ignored;
      if (result.wall > limits.wall) result.stopped = fmt::format("took longer than {:g} s", limits.wall);
      if (memory > limits.memory)
        result.stopped = fmt::format("used more than {:g} MB of memory", 1e-6 * limits.memory);
      if (is_nearly_full(folder))
        result.stopped = fmt::format("left hardly any space on the disk of {}", folder.string());
      if (static_cast<double>(fs::file_size(log, ignored)) > limits.output && !ignored)
        result.stopped = fmt::format("wrote more than {:g} MB to its output", 1e-6 * limits.output);
    }
  }
  leave_nothing();
  result.cpu = user_time_of_children() - user_before;
  return result;
}

}  // namespace touchstone::programs
