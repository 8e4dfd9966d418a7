#include "reports/pages/staging.hpp"

#include "vnv/files/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;
using files::neighbour;
using files::remove_what_the_killed_left;

void require_written(const std::error_code& cause, const fs::path& place) {
  if (cause) throw std::runtime_error(fmt::format("{}: cannot be written: {}", place.string(), cause.message()));
}

// In one step; false where the system cannot, or one of them is not there.
bool are_exchanged([[maybe_unused]] const fs::path& one, [[maybe_unused]] const fs::path& other) {
#ifdef RENAME_EXCHANGE
  return renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

// "site/" and "./site" name the same folder as "site".
fs::path plain_path(const fs::path& site) {
  const fs::path whole = fs::absolute(site).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

Staging::Staging(fs::path site) : site_(plain_path(site)), folder_(neighbour(site_, "part")) {
  const bool is_free = !fs::exists(site_) || (fs::is_directory(site_) && fs::is_empty(site_));
  if (!is_free && !fs::exists(site_ / "verdicts.csv"))
    throw std::runtime_error(
        fmt::format("{}: is there and is no site, expected a new, an empty or a former one", site.string()));
  std::error_code cause;
  fs::create_directories(folder_, cause);
  require_written(cause, site);
}

Staging::~Staging() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Staging::publish() {
  std::error_code cause, ignored;
  if (!are_exchanged(folder_, site_)) {
    const fs::path former = neighbour(site_, "former");
    fs::rename(site_, former, ignored);
    fs::rename(folder_, site_, cause);
    if (cause) fs::rename(former, site_, ignored);
    require_written(cause, site_);
    fs::remove_all(former, ignored);
  }
  remove_what_the_killed_left(site_);
}

void Staging::publish_file(const std::string& name) {
  std::error_code cause;
  fs::create_directories(site_, cause);
  require_written(cause, site_);
  fs::rename(folder_ / name, site_ / name, cause);
  require_written(cause, site_ / name);
}

}  // namespace touchstone::reports
