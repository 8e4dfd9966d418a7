#include "reports/compare/work_precision.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace touchstone::reports {
namespace {

vnv::WorkPoint point(const std::string& series, double cpu, double error, double particles = 800) {
  return {.diagram = "work",
          .series = series,
          .family = series.starts_with("mpm") ? "MPM" : "SPH",
          .particles = particles,
          .per_step = cpu / 1000,
          .error = error,
          .cpu = cpu,
          .cpu_lowest = 0.9 * cpu,
          .cpu_highest = 1.1 * cpu};
}

vnv::WorkPoint published(const std::string& series, const std::string& family, double cpu, double error) {
  vnv::WorkPoint p = point(series, cpu, error);
  p.family = family;
  p.elsewhere = true;
  return p;
}

const vnv::WorkDiagram diagram{"work", "Work-precision diagram", "At 1 s.", {"L2", "%", vnv::Kind::norm}, {1, 0.1}, 1};

/// mpm reaches 1 % in 2 s, sph in 20 s; the paper's pair is there twice, once a record.
CaseRecords two_methods() {
  CaseRecords records{"poiseuille", {sample_record("mpm"), sample_record("sph")}};
  records.records[0].work = {point("mpm", 1, 2), point("mpm", 4, 0.5), point("mpm", 5, 3)};
  records.records[1].work = {point("sph", 10, 2), point("sph", 40, 0.5)};
  for (auto& record : records.records) {
    record.diagrams = {diagram};
    record.work.push_back(published("paper MPM", "MPM", 100, 2));
    record.work.push_back(published("paper SPH", "SPH", 1100, 3));
  }
  return records;
}

const vnv::Curve* find_curve(const CaseRecords& records, const std::string& label) {
  for (const auto& record : records.records)
    for (const auto& curve : record.curves)
      if (curve.figure == "work" && curve.label == label) return &curve;
  return nullptr;
}

const vnv::Table& find_table(const CaseRecords& records, const std::string& id) {
  return *std::ranges::find(records.records.front().tables, id, &vnv::Table::id);
}

TEST(WorkPrecision, DrawsEachMethodsFrontAndWhatNoRunBeats) {
  CaseRecords records = two_methods();
  add_work_precision(records);
  EXPECT_EQ(each_once(records, &vnv::Record::figures).back().id, "work");
  EXPECT_EQ(find_curve(records, "mpm")->x, (std::vector<double>{1, 4}));
  EXPECT_EQ(find_curve(records, "Pareto front of all methods here")->x, (std::vector<double>{1, 4}));
  EXPECT_EQ(find_curve(records, "beaten by another run of its method")->x, (std::vector<double>{5}));
  EXPECT_EQ(find_curve(records, "paper SPH")->role, vnv::Role::published);
}

TEST(WorkPrecision, ComparesWhatOneMachineRanAndSaysWhich) {
  CaseRecords records = two_methods();
  records.records.push_back(records.records[1]);
  for (vnv::Record& record : records.records) {
    record.host = "n1";
    record.machine = "a machine";
  }
  vnv::Record& other = records.records[2];
  other.host = "n2";
  other.method = "sph_elsewhere";
  for (vnv::WorkPoint& p : other.work)
    if (!p.elsewhere) p.series = other.method;
  add_work_precision(records);
  EXPECT_TRUE(each_once(records, &vnv::Record::figures).back().caption.ends_with("run on one: n1, a machine."));
  EXPECT_FALSE(find_curve(records, "sph_elsewhere"));
  ASSERT_TRUE(find_curve(records, "sph_elsewhere on n2"));
  EXPECT_EQ(find_curve(records, "sph_elsewhere on n2")->role, vnv::Role::published);
  EXPECT_EQ(find_table(records, "work_ratios").columns.size(), 5u) << "no ratio of two machines";
}

TEST(WorkPrecision, RanksMethodsByTheTimeToAnError) {
  CaseRecords records = two_methods();
  add_work_precision(records);
  const vnv::Table costs = find_table(records, "work_prices");
  ASSERT_EQ(costs.rows.size(), 4u);
  EXPECT_EQ(std::get<std::string>(costs.rows[0][1]), "mpm");
  EXPECT_EQ(std::get<std::string>(costs.rows[0][2]), "2 (0.9 to 4.4)");
  EXPECT_EQ(std::get<std::string>(costs.rows[0][3]), "not reached");
  EXPECT_EQ(std::get<std::string>(costs.rows[1][1]), "sph");
  EXPECT_EQ(std::get<std::string>(costs.rows[2][1]), "paper MPM, measured elsewhere");
}

/// Two methods with errors of 1.6, 0.4 and 0.1 % at 1 s, in 1, 2 and 4 s and in as long; of them only the first
/// declares the diagram.
CaseRecords one_declares() {
  CaseRecords records{"poiseuille", {sample_record("mpm"), sample_record("another code")}};
  for (auto& record : records.records) {
    record.values = errors_of(sample_order());
    record.runs = {sample_run("M1", 1), sample_run("M2", 2), sample_run("M3", 4)};
  }
  records.records[0].diagrams = {
      {.id = "work", .title = "Work", .caption = "", .quantity = records.records[0].values[0].quantity, .targets = {}}};
  return records;
}

TEST(WorkPrecision, JoinsWhoeverMeasuredTheQuantityAtTheSameTime) {
  CaseRecords records = one_declares();
  add_work_precision(records);
  EXPECT_EQ(find_curve(records, "mpm")->y, (std::vector<double>{1.6, 0.4, 0.1}));
  EXPECT_EQ(find_curve(records, "another code")->y, (std::vector<double>{1.6, 0.4, 0.1}));
  EXPECT_EQ(find_curve(records, "beaten by another run of its method"), nullptr) << "all are on their fronts";
  const std::string caption = each_once(records, &vnv::Record::figures).back().caption;
  EXPECT_TRUE(caption.starts_with("L2 v_x, at t = 1 s, against CPU time up to then (longer")) << caption;
}

TEST(WorkPrecision, TakesNoOtherQuantityForThisOneByItsName) {
  CaseRecords records = one_declares();
  for (auto& value : records.records[1].values) value.quantity.kind = vnv::Kind::error;
  add_work_precision(records);
  EXPECT_NE(find_curve(records, "mpm"), nullptr);
  EXPECT_EQ(find_curve(records, "another code"), nullptr);
}

TEST(WorkPrecision, IsOfTheTimeAtWhichMostMethodsHaveALadder) {
  CaseRecords records = one_declares();
  const auto later = errors_of(sample_order("L2 v_x [%]", 2, 2));
  for (auto& record : records.records) {
    for (auto& run : record.runs) run.end_time = 2;
    record.values.insert(record.values.begin(), later.begin(), later.end());
  }
  add_work_precision(records);
  EXPECT_EQ(find_curve(records, "mpm")->x, (std::vector<double>{0.5, 1, 2})) << "half of each run";
}

TEST(WorkPrecision, AsksForErrorsThatTwoMethodsReachAndRanksByWhatHalfOfThemDo) {
  CaseRecords records = one_declares();
  for (auto& value : records.records[1].values) value.value /= 100;
  add_work_precision(records);
  const vnv::Table costs = find_table(records, "work_prices");
  EXPECT_EQ(costs.columns, (std::vector<std::string>{"rank", "method", "CPU to 1 % [s]", "CPU to 0.3 % [s]",
                                                     "CPU to 0.1 % [s]", "smallest error"}));
  EXPECT_TRUE(costs.caption.ends_with("Ranked by the time to 0.1 %.")) << costs.caption;
}

TEST(WorkPrecision, SetsWhatOccupiesAnotherResourceInADiagramOfItsOwn) {
  CaseRecords records = one_declares();
  for (auto& run : records.records[1].runs) {
    run.cost.resource = vnv::Resource::gpu;
    run.cost.occupied = 8;
    run.cost.cpu = vnv::not_a_number;
  }
  add_work_precision(records);
  EXPECT_EQ(find_curve(records, "another code"), nullptr) << "beside CPU times";
  const auto& curves = records.records[1].curves;
  EXPECT_EQ(std::ranges::count(curves, "work_GPU", &vnv::Curve::figure), 1);
  const auto figures = each_once(records, &vnv::Record::figures);
  const auto own = std::ranges::find(figures, "work_GPU", &vnv::Figure::id);
  ASSERT_NE(own, figures.end());
  EXPECT_EQ(own->x.label, "GPU time [s]");
  EXPECT_TRUE(contains(own->caption, "against GPU time up to then (longer")) << own->caption;
}

TEST(WorkPrecision, SaysWhatDoesNotCompareInItsTimes) {
  CaseRecords records = one_declares(), of_another_code = records, on_another_machine = records;
  of_another_code.records[1].another_code = true;
  on_another_machine.records[1].machine = "another";
  for (CaseRecords* each : {&records, &of_another_code, &on_another_machine}) add_work_precision(*each);
  const auto says = [](const CaseRecords& of, const char* words) {
    return contains(each_once(of, &vnv::Record::figures).back().caption, words);
  };
  EXPECT_FALSE(says(records, "its start and its output"));
  EXPECT_TRUE(says(of_another_code, "its start and its output"));
  EXPECT_FALSE(says(records, "measured elsewhere, on other machines"));
  EXPECT_TRUE(says(on_another_machine, "measured elsewhere, on other machines"));
}

TEST(CostRatios, SetEqualParticleNumberBesideEqualError) {
  const auto records = two_methods();
  std::vector<vnv::WorkPoint> points = records.records[0].work;
  points.insert(points.end(), records.records[1].work.begin(), records.records[1].work.end());
  const vnv::Table table = cost_ratios(diagram, points);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"at equal", "of", "SPH over MPM, Sun et al.",
                                                     "SPH over MPM, cheapest SPH here", "SPH over MPM, sph"}));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][2]), 11);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][3]), 10);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][4]), 10);
  EXPECT_EQ(std::get<std::string>(table.rows[1][3]), "10");
  EXPECT_EQ(std::get<std::string>(table.rows[2][2]), "neither reaches it");
}

TEST(CostRatios, SayWhoDoesNotReachAnError) {
  const vnv::Table table = cost_ratios(diagram, {point("mpm", 1, 2), point("mpm", 4, 0.05), point("sph", 10, 2)});
  EXPECT_EQ(std::get<std::string>(table.rows[1][2]), "SPH does not reach it");
}

/// What is said of 1 % where `mpm` and `sph` have these errors [%] in 1 and 4 s, and in 10 and 40 s.
std::string ratio_at_one_per_cent(const std::array<double, 2>& mpm, const std::array<double, 2>& sph) {
  const vnv::Table table = cost_ratios(
      diagram, {point("mpm", 1, mpm[0]), point("mpm", 4, mpm[1]), point("sph", 10, sph[0]), point("sph", 40, sph[1])});
  return std::get<std::string>(table.rows[1][2]);
}

TEST(CostRatios, AreBoundedWhereTheCheapestRunIsBetterThanAskedAlready) {
  EXPECT_EQ(ratio_at_one_per_cent({2, 0.5}, {2, 0.5}), "10");
  EXPECT_EQ(ratio_at_one_per_cent({2, 0.5}, {0.9, 0.5}), "≤ 5");
  EXPECT_EQ(ratio_at_one_per_cent({0.9, 0.5}, {2, 0.5}), "≥ 20");
  EXPECT_EQ(ratio_at_one_per_cent({0.9, 0.5}, {0.9, 0.5}), "about 10");
}

TEST(CostRatios, AreNoneWithoutBothFamilies) { EXPECT_TRUE(cost_ratios(diagram, {point("mpm", 1, 2)}).rows.empty()); }

/// mpm falls to 0.1 % in 4 s; sph has 10 times the error and takes half the time; crude stays at 50 %.
CaseRecords three_methods() {
  CaseRecords records{"poiseuille", {sample_record("crude"), sample_record("mpm"), sample_record("sph")}};
  for (auto& record : records.records) {
    record.values = errors_of(sample_order());
    const double factor = record.method == "mpm" ? 1 : 0.5;
    record.runs = {sample_run("M1", factor * 1), sample_run("M2", factor * 2), sample_run("M3", factor * 4)};
  }
  for (auto& error : records.records[0].values) error.value = 50;
  for (auto& error : records.records[2].values) error.value *= 10;
  return records;
}

std::optional<Cheapest> found(const CaseRecords& records) { return cheapest(records, {"L2 v_x [%]", 1}); }

TEST(Cheapest, IsAskedForTheSmallestErrorThatTwoMethodsReach) {
  const auto answer = found(three_methods());
  ASSERT_TRUE(answer);
  EXPECT_DOUBLE_EQ(answer->error, 1);
  EXPECT_EQ(answer->best.method, "mpm");
  EXPECT_EQ(answer->next.method, "sph");
  EXPECT_DOUBLE_EQ(answer->next.time.cpu, 2);
}

TEST(Cheapest, InterpolatesBetweenRuns) {
  const auto answer = found(three_methods());
  EXPECT_NEAR(answer->best.time.cpu, 1.265, 1e-3);  // error ~ CPU^-2, and 1.6 % costs 1 s
}

TEST(Cheapest, OfAnotherQuantityOrTimeIsAnotherQuestion) {
  CaseRecords records = three_methods();
  records.records[1].values.push_back({"M1", 4e-3, 1, {"Linf v_x", "%", vnv::Kind::norm}, 1e-9});
  records.records[1].values.push_back({"M1", 4e-3, 0.1, {"L2 v_x", "%", vnv::Kind::norm}, 1e-9});
  EXPECT_NEAR(found(records)->best.time.cpu, 1.265, 1e-3);
  EXPECT_FALSE(cheapest(records, {"Linf v_x [%]", 1}));
}

TEST(Cheapest, ChargesARunOnlyForAsFarAsItWentWhenItWasMeasured) {
  CaseRecords records = three_methods();
  for (auto& run : records.records[2].runs) {
    run.end_time = 10;
    run.cost.cpu *= 10;
  }
  EXPECT_DOUBLE_EQ(found(records)->next.time.cpu, 2);
}

TEST(Cheapest, LeavesOutRunsThatDidNotFinish) {
  CaseRecords records = three_methods();
  records.records[1].runs[2].finished = false;
  records.records[1].runs[1].finished = false;
  EXPECT_DOUBLE_EQ(found(records)->error, 1.6);
}

TEST(Cheapest, IsNoRunThatOccupiedAnotherResourceThanCpuTime) {
  CaseRecords records = three_methods();
  records.records.push_back(records.records[1]);
  for (vnv::Record* record : {&records.records[0], &records.records.back()}) {
    record->method += " on a GPU";
    record->machine = "another";
    record->values = errors_of(sample_order());
    for (auto& run : record->runs) {
      run.cost.resource = vnv::Resource::gpu;
      run.cost.occupied = 1e-3;
      run.cost.cpu = vnv::not_a_number;
    }
  }
  const auto answer = found(records);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->best.method, "mpm");
  EXPECT_EQ(answer->next.method, "sph");
}

TEST(Cheapest, IsAskedForOnTheMachineThatRanMost) {
  CaseRecords records = three_methods();
  records.records[2].host = "n2";
  EXPECT_EQ(found(records)->best.method, "crude") << "sph ran on another machine than the other two";
  records.records[1].host = "n2";
  EXPECT_EQ(found(records)->next.method, "sph");
  EXPECT_EQ(found(records)->machine, vnv::one_machine(records.records[2]));
}

TEST(Cheapest, IsNotAskedForAcrossMachinesOrOfOneMethod) {
  CaseRecords records = three_methods();
  for (vnv::Record& record : records.records) record.machine = record.method;
  EXPECT_FALSE(found(records));
  records = three_methods();
  records.records.resize(1);
  EXPECT_FALSE(found(records));
  records.records.push_back(records.records[0]);
  EXPECT_FALSE(found(records)) << "two records of one method are one method";
}

}  // namespace
}  // namespace touchstone::reports
