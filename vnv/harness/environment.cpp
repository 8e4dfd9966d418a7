#include "vnv/harness/environment.hpp"

#include "vnv_revision.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
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

/// Of a node of Slurm its own name, which need not be that of its host.
std::string host() {
  if (const char* node = std::getenv("SLURMD_NODENAME")) return node;
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

void describe_environment(Record& record) {
  record.revision = TOUCHSTONE_REVISION;
  record.compiler = fmt::format("{} {}", TOUCHSTONE_COMPILER, __VERSION__);
  record.flags = TOUCHSTONE_FLAGS;
  record.machine = machine();
  record.host = host();
  record.finished_at = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace touchstone::vnv
