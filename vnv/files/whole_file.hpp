#pragma once
/// Files that are whole or not there.

#include <filesystem>
#include <string>
#include <string_view>

namespace touchstone::files {

/// Writes to a neighbouring temporary name, brings that to the disk and renames it, so that whoever reads the file,
/// even after a power cut, finds the former text or this one. What others left that were killed while they did so is
/// removed. Throws std::runtime_error naming the file and the cause.
void write_whole(const std::filesystem::path& file, std::string_view text);

/// Makes a folder and those above it where they are not there. Throws std::runtime_error naming it and the cause.
void make_folder(const std::filesystem::path& folder);

/// All bytes of a file; none where it cannot be read.
std::string read_whole(const std::filesystem::path& file);

/// Where this process makes what will take a place: ".site.123.part", of kind "part".
std::filesystem::path neighbour(const std::filesystem::path& place, std::string_view kind);

/// Removes the neighbours, of kinds "part" and "former", of processes that are no more.
void remove_what_the_killed_left(const std::filesystem::path& place);

}  // namespace touchstone::files
