#include "reports/figures/axes.hpp"
#include "reports/figures/isolines.hpp"
#include "reports/figures/plot.hpp"
#include "reports/read/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace touchstone::reports {
namespace {

constexpr int width = 760;                                                              // px
constexpr int left = 72, right = 12, top = 42, gap_x = 18, gap_y = 30, axis_band = 52;  // px  around the panels
constexpr int bar_bottom = 46, bar_height = 11, bar_band = 70;  // px  the colour bar and its labels
constexpr double tallest_panel = 560;                           // px
constexpr double default_ratio = 0.62;                          // height to width of a panel
constexpr double tick_width = 30, tick_height = 24;             // px  that a label of an axis takes at least
constexpr double most_ticks = 8;

// Viridis by Smith & van der Walt (2015): even to the eye, and in grey, and to the colour-blind.
constexpr auto colour_map =
    "set palette defined (0 '#440154', 0.125 '#472D7B', 0.25 '#3B528B', 0.375 '#2C728E', 0.5 '#21918C', "
    "0.625 '#28AE80', 0.75 '#5EC962', 0.875 '#ADDC30', 1 '#FDE725')\n";

struct Panel {
  const vnv::Cloud* cloud;
  std::size_t column = 0, row = 0;
  std::size_t first = 0;  // its first row in the data
  std::vector<IsolinePiece> lines{};
  std::size_t first_of_lines = 0;
};

// Panels, their grid, and the axes that all share.
struct Panels {
  std::vector<Panel> all;
  std::vector<std::string> columns, rows;
  AxisRange x, y, colour;

  Panels(const vnv::Figure& figure, const CaseRecords& records) : x(figure.x), y(figure.y), colour(figure.colour) {
    for_each(records, &vnv::Record::clouds, [&](const auto&, const auto& cloud) {
      if (cloud.figure == figure.id) add(cloud);
    });
  }

 private:
  void add(const vnv::Cloud& cloud) {
    const Panel panel{&cloud, place_in(columns, cloud.column), place_in(rows, cloud.row), next_row_};
    const auto stands_there = [&](const Panel& p) { return p.column == panel.column && p.row == panel.row; };
    if (std::ranges::any_of(all, stands_there)) return;
    all.push_back(panel);
    next_row_ += cloud.x.size();
    x.add(cloud.x);
    y.add(cloud.y);
    colour.add(cloud.colour);
  }
  std::size_t next_row_ = 0;
};

// A little air, so that particles at a wall are seen whole.
std::pair<double, double> aired(const AxisRange& extent) { return extent.range(0.02); }

double span(const AxisRange& extent) { return aired(extent).second - aired(extent).first; }
std::string aired_range(const char* name, const AxisRange& extent) {
  return range_command(name, aired(extent).first, aired(extent).second);
}

// Where everything stands, in pixels from the lower left corner.
struct Layout {
  double panel_width, panel_height;
  int height;

  Layout(const Panels& panels, const vnv::Figure& figure) {
    const auto columns = static_cast<double>(panels.columns.size()), rows = static_cast<double>(panels.rows.size());
    panel_width = (width - left - right - gap_x * (columns - 1)) / columns;
    const double ratio = figure.equal_axes ? span(panels.y) / span(panels.x) : default_ratio;
    panel_width = std::min(panel_width, tallest_panel / ratio);
    panel_height = panel_width * ratio;
    height = static_cast<int>(std::ceil(top + rows * panel_height + (rows - 1) * gap_y + axis_band + bar_band));
  }
  double left_of(const Panel& p) const { return left + static_cast<double>(p.column) * (panel_width + gap_x); }
  double top_of(const Panel& p) const { return height - top - static_cast<double>(p.row) * (panel_height + gap_y); }
};

// The side [px] of the square that a particle stands for, from the area that the cloud covers.
double particle_size(const vnv::Cloud& cloud, const Panels& panels, const Layout& layout, const vnv::Figure& figure) {
  const double count = static_cast<double>(std::max<std::size_t>(1, cloud.x.size()));
  const double bin = std::sqrt(8 * layout.panel_width * layout.panel_height / count);  // px
  std::set<std::pair<long, long>> covered;
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    const double x = cloud.x[i] * figure.x.scale, y = cloud.y[i] * figure.y.scale;
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    covered.insert({std::lround(x / span(panels.x) * layout.panel_width / bin),
                    std::lround(y / span(panels.y) * layout.panel_height / bin)});
  }
  return bin * std::sqrt(static_cast<double>(covered.size()) / count);
}

// Lines of equal colour, where the figure has them, after all particles in the data.
void add_lines(Panels& panels, const Layout& layout, const vnv::Figure& figure) {
  std::size_t next = 0;
  for (const Panel& panel : panels.all) next += panel.cloud->x.size();
  for (Panel& panel : panels.all) {
    const double spacing =
        particle_size(*panel.cloud, panels, layout, figure) * span(panels.x) / layout.panel_width / figure.x.scale;
    panel.lines = isolines(*panel.cloud, figure.isolines / figure.colour.scale, spacing);
    panel.first_of_lines = next;
    next += panel.lines.size();
  }
}

// The row, and above the uppermost the column.
std::string title_of(const Panel& panel) {
  const std::string row = gnuplot_string(panel.cloud->row);
  return panel.row == 0 ? gnuplot_string(panel.cloud->column) + " . \"\\n\" . " + row : row;
}

std::string panel_commands(const Panel& panel, const Panels& panels, const Layout& layout, const vnv::Figure& figure) {
  const bool is_lowest = panel.row + 1 == panels.rows.size();
  const double l = layout.left_of(panel), t = layout.top_of(panel);
  const auto across = [](double px) { return px / width; };  // fractions of the figure
  const auto up = [&](double px) { return px / layout.height; };
  std::string commands = fmt::format("set margins at screen {:.6f}, screen {:.6f}, screen {:.6f}, screen {:.6f}\n",
                                     across(l), across(l + layout.panel_width), up(t - layout.panel_height), up(t));
  commands += fmt::format("set title {} noenhanced offset 0,-0.6\n", title_of(panel));
  commands += fmt::format("set xlabel {} offset 0,0.3\nset format x '{}'\n",
                          gnuplot_string(is_lowest ? gnuplot_label(figure.x.label) : ""), is_lowest ? "%g" : "");
  commands += fmt::format("set ylabel {}\nset format y '{}'\n",
                          gnuplot_string(panel.column == 0 ? gnuplot_label(figure.y.label) : ""),
                          panel.column == 0 ? "%g" : "");
  const double size = std::clamp(particle_size(*panel.cloud, panels, layout, figure) / 5, 0.05, 1.5);
  commands += "plot " + data_rows(figure.id, panel.first, panel.cloud->x.size()) +
              fmt::format("2:3:4 with points pointtype 7 pointsize {:.3g} linecolor palette notitle", size);
  if (!panel.lines.empty())
    commands += ", \\\n     " + data_rows(figure.id, panel.first_of_lines, panel.lines.size()) +
                "2:3:($5-$2):($6-$3) with vectors nohead linewidth 0.6 linecolor rgb '#FFFFFF' notitle";
  return commands + "\n";
}

// One bar under all panels; it is drawn with the first and then switched off.
std::string bar_command(const Layout& layout) {
  return fmt::format("set colorbox horizontal user origin screen {:.6f},{:.6f} size screen {:.6f},{:.6f} noborder\n",
                     0.25, bar_bottom / static_cast<double>(layout.height), 0.5,
                     bar_height / static_cast<double>(layout.height));
}

std::string script(const Panels& panels, const Layout& layout, const vnv::Figure& figure) {
  std::string text = fmt::format(R"(# Redraws {0}.png from {0}.csv: gnuplot {0}.gp
if (!exists("image")) image = '{0}.png'
set encoding utf8
set terminal pngcairo size {1},{2} enhanced font 'sans,10' fontscale 2 linewidth 2 pointscale 2 background '#ffffff'
if (exists("paper")) set terminal pdfcairo size {1}/192.,{2}/192. enhanced font 'sans,10'
set output image
set datafile separator comma
set minussign
set border 15 linecolor rgb '#333333' linewidth 0.8
set tics out nomirror scale 0.5 textcolor rgb '#111111'
)",
                                 figure.id, 2 * width, 2 * layout.height);
  text += colour_map + aired_range("x", panels.x) + aired_range("y", panels.y);
  text += fmt::format("set xtics {:g}\nset ytics {:g}\n",
                      tick_step(span(panels.x), std::min(most_ticks, layout.panel_width / tick_width)),
                      tick_step(span(panels.y), std::min(most_ticks, layout.panel_height / tick_height)));
  const auto [lowest, highest] = panels.colour.range();
  text += axis_commands("cb", figure.colour, panels.colour) + range_command("cb", lowest, highest);
  text += "set cblabel offset 0,0.4\nset multiplot\n" + bar_command(layout);
  for (const auto& panel : panels.all) {
    text += panel_commands(panel, panels, layout, figure);
    if (&panel == &panels.all.front()) text += "unset colorbox\n";
  }
  return text + "unset multiplot\nset output\n";
}

std::string data(const Panels& panels, const vnv::Figure& figure) {
  std::vector<std::string> columns{"panel", figure.x.label, figure.y.label, figure.colour.label};
  if (figure.isolines > 0) columns.insert(columns.end(), {"line to " + figure.x.label, "line to " + figure.y.label});
  std::string csv = csv_line(columns);
  const std::string no_line = figure.isolines > 0 ? ",," : "";
  for (const auto& panel : panels.all) {
    const vnv::Cloud& cloud = *panel.cloud;
    for (std::size_t i = 0; i < cloud.x.size(); ++i)
      csv += fmt::format("{},{:.5g},{:.5g},{:.4g}{}\n", csv_field(cloud.column + ", " + cloud.row),
                         cloud.x[i] * figure.x.scale, cloud.y[i] * figure.y.scale,
                         cloud.colour[i] * figure.colour.scale, no_line);
  }
  for (const auto& panel : panels.all)
    for (const IsolinePiece& line : panel.lines)
      csv += fmt::format("{},{:.5g},{:.5g},{:.4g},{:.5g},{:.5g}\n",
                         csv_field(panel.cloud->column + ", " + panel.cloud->row + ", isoline"),
                         line.x * figure.x.scale, line.y * figure.y.scale, line.level * figure.colour.scale,
                         line.to_x * figure.x.scale, line.to_y * figure.y.scale);
  return csv;
}

long undrawn(const Panels& panels, const vnv::Figure& figure) {
  long count = 0;
  for (const auto& panel : panels.all)
    for (std::size_t i = 0; i < panel.cloud->x.size(); ++i)
      count += !is_drawable(panel.cloud->x[i], figure.x) || !is_drawable(panel.cloud->y[i], figure.y) ||
               !is_drawable(panel.cloud->colour[i], figure.colour);
  return count;
}

}  // namespace

Plot plot_clouds(const vnv::Figure& figure, const CaseRecords& records) {
  Panels panels(figure, records);
  const Layout layout(panels, figure);
  if (figure.isolines > 0) add_lines(panels, layout, figure);
  return {figure.id + ".png",     width, layout.height, script(panels, layout, figure), data(panels, figure),
          undrawn(panels, figure)};
}

}  // namespace touchstone::reports
