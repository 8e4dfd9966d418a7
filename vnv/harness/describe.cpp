#include "vnv/harness/describe.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/judge/baselines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {
namespace {

std::optional<double> if_finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }
std::optional<double> if_finite(const std::optional<double>& value) { return value ? if_finite(*value) : value; }

LevelDescription of(const Method& method, const Level& level) {
  LevelDescription said{
      .name = level.name,
      .spacing = level.spacing,
      .cell = if_finite(level.cell),
      .smoothing_length = if_finite(level.smoothing_length),
      .time_step = if_finite(level.step_or(method.time_step ? method.time_step(level) : not_a_number)),
      .until = {}};
  for (const Suite suite : suites)
    if (level.until(suite) > 0) said.until.emplace(name_of(suite), level.until(suite));
  return said;
}

std::vector<ClaimDescription> of(const std::vector<Claim>& claims) {
  std::vector<ClaimDescription> said;
  for (const Claim& claim : claims)
    said.push_back({.quantity = claim.quantity.heading(),
                    .lower = if_finite(claim.lower),
                    .upper = if_finite(claim.upper),
                    .author = claim.author.words,
                    .level = claim.level,
                    .time = if_finite(claim.time),
                    .ladder = claim.ladder,
                    .surely_above = if_finite(claim.surely_above),
                    .least_levels = claim.ladder.empty() ? 0 : claim.least_levels});
  return said;
}

ToleranceDescription of(const Tolerance& tolerance) {
  ToleranceDescription said{tolerance.relative, tolerance.absolute, tolerance.basis};
  for (const Tolerance::Exception& wider : tolerance.exceptions)
    said.basis += fmt::format("; values of \"{}\" by {:g} %: {}", wider.words, 100 * wider.relative, wider.basis);
  return said;
}

MethodDescription of(const Method& method, const Baselines& baselines) {
  MethodDescription said{.name = method.name,
                         .description = method.description,
                         .levels = {},
                         .ladders = {},
                         .claims = of(method.claims),
                         .tolerance = of(method.tolerance),
                         .relative_cost = method.relative_cost,
                         .baselines = std::ranges::count(baselines.rows, method.name, &Baseline::method)};
  for (const ClaimDescription& claim : of(method.claims_of_work)) said.claims.push_back(claim);
  for (const Level& level : method.levels) said.levels.push_back(of(method, level));
  for (const Ladder& ladder : method.ladders) said.ladders.push_back({ladder.name, ladder.levels});
  return said;
}

}  // namespace

Description describe(const std::string& case_name, const Case& declared, const std::filesystem::path& data) {
  const std::filesystem::path file = data / "baselines" / (case_name + ".csv");
  const Baselines baselines = read_baselines(file).value_or(Baselines{});
  Description said{
      .name = case_name,
      .title = declared.title,
      .description = declared.description,
      .suites = {},
      .times = declared.times,
      .timed = declared.timed,
      .label = declared.label,
      .priced_as = declared.priced_as.empty() ? case_name : declared.priced_as,
      .claims = of(declared.claims),
      .methods = {},
      .data_folder = data.string(),
      .tables = {},
      .baseline_file = file.string(),
      .acceptance = {baselines.acceptance.revision, baselines.acceptance.date, baselines.acceptance.reason}};
  for (const Method& method : declared.methods) said.methods.push_back(of(method, baselines));
  for (const Suite suite : suites)
    if (std::ranges::any_of(said.methods, [&](const auto& method) { return method.is_run_in(name_of(suite)); }))
      said.suites.emplace_back(name_of(suite));
  for (const std::filesystem::path& table : tables_read()) said.tables.push_back(table.string());
  return said;
}

}  // namespace touchstone::vnv
