#pragma once
/// The figures of a site as a dashboard shows them beside the test that drew them.

#include <filesystem>
#include <string>

namespace touchstone::reports {

/// Draws the figures of all cases of a site as PNG into a folder, which is made anew, and gives a line
/// <CTestMeasurementFile> for each, by which ctest attaches it to its test. Throws as `run_gnuplot` and `save` do.
std::string attach_figures(const std::filesystem::path& site, const std::filesystem::path& folder);

}  // namespace touchstone::reports
