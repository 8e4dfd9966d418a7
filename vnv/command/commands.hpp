#pragma once
/// The subcommands of `vnv`: a file each, and a line each here.

#include "vnv/command/catalogue.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
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
/// The option -j.
CLI::Option* add_at_once(CLI::App& command, int& at_once);

/// What is to do once the command line has asked for a subcommand: `work`, with the options as they were read by then.
template <class Options>
void set_todo(CLI::App& command, Session& session, auto work, const std::shared_ptr<Options>& options) {
  command.callback([=, &session] { session.todo = [=, &session] { return work(session.build, *options); }; });
}

/// Turns records into pages; `arguments` are those of touchstone_report. Throws std::runtime_error if it cannot.
void make_pages(const Build& build, const Words& arguments);

}  // namespace touchstone::vnv::command
