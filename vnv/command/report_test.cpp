#include "vnv/command/commands.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

/// A build folder whose page maker writes down what it is asked for.
class AReport : public testing::Test {
 protected:
  AReport() {
    build_.folder = scratch_.path();
    put("CMakeCache.txt", "TOUCHSTONE_HISTORY:PATH=/nights\nCMAKE_HOME_DIRECTORY:INTERNAL=" + root() + "\n");
    put("data/known_failures.csv", "");
    put("reports/touchstone_report", "#!/bin/sh\necho \"$@\" > \"$0.asked\"\n");
    fs::permissions(scratch_.path() / "reports/touchstone_report", fs::perms::owner_all);
  }

  std::string root() const { return scratch_.path(); }

  void put(const std::string& name, const std::string& text) const {
    fs::create_directories((scratch_.path() / name).parent_path());
    std::ofstream(scratch_.path() / name) << text;
  }

  /// What the page maker is asked for.
  std::string asked_by(const ReportOptions& options) {
    report(build_, options);
    return asked();
  }
  std::string asked() const {
    std::ifstream asked(scratch_.path() / "reports/touchstone_report.asked");
    std::string line;
    std::getline(asked, line);
    return line;
  }

  const programs::ScratchFolder scratch_;
  Build build_;
};

TEST_F(AReport, KnowsWhichClaimsAreKnownToFail) {
  const std::string pages = root() + "/records/acceptance " + root() + "/site/acceptance";
  EXPECT_EQ(asked_by({}), pages + " --known-failures " + root() + "/data/known_failures.csv");
  EXPECT_EQ(asked_by({.known_failures = "mine.csv"}), pages + " --known-failures mine.csv");
  fs::remove(root() + "/data/known_failures.csv");
  EXPECT_EQ(asked_by({}), pages);
}

TEST_F(AReport, ShowsWhatCameOfSeededFaults) {
  fs::remove(root() + "/data/known_failures.csv");
  EXPECT_EQ(asked_by({.records = "records", .site = "site", .faults = "mine.csv"}), "records site --faults mine.csv");
  put("vnv/trials/faults/trials.csv", "");
  EXPECT_EQ(asked_by({.records = "records", .site = "site"}),
            "records site --faults " + root() + "/vnv/trials/faults/trials.csv");
}

TEST_F(AReport, LetsOnlyTheNightsOfABuildJoinItsHistory) {
  fs::remove(root() + "/data/known_failures.csv");
  EXPECT_EQ(asked_by({.suite = "nightly"}), root() + "/records/nightly " + root() + "/site/nightly --history /nights");
  EXPECT_EQ(asked_by({.records = "my_records", .site = "my_site", .suite = "nightly"}), "my_records my_site");
  EXPECT_EQ(asked_by({.records = "my_records", .site = "my_site", .history = "my_nights"}),
            "my_records my_site --history my_nights");
}

TEST_F(AReport, ForAPaperIsOfOneCaseWithTheLiteratureOfTheData) {
  EXPECT_EQ(export_case(build_, {.case_name = "couette"}), all_holds);
  EXPECT_EQ(asked(), root() + "/records/acceptance " + root() + "/export/couette --paper couette --references " +
                         root() + "/data/references.bib");
  export_case(build_, {.case_name = "couette", .records = "mine", .folder = "paper"});
  EXPECT_EQ(asked().substr(0, 26), "mine paper --paper couette");
  put("reports/touchstone_report", "#!/bin/sh\nexit 3\n");
  EXPECT_EQ(export_case(build_, {.case_name = "nonsense"}), bad_input) << "of which the report has said why";
}

}  // namespace
}  // namespace touchstone::vnv::command
