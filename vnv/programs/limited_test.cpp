#include "vnv/programs/limited.hpp"

#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace touchstone::programs {
namespace {

class ALimitedProgram : public testing::Test {
 protected:
  Ran shell(const std::string& script, const Limits& limits = {}) const {
    return run_limited("script", {"sh", "-c", script}, folder.path(), folder / "log", limits);
  }
  pid_t written(const std::string& file) const { return std::stoi(last_lines(folder / file, 1)); }
  const ScratchFolder folder;
};

TEST_F(ALimitedProgram, RunsInItsFolderAndIsMeasuredWithAllThatItStarts) {
  const Ran ran = shell("pwd; (i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done) & wait; exit 3");
  EXPECT_EQ(ran.ending.status, 3);
  EXPECT_FALSE(ran.well());
  EXPECT_EQ(last_lines(folder / "log", 1), folder.path().string());
  EXPECT_GT(ran.cpu, 0.01) << "what it started counts";
  EXPECT_GE(ran.wall, 0.01);
}

TEST_F(ALimitedProgram, IsEndedAtALimitWhateverItIgnores) {
  const Ran ran = run_limited("deaf", {"sh", "-c", "trap '' TERM; echo $$ > id; while true; do sleep 0.05; done"},
                              folder.path(), folder / "log", {.wall = 0.3, .grace = std::chrono::milliseconds(100)});
  EXPECT_EQ(ran.sentence(), "was ended: took longer than 0.3 s");
  EXPECT_LT(ran.wall, 5);
  EXPECT_NE(kill(written("id"), 0), 0) << "still runs";
  EXPECT_EQ(shell("yes", {.output = 1e5}).stopped, "wrote more than 0.1 MB to its output");
  EXPECT_EQ(shell("head -c 300000000 /dev/zero | tail", {.memory = 50e6}).stopped, "used more than 50 MB of memory");
}

TEST_F(ALimitedProgram, LeavesNothingThatItStarted) {
  const Ran ran = shell("setsid sh -c 'echo $$ > id; exec sleep 60' & while [ ! -s id ]; do sleep 0.01; done");
  EXPECT_TRUE(ran.well()) << ran.sentence();
  EXPECT_NE(kill(written("id"), 0), 0) << "still runs";
}

TEST(AProcess, ThatEndsBetweenLookingAndReadingSaysNothing) {
  const pid_t child = fork();
  if (child == 0) {
    pause();
    _exit(0);
  }
  std::ifstream open_before(fmt::format("/proc/{}/stat", child)), file(fmt::format("/proc/{}/stat", child));
  EXPECT_NE(said_by_process(open_before).find(')'), std::string::npos);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(said_by_process(file), "");
}

TEST_F(ALimitedProgram, ThatIsNotThereFails) {
  const Ran ran = run_limited("none", {"no_such_program"}, folder.path(), folder / "log", {});
  EXPECT_EQ(ran.ending.status, 127);
  EXPECT_NE(last_lines(folder / "log", 1).find("no_such_program"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::programs
