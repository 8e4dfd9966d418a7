#include "reports/figures/axes.hpp"
#include "reports/figures/plot.hpp"
#include "reports/figures/style.hpp"
#include "reports/read/csv.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace touchstone::reports {
namespace {

using vnv::Role;

constexpr int plot_height = 440;         // px
constexpr std::size_t few_points = 24;   // up to here a line shows its points too
constexpr std::size_t many_points = 60;  // from here on points are drawn smaller

// One curve, and its place among those that look alike: the curves of one method share a colour.
struct CurveSeries {
  const vnv::Curve* curve;
  std::string family;
  std::size_t colour = 0, member = 0;
  bool is_grey = false;
  std::string seen{};  // of points that others would cover: '1' for each that is drawn; empty where all are
};

// What is published takes colours from the end of the palette, and where a method of ours has its colour, none.
std::size_t colour_of_published(const CurveSeries& s) { return palette.size() - 1 - s.colour % palette.size(); }

LineStyle style_of(const CurveSeries& s) {
  const std::size_t turn = s.member + s.colour / palette.size();  // a second round of colours takes other marks
  switch (s.curve->role) {
    case Role::exact:
      return {"#000000", 2, pick(dashes, s.member), 1.1, 0.7};
    case Role::experiment:
      return {"#000000", pick(hollow_marks, s.member), "1", 1.2, 0.9};
    case Role::published:
      return {s.is_grey ? "#5A5A5A" : palette[colour_of_published(s)], pick(hollow_marks, turn), "(7,5)", 1.5, 0.9};
    case Role::guide:
      return {"#8A8A8A", 1, pick(dashes, s.member + 1), 1.2, 0.7};
    case Role::best:
      return {"#000000", 6, "1", 2, 1.3};
    case Role::ours:
      break;
  }
  LineStyle style = style_of_method(s.colour, s.member);
  if (!s.seen.empty()) style = {style.colour, pick(filled_marks, s.colour), "1", 2, 0.75};
  return style;
}

std::vector<CurveSeries> find_series(const vnv::Figure& figure, const CaseRecords& records) {
  std::vector<CurveSeries> all;
  std::set<std::string> labels;
  for_each(records, &vnv::Record::curves, [&](const auto& record, const auto& curve) {
    if (curve.figure == figure.id && labels.insert(curve.label).second)
      all.push_back({&curve, curve.role == Role::ours ? record.method : ""});
  });
  return all;
}

// Colours and members of one role, in order of appearance.
void number_series(std::vector<CurveSeries>& all, Role role) {
  std::vector<std::string> families;
  std::vector<std::size_t> members;
  for (auto& series : all) {
    if (series.curve->role != role) continue;
    series.colour = place_in(families, series.family);
    members.resize(families.size());
    series.member = members[series.colour]++;
  }
  if (families.size() > 1) return;
  for (auto& series : all)  // a family alone can spend the colours on its members
    if (series.curve->role == role) series.colour = series.member;
}

// Back to front: a thin exact line stays visible upon a thick one of ours.
constexpr std::array back_to_front{Role::guide, Role::published, Role::ours, Role::experiment, Role::exact, Role::best};

std::vector<CurveSeries> series_of(const vnv::Figure& figure, const CaseRecords& records) {
  std::vector<CurveSeries> all = find_series(figure, records);
  for (const Role role : back_to_front) number_series(all, role);
  std::size_t ours = 0;
  for (const CurveSeries& s : all)
    if (s.curve->role == Role::ours) ours = std::max(ours, s.colour + 1);
  for (CurveSeries& s : all) s.is_grey = s.curve->role == Role::published && colour_of_published(s) < ours;
  std::ranges::stable_sort(all, {},
                           [](const CurveSeries& s) { return std::ranges::find(back_to_front, s.curve->role); });
  return all;
}

long drawable_points(const vnv::Curve& curve, const vnv::Figure& figure) {
  long count = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    count += is_drawable(curve.x[i], figure.x) && is_drawable(curve.y[i], figure.y);
  return count;
}

std::string with_clause(const CurveSeries& series) {
  const vnv::Curve& curve = *series.curve;
  const LineStyle l = style_of(series);
  const bool is_line = curve.role == Role::exact || curve.role == Role::guide || curve.x.size() > few_points;
  const double size = curve.x.size() < many_points || !series.seen.empty() ? l.size : 0.6 * l.size;
  const std::string points = fmt::format("pointtype {} pointsize {:.3g}", l.mark, size);
  if (curve.points) return fmt::format("points {} linewidth {} linecolor rgb '{}'", points, l.width * 0.6, l.colour);
  return is_line ? "lines " + l.line() : fmt::format("linespoints {} {}", l.line(), points);
}

// `first` is the row of the data at which the curve starts.
std::string element(const CurveSeries& series, const vnv::Figure& figure, std::size_t first) {
  const vnv::Curve& curve = *series.curve;
  const std::string with = with_clause(series), label = shortened(curve.label);
  if (drawable_points(curve, figure) == 0)
    return fmt::format("NaN with {} title {}", with, gnuplot_string(label + " (no finite value)"));
  const std::string y =
      series.seen.empty() ? "3" : fmt::format("('{}'[int($0)+1:int($0)+1] eq '1' ? $3 : NaN)", series.seen);
  return fmt::format("{}2:{} with {} title {}", data_rows(figure.id, first, curve.x.size()), y, with,
                     gnuplot_string(label));
}

std::vector<std::string> labels_of(const std::vector<CurveSeries>& all) {
  std::vector<std::string> labels;
  for (const auto& series : all) labels.push_back(series.curve->label);
  return labels;
}

std::string plot_command(const std::vector<CurveSeries>& all, const vnv::Figure& figure) {
  std::string elements;
  std::size_t row = 0;
  for (const auto& series : all) {
    elements += (row + elements.size() > 0 ? ", \\\n     " : "") + element(series, figure, row);
    row += series.curve->x.size();
  }
  return "plot " + elements + "\n";
}

AxisRange extent_of(const std::vector<CurveSeries>& all, const vnv::Axis& axis,
                    std::vector<double> vnv::Curve::*values) {
  AxisRange extent(axis);
  for (const auto& series : all) extent.add(series.curve->*values);
  return extent;
}

/// Where a value stands on an axis that is so many pixels long.
long pixel(double value, const vnv::Axis& axis, const std::pair<double, double>& range, double length) {
  const auto along = [&](double v) { return axis.logarithmic ? std::log10(v) : v; };
  return std::lround(length * (along(value) - along(range.first)) / (along(range.second) - along(range.first)));
}

/// Of marks that would cover each other one is drawn, of the curve that has had fewest, so that each is seen. What
/// stands apart by more than a line is wide is always drawn.
void choose_seen(std::vector<CurveSeries*> marks, const vnv::Figure& figure, const AxisRange& x, const AxisRange& y) {
  constexpr long near_x = 10, near_y = 2;  // px
  std::size_t longest = 0;
  for (CurveSeries* s : marks) {
    s->seen = std::string(s->curve->x.size(), '0');
    longest = std::max(longest, s->seen.size());
  }
  std::set<std::pair<long, long>> covered;
  const auto count = [](const CurveSeries* s) { return std::ranges::count(s->seen, '1'); };
  for (std::size_t i = 0; i < longest; ++i) {
    if (marks.size() > 1) std::ranges::stable_sort(marks, {}, count);
    for (CurveSeries* s : marks) {
      if (i >= s->seen.size()) continue;
      const double across = s->curve->x[i] * figure.x.scale, up = s->curve->y[i] * figure.y.scale;
      if (!is_drawable(across, figure.x) || !is_drawable(up, figure.y)) continue;
      const long px = pixel(across, figure.x, x.range(), Frame::width),
                 py = pixel(up, figure.y, y.range(), plot_height);
      if (covered.contains({px, py})) continue;
      s->seen[i] = '1';
      for (long dx = -near_x; dx <= near_x; ++dx)
        for (long dy = -near_y; dy <= near_y; ++dy) covered.insert({px + dx, py + dy});
    }
  }
}

/// All methods together, and each dense measurement by itself.
void choose_seen(std::vector<CurveSeries>& all, const vnv::Figure& figure, const AxisRange& x, const AxisRange& y) {
  std::vector<CurveSeries*> ours;
  for (CurveSeries& s : all) {
    if (s.curve->points && s.curve->role == Role::ours) ours.push_back(&s);
    const bool is_measured = s.curve->role == Role::experiment || s.curve->role == Role::published;
    if (s.curve->points && is_measured && s.curve->x.size() >= many_points) choose_seen({&s}, figure, x, y);
  }
  if (ours.size() > 1) choose_seen(ours, figure, x, y);
}

std::string script(std::vector<CurveSeries>& all, const vnv::Figure& figure, const Frame& frame) {
  const AxisRange x = extent_of(all, figure.x, &vnv::Curve::x), y = extent_of(all, figure.y, &vnv::Curve::y);
  choose_seen(all, figure, x, y);
  return frame.commands(figure, x, y) + plot_command(all, figure) + "set output\n";
}

std::string data(const std::vector<CurveSeries>& all, const vnv::Figure& figure) {
  std::string csv = csv_line({"curve", figure.x.label, figure.y.label});
  for (const auto& series : all)
    for (std::size_t i = 0; i < series.curve->x.size(); ++i)
      csv += csv_line({series.curve->label, plain(series.curve->x[i] * figure.x.scale, data_digits),
                       plain(series.curve->y[i] * figure.y.scale, data_digits)});
  return csv;
}

}  // namespace

Plot plot_curves(const vnv::Figure& figure, const CaseRecords& records) {
  std::vector<CurveSeries> all = series_of(figure, records);
  const Frame frame(plot_height, labels_of(all));
  Plot plot{figure.id + ".svg", Frame::width, frame.height(), script(all, figure, frame), data(all, figure)};
  for (const auto& series : all) {
    const long drawable = drawable_points(*series.curve, figure);
    plot.undrawn += static_cast<long>(series.curve->x.size()) - drawable;
    if (!series.seen.empty()) plot.covered += drawable - std::ranges::count(series.seen, '1');
  }
  return plot;
}

}  // namespace touchstone::reports
