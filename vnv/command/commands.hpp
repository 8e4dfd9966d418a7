#pragma once
/// The subcommands of `vnv`: a file each, and a line each here.

#include "vnv/command/catalogue.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

enum ExitStatus { all_holds = 0, something_fails = 1, bad_input = 3, bad_usage = 4 };

/// What all subcommands share.
struct Session {
  Build build{};
  std::function<int()> todo{};  // what the command line asks for; returns an ExitStatus
};

/// Each adds its subcommand, which sets what is to do.
void add_list(CLI::App& app, Session& session);
void add_run(CLI::App& app, Session& session);
void add_report(CLI::App& app, Session& session);
void add_accept(CLI::App& app, Session& session);
void add_gate(CLI::App& app, Session& session);
void add_explain(CLI::App& app, Session& session);
void add_plan(CLI::App& app, Session& session);
void add_completion(CLI::App& app, Session& session);

inline constexpr void (*subcommands[])(CLI::App&, Session&) = {add_list, add_run,     add_report, add_accept,
                                                               add_gate, add_explain, add_plan,   add_completion};

inline const std::vector<std::string> suites{"acceptance", "report", "nightly"};

/// The option --suite, as several have it.
CLI::Option* add_suite(CLI::App& command, std::string& suite);
/// Which methods, as several ask.
CLI::Option* add_patterns(CLI::App& command, std::vector<std::string>& patterns);

}  // namespace touchstone::vnv::command
