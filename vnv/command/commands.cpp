#include "vnv/command/commands.hpp"

namespace touchstone::vnv::command {

CLI::Option* add_suite(CLI::App& command, std::string& suite) {
  return command.add_option("--suite", suite, "acceptance, report or nightly")->check(CLI::IsMember(suites));
}

CLI::Option* add_patterns(CLI::App& command, std::vector<std::string>& patterns) {
  return command.add_option("PATTERN", patterns, "a case, CASE.METHOD, a glob or a part of one; all if there is none");
}

}  // namespace touchstone::vnv::command
