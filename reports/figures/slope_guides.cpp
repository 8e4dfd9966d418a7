#include "reports/figures/slope_guides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::reports {
namespace {

constexpr double frame_width = 700, frame_height = 430;  // px  as far as distances need it
constexpr double enough = 45;                            // px  of room around the guides
constexpr double longest = 0.2, tallest = 0.4;           // of the frame
constexpr int places = 40;                               // tried along each axis
constexpr int samples = 12;                              // of a straight piece

/// A place in shares of the frame, from its lower left.
struct Place {
  double x, y;
};

Place on_the_way(const Place& from, const Place& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

double square(double value) { return value * value; }

/// In square pixels.
double squared_distance(const Place& a, const Place& b) {
  return square(frame_width * (a.x - b.x)) + square(frame_height * (a.y - b.y));
}

double share_of(std::pair<double, double> range, double value) {
  return std::log(value / range.first) / std::log(range.second / range.first);
}

/// The lines, as places close to each other.
std::vector<Place> sampled(std::pair<double, double> x, std::pair<double, double> y,
                           const std::vector<DrawnLine>& lines) {
  std::vector<Place> all;
  for (const auto& line : lines) {
    std::vector<Place> corners;
    for (const auto& [across, up] : line) {
      const Place place{share_of(x, across), share_of(y, up)};
      if (std::isfinite(place.x) && std::isfinite(place.y)) corners.push_back(place);
    }
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      for (int k = 0; k < samples; ++k)
        all.push_back(on_the_way(corners[i], corners[i + 1], static_cast<double>(k) / samples));
    if (!corners.empty()) all.push_back(corners.back());
  }
  return all;
}

/// Two lines from a corner, of slope 1 and 2 where the axes measure so.
struct Fan {
  Place corner, first, second;  // where the lines start, and end

  std::vector<Place> outline() const {
    std::vector<Place> all;
    for (const Place& end : {first, second}) {
      for (int k = 0; k <= 4; ++k) all.push_back(on_the_way(corner, end, k / 4.0));
      all.push_back({end.x + 12 / frame_width, end.y});  // its name
    }
    return all;
  }
};

double room_around(const Fan& fan, const std::vector<Place>& others) {
  double room = std::numeric_limits<double>::infinity();
  for (const Place& own : fan.outline())
    for (const Place& other : others) room = std::min(room, squared_distance(own, other));
  return std::sqrt(room);
}

/// From the lower right on, where errors that shrink with the spacing leave room, the first place with enough of it.
Fan roomiest(double width, double slope, const std::vector<Place>& others) {
  Fan best{};
  double most = -1;
  for (int i = places; i >= 0; --i)
    for (int k = 0; k <= places; ++k) {
      const Place corner{0.02 + (0.93 - width) * i / places, 0.04 + (0.92 - 2 * slope * width) * k / places};
      const Fan fan{
          corner, {corner.x + width, corner.y + slope * width}, {corner.x + width, corner.y + 2 * slope * width}};
      const double room = std::min(enough, room_around(fan, others));
      if (room > most) {
        most = room;
        best = fan;
      }
    }
  return best;
}

std::string line_command(const Place& from, const Place& to) {
  return fmt::format(
      "set arrow from graph {:.4f},{:.4f} to graph {:.4f},{:.4f} nohead linecolor rgb '#8A8A8A' linewidth 1.2\n",
      from.x, from.y, to.x, to.y);
}

std::string name_command(const char* name, const Place& end) {
  return fmt::format("set label '{}' at graph {:.4f},{:.4f} left offset 0.4,0 font ',12' textcolor rgb '#6A6A6A'\n",
                     name, end.x, end.y);
}

}  // namespace

std::string slope_guides(std::pair<double, double> x, std::pair<double, double> y,
                         const std::vector<DrawnLine>& lines) {
  const double slope = std::log(x.second / x.first) / std::log(y.second / y.first);  // in shares of the frame
  const Fan fan = roomiest(std::min(longest, tallest / (2 * slope)), slope, sampled(x, y, lines));
  return line_command(fan.corner, fan.first) + line_command(fan.corner, fan.second) + name_command("1", fan.first) +
         name_command("2", fan.second);
}

}  // namespace touchstone::reports
