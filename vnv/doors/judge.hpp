#pragma once
/// The output of any code, judged by a flow.

#include "vnv/doors/fields.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/record/record.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {
struct Baselines;
}

namespace touchstone::vnv::doors {

/// One resolution of a code: what its files hold at their times, how it ended and what it took.
struct GivenLevel {
  double spacing;                    // m
  std::map<double, Samples> at{};    // s
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
};

/// Reads a file into the level of its spacing [m], which is counted from the number of rows at its first time where
/// none is said: rows that are lost later make no other level. Throws Unreadable, and std::invalid_argument where
/// spacing and time were there before.
void read_into(Given& given, const Flow& flow, const Mapping& mapping, const std::filesystem::path& file,
               std::optional<double> spacing);

/// The same of what a file held at one time.
void read_into(Given& given, const Flow& flow, const Mapping& mapping, Dataset data, std::optional<double> spacing);

/// What single files hold, each of one level, as one; in the order of their times.
Given together(std::vector<Given> each);

/// What is judged, and what is claimed of it besides the claims of its flow.
struct Judged {
  std::string name = "files";  // of the code, as a method
  std::string description = "Files of another code.";
  Suite suite = Suite::report;
  std::optional<double> at_most{};         // %  of each error at the finest resolution
  std::optional<double> order_at_least{};  // of each norm of which the flow claims an order
  bool diagnose = false;                   // what does not fail, too
  const Baselines* baselines = nullptr;
  std::vector<double> times{};  // s  asked for; empty: those of the flow
};

/// Which files were read, what as what, what could not be judged and why, and the record.
struct Judgement {
  std::vector<std::string> files{}, words{}, not_judged{};
  Record record{};
};

/// The quantity of the verdict that fails where nothing was claimed of a flow but that runs end.
inline constexpr std::string_view anything_claimed = "anything claimed";
/// That of the verdict that fails where a user's limit applies to nothing.
inline constexpr std::string_view anything_limited = "errors that the limit applies to";

/// Whether a claim speaks of a value, or of the order of it: else it is only printed.
bool is_limited(const Value& value, const Record& record);

/// Judges levels of equal spacing as times of one resolution, and several of them as a ladder. A sample within 1 % of a
/// time that was asked for is judged at its own time and counts as of that.
Judgement judge_given(const Flow& flow, Given given, const Judged& what);

/// The same of files, whose ends are those of their times and not claimed.
Judgement judge_files(const Flow& flow, const std::vector<std::filesystem::path>& files, const Mapping& mapping = {},
                      std::optional<double> spacing = std::nullopt, const Judged& what = {});

}  // namespace touchstone::vnv::doors
