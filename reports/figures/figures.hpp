#pragma once
/// Figures of a case: the image, and beside it the script and the data that redraw it.

#include "reports/figures/plot.hpp"

#include <filesystem>
#include <utility>
#include <vector>

namespace touchstone::reports {

/// A figure that stands in its folder as <id>.svg or <id>.png, <id>.gp and <id>.csv.
struct DrawnFigure {
  vnv::Figure figure;
  std::string image;
  int width, height;  // as shown, in pixels
  long undrawn;       // points that could not be shown
  long covered;       // points that others would cover
};

/// Throws as `run_gnuplot` and `save` do; then the image is not there.
DrawnFigure draw(const vnv::Figure& figure, const CaseRecords& records, const std::filesystem::path& folder);

/// A plot in the frame of a figure.
DrawnFigure draw(const Plot& plot, const vnv::Figure& figure, const std::filesystem::path& folder);

/// Figures with what is to be drawn in them: all of a case that have curves or clouds, and errors over spacing of all
/// its methods, once for each quantity and time that its orders are compared in.
using Plots = std::vector<std::pair<vnv::Figure, Plot>>;
Plots plots_of_all(const CaseRecords& records);
Plots plots_of_orders(const CaseRecords& records);

/// The image of the first figure with clouds, or else of the first with curves, by its name; empty without any.
std::string first_image(const CaseRecords& records);

/// The first.
std::vector<DrawnFigure> draw_all(const CaseRecords& records, const std::filesystem::path& folder);

/// The second.
std::vector<DrawnFigure> draw_orders(const CaseRecords& records, const std::filesystem::path& folder);

}  // namespace touchstone::reports
