#include "vnv/command/commands.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::command {
namespace order_test {

class OrderOfATable : public testing::Test {
 protected:
  /// What `vnv order` prints of a table, and its exit status.
  std::string said(const std::string& table, std::optional<double> surely_above = std::nullopt,
                   bool are_values = false) {
    files::write_whole(file, table);
    testing::internal::CaptureStdout();
    std::string refusal;
    try {
      status = order({}, {.file = file.string(), .are_values = are_values, .surely_above = surely_above});
    } catch (const std::invalid_argument& error) {
      refusal = error.what();
    }
    return testing::internal::GetCapturedStdout() + refusal;
  }
  const programs::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "errors.csv";
  int status = -1;
};

TEST_F(OrderOfATable, IsObservedOfEachColumnInAnyOrderOfTheRows) {
  const std::string words = said("spacing,L2,Linf\n0.1,1e-2,0.1\n0.4,16e-2,0.4\n0.2,4e-2,0.2\n", 0.9);
  EXPECT_NE(words.find("L2: observed order 2 +- "), std::string::npos) << words;
  EXPECT_NE(words.find("Linf: observed order 1 +- "), std::string::npos) << words;
  EXPECT_NE(words.find("between neighbours: 2, 2"), std::string::npos) << words;
  EXPECT_EQ(status, all_holds);
}

TEST_F(OrderOfATable, IsNotSurelyAboveALimitThatItsIntervalReaches) {
  said("spacing,L2\n0.1,1e-2\n0.2,5e-2\n0.4,16e-2\n", 1.9);
  EXPECT_EQ(status, something_fails);
  said("spacing,L2\n0.1,1e-2\n0.2,5e-2\n0.4,16e-2\n");
  EXPECT_EQ(status, all_holds) << "nothing was asked";
}

TEST_F(OrderOfATable, IsRefusedOfWhatIsNoLadder) {
  EXPECT_NE(said("spacing\n0.1\n0.2\n").find("expected one table, of a column of spacings"), std::string::npos);
  EXPECT_NE(said("spacing,L2\n-0.1,1\n0.2,2\n").find("expected"), std::string::npos);
}

TEST_F(OrderOfATable, OfValuesIsToldWithTheirExtrapolationAndTheGridConvergenceIndex) {
  const std::string words = said("spacing,drag\n1,1.1\n4,2.6\n2,1.4\n", 1.9, true);
  EXPECT_NE(words.find("drag at spacings 4, 2, 1: observed order 2, extrapolated to 1, "
                       "grid convergence index 0.125 (11.4 %)"),
            std::string::npos)
      << words;
  EXPECT_EQ(status, all_holds);
  EXPECT_NE(said("spacing,drag\n1,1\n2,3\n4,2\n", 1, true).find("oscillates"), std::string::npos);
  EXPECT_EQ(status, something_fails);
  EXPECT_NE(said("spacing,drag\n1,1\n2,3\n", {}, true).find("2 resolutions, expected at least 3"), std::string::npos);
}

}  // namespace order_test
}  // namespace touchstone::vnv::command
