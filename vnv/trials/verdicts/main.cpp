/// touchstone_verdict_mutation RECORDS --claims FOLDER: would the index show each claim that holds in a suite's records
/// if its record said that it does not, or did not say so? Each is mutated as a text, one at a time, read as the report
/// reads it, and its case put on an index.

#include "reports/pages/pages.hpp"
#include "vnv/programs/command_line.hpp"
#include "vnv/record/json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>

namespace {

namespace fs = std::filesystem;
using namespace touchstone;
using reports::CaseRecords;
using vnv::Record, vnv::Verdict;
using Json = vnv::json::Json;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A mutation of the record's text: of all of it, its verdict, and what is just beyond the limit of that.
struct Mutation {
  const char* name;
  std::function<void(Json& record, Json& verdict, const Json& beyond)> mutate;
};

Json just_beyond(const Verdict& v) {
  const bool is_above = !v.lower || (v.upper && *v.upper - v.value <= v.value - *v.lower);
  return vnv::json::Writer::json(is_above ? std::nextafter(*v.upper, infinity) : std::nextafter(*v.lower, -infinity));
}

void move_beyond_with_measured(Json& record, Json& v, const Json& beyond) {
  v["value"] = beyond;
  for (Json& value : record.at("values"))
    if (value.at("level") == v.at("level") && value.at("time") == v.at("time") &&
        value.at("quantity").at("name") == v.at("quantity"))
      value["value"] = beyond;
}

const std::vector<Mutation> mutations{
    {"value", [](Json&, Json& v, const Json& beyond) { v["value"] = beyond; }},
    {"value and what was measured", move_beyond_with_measured},
    {"value and outcome",
     [](Json& record, Json& v, const Json& beyond) {
       move_beyond_with_measured(record, v, beyond);
       v["outcome"] = "fails";
     }},
    {"outcome", [](Json&, Json& v, const Json&) { v["outcome"] = "inconclusive"; }},
    {"nan", [](Json&, Json& v, const Json&) { v["value"] = "nan"; }},
    {"no limits", [](Json&, Json& v, const Json&) { v["lower"] = v["upper"] = nullptr; }},
    {"level", [](Json&, Json& v, const Json&) { v["level"] = "nowhere"; }},
    {"no value", [](Json&, Json& v, const Json&) { v.erase("value"); }},
    {"no verdict",
     [](Json& record, Json& v, const Json&) {
       auto& all = record.at("verdicts").get_ref<Json::array_t&>();
       all.erase(all.begin() + (&v - all.data()));
     }},
};

/// A record as a text of JSON and as it is read.
struct Entry {
  Json json;
  std::size_t of_case, at;  // where among the cases it stands
};

struct Suite {
  std::vector<CaseRecords> cases{};
  std::vector<Entry> entries{};
  vnv::AcceptedClaims accepted{};
};

/// Figures are not drawn on an index, and most of a record.
Suite read_suite(const fs::path& folder, const fs::path& claims) {
  Suite suite{.accepted = vnv::read_all_accepted_claims(claims)};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    std::ifstream stream(file);
    Json json = Json::parse(stream);
    for (const char* drawn : {"figures", "curves", "clouds", "tables", "diagrams", "work"}) json[drawn] = Json::array();
    Record record = vnv::record_in(json.dump(), file);
    if (suite.cases.empty() || suite.cases.back().name != record.case_name)
      suite.cases.push_back({record.case_name, {}});
    std::vector<Record>& records = suite.cases.back().records;
    records.push_back(std::move(record));
    suite.entries.push_back({std::move(json), suite.cases.size() - 1, records.size() - 1});
  }
  if (files.empty()) throw std::runtime_error(fmt::format("{}: no records in it, expected *.json", folder.string()));
  return suite;
}

/// Whether a report of these cases is green, by its exit status or by its index.
bool is_green(const std::vector<CaseRecords>& cases, const vnv::AcceptedClaims& accepted) {
  reports::NightStatus status = reports::night_status(cases, {}, "");
  status.claims = claims_status(cases, accepted, false);
  return status.passes() || contains(index_page(cases, status), "<p class=\"sum holds\">");
}

/// The cases with another text for one record; nothing where that is refused, in one line, and no page is made.
std::optional<std::vector<CaseRecords>> with_record(std::vector<CaseRecords> cases, std::size_t c, std::size_t r,
                                                    const Json& json) try {
  cases[c].records[r] = vnv::record_in(json.dump(), cases[c].name);
  return cases;
} catch (const std::runtime_error&) {
  return std::nullopt;
}

/// Whether a suite without this record misses it.
bool is_missed(std::vector<CaseRecords> cases, const Entry& entry, const vnv::AcceptedClaims& accepted) {
  std::vector<Record>& records = cases[entry.of_case].records;
  const std::string name = fmt::format("{}.{} (all)", cases[entry.of_case].name, records[entry.at].method);
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(entry.at));
  if (records.empty()) cases.erase(cases.begin() + static_cast<std::ptrdiff_t>(entry.of_case));
  return !cases.empty() && contains(claims_status(cases, accepted, true).missing, name);
}

/// Whether each mutation was seen, and which were not.
int try_all(const Suite& suite) {
  long claims = 0, records = 0, missed = 0, seen_in_all = 0;
  std::vector<long> seen(mutations.size());
  for (const Entry& entry : suite.entries) {
    const Record& record = suite.cases[entry.of_case].records[entry.at];
    if (!is_green({{record.case_name, {record}}}, suite.accepted)) continue;  // it is red anyway
    ++records;
    missed += is_missed(suite.cases, entry, suite.accepted);
    for (std::size_t k = 0; k < record.verdicts.size(); ++k) {
      ++claims;
      for (std::size_t m = 0; m < mutations.size(); ++m) {
        Json mutated = entry.json;
        mutations[m].mutate(mutated, mutated.at("verdicts").at(k), just_beyond(record.verdicts[k]));
        const auto cases = with_record({{record.case_name, {record}}}, 0, 0, mutated);
        const bool is_seen = !cases || !is_green(*cases, suite.accepted);
        seen[m] += is_seen;
        if (!is_seen) fmt::print("SURVIVED {}: {}\n", mutations[m].name, record.verdicts[k].sentence);
        if (m == 0 && k == 0)  // on the index of all cases, too
          seen_in_all += !is_green(*with_record(suite.cases, entry.of_case, entry.at, mutated), suite.accepted);
      }
    }
  }
  fmt::print("{} claims hold in {} records\n", claims, records);
  bool all = missed == records && seen_in_all == records && claims > 0;
  for (std::size_t m = 0; m < mutations.size(); ++m) {
    fmt::print("{}: {} seen by the index\n", mutations[m].name, seen[m]);
    all = all && seen[m] == claims;
  }
  fmt::print("one value of each record: {} seen by the index of all\nrecord: {} missed by the index\n", seen_in_all,
             missed);
  return all ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app{"Mutates each claim that holds in a suite's records, and says how many an index shows as red.",
               "touchstone_verdict_mutation"};
  std::string records, claims;
  app.add_option("RECORDS", records, "folder of records, *.json")->required()->check(programs::existing_folder());
  app.add_option("--claims", claims, "folder of accepted claims")->required()->check(programs::existing_folder());
  if (const auto status = programs::read_command_line(app, count, arguments)) return *status;
  try {
    return try_all(read_suite(records, claims));
  } catch (const std::exception& error) {
    fmt::print(stderr, "touchstone_verdict_mutation: {}\n", error.what());
    return 3;
  }
}
