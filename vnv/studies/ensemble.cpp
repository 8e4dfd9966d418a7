#include "vnv/studies/ensemble.hpp"

#include "vnv/record/record.hpp"

#include <cmath>

namespace touchstone::vnv {
namespace {

bool is_told_of(const Value& e, const EnsembleComparison& one) {
  return e.quantity == one.quantity && (e.time == one.time || (std::isnan(e.time) && std::isnan(one.time)));
}

}  // namespace

std::vector<EnsembleComparison> compare_with_accepted(const Record& record, const Baselines& baselines) {
  std::vector<EnsembleComparison> all;
  for (const Value& e : record.values) {
    auto one = std::ranges::find_if(all, [&](const EnsembleComparison& known) { return is_told_of(e, known); });
    if (one == all.end()) one = all.insert(all.end(), {e.quantity, e.time, {}, {}, not_a_number, not_a_number});
    one->members.push_back(e.value);
    if (const Baseline* accepted = baselines.find(record.method, e.level, e.time, e.quantity.heading()))
      one->accepted.push_back(accepted->value);
  }
  for (EnsembleComparison& one : all) {
    one.distance = wasserstein_distance(one.members, one.accepted);
    one.p_value = one.accepted.empty() ? not_a_number : p_value(one.members, one.accepted);
  }
  return all;
}

}  // namespace touchstone::vnv
