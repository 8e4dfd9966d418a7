#pragma once
/// Where the programs of methods run: on this machine, on hosts by GNU parallel and ssh, on a cluster by Slurm.
///
/// Elsewhere they run by lines of a shell in RECORDS/engine/, and each leaves how it ended in RECORDS/engine/ended/: so
/// what has ended is known whoever was killed meanwhile, and what left nothing was lost with its machine. All machines
/// see the build folder, the data and the records at the same places.

#include "vnv/command/tasks.hpp"
#include "vnv/programs/limited.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

/// One method of one case, to be run.
struct Job {
  std::string name{};  // "poiseuille.mpm"
  std::string key{};   // of its program, data and suite, one word
  Words call{};
  bool alone = false;  // what it judges is time: nothing runs beside it
  double relative_cost = 0;
  std::optional<LastCost> last{};
};

/// How the program of a job ended, and where.
struct JobResult : programs::ProcessResult {
  std::string host{};  // empty: here

  /// "was killed by signal 9 (Killed) on n2"
  std::string sentence() const;
};

class Engine {
 public:
  /// Called once for each job; `begins` only by an engine that knows when.
  struct Listener {
    std::function<void(const Job&)> begins;
    std::function<void(const Job&, const JobResult&)> ended;
  };

  virtual ~Engine() = default;
  /// Runs jobs to their ends, the dearest first. What it started is ended, or cancelled, if this program is told to
  /// end, and nothing else. Throws std::runtime_error if the engine is not there or refuses them.
  virtual void run(std::vector<Job> jobs, const Listener& listener) = 0;
};

struct EngineOptions {
  std::string engine = "local";
  int at_once = 0;      // programs; with parallel on each host; 0: one here, else as many as the engine will
  std::string hosts{};  // of parallel: as its --sshlogin has them, or a file of them
  Words options{};      // more of the engine's own: --partition=long
  std::filesystem::path records{};  // absolute
};
inline const std::vector<std::string> engines{"local", "parallel", "slurm"};

/// Throws std::invalid_argument for hosts of an engine that has none.
std::unique_ptr<Engine> make_engine(const EngineOptions& options);

/// How a job ended that ran elsewhere, also for a run that was killed before it heard of it; nothing if it has not.
std::optional<JobResult> ended_elsewhere(const std::filesystem::path& records, const std::string& name,
                                         const std::string& key);
void forget_ended(const std::filesystem::path& records, const std::string& name);

/// How long a job may take [s] and how much memory [bytes], by what it took last: five times and a minute more, twice
/// and a gigabyte more. What nobody knows gets an hour and 8 GB.
struct JobLimits {
  double wall, memory;
};
JobLimits limits_of(const Job& job);

/// Jobs that one element of an array, or one login, runs one after the other: neighbours together, so long [s] by their
/// last cost.
std::vector<std::vector<Job>> packed(const std::vector<Job>& jobs, double seconds);

}  // namespace touchstone::vnv::command
