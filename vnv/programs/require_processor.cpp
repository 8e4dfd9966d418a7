/// A program that was built for its machine (TOUCHSTONE_NATIVE) and is started on a processor with fewer instructions
/// says so, where it would die of the first that is unknown. This is compiled for any processor, linked into every
/// program, and runs before all else of it.

#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace {

void refuse(const char* feature) {
  dprintf(STDERR_FILENO,
          "%s: needs %s, which this processor does not have; expected a build made here, or by the preset portable\n",
          program_invocation_short_name, feature);
  _exit(3);
}

[[gnu::constructor(101)]] void require_the_processor() {  // 101: before what is constructed without a number
  __builtin_cpu_init();
#define REQUIRE(feature) \
  if (!__builtin_cpu_supports(#feature)) refuse(#feature);
  NEEDED  // by the build: REQUIRE(avx) and so on
}

}  // namespace
