#include "vnv/flows/formulas/flow_file.hpp"

#include "vnv/files/data_folder.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/files/toml_keys.hpp"
#include "vnv/flows/formulas/formulas.hpp"
#include "vnv/flows/formulas/residual.hpp"
#include "vnv/flows/formulas/spline.hpp"
#include "vnv/flows/squares/in_square.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

namespace fs = std::filesystem;
using files::Keys;
using formulas::Definition;
using formulas::Formulas;

const std::string flow_schema = "touchstone flow 1";

/// A parameter that may be wrong, and the cause that it is for the diagnosis.
struct Doubtful {
  std::string name;
  Cause cause;
};

/// What the formulas of a flow may speak of.
struct Vocabulary {
  formulas::Numbers numbers{};  // parameters
  formulas::Functions functions{};
  std::vector<Definition> definitions{};
  std::vector<Doubtful> doubtful{};

  /// Formulas of it, where something may be wrong.
  Formulas of(const std::vector<Definition>& more, const Changes& by = {}) const {
    std::vector<Definition> all = definitions;
    std::vector<std::string> wanted;
    for (const Definition& one : more) {
      all.push_back(one);
      wanted.push_back(one.name);
    }
    formulas::Numbers altered = numbers;
    for (const Doubtful& one : doubtful) altered[one.name] *= 1 + by(one.cause);
    return Formulas(all, wanted, altered, functions);
  }
  std::vector<Cause> causes() const {
    std::vector<Cause> all;
    for (const Doubtful& one : doubtful) all.push_back(one.cause);
    return all;
  }
};

std::vector<std::string> in_lines(const std::vector<Definition>& first, const std::vector<Definition>& then) {
  std::vector<std::string> lines;
  for (const auto* part : {&first, &then})
    for (const Definition& one : *part) lines.push_back(fmt::format("{} = {}", one.name, one.text));
  return lines;
}

/// Two formulas as a vector.
VelocityTruth as_vector(const Formulas& both) {
  return [both](const Vec2& x, double t) -> Vec2 {
    const auto v = both(x.x(), x.y(), t);
    return {v[0], v[1]};
  };
}

/// Reads the parts of a file, each of which may use the names of those before it.
class FlowFile {
 public:
  FlowFile(const fs::path& file, const toml::table& table, Settings& settings)
      : keys_(table, file), settings_(settings) {}

  Flow flow() {
    if (keys_.text("schema", flow_schema) != flow_schema)
      keys_.refuse(*keys_.node("schema"), "schema", fmt::format("'{}', the only version known here", flow_schema));
    Flow made;
    read_parameters();
    read_tables();
    read_definitions();
    read_domain(made);
    read_fluid(made);
    read_exact(made);
    read_force(made);
    read_times(made);
    made.judged.title = keys_.text("title", keys_.file().stem().string());
    made.judged.description = keys_.text("description", "A flow in formulas.");
    read_claims(made);
    if (keys_.has("equation")) require_that_it_solves(made);
    keys_.require_no_other();
    return made;
  }

 private:
  Definition definition(const Keys& of, const std::string& key) const { return definition(of, key, *of.node(key)); }
  /// Of a key, or of an element of its array.
  Definition definition(const Keys& of, const std::string& key, const toml::node& node) const {
    const toml::source_position at = node.source().begin;
    Definition made{key, "", fmt::format("{}:{}", keys_.file().string(), at.line)};
    if (const std::optional<double> number = node.value<double>())
      made.text = fmt::format("{:.17g}", *number);
    else if (node.is_string())
      made.text = *node.value<std::string>(), made.column = at.column + 1;  // behind the quotation mark
    else
      of.refuse(node, key, "a number or a formula");
    return made;
  }

  void take_name(const std::string& name, const toml::node& node) {
    const std::string where = fmt::format("{}:{}", keys_.file().string(), node.source().begin.line);
    formulas::require_name(name, where);
    if (!names_.insert(name).second)
      throw std::invalid_argument(fmt::format("{}: the name '{}' stands twice, expected another one", where, name));
  }

  /// What has to be the same everywhere and at all times.
  double number(const Definition& one) const {
    const Formulas formula = vocabulary_.of({one});
    const double value = formula(0, 0, 0)[0];
    if (!formula.are_constant() || !std::isfinite(value))
      throw std::invalid_argument(
          fmt::format("{}: {} = \"{}\"{}, expected a finite number, the same everywhere and at all times", one.where,
                      one.name, one.text, formula.are_constant() ? fmt::format(" is {}", value) : ""));
    return value;
  }
  std::optional<double> number(const Keys& of, const std::string& key) const {
    if (!of.has(key)) return std::nullopt;
    return number(definition(of, key));
  }
  double positive(const Keys& of, const std::string& key, std::string_view example) const {
    of.require(key, example);
    const double value = *number(of, key);
    if (!(value > 0)) of.refuse(*of.node(key), key, fmt::format("more than 0 (it is {:g})", value));
    return value;
  }

  void read_parameters() {
    const Keys parameters = keys_.table("parameters");
    for (const std::string& name : parameters.in_order()) {
      const toml::node& node = *parameters.node(name);
      take_name(name, node);
      const bool is_table = node.is_table();
      const Keys of = is_table ? parameters.table(name) : parameters;
      const std::string value = is_table ? "value" : name;
      of.require(value, "1");
      vocabulary_.numbers[name] =
          settings_(name, *number(of, value), is_table ? of.text("unit", "-") : "-",
                    is_table ? of.text("words", "parameter of the formulas") : "parameter of the formulas");
      if (!is_table) continue;
      if (of.has("may_be_wrong")) read_doubt(of, name);
      of.require_no_other();
    }
    parameters.require_no_other();
  }

  /// `may_be_wrong = true`, or what the parameter is: then the diagnosis speaks of that.
  void read_doubt(const Keys& of, const std::string& name) {
    const toml::node& node = *of.node("may_be_wrong");
    static const std::map<std::string, Cause, std::less<>> known{{"viscosity", Cause::viscosity},
                                                                 {"force", Cause::force},
                                                                 {"gravity", Cause::gravity},
                                                                 {"speed of sound", Cause::sound_speed}};
    if (node.is_string() && known.contains(*node.value<std::string>())) {
      vocabulary_.doubtful.push_back({name, known.at(*node.value<std::string>())});
    } else if (node.is_boolean()) {
      if (!*node.value<bool>()) return;
      if (other_doubts_.size() == most_parameters_in_doubt)
        of.refuse(node, "may_be_wrong",
                  fmt::format("{} parameters or fewer that may be wrong", most_parameters_in_doubt));
      vocabulary_.doubtful.push_back({name, cause_of_parameter(other_doubts_.size())});
      other_doubts_.push_back(name);
    } else {
      of.refuse(node, "may_be_wrong", "true, false, \"viscosity\", \"force\", \"gravity\" or \"speed of sound\"");
    }
    if (vocabulary_.numbers[name] == 0)
      of.refuse(node, "may_be_wrong", "a parameter that is not 0: how wrong it is is a part of it");
  }

  /// Tables as functions, of files in the folder of this one or below it.
  void read_tables() {
    const Keys tables = keys_.table("tables");
    for (const std::string& name : tables.in_order()) {
      take_name(name, *tables.node(name));
      const Keys table = tables.table(name);
      for (const auto& [key, example] :
           {std::pair("file", "\"profile.csv\""), {"of", "\"y [m]\""}, {"value", "\"v [m/s]\""}})
        table.require(key, example);
      const fs::path file = fs::path(table.text("file")).lexically_normal();
      if (file.is_absolute() || file.empty() || *file.begin() == "..")
        table.refuse(*table.node("file"), "file", "one in the folder of this file or below it");
      vocabulary_.functions[name] =
          formulas::spline_of(keys_.file().parent_path() / file, table.text("of"), table.text("value"));
      table.require_no_other();
    }
    tables.require_no_other();
  }

  void read_definitions() {
    const Keys let = keys_.table("let");
    for (const std::string& name : let.in_order()) {
      take_name(name, *let.node(name));
      vocabulary_.definitions.push_back(definition(let, name));
      vocabulary_.of({});  // whether it can be read
    }
    let.require_no_other();
  }

  /// The lowest and the highest [m] along an axis.
  std::pair<double, double> range(const Keys& domain, const std::string& axis) const {
    domain.require(axis, R"([0, "L"])");
    const toml::array* ends = domain.node(axis)->as_array();
    if (!ends || ends->size() != 2) domain.refuse(*domain.node(axis), axis, "two numbers or formulas, low and high");
    const std::array found{number(definition(domain, axis, *ends->get(0))),
                           number(definition(domain, axis, *ends->get(1)))};
    if (!(found[0] < found[1]))
      domain.refuse(*domain.node(axis), axis,
                    fmt::format("low below high (they are {:g} and {:g})", found[0], found[1]));
    return {found[0], found[1]};
  }

  void read_domain(Flow& made) {
    const Keys domain = keys_.table("domain");
    const auto [left, right] = range(domain, "x");
    const auto [low, high] = range(domain, "y");
    made.domain.box = {.low = {left, low}, .high = {right, high}};
    for (const std::string& axis : domain.texts("periodic")) {
      if (axis != "x" && axis != "y")
        domain.refuse(*domain.node("periodic"), "periodic", R"(["x"], ["y"] or ["x", "y"])");
      (axis == "x" ? made.domain.periodic_x : made.domain.periodic_y) = true;
    }
    made.filled = made.domain.box;
    made.across = domain.has("across") ? positive(domain, "across", "1") : made.filled.size().minCoeff();
    domain.require_no_other();
  }

  void read_fluid(Flow& made) {
    const Keys fluid = keys_.table("fluid");
    const double rho = positive(fluid, "density", "1000");
    made.fluid = {{.density = rho, .bulk_modulus = HUGE_VAL}, rho * number(fluid, "viscosity").value_or(0)};
    if (fluid.has("sound_speed"))
      made.fluid.bulk_modulus = rho * std::pow(positive(fluid, "sound_speed", "10"), 2) / Tait::gamma;
    if (made.fluid.viscosity < 0) fluid.refuse(*fluid.node("viscosity"), "viscosity", "0 or more");
    fluid.require_no_other();
  }

  void read_exact(Flow& made) {
    const Keys exact = keys_.table("exact");
    exact.require("v_x", "\"U*sin(pi*y/H)\"");
    exact.require("v_y", "0");
    const std::vector<Definition> both{definition(exact, "v_x"), definition(exact, "v_y")};
    std::vector<Definition> all = both;
    if (exact.has("p")) all.push_back(definition(exact, "p"));
    exact.require_no_other();
    const flows::PressureWith pressure = [of = vocabulary_, p = all.back()](const Changes& by) -> PressureTruth {
      return [at = of.of({p}, by)](const Vec2& x, double t) { return at(x.x(), x.y(), t)[0]; };
    };
    const bool has_pressure = all.size() > both.size();
    flows::fill(
        made, [of = vocabulary_, both](const Changes& by) { return as_vector(of.of(both, by)); },
        has_pressure ? pressure({}) : PressureTruth(), vocabulary_.causes());
    if (has_pressure) flows::add_pressure(made, pressure, vocabulary_.causes());
    for (Exact& one : made.exact) one.parameters = other_doubts_;
    made.formulas = in_lines(vocabulary_.definitions, all);
  }

  void read_force(Flow& made) {
    if (!keys_.has("force")) return;
    const Keys force = keys_.table("force");
    force.require("b_x", "\"F\"");
    force.require("b_y", "0");
    const std::vector<Definition> both{definition(force, "b_x"), definition(force, "b_y")};
    force.require_no_other();
    const Formulas of = vocabulary_.of(both);
    const VelocityTruth at = as_vector(of);
    if (of.are_constant()) {
      made.drive.amplitude = at(Vec2::Zero(), 0);
      return;
    }
    made.drive.at = at;
    made.drive.formula = in_lines(vocabulary_.definitions, both);
    const Box& box = made.domain.box;
    for (const auto& [i, j, t] : {std::tuple(0.1, 0.3, 0.0), std::tuple(0.75, 0.2, 0.1), std::tuple(0.5, 0.95, 0.2)}) {
      const Vec2 x = box.low + box.size().cwiseProduct(Vec2(i, j)), b = at(x, t);
      made.drive.examples.push_back({x.x(), x.y(), t, b.x(), b.y()});
    }
  }

  void read_times(Flow& made) {
    keys_.require("times", "[0.5, 1]");
    made.judged.times = keys_.numbers("times");
    if (std::ranges::adjacent_find(made.judged.times, std::greater_equal{}) != made.judged.times.end() ||
        !(made.judged.times.front() > 0))
      keys_.refuse(*keys_.node("times"), "times", "increasing ones above 0 [s]");
    const Vec2 x = made.filled.low + made.filled.size().cwiseProduct(Vec2(0.37, 0.41));
    for (const double t : made.judged.times)
      if (const Vec2 v = made.velocity()(x, t); !v.allFinite())
        throw std::invalid_argument(
            fmt::format("{}: the exact velocity at ({:g}, {:g}) m and {:g} s is ({}, {}), expected numbers",
                        keys_.file().string(), x.x(), x.y(), t, v.x(), v.y()));
    made.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, made.judged.times.front());
  }

  void read_claims(Flow& made) const {
    const Keys claims = keys_.table("claims");
    const Author author = baseline(claims.text("author", "limit of the flow's file"));
    if (const std::optional<double> least = claims.number_if_there("order_at_least"))
      made.judged.claims = {
          order_at_least(ladder_of_files, l2_velocity, *least, *least - 0.5, author).with_at_least_levels(3)};
    if (claims.has("at_most")) {
      made.of_resolved = {at_most(l2_velocity, claims.positive("at_most", 1), author)};
      made.resolved = claims.positive("from_across", 1);
    }
    claims.require_no_other();
  }

  void require_that_it_solves(Flow& made) const {
    static const std::string known = "navier-stokes";
    if (keys_.text("equation") != known)
      keys_.refuse(*keys_.node("equation"), "equation", fmt::format("\"{}\", of an incompressible fluid", known));
    const formulas::Residual found = formulas::residual_of(made);
    if (!(found.size <= formulas::largest_residual))
      throw std::invalid_argument(fmt::format("{}: the formulas do not solve the Navier-Stokes equations: {}",
                                              keys_.file().string(), found.sentence));
    made.residual = "The formulas solve the Navier-Stokes equations: " + found.sentence;
  }

  Keys keys_;
  Settings& settings_;
  Vocabulary vocabulary_{};
  std::vector<std::string> other_doubts_{};  // of which nothing more is known
  std::set<std::string> names_{};
};

fs::path file_of(const std::string& name) { return data_folder() / "flows" / (name + ".toml"); }

[[noreturn]] void refuse_file(const fs::path& file, const std::exception& error) {
  const std::string what = error.what();
  throw std::invalid_argument(printable(what.starts_with(file.string() + ":") ? what : file.string() + ": " + what));
}

}  // namespace

std::vector<std::string> known_flows() {
  std::vector<std::string> names = flow_names();
  if (const fs::path folder = data_folder() / "flows"; fs::is_directory(folder))
    for (const fs::directory_entry& file : fs::directory_iterator(folder))
      if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
  std::ranges::sort(names);
  return names;
}

Flow read_flow(const fs::path& file, Settings settings) try {
  const toml::table table = files::parsed_toml(file);
  Flow flow = FlowFile(file, table, settings).flow();
  const std::string name = file.stem().string();
  if (name.empty() ||
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") != name.npos)
    throw std::invalid_argument("the name of the file names the flow, expected letters, digits, _ and - in it");
  const std::vector<std::string> known = known_flows();
  if (std::ranges::find(known, name) != known.end() && fs::absolute(file) != fs::absolute(file_of(name)))
    throw std::invalid_argument(
        fmt::format("{} is the name of another flow, expected one that vnv scene does not list", name));
  return finished(std::move(flow), name, settings);
} catch (const std::logic_error& error) {
  refuse_file(file, error);
} catch (const BadData& error) {  // of a table
  refuse_file(file, error);
}

Flow flow_of(const std::string& name_or_file, Settings settings, const fs::path& folder) {
  if (name_or_file.ends_with(".toml")) return read_flow(folder / name_or_file, std::move(settings));
  const std::vector<std::string> built_in = flow_names(), known = known_flows();
  if (std::ranges::find(built_in, name_or_file) != built_in.end()) return flow_named(name_or_file, std::move(settings));
  if (std::ranges::find(known, name_or_file) != known.end())
    return read_flow(file_of(name_or_file), std::move(settings));
  throw std::invalid_argument(
      fmt::format("no flow '{}', expected one of: {}; or a file, mine.toml", name_or_file, fmt::join(known, ", ")));
}

}  // namespace touchstone::vnv
