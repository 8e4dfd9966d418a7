#include "reports/compare/orders.hpp"

#include "reports/text/notation.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <tuple>

namespace touchstone::reports {
namespace {

bool has_ladder(const vnv::ObservedOrder& order) {
  return order.spacings.size() >= 2 && order.errors.size() == order.spacings.size();
}

bool speaks_of(const vnv::Verdict& verdict, const vnv::ObservedOrder& order) {
  return verdict.quantity == fmt::format("order of {} over {}", vnv::with_heading(order.quantity).name, order.ladder) &&
         Subject{order.quantity, order.time}.is(order.quantity, verdict.time);
}

bool is_claimed(const vnv::Record& record, const vnv::ObservedOrder& order) {
  return std::ranges::any_of(record.verdicts, [&](const auto& verdict) { return speaks_of(verdict, order); });
}

/// Each once, in order of appearance.
template <class Chooses>
std::vector<Subject> subjects(const CaseRecords& records, const Chooses& chooses) {
  std::vector<Subject> found;
  for_each(records, &vnv::Record::orders, [&](const auto& record, const auto& order) {
    const bool is_known =
        std::ranges::any_of(found, [&](const Subject& s) { return s.is(order.quantity, order.time); });
    if (!is_known && has_ladder(order) && chooses(record, order)) found.push_back({order.quantity, order.time});
  });
  return found;
}

std::set<std::string> claimed_ladders(const CaseRecords& records) {
  std::set<std::string> ladders;
  for_each(records, &vnv::Record::orders, [&](const auto& record, const auto& order) {
    if (is_claimed(record, order)) ladders.insert(order.ladder);
  });
  return ladders;
}

std::vector<vnv::ObservedOrder> shown(const vnv::Record& record, const Subject& subject,
                                      const std::set<std::string>& ladders) {
  std::vector<vnv::ObservedOrder> all, claimed;
  for (const auto& order : record.orders)
    if (subject.is(order.quantity, order.time) && has_ladder(order))
      (ladders.contains(order.ladder) ? claimed : all).push_back(order);
  if (!claimed.empty() || all.empty()) return claimed;
  return {*std::ranges::max_element(all, {}, [](const auto& order) { return order.spacings.size(); })};
}

OrderComparison comparison_of(const CaseRecords& records, const Subject& subject) {
  OrderComparison comparison{subject, {}};
  const auto ladders = claimed_ladders(records);
  std::size_t place = 0;
  for (const auto& record : records.records) {
    for (const auto& order : shown(record, subject, ladders)) comparison.lines.push_back({record.method, place, order});
    place += !record.orders.empty();
  }
  return comparison;
}

/// "L2 v_x, per particle [%]" is of the velocity, "L2 p less its mean [%]" of the pressure.
bool is_norm_of(Field field, const std::string& quantity) {
  const std::string symbol = field == Field::velocity ? "L2 v" : "L2 p";
  return quantity.starts_with(symbol) && !std::isalnum(static_cast<unsigned char>(quantity.c_str()[symbol.size()]));
}

long methods_with_three_spacings(const OrderComparison& comparison) {
  std::set<std::string> methods;
  for (const auto& line : comparison.lines)
    if (line.order.spacings.size() >= 3) methods.insert(line.method);
  return std::ssize(methods);
}

std::vector<Subject> claimed_subjects(const CaseRecords& records) { return subjects(records, is_claimed); }

}  // namespace

bool Subject::is(const std::string& its_quantity, double its_time) const {
  return its_quantity == quantity && std::abs(its_time - time) <= 1e-9 * std::abs(time);
}

std::string OrderComparison::id() const {
  std::string id = "order_";
  for (const char letter : fmt::format("{} at {:.6g} s", vnv::with_heading(subject.quantity).name, subject.time)) {
    if (std::isalnum(static_cast<unsigned char>(letter)))
      id += letter;
    else if (!id.ends_with('_'))
      id += '_';
  }
  return id;
}

std::vector<OrderLine> OrderComparison::of_method(const std::string& method) const {
  std::vector<OrderLine> own;
  std::ranges::copy_if(lines, std::back_inserter(own), [&](const OrderLine& line) { return line.method == method; });
  return own;
}

std::string OrderComparison::name_of(const OrderLine& line) const {
  return of_method(line.method).size() == 1 ? line.method : fmt::format("{}, {}", line.method, line.order.ladder);
}

std::optional<OrderComparison> principal_comparison(const CaseRecords& records, Field field) {
  std::vector<Subject> candidates = claimed_subjects(records);
  std::erase_if(candidates, [&](const Subject& s) { return !is_norm_of(field, s.quantity); });
  if (candidates.empty()) {
    candidates = subjects(records, [&](const auto&, const auto& order) { return is_norm_of(field, order.quantity); });
    if (candidates.empty()) return std::nullopt;
    const std::string first = candidates.front().quantity;
    std::erase_if(candidates, [&](const Subject& s) { return s.quantity != first; });
  }
  std::vector<OrderComparison> comparisons;
  for (const auto& subject : candidates) comparisons.push_back(comparison_of(records, subject));
  return *std::ranges::max_element(
      comparisons, {}, [](const auto& c) { return std::tuple(methods_with_three_spacings(c), c.subject.time); });
}

std::vector<OrderComparison> order_comparisons(const CaseRecords& records) {
  std::vector<OrderComparison> all;
  for (const Field field : {Field::velocity, Field::pressure})
    if (auto principal = principal_comparison(records, field)) all.push_back(std::move(*principal));
  for (const auto& subject : claimed_subjects(records)) {
    OrderComparison claimed = comparison_of(records, subject);
    if (std::ranges::find(all, claimed.id(), &OrderComparison::id) == all.end()) all.push_back(std::move(claimed));
  }
  return all;
}

}  // namespace touchstone::reports
