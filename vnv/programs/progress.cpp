#include "vnv/programs/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string_view>

namespace touchstone::programs {
namespace {

double seconds(std::chrono::steady_clock::duration time) { return std::chrono::duration<double>(time).count(); }

/// Columns of the terminal that stderr is; none if it is no terminal that can rewrite a line.
int columns_of_stderr() {
  const char* term = std::getenv("TERM");
  if (isatty(STDERR_FILENO) == 0 || (term && std::string_view(term) == "dumb")) return 0;
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? std::max<int>(size.ws_col, 40) : 100;
}

/// The beginning of a text, so many columns wide, without a character of UTF-8 that is cut in two.
std::string_view beginning(std::string_view text, int columns) {
  std::size_t end = 0;
  for (int taken = 0; end < text.size(); ++end)
    if ((text[end] & 0xC0) != 0x80 && ++taken > columns) break;
  return text.substr(0, end);
}

}  // namespace

std::string duration_in_words(double time) {
  if (time < 59.5) return fmt::format("{:.0f} s", time);
  const long minutes = std::lround(time / 60);
  if (minutes < 60) return fmt::format("{} min", minutes);
  return minutes % 60 == 0 ? fmt::format("{} h", minutes / 60) : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

void Work::expect(const std::string& part, std::optional<double> expected, bool alone) {
  parts_[part].expected = expected;
  parts_[part].alone = alone;
  parts_[part].guessed = false;
}

void Work::guess(const std::string& part, double seconds, bool alone) {
  expect(part, seconds, alone);
  parts_[part].guessed = true;
}

void Work::begin(const std::string& part, Clock::time_point now) {
  if (parts_[part].began) return;
  parts_[part].began = now;
  running_.push_back(part);
}

void Work::end(const std::string& name, Clock::time_point now) {
  Part& part = parts_[name];
  if (part.began && part.expected) {
    ended_ += seconds(now - *part.began);
    expected_ += *part.expected;
  }
  part.has_ended = true;
  std::erase(running_, name);
}

std::optional<double> Work::pace() const {
  return trusted_ + expected_ > 0 ? std::optional((trusted_ + ended_) / (trusted_ + expected_)) : std::nullopt;
}

std::optional<double> Work::left(Clock::time_point now) const {
  const std::optional<double> factor = pace();
  if (!factor || running_.empty()) return std::nullopt;
  double together = 0, longest = 0, alone = 0;  // s
  bool any_known = false;
  for (const auto& [name, part] : parts_) {
    if (part.has_ended || !part.expected) continue;
    any_known = true;
    double left = *factor * *part.expected;
    if (part.began) {
      const double taken = seconds(now - *part.began);
      left = std::max(left - taken, taken / 10);  // one that is overdue ends in a while
    }
    (part.alone ? alone : together) += left;
    if (!part.alone) longest = std::max(longest, left);
  }
  if (!any_known) return std::nullopt;
  return std::max(longest, together / static_cast<double>(running_.size())) + alone;
}

std::string Work::sentence(Clock::time_point now) const {
  const auto ended = std::ranges::count_if(parts_, [](const auto& one) { return one.second.has_ended; });
  const auto unknown =
      std::ranges::count_if(parts_, [](const auto& one) { return !one.second.has_ended && !one.second.expected; });
  std::string text = fmt::format("{} of {} done", ended, parts_.size());
  const bool is_guess =
      std::ranges::any_of(parts_, [](const auto& one) { return !one.second.has_ended && one.second.guessed; });
  const std::optional<double> time = left(now);
  if (time) text += fmt::format(", {} {} left", is_guess ? "perhaps" : "about", duration_in_words(*time));
  if (unknown > 0) text += fmt::format("{} {} of unknown cost", time ? " and" : ",", unknown);
  if (running_.empty() && ended < std::ssize(parts_)) return text + "; none runs yet";
  for (std::size_t k = 0; k < running_.size(); ++k)
    text += fmt::format("{} {} {}", k == 0 ? "; now" : ",", running_[k],
                        duration_in_words(seconds(now - *parts_.at(running_[k]).began)));
  return text;
}

Progress::Progress(std::string name, Where where) : Progress(std::move(name), std::cerr, columns_of_stderr()) {
  if (where == Where::terminal && columns_ == 0) out_ = nullptr;
}

Progress::Progress(std::string name, std::ostream& out, int columns)
    : name_(std::move(name)), out_(&out), columns_(columns) {}

bool Progress::is_due(Clock::time_point now) const {
  if (columns_ > 0) return !shown_ || now - *shown_ >= std::chrono::milliseconds(200);
  const double between = std::max(60.0, 0.05 * seconds(now - start_));
  return seconds(now - shown_.value_or(start_)) >= between;
}

void Progress::show(const std::function<std::string()>& words, Clock::time_point now) {
  if (!out_ || !is_due(now)) return;
  shown_ = now;
  is_there_ = columns_ > 0;
  const std::string line = fmt::format("{}: {}", name_, words());
  if (is_there_)
    *out_ << "\r\x1b[K" << beginning(line, columns_ - 1);
  else
    *out_ << line << '\n';
  *out_ << std::flush;
}

void Progress::clear() {
  if (!is_there_) return;
  is_there_ = false;
  shown_.reset();
  *out_ << "\r\x1b[K" << std::flush;
}

}  // namespace touchstone::programs
