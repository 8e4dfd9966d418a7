#include "vnv/record/record.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/record/former.hpp"
#include "vnv/record/json.hpp"
#include "vnv/record/same_time.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace touchstone::vnv {

TOUCHSTONE_FIELDS(Cost, particles, boundary_particles, steps, repeats, cpu, cpu_lowest, cpu_highest, wall, stepping,
                  harness, peak_memory, resource, occupied)
TOUCHSTONE_FIELDS(RunSummary, level, spacing, time_step, end_time, finished, outcome, cost)
TOUCHSTONE_FIELDS(Quantity, name, unit, kind, better)
TOUCHSTONE_FIELDS(Value, level, spacing, time, quantity, value)
TOUCHSTONE_FIELDS(ObservedOrder, ladder, quantity, time, order, half_width, trend, asymptotic, floor, floor_half_width,
                  order_to_floor, order_to_floor_half_width, levels, spacings, errors, pairwise)
TOUCHSTONE_FIELDS(Verdict, case_name, method, level, spacing, time, quantity, unit, kind, better, value, lower, upper,
                  surely_above, half_width, trend, author, outcome, margin, sentence)
TOUCHSTONE_FIELDS(FittedCause, cause, unit, value, half_width)
TOUCHSTONE_FIELDS(Explanation, causes, share, named, sentence)
TOUCHSTONE_FIELDS(Diagnosis, level, field, quantities, error, explanations, sentence)
TOUCHSTONE_FIELDS(Axis, label, scale, logarithmic, low, high)
TOUCHSTONE_FIELDS(Figure, id, title, caption, x, y, colour, equal_axes, isolines)
TOUCHSTONE_FIELDS(Curve, figure, label, role, x, y, points)
TOUCHSTONE_FIELDS(Cloud, figure, column, row, x, y, colour)
TOUCHSTONE_FIELDS(Table, id, title, caption, columns, rows)
TOUCHSTONE_FIELDS(WorkDiagram, id, title, caption, quantity, targets, ranked_by)
TOUCHSTONE_FIELDS(WorkPoint, diagram, series, family, run, elsewhere, particles, per_step, error, cpu, cpu_lowest,
                  cpu_highest)
TOUCHSTONE_FIELDS(HistoryFile, level, file)
TOUCHSTONE_FIELDS(Record, schema, case_name, title, description, method, method_description, another_code, as_printed,
                  suite, revision, compiler, flags, machine, finished_at, host, runs, values, orders, verdicts,
                  diagnoses, figures, curves, clouds, tables, diagrams, work, histories)

namespace {

void require_equal(std::size_t found, std::size_t expected, const std::string& what) {
  if (found != expected) throw json::Misfit{what, fmt::format("has {} entries, expected {}", found, expected)};
}

/// They become names of files, of which none leads out of the folder that it is meant for.
void check_names(const Record& record) {
  for (const auto& [what, name] : {std::pair("case_name", record.case_name), std::pair("method", record.method)})
    if (name.starts_with('.') || name.find('/') != name.npos)
      throw json::Misfit{what, fmt::format("is '{}', expected a name that begins with no '.' and has no '/'", name)};
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

/// Schema 1 had one run of each, and no diagrams of error against run time.
void bring_up_from_1(json::Json& json) {
  for (auto& run : json.at("runs")) {
    json::Json& cost = run.at("cost");
    cost["repeats"] = 1;
    cost["cpu_lowest"] = cost["cpu_highest"] = cost.at("cpu");
    cost["stepping"] = cost["harness"] = 0;
  }
  for (const char* list : {"diagrams", "work"}) json[list] = json::Json::array();
}

/// Schema 2 had orders without a trend and a floor.
void bring_up_from_2(json::Json& json) {
  for (auto& order : json.at("orders")) {
    order["trend"] = json::Writer::json(Trend::inconclusive);
    order["asymptotic"] = false;
    for (const char* number : {"floor", "floor_half_width", "order_to_floor", "order_to_floor_half_width"})
      order[number] = "nan";
  }
}

/// Schema 3 had the headings of quantities only, and values were called errors.
void bring_up_from_3(json::Json& json) {
  const auto declared = [](const json::Json& heading) {
    return json::Writer::json(with_heading(current_name(heading.get<std::string>())));
  };
  rename_former_keys(json);
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

/// Schema 4 had no intervals in verdicts on orders: they are such as make the recorded outcome. And a limit of zero
/// stood where there is none.
void bring_up_from_4(json::Json& json) {
  if (!json.contains("histories")) json["histories"] = json::Json::array();  // written before there were any
  for (auto& verdict : json.at("verdicts")) {
    const bool is_order = verdict.at("quantity").get<std::string>().starts_with("order of ");
    const bool fails = verdict.at("outcome") == "fails", holds = verdict.at("outcome") == "holds";
    verdict["surely_above"] = is_order && fails ? json::Json(0) : json::Json();
    verdict["half_width"] = !is_order ? json::Json() : fails || holds ? json::Json(0) : json::Json("inf");
    verdict["trend"] = json::Writer::json(fails ? Trend::stalled : Trend::converging);
    if (verdict.at("quantity") == never_accepted) verdict["upper"] = nullptr;
  }
  json["schema"] = Record{}.schema;
}

/// What was added to this schema since its first record.
void add_what_is_new(json::Json& json) {
  const auto add = [](json::Json& object, const char* name, const json::Json& value) {
    if (object.is_object() && !object.contains(name)) object[name] = value;
  };
  add(json, "another_code", false);
  add(json, "host", "");
  add(json, "as_printed", false);
  add(json, "diagnoses", json::Json::array());
  if (json.contains("figures"))
    for (auto& figure : json["figures"]) add(figure, "isolines", 0);
  for (auto& diagnosis : json["diagnoses"]) add(diagnosis, "quantities", json::Json::array());
  if (!json.contains("runs") || !json["runs"].is_array()) return;  // which is refused later
  for (auto& run : json["runs"])
    if (run.is_object() && run.contains("cost")) {
      add(run["cost"], "resource", json::Writer::json(Resource::cpu));
      add(run["cost"], "occupied", 0.0);
    }
}

}  // namespace

std::string one_machine(const Record& record) {
  return record.host.empty() ? record.machine : record.host + ", " + record.machine;
}

std::string contradiction(const Verdict& v, const Record& record) {
  const Outcome judged = outcome_of(v);
  const bool was_cautious =
      v.outcome == Outcome::inconclusive && judged == Outcome::holds;  // by a former rule: no pass
  if (judged != v.outcome && !was_cautious)
    return fmt::format("says '{}', expected '{}' by value and limits", word_of(v.outcome), word_of(judged));
  if (!v.level.empty() && !record.runs.empty() &&
      std::ranges::find(record.runs, v.level, &RunSummary::level) == record.runs.end())
    return "no such level was run";
  for (const Value& measured : record.values)
    if (measured.level == v.level && measured.quantity.name == v.quantity && same_time(measured.time, v.time) &&
        measured.value != v.value && !(std::isnan(measured.value) && std::isnan(v.value)))
      return fmt::format("expected {:.6g}, the value that was measured", measured.value);
  return "";
}

const Diagnosis* diagnosis_of(const Verdict& verdict, const Record& record) {
  const std::string& level = verdict.level.empty() && !record.runs.empty() ? record.runs.back().level : verdict.level;
  for (const Diagnosis& one : record.diagnoses)
    if (one.level == level && std::ranges::find(one.quantities, verdict.quantity) != one.quantities.end()) return &one;
  return nullptr;
}

namespace {

/// A record is not believed: each verdict is judged again by its numbers, and one that the record contradicts fails.
void judge_again(Record& record) {
  for (Verdict& v : record.verdicts)
    if (const std::string what = contradiction(v, record); !what.empty()) {
      v.outcome = Outcome::fails;
      v.margin = not_a_number;
      v.sentence = fmt::format("{}.{}{}: inconsistent record: {} = {:.6g}: {}: FAILS", v.case_name, v.method,
                               v.level.empty() ? "" : " " + v.level, v.quantity, v.value, what);
    }
}

Record record_from(json::Json json) {
  int schema = 0;
  const json::Reader header(json);
  header("schema", schema);
  if (schema < 1 || schema > Record{}.schema)
    throw json::Misfit{"schema", fmt::format("is {}, expected 1 to {}, those known here{}", schema, Record{}.schema,
                                             schema > 0 ? ": a newer Touchstone wrote it" : "")};
  constexpr auto bring_up =
      std::to_array<void (*)(json::Json&)>({bring_up_from_1, bring_up_from_2, bring_up_from_3, bring_up_from_4});
  for (auto from = static_cast<std::size_t>(schema); from <= bring_up.size(); ++from) bring_up[from - 1](json);
  add_what_is_new(json);
  Record record;
  const json::Reader reader(json);
  describe(reader, record);
  check_names(record);
  check_lengths(record);
  judge_again(record);
  return record;
}

}  // namespace

std::string as_json(const Record& record) { return json::Writer::json(record).dump(); }

void write(const Record& record, const std::filesystem::path& file) {
  for (const HistoryFile& history : record.histories) {
    if (history.text.empty()) continue;
    const std::filesystem::path place = file.parent_path() / history.file;
    std::error_code refused;  // what may not be made cannot be written either, and that is said
    std::filesystem::create_directory(place.parent_path(), refused);
    files::write_whole(place, history.text);
  }
  files::write_whole(
      file, json::with_clear_errors(file.string(), "cannot be written", [&] { return as_json(record) + "\n"; }));
}

Record read_record(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return record_in({std::istreambuf_iterator<char>(stream), {}}, file.string());
}

Record record_in(const std::string& text, const std::string& source) {
  return json::with_clear_errors(source, "not a complete record", [&] { return record_from(json::parsed(text)); });
}

}  // namespace touchstone::vnv
