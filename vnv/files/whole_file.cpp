#include "vnv/files/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace touchstone::files {
namespace {

namespace fs = std::filesystem;

/// Whether a process has ended but nobody has waited for it yet, so that its number is still taken: proc(5).
bool is_zombie(pid_t process) {
  const std::string stat = read_whole(fmt::format("/proc/{}/stat", process));
  const std::size_t name_ends = stat.rfind(')');
  return name_ends != std::string::npos && name_ends + 2 < stat.size() && stat[name_ends + 2] == 'Z';
}

bool has_ended(pid_t process) { return (kill(process, 0) != 0 && errno == ESRCH) || is_zombie(process); }

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// What is no regular file, /dev/full in a test, may have no disk to be brought to.
bool bring_to_disk(int file) { return fsync(file) == 0 || errno == EINVAL; }

/// False with the cause in `errno`.
bool write_and_rename(const fs::path& part, const fs::path& file, std::string_view text) {
  const int opened = open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0) return false;
  const bool is_written = write_all(opened, text) && bring_to_disk(opened);
  const int cause = errno;
  const bool is_closed = close(opened) == 0;
  if (!is_written) errno = cause;
  return is_written && is_closed && std::rename(part.c_str(), file.c_str()) == 0;
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code cause;
  fs::create_directories(folder, cause);
  if (!cause && !fs::is_directory(folder)) cause = std::make_error_code(std::errc::not_a_directory);
  if (cause) throw std::runtime_error(fmt::format("{}: no folder can be made: {}", folder.string(), cause.message()));
}

std::string read_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path neighbour(const fs::path& place, std::string_view kind) {
  return place.parent_path() / fmt::format(".{}.{}.{}", place.filename().string(), getpid(), kind);
}

void remove_what_the_killed_left(const fs::path& place) {
  const std::string begin = fmt::format(".{}.", place.filename().string());
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(fs::absolute(place).parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    pid_t process = 0;
    if (!name.starts_with(begin)) continue;
    const std::string kind = std::from_chars(name.data() + begin.size(), name.data() + name.size(), process).ptr;
    if ((kind == ".part" || kind == ".former") && process > 0 && has_ended(process)) left.push_back(entry.path());
  }
  for (const fs::path& file : left) fs::remove_all(file, ignored);
}

void write_whole(const fs::path& file, std::string_view text) {
  const fs::path part = neighbour(file, "part");
  if (!write_and_rename(part, file, text)) {
    const std::string cause = std::strerror(errno);
    std::error_code ignored;
    fs::remove(part, ignored);
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), cause));
  }
  remove_what_the_killed_left(file);
}

}  // namespace touchstone::files
