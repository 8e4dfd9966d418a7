/// The TOML file of a solver.

#include "vnv/doors/solver.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

namespace fs = std::filesystem;

/// A table of the file: gives what its keys hold, and refuses those that nobody asked for.
class Keys {
 public:
  Keys(const toml::table& table, const fs::path& file, std::string of = "")
      : table_(table), file_(file), of_(std::move(of)) {}

  bool has(const std::string& key) const { return asked_.insert(key), table_.contains(key); }

  std::string text(const std::string& key, const std::string& otherwise = "") const {
    return has(key) ? of_kind<std::string>(*table_.get(key), key, "a text") : otherwise;
  }
  double number(const std::string& key) const { return of_kind<double>(*table_.get(key), key, "a number"); }
  double positive(const std::string& key, double otherwise) const {
    if (!has(key)) return otherwise;
    const double value = number(key);
    if (!(value > 0)) refuse(*table_.get(key), key, "a number above 0");
    return value;
  }
  std::optional<double> number_if_there(const std::string& key) const {
    return has(key) ? std::optional(number(key)) : std::nullopt;
  }
  bool flag(const std::string& key) const { return has(key) && of_kind<bool>(*table_.get(key), key, "true or false"); }

  std::vector<double> numbers(const std::string& key) const { return all<double>(key, "an array of numbers"); }
  /// One text or an array of them.
  std::vector<std::string> texts(const std::string& key) const {
    if (has(key) && table_.get(key)->is_string()) return {text(key)};
    return all<std::string>(key, "a text or an array of texts");
  }

  /// The table of a key, empty if there is none.
  Keys table(const std::string& key) const {
    static const toml::table none;
    if (!has(key)) return {none, file_, key};
    if (!table_.get(key)->is_table()) refuse(*table_.get(key), key, "a table");
    return {*table_.get(key)->as_table(), file_, key};
  }
  template <class T>
  std::map<std::string, T> pairs(const std::string& kind) const {
    std::map<std::string, T> all;
    for (const auto& [key, node] : table_) {
      asked_.emplace(key.str());
      all.emplace(key.str(), of_kind<T>(node, std::string(key.str()), kind));
    }
    return all;
  }

  /// Throws for a key that was not asked for.
  void require_no_other() const {
    for (const auto& [key, node] : table_)
      if (!asked_.contains(std::string(key.str())))
        throw std::invalid_argument(fmt::format("{}:{}: unknown key '{}'{}, expected one of: {}", file_.string(),
                                                key.source().begin.line, key.str(), of_.empty() ? "" : " of " + of_,
                                                fmt::join(asked_, ", ")));
  }

  [[noreturn]] void refuse(const toml::node& node, const std::string& key, std::string_view expected) const {
    std::ostringstream value;
    if (const auto number = node.value_exact<double>())
      value << fmt::format("{}", *number);  // as it was written: toml++ writes 1e-7 as 9.9999999999999995e-08
    else
      node.visit([&](const auto& held) { value << held; });
    throw std::invalid_argument(fmt::format("{}:{}: {}{} = {}, expected {}", file_.string(), node.source().begin.line,
                                            of_.empty() ? "" : of_ + ".", key, value.str(), expected));
  }
  void require(const std::string& key, std::string_view example) const {
    if (!has(key))
      throw std::invalid_argument(fmt::format("{}: no key '{}'{}, expected one such as {} = {}", file_.string(), key,
                                              of_.empty() ? "" : " of " + of_, key, example));
  }

 private:
  template <class T>
  T of_kind(const toml::node& node, const std::string& key, std::string_view expected) const {
    const std::optional<T> value = node.value<T>();
    if (!value) refuse(node, key, expected);
    return *value;
  }
  template <class T>
  std::vector<T> all(const std::string& key, std::string_view expected) const {
    std::vector<T> values;
    if (!has(key)) return values;
    const toml::array* array = table_.get(key)->as_array();
    if (!array || array->empty()) refuse(*table_.get(key), key, expected);
    for (const toml::node& node : *array) values.push_back(of_kind<T>(node, key, expected));
    return values;
  }

  const toml::table& table_;
  const fs::path& file_;
  std::string of_;
  mutable std::set<std::string> asked_{};
};

const std::string solver_schema = "touchstone solver 1";

toml::table parsed(const fs::path& file) try {
  return toml::parse_file(file.string());
} catch (const toml::parse_error& error) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
}

Mapping mapping_of(const Keys& keys) {
  Mapping mapping;
  mapping.arrays = keys.table("fields").pairs<std::string>("the name of an array");
  mapping.units = keys.table("units").pairs<std::string>("a unit");
  mapping.axes = keys.text("axes");
  if (const std::vector<double> origin = keys.numbers("origin"); origin.size() == 2)
    mapping.origin = {origin[0], origin[1]};
  else if (keys.has("origin"))
    throw std::invalid_argument(fmt::format("read.origin: {} numbers, expected 2 [m]", origin.size()));
  mapping.only = keys.text("only");
  mapping.inside = keys.flag("inside");
  mapping.time = keys.number_if_there("time");
  mapping.time_step = keys.number_if_there("time_step");
  keys.require_no_other();
  return mapping;
}

/// Spacings [m], the coarsest first: as they are, or by how many of them fit across the flow.
std::vector<double> spacings_of(const Keys& keys, const Flow& flow) {
  std::vector<double> spacings = keys.numbers("spacings");
  for (const double across : keys.numbers("across")) spacings.push_back(flow.across / across);
  if (spacings.empty()) keys.require("across", "[10, 20, 40]");
  for (const double spacing : spacings)
    if (!(spacing > 0 && spacing <= flow.across))
      throw std::invalid_argument(
          fmt::format("spacing {:g} m, expected more than 0 and at most {:g} m, all across", spacing, flow.across));
  std::ranges::sort(spacings, std::greater{});
  return spacings;
}

/// Besides the increasing times [s] all multiples of a step, from 0 to the last time.
std::vector<double> with_multiples(const std::vector<double>& times, double step) {
  const double end = times.back();
  std::vector<double> all = times;
  for (int k = 0; k * step < end * (1 - 1e-9); ++k) {
    const double one = as_meant(k * step);
    const auto next = std::ranges::lower_bound(times, one * (1 - 1e-9));
    if (next == times.end() || *next > one * (1 + 1e-9)) all.push_back(one);
  }
  std::ranges::sort(all);
  return all;
}

void read_command(const Keys& keys, Solver& solver) {
  keys.require("command", R"(["./solver", "{scene}"])");
  solver.command = keys.texts("command");
  solver.is_for_shell = solver.command.size() == 1;
}

/// Of which a run occupies so many, of one kind.
void read_resources(const Keys& keys, Solver& solver) {
  for (const auto& [key, resource] : {std::pair("gpus", Resource::gpu), std::pair("cores", Resource::core)}) {
    if (!keys.has(key)) continue;
    if (solver.resources > 0)
      throw std::invalid_argument(
          fmt::format("{}: resources.cores beside resources.gpus, expected one of them: a cost has one unit",
                      solver.file.string()));
    solver.resource = resource;
    solver.resources = keys.positive(key, 0);
  }
  keys.require_no_other();
}

Solver solver_in(const fs::path& file) {
  if (!fs::is_regular_file(file)) throw std::invalid_argument(fmt::format("{}: no such file", file.string()));
  const toml::table table = parsed(file);
  const Keys keys(table, file);
  if (keys.text("schema", solver_schema) != solver_schema)  // before all that another version may say otherwise
    keys.refuse(*table.get("schema"), "schema", fmt::format("'{}', the only version known here", solver_schema));
  Solver solver{.file = fs::absolute(file), .name = keys.text("name", file.stem().string())};
  if (solver.name.find_first_of("./ \t\n") != solver.name.npos || solver.name.empty())
    throw std::invalid_argument(
        fmt::format("{}: name = '{}', expected one without points, slashes and blanks", file.string(), solver.name));
  solver.description = keys.text("description", fmt::format("Another code, run by {}.", file.filename().string()));
  keys.require("flow", "\"stokes_first\"");
  solver.flow = flow_named(keys.text("flow"), Settings(keys.table("set").pairs<double>("a number")));
  solver.spacings = spacings_of(keys, solver.flow);
  if (keys.has("times")) solver.flow.judged.times = keys.numbers("times");  // as its scene says them
  solver.times = solver.flow.judged.times;
  if (!std::ranges::is_sorted(solver.times) || !(solver.times.front() > 0))
    throw std::invalid_argument(
        fmt::format("{}: times = {}, expected increasing ones above 0", file.string(), solver.times));
  if (const double step = keys.positive("every", 0); step > 0) {
    constexpr int most = 100'000;  // each is written, read and judged
    if (const double end = solver.times.back(); end / step > most)
      keys.refuse(*table.get("every"), "every",
                  fmt::format("{:g} s or more: {} times until {:g} s at most", end / most, most, end));
    solver.times = with_multiples(solver.times, step);
  }
  read_command(keys, solver);
  solver.needs = keys.table("needs").pairs<std::string>("how to get it");
  keys.require("output", "\"profile.csv\"");
  solver.output = keys.texts("output");
  solver.mapping = mapping_of(keys.table("read"));
  require_known_names(solver.mapping, fmt::format("{}: read", file.string()));
  const Keys limits = keys.table("limits"), claims = keys.table("claims");
  solver.limits.wall = limits.positive("time", solver.limits.wall);
  solver.limits.memory = limits.positive("memory", solver.limits.memory);
  limits.require_no_other();
  read_resources(keys.table("resources"), solver);
  solver.at_most = claims.number_if_there("at_most");
  solver.order_at_least = claims.number_if_there("order_at_least");
  claims.require_no_other();
  if (const std::string folder = keys.text("baselines"); !folder.empty())
    solver.baselines = solver.file.parent_path() / folder;
  solver.tolerance = keys.positive("tolerance", solver.tolerance);
  keys.require_no_other();
  return solver;
}

}  // namespace

Solver read_solver(const fs::path& file) try {
  return solver_in(file);
} catch (const std::logic_error& error) {  // of the file, or of an oracle, which knows none
  const std::string what = error.what();
  throw std::invalid_argument(printable(what.starts_with(file.string()) ? what : file.string() + ": " + what));
}

}  // namespace touchstone::vnv::doors
