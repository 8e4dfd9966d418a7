#include "vnv/judge/baselines.hpp"

#include "vnv/files/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

namespace touchstone::vnv {
namespace baselines_test {

constexpr double never = std::numeric_limits<double>::quiet_NaN();
const Acceptance accepted{.title = "Poiseuille", .revision = "1a2b3c", .date = "2025-01-31", .reason = "first values"};
const Baseline l2{.method = "mpm",
                  .level = "M2",
                  .time = 0.1,
                  .quantity = "L2 v_x, row means",
                  .value = 0.1 + 0.2,
                  .lower = 1e-300,
                  .upper = 1.0 / 3,
                  .basis = "one part in a million, \"calm\" flow"};
const Baseline order{.method = "mpm",
                     .level = "",
                     .time = never,
                     .quantity = "order of L2 over grid",
                     .value = 2,
                     .lower = 1.9,
                     .upper = 2.1,
                     .basis = "half width of the fit"};

Baseline changed(const std::function<void(Baseline&)>& change) {
  Baseline row = l2;
  change(row);
  return row;
}

std::filesystem::path fresh_folder() {
  const auto folder = std::filesystem::path(testing::TempDir()) / "baselines" /
                      testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::remove_all(folder);
  return folder;
}

std::string bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What a refusal says after the name of the file; empty if there is none.
template <class Act>
std::string said_by(const Act& act) {
  try {
    act();
  } catch (const BadData& refusal) {
    const std::string words = refusal.what();
    return words.substr(words.find(".csv:") + 5);
  }
  return {};
}
std::string refusal(const std::vector<Baseline>& rows, const Acceptance& acceptance = accepted) {
  return said_by([&] { write_baselines(fresh_folder() / "case.csv", rows, acceptance); });
}
std::string refusal_of_text(const std::string& from, const std::string& to) {
  const auto file = fresh_folder() / "case.csv";
  write_baselines(file, {l2, order}, accepted);
  std::string text = bytes(file);
  text.replace(text.find(from), from.size(), to);
  std::ofstream(file, std::ios::binary) << text;
  return said_by([&] { read_baselines(file); });
}

TEST(Baselines, AreAbsentBeforeTheFirstAcceptance) {
  EXPECT_FALSE(read_baselines(fresh_folder() / "case.csv").has_value());
}

TEST(Baselines, ComeBackBitByBit) {
  const auto file = fresh_folder() / "case.csv";
  write_baselines(file, {l2, order}, accepted);
  const auto read = read_baselines(file).value();
  const auto* row = read.find(l2.method, l2.level, l2.time, l2.quantity);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->value, l2.value);
  EXPECT_EQ(row->lower, l2.lower);
  EXPECT_EQ(row->upper, l2.upper);
  EXPECT_EQ(row->basis, l2.basis);
  EXPECT_EQ(read.acceptance.reason, accepted.reason);
}

TEST(Baselines, WrittenAgainAreTheSameBytes) {
  const auto folder = fresh_folder();
  write_baselines(folder / "first.csv", {order, l2}, accepted);
  const auto read = read_baselines(folder / "first.csv").value();
  write_baselines(folder / "second.csv", {read.rows[1], read.rows[0]}, read.acceptance);
  EXPECT_EQ(bytes(folder / "first.csv"), bytes(folder / "second.csv"));
}

TEST(Baselines, KeepNotes) {
  const auto file = fresh_folder() / "case.csv";
  Acceptance noted = accepted;
  noted.notes = {"loosened until the next release", "see figure 5"};
  write_baselines(file, {l2}, noted);
  EXPECT_EQ(read_baselines(file)->acceptance.notes, noted.notes);
}

TEST(Baselines, AreFoundAtTheirPlaceAlone) {
  const Baselines both{.acceptance = accepted, .rows = {l2, order}};
  EXPECT_EQ(both.find("mpm", "", never, order.quantity), &both.rows[1]);
  EXPECT_EQ(both.find("sph", l2.level, l2.time, l2.quantity), nullptr);
  EXPECT_EQ(both.find(l2.method, "M3", l2.time, l2.quantity), nullptr);
  EXPECT_EQ(both.find(l2.method, l2.level, 0.2, l2.quantity), nullptr);
  EXPECT_EQ(both.find(l2.method, l2.level, never, l2.quantity), nullptr);
  EXPECT_EQ(both.find(l2.method, l2.level, l2.time, "Linf v_x, row means"), nullptr);
}

TEST(Baselines, AreFoundAfterAHundredSmallSteps) {
  double time = 0;
  for (int step = 0; step < 100; ++step) time += 0.001;
  ASSERT_NE(time, l2.time);
  const Baselines one{.acceptance = accepted, .rows = {l2}};
  EXPECT_EQ(one.find(l2.method, l2.level, time, l2.quantity), &one.rows[0]);
}

TEST(Baselines, LeaveNothingBesideThem) {
  const auto folder = fresh_folder();
  write_baselines(folder / "case.csv", {l2}, accepted);
  write_baselines(folder / "case.csv", {l2, order}, accepted);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(Baselines, StandWhenNewOnesAreRefused) {
  const auto file = fresh_folder() / "case.csv";
  write_baselines(file, {l2}, accepted);
  const auto before = bytes(file);
  const auto outside = changed([](Baseline& row) { row.value = 1; });
  EXPECT_THROW(write_baselines(file, {outside}, accepted), BadData);
  EXPECT_EQ(bytes(file), before);
}

TEST(Baselines, CannotBeWrittenWhereAFolderStands) {
  const auto folder = fresh_folder();
  std::filesystem::create_directories(folder / "case.csv" / "inside");
  const auto write = [&] { write_baselines(folder / "case.csv", {l2}, accepted); };
  EXPECT_EQ(said_by(write), " the baselines cannot be written; expected permission and space to write beside it");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(Baselines, MustLieBetweenTheirLimits) {
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.value = 0.5; })}).substr(0, 31),
            "6: value outside its limits; fo");
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.lower = 0.31; })}).substr(0, 31),
            "6: value outside its limits; fo");
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.lower = row.upper = row.value; })}), "");
}

TEST(Baselines, MustBeFinite) {
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.value = never; })}),
            "6: not a number in 'value'; found 'nan', expected a decimal number");
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.upper = INFINITY; })}),
            "6: not a number in 'upper'; found 'inf', expected a decimal number");
}

TEST(Baselines, MustHaveAMethodAQuantityAndABasis) {
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.basis = ""; })}),
            "6: nameless value; found method 'mpm', quantity 'L2 v_x, row means', basis '', expected none empty");
}

TEST(Baselines, MustStandOnceEach) {
  EXPECT_EQ(refusal({l2, order, changed([](Baseline& row) { row.value = 0.2; })}),
            "8: duplicate value; found mpm M2 of L2 v_x, row means at 0.1 s twice, expected it once");
  EXPECT_EQ(refusal({order, order}),
            "7: duplicate value; found mpm  of order of L2 over grid at nan s twice, expected it once");
}

TEST(Baselines, MustSayWhoAcceptedThemAndWhy) {
  Acceptance silent = accepted;
  silent.reason = "";
  EXPECT_EQ(refusal({l2}, silent), "4: not a line of provenance; found '# reason: ', expected '# key: value'");
  EXPECT_EQ(refusal_of_text("# date: 2025-01-31\n", ""),
            "4: no line '# date: ...' above the columns; found 'title', 'revision', 'reason'");
}

TEST(Baselines, MustKeepToOneLineEach) {
  EXPECT_EQ(refusal({changed([](Baseline& row) { row.basis = "two\nlines"; })}),
            "6: a quote that does not close; found '\"two', expected a second '\"'");
}

TEST(Baselines, RefuseAFileOfOtherColumns) {
  EXPECT_EQ(refusal_of_text("time [s]", "time [ms]"), "5: no column 'time [s]'; found 'time [ms]'");
}

TEST(Baselines, RefuseATruncatedFile) {
  EXPECT_EQ(refusal_of_text(",\"one part in a million, \"\"calm\"\" flow\"\n", ""),
            "7: the file ends within this row; found 7, expected 8 cells");
}

}  // namespace baselines_test
}  // namespace touchstone::vnv
