#include "vnv/run/own_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace touchstone::vnv {
namespace {

TEST(OwnProcess, ReturnsWhatItCalculated) {
  const std::string text("a\0b", 3);
  const Ended ended = in_own_process([&] { return text; });
  EXPECT_EQ(ended.result(), text);
  EXPECT_EQ(ended.crash, "");
}

TEST(OwnProcess, LeavesThisOneAsItWas) {
  int number = 1;
  in_own_process([&] { return std::to_string(++number); });
  EXPECT_EQ(number, 1);
}

TEST(OwnProcess, ThatIsKilledIsReportedInOneLine) {
  const Ended ended = in_own_process([]() -> std::string {
    raise(SIGKILL);
    return "";
  });
  EXPECT_NE(ended.crash.find("died of signal 9"), std::string::npos) << ended.crash;
  EXPECT_EQ(ended.crash.find('\n'), std::string::npos);
}

TEST(OwnProcess, ThatLeavesEarlyIsReported) {
  const Ended ended = in_own_process([]() -> std::string { std::_Exit(3); });
  EXPECT_NE(ended.crash.find("status 3"), std::string::npos) << ended.crash;
}

TEST(OwnProcess, IsNotLeftBehindWhereWhoeverWaitsForItIsKilled) {
  int ends[2];  // of a pipe, which ends when the last who may write has ended
  ASSERT_EQ(pipe(ends), 0);
  const pid_t waiting = fork();
  if (waiting == 0) {
    in_own_process([&]() -> std::string {
      if (write(ends[1], "b", 1) == 1) sleep(60);
      return "";
    });
    _exit(0);
  }
  close(ends[1]);
  char letter = 0;
  EXPECT_EQ(read(ends[0], &letter, 1), 1);
  kill(waiting, SIGKILL);
  waitpid(waiting, nullptr, 0);
  const auto before = std::chrono::steady_clock::now();
  EXPECT_EQ(read(ends[0], &letter, 1), 0);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
  close(ends[0]);
}

TEST(OwnProcess, PassesOnWhatIsThrown) {
  EXPECT_THROW(in_own_process([]() -> std::string { throw std::invalid_argument("spacing"); }), std::invalid_argument);
  EXPECT_THROW(in_own_process([]() -> std::string { throw std::logic_error("other"); }), std::runtime_error);
}

TEST(OwnProcess, HasAPeakMemoryOfItsOwn) {
  const auto with = [](std::size_t megabytes) {
    return in_own_process([=] { return std::string(1, std::vector<char>(megabytes << 20, 'x')[1000]); }).peak_memory;
  };
  const double large = with(64), small = with(1);
  EXPECT_GT(large - small, 50e6);
}

}  // namespace
}  // namespace touchstone::vnv
