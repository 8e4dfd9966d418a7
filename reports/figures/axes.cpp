#include "reports/figures/axes.hpp"

#include "reports/figures/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::reports {
namespace {

constexpr double most_steps = 8;     // between the ends of a linear axis
constexpr double few_decades = 2.5;  // up to here ticks stand at 1, 2 and 5, beyond at decades only

// Leading digits are 1, 2 or 5, exactly: powers of ten are read, not multiplied.
double tick(int digit, int decade) { return std::stod(fmt::format("{}e{}", digit, decade)); }

int decade_of(double value) { return static_cast<int>(std::floor(std::log10(value))); }

double below(double value) {
  double found = tick(1, decade_of(value) - 1);
  for (const int digit : {1, 2, 5})
    if (tick(digit, decade_of(value)) <= value * (1 + 1e-9)) found = tick(digit, decade_of(value));
  return found;
}

double above(double value) {
  for (int decade = decade_of(value);; ++decade)
    for (const int digit : {1, 2, 5})
      if (tick(digit, decade) >= value * (1 - 1e-9)) return tick(digit, decade);
}

std::string tick_label(int digit, int decade, bool few) {
  if (few && decade >= -4 && decade <= 5) return fmt::format("{:g}", tick(digit, decade));
  const std::string power = fmt::format("10^{{{}{}}}", decade < 0 ? "−" : "", std::abs(decade));
  return digit == 1 ? power : fmt::format("{}×{}", digit, power);
}

std::string logarithmic_ticks(double low, double high) {
  const bool few = std::log10(high / low) < few_decades;
  std::string ticks;
  for (int decade = decade_of(low); decade <= decade_of(high); ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const bool labelled = digit == 1 || (few && (digit == 2 || digit == 5));
      const std::string label = labelled ? tick_label(digit, decade, few) : "";
      ticks += fmt::format("{}'{}' {:g} {}", ticks.empty() ? "" : ", ", label, tick(digit, decade), labelled ? 0 : 1);
    }
  return ticks;
}

std::string logarithmic_commands(const char* name, double low, double high) {
  return range_command(name, low, high) +
         fmt::format("set logscale {0}\nset {0}tics ({1})\n", name, logarithmic_ticks(low, high));
}

// Limits from the data move out to the next tick; a hair beyond a tick, such as -1e-19, counts as on it.
std::string linear_commands(const char* name, const vnv::Axis& axis, double low, double high) {
  const double step = tick_step(high - low, most_steps), hair = 1e-6;
  const double from = axis.low ? low : step * std::floor(low / step + hair) + 0.0;
  const double to = axis.high ? high : step * std::ceil(high / step - hair);
  return range_command(name, from, to) + fmt::format("set {}tics {:.9g}\n", name, step);
}

// A label longer than an axis goes on in a second line, after a comma.
std::string label_in_lines(const std::string& label) {
  constexpr std::size_t most = 50;  // letters
  const auto in_quotes = [](const std::string& text) { return gnuplot_string(gnuplot_label(text)); };
  const std::size_t comma = label.size() > most ? label.rfind(", ", most) : std::string::npos;
  if (comma == std::string::npos) return in_quotes(label);
  return in_quotes(label.substr(0, comma + 1)) + " . \"\\n\" . " + in_quotes(label.substr(comma + 2));
}

}  // namespace

bool is_drawable(double value, const vnv::Axis& axis) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0);
}

void AxisRange::add(const std::vector<double>& si_values) {
  for (const double si : si_values) {
    const double value = si * axis_.scale;
    if (!is_drawable(value, axis_)) continue;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
}

std::pair<double, double> AxisRange::range(double air) const {
  const double low = axis_.low.value_or(is_empty() ? 1 : axis_.logarithmic ? below(low_) : low_);
  const double high = axis_.high.value_or(is_empty() ? 10 : axis_.logarithmic ? above(high_) : high_);
  if (low < high) return {axis_.low ? low : low - air * (high - low), axis_.high ? high : high + air * (high - low)};
  return axis_.logarithmic ? std::pair(low / 2, high * 2) : std::pair(low - 0.5, low + 0.5);
}

double tick_step(double span, double at_most) { return above(span / at_most); }

std::string range_command(const char* name, double low, double high) {
  return fmt::format("set {}range [{:.9g}:{:.9g}]\n", name, low, high);
}

std::string axis_commands(const char* name, const vnv::Axis& axis, const AxisRange& extent) {
  const auto [low, high] = extent.range();
  return fmt::format("set {0}label {1}\n", name, label_in_lines(axis.label)) +
         (axis.logarithmic ? logarithmic_commands(name, low, high) : linear_commands(name, axis, low, high));
}

}  // namespace touchstone::reports
