#include "vnv/command/engines.hpp"

#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

/// Methods that a shell plays: `does` is what each does.
class AnEngineElsewhere : public testing::Test {
 protected:
  AnEngineElsewhere() { fs::create_directories(scratch_ / "logs"); }

  Job job(const std::string& name, const std::string& does) const {
    return {.name = name, .key = "suite-1", .call = {"sh", "-c", does}};
  }

  /// By GNU parallel on this machine; what ended how, in the order of the names.
  std::map<std::string, std::string> run(const std::vector<Job>& jobs, const std::string& hosts = "",
                                         const Words& options = {}) const {
    std::map<std::string, std::string> ended;
    make_engine({.engine = "parallel", .hosts = hosts, .options = options, .records = scratch_.path()})
        ->run(jobs, {.begins = [](const Job&) {},
                     .ended = [&](const Job& one, const JobResult& result) { ended[one.name] = result.sentence(); }});
    return ended;
  }

  void SetUp() override {
    if (!programs::run_and_capture({"sh", "-c", "command -v parallel"}).ending.succeeded())
      GTEST_SKIP() << "no GNU parallel";
  }

  const programs::ScratchFolder scratch_;
  const std::string here_ = " on " + programs::run_and_capture({"sh", "-c", "printf %s \"$(uname -n)\""}).output;
};

TEST_F(AnEngineElsewhere, SaysHowEachEndedAndWhere) {
  const auto ended = run({job("a.well", "exit 0"), job("b.fails", "exit 1"), job("c.dies", "kill -SEGV $$")});
  EXPECT_EQ(ended.at("a.well"), "ended with status 0" + here_);
  EXPECT_EQ(ended.at("b.fails"), "ended with status 1" + here_);
  EXPECT_EQ(ended.at("c.dies"), "was killed by signal 11 (Segmentation fault)" + here_);
}

TEST_F(AnEngineElsewhere, KeepsWhatAProgramSays) {
  run({job("a.b", "echo \"it's $((6 * 7))\"; echo 'an error' >&2")});
  EXPECT_EQ(programs::last_lines(scratch_ / "logs/a.b.txt", 2), "it's 42\nan error");
}

TEST_F(AnEngineElsewhere, LeavesWhichHaveBegun) {
  std::ofstream((fs::create_directories(scratch_ / "engine/began"), scratch_ / "engine/began/former"));
  run({job("a.b", "exit 0")});
  EXPECT_TRUE(fs::exists(scratch_ / "engine/began/a.b"));
  EXPECT_FALSE(fs::exists(scratch_ / "engine/began/former")) << "of a run before";
}

TEST_F(AnEngineElsewhere, RunsAJudgedOneOnceAndOneThatLostItsMachineTwice) {
  const std::string counts = "echo x >>'" + (scratch_ / "count").string() + "';";
  run({job("a.fails", counts + "exit 1")});
  EXPECT_EQ(fs::file_size(scratch_ / "count"), 2u);
  const auto ended =
      run({job("b.lost", counts + "kill -TERM $$")});  // as all is told to end on a machine that goes down
  EXPECT_EQ(fs::file_size(scratch_ / "count"), 6u);
  EXPECT_TRUE(ended.at("b.lost").starts_with("was ended: lost")) << ended.at("b.lost");
}

TEST_F(AnEngineElsewhere, TakesShortOnesOverOneLoginAndLosesOneWithoutTheOthers) {
  std::vector<Job> jobs;
  for (const char* name : {"a.well", "b.lost", "c.well"}) {
    const std::string counts = fmt::format("echo x >>'{}/{}.count';", scratch_.path().string(), name);
    jobs.push_back(job(name, counts + (name == std::string("b.lost") ? "kill -TERM $$" : "exit 0")));
    jobs.back().last = LastCost{.wall = 6};
  }
  const auto ended = run(jobs);
  std::ifstream log(scratch_ / "engine/together.log");
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(log), {}, '\n'), 2) << "a head and one login";
  for (const char* name : {"a.well", "c.well"}) {
    EXPECT_EQ(ended.at(name), "ended with status 0" + here_);
    EXPECT_EQ(fs::file_size(scratch_ / (name + std::string(".count"))), 2u) << name << " is not run again";
  }
  EXPECT_EQ(fs::file_size(scratch_ / "b.lost.count"), 4u) << "tried twice";
  EXPECT_TRUE(ended.at("b.lost").starts_with("was ended: lost")) << ended.at("b.lost");
}

TEST_F(AnEngineElsewhere, EndsWhatTakesTooLong) {
  Job slow = job("a.slow", "sleep 100");
  slow.last = LastCost{.wall = -11.8};  // so that a minute more is a second
  EXPECT_EQ(run({slow}).at("a.slow"), "was ended: took longer than 1 s" + here_);
}

TEST_F(AnEngineElsewhere, GivesNoMoreMemoryThanTheLimit) {
  Job large = job("a.large", "ulimit -d");
  large.last = LastCost{.peak_memory = 12e6};
  run({large});
  EXPECT_EQ(programs::last_lines(scratch_ / "logs/a.large.txt", 1), "1000000");
}

TEST_F(AnEngineElsewhere, LeavesHowAJobEndedForWhoComesLater) {
  run({job("a.b", "exit 1")});
  const std::optional<JobResult> result = ended_elsewhere(scratch_.path(), "a.b", "suite-1");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->ending.status, 1);
  EXPECT_FALSE(ended_elsewhere(scratch_.path(), "a.b", "suite-2")) << "of another program";
  forget_ended(scratch_.path(), "a.b");
  EXPECT_FALSE(ended_elsewhere(scratch_.path(), "a.b", "suite-1"));
}

TEST_F(AnEngineElsewhere, RunsWhatJudgesTimeAlone) {
  const std::string file = (scratch_ / "order").string();
  std::vector<Job> jobs;
  for (const char* name : {"a.first", "b.second"}) {
    jobs.push_back(job(name, "echo in >>'" + file + "'; sleep 0.3; echo out >>'" + file + "'"));
    jobs.back().alone = true;
  }
  run(jobs);
  EXPECT_EQ(programs::last_lines(file, 9), "in\nout\nin\nout");
}

TEST_F(AnEngineElsewhere, SaysWhatWasSaidOfAHostThatCannotBeReached) {
  const std::string ssh = (scratch_ / "ssh").string();
  std::ofstream(ssh) << "echo 'no route to host' >&2; exit 255\n";
  const auto ended = run({job("a.b", "exit 0")}, "nowhere", {"--ssh", "sh " + ssh});
  EXPECT_TRUE(ended.at("a.b").starts_with("was ended: lost, twice, with its host; 'no route to host'"))
      << ended.at("a.b");
}

TEST_F(AnEngineElsewhere, ThrowsWhatParallelSaidOfAnOption) {
  try {
    run({job("a.b", "exit 0")}, ":", {"--frob"});
    FAIL() << "an option that is none was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "parallel started nothing: Unknown option: frob");
  }
}

TEST(AnEngine, ThatHasNoHostsRefusesThem) {
  EXPECT_THROW(make_engine({.engine = "slurm", .hosts = "a,b"}), std::invalid_argument);
  EXPECT_TRUE(make_engine({.engine = "parallel", .hosts = "a,b"}));
}

TEST(Elements, AreFilledInOrderByWhatJobsTookLast) {
  const auto of = [](double wall) { return Job{.name = "a.b", .relative_cost = 1000, .last = LastCost{.wall = wall}}; };
  const auto elements = packed({of(500), of(60), of(50), of(20), of(1)}, 120);
  std::vector<std::size_t> sizes;
  for (const auto& one : elements) sizes.push_back(one.size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 2, 2}));
}

TEST(Elements, TakeRelativeCostsWhereNobodyKnows) {
  const Job unknown{.name = "a.b", .relative_cost = 40};
  EXPECT_EQ(packed(std::vector<Job>(4, unknown), 120).size(), 2u);
}

TEST(LimitsOfAJob, FollowWhatItTookLast) {
  const JobLimits limits = limits_of({.name = "a.b", .last = LastCost{.wall = 100, .peak_memory = 2e9}});
  EXPECT_EQ(limits.wall, 560);
  EXPECT_EQ(limits.memory, 5e9);
  EXPECT_EQ(limits_of({.name = "a.b"}).wall, 3600);
}

}  // namespace
}  // namespace touchstone::vnv::command
