#include "vnv/programs/programs.hpp"

#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::programs {
namespace {

CapturedOutput shell(const std::string& script) { return run_and_capture({"/bin/sh", "-c", script}); }

TEST(AProgram, IsHeardOnBothStreams) {
  const CapturedOutput captured = shell("echo out; echo err >&2");
  EXPECT_TRUE(captured.ending.succeeded());
  EXPECT_EQ(captured.output, "out\n");
  EXPECT_EQ(captured.errors, "err\n");
}

TEST(AProgram, ThatFailsIsQuotedByTheFirstLineOfItsErrors) {
  const CapturedOutput captured = shell("echo out; echo 'no such method' >&2; echo 'see --help' >&2; exit 3");
  EXPECT_EQ(captured.ending.status, 3);
  EXPECT_EQ(captured.complaint(), "no such method");
  EXPECT_EQ(shell("exit 2").complaint(), "ended with status 2");
}

TEST(AProgram, ThatIsKilledIsToldWithItsSignal) {
  const CapturedOutput captured = shell("echo half >&2; kill -SEGV $$");
  EXPECT_FALSE(captured.ending.succeeded());
  EXPECT_EQ(captured.ending.sentence(), "was killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(captured.complaint(), captured.ending.sentence());
}

TEST(AProgram, ThatIsNotThereIsRefusedByName) {
  try {
    run_and_capture({"/no/such/program"});
    FAIL() << "ran without complaint";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "/no/such/program: cannot be started: No such file or directory");
  }
}

TEST(AProgram, WritesBothStreamsIntoOneFileAndHasNothingToRead) {
  const ScratchFolder folder;
  const auto file = folder.path() / "output";
  EXPECT_EQ(run_into(file, {"sh", "-c", "echo out; echo err >&2; cat; exit 3"}).status, 3);
  EXPECT_EQ(last_lines(file, 9), "out\nerr");
  EXPECT_EQ(last_lines(file, 1), "err");
}

TEST(Programs, ThatRunBesideEachOtherAreToldApart) {
  Running running;
  const pid_t slow = running.start("slow", {"sh", "-c", "sleep 0.2; exit 2"}, Streams{});
  const pid_t fast = running.start("fast", {"sh", "-c", "exit 1"}, Streams{});
  const auto next = [&] { return running.wait(std::chrono::seconds(20)).value(); };
  const Child first = next(), second = next();
  EXPECT_EQ(first.id, fast);
  EXPECT_EQ(first.ending.status, 1);
  EXPECT_EQ(second.id, slow);
  EXPECT_EQ(second.ending.status, 2);
}

TEST(Programs, AreWaitedForNoLongerThanAsked) {
  Running running;
  running.start("slow", {"sleep", "60"}, Streams{});
  EXPECT_FALSE(running.wait(std::chrono::milliseconds(10)).has_value());
}

}  // namespace
}  // namespace touchstone::programs
