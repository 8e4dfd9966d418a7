#include "reports/figures/sparkline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::reports {
namespace {

constexpr double width = 100, height = 30, margin = 3;

/// From night and value to a place in the picture.
class Scale {
 public:
  explicit Scale(const Series& series) : nights_(series.points.size()) {
    const auto [low, high] = series.range();
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

/// A path of what `marks` says of each night.
SparklinePath path(const char* kind, const Series& series, const auto& marks) {
  std::string drawn;
  for (std::size_t n = 0; n < series.points.size(); ++n) drawn += marks(n, series.points[n]);
  return {kind, drawn};
}

/// The line breaks where a night has no number.
SparklinePath line(const Series& series, const Scale& scale) {
  bool goes_on = false;
  return path("line", series, [&](std::size_t n, const SeriesPoint& point) -> std::string {
    const bool continues = std::exchange(goes_on, point.is_finite());
    return goes_on ? fmt::format("{}{:.4g} {:.3g}", continues ? 'L' : 'M', scale.x(n), scale.y(point.value)) : "";
  });
}

/// Marks of no length, which round caps make dots.
SparklinePath dots(const Series& series, const Scale& scale, bool failing) {
  return path(failing ? "dots fails" : "dots", series, [&](std::size_t n, const SeriesPoint& point) -> std::string {
    if (!point.is_finite() || point.fails != failing) return "";
    return fmt::format("M{:.4g} {:.3g}h0", scale.x(n), scale.y(point.value));
  });
}

/// Crosses at the foot, for what is no number.
SparklinePath crosses(const Series& series, const Scale& scale) {
  return path("nan", series, [&](std::size_t n, const SeriesPoint& point) -> std::string {
    return point.is_there && !point.is_finite() ? fmt::format("M{:.4g} 25l3 3m0-3l-3 3", scale.x(n) - 1.5) : "";
  });
}

SparklinePath limits(const Series& series, const Scale& scale) {
  std::string drawn;
  for (const auto& limit : {series.lower, series.upper})
    if (limit && scale.shows(*limit)) drawn += fmt::format("M0 {:.3g}H{}", scale.y(*limit), width);
  return {"limit", drawn};
}

SparklinePath steps(const Series& series, const Scale& scale) {
  return path("step", series, [&](std::size_t n, const SeriesPoint&) -> std::string {
    const bool is_step = std::ranges::find(series.steps, n, &Step::night) != series.steps.end();
    return is_step ? fmt::format("M{:.4g} 0V{}", scale.x(n), height) : "";
  });
}

}  // namespace

std::vector<SparklinePath> sparkline(const Series& series) {
  const Scale scale(series);
  std::vector<SparklinePath> paths{steps(series, scale),       limits(series, scale),     line(series, scale),
                                   dots(series, scale, false), dots(series, scale, true), crosses(series, scale)};
  std::erase_if(paths, [](const SparklinePath& path) { return path.d.empty(); });
  return paths;
}

}  // namespace touchstone::reports
