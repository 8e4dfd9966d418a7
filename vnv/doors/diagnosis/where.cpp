#include "vnv/doors/diagnosis/where.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

namespace touchstone::vnv::doors {

std::string where_it_lies(const std::vector<Located>& all, const Domain& domain, double spacing) {
  constexpr double near_spacings = 2, least_part = 0.5, least_denser = 1.6;
  const std::string spread = "its square is spread over the fluid";
  Vec2 low = Vec2::Constant(INFINITY), high = -low;
  double volume = 0, squared = 0;
  for (const Located& one : all) {
    low = low.cwiseMin(one.x), high = high.cwiseMax(one.x);
    volume += one.volume, squared += one.squared;
  }
  if (!(volume > 0 && squared > 0)) return spread;
  const double close = near_spacings * spacing;
  std::array<bool, 2> walled{!domain.periodic(0), !domain.periodic(1)};
  for (const int axis : {0, 1})
    if (domain.periodic(axis)) low[axis] = domain.box.low[axis], high[axis] = domain.box.high[axis];
    // a wall is where the domain ends, an edge of the fluid is half a spacing beyond its rows
    else
      for (auto [edge, end] : {std::pair(&low[axis], domain.box.low[axis]), {&high[axis], domain.box.high[axis]}})
        *edge = std::abs(*edge - end) < 1.5 * spacing ? end : *edge + std::copysign(spacing / 2, end - *edge);
  const auto at_low = [&](const Vec2& x, int axis) { return x[axis] < low[axis] + close; };
  const auto at_high = [&](const Vec2& x, int axis) { return x[axis] > high[axis] - close; };
  const auto at_either = [&](const Vec2& x, int axis) { return at_low(x, axis) || at_high(x, axis); };
  struct Region {
    std::string name;
    std::function<bool(const Vec2&)> has;
  };
  std::vector<Region> regions;
  const std::string within = fmt::format("within {:g} spacings of ", near_spacings);
  for (const int axis : {0, 1}) {
    if (!walled[axis]) {
      regions.push_back({within + fmt::format("the seam of the periodic box along {}", axis == 0 ? "x" : "y"),
                         [&, axis](const Vec2& x) { return at_either(x, axis); }});
      continue;
    }
    const bool top_is_free = axis == 1 && high[axis] < domain.box.high[axis];
    regions.push_back({within + (axis == 0 ? "the left wall" : "the lower wall"),
                       [&, axis](const Vec2& x) { return at_low(x, axis); }});
    regions.push_back({within + (top_is_free ? "the free surface"
                                 : axis == 0 ? "the right wall"
                                             : "the upper wall"),
                       [&, axis](const Vec2& x) { return at_high(x, axis); }});
    regions.push_back({within + (top_is_free ? "the floor or the free surface"
                                 : axis == 0 ? "the side walls"
                                             : "the lower or upper wall"),
                       [&, axis](const Vec2& x) { return at_either(x, axis); }});
  }
  if (walled[0] && walled[1])
    regions.push_back({within + "the corners", [&](const Vec2& x) { return at_either(x, 0) && at_either(x, 1); }});
  if (walled[0] || walled[1])
    regions.push_back({"in the core, the middle half between the walls", [&](const Vec2& x) {
                         const Vec2 off = ((x - (low + high) / 2).cwiseQuotient(high - low)).cwiseAbs();
                         return (!walled[0] || off.x() < 0.25) && (!walled[1] || off.y() < 0.25);
                       }});
  std::string best = spread;
  double most = 0;
  for (const Region& region : regions) {
    double part = 0, size = 0;
    for (const Located& one : all)
      if (region.has(one.x)) part += one.squared / squared, size += one.volume / volume;
    if (!(part >= least_part && part >= least_denser * size)) continue;
    if (const double found = part * std::log(part / size); found > most) {
      most = found;
      best =
          fmt::format("{:.0f} % of its square lies {}, in {:.0f} % of the fluid", 100 * part, region.name, 100 * size);
    }
  }
  return best;
}

}  // namespace touchstone::vnv::doors
