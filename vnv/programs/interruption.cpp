#include "vnv/programs/interruption.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace touchstone::programs {
namespace {

constexpr int to_end[] = {SIGINT, SIGTERM, SIGHUP};

sigset_t set_of(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  return set;
}

bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

}  // namespace

std::string Interrupted::sentence() const {
  return fmt::format("interrupted by signal {} ({}): {}", signal, strsignal(signal), work);
}

bool tells_to_end(int signal) { return std::ranges::find(to_end, signal) != std::end(to_end); }

void end_by(int signal) {
  std::fflush(nullptr);
  die_by(signal);
}

void die_by(int signal) {
  std::signal(signal, SIG_DFL);
  const sigset_t one = set_of(signal);
  sigprocmask(SIG_UNBLOCK, &one, nullptr);
  raise(signal);
  std::_Exit(128 + signal);  // as a shell says it: signals do not end the first process of a container
}

HeldSignals::HeldSignals() {
  held_ = set_of(SIGCHLD);
  for (const int signal : to_end)
    if (!is_ignored(signal)) sigaddset(&held_, signal);
  if (!is_ignored(SIGTSTP)) sigaddset(&held_, SIGTSTP);
  sigprocmask(SIG_BLOCK, &held_, &before_);
}

HeldSignals::~HeldSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

int HeldSignals::next(std::chrono::nanoseconds at_most) const {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(std::max(at_most, std::chrono::nanoseconds(0)));
  const timespec patience{.tv_sec = seconds.count(), .tv_nsec = std::max(0L, (at_most - seconds).count())};
  return std::max(0, sigtimedwait(&held_, nullptr, &patience));
}

void HeldSignals::stop_if_told(const std::string& work) const {
  while (const int signal = next({})) {
    if (signal == SIGTSTP) pause();
    if (tells_to_end(signal)) throw Interrupted{signal, work};
  }
}

void HeldSignals::pause() const {
  raise(SIGTSTP);
  const sigset_t one = set_of(SIGTSTP);
  sigprocmask(SIG_UNBLOCK, &one, nullptr);  // here it pauses
  sigprocmask(SIG_BLOCK, &one, nullptr);
}

void HeldSignals::let_go() const { sigprocmask(SIG_UNBLOCK, &held_, nullptr); }

}  // namespace touchstone::programs
