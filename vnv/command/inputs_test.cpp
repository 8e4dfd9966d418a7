#include "vnv/command/inputs.hpp"

#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

class FinishedWork : public testing::Test {
 protected:
  FinishedWork() {
    for (const char* folder : {"data/baselines", "data/claims", "data/papers", "records"})
      fs::create_directories(root_ / folder);
    put("program", "machine code");
    put("data/papers/table.csv", "1");
    put("data/baselines/small.csv", "2");
    put("data/baselines/other.csv", "3");
    described_.name = "small";
    described_.data_folder = root_ / "data";
    described_.baseline_file = root_ / "data/baselines/small.csv";
  }

  void put(const std::string& name, const std::string& text) const { std::ofstream(root_ / name) << text; }
  std::string hash() const { return hash_of_inputs(root_ / "program", described_); }
  fs::path records() const { return root_ / "records"; }
  Inputs inputs() const { return {hash(), "acceptance"}; }

  const programs::ScratchFolder scratch_;
  const fs::path root_ = scratch_.path();
  Description described_;
};

TEST_F(FinishedWork, IsKnownAgain) {
  put("records/small.mpm.json", "{}");
  EXPECT_FALSE(is_done(records(), "small.mpm", inputs()));
  set_done(records(), "small.mpm", inputs());
  EXPECT_TRUE(is_done(records(), "small.mpm", inputs()));
  EXPECT_FALSE(is_done(records(), "small.sph", inputs()));
}

TEST_F(FinishedWork, OfAnotherSuiteIsOther) {
  put("records/small.mpm.json", "{}");
  set_done(records(), "small.mpm", inputs());
  EXPECT_FALSE(is_done(records(), "small.mpm", {hash(), "nightly"}));
}

TEST_F(FinishedWork, WithoutItsRecordIsNone) {
  set_done(records(), "small.mpm", inputs());
  EXPECT_FALSE(is_done(records(), "small.mpm", inputs()));
}

TEST_F(FinishedWork, ThatIsForgottenIsGone) {
  put("records/small.mpm.json", "{}");
  put("records/.small.mpm.json.2147483647.part", "{");
  put("records/.small.mpm_float.json.2147483647.part", "{");
  set_done(records(), "small.mpm", inputs());
  forget(records(), "small.mpm");
  EXPECT_FALSE(fs::exists(records() / ".small.mpm.json.2147483647.part"));
  EXPECT_TRUE(fs::exists(records() / ".small.mpm_float.json.2147483647.part")) << "of another method";
  EXPECT_FALSE(fs::exists(record_file(records(), "small.mpm")));
  EXPECT_FALSE(is_done(records(), "small.mpm", inputs()));
}

TEST_F(FinishedWork, IsDoneAnewAfterAnyInputChanged) {
  const std::string before = hash();
  EXPECT_EQ(hash(), before);
  put("data/papers/table.csv", "1.1");
  const std::string other_table = hash();
  EXPECT_NE(other_table, before);
  put("data/baselines/small.csv", "2.1");
  const std::string other_baselines = hash();
  EXPECT_NE(other_baselines, other_table);
  put("data/claims/small.csv", "2.1");
  EXPECT_NE(hash(), other_baselines);
  put("program", "other machine code");
  EXPECT_NE(hash(), other_baselines);
}

TEST_F(FinishedWork, IsDoneAnewAfterAnyByteOfAnyFolderOfDataChanged) {
  std::string large(200000, 'x');  // more than is read at once
  for (const char* name : {"program", "data/experiments/front.csv", "data/known_failures.csv"}) {
    fs::create_directories((root_ / name).parent_path());
    put(name, large);
    const std::string before = hash();
    for (const std::size_t place : {std::size_t{0}, std::size_t{1} << 16, large.size() - 1}) {
      std::string other = large;
      other[place] = 'y';
      put(name, other);
      EXPECT_NE(hash(), before) << name << ", byte " << place;
    }
    put(name, large + 'x');
    EXPECT_NE(hash(), before) << name << ", a byte more";
  }
}

TEST_F(FinishedWork, StandsWhenBaselinesOfOthersChange) {
  const std::string before = hash();
  put("data/baselines/other.csv", "3.1");
  put("data/claims/other.csv", "3.1");
  EXPECT_EQ(hash(), before);
}

TEST_F(FinishedWork, OfAProgramThatIsGoneIsRefused) {
  fs::remove(root_ / "program");
  EXPECT_THROW(hash(), std::runtime_error);
}

TEST(AHash, IsThatOfFowlerNollAndVo) {
  Hash hash;
  hash.add("foobar");
  EXPECT_EQ(hash.digits(), "85944171f73967e8");
}

}  // namespace
}  // namespace touchstone::vnv::command
