#include "reports/read/night.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

vnv::Record nightly_record() {
  vnv::Record record = sample_record();
  record.suite = "nightly";
  record.revision = "bbb2d82-dirty";
  record.finished_at = "2026-11-22T17:25:34Z";
  record.machine = "a \"machine\"";
  record.runs = {sample_run("M2", 3)};
  record.orders = {sample_order()};
  record.values = {{"M2", 1e-4, 1, {"L2 v_x", "%", vnv::Kind::norm}, 1.5},
                   {"M2",
                    1e-4,
                    vnv::not_a_number,
                    {"largest stable time step, lower bound", "us", vnv::Kind::stability_limit},
                    7.25}};
  return record;
}
Night sample_night() { return night_of({{"poiseuille", {nightly_record()}}}); }

class NightFile : public testing::Test {
 protected:
  fs::path file(const Night& night) const { return folder / file_name(night); }
  std::string refusal(const Night& night) const try {
    read_night(file(night));
    return "read without complaint";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  void put(const Night& night, const std::string& text) const { std::ofstream(file(night)) << text; }

  ScratchFolder folder;
};

TEST_F(NightFile, IsNamedAfterItsEndAndItsRevision) {
  EXPECT_EQ(file_name(sample_night()), "2026-11-22T172534Z_bbb2d82-dirty.jsonl");
}

TEST_F(NightFile, ComesBackAsItWas) {
  Night night = sample_night();
  night.limits[0].time = 2;  // two that are not numbers are not equal
  night.runs[0].particle_steps_per_second = 1;
  night.verdicts[0].spacing = night.verdicts[0].time = 1;
  write_night(night, folder.path());
  EXPECT_EQ(read_night(file(night)), night);
}

TEST_F(NightFile, TellsLimitsFromErrorsAndAnOrderAboveItsFloor) {
  vnv::Record record = nightly_record();
  record.orders[0].floor = 0.1;
  record.orders[0].order_to_floor = 2.5;
  record.orders[0].order_to_floor_half_width = 0.25;
  const Night night = night_of({{"poiseuille", {record}}});
  EXPECT_EQ(night.errors.size(), 1u);
  EXPECT_EQ(night.limits.at(0).quantity, "largest stable time step, lower bound [us]");
  EXPECT_EQ(night.orders.at(0).order, 2.5);
  EXPECT_EQ(night.orders.at(0).half_width, 0.25);
  EXPECT_EQ(sample_night().orders.at(0).order, sample_order().order);
  EXPECT_EQ(sample_night().orders.at(0).half_width, sample_order().half_width);
}

TEST_F(NightFile, KeepsWhatIsNotANumber) {
  Night night = sample_night();
  night.verdicts[0].value = vnv::not_a_number;
  night.errors[0].value = -INFINITY;
  write_night(night, folder.path());
  EXPECT_TRUE(contains(read_whole(file(night)), "\"value\":\"nan\""));
  const Night read = read_night(file(night));
  EXPECT_TRUE(std::isnan(read.verdicts[0].value));
  EXPECT_EQ(read.errors[0].value, -INFINITY);
}

TEST_F(NightFile, WrittenTwiceIsOne) {
  write_night(sample_night(), folder.path());
  const std::string first = read_whole(file(sample_night()));
  write_night(sample_night(), folder.path());
  EXPECT_EQ(read_whole(file(sample_night())), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST_F(NightFile, OfATimeWithoutMachinesOfMethodsHasItsOwn) {
  const Night night = sample_night();
  write_night(night, folder.path());
  const std::string text = read_whole(file(night)), key = ",\"machine\":\"a \\\"machine\\\"\"";
  const std::size_t place = text.rfind(key);
  ASSERT_GT(place, text.find('\n'));
  put(night, std::string(text).erase(place, key.size()));
  const Night read = read_night(file(night));
  ASSERT_EQ(read.runs.size(), night.runs.size());
  for (std::size_t k = 0; k < read.runs.size(); ++k) EXPECT_EQ(read.runs[k].machine, night.runs[k].machine);
}

TEST_F(NightFile, ThatIsTornIsRefusedWithItsLine) {
  const Night night = sample_night();
  write_night(night, folder.path());
  const std::string whole = read_whole(file(night));
  put(night, whole.substr(0, whole.size() - 20));
  EXPECT_TRUE(contains(refusal(night), ".jsonl:6: not a complete JSON line")) << refusal(night);
  put(night, whole.substr(0, whole.rfind("{")));
  EXPECT_TRUE(contains(refusal(night), "4 lines below the header, expected 5")) << refusal(night);
  put(night, "");
  EXPECT_TRUE(contains(refusal(night), "is empty")) << refusal(night);
}

TEST_F(NightFile, OfAnotherKindIsRefused) {
  const Night night = sample_night();
  put(night, "{\"schema\":3}\n");
  EXPECT_TRUE(contains(refusal(night), ":1: no night")) << refusal(night);
  put(night, "{\"night\":2,\"lines\":0}\n");
  EXPECT_TRUE(contains(refusal(night), "night is 2, expected 1")) << refusal(night);
}

TEST_F(NightFile, NeedsARecordThatSaysWhenItFinished) {
  EXPECT_THROW(night_of({{"poiseuille", {sample_record()}}}), std::runtime_error);
}

TEST_F(NightFile, ThatIsNoneIsLeftOutOfAHistoryAndNamed) {
  Night earlier = sample_night(), other = sample_night();
  earlier.finished_at = "2026-11-21T17:00:00Z";
  other.finished_at = "2026-11-20T17:00:00Z";
  other.suite = "acceptance";
  for (const Night& night : {sample_night(), earlier, other}) write_night(night, folder.path());
  std::ofstream(folder / "notes.jsonl") << "remember the milk\n";
  std::ofstream(folder / ".2026.part") << "of a writer that was killed";
  const History history = read_history(folder.path(), "nightly");
  ASSERT_EQ(history.nights.size(), 2u);
  EXPECT_EQ(history.nights[0].finished_at, earlier.finished_at);
  ASSERT_EQ(history.refused.size(), 1u);
  EXPECT_TRUE(contains(history.refused[0], "notes.jsonl:1: not a complete JSON line")) << history.refused[0];
}

}  // namespace
}  // namespace touchstone::reports
