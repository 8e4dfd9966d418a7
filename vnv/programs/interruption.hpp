#pragma once
/// What tells this program to end, heard where nothing is left behind by it.

#include <chrono>
#include <csignal>
#include <string>

namespace touchstone::programs {

/// This program was told to end. Thrown where that was heard, so that all is tidied up on the way out; no
/// std::exception, since nobody on the way may take it for an error.
struct Interrupted {
  int signal;
  std::string work;  // that was broken off: "poiseuille.mpm, couette.mpm"

  /// "interrupted by signal 15 (Terminated): poiseuille.mpm, couette.mpm"
  std::string sentence() const;
};

/// Whether it is the keyboard's interrupt, SIGTERM, or says that the terminal is gone.
bool tells_to_end(int signal);

/// Ends this program as the signal does that nobody holds: its caller sees which it was.
[[noreturn]] void end_by(int signal);
/// The same, without printing what waits to be printed: in a process that was split off.
[[noreturn]] void die_by(int signal);

/// While this lives, signals that tell this program to end, or from the keyboard to pause, wait until they are asked
/// for, but for those that it was started to ignore, as by nohup(1). Then they do again what they did. These may be
/// nested.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// The next of them, or SIGCHLD, waited for so long at most; 0 if none came.
  int next(std::chrono::nanoseconds at_most) const;
  /// Throws Interrupted if one has come that tells to end.
  void stop_if_told(const std::string& work) const;
  /// Pauses this program as the keyboard's signal does that nobody holds; returns when it goes on.
  void pause() const;
  /// Holds them no longer: in a process that becomes another program.
  void let_go() const;

 private:
  sigset_t held_, before_;
};

}  // namespace touchstone::programs
