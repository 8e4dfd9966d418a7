#include "vnv/command/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

extern char** environ;

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

Ending ending_of(int status) {
  if (WIFSIGNALED(status)) return {.status = 0, .signal = WTERMSIG(status)};
  return {.status = WEXITSTATUS(status), .signal = 0};
}

/// Where a program's output and errors go; -1: where ours do.
pid_t spawn(const Words& command, int output, int errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (output >= 0) posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  if (errors >= 0) posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t id = 0;
  const int cause = posix_spawn(&id, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (cause != 0) throw std::runtime_error(fmt::format("{}: cannot be run: {}", command.front(), std::strerror(cause)));
  return id;
}

Ending wait_for(pid_t id) {
  int status = 0;
  while (waitpid(id, &status, 0) < 0)
    if (errno != EINTR) throw std::runtime_error(fmt::format("process {}: {}", id, std::strerror(errno)));
  return ending_of(status);
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
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace

std::string Ending::sentence() const {
  if (signal != 0) return fmt::format("was killed by signal {} ({})", signal, strsignal(signal));
  return fmt::format("ended with status {}", status);
}

pid_t start(const Words& command, const fs::path& output) {
  const int file = open(output.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", output.string(), std::strerror(errno)));
  const std::unique_ptr<const int, void (*)(const int*)> closes(&file, [](const int* number) { close(*number); });
  return spawn(command, file, file);
}

std::optional<Child> any_ended() {
  int status = 0;
  const pid_t id = waitpid(-1, &status, WNOHANG);
  if (id <= 0) return std::nullopt;
  return Child{id, ending_of(status)};
}

Ending run_here(const Words& command) {
  std::fflush(nullptr);
  return wait_for(spawn(command, -1, -1));
}

std::string Heard::complaint() const {
  return ending.signal != 0 || errors.empty() ? ending.sentence() : errors.substr(0, errors.find('\n'));
}

Heard run_and_hear(const Words& command) {
  const Scratch output, errors;
  const Ending ending = wait_for(spawn(command, output.number(), errors.number()));
  return {ending, output.text(), errors.text()};
}

}  // namespace touchstone::vnv::command
