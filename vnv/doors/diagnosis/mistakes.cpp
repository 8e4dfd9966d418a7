#include "vnv/doors/diagnosis/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv::doors {
namespace {

bool knows(const Exact& exact, Cause cause) { return std::ranges::find(exact.causes, cause) != exact.causes.end(); }

std::string nothing_is_there(const Exact& exact) {
  if (exact.field == "pressure")
    return knows(exact, Cause::gravity) ? "there is no pressure: gravity has no effect" : "there is no pressure";
  if (knows(exact, Cause::force)) return "the fluid is at rest: the force has no effect";
  if (knows(exact, Cause::floor)) return "the fluid is at rest: the moving wall has no effect";
  return "the fluid is at rest";
}

/// Units in which such a factor is made by reading one for another.
std::string unit_of(const std::string& field, int power) {
  const int size = std::abs(power);
  if (field == "pressure")
    return size == 2   ? ": hPa?"
           : size == 3 ? ": kPa, or over the density?"
           : size == 5 ? ": bar?"
           : size == 6 ? ": MPa?"
                       : "";
  return size == 2 ? ": cm/s?" : size == 3 ? ": mm/s?" : size == 6 ? ": µm/s?" : "";
}

/// The output before and after a time; of the first and the last as far off as the next is.
double before(const std::vector<double>& times, double t) {
  const auto at = std::ranges::lower_bound(times, t);
  if (at != times.begin()) return *(at - 1);
  return std::max(0.0, times.size() > 1 ? 2 * times[0] - times[1] : 0);
}
double after(const std::vector<double>& times, double t) {
  const auto at = std::ranges::upper_bound(times, t);
  return at != times.end() ? *at : 2 * t - before(times, t);
}

}  // namespace

std::vector<Mistake> mistakes_of_scale(const Exact& exact, double found) {
  std::vector<Mistake> all{
      {.cause = "at rest", .unit = "%", .value = -100, .sentence = nothing_is_there(exact), .scale = 0}};
  if (exact.field == "pressure") all[0].cause = "no pressure";
  if (!(std::abs(found) > 0) || !std::isfinite(found)) return all;
  int power = static_cast<int>(std::lround(std::log10(std::abs(found))));
  double size = std::pow(10, power);
  const double most_off = std::abs(power) == 1 ? 0.03 : 0.3;  // nobody reads one unit for another ten times as large
  if (std::abs(std::abs(found) / size - 1) > most_off) size = std::abs(found), power = 0;
  if (found > 0 && power == 0) return all;  // an amplitude
  std::string sentence = found > 0   ? fmt::format("the {} is", exact.field)
                         : size == 1 ? fmt::format("the {} has the wrong sign", exact.field)
                                     : fmt::format("the {} has the wrong sign and is", exact.field);
  if (size != 1)
    sentence += fmt::format(" {:.6g} times too {}{}", std::max(size, 1 / size), size > 1 ? "large" : "small",
                            unit_of(exact.field, power));
  all.push_back({.cause = power == 0 ? "reversed" : "power of ten",
                 .unit = "times",
                 .value = found,
                 .sentence = std::move(sentence),
                 .scale = std::copysign(size, found)});
  return all;
}

std::vector<Mistake> mistakes_of_place_and_time(const Exact& exact, const Domain& domain,
                                                const std::vector<double>& times) {
  const Vec2 low = domain.box.low, size = domain.box.size(), both = 2 * low + size;
  const std::string field = "the " + exact.field;
  const bool is_plane = exact.components == 2;
  std::vector<Mistake> all;
  const auto add_of_place = [&](std::string cause, std::string sentence, auto from, auto as) {
    all.push_back({.cause = std::move(cause),
                   .sentence = std::move(sentence),
                   .seen = [=](const auto& truth, const Vec2& x, double t) -> Vec2 { return as(truth(from(x), t)); }});
  };
  const auto same = [](const Vec2& v) { return v; };
  const auto swapped = [](const Vec2& v) -> Vec2 { return v.reverse(); };
  const auto quarters = [](int n) {
    return n == 0 ? "no part" : n == 2 ? "half" : n == 1 ? "a quarter" : "three quarters";
  };
  for (const auto& [i, j] :
       {std::pair(2, 0), {0, 2}, {2, 2}, {1, 0}, {3, 0}, {0, 1}, {0, 3}, {1, 1}, {1, 3}, {3, 1}, {3, 3}}) {
    if ((i > 0 && !domain.periodic(0)) || (j > 0 && !domain.periodic(1))) continue;
    std::string by = i == 0   ? fmt::format("{} of the box along y", quarters(j))
                     : j == 0 ? fmt::format("{} of the box along x", quarters(i))
                     : i == j ? fmt::format("{} of the box along x and y", quarters(i))
                              : fmt::format("{} of the box along x and {} along y", quarters(i), quarters(j));
    const Vec2 shift = 0.25 * size.cwiseProduct(Vec2(i, j));
    const Vec2 origin = shift - size.cwiseProduct(Vec2(i > 1, j > 1));  // of the data: the nearest, but for periods
    add_of_place(
        "shifted",
        fmt::format("{} is shifted by {}: with its origin at ({:.4g}, {:.4g}) m it fits", field, by, origin.x(),
                    origin.y()),
        [=](const Vec2& x) -> Vec2 {
          return {domain.wrapped(0, x.x() - shift.x()), domain.wrapped(1, x.y() - shift.y())};
        },
        same);
  }
  const auto negated = [](int axis) {
    return [axis](Vec2 v) {
      v[axis] *= -1;
      return v;
    };
  };
  for (const int axis : {0, 1}) {
    const char* name = axis == 0 ? "x" : "y";
    const auto mirrored = [=](Vec2 x) {
      x[axis] = both[axis] - x[axis];
      return x;
    };
    if (is_plane)
      add_of_place(fmt::format("mirrored along {}", name), fmt::format("{} is mirrored along {}", field, name),
                   mirrored, negated(axis));
    add_of_place(fmt::format("places mirrored along {}", name),
                 is_plane ? fmt::format("the places are mirrored along {}, the velocities are not", name)
                          : fmt::format("{} is mirrored along {}", field, name),
                 mirrored, same);
  }
  if (is_plane) {
    add_of_place("v_x reversed", "v_x has the wrong sign", same, negated(0));
    add_of_place("v_y reversed", "v_y has the wrong sign", same, negated(1));
    add_of_place("components swapped", "v_x and v_y are swapped", same, swapped);
    if (std::abs(size.x() / size.y() - 1) < 1e-9)
      add_of_place(
          "axes swapped", "x and y are swapped", [low](const Vec2& x) -> Vec2 { return low + (x - low).reverse(); },
          swapped);
  }
  const auto add_of_time = [&](std::string cause, std::string sentence, auto time) {
    all.push_back({.cause = std::move(cause),
                   .sentence = std::move(sentence),
                   .of_time = true,
                   .seen = [=](const auto& truth, const Vec2& x, double t) -> Vec2 { return truth(x, time(t)); }});
  };
  add_of_time("frozen", fmt::format("{} is that of the start: nothing changes", field), [](double) { return 0.0; });
  for (const auto& [factor, words] : {std::pair(2.0, "twice"), std::pair(0.5, "half")})
    add_of_time("clock", fmt::format("the clock of {} runs {} as fast as it should", field, words),
                [by = factor](double t) { return by * t; });  // Clang 14 captures no binding
  if (times.size() > 1) {
    add_of_time("one output late", fmt::format("{} is one output late", field),
                [times](double t) { return before(times, t); });
    add_of_time("one output early", fmt::format("{} is one output ahead", field),
                [times](double t) { return after(times, t); });
  }
  for (const Instead& one : exact.instead)
    all.push_back({.cause = one.cause,
                   .sentence = one.sentence,
                   .of_time = true,
                   .seen = [truth = one.truth](const auto&, const Vec2& x, double t) -> Vec2 { return truth(x, t); }});
  return all;
}

}  // namespace touchstone::vnv::doors
