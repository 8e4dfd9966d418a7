#include "vnv/command/engines.hpp"

#include "vnv/command/inputs.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;
using programs::Progress, programs::Work;
using Clock = Work::Clock;
using Listener = Engine::Listener;

constexpr std::chrono::milliseconds between_looks{200};

fs::path ended_file(const fs::path& records, const std::string& name) { return records / "engine" / "ended" / name; }

/// What a job is thought to take [s]: relative costs were chosen to be about that.
double expected(const Job& job) { return job.last ? job.last->wall : job.relative_cost; }

Work work_of(const std::vector<Job>& jobs) {
  Work work;
  for (const Job& job : jobs)
    if (job.last)
      work.expect(job.name, job.last->wall, job.alone);
    else
      work.guess(job.name, job.relative_cost, job.alone);
  return work;
}

void sort_dearest_first(std::vector<Job>& jobs) {
  std::ranges::stable_sort(jobs, {}, [](const Job& job) { return std::pair(job.alone, -expected(job)); });
}

class Local : public Engine {
 public:
  explicit Local(const EngineOptions& options)
      : at_once_(std::max(options.at_once, 1)), logs_(options.records / "logs") {}

  void run(std::vector<Job> jobs, const Listener& listener) override {
    sort_dearest_first(jobs);  // what judges time comes last
    Work work = work_of(jobs);
    auto next = jobs.cbegin();
    while (next != jobs.cend() || !running_.empty()) {
      for (; next != jobs.cend() && may_start(*next); ++next) {
        listener.begins(*next);
        running_.emplace(programs_.start(next->name, next->call, logs_ / (next->name + ".txt")), &*next);
        work.begin(next->name);
      }
      if (const std::optional<programs::Child> child = programs_.wait(between_looks)) {
        const Job& job = *running_.at(child->id);
        running_.erase(child->id);
        work.end(job.name);
        line_.clear();
        listener.ended(job, {{.ending = child->ending}});
      }
      if (!running_.empty()) line_.show([&] { return work.sentence(); });
    }
  }

 private:
  bool may_start(const Job& job) const {
    const bool one_is_timed = std::ranges::any_of(running_, [](const auto& entry) { return entry.second->alone; });
    return running_.empty() || (!job.alone && !one_is_timed && std::ssize(running_) < at_once_);
  }

  int at_once_;
  fs::path logs_;
  Progress line_{"vnv run"};
  programs::Running programs_;
  std::map<pid_t, const Job*> running_;
};

/// Runs one method within limits. A file below began/ marks that it has started, one below ended/ says how it ended;
/// there is none where others told it to end, as when its machine goes down. An engine may start it again: what
/// has ended is not run twice. Not `ulimit -v`, which would count what is mapped and never used.
constexpr std::string_view runs_one = R"(#!/bin/sh
# one.sh NAME KEY SECONDS KILOBYTES PROGRAM ARGUMENT...
here=${0%/*} name=$1 key=$2 seconds=$3 memory=$4 began=$(date +%s)
shift 4
[ -e "$here/ended/$name" ] && exit 0
(: >"$here/began/$name") 2>/dev/null
(ulimit -d "$memory" && exec timeout --foreground -k 10 "$seconds" "$@") >"$here/../logs/$name.txt" 2>&1 </dev/null
status=$?
case $status in
129 | 130 | 143) exit 1 ;;
137) [ $(($(date +%s) - began)) -ge "$seconds" ] && status=124 ;;
esac
new="$here/ended/.$name.$$.part"
echo "$key $status $seconds ${SLURMD_NODENAME:-$(uname -n)}" >"$new" && mv "$new" "$here/ended/$name"
)";

/// What the engines elsewhere have in common.
class Elsewhere : public Engine {
 public:
  explicit Elsewhere(const EngineOptions& options) : options_(options), folder_(options.records / "engine") {}

  void run(std::vector<Job> jobs, const Listener& listener) override {
    if (jobs.empty()) return;
    for (const Job& job : jobs) listener.begins(job);
    fs::create_directories(folder_ / "ended");
    fs::remove_all(folder_ / "began");
    fs::create_directories(folder_ / "began");
    files::write_whole(folder_ / "one.sh", runs_one);
    sort_dearest_first(jobs);
    work_ = work_of(jobs);
    const auto first_alone = std::ranges::find(jobs, true, &Job::alone);
    for (const Job& job : jobs) waiting_.emplace(job.name, &job);
    try {
      for (const Words& words : submit({jobs.begin(), first_alone}, {first_alone, jobs.end()})) gather(words, listener);
    } catch (...) {
      cancel();
      throw;
    }
    for (const Clock::time_point until = Clock::now() + until_all_see; !waiting_.empty() && Clock::now() < until;) {
      programs_.wait(between_looks);
      look(listener);
    }
    for (const auto& [name, job] : waiting_) listener.ended(*job, {{.stopped = why_lost(*job)}, ""});
  }

 protected:
  /// Gives the jobs to the engine; returns programs that end when all have ended, to be run one after the other.
  virtual std::vector<Words> submit(const std::vector<Job>& together, const std::vector<Job>& alone) = 0;
  virtual std::string why_lost(const Job& job) = 0;
  virtual void cancel() {}

  std::string line_of(const Job& job) const {
    const JobLimits limits = limits_of(job);
    Words words{(folder_ / "one.sh").string(), job.name, job.key, fmt::format("{:.0f}", limits.wall),
                fmt::format("{:.0f}", limits.memory / 1024)};
    words.insert(words.end(), job.call.begin(), job.call.end());
    for (std::string& word : words) word = programs::quoted(word);
    return fmt::format("sh {}", fmt::join(words, " "));
  }

  const EngineOptions options_;
  const fs::path folder_;

 private:
  /// A shared file system may show a file on one machine a while after another wrote it.
  static constexpr std::chrono::seconds until_all_see{5};

  void gather(const Words& words, const Listener& listener) {
    programs_.start(options_.engine, words, folder_ / "said.txt");
    while (!programs_.wait(between_looks)) {
      look(listener);
      line_.show([&] { return work_.sentence(); });
    }
  }

  void look(const Listener& listener) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "began"))
      if (waiting_.contains(entry.path().filename())) work_.begin(entry.path().filename());
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "ended")) {
      const auto found = waiting_.find(entry.path().filename());
      if (found == waiting_.end()) continue;
      const Job& job = *found->second;
      const std::optional<JobResult> result = ended_elsewhere(options_.records, job.name, job.key);
      if (!result) continue;
      waiting_.erase(found);
      work_.end(job.name);
      line_.clear();
      listener.ended(job, *result);
    }
  }

  Progress line_{"vnv run by " + options_.engine};
  programs::Running programs_;
  std::map<std::string, const Job*> waiting_;  // by name
  Work work_;
};

/// Jobs whose host fails, so that one leaves nothing, are tried once more, on another if there is one; what had ended
/// there is not run again, and is well whatever it found.
class Parallel : public Elsewhere {
 public:
  using Elsewhere::Elsewhere;

 private:
  /// A login and what GNU parallel does for it take 0.2 to 0.4 s of processor time.
  static constexpr double login = 20;  // s

  std::vector<Words> submit(const std::vector<Job>& together, const std::vector<Job>& alone) override {
    std::vector<Words> all;
    const auto add = [&](const std::string& name, const std::vector<Job>& jobs, int at_once) {
      if (jobs.empty()) return;
      std::string calls;  // of scripts, as the user's shell over there may be no Bourne shell
      std::size_t count = 0;
      for (const std::vector<Job>& of_a_login : packed(jobs, login)) {
        std::string lines = "lost=0\n";
        for (const Job& job : of_a_login) lines += line_of(job) + " || lost=1\n";
        const fs::path script = folder_ / fmt::format("{}.{}.sh", name, count++);
        files::write_whole(script, lines + "exit $lost\n");
        calls += fmt::format("sh {}\n", programs::quoted(script.string()));
      }
      files::write_whole(folder_ / name, calls);
      Words words{"parallel", "--will-cite",     "--retries", "2", "--arg-file", (folder_ / name).string(),
                  "--joblog", log(name).string()};
      fs::remove(log(name));  // parallel makes it when it has read its options
      if (!options_.hosts.empty())
        words.insert(words.end(), {fs::exists(options_.hosts) ? "--sshloginfile" : "--sshlogin", options_.hosts});
      if (at_once > 0) words.insert(words.end(), {"--jobs", std::to_string(at_once)});
      words.insert(words.end(), options_.options.begin(), options_.options.end());
      all.push_back(std::move(words));
    };
    add("together", together, options_.at_once);
    add("alone", alone, 1);
    return all;
  }

  fs::path log(const std::string& name) const { return folder_ / (name + ".log"); }

  std::string why_lost(const Job& job) override {
    const fs::path said = folder_ / "said.txt";
    if (!fs::exists(log(job.alone ? "alone" : "together"))) {
      std::ifstream in(said);
      std::string complaint;
      std::getline(in, complaint);
      throw std::runtime_error(fmt::format("parallel started nothing: {}", complaint));
    }
    const std::string last = programs::last_lines(said, 1);
    return fmt::format("lost, twice, with its host; {}see {}", last.empty() ? "" : fmt::format("'{}', ", last),
                       said.string());
  }
};

/// Arrays of jobs that ask for about as much, and a job that depends on all of them: when that ends, all have ended.
/// What its node loses Slurm starts once more, and what had ended there is not run again.
class Slurm : public Elsewhere {
 public:
  using Elsewhere::Elsewhere;

 private:
  /// An element lasts minutes: Slurm takes about 0.85 s for each.
  static constexpr double element = 120;              // s
  static constexpr std::size_t longest_array = 1000;  // elements; Slurm's own default allows 1001
  struct ArrayElement {
    std::string array;  // id
    std::size_t element;
  };

  std::vector<Words> submit(const std::vector<Job>& together, const std::vector<Job>& alone) override {
    cancel();  // what a run that was killed left in the queue
    std::map<double, std::vector<Job>> by_memory;
    for (const Job& job : together) by_memory[gigabytes(job)].push_back(job);
    for (const auto& [memory, jobs] : by_memory) submit_arrays(jobs, {fmt::format("--mem={:.0f}G", memory)});
    submit_arrays(alone, {"--exclusive", "--mem=0"});
    const std::string all = fmt::format("--dependency=afterany:{}", fmt::join(arrays_, ":"));
    return {sbatch({"--wait", all, "--time=1", "--mem=50M", "--output=/dev/null"}, "exit 0")};
  }

  /// A power of two, so that there are few arrays.
  static double gigabytes(const Job& job) { return std::exp2(std::ceil(std::log2(limits_of(job).memory / 1e9))); }

  void submit_arrays(const std::vector<Job>& jobs, const Words& needs) {
    const std::vector<std::vector<Job>> elements = packed(jobs, element);
    for (std::size_t k = 0; k < elements.size(); k += longest_array)
      submit_array({elements.begin() + static_cast<long>(k),
                    elements.begin() + static_cast<long>(std::min(k + longest_array, elements.size()))},
                   needs);
  }

  void submit_array(const std::vector<std::vector<Job>>& elements, const Words& needs) {
    const std::string name = fmt::format("array{}", arrays_.size());
    double wall = 0;  // s
    for (std::size_t k = 0; k < elements.size(); ++k) {
      std::string lines = "[ \"${SLURM_RESTART_COUNT:-0}\" -le 1 ] || exit 1\n";
      double longest = 0, all = 0;
      for (const Job& job : elements[k]) {
        lines += line_of(job) + "\n";
        longest = std::max(longest, limits_of(job).wall);
        all += expected(job);
      }
      wall = std::max(wall, longest + 3 * all);
      files::write_whole(folder_ / fmt::format("{}.{}.sh", name, k), lines);
    }
    Words asks{"--parsable",
               "--requeue",
               "--open-mode=append",
               fmt::format("--array=0-{}{}", elements.size() - 1,
                           options_.at_once > 0 ? fmt::format("%{}", options_.at_once) : ""),
               fmt::format("--time={:.0f}", std::ceil(wall / 60)),
               fmt::format("--output={}", (folder_ / (name + ".%a.txt")).string())};
    asks.insert(asks.end(), needs.begin(), needs.end());
    const programs::CapturedOutput captured = programs::run_and_capture(
        sbatch(asks, fmt::format("exec sh {}.$SLURM_ARRAY_TASK_ID.sh", programs::quoted((folder_ / name).string()))));
    if (!captured.ending.succeeded()) throw std::runtime_error(fmt::format("sbatch: {}", captured.complaint()));
    arrays_.push_back(captured.output.substr(0, captured.output.find_first_of(";\n")));
    for (std::size_t k = 0; k < elements.size(); ++k)
      for (const Job& job : elements[k]) places_.emplace(job.name, ArrayElement{arrays_.back(), k});
  }

  /// Options of the user's come last, and win.
  Words sbatch(const Words& needs, const std::string& lines) const {
    Words words{"sbatch", "--job-name", job_name(), "--ntasks=1"};
    words.insert(words.end(), needs.begin(), needs.end());
    words.insert(words.end(), options_.options.begin(), options_.options.end());
    words.insert(words.end(), {"--wrap", lines});
    return words;
  }

  /// Of this folder of records: what has it was submitted here, and what has not was not.
  std::string job_name() const {
    Hash hash;
    hash.add(options_.records.string());
    return "vnv-" + hash.digits();
  }

  std::string why_lost(const Job& job) override {
    const ArrayElement& place = places_.at(job.name);
    const programs::CapturedOutput captured =
        programs::run_and_capture({"squeue", "--noheader", "--states=all", "--format=%T %N",
                                   fmt::format("--jobs={}_{}", place.array, place.element)});
    std::istringstream said(captured.output);
    std::string state = "unknown state", node = "unknown node";
    said >> state >> node;
    return fmt::format("lost by job {}_{}: {} on {}", place.array, place.element, state, node);
  }

  void cancel() override { programs::run_and_capture({"scancel", "--me", "--name", job_name()}); }

  std::vector<std::string> arrays_;      // ids
  std::map<std::string, ArrayElement> places_;  // by name of the job
};

}  // namespace

std::string JobResult::sentence() const { return ProcessResult::sentence() + (host.empty() ? "" : " on " + host); }

std::unique_ptr<Engine> make_engine(const EngineOptions& options) {
  if (!options.hosts.empty() && options.engine != "parallel")
    throw std::invalid_argument(fmt::format("--hosts {}: expected with --engine parallel", options.hosts));
  if (options.engine == "parallel") return std::make_unique<Parallel>(options);
  if (options.engine == "slurm") return std::make_unique<Slurm>(options);
  return std::make_unique<Local>(options);
}

std::optional<JobResult> ended_elsewhere(const fs::path& records, const std::string& name, const std::string& key) {
  std::ifstream file(ended_file(records, name));
  std::string of, host;
  int status = 0;
  double seconds = 0;
  if (!(file >> of >> status >> seconds >> host) || of != key) return std::nullopt;
  constexpr int was_ended = 124, died = 128;  // of timeout(1), of a shell
  JobResult result{{}, host};
  if (status == was_ended)
    result.stopped = fmt::format("took longer than {:g} s", seconds);
  else
    result.ending = status > died ? programs::Ending{.signal = status - died} : programs::Ending{.status = status};
  return result;
}

void forget_ended(const fs::path& records, const std::string& name) { fs::remove(ended_file(records, name)); }

JobLimits limits_of(const Job& job) {
  if (!job.last) return {3600, 8e9};
  return {60 + 5 * job.last->wall, 1e9 + 2 * job.last->peak_memory};
}

std::vector<std::vector<Job>> packed(const std::vector<Job>& jobs, double seconds) {
  std::vector<std::vector<Job>> elements;
  double filled = INFINITY;
  for (const Job& job : jobs) {
    if (filled + expected(job) > seconds) {
      elements.emplace_back();
      filled = 0;
    }
    elements.back().push_back(job);
    filled += expected(job);
  }
  return elements;
}

}  // namespace touchstone::vnv::command
