#include "vnv/gate/command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace touchstone::gate {
namespace {

/// While it lives this process is deaf to the keyboard's interrupt, and the programs that it starts are not.
class LeftToPrograms {
 public:
  LeftToPrograms() { signal_ = std::signal(SIGINT, SIG_IGN); }
  ~LeftToPrograms() { std::signal(SIGINT, signal_); }
  LeftToPrograms(const LeftToPrograms&) = delete;
  LeftToPrograms& operator=(const LeftToPrograms&) = delete;

 private:
  void (*signal_)(int);
};

pid_t start(const std::vector<std::string>& words, const std::filesystem::path& output) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t heard;
  sigemptyset(&heard);
  sigaddset(&heard, SIGINT);
  posix_spawnattr_setsigdefault(&attributes, &heard);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments.front(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw std::runtime_error(fmt::format("{}: cannot be started: {}", words.front(), std::strerror(error)));
  return child;
}

}  // namespace

int run_command(const std::vector<std::string>& words, const std::filesystem::path& output) {
  const LeftToPrograms deaf;
  const pid_t child = start(words, output);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::runtime_error(fmt::format("{}: lost: {}", words.front(), std::strerror(errno)));
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  if (WTERMSIG(status) == SIGINT) throw std::runtime_error(fmt::format("{}: interrupted", words.front()));
  return 128 + WTERMSIG(status);
}

std::string last_lines(const std::filesystem::path& file, long lines) {
  std::vector<std::string> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  std::string text;
  for (std::size_t k = all.size() - std::min(all.size(), static_cast<std::size_t>(lines)); k < all.size(); ++k)
    text += (text.empty() ? "" : "\n") + all[k];
  return text;
}

ScratchFolder::ScratchFolder() {
  const std::string to_be_chosen(6, 'X');  // by mkdtemp, which puts letters of its own there
  std::string name = (std::filesystem::temp_directory_path() / ("touchstone_gate." + to_be_chosen)).string();
  if (!mkdtemp(name.data()))
    throw std::runtime_error(fmt::format("{}: cannot be made: {}", name, std::strerror(errno)));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace touchstone::gate
