#include "vnv/run/own_process.hpp"

#include <fmt/format.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

// How a calculation ended, as the status of its process.
enum Status { returned = 0, refused = 10, failed = 11, unwritten = 12 };

/// Each sample of a run takes and leaves megabytes; a system that is given them back every time spends as long on
/// clearing them anew as on the sample itself.
void keep_memory_that_is_freed() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 25);  // the most that is allowed
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

/// Whoever waits for the calculation may be killed; then nobody asks for it any more.
void end_with(pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent) _exit(unwritten);  // it was killed before
}

int write_all(std::FILE* file, const std::string& text, Status status) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  return whole ? status : unwritten;
}

int calculated(const std::function<std::string()>& calculate, std::FILE* file) try {
  keep_memory_that_is_freed();
  return write_all(file, calculate(), returned);
} catch (const std::invalid_argument& error) {
  return write_all(file, error.what(), refused);
} catch (const std::exception& error) {
  return write_all(file, error.what(), failed);
}

/// What the system says of the end of a process.
struct Farewell {
  int status;
  rusage used;
};

Farewell wait_for(pid_t child) {
  Farewell farewell{};
  while (wait4(child, &farewell.status, 0, &farewell.used) < 0)
    if (errno != EINTR) throw std::runtime_error(fmt::format("own process: lost: {}", std::strerror(errno)));
  return farewell;
}

std::string described_crash(int status) {
  if (WIFSIGNALED(status)) return fmt::format("died of signal {}: {}", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("left with status {} and no result", WEXITSTATUS(status));
}

/// Bytes. Linux counts in kibibytes, Darwin in bytes.
double peak_memory_of(const rusage& used) {
#ifdef __APPLE__
  return static_cast<double>(used.ru_maxrss);
#else
  return 1024 * static_cast<double>(used.ru_maxrss);
#endif
}

}  // namespace

std::string Ended::result() const {
  std::fseek(file_.get(), 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::ftell(file_.get())), '\0');
  std::rewind(file_.get());
  text.resize(std::fread(text.data(), 1, text.size(), file_.get()));
  return text;
}

Ended in_own_process(const std::function<std::string()>& calculate) {
  Ended ended;
  ended.file_.reset(std::tmpfile());
  if (!ended.file_) throw std::runtime_error(fmt::format("own process: no file: {}", std::strerror(errno)));
  std::fflush(nullptr);  // else both processes print what is waiting
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::runtime_error(fmt::format("own process: cannot be split off: {}", std::strerror(errno)));
  if (child == 0) {
    end_with(parent);
    _exit(calculated(calculate, ended.file_.get()));
  }
  const Farewell farewell = wait_for(child);
  ended.peak_memory = peak_memory_of(farewell.used);
  ended.user_time =
      static_cast<double>(farewell.used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(farewell.used.ru_utime.tv_usec);
  const int status = WIFEXITED(farewell.status) ? WEXITSTATUS(farewell.status) : -1;
  if (status == refused) throw std::invalid_argument(ended.result());
  if (status == failed) throw std::runtime_error(ended.result());
  if (status == unwritten)
    throw std::runtime_error("own process: its result cannot be written below " P_tmpdir "; is the disk full?");
  if (status != returned) ended.crash = described_crash(farewell.status);
  return ended;
}

}  // namespace touchstone::vnv
