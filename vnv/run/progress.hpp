#pragma once
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

namespace touchstone::vnv {

/// One line on a terminal, rewritten about twice a second: how far a run is and how long it still takes. In a log, and
/// wherever else stderr is no terminal, nothing.
class Progress {
 public:
  Progress(std::string name, double end_time) : name_(std::move(name)), end_time_(end_time) {}
  ~Progress() {
    if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double time) {
    using Seconds = std::chrono::duration<double>;
    const auto now = std::chrono::steady_clock::now();
    if (!on_terminal_ || Seconds(now - drawn_).count() < 0.5 || !(time > 0)) return;
    drawn_ = now;
    const double left = Seconds(now - start_).count() * (end_time_ - time) / time;
    fmt::print(stderr, "\r\x1b[K{}: {:.0f} %, {:.0f} s left", name_, 100 * time / end_time_, left);
    std::fflush(stderr);
  }

 private:
  std::string name_;
  double end_time_;  // s
  bool on_terminal_ = isatty(fileno(stderr)) != 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), drawn_ = start_;
};

}  // namespace touchstone::vnv
