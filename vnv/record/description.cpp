#include "vnv/record/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

template <>
struct nlohmann::adl_serializer<std::optional<double>> {
  static void to_json(json& j, const std::optional<double>& value) { j = value ? json(*value) : json(nullptr); }
  static void from_json(const json& j, std::optional<double>& value) {
    value = j.is_null() ? std::nullopt : std::optional(j.get<double>());
  }
};

namespace touchstone::vnv {

// Each type once, for the writer and for the reader, so that the two cannot disagree.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LevelDescription, name, spacing, cell, smoothing_length, time_step, until)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LadderDescription, name, levels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClaimDescription, quantity, lower, upper, author, level, time, ladder, surely_above,
                                   least_levels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ToleranceDescription, relative, absolute, basis)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MethodDescription, name, description, levels, ladders, claims, tolerance,
                                   relative_cost, baselines)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AcceptanceDescription, revision, date, reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Description, schema, name, title, description, suites, times, timed, label, claims,
                                   methods, data_folder, tables, baseline_file, acceptance)

bool MethodDescription::is_run_in(std::string_view suite) const {
  return std::ranges::any_of(levels,
                             [&](const LevelDescription& level) { return level.until.contains(std::string(suite)); });
}

std::string json_of(const Description& description) { return nlohmann::json(description).dump(2) + "\n"; }

Description description_in(const std::string& text, const std::string& source) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    const int schema = json.at("schema"), known = Description{}.schema;
    if (schema != known)
      throw std::runtime_error(fmt::format("{}: schema is {}, expected {}, the only one known here: build both anew",
                                           source, schema, known));
    return json.get<Description>();
  } catch (const nlohmann::json::exception& error) {
    const std::string message = error.what();  // opens with "[json.exception.parse_error.101] "
    throw std::runtime_error(
        fmt::format("{}: not a whole description: {}", source, message.substr(message.find("] ") + 2)));
  }
}

}  // namespace touchstone::vnv
