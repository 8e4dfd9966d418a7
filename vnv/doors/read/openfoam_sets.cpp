/// Lines of OpenFOAM's `sets` as raw text, TIME/line_p_U.xy: a coordinate or three, and the fields that the name of the
/// file says, vectors of three components where their names begin with U. The folder may be the time.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::doors::formats {
namespace {

/// The columns of a file by its name: as many of its last parts as leave one coordinate or three.
std::vector<Array> columns_of(const std::filesystem::path& file, std::size_t count) {
  std::string stem = file.stem().string();
  std::vector<Array> fields;
  std::size_t taken = 0;
  while (!stem.empty()) {
    const std::size_t bar = stem.rfind('_');
    const std::string name = stem.substr(bar == stem.npos ? 0 : bar + 1);
    const int components = name.starts_with('U') ? 3 : 1;
    taken += static_cast<std::size_t>(components);
    if (name.empty() || taken >= count) break;
    fields.insert(fields.begin(), Array{.name = name, .components = components});
    if (count - taken == 1 || count - taken == 3) {
      const bool is_distance = count - taken == 1;
      fields.insert(fields.begin(),
                    Array{.name = is_distance ? "distance" : points_array, .components = is_distance ? 1 : 3});
      return fields;
    }
    stem.resize(bar == stem.npos ? 0 : bar);
  }
  refuse(file.string(),
         fmt::format("{} columns, expected a coordinate or three and the fields that end the name, as in "
                     "line_p_U.xy",
                     count));
}

std::vector<Dataset> lines_of(const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
  const std::string name = file.string();
  Dataset data{.source = file.filename().string(), .format = "OpenFOAM set, raw", .rows_are = Rows::probes};
  data.time = number_in(file.parent_path().filename().string());
  std::string_view rest = bytes, first = bytes.substr(0, bytes.find('\n'));
  std::size_t count = 0;
  while (!next_word(first).empty()) ++count;
  if (count > limits.most_components)
    refuse(name, fmt::format("{} columns, expected {} or fewer", count, limits.most_components));
  data.arrays = columns_of(file, count);
  Budget budget(limits);
  for (long at = 1; !rest.empty(); ++at) {
    std::string_view line = next_line(rest);
    if (trimmed(line).empty()) continue;
    budget.take(1, count, name);
    for (Array& array : data.arrays)
      append_text(line, static_cast<std::size_t>(array.components), Type::float64,
                  fmt::format("{}:{}: {:.80}", name, at, array.name), array.values);
    if (!trimmed(line).empty())
      refuse(fmt::format("{}:{}", name, at), fmt::format("more numbers than {} columns", count));
  }
  require_equal_rows(data.arrays, name);
  return {std::move(data)};
}

}  // namespace

Format openfoam_sets() {
  return {.words = "a set of OpenFOAM",
          .help = "OpenFOAM's sets",
          .place = 46,
          .endings = {".xy"},
          .is_it = [](const std::filesystem::path& file, std::string_view) { return file.extension() == ".xy"; },
          .read = lines_of};
}

}  // namespace touchstone::vnv::doors::formats
