#include "vnv/flows/dams/gated_dam_ensemble.hpp"

#include "vnv/flows/dams/gated_dam_validation.hpp"
#include "vnv/judge/distribution.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::gated_dam {
namespace {

constexpr double from = 2.4, to = 6;  // T_H
const std::vector<double> percentiles{0.025, 0.5, 0.975};

/// What is compared of both: the members of the ensemble, and the percentiles of the repeats.
struct Compared {
  std::string name;
  std::vector<double> members, repeats;

  AgainstQuantiles test() const { return against_quantiles(members, repeats, percentiles); }
};

std::vector<Observed> observed_of(const std::vector<const Run*>& runs) {
  std::vector<Observed> all;
  for (const Run* run : runs) all.push_back(observed_in(*run, filled_300));
  return all;
}

/// At P2, with clocks aligned.
std::vector<Series> pressures_at_P2(const std::vector<Observed>& members) {
  std::vector<Series> all;
  for (const Observed& observed : members) all.push_back(aligned_by_arrival(observed.pressures[1]));
  return all;
}

std::vector<double> times() {
  std::vector<double> all;
  for (int k = 0; k <= 360; ++k) all.push_back(from + (to - from) * k / 360);
  return all;
}

std::vector<Compared> comparisons(const std::vector<Observed>& members, const std::vector<Series>& pressures) {
  std::vector<Compared> all;
  const auto band = band_of_P2();
  for (const double time : {2.6, 2.8, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0}) {
    Compared one{fmt::format("p/(rho g H) at P2, T_H = {:g}", time), {}, {}};
    for (const Series& pressure : pressures) one.members.push_back(value_at(pressure, time));
    for (const auto& [name, series] : band) one.repeats.push_back(value_at(series, time));
    all.push_back(one);
  }
  const std::vector<std::vector<double>> peaks = peaks_of_repeats();
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    Compared one{fmt::format("first peak p/(rho g H) at P{}", k + 1), {}, peaks[k]};
    for (const Observed& observed : members) one.members.push_back(impact_on(observed.pressures[k]).peak);
    all.push_back(one);
  }
  return all;
}

/// The fraction of the time in which the median is within the band of the repeats.
double median_inside(const std::vector<Series>& pressures) {
  const auto band = band_of_P2();
  return fraction_inside(quantile_of(pressures, times(), 0.5), band.front().second, band.back().second, from, to);
}

/// The fraction of T_H 5 to 7, in which the wave returns, for which a level as both runs of the experiment have it in the
/// mean lies within the range of the ensemble; of the gauges H2 to H4 the mean.
double late_levels_inside(const std::vector<Observed>& members) {
  std::vector<double> late;
  for (int step = 0; step <= 100; ++step) late.push_back(5 + 0.02 * step);
  const Observed first = measured_300(1), second = measured_300(2);
  double inside = 0;
  for (std::size_t k = 1; k < gauges.size(); ++k) {
    std::vector<Series> levels;
    for (const Observed& observed : members) levels.push_back(observed.levels[k]);
    const Series low = quantile_of(levels, late, 0), high = quantile_of(levels, late, 1);
    for (std::size_t i = 0; i < late.size(); ++i) {
      const double mean = (value_at(first.levels[k], late[i]) + value_at(second.levels[k], late[i])) / 2;
      inside += mean >= low.value[i] && mean <= high.value[i];
    }
  }
  return inside / static_cast<double>(late.size() * (gauges.size() - 1));
}

}  // namespace

Plot ensemble_beside_repeats() {
  return [](const Results& results, Record& record) {
    const std::string id = "ensemble_P2", name = results.method.name;
    record.figures.push_back(
        {id,
         "Pressure at P2: ensemble and repeats",
         "Median and percentiles 2.5 % and 97.5 % of starts that differ by a hundredth of a spacing, and of 100 repeats "
         "of the experiment; each start is shifted in time to the measured arrival, by 27 ms at most.",
         {"T_H = t sqrt(g/H)", 1, false, from, to},
         {"p/(rho g H)", 1, false, -0.5, 3}});
    Table table{
        "ensemble",
        "Ensemble and repeats of the experiment",
        "Distance: the largest difference between the two distribution functions at the three percentiles of the "
        "repeats; p-value: the exact probability that as many starts drawn from the distribution of the repeats would "
        "be at least as far from it.",
        {"method", "quantity", "starts", "median", "2.5 to 97.5 %", "measured median", "measured 2.5 to 97.5 %",
         "distance", "p-value"},
        {}};
    Table whole{"ensemble_in_time",
                "Agreement of the ensemble with the experiment over time",
                "Over all starts.",
                {"method", "quantity", "value"},
                {}};
    for (const auto& [label, series] : band_of_P2())
      record.curves.push_back(
          {id, label, label.ends_with("median") ? Role::experiment : Role::guide, series.time, series.value, false});
    const std::vector<const Run*> runs = ensemble_of(results);
    if (!runs.empty()) {
      const std::vector<Observed> members = observed_of(runs);
      const std::vector<Series> pressures = pressures_at_P2(members);
      const std::string of = fmt::format("{}, {} starts at {:g} across", name, runs.size(),
                                         std::round(filled_300.height / runs.front()->summary.spacing));
      for (const auto& [fraction, what] :
           std::vector<std::pair<double, std::string>>{{0.5, ""}, {0.025, ", 2.5 %"}, {0.975, ", 97.5 %"}}) {
        const Series curve = quantile_of(pressures, times(), fraction);
        record.curves.push_back({id, what.empty() ? of : name + what, Role::ours, curve.time, curve.value, false});
      }
      const auto range = [](double low, double high) { return fmt::format("{:.3g} to {:.3g}", low, high); };
      for (const Compared& one : comparisons(members, pressures)) {
        const AgainstQuantiles test = one.test();
        table.rows.push_back({name, one.name, static_cast<double>(one.members.size()), quantile(one.members, 0.5),
                              range(quantile(one.members, 0.025), quantile(one.members, 0.975)), one.repeats[1],
                              range(one.repeats[0], one.repeats[2]), test.distance, test.p_value});
      }
      for (const Value& value : ensemble_values(results, record))
        whole.rows.push_back({name, value.quantity.name, value.value});
    }
    for (const double coefficient : friction_coefficients)
      if (const auto rough = runs_with_friction(results, coefficient); !rough.empty())
        whole.rows.push_back({name, fmt::format("{}, skin friction {:g}", median_inside_band.name, coefficient),
                              median_inside(pressures_at_P2(observed_of(rough)))});
    for (Table* one : {&table, &whole}) record.tables.push_back(std::move(*one));
  };
}

std::vector<Value> ensemble_values(const Results& results, const Record&) {
  const std::vector<const Run*> runs = ensemble_of(results);
  if (runs.empty()) return {};
  const std::vector<Observed> members = observed_of(runs);
  std::vector<Value> found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({"", not_a_number, with_300.end, quantity, value});
  };
  const std::vector<Series> pressures = pressures_at_P2(members);
  add(median_inside_band, median_inside(pressures));
  add(levels_inside_ensemble, late_levels_inside(members));
  const std::vector<Compared> all = comparisons(members, pressures);
  add(unlike_repeats,
      static_cast<double>(std::ranges::count_if(all, [](const Compared& one) { return one.test().p_value < 0.01; })));
  return found;
}

}  // namespace touchstone::vnv::gated_dam
