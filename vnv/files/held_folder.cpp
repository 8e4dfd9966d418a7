#include "vnv/files/held_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace touchstone::files {

HeldFolder::HeldFolder(const std::filesystem::path& folder) : opened_(open(folder.c_str(), O_RDONLY | O_CLOEXEC)) {
  while (opened_ >= 0 && flock(opened_, LOCK_EX) != 0 && errno == EINTR) continue;
}

HeldFolder::~HeldFolder() {
  if (opened_ >= 0) close(opened_);
}

}  // namespace touchstone::files
