#pragma once
/// Methods whose levels are no resolutions: each is a flow, an arrangement or a variant, and runs something of its own.

#include "vnv/case.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace touchstone::vnv {

struct NamedRun {
  Level level;
  std::function<Run(const Level&, const Schedule&)> run;
};

/// Adds the levels of such runs to a method. Its run throws std::invalid_argument for a level that none has.
inline Method with_runs(Method method, std::vector<NamedRun> runs) {
  for (const NamedRun& one : runs) method.levels.push_back(one.level);
  method.run = [runs = std::move(runs), name = method.name](const Level& level, const Schedule& when) {
    for (const NamedRun& one : runs)
      if (one.level.name == level.name) return one.run(level, when);
    throw std::invalid_argument(fmt::format("{}: no level '{}', expected one of its own", name, level.name));
  };
  return method;
}

}  // namespace touchstone::vnv
