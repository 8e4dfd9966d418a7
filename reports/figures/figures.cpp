#include "reports/figures/figures.hpp"

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/order_plot.hpp"
#include "reports/text/files.hpp"

#include <algorithm>

namespace touchstone::reports {
namespace {

template <class Marks>
bool names(const Marks& marks, const std::string& id) {
  return std::any_of(marks.begin(), marks.end(), [&](const auto& mark) { return mark.figure == id; });
}

bool has_curves(const std::string& id, const CaseRecords& records) {
  return std::any_of(records.records.begin(), records.records.end(),
                     [&](const auto& r) { return names(r.curves, id); });
}

bool has_clouds(const std::string& id, const CaseRecords& records) {
  return std::any_of(records.records.begin(), records.records.end(),
                     [&](const auto& r) { return names(r.clouds, id); });
}

}  // namespace

DrawnFigure draw(const vnv::Figure& figure, const CaseRecords& records, const std::filesystem::path& folder) {
  return draw(has_clouds(figure.id, records) ? plot_clouds(figure, records) : plot_curves(figure, records), figure,
              folder);
}

DrawnFigure draw(const Plot& plot, const vnv::Figure& figure, const std::filesystem::path& folder) {
  save(folder / (figure.id + ".gp"), plot.script);
  save(folder / (figure.id + ".csv"), plot.data);
  run_gnuplot(folder / plot.image);
  return {figure, plot.image, plot.width, plot.height, plot.undrawn};
}

std::vector<DrawnFigure> draw_all(const CaseRecords& records, const std::filesystem::path& folder) {
  std::vector<DrawnFigure> drawn;
  for (const auto& figure : figures_of(records))
    if (has_curves(figure.id, records) || has_clouds(figure.id, records))
      drawn.push_back(draw(figure, records, folder));
  return drawn;
}

std::vector<DrawnFigure> draw_orders(const CaseRecords& records, const std::filesystem::path& folder) {
  std::vector<DrawnFigure> drawn;
  for (const auto& comparison : order_comparisons(records))
    drawn.push_back(draw(plot_orders(comparison), order_figure(comparison), folder));
  return drawn;
}

}  // namespace touchstone::reports
