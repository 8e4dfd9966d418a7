#include "vnv/record/description.hpp"

#include "vnv/record/json.hpp"

namespace touchstone::vnv {

// Each type once, for the writer and for the reader, so that the two cannot disagree.
TOUCHSTONE_FIELDS(LevelDescription, name, spacing, cell, smoothing_length, time_step, until)
TOUCHSTONE_FIELDS(LadderDescription, name, levels)
TOUCHSTONE_FIELDS(ClaimDescription, quantity, lower, upper, author, level, time, ladder, surely_above, least_levels)
TOUCHSTONE_FIELDS(ToleranceDescription, relative, absolute, basis)
TOUCHSTONE_FIELDS(MethodDescription, name, description, levels, ladders, claims, tolerance, relative_cost, baselines)
TOUCHSTONE_FIELDS(AcceptanceDescription, revision, date, reason)
TOUCHSTONE_FIELDS(Description, schema, name, title, description, suites, times, timed, label, priced_as, claims,
                  methods, data_folder, tables, baseline_file, acceptance)

bool MethodDescription::is_run_in(std::string_view suite) const {
  return std::ranges::any_of(levels,
                             [&](const LevelDescription& level) { return level.until.contains(std::string(suite)); });
}

std::string json_of(const Description& description) { return json::Writer::json(description).dump(2) + "\n"; }

Description description_in(const std::string& text, const std::string& source) {
  return json::with_clear_errors(source, "not a complete description", [&] {
    const json::Json found = json::parsed(text);
    int schema = 0;
    json::Reader{found}("schema", schema);
    if (schema != Description{}.schema)
      throw json::Misfit{"schema", fmt::format("is {}, expected {}, the only one known here: build both anew", schema,
                                               Description{}.schema)};
    Description description;
    json::Reader::read(found, description);
    return description;
  });
}

}  // namespace touchstone::vnv
