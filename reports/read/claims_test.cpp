#include "reports/read/claims.hpp"

#include "reports/testing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

vnv::Record record_of(const std::string& method, std::size_t claims) {
  vnv::Record record = sample_record(method);
  record.suite = "acceptance";
  record.verdicts.assign(claims, sample_verdict(vnv::Outcome::holds, 0.06));
  for (std::size_t k = 0; k < claims; ++k) record.verdicts[k].level = fmt::format("M{}", k);
  return record;
}

const vnv::AcceptedClaims accepted{{},
                                   {{"couette", "mpm", "acceptance", 0, 5, 0},
                                    {"poiseuille", "mpm", "acceptance", 0, 2, 0},
                                    {"poiseuille", "mpm", "nightly", 0, 9, 0},
                                    {"poiseuille", "sph", "acceptance", 0, 3, 0}}};

ClaimsStatus status_of(const std::vector<vnv::Record>& records, bool whole) {
  return claims_status({{"poiseuille", records}}, accepted, whole);
}

TEST(AClaimsStatus, NamesEachMethodThatMakesFewerThanAccepted) {
  EXPECT_EQ(status_of({record_of("mpm", 1), record_of("sph", 3)}, false).missing,
            "1 claim fewer than accepted: poiseuille.mpm (1 of 2 literature)");
}

TEST(AClaimsStatus, MissesAMethodThatWasNotRunOnlyWhereAllWas) {
  const std::vector records{record_of("mpm", 2)};
  EXPECT_EQ(status_of(records, true).missing, "8 claims fewer than accepted: couette.mpm (all), poiseuille.sph (all)");
  EXPECT_EQ(status_of(records, false).missing, "");
  EXPECT_EQ(status_of(records, false).note, "2 of 3 accepted methods were not run. ");
}

TEST(AClaimsStatus, SaysWhatThereIsMoreAndIsNotRedForIt) {
  const ClaimsStatus status = status_of({record_of("mpm", 3), record_of("new", 1)}, false);
  EXPECT_EQ(status.missing, "");
  EXPECT_TRUE(contains(status.note, "2 claims more than accepted: poiseuille.mpm (1), poiseuille.new (1)"))
      << status.note;
}

TEST(AClaimsStatus, CountsNoneWhereOneFails) {
  vnv::Record failing = record_of("mpm", 0);
  failing.verdicts = {sample_verdict(vnv::Outcome::fails, -1)};
  EXPECT_EQ(status_of({failing}, false).missing, "");
}

TEST(AClaimsStatus, OfASuiteThatWasNeverAcceptedSaysSo) {
  EXPECT_TRUE(contains(claims_status({{"poiseuille", {record_of("mpm", 1)}}}, {}, true).note,
                       "No claims of the suite acceptance were accepted yet"));
}

}  // namespace
}  // namespace touchstone::reports
