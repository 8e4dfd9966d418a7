#pragma once
/// A format that is read: NAME.cpp beside this file, which defines formats::NAME. Adding it and a sample is all; what
/// formats are made of is in parts/.

#include "vnv/doors/read/dataset.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchstone::vnv::doors {

/// All datasets of a file, in the order of their times. `bytes` are what it holds and nobody else reads them: those
/// that have been read may be given up. Throws Unreadable.
using Reader = std::vector<Dataset> (*)(const std::filesystem::path& file, std::string_view bytes, const Limits&);

/// What one format is called, by what it is told from others, and its reader.
struct Format {
  std::string_view words;   // where it is expected: "a dump of LAMMPS"
  std::string_view help{};  // where it is offered, if not so: "LAMMPS dumps"; said once where several say it
  int place = 100;          // in lists, lowest first; text is last
  std::vector<std::string_view> endings;  // of the names of its samples
  std::string_view begins{};              // its first bytes
  /// Where those do not tell it: of no more than its first 2000 bytes. It is asked before any first bytes are compared,
  /// the last in lists first, since a series of files looks like one of them.
  bool (*is_it)(const std::filesystem::path& file, std::string_view head) = nullptr;
  Reader read;
  bool may_crash = false;  // by a library that a file may bring down, so that it reads in a process of its own
};

/// A format by the name of its source.
using NamedFormat = std::pair<std::string, Format (*)()>;
const std::vector<NamedFormat>& all_formats();  // the build writes this list

/// The format that a file is told to be; text where no other is.
const Format& format_of(const std::filesystem::path& file, std::string_view bytes);

/// What the reader of a format gives. Throws Unreadable.
std::vector<Dataset> read_as(const Format& format, const std::filesystem::path& file, std::string_view bytes,
                             const Limits& limits);

/// "VTP, VTU, NPY or a dump of LAMMPS"; "VTP, VTU, NPY, LAMMPS dumps, and text tables".
std::string formats_besides_text();
std::string formats_in_help();

}  // namespace touchstone::vnv::doors
