#include "vnv/record/record.hpp"

#include "vnv/files/tables.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

namespace fs = std::filesystem;
constexpr double infinity = std::numeric_limits<double>::infinity();

class RecordFile : public testing::Test {
 protected:
  RecordFile() { fs::create_directories(folder_); }
  ~RecordFile() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name = "poiseuille.mpm.json") const { return folder_ / name; }
  void put(const std::string& text) const { std::ofstream(file()) << text; }
  std::string text() const {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// The record's text with one word changed.
  void change(const std::string& from, const std::string& to) const {
    std::string all = text();
    ASSERT_NE(all.find(from), std::string::npos) << from;
    put(all.replace(all.find(from), from.size(), to));
  }
  std::string refusal() const {
    try {
      read_record(file());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "read without complaint";
  }

 private:
  const fs::path folder_ = fs::path(testing::TempDir()) /
                           ("record." + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

/// Every field differs from its default, so that one that is not written or not read shows.
Record full_record() {
  Record r;
  int texts = 0;
  r.case_name = "poiseuille";
  r.method = "mpm";
  r.suite = "nightly";
  for (std::string Record::*text :
       {&Record::title, &Record::description, &Record::method_description, &Record::revision, &Record::compiler,
        &Record::flags, &Record::machine, &Record::finished_at, &Record::host})
    r.*text = fmt::format("Two\n\nparagraphs, ν and \"quotes\" {}", ++texts);
  const Cost cost{800, 120, 200000, 5, 92.5, 92.1, 94.2, 93.1, 92.9, 0.3, 1.7e6, Resource::gpu, 186.2};
  r.runs = {{"M1", 2.5e-5, 5e-6, 1.0, true, "finished", cost}};
  r.values = {{"M1", 2.5e-5, 1.0, {"L2 v_x", "%", Kind::norm}, 0.0334}};
  r.orders = {{"grid",
               "L2 v_x",
               1.0,
               0.98,
               0.11,
               Trend::stalled,
               true,
               0.004,
               0.001,
               1.9,
               0.2,
               {"M1", "M2"},
               {2.5e-5, 1.25e-5},
               {0.03, 0.015},
               {1.02}}};
  r.verdicts = {{"poiseuille", "mpm", "M1", 2.5e-5, 1.0, "order of L2 v_x over grid", "%", Kind::norm, Better::smaller,
                 4.3, 1.0, 4.0, 0.9, 0.1, Trend::converging, "theory", Outcome::fails, 0.17, "so"}};
  r.diagnoses = {{"M1", "velocity", {"L2 v_x"}, 3, {{{{"force", "%", 5, 0.1}}, 0.99, true, "so"}}, "so it is"}};
  r.figures = {{"profile", "Profiles", "Figure 5", {"y [mm]", 1e3, true, 0.0, 1.0}, {"v", 2}, {"p [Pa]", 3}, true}};
  r.curves = {{"profile", "mpm", Role::published, {0, 0.1}, {1e-300, 1.0 / 3}, true}};
  r.clouds = {{"cloud", "MPM", "t = 0.32 s", {0.1}, {0.2}, {0.3}}};
  r.tables = {
      {"norms", "Norms", "Table 3", {"level", "L2 [%]"}, {{std::string("M1"), 3.34}, {std::string("M2"), 1.59}}}};
  r.diagrams = {{"work", "Error against run time", "at 1 s", {"L2 v_x", "%", Kind::norm}, {3, 1}, 1}};
  r.work = {{"work", "paper", "MPM", "M1", true, 800, 4.6e-4, 3.34, 92, 91, 93}};
  r.histories = {{"M1", "histories/poiseuille.mpm.M1.csv"}};
  return r;
}

TEST_F(RecordFile, ComesBackAsItWasWritten) {
  write(full_record(), file());
  EXPECT_EQ(read_record(file()), full_record());
}

TEST_F(RecordFile, WrittenBeforeThereWereOtherResourcesCostsCpuTime) {
  auto json = nlohmann::ordered_json::parse(as_json(full_record()));
  for (const char* name : {"resource", "occupied"}) json["runs"][0]["cost"].erase(name);
  json["diagnoses"][0].erase("quantities");
  json.erase("another_code");
  const Record read = record_in(json.dump(), "written before");
  EXPECT_EQ(read.runs[0].cost.resource, Resource::cpu);
  EXPECT_EQ(read.runs[0].cost.spent(), 92.5);
  EXPECT_TRUE(read.diagnoses[0].quantities.empty());
}

TEST_F(RecordFile, StandsBesideTheHistoriesThatItLists) {
  Record record = full_record();
  record.histories[0].text = "# title: a history\ntime [s],v_x [m/s]\n0,nan\n0.1,2.5\n";
  write(record, file());
  const Sheet sheet = read_sheet(file().parent_path() / read_record(file()).histories[0].file);
  EXPECT_EQ(sheet.headings.cells, (std::vector<std::string>{"time [s]", "v_x [m/s]"}));
  EXPECT_TRUE(std::isnan(sheet.number(sheet.rows[0], 1, true)));
  EXPECT_EQ(sheet.number(sheet.rows[1], 1), 2.5);
}

TEST_F(RecordFile, IsReadWhereItWasWrittenBeforeThereWereHistories) {
  Record record = full_record();
  record.histories.clear();
  record.schema = 4;
  write(record, file());
  change(",\"histories\":[]", "");
  record = read_record(file());
  EXPECT_TRUE(record.histories.empty());
  EXPECT_EQ(record.schema, Record{}.schema);
}

/// One verdict that holds, 0.0334 of at most 0.04, and the value that it is of.
Record record_that_holds() {
  Record record = full_record();
  Verdict& v = record.verdicts[0];
  v.quantity = "L2 v_x";
  v.value = record.values[0].value;
  v.lower = v.surely_above = v.half_width = std::nullopt;
  v.upper = 0.04;
  v.outcome = Outcome::holds;
  return record;
}

TEST_F(RecordFile, IsNotBelievedWhereItContradictsItself) {
  write(record_that_holds(), file());
  EXPECT_EQ(read_record(file()), record_that_holds());
  const std::string plain = text();
  using Words = std::pair<std::string, std::string>;
  for (const auto& [changes, expected] :
       {std::pair(std::vector{Words("0.0334,\"lower\"", "0.0434,\"lower\""), Words("0.0334", "0.0434")},
                  "L2 v_x = 0.0434: says 'holds', expected 'fails' by value and limits"),
        {{Words("0.0334,\"lower\"", "\"nan\",\"lower\"")}, "= nan: says 'holds', expected 'fails'"},
        {{Words("\"upper\":0.04", "\"upper\":0.03")}, "says 'holds', expected 'fails'"},
        {{Words("\"upper\":0.04", "\"upper\":null")}, "says 'holds', expected 'inconclusive'"},
        {{Words("\"outcome\":\"holds\"", "\"outcome\":\"fails\"")}, "says 'fails', expected 'holds'"},
        {{Words("0.0334,\"lower\"", "0.0333,\"lower\"")}, "= 0.0333: expected 0.0334, the value that was measured"},
        {{Words("\"mpm\",\"level\":\"M1\"", "\"mpm\",\"level\":\"M9\"")},
         "mpm M9: inconsistent record: L2 v_x = 0.0334: no such level was run: FAILS"}}) {
    put(plain);
    for (const auto& [from, to] : changes) change(from, to);
    const Verdict verdict = read_record(file()).verdicts[0];
    EXPECT_EQ(verdict.outcome, Outcome::fails) << expected;
    EXPECT_NE(verdict.sentence.find(expected), std::string::npos) << verdict.sentence;
  }
}

TEST_F(RecordFile, MayBeMoreCautiousThanTheRuleOfToday) {
  Record record = record_that_holds();
  record.verdicts[0].outcome = Outcome::inconclusive;
  write(record, file());
  EXPECT_EQ(read_record(file()), record);
}

TEST_F(RecordFile, KeepsTheDifferenceBetweenNoLimitAndALimit) {
  Record record = full_record();
  record.verdicts[0].lower.reset();
  record.verdicts[0].half_width.reset();
  write(record, file());
  EXPECT_FALSE(read_record(file()).verdicts[0].lower.has_value());
  EXPECT_EQ(read_record(file()).verdicts[0].upper, 4.0);
}

TEST_F(RecordFile, KeepsNumbersThatAreNotFinite) {
  Record record = full_record();
  record.curves[0].y = {not_a_number, infinity};
  record.verdicts[0].upper = -infinity;
  record.tables[0].rows[0][1] = not_a_number;
  write(record, file());
  const Record back = read_record(file());
  EXPECT_TRUE(std::isnan(back.curves[0].y[0]));
  EXPECT_EQ(back.curves[0].y[1], infinity);
  EXPECT_EQ(back.verdicts[0].upper, -infinity);
  EXPECT_TRUE(std::isnan(std::get<double>(back.tables[0].rows[0][1])));
}

TEST_F(RecordFile, IsOverwrittenWholeAndLeavesNoTemporaryFile) {
  write(full_record(), file());
  Record second = full_record();
  second.title = "second";
  write(second, file());
  EXPECT_EQ(read_record(file()).title, "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(file().parent_path()), fs::directory_iterator()), 1);
}

TEST_F(RecordFile, InAFolderThatIsNotThereIsRefusedByName) {
  try {
    write(full_record(), file("nowhere/record.json"));
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere/record.json: cannot be written: No such file"), std::string::npos)
        << error.what();
  }
}

TEST_F(RecordFile, OnAFullDiskIsRefused) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  fs::create_symlink("/dev/full", file(".poiseuille.mpm.json." + std::to_string(getpid()) + ".part"));
  EXPECT_THROW(write(full_record(), file()), std::runtime_error);
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(RecordFile, WithTextThatIsNotUtf8IsRefused) {
  Record record = full_record();
  record.machine = "\xff";
  EXPECT_THROW(write(record, file()), std::runtime_error);
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(RecordFile, ThatIsTornIsRefusedWhereverItIsTorn) {
  write(full_record(), file());
  const std::string whole = text();
  for (std::size_t length = 0; length + 1 < whole.size(); length += 97) {
    put(whole.substr(0, length));
    EXPECT_NE(refusal().find("poiseuille.mpm.json: not a complete record: "), std::string::npos) << refusal();
  }
}

TEST_F(RecordFile, OfAnUnknownSchemaIsRefused) {
  write(full_record(), file());
  change("\"schema\":5", "\"schema\":7");
  EXPECT_TRUE(refusal().ends_with(".json: schema is 7, expected 1 to 5, those known here: a newer Touchstone wrote it"))
      << refusal();
  change("\"schema\":7", "\"schema\":0");
  EXPECT_TRUE(refusal().ends_with(".json: schema is 0, expected 1 to 5, those known here")) << refusal();
}

TEST_F(RecordFile, WhoseNamesLeadOutOfAFolderIsRefused) {
  for (const char* name : {"../poiseuille", "/etc/poiseuille", "a/../../b", ".."}) {
    Record record = full_record();
    record.case_name = name;
    write(record, file());
    EXPECT_NE(refusal().find(fmt::format("case_name is '{}', expected a name", name)), std::string::npos) << refusal();
    record = full_record();
    record.method = name;
    write(record, file());
    EXPECT_NE(refusal().find(fmt::format("method is '{}', expected a name", name)), std::string::npos) << refusal();
  }
}

TEST_F(RecordFile, WithAWordForANumberIsRefusedByPlace) {
  write(full_record(), file());
  change("92.5", "\"fast\"");
  EXPECT_NE(refusal().find("runs[0].cost.cpu is \"fast\", expected a number"), std::string::npos) << refusal();
}

TEST_F(RecordFile, WithAnUnknownOutcomeIsRefused) {
  write(full_record(), file());
  change("\"fails\"", "\"maybe\"");
  EXPECT_NE(refusal().find("verdicts[0].outcome is \"maybe\", expected one of holds, fails"), std::string::npos)
      << refusal();
}

TEST_F(RecordFile, WithoutOneOfItsFieldsIsRefused) {
  write(full_record(), file());
  change("\"half_width\"", "\"half_breadth\"");
  EXPECT_NE(refusal().find("orders[0].half_width is not there"), std::string::npos) << refusal();
}

TEST_F(RecordFile, WithACurveOfUnequalLengthsIsRefused) {
  Record record = full_record();
  record.curves[0].y.pop_back();
  write(record, file());
  EXPECT_NE(refusal().find("y of curve 'mpm' has 1 entries, expected 2"), std::string::npos) << refusal();
}

TEST_F(RecordFile, ThatIsNotThereIsRefused) {
  EXPECT_NE(refusal().find("cannot be read: No such file"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace touchstone::vnv
