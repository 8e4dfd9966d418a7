#include "vnv/programs/limited.hpp"

#include "vnv/programs/processes.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace touchstone::programs {
namespace {

class ALimitedProgram : public testing::Test {
 protected:
  ProcessResult shell(const std::string& script, const ProgramLimits& limits = {}) const {
    return run_limited("script", {"sh", "-c", script}, folder.path(), folder / "log", limits);
  }
  pid_t written(const std::string& file) const { return std::stoi(last_lines(folder / file, 1)); }
  const ScratchFolder folder;
};

TEST_F(ALimitedProgram, RunsInItsFolderAndIsMeasuredWithAllThatItStarts) {
  const ProcessResult result = shell("pwd; (i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done) & wait; exit 3");
  EXPECT_EQ(result.ending.status, 3);
  EXPECT_FALSE(result.succeeded());
  EXPECT_EQ(last_lines(folder / "log", 1), folder.path().string());
  EXPECT_GT(result.cpu, 0.01) << "what it started counts";
  EXPECT_GE(result.wall, 0.01);
}

TEST_F(ALimitedProgram, IsEndedAtALimitWhateverItIgnores) {
  const ProcessResult result =
      run_limited("deaf", {"sh", "-c", "trap '' TERM; echo $$ > id; while true; do sleep 0.05; done"}, folder.path(),
                  folder / "log", {.wall = 0.3, .grace = std::chrono::milliseconds(100)});
  EXPECT_EQ(result.sentence(), "was ended: took longer than 0.3 s");
  EXPECT_LT(result.wall, 5);
  EXPECT_NE(kill(written("id"), 0), 0) << "still runs";
  EXPECT_EQ(shell("yes", {.output = 1e5}).stopped, "wrote more than 0.1 MB to its output");
  EXPECT_EQ(shell("head -c 300000000 /dev/zero | tail", {.memory = 50e6}).stopped, "used more than 50 MB of memory");
}

TEST_F(ALimitedProgram, LeavesNothingThatItStarted) {
  const ProcessResult result =
      shell("setsid sh -c 'echo $$ > id; exec sleep 60' & while [ ! -s id ]; do sleep 0.01; done");
  EXPECT_TRUE(result.succeeded()) << result.sentence();
  EXPECT_NE(kill(written("id"), 0), 0) << "still runs";
}

TEST_F(ALimitedProgram, IsEndedBeforeTheDiskOfItsFolderIsFull) {
  const std::filesystem::path disk = folder / "disk";
  std::filesystem::create_directory(disk);
  if (mount("none", disk.c_str(), "tmpfs", 0, "size=50m") != 0) GTEST_SKIP() << "only root mounts a disk";
  const ProcessResult result =
      run_limited("writer", {"sh", "-c", "while head -c 200000 /dev/zero; do sleep 0.02; done > big"}, disk,
                  folder / "log", {.wall = 60, .grace = std::chrono::milliseconds(50)});
  EXPECT_EQ(result.stopped, "left hardly any space on the disk of " + disk.string());
  umount(disk.c_str());
}

TEST_F(ALimitedProgram, IsNotMeasuredWithWhoWatchesIt) {
  const std::string ballast(200'000'000, '.');  // of this process, which splits off the one that waits for the program
  EXPECT_LT(shell("sleep 0.2").peak_memory, 0.3 * static_cast<double>(ballast.size()));
}

TEST_F(ALimitedProgram, IsEndedWithAllItsForksAndSessions) {
  const std::string sleeper = fmt::format("sleep 61.{}", getpid());  // of no other who runs this test
  const ProcessResult result =
      shell("f() { while :; do setsid sh -c 'trap \"\" TERM; " + sleeper + "' & sleep 0.01; done; }; f & f & f & wait",
            {.wall = 0.5, .grace = std::chrono::milliseconds(50)});
  EXPECT_EQ(result.stopped, "took longer than 0.5 s");
  EXPECT_EQ(run_and_capture({"pgrep", "-f", "^" + sleeper}).output, "");
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
  const ProcessResult result = run_limited("none", {"no_such_program"}, folder.path(), folder / "log", {});
  EXPECT_EQ(result.ending.status, 127);
  EXPECT_NE(last_lines(folder / "log", 1).find("no_such_program"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::programs
