#include "vnv/gate/gate.hpp"

#include "vnv/gate/error_against_time.hpp"
#include "vnv/gate/turns.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <sstream>

namespace touchstone::gate {
namespace gate_test {

namespace fs = std::filesystem;

vnv::Record plain() {
  vnv::Record record;
  record.case_name = "flow";
  record.method = "mpm";
  record.suite = "acceptance";
  record.runs = {{.level = "M1", .end_time = 1, .finished = true, .outcome = "finished", .cost = {.cpu = 1}}};
  record.values = {{"M1", 1e-5, 1, {"L2 v_x", "%", vnv::Kind::norm}, 0.4}};
  return record;
}

void write_text(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

std::string text_in(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Gate : public testing::Test {
 protected:
  Gate() { request_.suite = "acceptance"; }

  fs::path folder() const { return scratch_.path(); }

  std::string record_file(const std::string& name, const vnv::Record& record) const {
    fs::create_directories((folder() / name).parent_path());
    vnv::write(record, folder() / name);
    return folder() / name;
  }

  /// A build folder whose one program is a script that hands out records, one after another: a hundred, which differ
  /// in their CPU time as those of a solver do that takes `slower` times as long.
  std::string build(
      const std::string& name, double slower, unsigned seed,
      const std::function<void(vnv::Record&)>& change = [](vnv::Record&) {}) const {
    const fs::path build = folder() / name, source = folder() / ("source of " + name);
    write_text(build / "CMakeCache.txt", "# cache\nCMAKE_HOME_DIRECTORY:INTERNAL=" + source.string() + "\n");
    write_text(source / "vnv/cases/flow.cpp", "");
    write_text(build / "vnv/flow_tests.cmake",
               "add_test([=[flow.mpm]=] [=[flow]=] --method mpm --suite acceptance --records x)\n");
    write_text(build / "vnv/flow", "#!/bin/sh\n# " + name +
                                       "\nn=$(cat \"$0.count\" 2>/dev/null || echo 0)\necho $((n+1)) > \"$0.count\"\n"
                                       "test -e \"$0.$n.json\" || exit 9\ncp \"$0.$n.json\" \"$6/flow.mpm.json\"\n");
    fs::permissions(build / "vnv/flow", fs::perms::owner_all);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 100; ++k) {
      vnv::Record record = plain();
      record.runs[0].cost.cpu = slower * std::exp(0.017 * normal(random));
      change(record);
      vnv::write(record, build / "vnv" / ("flow." + std::to_string(k) + ".json"));
    }
    return build;
  }

  Status gate(const std::string& before, const std::string& after) {
    request_.before = before;
    request_.after = after;
    output_.str("");
    return touchstone::gate::gate(request_, output_, progress_);
  }

  /// What a refusal says; empty if there is none.
  std::string refusal(const std::string& before, const std::string& after) {
    try {
      gate(before, after);
    } catch (const BadInput& refusal) {
      return refusal.what();
    }
    return "";
  }

  std::string output() const { return output_.str(); }

  GateRequest request_;
  std::ostringstream progress_;

 private:
  programs::ScratchFolder scratch_;
  std::ostringstream output_;
};

const auto less_accurate = [](vnv::Record& record) { record.values[0].value *= 1.1; };

TEST_F(Gate, LetsPassARecordAgainstItself) {
  const std::string file = record_file("flow.mpm.json", plain());
  EXPECT_EQ(gate(file, file), same_or_better);
  EXPECT_EQ(gate(folder(), folder()), same_or_better);
  EXPECT_NE(output().find("same: "), std::string::npos);
}

TEST_F(Gate, StopsALargerErrorAndLetsPassASmallerOne) {
  vnv::Record changed = plain();
  less_accurate(changed);
  const std::string good = record_file("good.json", plain()), bad = record_file("bad.json", changed);
  EXPECT_EQ(gate(good, bad), worse);
  EXPECT_NE(output().find("flow.mpm M1: L2 v_x [%] at 1 s: 0.4 before, 0.44 after: worse"), std::string::npos)
      << output();
  EXPECT_EQ(gate(bad, good), same_or_better);
  EXPECT_NE(output().find("better: "), std::string::npos);
}

TEST_F(Gate, WritesMarkdownJsonAndTheFront) {
  vnv::Record changed = plain();
  changed.values[0].value = vnv::not_a_number;
  request_.markdown = folder() / "gate.md";
  request_.json = folder() / "gate.json";
  request_.figure = folder() / "figure.json";
  EXPECT_EQ(gate(record_file("good.json", plain()), record_file("bad.json", changed)), worse);
  const std::string markdown = text_in(request_.markdown);
  EXPECT_EQ(markdown.find("**worse**: "), 0u);
  EXPECT_NE(markdown.find("| flow | mpm | same, 1 | – | worse, 1 |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("\n- flow.mpm M1: L2 v_x [%] at 1 s: 0.4 before, nan after: worse"), std::string::npos);
  const auto json = nlohmann::json::parse(text_in(request_.json));
  EXPECT_EQ(json["conclusion"], "worse");
  EXPECT_EQ(json["differences"][1]["after"], "nan");
  const vnv::Record figure = vnv::read_record(request_.figure);
  ASSERT_EQ(figure.curves.size(), 1u);  // an error that is no number is not drawn
  EXPECT_EQ(figure.curves[0].label, "mpm, before");
  EXPECT_EQ(figure.curves[0].y, std::vector<double>{0.4});
  ASSERT_EQ(figure.verdicts.size(), 2u);
  EXPECT_EQ(figure.verdicts[0].outcome, vnv::Outcome::fails);
  EXPECT_EQ(figure.verdicts[0].sentence.find("worse: "), 0u);
  EXPECT_EQ(figure.verdicts[1].sentence.find("flow.mpm M1: L2 v_x [%] at 1 s"), 0u);
  EXPECT_EQ(figure.tables.at(0).rows.size(), 1u);
}

TEST_F(Gate, CountsWhatBecameWorseInconclusiveBetterStayedOrIsUnjudged) {
  vnv::Record before = plain();
  before.values.clear();
  vnv::Record after = before;
  for (const double factor : {1.1, 1.2, 1.3, 0.5, 0.6, 1.0, 1.0, 1.0, 1.0}) {  // 3 worse, 2 better, 4 the same
    const vnv::Quantity quantity{fmt::format("error {}", before.values.size()), "%", vnv::Kind::error};
    before.values.push_back({"M1", 1e-5, 1, quantity, 0.4});
    after.values.push_back({"M1", 1e-5, 1, quantity, 0.4 * factor});
  }
  for (int k = 0; k < 5; ++k)  // unjudged
    after.values.push_back({"M1", 1e-5, 1, {fmt::format("new {}", k), "%", vnv::Kind::error}, 1});
  vnv::Verdict holds;
  holds.case_name = "flow", holds.method = "mpm", holds.level = "M1", holds.quantity = "L2 v_x", holds.unit = "%";
  holds.author = "theory: so", holds.time = 1, holds.value = 0.4, holds.upper = 0.5,
  holds.outcome = vnv::Outcome::holds;
  before.verdicts = {holds};
  holds.upper = 0.7;  // a looser limit: inconclusive
  after.verdicts = {holds};
  const std::string was = record_file("before.json", before), is = record_file("after.json", after);
  EXPECT_EQ(gate(was, is), worse);
  const std::string summary = "16 things compared: 3 worse, 1 inconclusive, 2 better, 5 same, 5 unjudged\n";
  EXPECT_TRUE(output().ends_with(": " + summary)) << output();
  EXPECT_NE(output().find("worse, 3 of 14"), std::string::npos) << "in the row of the method, of its errors\n"
                                                                << output();
  EXPECT_EQ(gate(is, is), same_or_better);
  EXPECT_TRUE(output().ends_with(": 16 things compared: 0 worse, 0 inconclusive, 0 better, 16 same, 0 unjudged\n"))
      << output();
}

TEST_F(Gate, DrawsTheFirstErrorThatIsNoRounding) {
  vnv::Record record = plain();
  record.values.insert(record.values.begin(), record.values[0]);
  record.values[0].quantity.name = "L2 v_y";
  record.values[0].value = 2e-15;
  request_.figure = folder() / "figure.json";
  const std::string file = record_file("flow.mpm.json", record);
  EXPECT_EQ(gate(file, file), same_or_better);
  const vnv::Record figure = vnv::read_record(request_.figure);
  EXPECT_EQ(figure.figures.at(0).y.label, "L2 v_x [%]");
  EXPECT_EQ(figure.verdicts.at(0).outcome, vnv::Outcome::holds);
}

TEST(Front, HasTheTimesOfItsOwnCaseAndMethodAndTheLastErrorOfEachRun) {
  const auto record = [](const std::string& case_name, const std::string& method, double cpu) {
    vnv::Record made = plain();
    made.case_name = case_name;
    made.method = method;
    made.runs[0].cost.cpu = cpu;
    made.values.push_back(made.values[0]);
    made.values.back().time = 2;
    made.values.back().value = 0.1 * cpu;
    return made;
  };
  const Records once{record("flow", "mpm", 1), record("other", "mpm", 5), record("flow", "sph", 7)};
  Records again = once;
  for (vnv::Record& one : again) one.runs[0].cost.cpu *= 3;
  const vnv::Record front = error_against_time({once, again}, {});
  ASSERT_EQ(front.curves.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double cpu = once[k].runs[0].cost.cpu;
    EXPECT_EQ(front.curves[k].x, std::vector<double>{2 * cpu}) << "the median of both runs";
    EXPECT_EQ(front.curves[k].y, std::vector<double>{0.1 * cpu}) << "at the last time";
  }
}

TEST_F(Gate, RefusesWhatCannotBeCompared) {
  const std::string good = record_file("good.json", plain());
  vnv::Record nightly = plain();
  nightly.suite = "nightly";
  EXPECT_NE(refusal(good, record_file("other.json", nightly)).find("suite 'nightly', expected records of one suite"),
            std::string::npos);
  vnv::Record future = plain();
  future.schema = 999;
  EXPECT_NE(refusal(good, record_file("future.json", future)).find("schema is 999"), std::string::npos);
  record_file("mixed/a.json", plain());
  record_file("mixed/b.json", nightly);
  EXPECT_NE(refusal(good, folder() / "mixed").find("records of suites"), std::string::npos);
  fs::create_directories(folder() / "empty");
  EXPECT_NE(refusal(good, folder() / "empty").find("no records"), std::string::npos);
  EXPECT_NE(refusal(good, "no_such_revision").find("nor a git revision"), std::string::npos);
  EXPECT_NE(refusal(good, "--upload-pack=x").find("nor a git revision"), std::string::npos);
  EXPECT_NE(refusal(good, build("build", 1, 1)).find("expected two of a kind"), std::string::npos);
  request_.only = "[";
  EXPECT_NE(refusal(good, good).find("expected a regular expression"), std::string::npos);
  request_.only = "couette";
  EXPECT_NE(refusal(good, good).find("none of a chosen method"), std::string::npos);
}

TEST_F(Gate, RefusesTwoRecordsOfOneMethodInAFolder) {
  record_file("twice/a.json", plain());
  record_file("twice/b.json", plain());
  EXPECT_NE(refusal(folder() / "twice", folder() / "twice").find("flow.mpm: two records"), std::string::npos);
}

/// A method that takes so long, of a resource, and has so large an error.
RunOnce runs(double seconds, vnv::Resource resource, double error) {
  return [=, random = std::mt19937(7)](std::ostream&, const programs::Meanwhile&) mutable {
    vnv::Record record = plain();
    vnv::Cost& cost = record.runs[0].cost;
    cost.resource = resource;
    (resource == vnv::Resource::cpu ? cost.cpu : cost.occupied) =
        seconds * std::exp(std::normal_distribution(0., 0.003)(random));
    if (resource != vnv::Resource::cpu) cost.cpu = vnv::not_a_number;
    record.values[0].value = error;
    return std::optional(record);
  };
}

TEST_F(Gate, RunsInTurnWhatItsCallerKnowsHowToRunAndComparesWhatThatOccupies) {
  const auto gpu = vnv::Resource::gpu;
  const auto gated = [&](RunOnce before, RunOnce after) {
    std::ostringstream output;
    const Status status = touchstone::gate::gate(request_, {"flow", "mpm", false, std::move(before), std::move(after)},
                                                 output, progress_);
    return std::pair(status, output.str());
  };
  const auto [slower, said] = gated(runs(10, gpu, 0.4), runs(12, gpu, 0.4));
  EXPECT_EQ(slower, worse);
  EXPECT_NE(said.find("flow.mpm: GPU time [s]: "), said.npos) << said;
  EXPECT_NE(said.find("1.2"), said.npos) << said;
  EXPECT_EQ(gated(runs(10, gpu, 0.4), runs(10, gpu, 0.4)).first, same_or_better);
  EXPECT_EQ(gated(runs(10, gpu, 0.4), runs(10, gpu, 0.6)).first, worse) << "a larger error at the same cost";
}

TEST_F(Gate, ComparesNoTimesOfTwoResources) {
  std::ostringstream output;
  request_.figure = folder() / "figure.json";
  const Contest contest{"flow", "mpm", false, runs(10, vnv::Resource::cpu, 0.4), runs(1, vnv::Resource::gpu, 0.4)};
  EXPECT_EQ(touchstone::gate::gate(request_, contest, output, progress_), same_or_better);
  EXPECT_NE(output.str().find("unjudged: CPU time [s] before and GPU time [s] after, which are not compared"),
            std::string::npos)
      << output.str();
  const vnv::Record figure = vnv::read_record(request_.figure);
  ASSERT_EQ(figure.figures.size(), 2u);
  EXPECT_EQ(figure.figures[0].x.label, "CPU time [s]");
  EXPECT_EQ(figure.figures[1].x.label, "GPU time [s]");
  EXPECT_EQ(figure.curves[1].figure, figure.figures[1].id);
}

TEST_F(Gate, SkipsProgramsThatAreTheSame) {
  const std::string same = build("same", 1, 1);
  EXPECT_EQ(gate(same, same), same_or_better);
  EXPECT_NE(output().find("programs of 1 cases the same"), std::string::npos) << output();
  EXPECT_FALSE(fs::exists(same + "/vnv/flow.count"));
}

TEST_F(Gate, TakesProgramsForTheSameThatDifferInTheirRevisionOnly) {
  const auto compiled = [&](const std::string& name, const std::string& revision, const std::string& solver) {
    const std::string folder = build(name, 1, 1), files = folder + "/vnv/CMakeFiles/";
    write_text(folder + "/vnv/flow", revision + solver);
    write_text(files + "flow.dir/cases/flow.cpp.o", "compiled in " + folder + solver);
    write_text(files + "vnv.dir/environment.cpp.o", revision);
    write_text(files + "vnv.dir/run.cpp.o", "compiled in " + folder);
    write_text(files + "wave.dir/cases/wave.cpp.o", revision);
    Build found{folder, ""};
    found.programs = {{.case_name = "flow", .file = folder + "/vnv/flow", .methods = {"mpm"}}};
    return found;
  };
  const Build a = compiled("build1", "1234567", ""), b = compiled("build2", "abcdef0-dirty", "");
  const Build c = compiled("build3", "1234567", ", otherwise"), d = compiled("build4", "abcdef0", "");
  const auto same = [&](const Build& other) { return are_same_programs(a, other, a.programs[0], other.programs[0]); };
  EXPECT_TRUE(same(b));
  EXPECT_FALSE(same(c));
  write_text(folder() / "build4/vnv/CMakeFiles/vnv.dir/run.cpp.o", "otherwise");
  EXPECT_FALSE(same(d));
  write_text(folder() / "build1/vnv/CMakeFiles/vnv_judge.dir/judge/claims.cpp.o", "judges");
  EXPECT_TRUE(same(b)) << "a library that one build lacks is not linked with the case";
  write_text(folder() / "build2/vnv/CMakeFiles/vnv_judge.dir/judge/claims.cpp.o", "judges otherwise");
  EXPECT_FALSE(same(b));
  fs::remove_all(folder() / "build2/vnv/CMakeFiles");
  EXPECT_FALSE(same(b));  // nothing tells whether they are the same
}

TEST_F(Gate, ReadsDataBesideAProgram) {
  const auto with_data = [&](const std::string& name, const std::string& file) {
    const std::string source = folder() / name;
    write_text(source + "/data/" + file, "a value");
    write_text(source + "/flow", "the program");
    Build found{folder(), source};
    found.programs = {{.case_name = "flow", .file = source + "/flow", .methods = {"mpm"}}};
    return found;
  };
  const Build none = with_data("a", "baselines/other.csv"), own = with_data("b", "baselines/flow.csv");
  const Build others = with_data("c", "baselines/third.csv"), paper = with_data("d", "papers/table.csv");
  const auto same = [&](const Build& b) { return are_same_programs(none, b, none.programs[0], b.programs[0]); };
  EXPECT_TRUE(same(others));
  EXPECT_FALSE(same(own));
  EXPECT_FALSE(same(paper));
}

TEST_F(Gate, OfABuildAgainstItselfIsTheSame) {
  EXPECT_EQ(gate(build("before", 1, 1), build("after", 1, 2)), same_or_better) << output();
}

TEST_F(Gate, NamesASolverThatIsATwentiethSlower) {
  EXPECT_EQ(gate(build("before", 1, 3), build("after", 1.05, 4)), worse);
  EXPECT_NE(output().find("after: worse: 1.0"), std::string::npos) << output();
  EXPECT_NE(output().find("30 pairs of runs"), std::string::npos) << output();
  fs::remove_all(folder() / "before");
  fs::remove_all(folder() / "after");
  EXPECT_EQ(gate(build("before", 1.05, 5), build("after", 1, 6)), same_or_better);
  EXPECT_NE(output().find("better: "), std::string::npos);
}

TEST_F(Gate, WithoutRepeatsComparesValuesOnly) {
  request_.repeats = 0;
  EXPECT_EQ(gate(build("before", 1, 1), build("after", 2, 2)), same_or_better) << output();
  EXPECT_EQ(text_in(folder() / "before/vnv/flow.count"), "1\n");
  fs::remove_all(folder() / "after");
  EXPECT_EQ(gate(folder() / "before", build("after", 1, 2, less_accurate)), worse);
}

TEST_F(Gate, FindsAProgramWorseThatWritesNoRecordAnyMore) {
  const std::string before = build("before", 1, 1), after = build("after", 1, 2);
  write_text(after + "/vnv/flow.count", "1000");
  EXPECT_EQ(gate(before, after), worse);
  EXPECT_NE(output().find("flow.mpm: method: worse: no longer there"), std::string::npos) << output();
  EXPECT_NE(progress_.str().find("ended with status 9 and no record"), std::string::npos);
}

TEST_F(Gate, FindsACaseWorseThatIsGone) {
  const std::string before = build("before", 1, 1), after = build("after", 1, 2);
  write_text(folder() / "source of before/vnv/cases/wave.cpp", "");
  fs::copy(before + "/vnv/flow", before + "/vnv/wave");
  write_text(before + "/vnv/wave_tests.cmake",
             "add_test([=[wave.sph]=] --method sph --suite acceptance --records x)\n");
  EXPECT_EQ(gate(before, after), worse);
  EXPECT_NE(output().find("wave.sph: method: worse: no longer there"), std::string::npos) << output();
}

TEST_F(Gate, NeverJudgesWhatACaseFindsThatJudgesTime) {
  const auto timed = [&](const std::string& name, double value) {
    const std::string folder = build(name, value, 1, [&](vnv::Record& r) { r.values[0].value = value; });
    std::ofstream(folder + "/vnv/flow_tests.cmake", std::ios::app) << "set_tests_properties(x RUN_SERIAL TRUE)\n";
    return folder;
  };
  EXPECT_EQ(gate(timed("before", 1), timed("after", 2)), same_or_better) << output();
  EXPECT_EQ(text_in(folder() / "before/vnv/flow.count"), "1\n");
}

TEST_F(Gate, ABuildWithoutItsProgramsIsRefused) {
  const std::string built = build("build", 1, 1);
  fs::remove(built + "/vnv/flow");
  EXPECT_NE(refusal(built, built).find("no program of a chosen case"), std::string::npos);
}

/// A repository with one commit, whose "project" is what `cmake_lists` says.
class GateOfRevisions : public Gate {
 protected:
  void commit(const std::string& cmake_lists) const {
    const fs::path repository = folder() / "repository";
    write_text(repository / "CMakeLists.txt", cmake_lists);
    write_text(repository / "vnv/cases/flow.cpp", "");
    write_text(repository / "vnv/cases/of_reports/slow.cpp", "");  // no target: acceptance runs nothing of it, so it is not built
    const std::string git = "cd '" + repository.string() + "' && git -c user.name=a -c user.email=a@b ";
    const std::string silent = " >/dev/null 2>&1";
    ASSERT_EQ(std::system(("cd '" + repository.string() + "' && git init" + silent).c_str()), 0);
    ASSERT_EQ(std::system((git + "add ." + silent).c_str()), 0);
    ASSERT_EQ(std::system((git + "commit -m first" + silent).c_str()), 0);
    fs::current_path(repository);
  }
  void SetUp() override {
    fs::create_directories(temporary());
    setenv("TMPDIR", temporary().c_str(), 1);
  }
  void TearDown() override {
    fs::current_path(before_);
    unsetenv("TMPDIR");
  }

  /// Where folders for a while are made.
  fs::path temporary() const { return folder() / "temporary"; }

 private:
  fs::path before_ = fs::current_path();
};

/// A project that is built by copying what was prepared in a folder.
std::string copied_from(const fs::path& prepared) {
  return "cmake_minimum_required(VERSION 3.25)\nproject(flow NONE)\nadd_custom_target(flow COMMAND ${CMAKE_COMMAND} -E "
         "copy_directory \"" +
         prepared.string() + "/vnv\" ${CMAKE_BINARY_DIR}/vnv)\n";
}

TEST_F(GateOfRevisions, AreBuiltAndForgotten) {
  commit(copied_from(build("prepared", 1, 1)));
  request_.repeats = 0;
  request_.all = true;
  EXPECT_EQ(gate("HEAD", "HEAD"), same_or_better) << output();
  EXPECT_NE(progress_.str().find("gate: builds "), std::string::npos);
  EXPECT_TRUE(fs::is_empty(temporary()));
  EXPECT_FALSE(fs::exists(".git/worktrees/source"));
}

TEST_F(GateOfRevisions, KeepTheirProgramsThoughTheyAreBuiltInOneFolder) {
  commit(copied_from(build("prepared", 1, 1)));
  write_text(folder() / "repository/data/papers/table.csv", "a value");
  commit(copied_from(build("prepared otherwise", 1, 2, less_accurate)));
  request_.repeats = 0;
  EXPECT_EQ(gate("HEAD~1", "HEAD"), worse) << output();
  EXPECT_NE(output().find("0.4 before, 0.44 after: worse"), std::string::npos) << output();
  EXPECT_EQ(gate("HEAD", "HEAD~1"), same_or_better) << output();
}

TEST_F(GateOfRevisions, ThatCannotBeBuiltAreRefusedAndForgotten) {
  commit("cmake_minimum_required(VERSION 3.25)\nproject(flow NONE)\nmessage(FATAL_ERROR \"no compiler knows this\")\n");
  EXPECT_NE(refusal("HEAD", "HEAD").find("no compiler knows this"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(temporary()));
  EXPECT_FALSE(fs::exists(".git/worktrees/source"));
}

}  // namespace gate_test
}  // namespace touchstone::gate
