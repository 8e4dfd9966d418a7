#include "reports/figures/gnuplot.hpp"

#include "reports/text/html.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/programs.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

// In gnuplot's single quotes, a quote is written twice.
std::string quoted(const fs::path& path) { return fmt::format("'{}'", replaced(path.string(), "'", "''")); }

// gnuplot's message is the last line that says something; those before repeat the command and point at it.
std::string message_in(const std::string& errors) {
  std::istringstream lines(errors);
  std::string message = "it ended early and said nothing; is the disk full?";
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t^") != std::string::npos) message = line.substr(line.find_first_not_of(" \t"));
  return message;
}

// gnuplot does not notice a full disk.
bool is_whole(const fs::path& image) {
  std::ifstream stream(image, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string tail = text.substr(text.size() - std::min<std::size_t>(text.size(), 16));
  return tail.find("</svg>") != std::string::npos || tail.find("IEND") != std::string::npos;
}

}  // namespace

fs::path find_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && fs::exists(fs::path(folder) / "gnuplot")) return fs::path(folder) / "gnuplot";
  throw GnuplotMissing(
      "gnuplot: not found on PATH, expected for the figures; install it (Debian: apt install gnuplot-nox)");
}

void run_gnuplot(const fs::path& script, const fs::path& image) {
  const fs::path gnuplot = fs::absolute(find_gnuplot()), whole = fs::absolute(script);
  const fs::path part = files::neighbour(fs::absolute(image), "part");
  const std::string raster = image.extension() == ".png" ? "raster = 1; " : "";
  const programs::Heard heard =
      programs::run_and_hear({gnuplot, "-d", "-e",
                              fmt::format("{}cd {}; image = {}; load {}; set output; print 'drawn'", raster,
                                          quoted(whole.parent_path()), quoted(part), quoted(whole))});
  std::string fault;
  if (!heard.errors.ends_with("drawn\n"))  // its exit status is 0 where a script ends it early
    fault = message_in(heard.errors);
  else if (!is_whole(part))
    fault = "the image is not whole; is the disk full?";
  if (fault.empty()) return fs::rename(part, image);
  std::error_code ignored;
  fs::remove(part, ignored);
  throw std::runtime_error(fmt::format("gnuplot: {} not drawn: {}", image.string(), fault));
}

void run_gnuplot(const fs::path& image) { run_gnuplot(fs::path(image).replace_extension(".gp"), image); }

}  // namespace touchstone::reports
