#include "vnv/judge/baselines.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/record/former.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace touchstone::vnv {
namespace {

using std::filesystem::path;

const std::vector<std::string> columns{"method", "level", "time [s]", "quantity", "value", "lower", "upper", "basis"};

bool stands_before(const Baseline& a, const Baseline& b) {
  const auto place = [](const Baseline& row) {
    const double time = std::isnan(row.time) ? -std::numeric_limits<double>::infinity() : row.time;
    return std::tuple(std::string_view(row.method), std::string_view(row.level), time, std::string_view(row.quantity));
  };
  return place(a) < place(b);
}

Baseline baseline_in(const Sheet& sheet, const Sheet::Row& row) {
  const Baseline found{.method = row.cells[0],
                       .level = row.cells[1],
                       .time = sheet.number(row, 2, true),
                       .quantity = current_name(row.cells[3]),
                       .value = sheet.number(row, 4),
                       .lower = sheet.number(row, 5),
                       .upper = sheet.number(row, 6),
                       .basis = row.cells[7]};
  if (!(found.lower <= found.value && found.value <= found.upper))
    throw BadData(sheet.file, row.line,
                  fmt::format("value outside its limits; found {} < {} < {}, expected lower <= value <= upper",
                              found.lower, found.value, found.upper));
  if (found.method.empty() || found.quantity.empty() || found.basis.empty())
    throw BadData(sheet.file, row.line,
                  fmt::format("nameless value; found method '{}', quantity '{}', basis '{}', expected none empty",
                              found.method, found.quantity, found.basis));
  return found;
}

void require_one_value_a_place(const Sheet& sheet, const Baselines& baselines) {
  for (std::size_t i = 0; i < baselines.rows.size(); ++i) {
    const auto& row = baselines.rows[i];
    if (baselines.find(row.method, row.level, row.time, row.quantity) != &row)
      throw BadData(sheet.file, sheet.rows[i].line,
                    fmt::format("duplicate value; found {} {} of {} at {} s twice, expected it once", row.method,
                                row.level, row.quantity, row.time));
  }
}

Baselines baselines_in(const Sheet& sheet) {
  require_headings(sheet, columns);
  Baselines baselines{Acceptance::read(sheet), {}};
  for (const auto& row : sheet.rows) baselines.rows.push_back(baseline_in(sheet, row));
  require_one_value_a_place(sheet, baselines);
  return baselines;
}

std::string shortest(double value) { return fmt::format("{}", value); }

std::string text_of(const std::vector<Baseline>& rows, const Acceptance& acceptance) {
  std::string text = acceptance.text() + csv_line(columns);
  for (const auto& row : rows)
    text += csv_line({row.method, row.level, shortest(row.time), row.quantity, shortest(row.value), shortest(row.lower),
                      shortest(row.upper), row.basis});
  return text;
}

}  // namespace

const Baseline* Baselines::find(std::string_view method, std::string_view level, double time,
                                std::string_view quantity) const {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Baseline& row) {
    return row.method == method && row.level == level && same_time(row.time, time) && row.quantity == quantity;
  });
  return found == rows.end() ? nullptr : &*found;
}

std::optional<Baselines> read_baselines(const path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  return baselines_in(read_sheet(file));
}

void write_baselines(const path& file, std::vector<Baseline> rows, const Acceptance& acceptance) {
  std::sort(rows.begin(), rows.end(), stands_before);
  const std::string text = text_of(rows, acceptance);
  baselines_in(parse_sheet(file, text));  // what cannot be read back is never written
  try {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    files::write_whole(file, text);
  } catch (const std::runtime_error&) {
    throw BadData(file, 0, "the baselines cannot be written; expected permission and space to write beside it");
  }
}

}  // namespace touchstone::vnv
