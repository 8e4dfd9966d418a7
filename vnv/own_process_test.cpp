#include "vnv/own_process.hpp"

#include <gtest/gtest.h>

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
