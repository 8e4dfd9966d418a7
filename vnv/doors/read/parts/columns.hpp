#pragma once
/// What readers of several formats do with the arrays of a dataset.

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vnv/doors/read/dataset.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors {

/// "t", "time [s]", "TimeValue": a column that parts rows by their time, or a number that is the time of all.
bool names_time(std::string_view name);

/// Units of time, each with its length [s].
inline const std::vector<std::pair<std::string, double>> units_of_time{
    {"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}, {"h", 3600}};

/// That of a heading, "v_x [m/s]" or "v_x (m/s)": "m/s"; empty where there is none, as in "c_v[1]".
std::string unit_in(std::string_view name);

/// Throws Unreadable where an array is there twice or of other rows than the first.
void require_equal_rows(const std::vector<Array>& arrays, const std::string& source);

void keep_rows(Array& array, const std::vector<bool>& kept);

/// Calls with the first of some rows, and with the numbers of these, up to the last; memory of those that have been
/// given is free again, so that what the call makes of them does not stand beside them.
template <class Call>
void consume_rows(Array& array, Call&& call) {
  constexpr std::size_t numbers_at_once = 1 << 18;
  const auto width = static_cast<std::size_t>(array.components);
  const std::size_t at_once = std::max<std::size_t>(1, numbers_at_once / width) * width;
  for (std::size_t at = 0; at < array.values.size(); at += at_once) {
    const std::span<double> some(array.values.data() + at, std::min(at_once, array.values.size() - at));
    call(at / width, std::span<const double>(some));
    forget(some.data(), some.size_bytes());
  }
  array.values = {};
}

/// A dataset of each time, in their order, where a column is the time and the whole has none; else the whole. Throws
/// Unreadable where these are more than a series may have.
std::vector<Dataset> parted_by_time(Dataset whole);

/// Numbers as a file holds them, the last index fastest.
struct Block {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

/// Blocks by their names, a row for each first index; but "x", "y" and others of one shape of two dimensions are values
/// on a grid, a row each, and a single block of two dimensions is a table of columns "column 1" and so on. Throws
/// Unreadable.
std::vector<Array> rows_of(std::vector<Block> blocks, const std::string& source);

/// One particle array of PySPH, with arrays of its properties.
struct ParticleArray {
  std::string name;
  std::vector<Array> arrays;
};

/// Rows of all particle arrays, those that are real (tag 0), with an array "array" of their names: `--only array=fluid`
/// chooses. What one lacks and another has is NaN. Throws Unreadable.
std::vector<Array> rows_of(std::vector<ParticleArray> all, const std::string& source);

}  // namespace touchstone::vnv::doors
