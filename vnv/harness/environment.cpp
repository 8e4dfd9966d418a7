#include "vnv/harness/environment.hpp"

#include "vnv_revision.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <string>
#include <thread>

namespace touchstone::vnv {
namespace {

/// "AMD EPYC, 2 processors"; what Linux says, or "unknown".
std::string machine() {
  std::string model = "unknown processor";
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.rfind("model name", 0) == 0) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  return fmt::format("{}, {} processors", model, std::thread::hardware_concurrency());
}

}  // namespace

void describe_environment(Record& record) {
  record.revision = TOUCHSTONE_REVISION;
  record.compiler = fmt::format("{} {}", TOUCHSTONE_COMPILER, __VERSION__);
  record.flags = TOUCHSTONE_FLAGS;
  record.machine = machine();
  record.finished_at = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace touchstone::vnv
