#pragma once
/// The output of any code, judged by a flow.

#include "vnv/doors/given.hpp"
#include "vnv/record/record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {
struct Baselines;
}

namespace touchstone::vnv::doors {

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
