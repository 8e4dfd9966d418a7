#include "vnv/doors/diagnosis/words.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::doors::diagnosis {

namespace {

/// How a cause is said: with its value, whose sign chooses the words.
struct Phrases {
  std::string_view name, unit, where_positive, where_negative;
};
/// In the order of causes.
constexpr std::array<Phrases, 12> phrases{{
    {"viscosity", "%", "the flow is that of a fluid {} too viscous",
     "the flow is that of a fluid {} less viscous than it should be"},
    {"force", "%", "the flow is that of a body force {} too strong", "the flow is that of a body force {} too weak"},
    {"gravity", "%", "gravity is {} too strong", "gravity is {} too weak"},
    {"sound speed", "%", "the speed of sound is {} too high", "the speed of sound is {} too low"},
    {"lower wall", "spacings", "the lower wall stands {} too far out", "the lower wall stands {} too far in"},
    {"upper wall", "spacings", "the upper wall stands {} too far out", "the upper wall stands {} too far in"},
    {"both walls", "spacings", "both walls stand {} too far out", "both walls stand {} too far in"},
    {"slip length", "spacings", "the fluid slips along its walls with a slip length of {}", ""},
    {"time", "s", "the flow is {} ahead", "the flow is {} late"},
    {"amplitude", "%", "the velocity is {} too large", "the velocity is {} too small"},
    {"mean along x", "%", "a mean velocity of {} of the root mean square is added along x",
     "a mean velocity of {} of the root mean square is added against x"},
    {"mean along y", "%", "a mean velocity of {} of the root mean square is added along y",
     "a mean velocity of {} of the root mean square is added against y"},
}};
constexpr Phrases amplitude_of_pressure{"amplitude", "%", "the pressure is {} too large",
                                        "the pressure is {} too small"},
    mean_of_pressure{"mean", "%", "a pressure of {} of its root mean square is added everywhere",
                     "a pressure of {} of its root mean square is missing everywhere"};

Phrases phrases_of(Cause cause, const FieldVector& seen) {
  const bool is_pressure = seen.field() == "pressure";
  if (cause >= Cause::parameter) return {seen.parameter(cause), "%", "{1} is {0} too large", "{1} is {0} too small"};
  if (is_pressure && cause == Cause::amplitude) return amplitude_of_pressure;
  if (is_pressure && cause == Cause::mean_x) return mean_of_pressure;
  return phrases[static_cast<std::size_t>(cause)];
}

bool is_of_mean(Cause cause) { return cause == Cause::mean_x || cause == Cause::mean_y; }

Explanation noise_of(const FieldVector& seen, double noise_squared) {
  const auto numbers = static_cast<double>(seen.error().size());
  const double size = 100 * std::sqrt(noise_squared / seen.times());
  return {.causes = {{"noise", "%", size, 1.96 * size / std::sqrt(2 * numbers)}},
          .share = std::min(1.0, noise_squared / seen.squared_error())};
}

/// Its sign is in the words.
std::string quantity(const FittedCause& c) {
  return fmt::format("{} {}", in_digits_of_interval(std::abs(c.value), c.half_width), c.unit);
}
/// What is five times as large or small, as a ratio: "20.00 ± 0.03 times".
std::string quantity(const FittedCause& c, Cause cause) {
  constexpr double many = 5;
  const double ratio = 1 + c.value / 100, wide = c.half_width / 100;
  const bool is_many = ratio >= many || (ratio > 0 && ratio <= 1 / many);
  if (c.unit != "%" || is_of_mean(cause) || !is_many || wide > ratio / 2) return quantity(c);
  return ratio > 1 ? fmt::format("{} times", in_digits_of_interval(ratio, wide))
                   : fmt::format("{} times", in_digits_of_interval(1 / ratio, wide / (ratio * ratio)));
}

/// " (of the air, 101325 Pa?)" where a pressure that is added everywhere is that.
std::string as_atmosphere(double mean) {
  constexpr double of_air = 101325;  // Pa
  return std::abs(mean / of_air - 1) < 0.01 ? " (that of the air, 101325 Pa?)" : "";
}

/// " (doubled)" or " (halved)" where a fraction is that but for its interval.
std::string in_times(double value, double half_width) {
  const auto is = [&](double what) { return std::abs(value - what) <= std::max(half_width, 0.01); };
  if (half_width > 0.1) return "";
  return is(1) ? " (doubled)" : is(-0.5) ? " (halved)" : "";
}

}  // namespace

Explanation as_noise(const FieldVector& seen) {
  const VectorXd& error = seen.error();
  Explanation noise =
      noise_of(seen, Rest(seen, error, MatrixXd(error.size(), 0)).noise() * static_cast<double>(error.size()));
  noise.sentence =
      fmt::format("the error is noise from sample to sample, {} of the root mean square", quantity(noise.causes[0]));
  return noise;
}
Explanation explanation(const Fit& fit, const FieldVector& seen, double spacing, bool is_named, bool is_best) {
  Explanation made{.share = fit.share, .named = is_named};
  for (std::size_t k = 0; k < fit.causes.size(); ++k) {
    const Phrases words = phrases_of(fit.causes[k], seen);
    const double scale = words.unit == "%" ? 100 : words.unit == "s" ? 1 : 1 / spacing;
    const auto i = static_cast<Index>(k);
    const FittedCause& one = made.causes.emplace_back(
        FittedCause{std::string(words.name), std::string(words.unit), scale * fit.value[i], scale * fit.half_width[i]});
    const std::string_view phrase =
        one.value >= 0 || words.where_negative.empty() ? words.where_positive : words.where_negative;
    made.sentence +=
        (k > 0 ? " and " : "") + fmt::format(fmt::runtime(phrase), quantity(one, fit.causes[k]), words.name);
    if (seen.field() == "pressure" && fit.causes[k] == Cause::mean_x)
      made.sentence += as_atmosphere(fit.value[i] * seen.norm());
    if (words.unit == "%") made.sentence += in_times(fit.value[i], fit.half_width[i]);
    if (is_named && k < fit.vanishing.size()) {
      const bool is_wall = words.unit == "spacings";
      const double in = fit.in_metres ? 1 : scale;
      const FittedCause at_zero{one.cause, std::string(fit.in_metres ? "m" : words.unit), in * fit.vanishing[k].value,
                                in * fit.vanishing[k].half_width};
      made.sentence += fmt::format(" ({} {}{})", is_wall ? "at all resolutions" : "at vanishing spacing",
                                   at_zero.value * fit.value[i] < 0 ? "-" : "", quantity(at_zero, fit.causes[k]));
    }
  }
  constexpr double worth_a_word = 0.03;
  if (is_named && fit.noise >= worth_a_word) {
    const Explanation noise = noise_of(seen, fit.noise * seen.squared_error());
    made.causes.push_back(noise.causes[0]);
    made.share = std::min(1.0, made.share + noise.share);
    if (is_best)
      made.sentence +=
          fmt::format(", with noise of {} of the root mean square from sample to sample", quantity(noise.causes[0]));
  }
  return made;
}

std::string in_words(const std::vector<Explanation>& explanations) {
  const Explanation& best = explanations.front();
  std::string sentence = fmt::format("{}, which {} {:.1f} % of the squared error", best.sentence,
                                     best.causes.size() > 1 ? "explain" : "explains", 100 * best.share);
  for (std::size_t k = 1; k < explanations.size() && explanations[k].named; ++k)
    sentence += (k == 1 ? "; or, indistinguishable by these data: " : "; or ") + explanations[k].sentence;
  return sentence;
}

}  // namespace touchstone::vnv::doors::diagnosis
