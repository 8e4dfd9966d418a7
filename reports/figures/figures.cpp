#include "reports/figures/figures.hpp"

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/order_plot.hpp"
#include "vnv/files/whole_file.hpp"

#include <algorithm>

namespace touchstone::reports {
namespace {

bool has(const CaseRecords& records, const auto& marks, const std::string& figure) {
  return std::ranges::any_of(records.records, [&](const vnv::Record& record) {
    return std::ranges::any_of(record.*marks, [&](const auto& mark) { return mark.figure == figure; });
  });
}

Plot plot_of(const vnv::Figure& figure, const CaseRecords& records) {
  return has(records, &vnv::Record::clouds, figure.id) ? plot_clouds(figure, records) : plot_curves(figure, records);
}

}  // namespace

void draw(const Plots& plots, const std::filesystem::path& folder) {
  for (const auto& [figure, plot] : plots) {
    files::write_whole(folder / (figure.id + ".gp"), plot.script);
    files::write_whole(folder / (figure.id + ".csv"), plot.data);
    run_gnuplot(folder / plot.image);
  }
}

Plots plots_of_all(const CaseRecords& records) {
  Plots plots;
  for (const auto& figure : each_once(records, &vnv::Record::figures))
    if (has(records, &vnv::Record::curves, figure.id) || has(records, &vnv::Record::clouds, figure.id))
      plots.emplace_back(figure, plot_of(figure, records));
  return plots;
}

std::string first_image(const CaseRecords& records) {
  const auto figures = each_once(records, &vnv::Record::figures);
  for (const auto& figure : figures)
    if (has(records, &vnv::Record::clouds, figure.id)) return figure.id + ".png";
  for (const auto& figure : figures)
    if (has(records, &vnv::Record::curves, figure.id)) return figure.id + ".svg";
  return "";
}

Plots plots_of_orders(const CaseRecords& records) {
  Plots plots;
  for (const auto& comparison : order_comparisons(records))
    plots.emplace_back(order_figure(comparison), plot_orders(comparison));
  return plots;
}

}  // namespace touchstone::reports
