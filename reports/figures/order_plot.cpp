#include "reports/figures/order_plot.hpp"

#include "reports/figures/style.hpp"
#include "reports/read/csv.hpp"
#include "reports/text/notation.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace touchstone::reports {
namespace {

constexpr int plot_height = 500;    // px
constexpr double below_data = 0.6;  // of the smallest error: where the guides start
constexpr double widest_band = 1;   // half-width of an order; beyond, a band would cover what it is to explain

/// A line of the comparison, and where its rows stand in the data.
struct LadderSeries {
  std::string label;
  LineStyle style;
  std::size_t first;
  const vnv::ObservedOrder* order;

  std::string data_in(const std::string& figure) const { return data_rows(figure, first, order->spacings.size()); }
  bool has_band() const { return order->half_width <= widest_band; }
  bool has_floor() const { return !std::isnan(order->floor); }
};

/// "order 2.02 ± 0.12".
std::string order_words(const vnv::ObservedOrder& order) {
  if (std::isnan(order.order)) return "no order";
  return fmt::format("order {}{}", with_interval(order.order, order.half_width),
                     order.spacings.size() == 2 ? " of two spacings" : "");
}

/// As in other figures, but with a mark of its own for each method: many lines meet here.
LineStyle style_of(const OrderLine& line, std::size_t member) {
  LineStyle style = style_of_method(line.place, member);
  style.mark = pick(member == 0 ? filled_marks : hollow_marks, line.place);
  style.width = 1.6;
  style.size = 0.8;
  return style;
}

std::vector<LadderSeries> series_of(const OrderComparison& comparison) {
  std::vector<LadderSeries> all;
  std::map<std::string, std::size_t> members;  // so far, of each method
  std::size_t row = 0;
  for (const auto& line : comparison.lines) {
    all.push_back({fmt::format("{}: {}", comparison.name_of(line), order_words(line.order)),
                   style_of(line, members[line.method]++), row, &line.order});
    row += line.order.spacings.size();
  }
  return all;
}

double mean_log(const std::vector<double>& values) {
  const auto add_log = [](double sum, double value) { return sum + std::log(value); };
  return std::accumulate(values.begin(), values.end(), 0.0, add_log) / static_cast<double>(values.size());
}

/// A power law of some order through the centre of the data, about which the least-squares line turns; not a number
/// where the interval knows no bounds.
double on_line(const vnv::ObservedOrder& data, double order, double spacing) {
  if (!std::isfinite(order)) return vnv::not_a_number;
  return std::exp(mean_log(data.errors) + order * (std::log(spacing) - mean_log(data.spacings)));
}

std::string rows(const LadderSeries& series, const vnv::Figure& figure) {
  const vnv::ObservedOrder& o = *series.order;
  std::string csv;
  for (std::size_t i = 0; i < o.spacings.size(); ++i) {
    const double h = o.spacings[i];
    std::vector<std::string> fields{series.label};
    for (const double value : {h * figure.x.scale, o.errors[i], on_line(o, o.order, h),
                               on_line(o, o.order - o.half_width, h), on_line(o, o.order + o.half_width, h), o.floor})
      fields.push_back(plain(value, data_digits));
    csv += csv_line(fields);
  }
  return csv;
}

std::string data(const std::vector<LadderSeries>& all, const vnv::Figure& figure) {
  std::string csv = csv_line({"ladder", figure.x.label, figure.y.label, "least-squares line",
                              "line of the lowest order", "line of the highest order", "floor"});
  for (const auto& series : all) csv += rows(series, figure);
  return csv;
}

long drawable_points(const LadderSeries& series, const vnv::Figure& figure) {
  return std::ranges::count_if(series.order->errors, [&](double error) { return is_drawable(error, figure.y); });
}

std::string line_element(const LadderSeries& series, const vnv::Figure& figure) {
  const LineStyle& l = series.style;
  const std::string with = fmt::format("linespoints {} pointtype {} pointsize {:.3g}", l.line(), l.mark, l.size);
  const std::string label = gnuplot_string(shortened(series.label));
  if (drawable_points(series, figure) == 0) return fmt::format("NaN with {} title {}", with, label);
  return fmt::format("{}2:3 with {} title {}", series.data_in(figure.id), with, label);
}

// Bands lie below all lines, so that none hides a point.
std::string plot_command(const std::vector<LadderSeries>& all, const vnv::Figure& figure) {
  std::string elements;
  const auto add = [&](const std::string& element) { elements += (elements.empty() ? "" : ", \\\n     ") + element; };
  for (const auto& s : all)
    if (s.has_band())
      add(s.data_in(figure.id) +
          fmt::format("2:5:6 with filledcurves fillstyle transparent solid 0.18 noborder linecolor rgb '{}' notitle",
                      s.style.colour));
  for (const auto& s : all)
    if (s.has_floor())
      add(s.data_in(figure.id) +
          fmt::format("2:7 with lines dashtype (8,5) linewidth 1.1 linecolor rgb '{}' notitle", s.style.colour));
  for (const auto& s : all) add(line_element(s, figure));
  return "plot " + elements + "\n";
}

/// The guides start below the smallest error at the finest spacing, where errors that decrease leave space.
struct Guides {
  double x = INFINITY, y = INFINITY, end = 0;  // where they start, and where the data end; as the axes show it

  Guides(const std::vector<LadderSeries>& all, const vnv::Figure& figure) {
    for (const auto& series : all)
      for (std::size_t i = 0; i < series.order->spacings.size(); ++i) {
        x = std::min(x, series.order->spacings[i] * figure.x.scale);
        end = std::max(end, series.order->spacings[i] * figure.x.scale);
        for (const double value : {series.order->errors[i], series.order->floor})
          if (is_drawable(value, figure.y)) y = std::min(y, below_data * value);
      }
  }
  bool are_there() const { return x < end && std::isfinite(y); }

  /// Slopes 1 and 2 up to the middle of the axis, each with its name.
  std::string commands() const {
    std::string text;
    const double middle = std::sqrt(x * end);
    for (const int slope : {1, 2}) {
      const double top = y * std::pow(middle / x, slope);
      text += fmt::format(
          "set arrow from first {:.6g},{:.6g} to first {:.6g},{:.6g} nohead back linecolor rgb '#8A8A8A' "
          "linewidth 1.2\nset label '{}' at first {:.6g},{:.6g} left offset 0.4,0 font ',12' textcolor rgb "
          "'#6A6A6A'\n",
          x, y, middle, top, slope, middle, top);
    }
    return text;
  }
};

std::string script(const std::vector<LadderSeries>& all, const vnv::Figure& figure, const Frame& frame) {
  AxisRange x(figure.x), y(figure.y);
  for (const auto& series : all) {
    x.add(series.order->spacings);
    y.add(series.order->errors);
    y.add({series.order->floor});
  }
  const Guides guides(all, figure);
  if (guides.are_there()) y.add({guides.y});
  return frame.commands(figure, x, y) + (guides.are_there() ? guides.commands() : "") + plot_command(all, figure) +
         "set output\n";
}

/// "mpm along grid; sph along spacing", where not all have the same ladder.
std::string ladders(const OrderComparison& comparison) {
  std::vector<std::string> names, methods;  // of each ladder
  for (const auto& line : comparison.lines) {
    const std::size_t place = place_in(names, line.order.ladder);
    methods.resize(names.size());
    methods[place] += (methods[place].empty() ? "" : ", ") + line.method;
  }
  if (names.size() == 1) return fmt::format("Along the ladder “{}”.", names.front());
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += fmt::format("{}{} along “{}”", i == 0 ? "" : "; ", methods[i], names[i]);
  return words + ".";
}

}  // namespace

vnv::Figure order_figure(const OrderComparison& comparison) {
  const std::vector<LadderSeries> all = series_of(comparison);
  std::string caption = fmt::format("{} over the spacing of the particles. {} ",
                                    vnv::with_heading(comparison.subject.quantity).name, ladders(comparison));
  if (std::ranges::any_of(all, &LadderSeries::has_band)) {
    caption += "Bands: the least-squares lines of all orders within the 95 % interval";
    if (!std::ranges::all_of(all, &LadderSeries::has_band))
      caption += fmt::format(", where that is no wider than ± {:g}", widest_band);
    caption += ". ";
  }
  if (std::ranges::any_of(all, &LadderSeries::has_floor))
    caption += "Dashed: the floor that the errors of a method fall to. ";
  return {.id = comparison.id(),
          .title = fmt::format("Observed orders at {:.4g} s", comparison.subject.time),
          .caption = caption + "Grey: slopes 1 and 2.",
          .x = {.label = "particle spacing [mm]", .scale = 1e3, .logarithmic = true},
          .y = {.label = comparison.subject.quantity, .logarithmic = true}};
}

Plot plot_orders(const OrderComparison& comparison) {
  const vnv::Figure figure = order_figure(comparison);
  const std::vector<LadderSeries> all = series_of(comparison);
  std::vector<std::string> labels;
  for (const auto& series : all) labels.push_back(series.label);
  const Frame frame(plot_height, labels);
  Plot plot{figure.id + ".svg", Frame::width, frame.height(), script(all, figure, frame), data(all, figure)};
  for (const auto& series : all) plot.undrawn += std::ssize(series.order->errors) - drawable_points(series, figure);
  return plot;
}

}  // namespace touchstone::reports
