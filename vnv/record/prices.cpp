#include "vnv/record/prices.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/record/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace touchstone::vnv {
namespace {

const std::vector<std::string> columns{"case",   "quantity", "target [-]", "ranked by [-]",
                                       "method", "printed",  "CPU [s]",    "smallest error [-]"};

/// "1 %"
std::string in_words(double error, const std::string& quantity) {
  const std::string unit = with_heading(quantity).unit;
  return fmt::format("{:.3g}{}", error, unit.empty() ? "" : " " + unit);
}

}  // namespace

std::vector<Price> prices_of(const std::vector<Record>& records) {
  std::vector<Price> prices;
  for (const Record& record : records)
    for (const WorkDiagram& diagram : record.diagrams) {
      std::vector<WorkPoint> own = of_series(record.work, record.method);
      std::erase_if(own, [&](const WorkPoint& p) { return p.diagram != diagram.id; });
      const std::vector<WorkPoint> front = pareto_front(own, worthwhile);
      for (const double target : diagram.targets)
        prices.push_back({record.case_name, diagram.quantity.heading(), target, diagram.ranked_by, record.method,
                          record.as_printed, time_to_error(own, target).cpu,
                          front.empty() ? not_a_number : front.back().error});
    }
  return prices;
}

std::string csv_of(const std::vector<Price>& prices, const std::string& source) {
  std::string text = fmt::format(
      "# title: CPU time of each method to given errors\n# citation: none\n# source: {}\n# scaling: none\n"
      "# geometry: none\n# uncertainty: none\n# note: Targets and smallest errors are in the unit of their quantity.\n{}",
      source, csv_line(columns));
  const auto number = [](double value) { return fmt::format("{:.4g}", value); };
  for (const Price& p : prices)
    text += csv_line({p.case_name, p.quantity, number(p.target), number(p.ranked_by), p.method,
                      p.as_printed ? "yes" : "no", number(p.cpu), number(p.smallest)});
  return text;
}

std::vector<Price> read_prices(const std::filesystem::path& file) {
  const DataTable table = read_table(file, {"CPU [s]", "smallest error [-]"});
  std::vector<Price> prices;
  for (std::size_t k = 0; k < table.rows(); ++k)
    prices.push_back({table.words("case")[k], table.words("quantity")[k], table.numbers("target [-]")[k],
                      table.numbers("ranked by [-]")[k], table.words("method")[k], table.words("printed")[k] == "yes",
                      table.numbers("CPU [s]")[k], table.numbers("smallest error [-]")[k]});
  return prices;
}

std::vector<Price> ranked(std::vector<Price> prices, double target) {
  std::erase_if(prices, [&](const Price& p) { return p.target != target; });
  std::ranges::stable_sort(prices, {}, [](const Price& p) {
    const bool is_reached = p.cpu > 0, is_known = p.smallest > 0;
    return std::tuple(!is_reached, !is_known, is_reached ? p.cpu : is_known ? p.smallest : 0);
  });
  return prices;
}

std::optional<DefaultMethod> default_method(const std::vector<Price>& of_flow) {
  if (of_flow.empty()) return std::nullopt;
  const double target = of_flow.front().ranked_by;
  const std::vector<Price> all = ranked(of_flow, target);
  if (all.empty()) return std::nullopt;
  const std::string error = in_words(target, all.front().quantity);
  if (!(all.front().cpu > 0))
    return DefaultMethod{all.front().method, fmt::format("no method reaches {}; its error is the smallest, {}", error,
                                                         in_words(all.front().smallest, all.front().quantity))};
  const auto end = std::ranges::find_if(all, [&](const Price& p) { return !(p.cpu <= as_cheap * all.front().cpu); });
  const Price& chosen =
      *std::min_element(all.begin(), end, [](const Price& a, const Price& b) { return a.smallest < b.smallest; });
  std::string reason = fmt::format("{:.2g} CPU s to {}", chosen.cpu, error);
  if (chosen.method != all.front().method)
    reason += fmt::format(", as cheap as {} and with a smaller least error, {} instead of {}", all.front().method,
                          in_words(chosen.smallest, chosen.quantity), in_words(all.front().smallest, chosen.quantity));
  else if (all.size() > 1 && all[1].cpu > 0)
    reason += fmt::format(", the next, {}, {:.2g} times as much", all[1].method, all[1].cpu / chosen.cpu);
  else if (all.size() > 1)
    reason += ", which no other method reaches";
  for (const Price& p : all)
    if (p.as_printed && p.method != chosen.method)
      reason += p.cpu > 0 ? fmt::format("; {} as printed {:.2g} times", p.method, p.cpu / chosen.cpu)
                          : fmt::format("; {} as printed does not reach it", p.method);
  return DefaultMethod{chosen.method, reason};
}

}  // namespace touchstone::vnv
