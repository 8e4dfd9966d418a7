#include "vnv/doors/read/in_a_child.hpp"

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

#include "vnv/doors/read/columns.hpp"
#include "vnv/doors/read/numbers.hpp"

namespace touchstone::vnv::doors {
namespace {

/// What goes through a pipe, or comes; after the first failure nothing does.
class Pipe {
 public:
  /// Of what comes it takes no more than `most_bytes` for one list of numbers.
  explicit Pipe(int end, std::size_t most_bytes = 0) : end_(end), most_bytes_(most_bytes) {}
  ~Pipe() { close(end_); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool is_whole() const { return is_whole_; }

  template <class Number>
  void put(const Number* numbers, std::size_t count) {
    transfer(reinterpret_cast<char*>(const_cast<Number*>(numbers)), count * sizeof(Number), ::write);
  }
  void put(std::uint64_t number) { put(&number, 1); }
  void put(const std::string& text) {
    put(text.size());
    put(text.data(), text.size());
  }

  template <class Number>
  std::vector<Number> get_all() {
    std::vector<Number> numbers;
    std::uint64_t left = get();
    if (left > most_bytes_ / sizeof(Number)) is_whole_ = false;
    if (is_whole_) reserve_more(numbers, left);
    while (is_whole_ && left > 0) {  // a broken count fills no more memory than comes
      const std::size_t first = numbers.size(), count = std::min<std::uint64_t>(left, 1 << 20);
      numbers.resize(first + count);
      transfer(reinterpret_cast<char*>(numbers.data() + first), count * sizeof(Number), ::read);
      left -= count;
    }
    return numbers;
  }
  std::uint64_t get() {
    std::uint64_t number = 0;
    transfer(reinterpret_cast<char*>(&number), sizeof number, ::read);
    return is_whole_ ? number : 0;
  }
  std::string get_text() {
    const std::vector<char> text = get_all<char>();
    return {text.begin(), text.end()};
  }

 private:
  template <class Call>
  void transfer(char* bytes, std::size_t left, Call call) {
    while (is_whole_ && left > 0) {
      const ssize_t done = call(end_, bytes, left);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) {
        is_whole_ = false;
      } else {
        bytes += done;
        left -= static_cast<std::size_t>(done);
      }
    }
  }

  int end_;
  std::size_t most_bytes_;
  bool is_whole_ = true;
};

/// Their numbers are gone then.
void put(Pipe& pipe, std::vector<Dataset>& datasets) {
  pipe.put(datasets.size());
  for (Dataset& dataset : datasets) {
    pipe.put(dataset.source);
    pipe.put(dataset.format);
    pipe.put(dataset.time.has_value());
    pipe.put(std::bit_cast<std::uint64_t>(dataset.time.value_or(0)));
    pipe.put(dataset.index.has_value());
    pipe.put(static_cast<std::uint64_t>(dataset.index.value_or(0)));
    pipe.put(dataset.arrays.size());
    for (Array& array : dataset.arrays) {
      pipe.put(array.name);
      pipe.put(static_cast<std::uint64_t>(array.components));
      pipe.put(array.values.size());
      consume_rows(array, [&](std::size_t, std::span<const double> some) { pipe.put(some.data(), some.size()); });
      pipe.put(array.labels.size());
      for (const std::string& label : array.labels) pipe.put(label);
    }
  }
}

std::vector<Dataset> get(Pipe& pipe) {
  std::vector<Dataset> datasets;
  for (std::uint64_t left = pipe.get(); pipe.is_whole() && left > 0; --left) {
    Dataset& dataset = datasets.emplace_back();
    dataset.source = pipe.get_text();
    dataset.format = pipe.get_text();
    const bool has_time = pipe.get() != 0;
    const auto time = std::bit_cast<double>(pipe.get());
    if (has_time) dataset.time = time;
    const bool has_index = pipe.get() != 0;
    const auto index = static_cast<long>(pipe.get());
    if (has_index) dataset.index = index;
    for (std::uint64_t arrays = pipe.get(); pipe.is_whole() && arrays > 0; --arrays) {
      Array& array = dataset.arrays.emplace_back();
      array.name = pipe.get_text();
      array.components = std::max(1, static_cast<int>(pipe.get()));
      array.values = pipe.get_all<double>();
      for (std::uint64_t labels = pipe.get(); pipe.is_whole() && labels > 0; --labels)
        array.labels.push_back(pipe.get_text());
    }
  }
  return datasets;
}

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
  Pipe pipe(end);
  try {
    std::vector<Dataset> datasets = read();
    pipe.put("");
    put(pipe, datasets);
  } catch (const std::bad_alloc&) {
    pipe.put(fmt::format("{}: takes more than {} bytes of memory", where, bytes));
  } catch (const std::exception& error) {
    pipe.put(error.what());
  }
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
    Pipe pipe(ends[0], bytes);
    if (child < 0) refuse(where, fmt::format("no process of its own: {}", std::strerror(errno)));
    refusal = pipe.get_text();
    if (refusal.empty()) datasets = get(pipe);
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
