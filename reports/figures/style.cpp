#include "reports/figures/style.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

constexpr int key_row = 20, sample_width = 72;  // px
constexpr double letter_width = 6.7;            // px
constexpr double overestimate = 0.1;            // of the width of a letter, by gnuplot
constexpr std::size_t most_letters = 80;        // letters

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }  // of UTF-8

std::size_t letters(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char byte) { return !is_continuation(byte); });
}

}  // namespace

std::string LineStyle::line() const {
  return fmt::format("dashtype {} linewidth {} linecolor rgb '{}'", dash, width, colour);
}

LineStyle style_of_method(std::size_t method, std::size_t member) {
  const std::size_t turn = member + method / palette.size();  // a second round of colours takes other marks
  const double size =
      std::max(0.5, 0.9 - 0.15 * static_cast<double>(method));  // equal points lie upon each other, seen
  return {pick(palette, method), pick(filled_marks, turn), pick(dashes, turn), 2, size};
}

std::string shortened(std::string label) {
  if (letters(label) <= most_letters) return label;
  while (letters(label) >= most_letters) label.pop_back();
  while (!label.empty() && is_continuation(label.back())) label.pop_back();
  return label + "…";
}

// So many rows that the entries of one method can stand below each other.
Frame::Frame(int plot_height, const std::vector<std::string>& labels) {
  for (const auto& label : labels) longest_label_ = std::max(longest_label_, letters(shortened(label)));
  const double entry = static_cast<double>(longest_label_) * letter_width + sample_width;
  const auto columns =
      std::clamp<std::size_t>(static_cast<std::size_t>(width / entry), 1, std::max<std::size_t>(1, labels.size()));
  key_rows_ = (labels.size() + columns - 1) / columns;
  height_ = plot_height + key_row * static_cast<int>(key_rows_);
}

std::string Frame::commands(const vnv::Figure& figure, const AxisRange& x, const AxisRange& y) const {
  std::string text =
      fmt::format(R"(# Redraws {0}.svg from {0}.csv: gnuplot {0}.gp
if (!exists("image")) image = '{0}.svg'
set encoding utf8
set terminal svg size {1},{2} dynamic enhanced font 'sans-serif,13' background '#ffffff'
if (exists("raster")) set terminal pngcairo size {1},{2} enhanced font 'sans,10' background '#ffffff'
if (exists("paper")) set terminal pdfcairo size {1}/96.,{2}/96. enhanced font 'sans,13'
set output image
set datafile separator comma
set minussign
set border 3 linecolor rgb '#333333'
set tics out nomirror scale 0.75,0.4 textcolor rgb '#111111'
set grid xtics ytics linetype 1 linecolor rgb '#DDDDDD' linewidth 0.8
set key below center vertical maxrows {3} Left reverse noenhanced samplen 2.6 spacing 1.15 height 1 font ',12' width {4:.1f}
)",
                  figure.id, width, height_, key_rows_, -overestimate * static_cast<double>(longest_label_));
  text += axis_commands("x", figure.x, x) + axis_commands("y", figure.y, y);
  if (figure.equal_axes) text += "set size ratio -1\n";
  if (x.is_empty() || y.is_empty()) text += "set label 'no finite value to draw' at graph 0.5,0.5 center\n";
  return text;
}

}  // namespace touchstone::reports
