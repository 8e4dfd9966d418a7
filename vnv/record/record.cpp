#include "vnv/record/record.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <concepts>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

using Json = nlohmann::ordered_json;

template <class T, class Plain>
concept A = std::same_as<std::remove_const_t<T>, Plain>;

// Each type is described once, for the writer and for the reader, so that the two cannot disagree.

void describe(auto& field, A<Cost> auto& c) {
  field("particles", c.particles);
  field("boundary_particles", c.boundary_particles);
  field("steps", c.steps);
  field("repeats", c.repeats);
  field("cpu", c.cpu);
  field("cpu_lowest", c.cpu_lowest);
  field("cpu_highest", c.cpu_highest);
  field("wall", c.wall);
  field("stepping", c.stepping);
  field("harness", c.harness);
  field("peak_memory", c.peak_memory);
}

void describe(auto& field, A<RunSummary> auto& r) {
  field("level", r.level);
  field("spacing", r.spacing);
  field("time_step", r.time_step);
  field("end_time", r.end_time);
  field("finished", r.finished);
  field("outcome", r.outcome);
  field("cost", r.cost);
}

void describe(auto& field, A<Error> auto& e) {
  field("level", e.level);
  field("spacing", e.spacing);
  field("time", e.time);
  field("quantity", e.quantity);
  field("value", e.value);
}

void describe(auto& field, A<ObservedOrder> auto& o) {
  field("ladder", o.ladder);
  field("quantity", o.quantity);
  field("time", o.time);
  field("order", o.order);
  field("half_width", o.half_width);
  field("trend", o.trend);
  field("asymptotic", o.asymptotic);
  field("floor", o.floor);
  field("floor_half_width", o.floor_half_width);
  field("order_to_floor", o.order_to_floor);
  field("order_to_floor_half_width", o.order_to_floor_half_width);
  field("levels", o.levels);
  field("spacings", o.spacings);
  field("errors", o.errors);
  field("pairwise", o.pairwise);
}

void describe(auto& field, A<Verdict> auto& v) {
  field("case_name", v.case_name);
  field("method", v.method);
  field("level", v.level);
  field("spacing", v.spacing);
  field("time", v.time);
  field("quantity", v.quantity);
  field("unit", v.unit);
  field("value", v.value);
  field("lower", v.lower);
  field("upper", v.upper);
  field("author", v.author);
  field("outcome", v.outcome);
  field("margin", v.margin);
  field("sentence", v.sentence);
}

void describe(auto& field, A<Axis> auto& a) {
  field("label", a.label);
  field("scale", a.scale);
  field("logarithmic", a.logarithmic);
  field("low", a.low);
  field("high", a.high);
}

void describe(auto& field, A<Figure> auto& f) {
  field("id", f.id);
  field("title", f.title);
  field("caption", f.caption);
  field("x", f.x);
  field("y", f.y);
  field("colour", f.colour);
  field("equal_axes", f.equal_axes);
}

void describe(auto& field, A<Curve> auto& c) {
  field("figure", c.figure);
  field("label", c.label);
  field("role", c.role);
  field("x", c.x);
  field("y", c.y);
  field("points", c.points);
}

void describe(auto& field, A<Cloud> auto& c) {
  field("figure", c.figure);
  field("column", c.column);
  field("row", c.row);
  field("x", c.x);
  field("y", c.y);
  field("colour", c.colour);
}

void describe(auto& field, A<Table> auto& t) {
  field("id", t.id);
  field("title", t.title);
  field("caption", t.caption);
  field("columns", t.columns);
  field("rows", t.rows);
}

void describe(auto& field, A<WorkDiagram> auto& d) {
  field("id", d.id);
  field("title", d.title);
  field("caption", d.caption);
  field("quantity", d.quantity);
  field("targets", d.targets);
  field("ranked_by", d.ranked_by);
}

void describe(auto& field, A<WorkPoint> auto& p) {
  field("diagram", p.diagram);
  field("series", p.series);
  field("family", p.family);
  field("run", p.run);
  field("elsewhere", p.elsewhere);
  field("particles", p.particles);
  field("per_step", p.per_step);
  field("error", p.error);
  field("cpu", p.cpu);
  field("cpu_lowest", p.cpu_lowest);
  field("cpu_highest", p.cpu_highest);
}

void describe(auto& field, A<Record> auto& r) {
  field("schema", r.schema);
  field("case_name", r.case_name);
  field("title", r.title);
  field("description", r.description);
  field("method", r.method);
  field("method_description", r.method_description);
  field("suite", r.suite);
  field("revision", r.revision);
  field("compiler", r.compiler);
  field("flags", r.flags);
  field("machine", r.machine);
  field("finished_at", r.finished_at);
  field("runs", r.runs);
  field("errors", r.errors);
  field("orders", r.orders);
  field("verdicts", r.verdicts);
  field("figures", r.figures);
  field("curves", r.curves);
  field("clouds", r.clouds);
  field("tables", r.tables);
  field("diagrams", r.diagrams);
  field("work", r.work);
}

// The words of an enumeration, in the order of its enumerators.
constexpr auto words(Outcome) { return std::to_array<std::string_view>({"holds", "fails", "inconclusive"}); }
constexpr auto words(Trend) {
  return std::to_array<std::string_view>({"converging", "stalled", "diverging", "inconclusive"});
}
constexpr auto words(Role) {
  return std::to_array<std::string_view>({"ours", "exact", "experiment", "published", "guide", "best"});
}

template <class T>
concept Enumeration = std::is_enum_v<T>;
template <class T>
concept Struct = std::is_class_v<T>;

class Writer {
 public:
  void operator()(const char* name, const auto& value) { object_[name] = json(value); }

  static Json json(const std::string& text) { return text; }
  static Json json(bool value) { return value; }
  static Json json(std::integral auto value) { return value; }
  static Json json(double value) {
    if (std::isfinite(value)) return value;
    if (std::isnan(value)) return "nan";
    return value > 0 ? "inf" : "-inf";
  }
  static Json json(const std::optional<double>& value) { return value ? json(*value) : Json(nullptr); }
  static Json json(const Cell& cell) {
    return std::visit([](const auto& value) { return json(value); }, cell);
  }
  static Json json(Enumeration auto value) { return words(value).at(static_cast<std::size_t>(value)); }
  template <class T>
  static Json json(const std::vector<T>& list) {
    Json array = Json::array();
    for (const auto& item : list) array.push_back(json(item));
    return array;
  }
  static Json json(const Struct auto& value) {
    Writer writer;
    describe(writer, value);
    return writer.object_;
  }

 private:
  Json object_ = Json::object();
};

// What does not fit, and where in the record: "runs[2].cost.cpu".
struct Misfit {
  std::string where, what;
};

void want(bool fits, const Json& found, std::string_view expected) {
  if (!fits) throw Misfit{"", fmt::format("is {}, expected {}", found.dump().substr(0, 60), expected)};
}

std::string listed(const auto& known) {
  std::string list;
  for (const auto word : known) list += (list.empty() ? " " : ", ") + std::string(word);
  return list;
}

class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) { want(object.is_object(), object, "an object"); }

  void operator()(const char* name, auto& value) const {
    if (!object_.contains(name)) throw Misfit{name, "is not there"};
    try {
      read(object_[name], value);
    } catch (const Misfit& misfit) {
      const bool joined = misfit.where.empty() || misfit.where.front() == '[';
      throw Misfit{std::string(name) + (joined ? "" : ".") + misfit.where, misfit.what};
    }
  }

  static void read(const Json& json, std::string& text) {
    want(json.is_string(), json, "a text");
    text = json;
  }
  static void read(const Json& json, bool& value) {
    want(json.is_boolean(), json, "true or false");
    value = json;
  }
  static void read(const Json& json, std::integral auto& value) {
    want(json.is_number_integer(), json, "a whole number");
    value = json;
  }
  static void read(const Json& json, double& value) {
    want(json.is_number() || is_not_finite(json), json, "a number");
    value = json.is_number() ? json.get<double>() : not_finite(json);
  }
  static void read(const Json& json, std::optional<double>& value) {
    if (json.is_null()) return value.reset();
    read(json, value.emplace());
  }
  // A cell with the text "nan" comes back as the number, and looks the same.
  static void read(const Json& json, Cell& cell) {
    if (json.is_string() && !is_not_finite(json)) return read(json, cell.emplace<std::string>());
    read(json, cell.emplace<double>());
  }
  static void read(const Json& json, Enumeration auto& value) {
    std::string word;
    read(json, word);
    const auto known = words(value);
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) want(false, json, "one of" + listed(known));
    value = static_cast<std::remove_cvref_t<decltype(value)>>(found - known.begin());
  }
  template <class T>
  static void read(const Json& json, std::vector<T>& list) {
    want(json.is_array(), json, "a list");
    list.resize(json.size());
    for (std::size_t i = 0; i < list.size(); ++i) read_item(json[i], i, list[i]);
  }
  static void read(const Json& json, Struct auto& value) {
    const Reader reader(json);
    describe(reader, value);
  }

 private:
  static void read_item(const Json& json, std::size_t i, auto& item) {
    try {
      read(json, item);
    } catch (const Misfit& misfit) {
      const bool joined = misfit.where.empty() || misfit.where.front() == '[';
      throw Misfit{fmt::format("[{}]{}{}", i, joined ? "" : ".", misfit.where), misfit.what};
    }
  }
  static bool is_not_finite(const Json& json) { return json == "nan" || json == "inf" || json == "-inf"; }
  static double not_finite(const Json& json) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return json == "nan" ? not_a_number : json == "inf" ? infinity : -infinity;
  }

  const Json& object_;
};

void want_equal(std::size_t found, std::size_t expected, const std::string& what) {
  if (found != expected) throw Misfit{what, fmt::format("has {} entries, expected {}", found, expected)};
}

void check_lengths(const Record& record) {
  for (const auto& c : record.curves) want_equal(c.y.size(), c.x.size(), fmt::format("y of curve '{}'", c.label));
  for (const auto& c : record.clouds) {
    want_equal(c.y.size(), c.x.size(), fmt::format("y of cloud '{}, {}'", c.column, c.row));
    want_equal(c.colour.size(), c.x.size(), fmt::format("colour of cloud '{}, {}'", c.column, c.row));
  }
  for (const auto& t : record.tables)
    for (const auto& row : t.rows) want_equal(row.size(), t.columns.size(), fmt::format("a row of table '{}'", t.id));
}

Record record_from(const Json& json) {
  int schema = 0;
  const Reader reader(json);
  reader("schema", schema);
  if (schema != Record{}.schema)
    throw Misfit{"schema", fmt::format("is {}, expected {}, the only one known here", schema, Record{}.schema)};
  Record record;
  describe(reader, record);
  check_lengths(record);
  return record;
}

// nlohmann's messages open with "[json.exception.parse_error.101] ".
std::string without_tag(const std::string& message) { return message.substr(message.find("] ") + 2); }

std::string text_of(const Record& record, const std::filesystem::path& file) {
  try {
    return Writer::json(record).dump() + "\n";
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), without_tag(error.what())));
  }
}

[[noreturn]] void refuse_to_write(const std::filesystem::path& file, const std::string& cause) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), cause));
}

}  // namespace

std::string_view name_of(Trend trend) { return words(trend).at(static_cast<std::size_t>(trend)); }

void write(const Record& record, const std::filesystem::path& file) {
  const std::string text = text_of(record, file);
  const auto part = file.parent_path() / fmt::format(".{}.{}.part", file.filename().string(), getpid());
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code cause;
  if (stream) std::filesystem::rename(part, file, cause);
  if (stream && !cause) return;
  const std::string message = cause ? cause.message() : std::strerror(errno);
  std::filesystem::remove(part, cause);
  refuse_to_write(file, message);
}

Record read_record(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  try {
    return record_from(Json::parse(stream));
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not a whole record: {}", file.string(), without_tag(error.what())));
  } catch (const Misfit& misfit) {
    throw std::runtime_error(fmt::format("{}: {} {}", file.string(), misfit.where, misfit.what));
  }
}

}  // namespace touchstone::vnv
