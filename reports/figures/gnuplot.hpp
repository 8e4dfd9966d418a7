#pragma once
/// gnuplot through gnuplot-iostream, which by itself fails silently: without gnuplot it ends the program by a signal or
/// leaves no file; after a bad command it leaves an empty one. Here an image is whole or there is an exception.

#include <filesystem>
#include <stdexcept>

namespace touchstone::reports {

struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Its path, by the PATH of the environment. Throws GnuplotMissing, saying what to install.
std::filesystem::path find_gnuplot();

/// Runs a script, in its folder, that draws into the file named by its variable `image`; one that draws an SVG draws a
/// PNG if `raster` is set and a PDF if `paper` is, as they are for images of these names.
/// Throws GnuplotMissing, or std::runtime_error with gnuplot's own message, or that it took longer than so many
/// seconds.
void run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& image, int longest = 60);

/// The same for the script beside the image: with the extension .gp.
void run_gnuplot(const std::filesystem::path& image, int longest = 60);

}  // namespace touchstone::reports
