#pragma once
/// gnuplot, which does not notice a full disk and after a bad command leaves an empty file: here an image is whole or
/// there is an exception.

#include <filesystem>
#include <stdexcept>

namespace touchstone::reports {

struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Its path, by the PATH of the environment. Throws GnuplotMissing, saying what to install.
std::filesystem::path find_gnuplot();

/// Runs a script, in its folder, that draws into the file named by its variable `image`; one that draws an SVG draws a
/// PNG if `raster` is set, as it is for an image of that name.
/// Throws GnuplotMissing, or std::runtime_error with gnuplot's own message.
void run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& image);

/// The same for the script beside the image: with the extension .gp.
void run_gnuplot(const std::filesystem::path& image);

}  // namespace touchstone::reports
