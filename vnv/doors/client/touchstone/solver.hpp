// SPDX-License-Identifier: MIT
#pragma once
/// A class of yours as a method of a flow: give it step(), time() and samples(), and let main() return
/// touchstone::client::run<Yours>(count, words). `vnv run` calls the program once a resolution and judges what it
/// wrote. Nothing of Touchstone is linked; a C++20 compiler and this file are all that is needed.

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::client {

/// Particles, or cells, at one time: an entry each, in SI units. A field that a solver does not have stays empty, as
/// may v_y where a flow is judged along x alone, between plates.
struct Samples {
  std::vector<double> x{}, y{};      // m
  std::vector<double> v_x{}, v_y{};  // m/s
  std::vector<double> p{};           // Pa
  std::vector<double> rho{};         // kg/m³
  std::vector<double> mass{};        // kg/m  of a plane flow: per metre of depth
};

/// What is to be computed: one resolution of a flow.
struct Scene {
  double spacing;                              // m  of particles, or width of cells
  Samples start;                               // particles at t = 0, on a lattice with that spacing
  std::map<std::string, double> parameters{};  // of the flow, in SI units: `vnv scene FLOW` says what they mean

  /// A parameter of the flow, scene["nu"]. Throws std::invalid_argument for one that it does not have.
  double operator[](const std::string& name) const {
    if (const auto found = parameters.find(name); found != parameters.end()) return found->second;
    std::string known;
    for (const auto& [one, value] : parameters) known += " " + one;
    throw std::invalid_argument("no parameter '" + name + "', expected one of:" + known);
  }
};

/// It may choose its own steps, or end each at the time that it is told: step(at_most) then advances by at most so many
/// seconds, and samples are of exactly the times that are judged.
template <class S>
concept ChoosesItsSteps = requires(S solver) {
  solver.step();
};
template <class S>
concept LimitsItsSteps = requires(S solver, double at_most) {
  solver.step(at_most);
};

/// What a class needs to be a method of a flow: it is made from the scene and says its time [s] and its samples.
template <class S>
concept Solver = std::constructible_from<S, const Scene&> &&
    (ChoosesItsSteps<S> || LimitsItsSteps<S>)&&requires(const S& solver) {
  { solver.time() } -> std::convertible_to<double>;
  { solver.samples() } -> std::convertible_to<Samples>;
};

namespace detail {

/// "0.1,0.2" at the commas.
inline std::vector<std::string> parts(const std::string& list) {
  std::vector<std::string> all;
  std::istringstream text(list);
  for (std::string part; std::getline(text, part, ',');) all.push_back(part);
  return all;
}

inline double number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument("'" + text + "', expected a number");
  return value;
}

/// The columns of particles.csv, in its order, and of samples.csv, but its time.
inline std::vector<std::pair<std::string, std::vector<double> Samples::*>> columns() {
  return {{"x [m]", &Samples::x},         {"y [m]", &Samples::y},  {"v_x [m/s]", &Samples::v_x},
          {"v_y [m/s]", &Samples::v_y},   {"p [Pa]", &Samples::p}, {"rho [kg/m³]", &Samples::rho},
          {"mass [kg/m]", &Samples::mass}};
}

inline Samples read_particles(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) throw std::invalid_argument(file + ": cannot be read, expected particles");
  Samples all;
  const auto in_order = columns();
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = parts(line);
    for (std::size_t k = 0; k < in_order.size(); ++k) (all.*in_order[k].second).push_back(number(cells.at(k)));
  }
  return all;
}

/// The table of a run, samples.csv: each number as the shortest digits that are read as the same number.
class Table {
 public:
  void add(double time, const Samples& samples) {
    std::string heading = "t [s]";
    std::vector<const std::vector<double>*> there;
    for (const auto& [name, column] : columns()) {
      const std::vector<double>& values = samples.*column;
      if (values.empty() && column != &Samples::y) continue;
      if (values.size() != samples.x.size())
        throw std::invalid_argument("samples(): " + std::to_string(values.size()) + " values of " + name +
                                    ", expected " + std::to_string(samples.x.size()) + " as of x");
      heading += "," + name;
      there.push_back(&values);
    }
    if (text_.empty()) text_ = heading + "\n";
    if (text_.compare(0, heading.size() + 1, heading + "\n") != 0)
      throw std::invalid_argument("samples(): " + heading + ", expected " + text_.substr(0, text_.find('\n')) +
                                  " as before");
    for (std::size_t row = 0; row < samples.x.size(); ++row) {
      write(time);
      for (const std::vector<double>* values : there) {
        text_ += ',';
        write((*values)[row]);
      }
      text_ += '\n';
    }
  }
  /// Whole or not at all.
  void save(const std::string& file) const {
    const std::string part = file + ".part";
    std::ofstream out(part, std::ios::binary);
    out << text_ << std::flush;
    if (!out || std::rename(part.c_str(), file.c_str()) != 0) throw std::runtime_error(file + ": cannot be written");
  }

 private:
  void write(double value) {
    char digits[32];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }

  std::string text_{};
};

template <Solver S>
void advance(S& solver, double until) {
  const double before = solver.time();
  if constexpr (LimitsItsSteps<S>)
    solver.step(until - before);
  else
    solver.step();
  if (!(solver.time() > before)) throw std::runtime_error("step() left the time at " + std::to_string(before) + " s");
}

}  // namespace detail

/// Runs a solver through the times [s], rising, and writes its samples to a file. A step that ends within rounding of a
/// time has reached it.
template <Solver S>
void write_samples(const Scene& scene, const std::vector<double>& times, const std::string& file) {
  S solver(scene);
  detail::Table table;
  for (const double time : times) {
    while (!(solver.time() >= time * (1 - 1e-12))) detail::advance(solver, time);
    table.add(solver.time(), solver.samples());
  }
  table.save(file);
}

/// The main() of a solver: by its words SPACING TIMES PARTICLES PARAMETERS, as the TOML file of touchstone_add_case
/// gives them, it writes samples.csv in the current folder. Returns 1, and says why, where it cannot.
template <Solver S>
int run(int count, char** words) try {
  if (count != 5) throw std::invalid_argument("expected SPACING TIMES PARTICLES PARAMETERS, as `vnv run` gives them");
  Scene scene{.spacing = detail::number(words[1]), .start = detail::read_particles(words[3])};
  for (const std::string& one : detail::parts(words[4]))
    scene.parameters[one.substr(0, one.find('='))] = detail::number(one.substr(one.find('=') + 1));
  std::vector<double> times;
  for (const std::string& time : detail::parts(words[2])) times.push_back(detail::number(time));
  write_samples<S>(scene, times, "samples.csv");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", words[0], error.what());
  return 1;
}

}  // namespace touchstone::client
