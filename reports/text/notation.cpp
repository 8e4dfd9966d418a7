#include "reports/text/notation.hpp"

#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace touchstone::reports {
namespace {

std::string with_minus(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

std::string grouped(std::string digits) {
  const int first = digits.starts_with('-') ? 1 : 0;
  for (int i = static_cast<int>(digits.size()) - 3; i > first; i -= 3) digits.insert(i, "\u202f");
  return with_minus(digits);
}

std::string with_power(const std::string& number) {
  const auto e = number.find('e');
  const int power = std::stoi(number.substr(e + 1));
  return fmt::format("{}\u202f×\u202f10^{}", with_minus(number.substr(0, e)), power);
}

// Narrow limits get as many digits as tell them apart.
std::string interval(double lower, double upper) {
  std::string from = plain(lower), to = plain(upper);
  for (int digits = 5; from == to && lower < upper && digits <= 17; ++digits) {
    from = plain(lower, digits);
    to = plain(upper, digits);
  }
  return fmt::format("in [{}, {}]", from, to);
}

}  // namespace

std::string plain(double value, int digits) {
  return std::isnan(value) ? "nan" : fmt::format("{:.{}g}", value, digits);
}
std::string plain_or_empty(double value, int digits) { return std::isnan(value) ? "" : plain(value, digits); }

std::string printed(double value, int digits) {
  if (!std::isfinite(value)) return with_minus(plain(value));
  if (std::abs(value) >= 1e4 && std::abs(value) < 1e7) return grouped(fmt::format("{:.0f}", value));
  const std::string number = plain(value, digits);
  return number.find('e') == std::string::npos ? with_minus(number) : with_power(number);
}

std::string printed(long count) {
  return std::abs(count) < 10000 ? with_minus(std::to_string(count)) : grouped(std::to_string(count));
}

std::string valued(double value, const std::string& unit) {
  return printed(value) + (unit.empty() ? "" : "\u202f" + unit);
}

std::string rounded(double value, const std::string& unit) {
  return valued(std::strtod(fmt::format("{:.2g}", value).c_str(), nullptr), unit);  // also of subnormal numbers
}

std::string in_percent(double fraction) {
  return std::isfinite(fraction) ? printed(std::round(fraction * 100)) + "\u202f%" : printed(fraction);
}

std::string limit(std::optional<double> lower, std::optional<double> upper) {
  if (lower && upper) return interval(*lower, *upper);
  if (upper) return "<= " + plain(*upper);
  if (lower) return ">= " + plain(*lower);
  return "";
}

std::string printed_limit(std::optional<double> lower, std::optional<double> upper) {
  return replaced(replaced(replaced(limit(lower, upper), "<=", "≤"), ">=", "≥"), "-", "−");
}

std::string with_unit(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : fmt::format("{} [{}]", quantity, unit);
}

// Two digits after the point, or up to four so that a narrow interval is not 0.
std::string with_interval(double value, double half_width) {
  const bool narrow = half_width > 0 && half_width < 0.01;
  const int digits = narrow ? std::min(4, static_cast<int>(std::ceil(-std::log10(half_width)))) : 2;
  const std::string middle = with_minus(fmt::format("{:.{}f}", value, digits));
  return std::isfinite(half_width) ? fmt::format("{} ± {:.{}f}", middle, half_width, digits) : middle;
}

std::string sign_and_word(vnv::Trend trend) {
  constexpr std::array signs{"↘", "→", "↗", "?"};  // in the order of the enumerators
  return fmt::format("{}\u00a0{}", signs[static_cast<std::size_t>(trend)], word(trend));
}

std::string counted(long count, const std::string& noun) {
  const bool hisses = noun.ends_with('s');
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : hisses ? "es" : "s");
}

}  // namespace touchstone::reports
