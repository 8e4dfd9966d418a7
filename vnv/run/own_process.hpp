#pragma once
/// A calculation in a process of its own, so that its memory and its crashes are its own.

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

namespace touchstone::vnv {

/// A calculation that has ended.
class Ended {
 public:
  /// What it returned; empty if it did not come to its end. It lies in a file until it is asked for, and so adds
  /// nothing to the memory of a process that is split off later.
  std::string result() const;

  std::string crash;       // how it died, in one line; empty if it did not
  double peak_memory = 0;  // bytes  largest resident set of its process
  double user_time = 0;    // s

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  friend Ended in_own_process(const std::function<std::string()>& calculate);
};

/// Runs the calculation in a process split off this one, which must have a single thread. What it throws derived from
/// std::exception is thrown here as std::runtime_error, an invalid argument as such. Throws std::runtime_error if there
/// is no process or no file to be had.
Ended in_own_process(const std::function<std::string()>& calculate);

}  // namespace touchstone::vnv
