/// The TOML file of a solver.

#include "vnv/doors/solver.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/files/toml_keys.hpp"
#include "vnv/flows/formulas/flow_file.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

namespace fs = std::filesystem;
using files::Keys;

const std::string solver_schema = "touchstone solver 1";

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
  mapping.probes = keys.flag("probes");
  mapping.at = keys.text("at");
  mapping.symmetric = keys.texts("symmetric");
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
  const toml::table table = files::parsed_toml(file);
  const Keys keys(table, file);
  if (keys.text("schema", solver_schema) != solver_schema)  // before all that another version may say otherwise
    keys.refuse(*table.get("schema"), "schema", fmt::format("'{}', the only version known here", solver_schema));
  Solver solver{.file = fs::absolute(file), .name = keys.text("name", file.stem().string())};
  if (solver.name.find_first_of("./ \t\n") != solver.name.npos || solver.name.empty())
    throw std::invalid_argument(
        fmt::format("{}: name = '{}', expected one without points, slashes and blanks", file.string(), solver.name));
  solver.description = keys.text("description", fmt::format("Another code, run by {}.", file.filename().string()));
  keys.require("flow", "\"stokes_first\"");
  solver.flow = flow_of(keys.text("flow"), Settings(keys.table("set").pairs<double>("a number")), file.parent_path());
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
