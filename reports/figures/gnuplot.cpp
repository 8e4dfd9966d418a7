#include "reports/figures/gnuplot.hpp"

#include "reports/text/html.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

// A gnuplot that ends early must not end this program with it.
class NoBrokenPipes {
 public:
  NoBrokenPipes() = default;
  ~NoBrokenPipes() { std::signal(SIGPIPE, former_); }
  NoBrokenPipes(const NoBrokenPipes&) = delete;
  NoBrokenPipes& operator=(const NoBrokenPipes&) = delete;

 private:
  void (*former_)(int) = std::signal(SIGPIPE, SIG_IGN);
};

// Where gnuplot leaves what it has drawn, what it says, and that it came to the end.
struct Traces {
  fs::path image, log, marker;
  const char* variable;  // that tells a script which terminal to take

  explicit Traces(const fs::path& final_image)
      : image(beside(final_image, "part")),
        log(beside(final_image, "log")),
        marker(beside(final_image, "end")),
        variable(final_image.extension() == ".png"   ? "raster = 1\n"
                 : final_image.extension() == ".pdf" ? "paper = 1\n"
                                                     : "") {}
  ~Traces() {
    std::error_code ignored;
    for (const auto& file : {image, log, marker}) fs::remove(file, ignored);
  }
  Traces(const Traces&) = delete;
  Traces& operator=(const Traces&) = delete;

 private:
  static fs::path beside(const fs::path& file, const char* kind) {
    return file.parent_path() / fmt::format(".{}.{}", file.filename().string(), kind);
  }
};

std::string quoted(const fs::path& path) { return fmt::format("'{}'", replaced(path.string(), "'", "'\\''")); }

// In gnuplot's own single quotes, a quote is written twice.
std::string as_text(const fs::path& path) { return fmt::format("'{}'", replaced(path.string(), "'", "''")); }

// gnuplot's message is the last line that says something; those before repeat the command and point at it.
std::string message_in(const fs::path& log) {
  std::istringstream lines(files::read_whole(log));
  std::string message = "it ended early and said nothing; is the disk full?";
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t^") != std::string::npos) message = line.substr(line.find_first_not_of(" \t"));
  return message;
}

// gnuplot does not notice a full disk.
bool is_whole(const fs::path& image) {
  const std::string text = files::read_whole(image);
  const std::string tail = text.substr(text.size() - std::min<std::size_t>(text.size(), 16));
  return tail.find("</svg>") != std::string::npos || tail.find("IEND") != std::string::npos ||
         tail.find("%%EOF") != std::string::npos;
}

// Read as a file, not as a dialogue: then the first error ends gnuplot, and the marker is never written.
void send(const fs::path& gnuplot, const fs::path& script, const Traces& traces, int longest) {
  const NoBrokenPipes guard;
  // `|| :` since gnuplot-iostream complains on standard error of an exit status; the marker tells as much.
  Gnuplot pipe(
      fmt::format("cd {0} && {{ timeout --foreground -k 1 {3} {1} -d /dev/stdin || [ $? -ne 124 ] || "
                  "echo 'it took longer than {3} s'; }} > {2} 2>&1 || :",
                  quoted(script.parent_path()), quoted(gnuplot), quoted(traces.log), longest));
  pipe << fmt::format("{}image = {}\nload {}\nset output\n", traces.variable, as_text(traces.image), as_text(script));
  pipe << fmt::format("set print {}\nprint 'end'\n", as_text(traces.marker));
}

}  // namespace

fs::path find_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && access((fs::path(folder) / "gnuplot").c_str(), X_OK) == 0)
      return fs::path(folder) / "gnuplot";
  throw GnuplotMissing(
      "gnuplot: not found on PATH, expected for the figures; install it (Debian: apt install gnuplot-nox)");
}

void run_gnuplot(const fs::path& script, const fs::path& image, int longest) {
  const fs::path gnuplot = find_gnuplot();
  const Traces traces(fs::absolute(image));
  send(fs::absolute(gnuplot), fs::absolute(script), traces, longest);
  if (files::read_whole(traces.marker) != "end\n")
    throw std::runtime_error(fmt::format("gnuplot: {} not drawn: {}", image.string(), message_in(traces.log)));
  if (!is_whole(traces.image))
    throw std::runtime_error(
        fmt::format("gnuplot: {} not drawn: the image is not whole; is the disk full?", image.string()));
  fs::rename(traces.image, image);
}

void run_gnuplot(const fs::path& image, int longest) {
  run_gnuplot(fs::path(image).replace_extension(".gp"), image, longest);
}

}  // namespace touchstone::reports
