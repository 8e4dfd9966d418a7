#include "vnv/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace touchstone::vnv {

Progress::Progress(std::string name, double end_time)
    : name_(std::move(name)),
      end_time_(end_time),
      on_terminal_(isatty(fileno(stderr)) != 0),
      start_(std::chrono::steady_clock::now()),
      drawn_(start_) {}

Progress::~Progress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::draw(double time) {
  using Seconds = std::chrono::duration<double>;
  const auto now = std::chrono::steady_clock::now();
  if (Seconds(now - drawn_).count() < 0.5 || !(time > 0)) return;
  drawn_ = now;
  const double left = Seconds(now - start_).count() * (end_time_ - time) / time;
  fmt::print(stderr, "\r\x1b[K{}: {:.0f} %, {:.0f} s left", name_, 100 * time / end_time_, left);
  std::fflush(stderr);
}

}  // namespace touchstone::vnv
