#include "vnv/doors/read/parts/in_a_child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>

#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors {
namespace {

/// One end of a pipe, from which what is passed comes or into which it goes; after the first failure nothing does.
class Pipe {
 public:
  enum class Way { in, out };

  /// Of what comes it takes no more than `most_bytes` for one list of numbers.
  Pipe(int end, Way way, std::size_t most_bytes = 0) : end_(end), way_(way), most_bytes_(most_bytes) {}
  ~Pipe() { close(end_); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool is_whole() const { return is_whole_; }

  void pass(std::uint64_t& number) { transfer(reinterpret_cast<char*>(&number), sizeof number); }
  template <class Number>
  void pass(std::optional<Number>& maybe) {
    std::uint64_t is_there = maybe.has_value(), bits = std::bit_cast<std::uint64_t>(maybe.value_or(0));
    pass(is_there), pass(bits);
    if (is_there) maybe = std::bit_cast<Number>(bits);
  }
  void pass(std::string& text) {
    std::vector<char> letters(text.begin(), text.end());
    pass_numbers(letters, [&] { transfer(letters.data(), letters.size()); });
    text.assign(letters.begin(), letters.end());
  }
  /// Of what goes the numbers are gone then.
  void pass(Array& array) {
    std::uint64_t components = static_cast<std::uint64_t>(array.components);
    pass(array.name), pass(components);
    array.components = std::max(1, static_cast<int>(components));
    pass_numbers(array.values, [&] {
      consume_rows(array, [&](std::size_t, std::span<const double> some) {
        transfer(reinterpret_cast<char*>(const_cast<double*>(some.data())), some.size_bytes());  // which it only reads
      });
    });
    pass(array.labels);
  }
  void pass(Dataset& one) { pass(one.source), pass(one.format), pass(one.time), pass(one.index), pass(one.arrays); }
  template <class One>
  void pass(std::vector<One>& all) {
    std::uint64_t count = all.size();
    pass(count);
    for (std::uint64_t k = 0; is_whole_ && k < count; ++k) pass(way_ == Way::in ? all.emplace_back() : all[k]);
  }

 private:
  template <class Number>
  void pass_numbers(std::vector<Number>& numbers, const auto& give) {
    std::uint64_t left = numbers.size();
    pass(left);
    if (way_ == Way::out) return give();
    if (left > most_bytes_ / sizeof(Number)) is_whole_ = false;
    if (is_whole_) reserve_more(numbers, left);
    while (is_whole_ && left > 0) {  // a broken count fills no more memory than comes
      const std::size_t first = numbers.size(), count = std::min<std::uint64_t>(left, 1 << 20);
      numbers.resize(first + count);
      transfer(reinterpret_cast<char*>(numbers.data() + first), count * sizeof(Number));
      left -= count;
    }
  }

  void transfer(char* bytes, std::size_t left) {
    while (is_whole_ && left > 0) {
      const ssize_t done = way_ == Way::in ? ::read(end_, bytes, left) : ::write(end_, bytes, left);
      if (done < 0 && errno == EINTR) continue;
      is_whole_ = done > 0;
      if (!is_whole_) return;
      bytes += done;
      left -= static_cast<std::size_t>(done);
    }
  }

  int end_;
  Way way_;
  std::size_t most_bytes_;
  bool is_whole_ = true;
};

/// Of this process: what it may write and shares with no other.
std::size_t bytes_of_data() {
  constexpr int place = 6;  // of the numbers of pages in this file
  std::ifstream pages("/proc/self/statm");
  std::size_t count = 0;
  for (int k = 0; k < place; ++k) pages >> count;
  return count * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void be_the_child(int end, const std::string& where, unsigned seconds, std::size_t bytes,
                               const std::function<std::vector<Dataset>()>& read) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // it ends with its parent
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGABRT}) std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const std::size_t most_bytes = bytes_of_data() + bytes;
  const rlimit no_core{0, 0}, time{seconds, seconds}, memory{most_bytes, most_bytes};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_DATA, &memory);
  setrlimit(RLIMIT_CPU, &time);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  Pipe pipe(end, Pipe::Way::out);
  std::string refusal;
  std::vector<Dataset> datasets;
  try {
    datasets = read();
  } catch (const std::bad_alloc&) {
    refusal = fmt::format("{}: takes more than {} bytes of memory", where, bytes);
  } catch (const std::exception& error) {
    refusal = error.what();
  }
  pipe.pass(refusal);
  if (refusal.empty()) pipe.pass(datasets);
  _exit(pipe.is_whole() ? 0 : 1);
}

}  // namespace

std::vector<Dataset> read_in_a_child(const std::string& where, unsigned seconds, std::size_t bytes,
                                     const std::function<std::vector<Dataset>()>& read) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse(where, fmt::format("no pipe: {}", std::strerror(errno)));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    be_the_child(ends[1], where, seconds, bytes, read);
  }
  close(ends[1]);
  std::string refusal;
  std::vector<Dataset> datasets;
  bool is_whole = false;
  {  // which closes the pipe, so that a child that is astray does not wait for it
    Pipe pipe(ends[0], Pipe::Way::in, bytes);
    if (child < 0) refuse(where, fmt::format("no process of its own: {}", std::strerror(errno)));
    pipe.pass(refusal);
    if (refusal.empty()) pipe.pass(datasets);
    is_whole = pipe.is_whole();
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!refusal.empty()) throw Unreadable(refusal);
  if (!is_whole || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    refuse(where, fmt::format("the library that reads it ended {} {}, expected a file that it can read",
                              WIFSIGNALED(status) ? "by signal" : "with status",
                              WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status)));
  for (const Dataset& dataset : datasets) require_equal_rows(dataset.arrays, where);
  return datasets;
}

}  // namespace touchstone::vnv::doors
