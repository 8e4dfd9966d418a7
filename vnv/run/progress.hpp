#pragma once
#include <chrono>
#include <string>

namespace touchstone::vnv {

/// One line on a terminal, rewritten about twice a second: how far a run is and how long it still takes. In a log, and
/// wherever else stderr is no terminal, nothing.
class Progress {
 public:
  Progress(std::string name, double end_time);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double time) {
    if (on_terminal_) draw(time);
  }

 private:
  void draw(double time);

  std::string name_;
  double end_time_;  // s
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_, drawn_;
};

}  // namespace touchstone::vnv
