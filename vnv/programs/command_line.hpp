#pragma once
/// Command lines by CLI11, whose misuse is told in one line: of which program, what, the value and what was expected.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::programs {

/// Of a program that was called as it cannot be.
inline constexpr int bad_usage = 4;

/// Values that an option accepts: those for which `holds`, told as `expected`.
inline CLI::Validator only(std::string expected, std::function<bool(const std::string&)> holds) {
  return {[expected = std::move(expected), holds = std::move(holds)](const std::string& value) {
            return holds(value) ? std::string() : fmt::format("'{}', expected {}", value, expected);
          },
          ""};
}

/// The whole text as a finite number.
inline std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || read != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

inline CLI::Validator numbers() {
  return only("a number", [](const std::string& text) { return number_in(text).has_value(); });
}
inline CLI::Validator above_zero() {
  return only("a number above 0", [](const std::string& text) { return number_in(text).value_or(0) > 0; });
}
inline CLI::Validator zero_or_above() {
  return only("a number, 0 or above", [](const std::string& text) { return number_in(text).value_or(-1) >= 0; });
}
inline CLI::Validator whole_numbers(int least, int most) {
  return only(fmt::format("a whole number from {} to {}", least, most), [=](const std::string& text) {
    const double number = number_in(text).value_or(std::nan(""));
    return number >= least && number <= most && number == std::floor(number);
  });
}
inline CLI::Validator one_of(const std::vector<std::string>& names) {
  return only(fmt::format("one of: {}", fmt::join(names, ", ")),
              [=](const std::string& text) { return std::ranges::find(names, text) != names.end(); });
}
inline CLI::Validator existing_folder() {
  return only("a folder", [](const std::string& path) { return std::filesystem::is_directory(path); });
}

/// The app, or the subcommand of it that was called.
inline const CLI::App& called(const CLI::App& app) {
  const auto subcommands = app.get_subcommands();
  return subcommands.empty() ? app : *subcommands.front();
}

/// What is wrong with a command line, in one line.
inline std::string misuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = called(app);
  const std::string name = &command == &app ? app.get_name() : app.get_name() + " " + command.get_name();
  std::string what = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
    const std::string extra = app.remaining(true).empty() ? what : app.remaining(true).front();
    what = fmt::format("unknown {} '{}'", extra.starts_with('-') ? "option" : "argument", extra);
  }
  return fmt::format("{}: {}; {} --help shows what is expected", name, what, name);
}

/// Reads a command line; an exit status where nothing is left to do: help was asked for, or a misuse was told.
inline std::optional<int> read_command_line(CLI::App& app, int count, char** arguments) {
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help
    fmt::print(stderr, "{}\n", misuse(app, error));
    return bad_usage;
  }
  return std::nullopt;
}

}  // namespace touchstone::programs
