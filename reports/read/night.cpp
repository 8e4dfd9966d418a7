#include "reports/read/night.hpp"

#include "reports/text/files.hpp"
#include "reports/text/numbers.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <concepts>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int schema = 1;

template <class T, class Plain>
concept A = std::same_as<std::remove_const_t<T>, Plain>;

// Each kind of line is described once, for the writer and for the reader, so that the two cannot disagree.

void describe(auto& field, A<Night> auto& n) {
  field("suite", n.suite);
  field("revision", n.revision);
  field("compiler", n.compiler);
  field("flags", n.flags);
  field("machine", n.machine);
  field("finished_at", n.finished_at);
}

void describe(auto& field, A<NightRun> auto& r) {
  field("case", r.case_name);
  field("method", r.method);
  field("level", r.level);
  field("spacing", r.spacing);
  field("time_step", r.time_step);
  field("finished", r.finished);
  field("outcome", r.outcome);
  field("cpu", r.cpu);
  field("wall", r.wall);
  field("peak_memory", r.peak_memory);
  field("particles", r.particles);
  field("steps", r.steps);
  field("particle_steps_per_second", r.particle_steps_per_second);
}

void describe(auto& field, A<NightValue> auto& e) {
  field("case", e.case_name);
  field("method", e.method);
  field("level", e.level);
  field("spacing", e.spacing);
  field("time", e.time);
  field("quantity", e.quantity);
  field("value", e.value);
}

void describe(auto& field, A<NightOrder> auto& o) {
  field("case", o.case_name);
  field("method", o.method);
  field("ladder", o.ladder);
  field("quantity", o.quantity);
  field("time", o.time);
  field("levels", o.levels);
  field("order", o.order);
  field("half_width", o.half_width);
}

void describe(auto& field, A<NightVerdict> auto& v) {
  field("case", v.case_name);
  field("method", v.method);
  field("level", v.level);
  field("spacing", v.spacing);
  field("time", v.time);
  field("quantity", v.quantity);
  field("author", v.author);
  field("value", v.value);
  field("lower", v.lower);
  field("upper", v.upper);
  field("margin", v.margin);
  field("outcome", v.outcome);
}

class Writer {
 public:
  explicit Writer(const char* kind, const auto& first) { object_[kind] = first; }
  void operator()(const char* name, const auto& value) { object_[name] = json(value); }
  std::string line() const { return object_.dump() + "\n"; }

 private:
  static Json json(const std::string& text) { return text; }
  static Json json(bool value) { return value; }
  static Json json(long value) { return value; }
  static Json json(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  }
  static Json json(const std::optional<double>& value) { return value ? json(*value) : Json(nullptr); }
  static Json json(vnv::Outcome outcome) { return word(outcome); }

  Json object_;
};

class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {}
  void operator()(const char* name, auto& value) const {
    const auto found = object_.find(name);
    if (found == object_.end()) throw std::runtime_error(fmt::format("no '{}'", name));
    if (!read(*found, value))
      throw std::runtime_error(
          fmt::format("{} is {}, expected another kind of value", name, found->dump().substr(0, 60)));
  }

 private:
  static bool read(const Json& json, std::string& text) {
    if (json.is_string()) text = json.get<std::string>();
    return json.is_string();
  }
  static bool read(const Json& json, bool& value) {
    if (json.is_boolean()) value = json.get<bool>();
    return json.is_boolean();
  }
  static bool read(const Json& json, long& value) {
    if (json.is_number_integer()) value = json.get<long>();
    return json.is_number_integer();
  }
  static bool read(const Json& json, double& value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (json.is_number()) return value = json.get<double>(), true;
    value = json == "inf" ? infinity : json == "-inf" ? -infinity : vnv::not_a_number;
    return json == "nan" || std::isinf(value);
  }
  static bool read(const Json& json, std::optional<double>& value) {
    if (json.is_null()) return value.reset(), true;
    return read(json, value.emplace());
  }
  static bool read(const Json& json, vnv::Outcome& outcome) {
    for (const auto known : {vnv::Outcome::holds, vnv::Outcome::fails, vnv::Outcome::inconclusive})
      if (json == word(known)) return outcome = known, true;
    return false;
  }

  const Json& object_;
};

// Applies `visit` to each list of a night with the kind that opens its lines.
void for_each_list(auto& night, const auto& visit) {
  visit("run", night.runs);
  visit("error", night.errors);
  visit("limit", night.limits);
  visit("order", night.orders);
  visit("verdict", night.verdicts);
}

long lines_of(const Night& night) {
  std::size_t lines = 0;
  for_each_list(night, [&](const char*, const auto& list) { lines += list.size(); });
  return static_cast<long>(lines);
}

std::string text_of(const Night& night) {
  Writer header("night", schema);
  header("lines", lines_of(night));
  describe(header, night);
  std::string text = header.line();
  for_each_list(night, [&](const char* kind, const auto& list) {
    for (const auto& item : list) {
      Writer writer("kind", kind);
      describe(writer, item);
      text += writer.line();
    }
  });
  return text;
}

long read_header(const Json& json, Night& night) {
  if (!json.is_object() || !json.contains("night"))
    throw std::runtime_error("no night, expected a line with \"night\"");
  if (json["night"] != schema)
    throw std::runtime_error(
        fmt::format("night is {}, expected {}, the only schema known here", json["night"].dump(), schema));
  long lines = 0;
  const Reader reader(json);
  reader("lines", lines);
  describe(reader, night);
  return lines;
}

void read_line(const Json& json, Night& night) {
  std::string kind;
  const Reader reader(json);
  reader("kind", kind);
  bool is_known = false;
  for_each_list(night, [&](const char* known, auto& list) {
    if (kind != known) return;
    is_known = true;
    describe(reader, list.emplace_back());
  });
  if (!is_known)
    throw std::runtime_error(fmt::format("kind is '{}', expected run, error, limit, order or verdict", kind));
}

Json parsed(const std::string& line) {
  Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) throw std::runtime_error("no whole line of JSON");
  return json;
}

bool is_stability_limit(const std::string& quantity) {
  return quantity.starts_with("critical time step") || quantity.starts_with("largest stable");
}

// A pure number has no "[-]", in errors as in verdicts.
std::string plain_quantity(const std::string& quantity) {
  const auto [name, unit] = vnv::name_and_unit(quantity);
  return with_unit(name, unit);
}

NightRun summary(const vnv::Record& record, const vnv::RunSummary& run) {
  const vnv::Cost& c = run.cost;
  return {record.case_name,
          record.method,
          run.level,
          run.spacing,
          run.time_step,
          run.finished,
          run.outcome,
          c.cpu,
          c.wall,
          c.peak_memory,
          c.particles,
          c.steps,
          c.particle_steps_per_second()};
}

// What a claim of convergence speaks of: the order above the floor, if there is one.
NightOrder summary(const vnv::Record& record, const vnv::ObservedOrder& o) {
  const bool above_floor = !std::isnan(o.floor);
  return {record.case_name,
          record.method,
          o.ladder,
          plain_quantity(o.quantity),
          o.time,
          static_cast<long>(o.errors.size()),
          above_floor ? o.order_to_floor : o.order,
          above_floor ? o.order_to_floor_half_width : o.half_width};
}

NightVerdict summary(const vnv::Verdict& v) {
  return {v.case_name, v.method, v.level, v.spacing, v.time,   with_unit(v.quantity, v.unit),
          v.author,    v.value,  v.lower, v.upper,   v.margin, v.outcome};
}

void add(const vnv::Record& record, Night& night) {
  for (const auto& run : record.runs) night.runs.push_back(summary(record, run));
  for (const auto& e : record.errors)
    (is_stability_limit(e.quantity) ? night.limits : night.errors)
        .push_back({record.case_name, record.method, e.level, e.spacing, e.time, plain_quantity(e.quantity), e.value});
  for (const auto& order : record.orders) night.orders.push_back(summary(record, order));
  for (const auto& verdict : record.verdicts) night.verdicts.push_back(summary(verdict));
}

}  // namespace

Night night_of(const std::vector<CaseRecords>& cases) {
  Night night;
  for (const auto& records : cases)
    for (const auto& r : records.records) {
      add(r, night);
      if (r.finished_at <= night.finished_at) continue;
      night.suite = r.suite;
      night.revision = r.revision;
      night.compiler = r.compiler;
      night.flags = r.flags;
      night.machine = r.machine;
      night.finished_at = r.finished_at;
    }
  if (night.finished_at.empty())
    throw std::runtime_error("no record says when it finished, expected the date of a night");
  return night;
}

std::string file_name(const Night& night) {
  std::string name = night.finished_at + "_" + night.revision;
  std::erase(name, ':');
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("._-", c); };
  std::ranges::replace_if(
      name, [&](char c) { return !fits(c); }, '-');
  return name + ".jsonl";
}

void write_night(const Night& night, const fs::path& folder) {
  std::error_code cause;
  fs::create_directories(folder, cause);
  if (cause) throw std::runtime_error(fmt::format("{}: cannot be written: {}", folder.string(), cause.message()));
  save_whole(folder / file_name(night), text_of(night));
}

Night read_night(const fs::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  Night night;
  long number = 0, expected = 0;
  try {
    for (std::string line; std::getline(stream, line);)
      if (++number == 1)
        expected = read_header(parsed(line), night);
      else
        read_line(parsed(line), night);
    if (number == 0) throw std::runtime_error("is empty, expected the header of a night");
    if (number != expected + 1)
      throw std::runtime_error(fmt::format("{} lines below the header, expected {}", number - 1, expected));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), std::max(number, 1L), error.what()));
  }
  return night;
}

}  // namespace touchstone::reports
