#include "vnv/command/commands.hpp"
#include "vnv/programs/scratch_folder.hpp"
#include "vnv/record/accepted_claims.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

/// Records of two methods with two claims each, and an empty list of what was accepted.
class AcceptedClaimsOfRecords : public testing::Test {
 protected:
  AcceptedClaimsOfRecords() {
    for (const char* mark : {"DASHBOARD_TEST_FROM_CTEST", "CTEST_INTERACTIVE_DEBUG_MODE"}) unsetenv(mark);
    fs::create_directories(records_);
    for (const char* method : {"mpm", "sph"}) put(method, 2);
  }
  void put(const std::string& method, std::size_t claims, Outcome outcome = Outcome::holds) const {
    Record record;
    record.case_name = "couette";
    record.method = method;
    record.suite = "acceptance";
    record.revision = record.finished_at = "made up";
    record.verdicts.resize(claims);
    for (Verdict& v : record.verdicts) {
      v.author = "theory: made up";
      v.time = static_cast<double>(&v - record.verdicts.data());
      v.value = outcome == Outcome::holds ? 1 : 2;
      v.upper = 1;
      v.outcome = outcome;
    }
    write(record, records_ / ("couette." + method + ".json"));
  }
  int accept_all() const {
    return accept({.folder = scratch_.path(), .data = data_},
                  {.patterns = {"couette"}, .reason = "made up", .claims = records_});
  }
  std::vector<ClaimCount> accepted() const { return read_accepted_claims(claims_file(data_, "couette")).rows; }

  const programs::ScratchFolder scratch_;
  const fs::path records_ = scratch_.path() / "records", data_ = scratch_.path() / "data";
};

TEST_F(AcceptedClaimsOfRecords, AreCountedAndForgottenWhereThereIsNoRecordAnyMore) {
  EXPECT_EQ(accept_all(), all_holds);
  EXPECT_EQ(accepted(), (std::vector<ClaimCount>{{"couette", "mpm", "acceptance", 2, 0, 0},
                                                 {"couette", "sph", "acceptance", 2, 0, 0}}));
  put("mpm", 1);
  fs::remove(records_ / "couette.sph.json");
  EXPECT_EQ(accept_all(), all_holds);
  EXPECT_EQ(accepted(), (std::vector<ClaimCount>{{"couette", "mpm", "acceptance", 1, 0, 0}}));
}

TEST_F(AcceptedClaimsOfRecords, AreNotAcceptedWhereOneFailsNorInATest) {
  accept_all();
  put("sph", 1, Outcome::fails);
  EXPECT_EQ(accept_all(), something_fails);
  EXPECT_EQ(accepted()[1].theory, 2);
  setenv("DASHBOARD_TEST_FROM_CTEST", "1", 1);
  EXPECT_THROW(accept_all(), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv::command
