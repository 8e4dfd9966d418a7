#pragma once
/// What an acceptance changed.

#include "vnv/judge/baselines.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

/// A baseline that is new, gone or other than it was.
struct BaselineChange {
  std::optional<Baseline> before, after;

  /// What is left of the old tolerance on the side the value went to, over it; negative beyond the old limits, and not
  /// a number for a value that is new or gone.
  double margin() const;
  /// "poiseuille.mpm M2, 0.1 s, L2 [%]: 1.2 -> 1.3, margin -0.5 of the old tolerance, beyond it"
  std::string sentence(const std::string& case_name) const;
};

/// The baselines whose value or limits differ, in the order of the new ones, then those that are gone.
std::vector<BaselineChange> changes(const Baselines& before, const Baselines& after);

}  // namespace touchstone::vnv::command
