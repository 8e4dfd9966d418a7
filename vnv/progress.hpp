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

  /// Cheap: looks at the clock every hundredth call.
  void show(double time) {
    if (on_terminal_ && ++calls_ % 100 == 0) draw(time);
  }

 private:
  void draw(double time);

  std::string name_;
  double end_time_;  // s
  bool on_terminal_;
  long calls_ = 0;
  std::chrono::steady_clock::time_point start_, drawn_;
};

}  // namespace touchstone::vnv
