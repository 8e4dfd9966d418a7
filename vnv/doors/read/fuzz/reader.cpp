/// The reader of a format, given whatever libFuzzer makes of its samples: it gives datasets of equally many rows or
/// refuses in one line, and takes no more memory than ten times its file and a constant. Built by Clang as fuzz_npz and
/// so on, each with the name of its format in FORMAT; what may crash needs -fork=1 -ignore_crashes=1.

#include <sanitizer/allocator_interface.h>

#include <cstdlib>
#include <string_view>

#include "vnv/doors/read/testing.hpp"

/// Bytes that are allocated now, and at the most, since the reader began; it may free what was there before.
static std::ptrdiff_t allocated = 0, most_allocated = 0;

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const auto grow = [](const volatile void*, std::size_t bytes) {
    allocated += static_cast<std::ptrdiff_t>(bytes);
    most_allocated = std::max(allocated, most_allocated);
  };
  const auto shrink = [](const volatile void* begin) {
    allocated -= static_cast<std::ptrdiff_t>(__sanitizer_get_allocated_size(begin));
  };
  return __sanitizer_install_malloc_and_free_hooks(grow, shrink) == 0 ? 1 : 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace touchstone::vnv::doors;
  static const Format format = format_named(FORMAT);
  allocated = most_allocated = 0;
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const Dataset& dataset : format.read("no such folder/a.vtp", bytes, Limits{.most_bytes = 1 << 22}))
      for (const Array& array : dataset.arrays)
        if (array.rows() != dataset.rows()) std::abort();
  } catch (const Unreadable& error) {
    for (const char* c = error.what(); *c != 0; ++c)
      if (static_cast<unsigned char>(*c) < ' ') std::abort();
  }
  // libzip takes 2 MB for 65535 entries; libhdf5 allocates what a file claims, until its process may have no more.
  const std::size_t constant = format.may_crash ? std::size_t{1} << 28 : std::size_t{1} << 22;
  if (static_cast<std::size_t>(most_allocated) > 10 * size + constant) std::abort();
  return 0;
}
