#pragma once
/// Samples of VTK's formats, and what they hold.

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors::vtk {

inline std::filesystem::path sample(const std::string& name) { return samples() / "vtk" / name; }

inline std::vector<Dataset> read_sample(const std::string& name) { return read_datasets(sample(name)); }

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// Names of arrays that differ in a bit, or in components; of datasets all but source and format is compared.
inline std::string differences(const Dataset& a, const Dataset& b) {
  std::string names;
  if (a.time != b.time || a.rows_are != b.rows_are || a.arrays.size() != b.arrays.size()) names += "the dataset;";
  for (std::size_t i = 0; i < std::min(a.arrays.size(), b.arrays.size()); ++i) {
    const Array &x = a.arrays[i], &y = b.arrays[i];
    if (x.name != y.name || x.components != y.components || !same_bits(x.values, y.values)) names += x.name + ";";
  }
  return names;
}

/// As samples/vtk/make_samples.py gives them.
inline Dataset seven_particles(bool with_specials = true) {
  Dataset particles{.time = 0.125, .arrays = {{points_array, 3}}};
  for (const char* type :
       {"Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float32", "Float64"})
    particles.arrays.push_back({type});
  particles.arrays.push_back({"velocity", 3});
  particles.arrays.push_back({"wide <&> name"});
  using number = std::numeric_limits<double>;
  if (with_specials)
    particles.arrays.push_back(
        {"specials",
         1,
         {number::quiet_NaN(), number::infinity(), -number::infinity(), -0.0, number::denorm_min(), number::max(), 1}});
  for (int i = 0; i < 7; ++i) {
    const auto append = [&](std::size_t array, std::initializer_list<double> row) {
      std::vector<double>& values = particles.arrays[array].values;
      values.insert(values.end(), row);
    };
    append(0, {0.1 * i, 1. / (i + 1), 0});
    for (std::size_t array = 1; array <= 10; ++array) append(array, {3. * i + 1});
    append(11, {i / 3., -i / 7., 1e-300 * i});
    append(12, {static_cast<float>(i / 3.)});
  }
  return particles;
}

}  // namespace touchstone::vnv::doors::vtk
