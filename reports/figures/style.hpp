#pragma once
/// What all figures of curves share: colours and marks, the frame, and the key below it.

#include "reports/figures/axes.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace touchstone::reports {

// Okabe & Ito (2008), "Color universal design", without black, kept for truth, and yellow, too pale on white.
inline constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"};
inline constexpr std::array filled_marks{7, 5, 9, 13, 11, 15};  // circle, square, triangle, diamond, ...
inline constexpr std::array hollow_marks{6, 4, 8, 12, 10, 14};
inline constexpr std::array dashes{"1", "(12,5)", "(3,4)", "(12,4,3,4)", "(20,6)", "(7,3,2,3,2,3)"};

template <class Array>
auto pick(const Array& array, std::size_t i) {
  return array[i % array.size()];
}

struct LineStyle {
  const char* colour;
  int mark;
  const char* dash;
  double width, size;

  /// As gnuplot has it: "dashtype 1 linewidth 2 linecolor rgb '#0072B2'".
  std::string line() const;
};

/// Methods differ in colour, the curves of one method in mark and dash.
LineStyle style_of_method(std::size_t method, std::size_t member);

/// A label as the key shows it, cut where it would take more than a line.
std::string shortened(std::string label);

/// A plot with its key below, as wide as all are.
class Frame {
 public:
  static constexpr int width = 800;  // px

  /// `plot_height` [px] is what the key does not take.
  Frame(int plot_height, const std::vector<std::string>& labels);

  int height() const { return height_; }  // px

  /// All that stands before the plot command.
  std::string commands(const vnv::Figure& figure, const AxisRange& x, const AxisRange& y) const;

 private:
  std::size_t longest_label_ = 1, key_rows_ = 1;
  int height_;
};

}  // namespace touchstone::reports
