#pragma once
/// From a folder of records to a folder of pages.

#include "reports/cases.hpp"

#include <filesystem>
#include <vector>

namespace touchstone::reports {

/// Writes the whole site beside its place and swaps it in at the end; if anything fails, what was there stays.
/// Without gnuplot the tables are still written, and GnuplotMissing is thrown.
/// Throws std::runtime_error if records cannot be read, figures cannot be drawn or the site cannot be written.
void make_site(const std::filesystem::path& records, const std::filesystem::path& site);

}  // namespace touchstone::reports
