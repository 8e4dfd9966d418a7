#include "vnv/record/former.hpp"

#include "vnv/files/data_folder.hpp"
#include "vnv/record/record.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace touchstone::vnv {
namespace {

TEST(FormerNames, AreThoseOfTodayWithAndWithoutTheirUnit) {
  EXPECT_EQ(current_name("critical time step [us]"), "largest stable time step [us]");
  EXPECT_EQ(current_name("period, less the exact"), "relative error of the period");
  EXPECT_EQ(current_name("L2 v_x, row means [%]"), "L2 v_x, row means [%]");
}

TEST(FormerNames, AreFoundWithinOrdersAndAtTheEndsOfNames) {
  EXPECT_EQ(current_name("order of L2 p less its mean, per particle over particles across"),
            "order of L2 p - mean(p), per particle over particles across");
  EXPECT_EQ(current_name("arrival at the far wall, chance of an ensemble so unlike the accepted one [-]"),
            "impact time at the downstream wall, p-value against the accepted ensemble [-]");
}

/// A record as schema 3 had it.
constexpr const char* of_schema_3 =
    R"json({"schema":3,"case_name":"critical_step","title":"","description":"","method":"mpm",
"method_description":"","suite":"acceptance","revision":"","compiler":"","flags":"","machine":"","finished_at":"","runs":[],
"errors":[{"rung":"M1","spacing":1e-3,"time":"nan","quantity":"critical time step over (31) [-]","value":1.11}],
"orders":[{"ladder":"grid","quantity":"L2 p less its mean, per particle [%]","time":1,"order":2,"half_width":0.1,"trend":"converging",
"asymptotic":true,"floor":"nan","floor_half_width":"nan","order_to_floor":"nan","order_to_floor_half_width":"nan","rungs":["M1"],
"spacings":[1e-3],"errors":[0.1],"pairwise":[]}],
"verdicts":[{"case_name":"critical_step","method":"mpm","rung":"M1","spacing":1e-3,"time":"nan","quantity":"critical time step over (31)",
"unit":"","value":1.11,"lower":1,"upper":null,"author":"theory: x","outcome":"holds","margin":0.11,"sentence":"x"}],
"figures":[],"curves":[],"clouds":[],"tables":[],
"diagrams":[{"id":"work","title":"","caption":"","quantity":"L2 v_x [%]","targets":[1],"ranked_by":1}],"work":[]})json";

TEST(FormerRecords, AreReadAsThoseOfToday) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "former.json";
  std::ofstream(file) << of_schema_3;
  const Record record = read_record(file);
  EXPECT_EQ(record.schema, Record{}.schema);
  ASSERT_EQ(record.values.size(), 1u);
  EXPECT_EQ(record.values[0].quantity.heading(), "largest stable time step over the Courant limit (31) [-]");
  EXPECT_EQ(record.values[0].value, 1.11);
  EXPECT_EQ(record.values[0].level, "M1");
  EXPECT_EQ(record.orders[0].levels, std::vector<std::string>{"M1"});
  EXPECT_EQ(record.orders[0].quantity, "L2 p - mean(p), per particle [%]");
  EXPECT_EQ(record.verdicts[0].quantity, "largest stable time step over the Courant limit (31)");
  EXPECT_EQ(record.verdicts[0].lower, 1);
  EXPECT_EQ(record.diagrams[0].quantity.unit, "%");
}

/// Each as the last version that wrote this schema wrote a record in which every field is another than its default.
TEST(FormerRecords, OfEachSchemaAreReadWithAllThatTheyHad) {
  const std::filesystem::path folder = data_folder() / "../vnv/record/former_records";
  for (int schema = 1; schema < Record{}.schema; ++schema) {
    const Record record = read_record(folder / ("of_schema_" + std::to_string(schema) + ".json"));
    SCOPED_TRACE(schema);
    EXPECT_EQ(record.schema, Record{}.schema);
    EXPECT_EQ(record.case_name + "." + record.method, "poiseuille.mpm");
    ASSERT_EQ(record.runs.size(), 1u);
    EXPECT_EQ(record.runs[0].level, "M1");
    EXPECT_EQ(record.runs[0].cost.cpu, 92.5);
    EXPECT_EQ(record.runs[0].cost.repeats, schema == 1 ? 1 : 5);
    EXPECT_EQ(record.runs[0].cost.cpu_highest, schema == 1 ? 92.5 : 94.2);
    EXPECT_EQ(record.runs[0].cost.resource, Resource::cpu);
    ASSERT_EQ(record.values.size(), 1u);
    EXPECT_EQ(record.values[0].quantity.name, "L2 v_x");
    EXPECT_EQ(record.values[0].value, 0.0334);
    ASSERT_EQ(record.orders.size(), 1u);
    EXPECT_EQ(record.orders[0].order, 0.98);
    EXPECT_EQ(record.orders[0].levels, (std::vector<std::string>{"M1", "M2"}));
    EXPECT_EQ(record.orders[0].trend, schema < 3 ? Trend::inconclusive : Trend::stalled);
    ASSERT_EQ(record.verdicts.size(), 1u);
    EXPECT_EQ(record.verdicts[0].upper, 4);
    EXPECT_EQ(record.figures.size() + record.curves.size() + record.clouds.size() + record.tables.size(), 4u);
    EXPECT_EQ(record.diagrams.size() + record.work.size(), schema == 1 ? 0u : 2u);
  }
}

}  // namespace
}  // namespace touchstone::vnv
