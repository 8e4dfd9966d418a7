#pragma once
/// How much memory a reader takes, for tests.

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <functional>

namespace touchstone::vnv::doors {

/// Bytes that a process of its own holds at the most, after this one's.
inline std::size_t most_held(const std::function<void()>& work) {
  const auto held_by = [](const std::function<void()>& of_child) {
    const pid_t child = fork();
    if (child == 0) {
      try {
        of_child();
      } catch (...) {
        _exit(1);
      }
      _exit(0);
    }
    int status = 0;
    rusage used{};
    EXPECT_EQ(wait4(child, &status, 0, &used), child);
    EXPECT_EQ(status, 0) << "it cannot be read";
    return 1024 * static_cast<std::size_t>(used.ru_maxrss);
  };
  malloc_trim(0);  // a child would use again what is free here
  const std::size_t before = held_by([] {});
  return held_by(work) - before;
}

}  // namespace touchstone::vnv::doors
