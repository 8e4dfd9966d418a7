#include "vnv/record/accepted_claims.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace touchstone::vnv {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> columns_of_claims{"suite", "method", "theory [-]", "literature [-]", "baseline [-]"};

auto place_of(const ClaimCount& c) { return std::tie(c.case_name, c.suite, c.method); }

long count_in(const Sheet& sheet, const Sheet::Row& row, std::size_t column) {
  const double count = sheet.number(row, column);
  if (count < 0 || count > 1e6 || count != std::floor(count))
    throw BadData(sheet.file, row.line, fmt::format("{} claims, expected a whole number from 0 to a million", count));
  return static_cast<long>(count);
}

std::string part_in_words(long accepted, long found, std::string_view author) {
  return found < accepted ? fmt::format(", {} of {} {}", accepted - found, accepted, author) : "";
}

AcceptedClaims claims_of(const Sheet& sheet) {
  require_headings(sheet, columns_of_claims);
  AcceptedClaims claims{Acceptance::read(sheet), {}};
  for (const Sheet::Row& row : sheet.rows) {
    const ClaimCount count{sheet.file.stem(),       row.cells[1],           row.cells[0], count_in(sheet, row, 2),
                           count_in(sheet, row, 3), count_in(sheet, row, 4)};
    if (claims.find(count.case_name, count.method, count.suite))
      throw BadData(sheet.file, row.line,
                    fmt::format("duplicate row; found {} of {} twice, expected it once", count.method, count.suite));
    claims.rows.push_back(count);
  }
  return claims;
}

}  // namespace

ClaimCount claims_in(const Record& record) {
  ClaimCount count{record.case_name, record.method, record.suite};
  std::set<std::string> counted;
  for (const Verdict& v : record.verdicts) {
    const auto limit = [](const std::optional<double>& value) { return value.value_or(not_a_number); };
    const bool is_another = counted
                                .insert(fmt::format("{}|{}|{}|{}|{}|{}", v.level, v.quantity, v.time, v.author,
                                                    limit(v.lower), limit(v.upper)))
                                .second;
    if (v.quantity == never_accepted || !is_another) continue;
    ++(v.author.starts_with("theory")       ? count.theory
       : v.author.starts_with("literature") ? count.literature
                                            : count.baseline);
  }
  return count;
}

long missing_of(const ClaimCount& accepted, const ClaimCount& found) {
  return std::max(0L, accepted.theory - found.theory) + std::max(0L, accepted.literature - found.literature) +
         std::max(0L, accepted.baseline - found.baseline);
}

std::string missing_in_words(const ClaimCount& accepted, const ClaimCount& found) {
  const std::string parts = part_in_words(accepted.theory, found.theory, "theory") +
                            part_in_words(accepted.literature, found.literature, "literature") +
                            part_in_words(accepted.baseline, found.baseline, "baseline");
  return found.total() == 0 ? "all" : parts.substr(2);
}

const ClaimCount* AcceptedClaims::find(std::string_view case_name, std::string_view method,
                                       std::string_view suite) const {
  const auto found = std::ranges::find_if(rows, [&](const ClaimCount& row) {
    return row.case_name == case_name && row.method == method && row.suite == suite;
  });
  return found == rows.end() ? nullptr : &*found;
}

void AcceptedClaims::set(const ClaimCount& count) {
  std::erase_if(rows, [&](const ClaimCount& row) { return place_of(row) == place_of(count); });
  rows.push_back(count);
}

fs::path claims_file(const fs::path& data, const std::string& case_name) {
  return data / "claims" / (case_name + ".csv");
}

AcceptedClaims read_accepted_claims(const fs::path& file) {
  return fs::exists(file) ? claims_of(read_sheet(file)) : AcceptedClaims{};
}

AcceptedClaims read_all_accepted_claims(const fs::path& folder) {
  AcceptedClaims all;
  if (!fs::is_directory(folder)) throw BadData(folder, 0, "not there; expected a folder of accepted claims");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".csv")
      std::ranges::copy(read_accepted_claims(entry).rows, std::back_inserter(all.rows));
  std::ranges::sort(all.rows, {}, place_of);
  return all;
}

void write_accepted_claims(const fs::path& file, AcceptedClaims claims) {
  if (claims.rows.empty()) {
    fs::remove(file);
    return;
  }
  std::string text = claims.acceptance.text() + csv_line(columns_of_claims);
  std::ranges::sort(claims.rows, {}, place_of);
  for (const ClaimCount& row : claims.rows)
    text += csv_line({row.suite, row.method, std::to_string(row.theory), std::to_string(row.literature),
                      std::to_string(row.baseline)});
  claims_of(parse_sheet(file, text));  // what cannot be read back is never written
  fs::create_directories(file.parent_path());
  files::write_whole(file, text);
}

}  // namespace touchstone::vnv
