#include "vnv/programs/command_line.hpp"

#include <gtest/gtest.h>

namespace touchstone::programs {
namespace {

/// What is told of a command line, empty if it is right.
std::string told(std::vector<std::string> words) {
  CLI::App app{"Tries.", "tried"};
  double length = 0;
  int runs = 0;
  std::string suite;
  app.add_option("--length", length, "")->check(above_zero());
  app.add_option("--runs", runs, "")->check(whole_numbers(1, 9));
  app.add_option("--suite", suite, "")->check(one_of({"day", "night"}));
  app.add_option("--folder", suite, "")->check(existing_folder());
  app.add_subcommand("list", "Lists.")->add_option("FILE", suite, "")->required();
  std::ranges::reverse(words);
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return misuse(app, error);
  }
  return "";
}
std::string told_of(const std::string& what) { return "tried: " + what + "; tried --help shows what is expected"; }

TEST(CommandLine, SaysInOneLineWhatIsWrongWithTheValueAndWhatWasExpected) {
  for (const char* length : {"-1", "0", "nan", "inf", "1e999", "1m", "", "one"})
    EXPECT_EQ(told({"--length", length}), told_of(fmt::format("--length: '{}', expected a number above 0", length)));
  for (const char* runs : {"0", "10", "2.5", "x"})
    EXPECT_EQ(told({"--runs", runs}), told_of(fmt::format("--runs: '{}', expected a whole number from 1 to 9", runs)));
  EXPECT_EQ(told({"--suite", "week"}), told_of("--suite: 'week', expected one of: day, night"));
  EXPECT_EQ(told({"--folder", "no_such"}), told_of("--folder: 'no_such', expected a folder"));
}

TEST(CommandLine, NamesWhatIsUnknownAndTheSubcommandThatWasCalled) {
  EXPECT_EQ(told({"--lenght", "1"}), told_of("unknown option '--lenght'"));
  EXPECT_EQ(told({"lst"}), told_of("unknown argument 'lst'"));
  EXPECT_EQ(told({"list", "a", "b"}), "tried list: unknown argument 'b'; tried list --help shows what is expected");
  EXPECT_EQ(told({"list"}), "tried list: FILE is required; tried list --help shows what is expected");
}

TEST(CommandLine, TakesWhatIsRight) {
  EXPECT_EQ(told({"--length", "1e-5", "--runs", "9", "--suite", "night", "--folder", "/"}), "");
}

}  // namespace
}  // namespace touchstone::programs
