/// Computes the steady lid-driven cavity until higher degrees change nothing, and writes what is known of its
/// centrelines to the folder that is named, data/computed, as data/README.md has it. Run it anew where
/// lid_driven_cavity.hpp changes:
///
///     build/reference/cavity_tables data/computed

#include "reference/lid_driven_cavity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using touchstone::reference::LidDrivenCavity;
using Profile = std::function<double(double)>;

/// A Reynolds number, the degree by which it is tabulated, and the lower one whose difference from it is the
/// uncertainty.
struct Tabulated {
  int Re, degree, lower;
};
constexpr Tabulated all[] = {{100, 80, 64}, {400, 96, 80}, {1000, 112, 96}, {3200, 128, 112}};

constexpr int degree_of_profiles = 80;  // of the polynomials through the places of a table

double place(int i) { return (1 - std::cos(std::numbers::pi * i / degree_of_profiles)) / 2; }

Profile u_of(const LidDrivenCavity& flow) {
  return [&flow](double y) { return flow.u(0.5, y); };
}
Profile v_of(const LidDrivenCavity& flow) {
  return [&flow](double x) { return flow.v(x, 0.5); };
}

/// How far apart two profiles are at most, at the places of the table and between them.
double distance(const Profile& a, const Profile& b) {
  double largest = 0;
  for (int i = 0; i < 2 * degree_of_profiles; ++i) {
    const double at = (place(i / 2) + place((i + 1) / 2)) / 2;
    largest = std::max(largest, std::abs(a(at) - b(at)));
  }
  return largest;
}

/// What a reader of the table has: the polynomial through its places (barycentric: Berrut & Trefethen 2004).
Profile as_tabulated(const Profile& profile) {
  std::vector<double> values;
  for (int i = 0; i <= degree_of_profiles; ++i) values.push_back(profile(place(i)));
  return [values](double at) {
    double sum = 0, weights = 0;
    for (int i = 0; i <= degree_of_profiles; ++i) {
      if (at == place(i)) return values[i];
      const double weight = (i % 2 ? -1 : 1) * (i % degree_of_profiles == 0 ? 0.5 : 1) / (at - place(i));
      sum += weight * values[i];
      weights += weight;
    }
    return sum / weights;
  };
}

/// Where a profile is smallest: the best of 200 places, and between its neighbours by golden sections.
double smallest_at(const Profile& of) {
  constexpr int many = 200;
  int best = 1;
  for (int k = 2; k < many; ++k)
    if (of(1.0 * k / many) < of(1.0 * best / many)) best = k;
  double low = (best - 1.0) / many, high = (best + 1.0) / many;
  while (high - low > 1e-8) {
    const double step = (high - low) / (1 + std::numbers::phi);
    if (of(low + step) < of(high - step))
      high -= step;
    else
      low += step;
  }
  return (low + high) / 2;
}

struct Extremum {
  std::string name;
  double value, at;
};
std::vector<Extremum> extrema_of(const LidDrivenCavity& flow) {
  const Profile u = u_of(flow), v = v_of(flow);
  const double back = smallest_at(u), up = smallest_at([&](double x) { return -v(x); }), down = smallest_at(v);
  return {{"smallest v_x", u(back), back}, {"largest v_y", v(up), up}, {"smallest v_y", v(down), down}};
}

/// What is known of a flow.
struct Known {
  Tabulated of;
  std::vector<std::string> rows;  // of the profiles
  double half_width;              // -  of their velocities
  double between_places;          // -  by which the polynomial through the table is off
  std::vector<Extremum> extrema, by_lower_degree;
};

Known known_of(Tabulated of, const LidDrivenCavity& flow, const LidDrivenCavity& lower) {
  Known known{of, {}, 0, 0, extrema_of(flow), extrema_of(lower)};
  for (int i = 0; i <= degree_of_profiles; ++i)
    known.rows.push_back(
        fmt::format("{},{:.12f},{:.9f},{:.9f}\n", of.Re, place(i), flow.u(0.5, place(i)), flow.v(place(i), 0.5)));
  const Profile u = u_of(flow), v = v_of(flow);
  known.half_width = std::max(distance(u, u_of(lower)), distance(v, v_of(lower)));
  known.between_places = std::max(distance(u, as_tabulated(u)), distance(v, as_tabulated(v)));
  return known;
}

/// The first two digits, rounded up.
std::string above(double number) {
  const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
  return fmt::format("{:.1e}", std::ceil(number / unit) * unit);
}

std::string degrees(const std::vector<Known>& flows) {
  std::string words;
  for (const Known& flow : flows)
    words += fmt::format("{}{} ({} at Re {})", words.empty() ? "" : ", ", flow.of.degree, flow.of.lower, flow.of.Re);
  return words;
}

std::string header(const std::string& title, const std::string& scaling, const std::string& uncertainty,
                   const std::string& note) {
  return fmt::format(
      "# title: {}\n# citation: none; computed by this project, by the method of O. Botella, R. Peyret, Benchmark "
      "spectral results on the lid-driven cavity flow, Comput. Fluids 27 (1998), 421-433\n# source: written by "
      "reference/cavity_tables.cpp, never by hand\n# scaling: {}\n# geometry: cavity_aspect = 1 -\n# uncertainty: "
      "{}\n# note: {}\n",
      title, scaling, uncertainty, note);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream to(file, std::ios::binary);
  to << text << std::flush;
  if (!to) throw std::runtime_error(file.string() + ": cannot be written");
}

void write_profiles(const std::filesystem::path& folder, const std::vector<Known>& flows) {
  std::string uncertainty, rows;
  double between_places = 1e-9;  // what is written
  for (const Known& flow : flows) {
    between_places = std::max(between_places, flow.between_places);
    uncertainty += fmt::format("{0}u.{1} = {2} -; v.{1} = {2} -", uncertainty.empty() ? "" : "; ", flow.of.Re,
                               above(flow.half_width));
    for (const std::string& row : flow.rows) rows += row;
  }
  write(folder / "cavity_profiles.csv",
        header("Velocities on the centrelines of a lid-driven square cavity, steady, by Chebyshev collocation",
               "s by the side of the cavity; u and v by the speed of the lid: u(1/2, s) along the lid on the vertical "
               "centreline, s from the floor; v(s, 1/2) towards it on the horizontal one, s in the direction in which "
               "the lid moves.",
               uncertainty,
               fmt::format("Stream functions of degree {}; the uncertainty is the largest difference from those of the "
                           "degree in brackets, anywhere on both centrelines.\n# note: The places are those of "
                           "Chebyshev: the polynomial of degree {} through those of a Reynolds number is off by {} "
                           "between them.",
                           degrees(flows), degree_of_profiles, above(between_places))) +
            "Re,s [-],u [-],v [-]\n" + rows);
}

void write_extrema(const std::filesystem::path& folder, const std::vector<Known>& flows) {
  std::string uncertainty, rows;
  for (const Known& flow : flows) {
    double of_value = 1e-9, of_place = 1e-6;  // what is written, and how flat an extremum is to rounding
    for (std::size_t k = 0; k < flow.extrema.size(); ++k) {
      of_value = std::max(of_value, std::abs(flow.extrema[k].value - flow.by_lower_degree[k].value));
      of_place = std::max(of_place, std::abs(flow.extrema[k].at - flow.by_lower_degree[k].at));
      rows += fmt::format("{},{},{:.9f},{:.6f}\n", flow.of.Re, flow.extrema[k].name, flow.extrema[k].value,
                          flow.extrema[k].at);
    }
    uncertainty += fmt::format("{0}value.{1} = {2} -; at.{1} = {3} -", uncertainty.empty() ? "" : "; ", flow.of.Re,
                               above(of_value), above(of_place));
  }
  write(folder / "cavity_extrema.csv",
        header("Extrema of the velocity on the centrelines of a lid-driven square cavity, steady, by Chebyshev "
               "collocation",
               "places by the side of the cavity, y from the floor and x in the direction in which the lid moves; "
               "velocities by the speed of the lid, v_x along it, v_y towards it.",
               uncertainty,
               fmt::format("Stream functions of degree {}; the uncertainty is the largest difference from those of the "
                           "degree in brackets.\n# note: smallest v_x is on the vertical centreline, at a height y; "
                           "largest and smallest v_y are on the horizontal one, at a place x.",
                           degrees(flows))) +
            "Re,quantity,value [-],at [-]\n" + rows);
}

}  // namespace

int main(int count, char** words) try {
  if (count != 2) throw std::runtime_error("expected one folder, data/computed");
  std::vector<Known> flows;
  std::optional<LidDrivenCavity> flow;
  for (const Tabulated& of : all) {
    constexpr int few = 64;  // a degree that finds the way
    if (!flow) flow.emplace(of.Re, few);
    // From Re 1000 Newton's method does not reach 3200 at once.
    for (const double Re : {1500.0, 2200.0})
      if (of.Re > 2200) flow.emplace(Re, few, LidDrivenCavity(*flow));
    const LidDrivenCavity lower(of.Re, of.lower, LidDrivenCavity(of.Re, few, *flow)), higher(of.Re, of.degree, lower);
    flows.push_back(known_of(of, higher, lower));
    fmt::print(stderr, "Re {}: known to {}, between the places of the table to {}\n", of.Re,
               above(flows.back().half_width), above(flows.back().between_places));
    flow.emplace(of.Re, few, LidDrivenCavity(lower));
  }
  write_profiles(words[1], flows);
  write_extrema(words[1], flows);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "cavity_tables: {}\n", error.what());
  return 3;
}
