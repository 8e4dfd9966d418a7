#pragma once
/// Figures of a case: the image, and beside it the script and the data that redraw it.

#include "reports/figures/plot.hpp"

#include <filesystem>
#include <utility>
#include <vector>

namespace touchstone::reports {

/// Figures with what is to be drawn in them: all of a case that have curves or clouds, and errors over spacing of all
/// its methods, once for each quantity and time that its orders are compared in.
using Plots = std::vector<std::pair<vnv::Figure, Plot>>;
Plots plots_of_all(const CaseRecords& records);
Plots plots_of_orders(const CaseRecords& records);

/// The image of the first figure with clouds, or else of the first with curves, by its name; empty without any.
std::string first_image(const CaseRecords& records);

/// Leaves <id>.gp, <id>.csv, and <id>.svg or <id>.png of each in a folder.
/// Throws as `run_gnuplot` and `write_whole` do; then the image is not there.
void draw(const Plots& plots, const std::filesystem::path& folder);

}  // namespace touchstone::reports
