#include "vnv/command/values.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::command {
namespace values_test {

std::string printed(const Record& record) {
  testing::internal::CaptureStdout();
  print_values(record);
  return testing::internal::GetCapturedStdout();
}

const Quantity error{"L2 v", "%", Kind::norm, Better::smaller}, pressure{"central pressure", "Pa", Kind::value};

Record of_two_levels() {
  Record record;
  for (const double spacing : {0.1, 0.05})
    for (const double time : {0.5, 1.0})
      record.values.push_back({spacing == 0.1 ? "10 across" : "20 across", spacing, time, error, 100 * spacing * time});
  return record;
}

TEST(Values, StandInARowForAQuantityAndATimeAndAColumnForALevel) {
  const std::string text = printed(of_two_levels());
  EXPECT_NE(text.find("quantity       time [s]        10 across        20 across\n"), std::string::npos) << text;
  EXPECT_NE(text.find("L2 v [%]            0.5                5              2.5  not limited\n"), std::string::npos)
      << text;
}

TEST(Values, ThatAreFollowedOverManyTimesAreToldByTheirExtremes) {
  Record record;
  for (int k = 0; k < 20; ++k) record.values.push_back({"10 across", 0.1, 0.1 * k, pressure, (k * 7) % 20 + 1.0});
  const std::string text = printed(record);
  EXPECT_NE(text.find("central pressure [Pa]       0 to 1.9          1 to 20  not limited\n"), std::string::npos)
      << text;
  record.values[3].value = not_a_number;
  EXPECT_NE(printed(record).find(" nan"), std::string::npos) << "what is no number is not lost among the others";
}

TEST(Values, ThatAClaimLimitsAreNotMarked) {
  Record record = of_two_levels();
  Verdict& verdict = record.verdicts.emplace_back();
  verdict.level = "20 across";
  verdict.quantity = error.name;
  EXPECT_EQ(printed(record).find("not limited"), std::string::npos);
}

}  // namespace values_test
}  // namespace touchstone::vnv::command
