/// A library to be preloaded: lets one call of the programs of a build fail as it does on a machine in trouble.
///
/// FAILING_CALL=write:28:7 lets the 7th call of write fail with error 28, counted over all processes together in the
/// file FAILING_COUNT, of eight bytes, and only in programs whose path begins with FAILING_IN. Calls: open (also of
/// streams), write, rename, fsync, mkdir, fork (also of posix_spawn and popen). FAILING_CALL=clock:-3:7 sets the clock
/// of the calendar three days back at its 7th call, and from then on.

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

struct Order {
  char call[16] = "";
  int error = 0;
  long which = 0;
  std::atomic<long>* count = nullptr;  // of all processes
};

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

using Open = int(const char*, int, ...);

bool is_meant() {
  char program[4096] = "";
  const char* where = std::getenv("FAILING_IN");
  return where && readlink("/proc/self/exe", program, sizeof program - 1) > 0 &&
         std::strncmp(program, where, std::strlen(where)) == 0;
}

Order order_given() {
  Order order;
  const char *call = std::getenv("FAILING_CALL"), *file = std::getenv("FAILING_COUNT");
  if (!call || !file || !is_meant()) return order;
  if (std::sscanf(call, "%15[a-z]:%d:%ld", order.call, &order.error, &order.which) != 3) return order;
  const int opened = real<Open>("open")(file, O_RDWR | O_CLOEXEC);
  void* shared = opened < 0 ? MAP_FAILED : mmap(nullptr, 8, PROT_READ | PROT_WRITE, MAP_SHARED, opened, 0);
  if (shared != MAP_FAILED) order.count = static_cast<std::atomic<long>*>(shared);
  if (opened >= 0) close(opened);
  return order;
}

const Order& order() {
  static const Order given = order_given();
  return given;
}

/// Counts this call, if it is the one that is ordered; else 0.
long counted(const char* call) { return order().count && std::strcmp(call, order().call) == 0 ? ++*order().count : 0; }

/// Whether this call fails, with its error in errno.
bool fails(const char* call) {
  if (counted(call) != order().which || !order().count) return false;
  errno = order().error;
  return true;
}

/// By how much the clock is wrong [s].
time_t wrong() { return counted("clock") >= order().which ? 86400L * order().error : 0; }

}  // namespace

extern "C" {

int open(const char* file, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;
  va_end(more);
  return fails("open") ? -1 : real<Open>("open")(file, flags, mode);
}
int open64(const char* file, int flags, ...) __attribute__((alias("open")));  // with files of 64 bits they are the same
FILE* fopen(const char* file, const char* mode) {
  return fails("open") ? nullptr : real<decltype(fopen)>("fopen")(file, mode);
}
FILE* fopen64(const char* file, const char* mode) __attribute__((alias("fopen")));
ssize_t write(int file, const void* bytes, size_t size) {
  return fails("write") ? -1 : real<decltype(write)>("write")(file, bytes, size);
}
ssize_t writev(int file, const iovec* parts, int count) {
  return fails("write") ? -1 : real<decltype(writev)>("writev")(file, parts, count);
}
int rename(const char* from, const char* to) noexcept {
  return fails("rename") ? -1 : real<int(const char*, const char*)>("rename")(from, to);
}
int fsync(int file) { return fails("fsync") ? -1 : real<int(int)>("fsync")(file); }
int mkdir(const char* folder, mode_t mode) noexcept {
  return fails("mkdir") ? -1 : real<int(const char*, mode_t)>("mkdir")(folder, mode);
}
pid_t fork() noexcept { return fails("fork") ? -1 : real<pid_t()>("fork")(); }
FILE* popen(const char* command, const char* mode) {
  return fails("fork") ? nullptr : real<decltype(popen)>("popen")(command, mode);
}
int posix_spawn(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const* arguments, char* const* environment) {
  using Spawn =
      int(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const*, char* const*);
  return fails("fork") ? errno : real<Spawn>("posix_spawn")(process, path, actions, attributes, arguments, environment);
}

time_t time(time_t* to) noexcept {
  const time_t now = real<time_t(time_t*)>("time")(nullptr) + wrong();
  if (to) *to = now;
  return now;
}
int clock_gettime(clockid_t clock, timespec* to) noexcept {
  const int status = real<int(clockid_t, timespec*)>("clock_gettime")(clock, to);
  if (clock == CLOCK_REALTIME) to->tv_sec += wrong();
  return status;
}

}  // extern "C"
