#pragma once
/// What gnuplot is to draw, as text: a script and the data it reads. The same records give the same text.

#include "reports/read/cases.hpp"

#include <string>
#include <string_view>

namespace touchstone::reports {

struct Plot {
  std::string image;          // "profile.svg"
  int width = 0, height = 0;  // as shown on the page, in pixels
  std::string script, data;   // of profile.gp and profile.csv
  long undrawn = 0;           // points that no axis can show: not a number, or not positive on a logarithmic axis
  long covered = 0;           // points that are not drawn since one of another method would cover them
};

/// All curves of the case that name the figure; those of equal label are drawn once.
Plot plot_curves(const vnv::Figure& figure, const CaseRecords& records);

/// All clouds of the case that name the figure, as panels in rows and columns under one colour bar.
Plot plot_clouds(const vnv::Figure& figure, const CaseRecords& records);

/// A text between gnuplot's single quotes, on one line.
std::string gnuplot_string(std::string_view text);

/// An axis label in gnuplot's enhanced text: v_x and 10^-3 get their index and power, mpm_reset stays as it is.
std::string gnuplot_label(std::string_view text);

/// So many rows of the data of a figure from row `first` on, before what gnuplot makes of their columns.
std::string data_rows(const std::string& figure, std::size_t first, std::size_t count);

inline constexpr int data_digits = 9;

/// Where a name stands among those that were met, which it joins if it is new.
std::size_t place_in(std::vector<std::string>& names, const std::string& name);

}  // namespace touchstone::reports
