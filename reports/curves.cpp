#include "reports/axes.hpp"
#include "reports/csv.hpp"
#include "reports/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace touchstone::reports {
namespace {

using vnv::Role;

constexpr int width = 800, plot_height = 440, key_row = 20, sample_width = 48;  // px
constexpr double letter_width = 6.7;                                            // px
constexpr double overestimate = 0.1;                                            // of the width of a letter, by gnuplot
constexpr std::size_t most_letters = 80;                                        // letters
constexpr std::size_t few_points = 24;   // up to here a line shows its points too
constexpr std::size_t many_points = 60;  // from here on points are drawn smaller

// Okabe & Ito (2008), "Color universal design", without black, kept for truth, and yellow, too pale on white.
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"};
constexpr std::array filled_marks{7, 5, 9, 13, 11, 15};  // circle, square, triangle, diamond, ...
constexpr std::array hollow_marks{6, 4, 8, 12, 10, 14};
constexpr std::array dashes{"1", "(12,5)", "(3,4)", "(12,4,3,4)", "(20,6)", "(7,3,2,3,2,3)"};

template <class Array>
auto pick(const Array& array, std::size_t i) {
  return array[i % array.size()];
}

// One curve, and its place among those that look alike: the curves of one method share a colour.
struct Series {
  const vnv::Curve* curve;
  std::string family;
  std::size_t colour = 0, member = 0;
};

struct Look {
  const char* colour;
  int mark;
  const char* dash;
  double width, size;
};

Look look(const Series& s) {
  const std::size_t turn = s.member + s.colour / palette.size();  // a second round of colours takes other marks
  switch (s.curve->role) {
    case Role::exact:
      return {"#000000", 2, pick(dashes, s.member), 1.1, 0.7};
    case Role::experiment:
      return {"#000000", pick(hollow_marks, s.member), "1", 1.2, 0.9};
    case Role::published:
      return {pick(palette, palette.size() - 1 - s.colour % palette.size()), pick(hollow_marks, turn), "(7,5)", 1.5,
              0.9};
    case Role::guide:
      return {"#8A8A8A", 1, pick(dashes, s.member + 1), 1.2, 0.7};
    case Role::best:
      return {"#000000", 6, "1", 2, 1.3};
    case Role::ours:
      break;
  }
  const double size =
      std::max(0.5, 0.9 - 0.15 * static_cast<double>(s.colour));  // equal points lie upon each other, seen
  return {pick(palette, s.colour), pick(filled_marks, turn), pick(dashes, turn), 2, size};
}

std::vector<Series> find_series(const vnv::Figure& figure, const CaseRecords& records) {
  std::vector<Series> all;
  std::set<std::string> labels;
  for (const auto& record : records.records)
    for (const auto& curve : record.curves)
      if (curve.figure == figure.id && labels.insert(curve.label).second)
        all.push_back({&curve, curve.role == Role::ours ? record.method : ""});
  return all;
}

// Colours and members of one role, in order of appearance.
void number_series(std::vector<Series>& all, Role role) {
  std::vector<std::string> families;
  std::vector<std::size_t> members;
  for (auto& series : all) {
    if (series.curve->role != role) continue;
    series.colour = std::find(families.begin(), families.end(), series.family) - families.begin();
    if (series.colour == families.size()) {
      families.push_back(series.family);
      members.push_back(0);
    }
    series.member = members[series.colour]++;
  }
  if (families.size() > 1) return;
  for (auto& series : all)  // a family alone can spend the colours on its members
    if (series.curve->role == role) series.colour = series.member;
}

// Back to front: a thin exact line stays visible upon a thick one of ours.
constexpr std::array back_to_front{Role::guide, Role::published, Role::ours, Role::experiment, Role::exact, Role::best};

std::vector<Series> series_of(const vnv::Figure& figure, const CaseRecords& records) {
  std::vector<Series> all = find_series(figure, records);
  for (const Role role : back_to_front) number_series(all, role);
  const auto depth = [](const Series& s) {
    return std::find(back_to_front.begin(), back_to_front.end(), s.curve->role);
  };
  std::stable_sort(all.begin(), all.end(), [&](const Series& a, const Series& b) { return depth(a) < depth(b); });
  return all;
}

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }  // of UTF-8

std::size_t letters(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char byte) { return !is_continuation(byte); });
}

std::string shortened(std::string label) {
  if (letters(label) <= most_letters) return label;
  while (letters(label) >= most_letters) label.pop_back();
  while (!label.empty() && is_continuation(label.back())) label.pop_back();
  return label + "…";
}

long drawable_points(const vnv::Curve& curve, const vnv::Figure& figure) {
  long count = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    count += is_drawable(curve.x[i], figure.x) && is_drawable(curve.y[i], figure.y);
  return count;
}

std::string style(const vnv::Curve& curve, const Look& l) {
  const bool is_line = curve.role == Role::exact || curve.role == Role::guide || curve.x.size() > few_points;
  const double size = curve.x.size() < many_points ? l.size : 0.6 * l.size;
  const std::string line = fmt::format("dashtype {} linewidth {} linecolor rgb '{}'", l.dash, l.width, l.colour);
  const std::string points = fmt::format("pointtype {} pointsize {:.3g}", l.mark, size);
  if (curve.points) return fmt::format("points {} linewidth {} linecolor rgb '{}'", points, l.width * 0.6, l.colour);
  return is_line ? "lines " + line : fmt::format("linespoints {} {}", line, points);
}

// `first` is the row of the data at which the curve starts.
std::string element(const Series& series, const vnv::Figure& figure, std::size_t first) {
  const vnv::Curve& curve = *series.curve;
  const std::string with = style(curve, look(series)), label = shortened(curve.label);
  if (drawable_points(curve, figure) == 0)
    return fmt::format("NaN with {} title {}", with, gnuplot_string(label + " (no finite value)"));
  return fmt::format("'{}.csv' skip 1 every ::{}::{} using 2:3 with {} title {}", figure.id, first,
                     first + curve.x.size() - 1, with, gnuplot_string(label));
}

std::size_t longest_label(const std::vector<Series>& all) {
  std::size_t longest = 1;
  for (const auto& series : all) longest = std::max(longest, letters(shortened(series.curve->label)));
  return longest;
}

// So many that the entries of one method can stand below each other.
std::size_t key_rows(const std::vector<Series>& all) {
  const double entry = static_cast<double>(longest_label(all)) * letter_width + sample_width;
  const auto columns =
      std::clamp<std::size_t>(static_cast<std::size_t>(width / entry), 1, std::max<std::size_t>(1, all.size()));
  return (all.size() + columns - 1) / columns;
}

std::string plot_command(const std::vector<Series>& all, const vnv::Figure& figure) {
  std::string elements;
  std::size_t row = 0;
  for (const auto& series : all) {
    elements += (row + elements.size() > 0 ? ", \\\n     " : "") + element(series, figure, row);
    row += series.curve->x.size();
  }
  return "plot " + elements + "\n";
}

Extent extent_of(const std::vector<Series>& all, const vnv::Axis& axis, std::vector<double> vnv::Curve::*values) {
  Extent extent(axis);
  for (const auto& series : all) extent.add(series.curve->*values);
  return extent;
}

std::string script(const std::vector<Series>& all, const vnv::Figure& figure, int height) {
  const Extent x = extent_of(all, figure.x, &vnv::Curve::x), y = extent_of(all, figure.y, &vnv::Curve::y);
  std::string text =
      fmt::format(R"(# Redraws {0}.svg from {0}.csv: gnuplot {0}.gp
if (!exists("image")) image = '{0}.svg'
set encoding utf8
set terminal svg size {1},{2} dynamic enhanced font 'sans-serif,13' background '#ffffff'
set output image
set datafile separator comma
set minussign
set border 3 linecolor rgb '#333333'
set tics out nomirror scale 0.75,0.4 textcolor rgb '#111111'
set grid xtics ytics linetype 1 linecolor rgb '#DDDDDD' linewidth 0.8
set key below center vertical maxrows {3} Left reverse noenhanced samplen 2.6 spacing 1.15 height 1 font ',12' width {4:.1f}
)",
                  figure.id, width, height, key_rows(all), -overestimate * static_cast<double>(longest_label(all)));
  text += axis_commands("x", figure.x, x) + axis_commands("y", figure.y, y);
  if (figure.equal_axes) text += "set size ratio -1\n";
  if (x.is_empty() || y.is_empty()) text += "set label 'no finite value to draw' at graph 0.5,0.5 center\n";
  return text + plot_command(all, figure) + "set output\n";
}

std::string data(const std::vector<Series>& all, const vnv::Figure& figure) {
  std::string csv = csv_line({"curve", figure.x.label, figure.y.label});
  for (const auto& series : all)
    for (std::size_t i = 0; i < series.curve->x.size(); ++i)
      csv += csv_line({series.curve->label, gnuplot_number(series.curve->x[i] * figure.x.scale),
                       gnuplot_number(series.curve->y[i] * figure.y.scale)});
  return csv;
}

}  // namespace

Plot plot_curves(const vnv::Figure& figure, const CaseRecords& records) {
  const std::vector<Series> all = series_of(figure, records);
  const int height = plot_height + key_row * static_cast<int>(key_rows(all));
  Plot plot{figure.id + ".svg", width, height, script(all, figure, height), data(all, figure)};
  for (const auto& series : all)
    plot.undrawn += static_cast<long>(series.curve->x.size()) - drawable_points(*series.curve, figure);
  return plot;
}

}  // namespace touchstone::reports
