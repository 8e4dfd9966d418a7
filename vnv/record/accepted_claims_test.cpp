#include "vnv/record/accepted_claims.hpp"

#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

constexpr auto* keys = "# title: t\n# revision: r\n# date: d\n# reason: why\n";
constexpr auto* headings = "suite,method,theory [-],literature [-],baseline [-]\n";

class AcceptedClaimsFile : public testing::Test {
 protected:
  AcceptedClaims read(const std::string& text) const {
    std::ofstream(file) << text;
    return read_accepted_claims(file);
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "read without complaint";
  }

  const programs::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "couette.csv";
};

TEST_F(AcceptedClaimsFile, ComesBackAsItWasWritten) {
  AcceptedClaims claims{{"t", "r", "d", "why, in a word"}, {{"couette", "sph", "acceptance", 1, 2, 3}}};
  claims.set({"couette", "mpm", "acceptance", 4, 0, 6});
  claims.set({"couette", "sph", "acceptance", 1, 2, 4});
  write_accepted_claims(file, claims);
  const AcceptedClaims back = read_accepted_claims(file);
  EXPECT_EQ(back.acceptance.reason, "why, in a word");
  ASSERT_EQ(back.rows.size(), 2u);
  EXPECT_EQ(*back.find("couette", "sph", "acceptance"), (ClaimCount{"couette", "sph", "acceptance", 1, 2, 4}));
  EXPECT_EQ(back.find("couette", "sph", "nightly"), nullptr);
  EXPECT_EQ(read_all_accepted_claims(folder.path()).rows, back.rows);
}

TEST_F(AcceptedClaimsFile, IsNotThereWithoutClaims) {
  EXPECT_TRUE(read_accepted_claims(file).rows.empty());
  write_accepted_claims(file, {{"t", "r", "d", "why"}, {{"couette", "sph", "acceptance", 1, 2, 3}}});
  write_accepted_claims(file, {});
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_THROW(read_all_accepted_claims(folder.path() / "nowhere"), std::runtime_error);
}

TEST_F(AcceptedClaimsFile, IsRefusedWhereACountIsNoneOrStandsTwice) {
  const std::string head = std::string(keys) + headings;
  EXPECT_EQ(read(head + "nightly,mpm,1,2,3\n").rows.front().total(), 6);
  EXPECT_NE(refusal(head + "nightly,mpm,1,-2,3\n").find("couette.csv:6: -2 claims, expected a whole number"),
            std::string::npos);
  EXPECT_NE(refusal(head + "nightly,mpm,1,1e81,3\n").find("1e+81 claims, expected a whole number from 0 to a million"),
            std::string::npos)
      << "no long holds it: none would be missing";
  EXPECT_NE(refusal(head + "nightly,mpm,1,2,3\nnightly,mpm,1,2,4\n").find("mpm of nightly twice, expected it once"),
            std::string::npos);
}

TEST(AcceptedClaims, AreMissingAuthorByAuthor) {
  const ClaimCount accepted{"couette", "mpm", "acceptance", 30, 0, 4};
  EXPECT_EQ(missing_of(accepted, {"", "", "", 28, 9, 5}), 2);
  EXPECT_EQ(missing_in_words(accepted, {"", "", "", 28, 9, 3}), "2 of 30 theory, 1 of 4 baseline");
  EXPECT_EQ(missing_in_words(accepted, {}), "all");
  EXPECT_EQ(missing_of(accepted, {"", "", "", 31, 9, 5}), 0);
}

TEST(AcceptedClaims, AreCountedByTheirAuthor) {
  Record record;
  record.case_name = "couette";
  record.method = "mpm";
  record.suite = "acceptance";
  for (const char* author : {"theory: a", "theory: b", "literature: c", "baseline: d", "baseline: d"})
    record.verdicts.emplace_back().author = author;  // the last one twice: a value that stands at a place where another is
  record.verdicts.emplace_back().quantity = never_accepted;
  EXPECT_EQ(claims_in(record), (ClaimCount{"couette", "mpm", "acceptance", 2, 1, 1}));
}

}  // namespace
}  // namespace touchstone::vnv
