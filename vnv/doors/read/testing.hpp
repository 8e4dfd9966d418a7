#pragma once
/// Samples of formats, as tests read them.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/pickle.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/files/whole_file.hpp"

namespace touchstone::vnv::doors {

inline std::filesystem::path samples() { return data_folder().parent_path() / "vnv/doors/read/samples"; }

/// A format by its name; "pickle" is what stands in a .npz behind its checksums, as if it were one.
inline Format format_named(std::string_view name) {
  for (const auto& [known, format] : all_formats())
    if (known == name) return format();
  if (name != "pickle") throw std::out_of_range(std::string(name) + ": no format, expected one");
  return {.words = "a pickle",
          .endings = {".pickle"},
          .read = [](const std::filesystem::path& file, std::string_view bytes, const Limits&) {
            return Pickle(bytes, file.string()), std::vector<Dataset>{};
          }};
}

inline std::vector<Dataset> read_as(std::string_view name, const std::filesystem::path& file, std::string_view bytes,
                                    const Limits& limits) {
  return read_as(format_named(name), file, bytes, limits);
}

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
