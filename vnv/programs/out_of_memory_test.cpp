#include "vnv/programs/out_of_memory.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace touchstone::programs {
namespace {

template <class Exception>
void fail() {
  throw Exception("");
}

template <class Exception>
void end_by_what_may_not_throw() noexcept {
  tell_when_out_of_memory("vnv", 3);
  fail<Exception>();
}

struct NoMemory : std::bad_alloc {
  explicit NoMemory(const char*) {}
};

TEST(OutOfMemoryDeathTest, WhatMayNotThrowEndsTheProgramWithALineAndAStatus) {
  EXPECT_EXIT(end_by_what_may_not_throw<NoMemory>(), testing::ExitedWithCode(3), "^vnv: out of memory\n$");
}

TEST(OutOfMemoryDeathTest, AnyOtherExceptionThatNobodyCanCatchStillAborts) {
  EXPECT_EXIT(end_by_what_may_not_throw<std::logic_error>(), testing::KilledBySignal(SIGABRT), "logic_error");
}

void end_by_what_new_throws() {
  tell_when_out_of_memory("vnv", 3);
  try {
    std::get_new_handler()();
  } catch (const std::exception& error) {
    std::_Exit(error.what() == std::string_view("out of memory") ? 0 : 1);
  }
}

TEST(OutOfMemoryDeathTest, NewThrowsWhatSaysSo) {
  EXPECT_EXIT(end_by_what_new_throws(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace touchstone::programs
