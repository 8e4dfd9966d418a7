#pragma once
/// From a folder of records to a folder of pages.

#include "reports/read/known_failures.hpp"

#include <filesystem>

namespace touchstone::reports {

/// What a site may know beside the records of its night.
struct SiteInputs {
  std::filesystem::path history{};         // folder of all nights, which this one joins; empty: no trend
  std::filesystem::path known_failures{};  // file; empty: none is known
  std::filesystem::path faults{};          // file of what try.py has found; empty: no page of it
  std::filesystem::path claims{};          // folder of accepted claims; empty: none are expected
  bool whole = false;                      // all of a suite was run: each accepted method has to be there
};

/// Writes the whole site beside its place and swaps it in at the end; if anything fails, what was there stays.
/// The night joins its history before any page is drawn. Says how its failures stand beside the known ones.
/// Without gnuplot the tables are still written, and GnuplotMissing is thrown.
/// Throws std::runtime_error if records, known failures or faults cannot be read, figures cannot be drawn or the site
/// cannot be written, and programs::Interrupted if this program is asked to end.
NightStatus make_site(const std::filesystem::path& records, const std::filesystem::path& site,
                      const SiteInputs& inputs = {});

}  // namespace touchstone::reports
