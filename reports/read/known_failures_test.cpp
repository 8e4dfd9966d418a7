#include "reports/read/known_failures.hpp"

#include "reports/pages/pages.hpp"
#include "reports/testing.hpp"
#include "vnv/files/data_folder.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::reports {
namespace {

const std::string columns = "id,case,method,level,quantity,since,expires,reason\n";

class KnownFailures : public testing::Test {
 protected:
  std::vector<KnownFailure> read(const std::string& text) const {
    std::ofstream(folder / "known.csv") << text;
    return read_known_failures(folder / "known.csv");
  }
  std::string refusal(const std::string& row) const try {
    read("# note: one\n" + columns + row);
    return "read without complaint";
  } catch (const std::runtime_error& error) {
    return error.what();
  }

  ScratchFolder folder;
};

TEST_F(KnownFailures, AreRowsBelowCommentsAndMayBeNone) {
  EXPECT_TRUE(read("# note: one\n" + columns).empty());
  const auto rows =
      read(columns + "drift,poiseuille,mpm,M2,\"L2 v_x, mean [%]\",2026-11-01,2026-12-01,\"it \"\"drifts\"\"\"\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].quantity, "L2 v_x, mean [%]");
  EXPECT_EQ(rows[0].reason, "it \"drifts\"");
}

TEST_F(KnownFailures, NeedAReasonAndADateThatComesSoon) {
  const std::string claim = "a,poiseuille,mpm,M2,L2 v_x [%],";
  EXPECT_TRUE(contains(refusal(claim + "2026-11-01,2026-12-01,\n"), "known.csv:3: no reason")) << refusal(claim);
  EXPECT_TRUE(contains(refusal(claim + "2026-11-01,2027-02-01,x\n"), "expires 92 days after 2026-11-01"));
  EXPECT_TRUE(contains(refusal(claim + "2026-11-02,2027-01-31,x\n"), "without complaint"));
  EXPECT_TRUE(contains(refusal(claim + "2026-11-02,2026-11-01,x\n"), "expires -1 days"));
  EXPECT_TRUE(contains(refusal(claim + "2026-11-02,2026-02-30,x\n"), "'2026-02-30', expected a date"));
  EXPECT_TRUE(contains(refusal(claim + "soon,2026-11-01,x\n"), "since 'soon'"));
}

TEST_F(KnownFailures, AreNamedOnceAndWhole) {
  const std::string row = "a,poiseuille,mpm,M2,L2 v_x [%],2026-11-01,2026-12-01,x\n";
  EXPECT_TRUE(contains(refusal(row + row), "known.csv:4: duplicate id; found 'a'"));
  EXPECT_TRUE(contains(refusal(row + "b" + row.substr(1)), "known.csv:4: duplicate claim; found that of 'a'"));
  EXPECT_TRUE(contains(refusal("a,poiseuille\n"), "found 2, expected 8 cells"));
  EXPECT_TRUE(contains(refusal("a,\"poiseuille\n"), "a quote that does not close"));
  EXPECT_THROW(read(""), std::runtime_error);
  EXPECT_THROW(read("id,case\n"), std::runtime_error);
  EXPECT_THROW(read_known_failures(folder / "nowhere.csv"), std::runtime_error);
}

TEST_F(KnownFailures, OfTheProjectAreReadable) {
  EXPECT_NO_THROW(read_known_failures(vnv::data_folder() / "known_failures.csv"));
}

KnownFailure known(const std::string& expires = "2026-12-01") {
  return {"drift", "poiseuille", "mpm", "M2", "L2 v_x [%]", "2026-11-01", expires, "it drifts"};
}
std::vector<CaseRecords> night_with(vnv::Outcome outcome) {
  vnv::Record record = sample_record();
  record.verdicts = {sample_verdict(outcome, -0.1)};
  return {{"poiseuille", {record}}};
}
const std::string today = "2026-11-22T17:00:00Z";

TEST(ANightStatus, IsAmberWhereTheFailureIsKnown) {
  const auto cases = night_with(vnv::Outcome::fails);
  const NightStatus found = night_status(cases, {known()}, today);
  EXPECT_EQ(found.red_count(), 0u);
  const std::string html = index_page(cases, found);
  EXPECT_TRUE(contains(html, "class=\"sum known\"")) << html;
  EXPECT_TRUE(contains(html, "known as drift until 2026-12-01: it drifts")) << html;
  EXPECT_TRUE(contains(html, "<td class=\"known\">1 of 1 fails, known")) << html;
}

TEST(ANightStatus, IsRedWhereTheFailureIsUnknown) {
  const auto cases = night_with(vnv::Outcome::fails);
  for (const auto& rows : {std::vector<KnownFailure>{}, {KnownFailure{}}}) {
    const NightStatus found = night_status(cases, rows, today);
    EXPECT_EQ(found.sentence(), "1 red: 1 unknown or expired failure, 0 unexpected passes; 0 known");
    EXPECT_TRUE(contains(index_page(cases, found), "class=\"sum fails\""));
  }
}

TEST(ANightStatus, IsRedWhereTheKnownFailureIsOfAnotherCaseMethodLevelOrQuantity) {
  const auto cases = night_with(vnv::Outcome::fails);
  for (std::string KnownFailure::*part :
       {&KnownFailure::case_name, &KnownFailure::method, &KnownFailure::level, &KnownFailure::quantity})
    for (const char* other : {"another", ""}) {
      KnownFailure row = known();
      row.*part = other;
      EXPECT_EQ(night_status(cases, {row}, today).red_count(), 1u)
          << row.case_name << row.method << row.level << row.quantity;
    }
}

TEST(ANightStatus, IsRedWhereTheRowHasExpired) {
  const auto cases = night_with(vnv::Outcome::fails);
  EXPECT_EQ(night_status(cases, {known("2026-11-22")}, today).red_count(), 0u);
  const NightStatus found = night_status(cases, {known("2026-11-21")}, today);
  EXPECT_EQ(found.red_count(), 1u);
  EXPECT_TRUE(contains(index_page(cases, found), "drift expired on 2026-11-21"));
}

TEST(ANightStatus, IsRedWhereAKnownFailurePasses) {
  const auto cases = night_with(vnv::Outcome::holds);
  const NightStatus found = night_status(cases, {known()}, today);
  EXPECT_EQ(found.sentence(), "1 red: 0 unknown or expired failures, 1 unexpected pass; 0 known");
  const std::string html = index_page(cases, found);
  EXPECT_TRUE(contains(html, "unexpected pass of the known failure drift: remove it")) << html;
  EXPECT_TRUE(contains(html, "class=\"sum fails\"")) << html;
}

TEST(ANightStatus, SaysNothingOfWhatWasNotJudged) {
  KnownFailure other = known();
  other.case_name = "couette";
  EXPECT_EQ(night_status(night_with(vnv::Outcome::holds), {other}, today).red_count(), 0u);
}

}  // namespace
}  // namespace touchstone::reports
