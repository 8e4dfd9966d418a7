#pragma once
/// How far long work is, and how long it still takes.

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace touchstone::programs {

/// "40 s", "12 min", "2 h 5 min"
std::string duration_in_words(double seconds);

/// Work in parts, of which some run beside each other, and what is left of it.
class Work {
 public:
  using Clock = std::chrono::steady_clock;

  /// What parts took so far corrects what is expected of the others; the first `trusted` seconds of that are believed
  /// as they are. None: what is expected has no unit, and says nothing before a part has ended.
  explicit Work(double trusted = 10) : trusted_(trusted) {}

  /// A part that has not begun, and what it is expected to take [s], as a rule what it took last; again, with what is
  /// known by now.
  void expect(const std::string& part, std::optional<double> expected, bool alone = false);
  /// The same of one that never ran here: no more than a guess [s].
  void guess(const std::string& part, double seconds, bool alone = false);
  void begin(const std::string& part, Clock::time_point now = Clock::now());
  void end(const std::string& part, Clock::time_point now = Clock::now());

  /// How long it still takes [s], with as many parts beside each other as there are now; nothing where nobody knows of
  /// any part that is left, and where none runs.
  std::optional<double> left(Clock::time_point now = Clock::now()) const;

  /// "3 of 12 done, about 4 min left and 2 of unknown cost; now couette.mpm 3 s, poiseuille.sph 12 s"; "perhaps" in
  /// place of "about" where any of that is a guess.
  std::string sentence(Clock::time_point now = Clock::now()) const;

 private:
  struct Part {
    std::optional<double> expected{};  // s
    bool alone = false, guessed = false;
    std::optional<Clock::time_point> began{};
    bool has_ended = false;
  };
  std::optional<double> pace() const;  // seconds that pass in one that is expected

  double trusted_;  // s
  std::map<std::string, Part> parts_{};
  std::vector<std::string> running_{};  // names, in the order of their start
  double ended_ = 0, expected_ = 0;     // s  that parts took which have ended, and were expected to
};

/// Words that follow work, on stderr: on a terminal one line below all others, rewritten in place, which is gone when
/// this ends; in a log a line of their own from time to time, the first after a minute.
class Progress {
 public:
  enum class Where { terminal_and_log, terminal };

  /// Of a program or what it runs, which begins each line.
  explicit Progress(std::string name, Where where = Where::terminal_and_log);
  /// Elsewhere: on a terminal of so many columns, or in a log where there are none.
  Progress(std::string name, std::ostream& out, int columns);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  using Clock = Work::Clock;
  /// Says the words if it is time to.
  void show(const std::function<std::string()>& words, Clock::time_point now = Clock::now());
  /// Before others write where this does.
  void clear();

 private:
  bool is_due(Clock::time_point now) const;

  std::string name_;
  std::ostream* out_;  // null: nothing is said
  int columns_;        // none: a log
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> shown_{};
  bool is_there_ = false;  // a line on the terminal
};

}  // namespace touchstone::programs
