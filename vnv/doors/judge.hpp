#pragma once
/// The output of any code, judged by a flow.

#include "vnv/doors/fields.hpp"
#include "vnv/doors/flow.hpp"
#include "vnv/record/record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::doors {

struct JudgeRequest {
  std::string name = "files";                  // of the code, as a method
  std::vector<std::filesystem::path> files{};  // of one resolution or of several
  Mapping mapping{};
  std::optional<double> spacing{};  // m  of the particles; else the root of the filled area over their number
  std::optional<double> at_most{};  // %  a limit of the user's for each norm
};

/// What was read as what, what could not be judged and why, and the record.
struct Judgement {
  std::vector<std::string> words{}, not_judged{};
  Record record{};
};

/// Files of equal spacing are times of one level; levels of different spacings are a ladder. Throws Unreadable, and
/// std::invalid_argument where two files have the same spacing and time.
Judgement judge_files(const Flow& flow, const JudgeRequest& request);

}  // namespace touchstone::vnv::doors
