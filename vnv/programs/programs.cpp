#include "vnv/programs/programs.hpp"

#include "vnv/programs/processes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace touchstone::programs {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

Ending ending_of(int status) {
  if (WIFSIGNALED(status)) return {.status = 0, .signal = WTERMSIG(status)};
  return {.status = WEXITSTATUS(status), .signal = 0};
}

/// This process gets the signal when its parent dies.
void hear_of_the_end_of(pid_t parent, int signal) {
  prctl(PR_SET_PDEATHSIG, signal);
  if (getppid() != parent) _exit(0);  // it died before it could be known
}

/// Turns this process, split off the parent, into a program; returns only if that cannot be, with the cause in errno.
void become(char* const* words, const Streams& streams, pid_t parent, const HeldSignals& held) {
  hear_of_the_end_of(parent, SIGTERM);
  held.let_go();
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0) return;
  if (dup2(streams.output, STDOUT_FILENO) < 0 || dup2(streams.errors, STDERR_FILENO) < 0) return;
  execvp(words[0], words);
}

/// Ends this process as another has ended.
[[noreturn]] void end_as(int status) {
  if (!WIFSIGNALED(status)) _exit(WEXITSTATUS(status));
  const rlimit no_core{};
  setrlimit(RLIMIT_CORE, &no_core);
  die_by(WTERMSIG(status));
}

/// Stands between the starter and its program, and ends as that does. Where the starter is killed first, so that nobody
/// else is told, it ends the program with all that this started, also in groups and sessions of their own.
[[noreturn]] void keep(pid_t program, pid_t starter, const HeldSignals& held, std::chrono::milliseconds grace) {
  constexpr std::chrono::seconds between_looks{1};
  const auto has_ended = [program](int& status) {
    pid_t found = 0;
    while ((found = waitpid(-1, &status, WNOHANG)) > 0 && found != program) continue;  // others were left behind
    return found == program;
  };
  int status = 0;
  while (getppid() == starter) {
    if (has_ended(status)) end_as(status);
    held.next(between_looks);
  }
  kill(0, SIGTERM);
  kill(0, SIGCONT);
  const Clock::time_point until = Clock::now() + grace;
  while (Clock::now() < until && !has_ended(status)) held.next(until - Clock::now());
  leave_nothing();
  _exit(0);
}

/// Returns when the program runs. What it died of before, its process writes into a pipe, which a program that runs
/// does not have.
pid_t split_off(const Words& command, const Streams& streams, const HeldSignals& held,
                std::chrono::milliseconds grace) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const auto refuse = [&](int cause) {
    throw std::runtime_error(fmt::format("{}: cannot be started: {}", command.front(), std::strerror(cause)));
  };
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) refuse(errno);
  const auto give_up = [&ends] {
    const int cause = errno;
    _exit(write(ends[1], &cause, sizeof cause) < 0 ? 126 : 127);
  };
  const pid_t starter = getpid(), child = fork();
  if (child == 0) {
    setpgid(0, 0);
    hear_of_the_end_of(starter, SIGCHLD);  // it is held, and wakes it
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const pid_t keeper = getpid(), program = fork();
    if (program == 0) become(words.data(), streams, keeper, held);
    if (program <= 0) give_up();
    close(ends[0]);
    close(ends[1]);
    keep(program, starter, held, grace);
  }
  int cause = child < 0 ? errno : 0;
  close(ends[1]);
  if (child > 0 && read(ends[0], &cause, sizeof cause) > 0) waitpid(child, nullptr, 0);
  close(ends[0]);
  if (cause != 0) refuse(cause);
  return child;
}

/// Whether nothing of a process group is left, once what has ended was waited for.
bool has_ended(pid_t group) {
  pid_t found = 0;
  while ((found = waitpid(-group, nullptr, WNOHANG)) > 0) continue;
  return found < 0;
}

/// A file without a name, gone when it is closed.
class Scratch {
 public:
  Scratch() : file_(std::tmpfile()) {
    if (!file_) throw std::runtime_error(fmt::format("no temporary file: {}", std::strerror(errno)));
    fcntl(number(), F_SETFD, FD_CLOEXEC);
  }
  int number() const { return fileno(file_.get()); }
  std::string text() const {
    std::string all;
    std::rewind(file_.get());
    char part[4096];
    while (const std::size_t read = std::fread(part, 1, sizeof part, file_.get())) all.append(part, read);
    return all;
  }

 private:
  std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })> file_;
};

Ending run_alone(const Words& words, const auto& output, const Meanwhile& meanwhile = {}) {
  constexpr std::chrono::milliseconds often{200}, seldom{60000};
  Running running;
  running.start(words.front(), words, output);
  while (true) {
    if (meanwhile) meanwhile();
    if (const std::optional<Child> child = running.wait(meanwhile ? often : seldom)) return child->ending;
  }
}

}  // namespace

std::string quoted(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,+-=:";
  if (!text.empty() && text.find_first_not_of(plain) == text.npos) return text;
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? "'\\''" : std::string(1, c);
  return all + "'";
}

std::string Ending::sentence() const {
  if (signal != 0) return fmt::format("was killed by signal {} ({})", signal, strsignal(signal));
  return fmt::format("ended with status {}", status);
}

Running::Running(std::chrono::milliseconds grace) : grace_(grace) {
  std::signal(SIGCHLD, SIG_DFL);     // who ignores it is not told how programs ended
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // what a program leaves behind is waited for here
}

Running::~Running() { end_all(SIGTERM); }

pid_t Running::start(const std::string& name, const Words& words, const Streams& streams) {
  const pid_t id = split_off(words, streams, held_, grace_);
  names_.emplace(id, name);
  return id;
}

pid_t Running::start(const std::string& name, const Words& words, const fs::path& output) {
  const int file = open(output.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", output.string(), std::strerror(errno)));
  const std::unique_ptr<const int, void (*)(const int*)> closes(&file, [](const int* number) { close(*number); });
  return start(name, words, Streams{.output = file, .errors = file});
}

std::optional<Child> Running::wait(std::chrono::milliseconds at_most) {
  const Clock::time_point until = Clock::now() + at_most;
  while (true) {
    if (const std::optional<Child> child = ended()) return child;
    if (Clock::now() >= until) return std::nullopt;
    const int signal = held_.next(until - Clock::now());
    if (signal == SIGTSTP) pause();
    if (tells_to_end(signal)) interrupt(signal);
  }
}

std::optional<Child> Running::ended() {
  for (const auto& [id, name] : names_) {
    int status = 0;
    const pid_t found = waitpid(id, &status, WNOHANG);
    if (found == 0) continue;
    if (found < 0) throw std::runtime_error(fmt::format("{}: lost: {}", name, std::strerror(errno)));
    names_.erase(found);
    left_.push_back(found);
    return Child{found, ending_of(status)};
  }
  std::erase_if(left_, has_ended);
  return std::nullopt;
}

/// Whether any of the programs, or of what they started, still runs.
bool Running::any_left() {
  std::erase_if(names_, [](const auto& program) { return has_ended(program.first); });
  return !names_.empty();
}

void Running::send(int signal) const {
  for (const auto& [id, name] : names_) kill(-id, signal);
}

void Running::pause() const {
  send(SIGTSTP);
  held_.pause();
  send(SIGCONT);
}

void Running::end_all(int signal) {
  send(signal);
  send(SIGCONT);  // what is paused hears nothing
  const Clock::time_point until = Clock::now() + grace_;
  while (any_left() && Clock::now() < until && !tells_to_end(held_.next(until - Clock::now()))) continue;
  send(SIGKILL);
  for (const auto& [id, name] : names_)
    while (waitpid(-id, nullptr, 0) > 0) continue;
  names_.clear();
}

void Running::interrupt(int signal) {
  std::string work;
  for (const auto& [id, name] : names_) work += (work.empty() ? "" : ", ") + name;
  end_all(signal);
  throw Interrupted{signal, work};
}

Ending run_here(const Words& words) {
  std::fflush(nullptr);
  return run_alone(words, Streams{});
}

Ending run_into(const fs::path& output, const Words& words, const Meanwhile& meanwhile) {
  const Ending ending = run_alone(words, output, meanwhile);
  if (ending.signal == SIGINT) throw std::runtime_error(fmt::format("{}: interrupted", words.front()));
  return ending;
}

std::string CapturedOutput::complaint() const {
  return ending.signal != 0 || errors.empty() ? ending.sentence() : errors.substr(0, errors.find('\n'));
}

CapturedOutput run_and_capture(const Words& words, const Meanwhile& meanwhile) {
  const Scratch output, errors;
  const Ending ending = run_alone(words, Streams{.output = output.number(), .errors = errors.number()}, meanwhile);
  return {ending, output.text(), errors.text()};
}

std::string last_lines(const fs::path& file, long lines) {
  std::vector<std::string> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return fmt::format("{}", fmt::join(all.end() - std::min(lines, std::ssize(all)), all.end(), "\n"));
}

}  // namespace touchstone::programs
