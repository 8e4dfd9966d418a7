#pragma once
/// A program that gets no more memory says so in one line.

#include <new>
#include <string_view>

namespace touchstone::programs {

struct OutOfMemory : std::bad_alloc {
  const char* what() const noexcept override { return "out of memory"; }
};

/// From now on `new` throws OutOfMemory. Where that leaves a function that may not throw, as the destructor of a JSON
/// value, which allocates, nobody can catch it: `PROGRAM: out of memory` is said and this program ends with that
/// status, where std::terminate would end it by SIGABRT.
void tell_when_out_of_memory(std::string_view program, int status);

}  // namespace touchstone::programs
