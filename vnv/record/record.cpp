#include "vnv/record/record.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/record/former.hpp"
#include "vnv/record/json.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace touchstone::vnv {

TOUCHSTONE_FIELDS(Cost, particles, boundary_particles, steps, repeats, cpu, cpu_lowest, cpu_highest, wall, stepping,
                  harness, peak_memory)
TOUCHSTONE_FIELDS(RunSummary, level, spacing, time_step, end_time, finished, outcome, cost)
TOUCHSTONE_FIELDS(Quantity, name, unit, kind, better)
TOUCHSTONE_FIELDS(Value, level, spacing, time, quantity, value)
TOUCHSTONE_FIELDS(ObservedOrder, ladder, quantity, time, order, half_width, trend, asymptotic, floor, floor_half_width,
                  order_to_floor, order_to_floor_half_width, levels, spacings, errors, pairwise)
TOUCHSTONE_FIELDS(Verdict, case_name, method, level, spacing, time, quantity, unit, kind, better, value, lower, upper,
                  author, outcome, margin, sentence)
TOUCHSTONE_FIELDS(Axis, label, scale, logarithmic, low, high)
TOUCHSTONE_FIELDS(Figure, id, title, caption, x, y, colour, equal_axes)
TOUCHSTONE_FIELDS(Curve, figure, label, role, x, y, points)
TOUCHSTONE_FIELDS(Cloud, figure, column, row, x, y, colour)
TOUCHSTONE_FIELDS(Table, id, title, caption, columns, rows)
TOUCHSTONE_FIELDS(WorkDiagram, id, title, caption, quantity, targets, ranked_by)
TOUCHSTONE_FIELDS(WorkPoint, diagram, series, family, run, elsewhere, particles, per_step, error, cpu, cpu_lowest,
                  cpu_highest)
TOUCHSTONE_FIELDS(HistoryFile, level, file)
TOUCHSTONE_FIELDS(Record, schema, case_name, title, description, method, method_description, suite, revision, compiler,
                  flags, machine, finished_at, runs, values, orders, verdicts, figures, curves, clouds, tables,
                  diagrams, work, histories)

namespace {

void require_equal(std::size_t found, std::size_t expected, const std::string& what) {
  if (found != expected) throw json::Misfit{what, fmt::format("has {} entries, expected {}", found, expected)};
}

void check_lengths(const Record& record) {
  for (const auto& c : record.curves) require_equal(c.y.size(), c.x.size(), fmt::format("y of curve '{}'", c.label));
  for (const auto& c : record.clouds) {
    require_equal(c.y.size(), c.x.size(), fmt::format("y of cloud '{}, {}'", c.column, c.row));
    require_equal(c.colour.size(), c.x.size(), fmt::format("colour of cloud '{}, {}'", c.column, c.row));
  }
  for (const auto& t : record.tables)
    for (const auto& row : t.rows)
      require_equal(row.size(), t.columns.size(), fmt::format("a row of table '{}'", t.id));
}

/// Schema 3 had the headings of quantities only, and values were called errors.
void bring_up_from_3(json::Json& json) {
  const auto declared = [](const json::Json& heading) {
    return json::Writer::json(with_heading(current_name(heading.get<std::string>())));
  };
  rename_former_keys(json);
  json["schema"] = 4;
  json["values"] = std::move(json.at("errors"));
  for (auto& value : json.at("values")) value["quantity"] = declared(value.at("quantity"));
  for (auto& diagram : json.at("diagrams")) diagram["quantity"] = declared(diagram.at("quantity"));
  for (auto& order : json.at("orders")) order["quantity"] = current_name(order.at("quantity"));
  for (auto& verdict : json.at("verdicts")) {
    verdict["quantity"] = current_name(verdict.at("quantity"));
    verdict["kind"] = json::Writer::json(Kind::value);
    verdict["better"] = json::Writer::json(Better::undeclared);
  }
}

Record record_from(json::Json json) {
  int schema = 0;
  const json::Reader header(json);
  header("schema", schema);
  if (schema == 3)
    bring_up_from_3(json);
  else if (schema != Record{}.schema)
    throw json::Misfit{"schema", fmt::format("is {}, expected {} or 3, those known here", schema, Record{}.schema)};
  if (!json.contains("histories")) json["histories"] = json::Json::array();  // written before there were any
  Record record;
  const json::Reader reader(json);
  describe(reader, record);
  check_lengths(record);
  return record;
}

}  // namespace

std::string_view name_of(Trend trend) { return words(trend).at(static_cast<std::size_t>(trend)); }

void write(const Record& record, const std::filesystem::path& file) {
  for (const HistoryFile& history : record.histories) {
    if (history.text.empty()) continue;
    const std::filesystem::path place = file.parent_path() / history.file;
    std::error_code refused;  // what may not be made cannot be written either, and that is said
    std::filesystem::create_directory(place.parent_path(), refused);
    files::write_whole(place, history.text);
  }
  files::write_whole(file, json::with_clear_errors(file.string(), "cannot be written",
                                                   [&] { return json::Writer::json(record).dump() + "\n"; }));
}

Record read_record(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return json::with_clear_errors(file.string(), "not a whole record",
                                 [&] { return record_from(json::Json::parse(stream)); });
}

}  // namespace touchstone::vnv
