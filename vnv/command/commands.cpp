#include "vnv/command/commands.hpp"

#include "vnv/command/joined.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::vnv::command {

CLI::Option* add_suite(CLI::App& command, std::string& suite) {
  return command.add_option("--suite", suite, "acceptance, report or nightly")->check(CLI::IsMember(suites));
}

CLI::Option* add_patterns(CLI::App& command, std::vector<std::string>& patterns) {
  return command.add_option("PATTERN", patterns, "a case, CASE.METHOD, a glob or a part of one; all if there is none");
}

CLI::Option* add_at_once(CLI::App& command, int& at_once) {
  return command.add_option("-j", at_once, "so many programs at once; what judges time runs alone")
      ->check(CLI::Range(1, 4096));
}

void make_pages(const Build& build, const Words& arguments) {
  Words call = {(build.folder / "reports" / "touchstone_report").string()};
  call.insert(call.end(), arguments.begin(), arguments.end());
  if (const programs::Ending ending = programs::run_here(call); !ending.well())
    throw std::runtime_error(fmt::format("{} {}", joined(call, " "), ending.sentence()));
}

}  // namespace touchstone::vnv::command
