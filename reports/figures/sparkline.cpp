#include "reports/figures/sparkline.hpp"

#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::reports {
namespace {

constexpr double width = 100, height = 30, margin = 3;

bool is_drawn(const SeriesPoint& point) { return point.is_there && std::isfinite(point.value); }

/// From night and value to a place in the picture.
class Scale {
 public:
  explicit Scale(const Series& series) : nights_(series.points.size()) {
    double low = INFINITY, high = -INFINITY;
    for (const auto& point : series.points)
      if (is_drawn(point)) {
        low = std::min(low, point.value);
        high = std::max(high, point.value);
      }
    logarithmic_ = low > 0 && high > 10 * low;
    low_ = along(low);
    high_ = along(high);
  }

  double x(std::size_t night) const {
    if (nights_ < 2) return width / 2;
    return margin + (width - 2 * margin) * static_cast<double>(night) / static_cast<double>(nights_ - 1);
  }
  double y(double value) const {
    if (!(high_ - low_ > 1e-9 * std::max(std::abs(low_), std::abs(high_)))) return height / 2;
    return height - margin - (height - 2 * margin) * (along(value) - low_) / (high_ - low_);
  }
  bool shows(double value) const { return (!logarithmic_ || value > 0) && along(value) > low_ && along(value) < high_; }

 private:
  double along(double value) const { return logarithmic_ ? std::log10(value) : value; }

  std::size_t nights_;
  bool logarithmic_;
  double low_, high_;
};

/// The line breaks where a night has no number.
std::string line(const Series& series, const Scale& scale) {
  std::string path;
  bool goes_on = false;
  for (std::size_t n = 0; n < series.points.size(); ++n) {
    const SeriesPoint& point = series.points[n];
    if (is_drawn(point)) path += fmt::format("{}{:.4g} {:.3g}", goes_on ? 'L' : 'M', scale.x(n), scale.y(point.value));
    goes_on = is_drawn(point);
  }
  return fmt::format("<path class=\"line\" d=\"{}\"/>", path);
}

/// Marks of no length, which round caps make dots.
std::string dots(const Series& series, const Scale& scale, bool failing) {
  std::string path;
  for (std::size_t n = 0; n < series.points.size(); ++n)
    if (const SeriesPoint& point = series.points[n]; is_drawn(point) && point.fails == failing)
      path += fmt::format("M{:.4g} {:.3g}h0", scale.x(n), scale.y(point.value));
  return path.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", failing ? "dots fails" : "dots", path);
}

/// Crosses at the foot, for what is no number.
std::string crosses(const Series& series, const Scale& scale) {
  std::string path;
  for (std::size_t n = 0; n < series.points.size(); ++n)
    if (series.points[n].is_there && !is_drawn(series.points[n]))
      path += fmt::format("M{:.4g} 25l3 3m0-3l-3 3", scale.x(n) - 1.5);
  return path.empty() ? "" : fmt::format("<path class=\"nan\" d=\"{}\"/>", path);
}

std::string limits(const Series& series, const Scale& scale) {
  std::string path;
  for (const auto& limit : {series.lower, series.upper})
    if (limit && scale.shows(*limit)) path += fmt::format("M0 {:.3g}H{}", scale.y(*limit), width);
  return path.empty() ? "" : fmt::format("<path class=\"limit\" d=\"{}\"/>", path);
}

std::string steps(const Series& series, const Scale& scale) {
  std::string path;
  for (const Step& step : series.steps) path += fmt::format("M{:.4g} 0V{}", scale.x(step.night), height);
  return path.empty() ? "" : fmt::format("<path class=\"step\" d=\"{}\"/>", path);
}

}  // namespace

std::string sparkline(const Series& series) {
  const Scale scale(series);
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{}\">{}{}{}{}{}{}</svg>",
      width, height, escape(series.quantity), steps(series, scale), limits(series, scale), line(series, scale),
      dots(series, scale, false), dots(series, scale, true), crosses(series, scale));
}

}  // namespace touchstone::reports
