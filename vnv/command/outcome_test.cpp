#include "vnv/command/outcome.hpp"

#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

class AnOutcome : public testing::Test {
 protected:
  fs::path record_with(const std::vector<Outcome>& outcomes) const {
    Record record;
    for (const Outcome outcome : outcomes) {
      Verdict& verdict = record.verdicts.emplace_back();
      verdict.value = outcome == Outcome::fails ? 2 : 1;
      if (outcome != Outcome::inconclusive) verdict.upper = 1;
      verdict.outcome = outcome;
      verdict.sentence = "small.mpm: L2 = 2: FAILS";
    }
    write(record, folder_ / "small.mpm.json");
    return folder_ / "small.mpm.json";
  }

  const programs::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  const JobResult succeeded_{}, failed_{{.ending = {.status = 1}}}, killed_{{.ending = {.signal = 9}}};
};

TEST_F(AnOutcome, CountsWhatHoldsAndQuotesWhatDoesNot) {
  const MethodOutcome outcome =
      outcome_of("small.mpm", failed_, record_with({Outcome::holds, Outcome::fails, Outcome::inconclusive}), "log");
  EXPECT_EQ(outcome.held, 1);
  EXPECT_EQ(outcome.judged, 3);
  EXPECT_EQ(outcome.failures, std::vector<std::string>(2, "small.mpm: L2 = 2: FAILS"));
  EXPECT_TRUE(is_conclusive(outcome, failed_));
}

TEST_F(AnOutcome, OfAProgramThatWasKilledSaysBySignal) {
  const MethodOutcome outcome = outcome_of("small.mpm", killed_, folder_ / "none.json", "logs/small.mpm.txt");
  ASSERT_EQ(outcome.failures.size(), 1u);
  EXPECT_EQ(outcome.failures[0], "small.mpm: its program was killed by signal 9 (Killed); logs/small.mpm.txt");
  EXPECT_FALSE(is_conclusive(outcome, killed_));
}

TEST_F(AnOutcome, OfAProgramThatFailsThoughAllHoldsIsAFailure) {
  const MethodOutcome outcome = outcome_of("small.mpm", failed_, record_with({Outcome::holds}), "log");
  EXPECT_EQ(outcome.failures.size(), 1u);
  EXPECT_FALSE(is_conclusive(outcome, failed_));
}

TEST_F(AnOutcome, OfAProgramThatCouldNotWriteQuotesIt) {
  const fs::path log = folder_ / "small.mpm.txt";
  std::ofstream(log)
      << "main.cpp:1: Failure\nsmall.mpm: small.mpm.json: cannot be written: No space left\n[FAILED] x\n";
  const MethodOutcome outcome = outcome_of("small.mpm", failed_, folder_ / "none.json", log);
  ASSERT_EQ(outcome.failures.size(), 1u);
  EXPECT_EQ(
      outcome.failures[0],
      "small.mpm: its program ended with status 1: small.mpm.json: cannot be written: No space left; " + log.string());
}

TEST_F(AnOutcome, IsInconclusiveWhereNothingFailed) {
  EXPECT_TRUE(outcome_in(read_record(record_with({Outcome::holds, Outcome::inconclusive}))).is_inconclusive);
  EXPECT_FALSE(outcome_in(read_record(record_with({Outcome::inconclusive, Outcome::fails}))).is_inconclusive);
  EXPECT_FALSE(outcome_in(read_record(record_with({Outcome::holds}))).is_inconclusive);
}

TEST_F(AnOutcome, ThatMayBeTheMachinesIsTriedAgain) {
  Record record;
  record.verdicts.emplace_back().outcome = Outcome::fails;
  EXPECT_TRUE(is_conclusive(outcome_in(record), failed_));
  record.runs.emplace_back().outcome = "died of signal 9: Killed";
  EXPECT_FALSE(is_conclusive(outcome_in(record), failed_));
  record.runs.clear();
  record.verdicts[0].quantity = could_be_assessed;
  EXPECT_FALSE(is_conclusive(outcome_in(record), failed_));
}

TEST_F(AnOutcome, WithoutARecordIsAFailure) {
  const MethodOutcome outcome = outcome_of("small.mpm", succeeded_, folder_ / "none.json", "log");
  EXPECT_EQ(outcome.failures.size(), 1u);
  EXPECT_FALSE(is_conclusive(outcome, succeeded_));
}

TEST(CostOfAMethod, IsInTheResourceThatItsRunsOccupied) {
  Record record;
  record.runs = {{.level = "M1", .cost = {.repeats = 2, .cpu = 3}}};
  EXPECT_EQ(outcome_in(record).spent, 6);
  record.runs[0].cost = {.cpu = not_a_number, .resource = Resource::core, .occupied = 5};
  EXPECT_EQ(outcome_in(record).spent, 5);
  EXPECT_EQ(outcome_in(record).resource, Resource::core);
}

}  // namespace
}  // namespace touchstone::vnv::command
