#pragma once
/// Other programs: started, waited for, heard, and ended where this one is told to end.

#include "vnv/programs/interruption.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::programs {

using Words = std::vector<std::string>;  // a program, found as a shell finds it, and its arguments

/// In single quotes for a shell, wherever that reads it otherwise.
std::string quoted(const std::string& text);

struct Ending {
  int status = 0;  // exit status
  int signal = 0;  // that killed it, or 0

  bool succeeded() const { return status == 0 && signal == 0; }
  /// "ended with status 1", "was killed by signal 11 (Segmentation fault)"
  std::string sentence() const;
};

/// A program that was started and has ended.
struct Child {
  pid_t id;
  Ending ending;
};

/// Where a program's output and errors go: open files.
struct Streams {
  int output = STDOUT_FILENO, errors = STDERR_FILENO;
};

/// Programs that run beside each other and have nothing to read; those that still run are ended with this.
///
/// Each leads a process group of its own, so that what it starts is ended with it. Signals that tell this program to
/// end or to pause are held, and passed on by who waits: the programs are given the signal, and after the grace time,
/// or at once if this one is told again, they are killed. Where this program is itself killed, each is ended likewise,
/// with all that it started, by a process that stands between the two and ends as its program does.
class Running {
 public:
  explicit Running(std::chrono::milliseconds grace = std::chrono::seconds(5));
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Starts a program, called by its name where it is broken off. Throws std::runtime_error if it cannot be started.
  pid_t start(const std::string& name, const Words& words, const Streams& streams);
  /// The same; both its output and its errors go into one file, made anew.
  pid_t start(const std::string& name, const Words& words, const std::filesystem::path& output);

  /// The next that has ended, waited for so long at most. Throws Interrupted, when all have ended, if this program is
  /// told to end.
  std::optional<Child> wait(std::chrono::milliseconds at_most);

 private:
  std::optional<Child> ended();
  bool any_left();
  void send(int signal) const;
  void pause() const;
  void end_all(int signal);
  [[noreturn]] void interrupt(int signal);

  HeldSignals held_;
  std::chrono::milliseconds grace_;
  std::map<pid_t, std::string> names_;  // of those that run
  std::vector<pid_t> left_;             // process groups of those that ended
};

/// Runs a program to its end; it writes where this one does.
Ending run_here(const Words& words);

/// Called some times a second while a program runs; none: nothing is.
using Meanwhile = std::function<void()>;

/// Runs a program to its end; what it writes goes into a file. Throws std::runtime_error if it dies of an interrupt.
Ending run_into(const std::filesystem::path& output, const Words& words, const Meanwhile& meanwhile = {});

struct CapturedOutput {
  Ending ending;
  std::string output, errors;

  /// The first line of its errors, or how it ended if there is none or it was killed: what to quote of one that failed.
  std::string complaint() const;
};
/// Runs a program to its end and keeps what it says.
CapturedOutput run_and_capture(const Words& words, const Meanwhile& meanwhile = {});

/// The last lines of a text file, for a message.
std::string last_lines(const std::filesystem::path& file, long lines);

}  // namespace touchstone::programs
