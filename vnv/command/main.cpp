/// vnv: one command for people. What it does, the programs do; ctest calls the same programs.

#include "vnv/command/commands.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

/// This program lies in BUILD/vnv/.
fs::path own_build_folder() { return fs::read_symlink("/proc/self/exe").parent_path().parent_path(); }

/// With the help of the subcommand that the command line got to.
int complain(const CLI::App& app, const CLI::ParseError& error) {
  fmt::print(stderr, "vnv: {}\n\n{}", error.what(), app.help());
  return bad_usage;
}

int run(int count, char** arguments) {
  CLI::App app{"Runs cases, judges them by their claims, and tells what they are."};
  app.name("vnv");
  app.footer(
      "Examples:\n"
      "  vnv run poiseuille              judge each method of a case\n"
      "  vnv explain poiseuille.mpm      what is solved, claimed and cited\n"
      "  vnv run --suite nightly -j 4    all of a suite, four programs at once\n"
      "Each method is a test as well: ctest -R '^poiseuille.mpm$', or '^nightly.poiseuille.mpm$'. Unit tests are of "
      "ctest alone: ctest -L unit.\n"
      "Exit status: 0 all claims hold, 1 some do not, 3 bad input, 4 bad usage.");
  app.require_subcommand(0, 1);  // that there is one is asked last, so that a misspelt one is named
  app.fallthrough();
  Session session;
  session.build.folder = own_build_folder();
  app.add_option("--build", session.build.folder, "build folder; else that of this program");
  app.add_option("--data", session.build.data, "folder of experiments, papers and baselines; else that of the sources");
  for (const auto add : subcommands) add(app, session);
  try {
    app.parse(count, arguments);
    if (!session.todo) throw CLI::RequiredError::Subcommand(1);
  } catch (const CLI::ParseError& error) {
    const bool is_help = error.get_exit_code() == 0;
    return is_help ? app.exit(error) : complain(app, error);
  }
  return session.todo();
}

}  // namespace
}  // namespace touchstone::vnv::command

int main(int count, char** arguments) {
  try {
    return touchstone::vnv::command::run(count, arguments);
  } catch (const touchstone::programs::Interrupted& told) {
    fmt::print(stderr, "vnv: {}\n", told.sentence());
    touchstone::programs::end_by(told.signal);
  } catch (const std::exception& error) {
    fmt::print(stderr, "vnv: {}\n", error.what());
    return touchstone::vnv::command::bad_input;
  }
}
