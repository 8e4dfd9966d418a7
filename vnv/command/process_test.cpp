#include "vnv/command/process.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

Heard shell(const std::string& script) { return run_and_hear({"/bin/sh", "-c", script}); }

TEST(AProgram, IsHeardOnBothStreams) {
  const Heard heard = shell("echo out; echo err >&2");
  EXPECT_TRUE(heard.ending.well());
  EXPECT_EQ(heard.output, "out\n");
  EXPECT_EQ(heard.errors, "err\n");
}

TEST(AProgram, ThatFailsIsQuotedByTheFirstLineOfItsErrors) {
  const Heard heard = shell("echo out; echo 'no such method' >&2; echo 'see --help' >&2; exit 3");
  EXPECT_EQ(heard.ending.status, 3);
  EXPECT_EQ(heard.complaint(), "no such method");
  EXPECT_EQ(shell("exit 2").complaint(), "ended with status 2");
}

TEST(AProgram, ThatIsKilledIsToldWithItsSignal) {
  const Heard heard = shell("echo half >&2; kill -SEGV $$");
  EXPECT_FALSE(heard.ending.well());
  EXPECT_EQ(heard.ending.sentence(), "was killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(heard.complaint(), heard.ending.sentence());
}

TEST(AProgram, ThatIsNotThereIsRefusedByName) {
  try {
    run_and_hear({"/no/such/program"});
    FAIL() << "ran without complaint";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "/no/such/program: cannot be run: No such file or directory");
  }
}

}  // namespace
}  // namespace touchstone::vnv::command
