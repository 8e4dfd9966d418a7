#include "vnv/doors/solver.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

namespace touchstone::vnv::doors {
namespace {

/// A code that answers with the state that it starts from, as if no time had passed.
constexpr std::string_view frozen = R"(name = "frozen"
flow = "shear_wave"
across = [10, 20, 40]
times = [0.1]
command = ["cp", "{particles}", "end.csv"]
output = "end.csv"
baselines = "accepted"
[read]
time = 0.1
)";

class OtherSolvers : public testing::Test {
 protected:
  Solver solver(std::string text, const std::string& part = "", const std::string& becomes = "") const {
    if (!part.empty()) text.replace(text.find(part), part.size(), becomes);
    files::write_whole(folder / "mine.toml", text);
    return read_solver(folder / "mine.toml");
  }
  std::string refusal(const std::string& part, const std::string& becomes) const {
    try {
      prepare(solver(std::string(frozen), part, becomes), folder / "runs");
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      return text.substr(std::min(text.size(), text.find("mine.toml")));
    }
    return "read without complaint";
  }
  Record run(const Solver& one) const { return run_solver(one, folder / "runs", Suite::acceptance).record; }

  /// Why a command has no answer, by each resolution's own verdict.
  std::string no_answer(const std::string& command, double limit = 60) const {
    const Record record = run(
        solver(fmt::format("{}[limits]\ntime = {}\n", frozen, limit), R"(["cp", "{particles}", "end.csv"])", command));
    EXPECT_EQ(record.verdicts.size(), 3u) << "nothing else is said where nothing was answered";
    for (const Verdict& v : record.verdicts) EXPECT_EQ(v.outcome, Outcome::fails);
    return record.verdicts.front().sentence;
  }

  const programs::ScratchFolder folder;
};

TEST_F(OtherSolvers, AreRunMeasuredAndJudgedAtEachResolution) {
  const Solver frozen_solver = solver(std::string(frozen));
  const Record record = run(frozen_solver);
  ASSERT_EQ(record.runs.size(), 3u);
  EXPECT_EQ(record.case_name + "." + record.method, "shear_wave.frozen");
  const double nu = frozen_solver.flow.fluid.kinematic_viscosity(), k = 2 * std::numbers::pi;
  for (const Value& value : record.values) {
    if (value.quantity.kind != Kind::norm) continue;
    EXPECT_NEAR(value.value, 100 * std::expm1(k * k * nu * 0.1), 1e-6) << value.quantity.heading();
    EXPECT_EQ(value.time, 0.1);
  }
  for (const RunSummary& one : record.runs) {
    EXPECT_TRUE(one.finished);
    EXPECT_GT(one.cost.wall, 0);
    EXPECT_GE(one.cost.cpu, 0);
  }
  const auto of_order =
      std::ranges::find_if(record.verdicts, [](const Verdict& v) { return v.quantity.starts_with("order of"); });
  ASSERT_NE(of_order, record.verdicts.end());
  EXPECT_EQ(of_order->outcome, Outcome::fails) << "an error that does not fall is not consistent";
  EXPECT_NE(of_order->sentence.find("s late"), std::string::npos) << of_order->sentence;
}

TEST_F(OtherSolvers, CostWallTimesTimesWhatTheySayTheyOccupyAndNoCpuTime) {
  const Record record = run(solver(std::string(frozen) + "[resources]\ngpus = 2\n"));
  for (const RunSummary& one : record.runs) {
    EXPECT_EQ(one.cost.resource, Resource::gpu);
    EXPECT_GT(one.cost.wall, 0);
    EXPECT_EQ(one.cost.occupied, 2 * one.cost.wall);
    for (const double cpu : {one.cost.cpu, one.cost.cpu_lowest, one.cost.cpu_highest}) EXPECT_TRUE(std::isnan(cpu));
  }
  EXPECT_EQ(record_in(as_json(record), "as written").runs.front().cost.occupied, record.runs.front().cost.occupied);
  EXPECT_EQ(run(solver(std::string(frozen) + "[resources]\ncores = 3\n")).runs.front().cost.resource, Resource::core);
}

TEST_F(OtherSolvers, SayWhyTheyHaveNoAnswer) {
  const auto says = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find("10 across: gave no result: " + part), text.npos) << text;
  };
  says(no_answer(R"(["sh", "-c", "echo reads; echo 'no mesh' >&2; exit 3"])"),
       "ended with status 3; it said: reads;no mesh");
  says(no_answer(R"(["sleep", "60"])", 0.4), "was ended: took longer than 0.4 s");
  says(no_answer(R"("true")"), "wrote no file end.csv");
  says(no_answer(R"("kill -SEGV $$")"), "was killed by signal 11");
  says(no_answer(R"("head -c 100 {particles} > end.csv")"), fmt::format("{}", (folder / "runs").string()));
  const Record late = run(solver(std::string(frozen), "time = 0.1", "time = 0.2"));
  says(late.verdicts.front().sentence, "no output at 0.1 s, expected it within 1 %; output is at 0.2 s");
  std::string over_time(frozen);
  over_time.replace(over_time.find("shear_wave"), 10, "hydrostatic");
  says(run(solver(over_time, R"(["cp", "{particles}", "end.csv"])", R"("true")")).verdicts.front().sentence,
       "wrote no file end.csv");
}

TEST_F(OtherSolvers, FillReplacementFieldsAlsoForAShellAndFromAPathWithBlanks) {
  const Solver one = solver(std::string(frozen), R"(["cp", "{particles}", "end.csv"])",
                            R"("echo {L} {across} ${{HOME} {until} > {folder}/said; cp {particles} end.csv")");
  const std::filesystem::path runs = folder / "it's here";
  EXPECT_EQ(run_solver(one, runs, Suite::acceptance).record.runs.size(), 3u);
  EXPECT_EQ(files::read_whole(runs / "20_across" / "said"), fmt::format("1 20 {} 0.1\n", std::getenv("HOME")));
}

TEST_F(OtherSolvers, HaveAsOutputNothingThatWasGivenToThemOrSaidUnlessItIsNamed) {
  const auto outcome = [&](const std::string& command, const std::string& output) {
    std::string text(frozen);
    text.replace(text.find("output = \"end.csv\""), 18, "output = \"" + output + "\"");
    return run(solver(text, R"(["cp", "{particles}", "end.csv"])", command)).runs.front().outcome;
  };
  EXPECT_EQ(outcome(R"("echo done; cp {particles} end.txt")", "*.txt"), "finished") << "output.txt is what it said";
  EXPECT_EQ(outcome(R"("cp {particles} end.csv")", "*.csv"), "finished");
  EXPECT_EQ(outcome(R"("true")", "*.csv"), "gave no result: wrote no file *.csv");
  EXPECT_EQ(outcome(R"("cat {particles}")", "output.txt"), "finished");
}

TEST_F(OtherSolvers, ArePreparedForOthersToRunAndCollected) {
  const Solver one = solver(std::string(frozen));
  prepare(one, folder / "runs");
  for (const char* level : {"10_across", "20_across"})
    std::filesystem::copy(folder / "runs" / level / "particles.csv", folder / "runs" / level / "end.csv");
  const Record record = collect(one, folder / "runs", Suite::acceptance).record;
  EXPECT_TRUE(record.runs[0].finished && record.runs[1].finished);
  EXPECT_EQ(record.runs[2].outcome, "gave no result: wrote no file end.csv");
}

TEST_F(OtherSolvers, ThatOthersRanCostTheWallTimeOfTheirScriptTimesWhatTheyOccupy) {
  const Solver one = solver(std::string(frozen) + "[resources]\ngpus = 4\n", R"(["cp", "{particles}", "end.csv"])",
                            R"("cp {particles} end.csv; sleep 0.05; exit 0")");
  prepare(one, folder / "runs");
  for (const char* level : {"10_across", "20_across"})
    EXPECT_EQ(std::system(fmt::format("sh {}", (folder / "runs" / level / "run.sh").string()).c_str()), 0);
  std::filesystem::remove(folder / "runs/20_across/.began_and_ended");
  const Record record = collect(one, folder / "runs", Suite::acceptance).record;
  EXPECT_GE(record.runs[0].cost.wall, 0.05);
  EXPECT_LT(record.runs[0].cost.wall, 60);
  EXPECT_EQ(record.runs[0].cost.occupied, 4 * record.runs[0].cost.wall);
  EXPECT_TRUE(std::isnan(record.runs[0].cost.cpu));
  EXPECT_TRUE(std::isnan(record.runs[1].cost.occupied)) << "it was killed, or an older script";
}

TEST_F(OtherSolvers, KeepBaselinesInAFolderOfTheirOwn) {
  const Solver one = solver(std::string(frozen));
  Record record = run(one);
  EXPECT_THROW(accept(one, record, "none"), std::invalid_argument) << "its order does not hold";
  std::erase_if(record.verdicts, [](const Verdict& v) { return v.outcome != Outcome::holds; });
  accept(one, record, "first values");
  const auto failing = [](const Record& judged) {
    return std::ranges::count_if(judged.verdicts, [](const Verdict& v) {
      return v.author.starts_with("baseline") && v.outcome != Outcome::holds;
    });
  };
  EXPECT_EQ(failing(run(one)), 0);
  EXPECT_GT(failing(run(solver(std::string(frozen), "times = [0.1]", "times = [0.1005]"))), 0)
      << "other times, other values";
}

TEST_F(OtherSolvers, DoNotPassByEndingAndMayHaveTheirValuesAccepted) {
  const Solver one = solver(std::string(frozen), "across = [10, 20, 40]", "across = [10]");
  const Record record = run(one);
  for (const Verdict& v : record.verdicts)
    EXPECT_EQ(v.outcome, v.quantity == anything_claimed ? Outcome::fails : Outcome::holds) << v.sentence;
  EXPECT_EQ(record.verdicts.back().quantity, anything_claimed);
  accept(one, record, "first values");
  for (const Verdict& v : run(one).verdicts) EXPECT_EQ(v.outcome, Outcome::holds) << v.sentence;
}

TEST_F(OtherSolvers, MayBeHeldToALimitOfTheirOwnWhereTheFlowHasOneForFineResolutionsOnly) {
  std::string in_cavity(frozen);
  in_cavity.replace(in_cavity.find("shear_wave"), 10, "cavity");
  in_cavity.replace(in_cavity.find("times = [0.1]"), 13, "times = [12]");
  in_cavity.replace(in_cavity.find("time = 0.1"), 10, "time = 12");
  const Record record = run(solver(in_cavity + "[claims]\nat_most = 2\n"));
  long limited = 0;
  for (const Verdict& v : record.verdicts) {
    if (v.author != "baseline: limit of the user") continue;
    ++limited;
    EXPECT_EQ(v.level, "40 across");
    EXPECT_EQ(v.outcome, Outcome::fails) << "water at rest is 100 % off";
  }
  EXPECT_EQ(limited, 4) << "L2 and Linf on two lines";
}

TEST_F(OtherSolvers, AreAskedForMoreTimesWhereHistoriesAreJudged) {
  const Solver one = solver(std::string(frozen), "times = [0.1]", "times = [0.1, 0.25]\nevery = 0.1");
  EXPECT_EQ(one.times, std::vector<double>({0, 0.1, 0.2, 0.25}));
  const Solver longer = solver(std::string(frozen), "times = [0.1]", "times = [0.5]\nevery = 0.1");
  EXPECT_EQ(fmt::format("{}", longer.times[3]), "0.3") << "not what 3 times 0.1 is in binary";
}

TEST_F(OtherSolvers, ReadInTheirSceneTheTimesThatTheyAreAskedFor) {
  prepare(solver(std::string(frozen), "times = [0.1]", "times = [0.25, 0.75]"), folder / "runs");
  std::string scene = files::read_whole(folder / "runs" / "10_across" / "scene.json");
  std::erase_if(scene, [](char letter) { return std::isspace(static_cast<unsigned char>(letter)); });
  EXPECT_NE(scene.find("\"times[s]\":[0.25,0.75]"), scene.npos) << scene;
}

TEST_F(OtherSolvers, SayWhatTheyNeedAndIsNotHere) {
  const std::string needs =
      "needs = { sh = \"any shell\", no_such_program = \"package none\", \"/no/such/file\" = \"by hand\" }\n";
  EXPECT_EQ(missing_here(solver(std::string(frozen), "output", needs + "output")),
            "/no/such/file (by hand), no_such_program (package none)");
  EXPECT_EQ(missing_here(solver(std::string(frozen))), "");
}

TEST_F(OtherSolvers, AreRefusedWithFileLineAndKey) {
  EXPECT_EQ(refusal("across = [10, 20, 40]", "across = 10"), "mine.toml:3: across = 10, expected an array of numbers");
  EXPECT_EQ(refusal("times = [0.1]", "times = [\"soon\"]"),
            "mine.toml:4: times = 'soon', expected an array of numbers");
  EXPECT_EQ(refusal("times = [0.1]", "times = [0.1]\nevery = 1e-9"),
            "mine.toml:5: every = 1e-09, expected 1e-06 s or more: 100000 times until 0.1 s at most");
  EXPECT_EQ(refusal("across", "levels"), "mine.toml: no key 'across', expected one such as across = [10, 20, 40]");
  EXPECT_EQ(refusal("command", "cmd"),
            "mine.toml: no key 'command', expected one such as command = [\"./solver\", \"{scene}\"]");
  EXPECT_EQ(refusal("time = 0.1", "tine = 0.1").substr(0, 47), "mine.toml:9: unknown key 'tine' of read, expect");
  for (const auto& [key, said] : {std::pair("fields = { velocty = \"U\" }", "field 'velocty' = 'U'"),
                                  std::pair("units = { lenght = \"mm\" }", "unit of 'lenght' = 'mm'")})
    EXPECT_EQ(refusal("time = 0.1", key).find(fmt::format("mine.toml: read: {}, expected one of: density, ", said)), 0)
        << refusal("time = 0.1", key);
  EXPECT_EQ(refusal("times =", "set = { nu = 0 }\ntimes =").substr(0, 11), "mine.toml: ");
  EXPECT_EQ(refusal("shear_wave", "shear\\nwave").substr(0, 32), "mine.toml: no flow 'shear?wave',");
  EXPECT_EQ(refusal("output", "flow = \"x\"\noutput").substr(0, 12), "mine.toml:6:");
  EXPECT_EQ(
      refusal("{particles}", "{particle}"),
      "mine.toml: command: '{particle}' is no replacement field, expected one of: L, Re, U, across, c, folder, here, "
      "parameters, particles, rho, scene, spacing, times, until; a brace is {{");
  EXPECT_EQ(refusal("flow =", "schema = \"touchstone solver 2\"\nnew_key = 1\nflow ="),
            "mine.toml:2: schema = 'touchstone solver 2', expected 'touchstone solver 1', the only version known here");
  EXPECT_EQ(refusal("flow =", "schema = \"touchstone solver 1\"\nflow ="), "read without complaint");
  for (const auto& [resources, said] :
       {std::pair("gpus = 0", "mine.toml:9: resources.gpus = 0, expected a number above 0"),
        std::pair("gpus = 1\ncores = 4",
                  "mine.toml: resources.cores beside resources.gpus, expected one of them: a cost has one unit")})
    EXPECT_EQ(refusal("[read]", fmt::format("[resources]\n{}\n[read]", resources)), said);
  EXPECT_EQ(refusal("\"frozen\"", "\"../frozen\""),
            "mine.toml: name = '../frozen', expected one without points, slashes and blanks");
}

}  // namespace
}  // namespace touchstone::vnv::doors
