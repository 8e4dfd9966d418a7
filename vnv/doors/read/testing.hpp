#pragma once
/// Samples of formats, as tests read them.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "vnv/doors/read/dataset.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/files/whole_file.hpp"

namespace touchstone::vnv::doors {

inline std::filesystem::path samples() { return data_folder().parent_path() / "vnv/doors/read/samples"; }

/// What a reader says of what it cannot read; empty where it can.
inline std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "";
}

/// The bytes with the first `from` replaced.
inline std::string with(std::string bytes, const std::string& from, const std::string& to) {
  return bytes.replace(bytes.find(from), from.size(), to);
}

/// Five particles, as make_samples.py of npy, hdf5 and lammps give them: x, y, u and v.
inline std::vector<double> five(char name) {
  std::vector<double> column;
  for (const double k : {0., 1., 2., 3., 4.})
    column.push_back(name == 'x' ? 0.1 * k : name == 'y' ? 1 / (k + 1) : name == 'u' ? k / 3 : -k / 7);
  return column;
}

}  // namespace touchstone::vnv::doors
