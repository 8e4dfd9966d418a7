#pragma once
/// What files of another code hold, as resolutions of a flow.

#include "vnv/doors/fields.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/record/run_summary.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::doors {

/// One resolution of a code: what its files hold at their times, how it ended and what it took.
struct GivenLevel {
  double spacing;                    // m
  std::map<double, Samples> at{};    // s
  std::map<double, Slab> slabs{};    // of three-dimensional rows at these times, or those that move across the plane
  std::string outcome = "finished";  // or why there is no answer
  bool spacing_is_said = false;      // by the user, not counted from the rows at the first time
  bool has_volumes = true;           // or masses and densities, at all times
  bool has_particles = true;         // not cells of a mesh
  Cost cost{.cpu = not_a_number,
            .cpu_lowest = not_a_number,
            .cpu_highest = not_a_number,
            .wall = not_a_number,
            .peak_memory = not_a_number};
};

/// "40 across": the name of the level of a resolution by its spacing [m].
std::string level_name(const Flow& flow, double spacing);

/// What files of a code hold, by resolutions, and what was read as what.
struct Given {
  std::vector<GivenLevel> levels{};
  std::optional<std::vector<std::string>> fields{};  // that all files have
  std::vector<std::string> files{};                  // in words
  std::vector<std::string> words{};                  // what was read as what

  /// Says a thing once.
  void say(const std::string& line);
  /// Those fields that the files before and this one have.
  void keep_fields(const std::vector<std::string>& those);
};

/// Reads a file into the one level of what is given, of the spacing [m] that is said or is counted from the number of
/// rows at the first time: rows that are lost later make no other level. Throws Unreadable, and std::invalid_argument
/// where the time was there before.
void read_into(Given& given, const Flow& flow, const Mapping& mapping, const std::filesystem::path& file,
               std::optional<double> spacing);

/// The same of what a file held at one time.
void read_into(Given& given, const Flow& flow, const Mapping& mapping, Dataset data, std::optional<double> spacing);

/// What single files hold, each of one level, as one; in the order of their times.
Given together(std::vector<Given> each);

/// What all files hold.
Given read_files(const Flow& flow, const std::vector<std::filesystem::path>& files, const Mapping& mapping,
                 std::optional<double> spacing);

}  // namespace touchstone::vnv::doors
