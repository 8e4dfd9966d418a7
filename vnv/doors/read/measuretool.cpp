/// Tables of DualSPHysics' MeasureTool: three lines with the places, a line of headings, "Part;Time [s];Vel_0.x [m/s]",
/// and a row for each time, with the fields of all places side by side.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

#include <map>

namespace touchstone::vnv::doors::formats {
namespace {

std::string_view next_cell(std::string_view& line) {
  const std::string_view cell = line.substr(0, line.find(';'));
  line.remove_prefix(std::min(line.size(), cell.size() + 1));
  return trimmed(cell);
}

/// A heading, "Vel_12.x [m/s]": field, place, component, or none where it is of another kind.
struct Heading {
  std::string field{};
  std::size_t place = 0;
  int component = 0;
};
std::optional<Heading> heading_of(std::string_view cell) {
  const std::size_t unit = cell.find(" ["), bar = cell.substr(0, unit).rfind('_');
  if (bar == cell.npos) return std::nullopt;
  std::string_view behind = cell.substr(bar + 1, unit == cell.npos ? unit : unit - bar - 1);
  Heading found;
  if (behind.size() > 2 && behind[behind.size() - 2] == '.') {
    found.component = behind.back() - 'x';
    behind.remove_suffix(2);
  }
  const auto place = number_in(behind);
  if (!place || *place < 0 || *place > 1e9 || found.component < 0 || found.component > 2) return std::nullopt;
  found.place = static_cast<std::size_t>(*place);
  found.field = std::string(cell.substr(0, bar)) + std::string(unit == cell.npos ? "" : cell.substr(unit));
  return found;
}

class MeasureTool {
 public:
  MeasureTool(const std::filesystem::path& file, std::string_view bytes, const Limits& limits)
      : file_(file), rest_(bytes), limits_(limits), budget_(limits) {}

  std::vector<Dataset> datasets() && {
    for (int axis = 0; axis < 3; ++axis) take_places(axis);
    take_headings();
    std::vector<Dataset> all;
    while (!trimmed(rest_).empty()) {
      if (all.size() == limits_.most_datasets)
        refuse_here(fmt::format("expected no more than {} times", limits_.most_datasets));
      all.push_back(at_a_time());
    }
    return all;
  }

 private:
  [[noreturn]] void refuse_here(const std::string& what) const {
    refuse(fmt::format("{}:{}", file_.string(), at_), what);
  }
  std::string_view next() {
    if (rest_.empty()) refuse_here("ends, expected three lines of places, headings and rows");
    ++at_;
    return next_line(rest_);
  }
  double number(std::string_view cell, std::string_view of) const {
    const auto value = number_in(cell);
    if (!value) refuse_here(fmt::format("{:.80}: '{:.40}', expected a number", of, cell));
    return *value;
  }

  void take_places(int axis) {
    std::string_view line = next();
    next_cell(line);
    const std::string_view name = next_cell(line);
    if (name != fmt::format("Pos{} [m]:", "XYZ"[axis]))
      refuse_here(fmt::format("'{:.40}', expected 'Pos{} [m]:'", name, "XYZ"[axis]));
    std::size_t count = 0;
    for (; !line.empty(); ++count) {
      const double value = number(next_cell(line), name);
      if (axis == 0) budget_.take(1, 3, file_.string()), places_.insert(places_.end(), {0.0, 0.0, 0.0});
      if (3 * count + 2 >= places_.size()) refuse_here("more places than along x");
      places_[3 * count + static_cast<std::size_t>(axis)] = value;
    }
    if (3 * count != places_.size())
      refuse_here(fmt::format("{} places, expected {} as along x", count, places_.size() / 3));
  }

  void take_headings() {
    std::string_view line = next();
    while (!line.empty()) {
      const std::string_view cell = next_cell(line);
      columns_.push_back(heading_of(cell));
      if (names_time(cell)) time_ = columns_.size() - 1;
      if (const auto& found = columns_.back()) {
        if (3 * found->place + 2 >= places_.size())
          refuse_here(fmt::format("'{:.40}', of which there is no place", cell));
        int& components = fields_[found->field];
        components = std::max(components, found->component + 1);
      }
    }
    if (!time_ || fields_.empty()) refuse_here("no time or no field of a place, expected both");
  }

  Dataset at_a_time() {
    Dataset data{.source = file_.filename().string(), .format = "MeasureTool", .rows_are = Rows::probes};
    std::string_view line = next();
    const std::size_t rows = places_.size() / 3;
    data.arrays.push_back({.name = points_array, .components = 3, .values = places_});
    for (const auto& [name, components] : fields_) {
      budget_.take(rows, static_cast<std::size_t>(components), file_.string());
      data.arrays.push_back({.name = name, .components = components});
      data.arrays.back().values.assign(rows * static_cast<std::size_t>(components), 0);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (line.empty()) refuse_here(fmt::format("{} cells, expected {} as headings", k, columns_.size()));
      const std::string_view cell = next_cell(line);
      if (k == *time_)
        data.time = time_of(number(cell, "time"), Type::float64, fmt::format("{}:{}", file_.string(), at_));
      if (const auto& heading = columns_[k]) {
        const auto field = std::ranges::find(data.arrays, heading->field, &Array::name);
        field->values[heading->place * static_cast<std::size_t>(field->components) +
                      static_cast<std::size_t>(heading->component)] = number(cell, heading->field);
      }
    }
    return data;
  }

  const std::filesystem::path& file_;
  std::string_view rest_;
  const Limits& limits_;
  Budget budget_;
  long at_ = 0;
  std::vector<double> places_{};
  std::vector<std::optional<Heading>> columns_{};
  std::map<std::string, int> fields_{};  // components of each
  std::optional<std::size_t> time_{};
};

}  // namespace

Format measuretool() {
  return {.words = "a table of MeasureTool",
          .help = "tables of MeasureTool",
          .place = 48,
          .endings = {".csv"},
          .is_it =
              [](const std::filesystem::path&, std::string_view head) {
                next_cell(head);
                return next_cell(head) == "PosX [m]:";
              },
          .read = [](const std::filesystem::path& file, std::string_view bytes,
                     const Limits& limits) { return MeasureTool(file, bytes, limits).datasets(); }};
}

}  // namespace touchstone::vnv::doors::formats
