#include "reports/read/cases.hpp"
#include "reports/pages/pages.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::reports {
namespace {

using vnv::Outcome;

class Cases : public testing::Test {
 protected:
  void put(const vnv::Record& record) const {
    vnv::write(record, folder / (record.case_name + "." + record.method + ".json"));
  }
  std::string refusal() const {
    try {
      read_cases(folder.path());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "read without complaint";
  }
  ScratchFolder folder;
};

TEST_F(Cases, JoinTheMethodsOfACase) {
  vnv::Record other = sample_record();
  other.case_name = "couette";
  for (const auto& record : {sample_record("sph"), sample_record("mpm"), other}) put(record);
  const auto cases = read_cases(folder.path());
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].name, "couette");
  ASSERT_EQ(cases[1].records.size(), 2u);
  EXPECT_EQ(cases[1].records[0].method, "mpm");
}

TEST_F(Cases, DeclareAFigureOnce) {
  const CaseRecords records{"poiseuille", {sample_record("mpm"), sample_record("sph")}};
  EXPECT_EQ(each_once(records, &vnv::Record::figures).size(), 1u);
}

TEST_F(Cases, JoinTheRowsOfATable) {
  vnv::Record record = sample_record();
  record.tables = {{"norms", "Norms", "", {"level"}, {{std::string("M1")}}}};
  const auto tables = tables_of({"poiseuille", {record, record}});
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].rows.size(), 2u);
}

TEST_F(Cases, WithoutTheirFolderAreRefused) { EXPECT_THROW(read_cases(folder / "nowhere"), std::runtime_error); }

TEST_F(Cases, WithoutRecordsAreRefused) { EXPECT_TRUE(contains(refusal(), "no records in it")) << refusal(); }

TEST_F(Cases, WithATornRecordAreRefusedByItsName) {
  std::ofstream(folder / "torn.json") << "{\"schema\":1,";
  EXPECT_TRUE(contains(refusal(), "torn.json")) << refusal();
}

TEST_F(Cases, WithANameThatLeavesTheirFolderAreRefused) {
  vnv::Record record = sample_record();
  record.case_name = "../elsewhere";
  vnv::write(record, folder / "record.json");
  EXPECT_TRUE(contains(refusal(), "case_name is '../elsewhere'")) << refusal();
}

TEST_F(Cases, WithACurveOfNoFigureAreRefused) {
  vnv::Record record = sample_record();
  record.curves[0].figure = "profil";
  put(record);
  EXPECT_TRUE(contains(refusal(), "'profil', which no record declares")) << refusal();
}

TEST_F(Cases, WithCurvesAmongCloudsAreRefused) {
  vnv::Record record = sample_record();
  record.clouds = {{"profile", "MPM", "t = 0 s", {}, {}, {}}};
  put(record);
  EXPECT_TRUE(contains(refusal(), "curves and clouds")) << refusal();
}

TEST_F(Cases, WithOneTableUnderTwoHeadingsAreRefused) {
  vnv::Record mpm = sample_record("mpm"), sph = sample_record("sph");
  mpm.tables = {{"norms", "", "", {"level"}, {}}};
  sph.tables = {{"norms", "", "", {"quantity"}, {}}};
  put(mpm);
  put(sph);
  EXPECT_TRUE(contains(refusal(), "table 'norms'")) << refusal();
}

TEST(ErrorsTable, GivesNoTimeToWhatBelongsToAWholeRun) {
  vnv::Record record = sample_record();
  record.values = {{"M1", 1e-3, std::nan(""), {"largest stable time step", "us", vnv::Kind::stability_limit}, 42.5}};
  const std::string html = case_page({"poiseuille", {record}}, {}, {});
  EXPECT_NE(html.find("42.5"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos) << html;
}

TEST(Tally, CountsEveryOutcome) {
  const Tally sum = tally({sample_verdict(Outcome::holds, 0.5), sample_verdict(Outcome::fails, -0.2),
                           sample_verdict(Outcome::inconclusive, vnv::not_a_number)});
  EXPECT_EQ(sum.holds, 1);
  EXPECT_EQ(sum.fails, 1);
  EXPECT_EQ(sum.inconclusive, 1);
  EXPECT_EQ(sum.worst(), Outcome::fails);
}

TEST(Tally, CountsWhoSetTheLimits) {
  vnv::Verdict theory = sample_verdict(Outcome::holds, 0.5), baseline = sample_verdict(Outcome::fails, -1);
  theory.author = "theory: of second order";
  baseline.author = "baseline: as measured";
  const Tally sum = tally({theory, baseline, baseline, sample_verdict(Outcome::inconclusive, 0)});
  EXPECT_EQ(std::tuple(sum.theory, sum.literature, sum.baseline), std::tuple(1, 1, 2));
}

TEST(Margin, IsNoneOfALimitThatIsMetToTheDigit) {
  EXPECT_FALSE(has_margin(sample_verdict(Outcome::holds, 0)));
  EXPECT_TRUE(has_margin(sample_verdict(Outcome::holds, 0.5)));
  EXPECT_TRUE(has_margin(sample_verdict(Outcome::fails, 0)));
}

TEST(Tally, OfNothingProvesNothing) { EXPECT_EQ(tally({}).worst(), Outcome::inconclusive); }

}  // namespace
}  // namespace touchstone::reports
